/// One thread a control point, its spans in fixed order.
@compute @workgroup_size(64)
fn jerk_gradient(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.points {
        return;
    }
    var sum = vec4f();
    for (var i = jerk_starts[id.x]; i < jerk_starts[id.x + 1u]; i++) {
        let term = jerk_terms[i];
        sum += term.weight * jerk_of_span(term.row);
    }
    d_points[id.x] += 2.0 * jerk_weights() * sum;
}
