// Samples to pixels, and the adjoint of that. Twin of src/core/view/camera.rs.

const NEAREST_DEPTH: f32 = 1e-3;

fn affine(row: vec4f, sample: vec4f) -> f32 {
    return dot(row.xyz, sample.xyz) + row.w;
}

fn depth_of(view: u32, sample: vec4f) -> f32 {
    return max(affine(scene.view[view].forward, sample), NEAREST_DEPTH);
}

/// Pixels per world unit at the sample's depth.
fn pixels_per_world(view: u32, sample: vec4f) -> f32 {
    let scale = scene.view[view].scale;
    return select(scale, scale / depth_of(view, sample), scene.view[view].perspective == 1u);
}

/// Whether a number is finite and within reach of any picture. On bits, as shaders may take it that no number is NaN.
fn within_reach(x: f32) -> bool {
    return (bitcast<u32>(x) & 0x7fffffffu) <= bitcast<u32>(FARTHEST_PX);
}

/// Where a sample is seen, and its visibility.
fn seen(view: u32, sample: vec4f) -> vec3f {
    let axes = vec2f(affine(scene.view[view].right, sample), affine(scene.view[view].down, sample));
    let center = scene.view[view].centre_px + pixels_per_world(view, sample) * axes;
    if !within_reach(center.x) || !within_reach(center.y) {
        return vec3f(center, 1.0);
    }
    return vec3f(center, visibility(view, center, affine(scene.view[view].forward, sample)));
}

fn is_hidden(view: u32, k: u32) -> bool {
    return k == NONE || seen(view, samples[k]).z < LEAST_VISIBILITY;
}

/// One thread a sample and view. What is hidden on both sides is not drawn.
@compute @workgroup_size(64)
fn project(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.samples {
        return;
    }
    let sample = samples[id.x];
    let view = id.y;
    let at = seen(view, sample);
    let radius = at.z * pixels_per_world(view, sample) * 0.5 * sample.w;
    let link = links[id.x];
    var usable = within_reach(at.x) && within_reach(at.y) && within_reach(radius) && link.x != id.x;
    if at.z < LEAST_VISIBILITY && is_hidden(view, link.x) && is_hidden(view, link.y) {
        usable = false;
    }
    vertices[view * scene.samples + id.x] = vec4f(at.xy, max(radius, 0.0), select(0.0, 1.0, usable));
}

/// One thread a sample, views in order. With p = k q, k = f / z: dq = k dp, dz = -(k / z) sum q dp. The width is thinned
/// to V w, where dV/dz = -s V (1 - V).
@compute @workgroup_size(64)
fn project_vjp(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.samples {
        return;
    }
    let sample = samples[id.x];
    var sum = vec4f();
    for (var view = 0u; view < scene.views; view++) {
        let d = d_vertices[view * scene.samples + id.x];
        let k = pixels_per_world(view, sample);
        let right = scene.view[view].right;
        let down = scene.view[view].down;
        let seen_share = seen(view, sample).z;
        let d_thinned = k * 0.5 * d.z;
        var d_depth = -scene.view[view].steepness * seen_share * (1.0 - seen_share) * sample.w * d_thinned;
        if scene.view[view].perspective == 1u {
            let along = affine(right, sample) * d.x + affine(down, sample) * d.y + 0.5 * seen_share * sample.w * d.z;
            d_depth -= (k / depth_of(view, sample)) * along;
        }
        sum += vec4f(k * (right.xyz * d.x + down.xyz * d.y) + scene.view[view].forward.xyz * d_depth, seen_share * d_thinned);
    }
    d_samples[id.x] = sum;
}
