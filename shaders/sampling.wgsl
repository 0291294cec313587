// Control points to samples and back. Twin of src/core/wire/linear_map.rs.

/// One thread a sample.
@compute @workgroup_size(64)
fn sample(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.samples {
        return;
    }
    let row = sampling_rows[id.x];
    var sum = vec4f();
    for (var k = 0u; k < 4u; k++) {
        sum += row.weights[k] * state[(row.first + k) % scene.points];
    }
    samples[id.x] = sum;
}

const GROUP: u32 = 32u;

var<workgroup> images: array<vec4f, GROUP>;
var<workgroup> pulls: array<vec3f, GROUP>;

/// A workgroup a control point, its samples added up as a tree of fixed shape; length and surface pull along the same way.
@compute @workgroup_size(32)
fn sample_transpose(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    var image = vec4f();
    var pull = vec3f();
    for (var i = sampling_starts[group.x] + local; i < sampling_starts[group.x + 1u]; i += GROUP) {
        let term = sampling_terms[i];
        image += term.weight * d_samples[term.row];
        if now.length > 0.0 {
            pull += term.weight * now.length * d_length(term.row);
        }
        if scene.planes > 0u {
            pull += term.weight * d_surface(term.row);
        }
    }
    images[local] = image;
    pulls[local] = pull;
    workgroupBarrier();
    for (var half = GROUP / 2u; half > 0u; half /= 2u) {
        if local < half {
            images[local] += images[local + half];
            pulls[local] += pulls[local + half];
        }
        workgroupBarrier();
    }
    if local == 0u {
        d_points_image[group.x] = images[0];
        d_points[group.x] = images[0] + vec4f(pulls[0], 0.0);
    }
}
