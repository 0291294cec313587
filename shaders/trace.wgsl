// Forward: the visible outline into integer sums, in any order.

/// Whether the left border is traced instead of a polygon.
var<private> bordering: bool;

fn visit(view: u32, pixel: u32, area: i32, beyond: i32, length_px: f32, u: f32) {
    if bordering {
        let row = pixel / scene.view[view].width;
        atomicAdd(&sums[scene.pixels + scene.view[view].first_row + row], area);
        return;
    }
    let at = scene.view[view].first_pixel + pixel;
    if (atomicAdd(&sums[at], area) & TOUCHED) == 0 {
        atomicOr(&sums[at], TOUCHED);
    }
    if beyond != 0 {
        atomicAdd(&sums[at + 1u], beyond);
    }
}

/// Four threads a node and view, one for each straight edge.
@compute @workgroup_size(64)
fn trace_straight(@builtin(global_invocation_id) id: vec3u) {
    if id.x < 4u * scene.samples {
        trace_edge(id.y, straight_edge(id.y, id.x / 4u, id.x % 4u));
    }
}

/// A workgroup a node and view.
@compute @workgroup_size(32)
fn trace_polygons(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let sides = polygon_sides(group.y, group.x);
    for (var side = local; side < sides; side += 32u) {
        trace_edge(group.y, polygon_edge(group.y, group.x, side));
    }
}

/// A thread for each eight rows of a view: how much of the border x = 0 nothing covers.
@compute @workgroup_size(64)
fn trace_border(@builtin(global_invocation_id) id: vec3u) {
    let begin = 8u * id.x;
    let height = scene.view[id.y].height;
    if begin < height {
        bordering = true;
        let edge = Edge(vec2f(0.0, f32(begin)), vec2f(0.0, f32(min(height - begin, 8u))), NONE);
        trace_part(id.y, edge, vec3u(NONE), vec2f());
    }
}
