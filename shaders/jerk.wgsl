// The jerk energy's gradient, added to the image's and the length's. Twin of src/core/wire/jerk.rs.

/// Third derivative on a span times the root of its width.
fn jerk_of_span(span: u32) -> vec4f {
    let row = jerk_rows[span];
    var sum = vec4f();
    for (var k = 0u; k < 4u; k++) {
        sum += row.weights[k] * state[(row.first + k) % scene.points];
    }
    return sum;
}

fn jerk_weights() -> vec4f {
    return vec4f(now.jerk_position, now.jerk_position, now.jerk_position, now.jerk_width);
}
