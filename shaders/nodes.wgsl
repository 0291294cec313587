// What a wire costs that bends and takes room. Twin of src/core/objective/elastic.rs and src/core/objective/clearance.rs.

/// The curve at a node, or a derivative, by the weights of its control points.
fn curve(node: Node, weights: vec4f) -> vec4f {
    var sum = vec4f();
    for (var k = 0u; k < 4u; k++) {
        sum += weights[k] * state[(node.first + k) % scene.points];
    }
    return sum;
}

/// ln(1 + x): near 1 a device's logarithm knows little more than that it is small.
fn log_above_1(x: f32) -> f32 {
    if x > 0.5 {
        return log(1.0 + x);
    }
    let s = x / (2.0 + x);
    let q = s * s;
    return 2.0 * s * (1.0 + q * (1.0 / 3.0 + q * (1.0 / 5.0 + q * (1.0 / 7.0 + q / 9.0))));
}

/// A node's gradient, and its losses: bending, tightness, evenness, clearance.
struct Pull {
    place: vec4f,
    first: vec3f,
    second: vec3f,
    losses: vec4f,
}

fn bend(pull: ptr<function, Pull>, node: Node, width: f32) {
    let a = curve(node, node.first_derivative).xyz;
    let speed = sqrt(dot(a, a) + now.standstill * now.standstill);
    let tangent = a / speed;
    let turn = curve(node, node.second_derivative).xyz / (speed * speed);
    let along = dot(tangent, turn);
    let turn_squared = dot(turn, turn);
    let curvature_squared = max(turn_squared - along * along, 0.0);
    let length = speed * node.step;

    let cusp_squared = now.cusp_radius * now.cusp_radius;
    let cusp = cusp_squared * curvature_squared;
    var density = now.bending * log_above_1(cusp) / cusp_squared;
    var d_square = now.bending * length / (1.0 + cusp);
    (*pull).losses.x = density * length;

    let by_width = now.least_diameters * width;
    let radius = max(by_width, now.least_radius);
    let curvature = sqrt(curvature_squared);
    let over = radius * curvature - 1.0;
    if over > 0.0 {
        let hinge = over * over / (1.0 + over);
        let slope = (over * over + 2.0 * over) / ((1.0 + over) * (1.0 + over));
        let tight = now.tightness * radius * hinge;
        density += tight;
        (*pull).losses.y = tight * length;
        d_square += now.tightness * length * radius * radius * slope / (2.0 * curvature);
        if by_width > now.least_radius {
            let d_radius = now.tightness * length * (hinge + radius * curvature * slope);
            (*pull).place.w = d_radius * now.least_diameters;
        }
    }

    let uneven = speed / now.even_speed - 1.0;
    (*pull).losses.z = now.evenness * uneven * uneven * now.even_speed * node.step;
    let d_speed = (density + 2.0 * now.evenness * uneven) * node.step;
    let d_tangent = turn_squared * tangent - along * turn - 3.0 * curvature_squared * tangent;
    (*pull).first = 2.0 * d_square / speed * d_tangent + d_speed * tangent;
    (*pull).second = 2.0 * d_square / (speed * speed) * (turn - along * tangent);
}

fn keep_clear(pull: ptr<function, Pull>, node: Node, i: u32, place: vec4f) {
    for (var n = neighbours[i]; n < neighbours[i + 1u]; n++) {
        let neighbour = nodes[neighbours[n]];
        let other = curve(neighbour, neighbour.place);
        let apart = place.xyz - other.xyz;
        let distance = length(apart);
        let by_width = 0.5 * now.clearance_diameters * (place.w + other.w);
        let least = max(by_width, now.least_clearance);
        if distance >= least {
            continue;
        }
        let near = 1.0 - distance / least;
        let share = now.clearance * now.mean_speed * now.mean_speed * node.step * neighbour.step / least;
        // Each pair is seen from both its ends.
        (*pull).losses.w += 0.5 * share * near * near;
        if distance > 0.0 {
            (*pull).place -= vec4f(2.0 * share * near / (least * distance) * apart, 0.0);
        }
        if by_width > now.least_clearance {
            let d_least = share * near * (2.0 * distance / least - near) / least;
            (*pull).place.w += 0.5 * now.clearance_diameters * d_least;
        }
    }
}

/// One thread a node; a workgroup's losses are added up as trees of fixed shape.
@compute @workgroup_size(256)
fn pull_nodes(
    @builtin(workgroup_id) group: vec3u,
    @builtin(local_invocation_index) local: u32,
) {
    let i = group.x * GROUP + local;
    var pull = Pull();
    if i < scene.nodes {
        let node = nodes[i];
        let place = curve(node, node.place);
        if max(now.bending, max(now.tightness, now.evenness)) > 0.0 {
            bend(&pull, node, place.w);
        }
        if now.clearance > 0.0 {
            keep_clear(&pull, node, i, place);
        }
        d_nodes[3u * i] = pull.place;
        d_nodes[3u * i + 1u] = vec4f(pull.first, 0.0);
        d_nodes[3u * i + 2u] = vec4f(pull.second, 0.0);
    }
    for (var loss = 0u; loss < 4u; loss++) {
        let sum = sum_up(pull.losses[loss], local);
        if local == 0u {
            partials[scene.node_partial + 4u * group.x + loss] = sum;
        }
    }
}
