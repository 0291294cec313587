// Backward: what an adjoint picture does to each edge, along the same visible outline. The derivative of a pixel's
// area is the integral over its outline of the outline's normal speed.

var<private> weight_sum: f32;
var<private> weight_moment: f32;

/// What edges do to their piece's start and end disc, or a polygon's sides to its node.
var<workgroup> pulls: array<vec3f, 64>;
var<workgroup> end_pulls: array<vec3f, 64>;
var<workgroup> shown: u32;

fn visit(view: u32, pixel: u32, area: i32, beyond: i32, length_px: f32, u: f32) {
    let weight = pyramid[scene.view[view].first_pixel + pixel] * length_px;
    weight_sum += weight;
    weight_moment += weight * u;
}

/// Adjoints of the start and end disc of sixteen pieces.
fn pull_straight(view: u32, group: u32, local: u32) {
    let k = node_of(group, local);
    let moving = straight_edge(view, k, edge_of(local));
    if k < scene.samples {
        let known = visible[4u * (view * scene.samples + k) + edge_of(local)];
        if known.x < known.y {
            walk_visible(view, moving.edge, known.x, known.y, moving.u);
        } else if known.x > known.y {
            trace_edge(view, moving);
        }
    }
    let speed = vec3f(moving.normal, moving.radius_weight);
    pulls[local] = (weight_sum - weight_moment) * speed;
    end_pulls[local] = weight_moment * speed;
    workgroupBarrier();
    if edge_of(local) == 0u && k < scene.samples {
        var start = vec3f();
        var end = vec3f();
        for (var i = local; i < 64u; i += NODES) {
            start += pulls[i];
            end += end_pulls[i];
        }
        let at = 3u * (view * scene.samples + k);
        d_pieces[at] = vec4f(start, 0.0);
        d_pieces[at + 1u] = vec4f(end, 0.0);
    }
}

/// Adjoints of two nodes by their polygons, added up as trees of fixed shape.
fn pull_polygons(view: u32, i: u32, local: u32) {
    var sum = vec3f();
    var k = NONE;
    if i < shown {
        k = filled[first_shown(view) + i];
        for (var side = local % 32u; side < polygon_sides(view, k); side += 32u) {
            let moving = polygon_edge(view, k, side);
            weight_sum = 0.0;
            trace_edge(view, moving);
            sum += weight_sum * vec3f(moving.normal, 1.0);
        }
    }
    pulls[local] = sum;
    workgroupBarrier();
    for (var reach = 16u; reach > 0u; reach /= 2u) {
        if local % 32u < reach {
            pulls[local] += pulls[local + reach];
        }
        workgroupBarrier();
    }
    if local % 32u == 0u && k != NONE {
        d_pieces[3u * (view * scene.samples + k) + 2u] = vec4f(pulls[local], 0.0);
    }
    workgroupBarrier();
}

/// Workgroups for straight edges, then for polygons.
@compute @workgroup_size(64)
fn pull_back(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    let view = group.y;
    if group.x < straight_groups() {
        pull_straight(view, group.x, local);
        return;
    }
    if local == 0u {
        shown = filled[SHOWN_COUNTS + view];
    }
    let count = workgroupUniformLoad(&shown);
    for (var i = first_polygon(group.x, 0u); i < count; i += 2u * polygon_groups()) {
        pull_polygons(view, i + local / 32u, local);
    }
}
