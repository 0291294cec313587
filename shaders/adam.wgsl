// What an iteration leaves behind, then a step of Adam and the width's bounds. Twin of `Tally::note` and `State::step`
// (src/optimize/engine.rs). One thread a control point.

@compute @workgroup_size(64)
fn adam(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.points {
        return;
    }
    if best[0].y == 1.0 {
        best[1u + id.x] = state[id.x];
    }
    gradient_norms[id.x] += now.gradient_share * (length(d_points_image[id.x].xyz) - gradient_norms[id.x]);
    let gradient = d_points[id.x];
    var gradient_squared = gradient * gradient;
    if now.per_point == 1u {
        gradient_squared = vec4f(vec3f(dot(gradient.xyz, gradient.xyz)), gradient_squared.w);
    }
    let first = now.beta1 * state[scene.points + id.x] + (1.0 - now.beta1) * gradient;
    let second = now.beta2 * state[2u * scene.points + id.x] + (1.0 - now.beta2) * gradient_squared;
    let root = sqrt(second / now.correction2) + now.epsilon;
    var point = state[id.x] - now.rates * (first / now.correction1) / root;
    point.w = clamp(point.w, now.width_bounds.x, now.width_bounds.y);
    state[id.x] = point;
    state[scene.points + id.x] = first;
    state[2u * scene.points + id.x] = second;
}
