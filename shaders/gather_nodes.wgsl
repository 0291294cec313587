/// Adjoints of nodes to those of control points, added to what pulls at them already. One thread a control point, its
/// nodes in fixed order.
@compute @workgroup_size(64)
fn gather_nodes(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.points {
        return;
    }
    var sum = vec4f();
    for (var n = point_nodes[id.x]; n < point_nodes[id.x + 1u]; n++) {
        let i = point_nodes[n];
        let node = nodes[i];
        let k = (id.x + scene.points - node.first) % scene.points;
        sum += node.place[k] * d_nodes[3u * i];
        sum += node.first_derivative[k] * d_nodes[3u * i + 1u];
        sum += node.second_derivative[k] * d_nodes[3u * i + 2u];
    }
    d_points[id.x] += sum;
}
