// The convex polygons whose union is drawn: a quad a piece, a regular polygon a hard joint. Twin of
// src/raster/shapes.rs. In the total order the polygon of node k is 2 k, the quad of piece k is 2 k + 1.

const EMPTY_BOX: vec4f = vec4f(1e30);
const MOST_EVEN_SIDES: u32 = 64u;
const MOST_SIDES: u32 = 4096u;

/// Place in `rings` of the polygon that sticks out of a disc by no more than the tolerance.
fn ring_of(radius: f32) -> u32 {
    let turn = min(sqrt(8.0 * ARC_TOLERANCE_PX / radius), 0.78539816);
    let wanted = 2u * u32(ceil(3.14159265 / turn));
    if wanted <= MOST_EVEN_SIDES {
        return max(wanted, 8u) / 2u - 4u;
    }
    var sides = 2u * MOST_EVEN_SIDES;
    var ring = MOST_EVEN_SIDES / 2u - 3u;
    while sides < wanted && sides < MOST_SIDES {
        sides *= 2u;
        ring++;
    }
    return ring;
}

/// The line through two corners, its normal towards `outward` along the axis, and its offset.
fn end_line(p: vec2f, q: vec2f, axis: vec2f, outward: f32) -> vec3f {
    let along = p - q;
    let length = sqrt(along.x * along.x + along.y * along.y);
    var normal = axis;
    if length > 1e-6 {
        normal = vec2f(along.y, -along.x) / length;
    }
    if dot(normal, axis) * outward < 0.0 {
        normal = -normal;
    }
    return vec3f(normal, dot(normal, p));
}

/// A box round a point relative to a node.
fn corner_box(node: vec4f, corner: vec2f) -> vec4f {
    return disc_box(node.xy + corner, BOX_MARGIN_PX);
}

/// One thread a node and view. Makes room for `fill_cells`, too.
@compute @workgroup_size(64)
fn shape_nodes(@builtin(global_invocation_id) id: vec3u) {
    let k = id.x;
    if k >= scene.samples {
        return;
    }
    let view = id.y;
    let first = view * scene.samples;
    empty_cells(first + k, scene.samples * scene.views);
    let node = vertex_of(view, k);
    let start = joints[first + k];
    var shape = Shape();
    shape.quad_box = EMPTY_BOX;
    shape.polygon_box = EMPTY_BOX;
    shape.origin = node.xy;
    shape.radius = node.z;
    shape.ring = NONE;
    if start.kind == HARD && node.z > SMALLEST_RADIUS_PX {
        shape.ring = ring_of(node.z);
        shape.polygon_box = disc_box(node.xy, node.z * scene.rings[shape.ring].z + BOX_MARGIN_PX);
    }
    if start.next != NONE {
        let next = vertex_of(view, start.next);
        let piece = piece_between(node, next);
        if piece.has_sides {
            let end = joints[first + start.next];
            let left = side_normal(piece, 1.0);
            let right = side_normal(piece, -1.0);
            let near = end_line(start.after[0], start.after[1], piece.axis, -1.0);
            var far = end_line(end.before[0], end.before[1], piece.axis, 1.0);
            far.z += dot(far.xy, next.xy - node.xy);
            shape.has_sides = 1u;
            shape.drawn = vec2f(select(0.0, 1.0, start.kind == SOFT), select(0.0, 1.0, end.kind == SOFT));
            shape.normal_x = vec4f(left.x, right.x, near.x, far.x);
            shape.normal_y = vec4f(left.y, right.y, near.y, far.y);
            // An end line that is not drawn lies inside a neighbour: reach into it.
            let reach = (1.0 - shape.drawn) * 2.0 * ORDER_MARGIN_PX;
            shape.offset = vec4f(node.z, node.z, near.z + reach.x, far.z + reach.y);
            shape.quad_box = min(corner_box(node, start.after[0]), corner_box(node, start.after[1]));
            shape.quad_box = min(shape.quad_box, corner_box(next, end.before[0]));
            shape.quad_box = min(shape.quad_box, corner_box(next, end.before[1]));
        }
    }
    shapes[first + k] = shape;
}
