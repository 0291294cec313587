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

/// How much of the border x = 0 of eight rows nothing covers.
fn trace_border(view: u32, begin: u32) {
    let height = scene.view[view].height;
    if begin < height {
        bordering = true;
        let edge = Edge(vec2f(), vec2f(0.0, f32(begin)), vec2f(0.0, f32(min(height - begin, 8u))), NONE);
        trace_part(view, edge, vec3u(NONE), vec2f());
    }
}

/// Workgroups for straight edges, then for polygons, then for the border.
@compute @workgroup_size(64)
fn trace(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let view = group.y;
    if group.x < straight_groups() {
        let k = node_of(group.x, local);
        trace_edge(view, straight_edge(view, k, edge_of(local)));
        if k < scene.samples {
            visible[4u * (view * scene.samples + k) + edge_of(local)] = seen;
        }
    } else if group.x < straight_groups() + polygon_groups() {
        let count = filled[SHOWN_COUNTS + view];
        for (var i = first_polygon(group.x, local); i < count; i += 2u * polygon_groups()) {
            let k = filled[first_shown(view) + i];
            for (var side = local % 32u; side < polygon_sides(view, k); side += 32u) {
                trace_edge(view, polygon_edge(view, k, side));
            }
        }
    } else {
        trace_border(view, 8u * (64u * (group.x - straight_groups() - polygon_groups()) + local));
    }
}
