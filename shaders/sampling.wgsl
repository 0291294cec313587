// Control points to samples and back. Twin of src/wire/linear_map.rs.

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

/// One thread a control point, its samples in fixed order; the length pulls along the same way.
@compute @workgroup_size(64)
fn sample_transpose(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.points {
        return;
    }
    var image = vec4f();
    var pull = vec3f();
    for (var i = sampling_starts[id.x]; i < sampling_starts[id.x + 1u]; i++) {
        let term = sampling_terms[i];
        image += term.weight * d_samples[term.row];
        if now.length > 0.0 {
            pull += term.weight * d_length(term.row);
        }
    }
    d_points_image[id.x] = image;
    d_points[id.x] = image + vec4f(now.length * pull, 0.0);
}
