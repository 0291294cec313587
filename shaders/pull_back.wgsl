// Backward: what an adjoint picture does to each edge, along the same visible outline. The derivative of a pixel's
// area is the integral over its outline of the outline's normal speed.

var<private> weight_sum: f32;
var<private> weight_moment: f32;

fn visit(view: u32, pixel: u32, area: i32, beyond: i32, length_px: f32, u: f32) {
    let weight = pyramid[scene.view[view].first_pixel + pixel] * length_px;
    weight_sum += weight;
    weight_moment += weight * u;
}

/// Four threads a node and view, one for each straight edge: adjoints of the piece's start and end disc.
@compute @workgroup_size(64)
fn pull_straight(@builtin(global_invocation_id) id: vec3u) {
    if id.x >= 4u * scene.samples {
        return;
    }
    let moving = straight_edge(id.y, id.x / 4u, id.x % 4u);
    trace_edge(id.y, moving);
    let speed = vec4f(moving.normal, moving.radius_weight, 0.0);
    let at = 9u * (id.y * scene.samples + id.x / 4u) + 2u * (id.x % 4u);
    d_pieces[at] = (weight_sum - weight_moment) * speed;
    d_pieces[at + 1u] = weight_moment * speed;
}

const GROUP: u32 = 32u;

var<workgroup> pulls: array<vec3f, GROUP>;

/// A workgroup a node and view, added up as a tree of fixed shape.
@compute @workgroup_size(32)
fn pull_polygons(@builtin(workgroup_id) group: vec3u, @builtin(local_invocation_index) local: u32) {
    var sum = vec3f();
    let sides = polygon_sides(group.y, group.x);
    for (var side = local; side < sides; side += GROUP) {
        let moving = polygon_edge(group.y, group.x, side);
        weight_sum = 0.0;
        trace_edge(group.y, moving);
        sum += weight_sum * vec3f(moving.normal, 1.0);
    }
    pulls[local] = sum;
    workgroupBarrier();
    for (var reach = GROUP / 2u; reach > 0u; reach /= 2u) {
        if local < reach {
            pulls[local] += pulls[local + reach];
        }
        workgroupBarrier();
    }
    if local == 0u {
        d_pieces[9u * (group.y * scene.samples + group.x) + 8u] = vec4f(pulls[0], 0.0);
    }
}
