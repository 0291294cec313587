/// Adjoints of edges to those of vertices, in fixed order. One thread a node and view.
@compute @workgroup_size(64)
fn gather_pulls(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= scene.samples {
        return;
    }
    let first = id.y * scene.samples;
    var sum = d_pieces[3u * (first + id.x)];
    let previous = joints[first + id.x].previous;
    if previous != NONE {
        sum += d_pieces[3u * (first + previous) + 1u];
    }
    if is_shown(id.y, 2u * id.x) {
        sum += d_pieces[3u * (first + id.x) + 2u];
    }
    d_vertices[first + id.x] = sum;
}
