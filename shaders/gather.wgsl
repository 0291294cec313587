/// Adjoints of edges to those of vertices, in fixed order. One thread a node and view.
@compute @workgroup_size(64)
fn gather_pulls(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.samples {
        return;
    }
    let first = id.y * scene.samples;
    var sum = vec4f();
    let previous = joints[first + id.x].previous;
    for (var edge = 0u; edge < 4u; edge++) {
        sum += d_pieces[9u * (first + id.x) + 2u * edge];
        if previous != NONE {
            sum += d_pieces[9u * (first + previous) + 2u * edge + 1u];
        }
    }
    d_vertices[first + id.x] = sum + d_pieces[9u * (first + id.x) + 8u];
}
