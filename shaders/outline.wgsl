// The visible outline: sides and drawn end lines of pieces, polygons of nodes, cut by the picture, by what hides them
// and by the pixels. Twin of src/core/raster/outline.rs. Whoever uses this defines `visit`, what becomes of a sub-edge.

/// An edge to trace and how it moves.
struct Moving {
    edge: Edge,
    /// Hiders that do not apply: its own polygon and neighbours it shares an end point with.
    skip: vec3u,
    normal: vec2f,
    /// How far it moves out when the radius grows.
    radius_weight: f32,
    /// Parameter along the piece at its start and end.
    u: vec2f,
    exists: bool,
}

/// Hidden intervals in hand. With more, the ones that begin last are dropped, and looked for again.
const MOST_INTERVALS: u32 = 8u;
/// Beyond any parameter.
const NEVER: f32 = 2.0;

var<private> hidden_low: array<f32, MOST_INTERVALS>;
var<private> hidden_high: array<f32, MOST_INTERVALS>;
var<private> hidden_count: u32;
/// Nothing is known of hidden intervals that begin from here on.
var<private> horizon: f32;

/// The stretch in hand, as parameters of its edge.
var<private> stretch: vec2f;
/// What of the edge was visible so far, as long as that is one interval; nothing at first.
var<private> seen: vec2f;
/// In place of several intervals.
const SEVERAL: vec2f = vec2f(1.0, 0.0);

/// Adds to what was seen an interval of the stretch in hand.
fn see(low: f32, high: f32) {
    let begin = mix(stretch.x, stretch.y, low);
    let to = mix(stretch.x, stretch.y, high);
    if seen.x == seen.y {
        seen = vec2f(begin, to);
    } else if seen.x < seen.y && abs(begin - seen.y) < SHORTEST_VISIBLE {
        seen.y = to;
    } else {
        seen = SEVERAL;
    }
}

/// Adds an interval to those in hand, which stay apart by more than what counts as visible. True if it covers all.
fn cover(begin: f32, to: f32) -> bool {
    var low = begin;
    var high = to;
    var kept = 0u;
    for (var i = 0u; i < hidden_count; i++) {
        let a = hidden_low[i];
        let b = hidden_high[i];
        if a > high + SHORTEST_VISIBLE || b + SHORTEST_VISIBLE < low {
            hidden_low[kept] = a;
            hidden_high[kept] = b;
            kept++;
        } else {
            low = min(low, a);
            high = max(high, b);
        }
    }
    if kept == MOST_INTERVALS {
        var last = 0u;
        for (var i = 1u; i < MOST_INTERVALS; i++) {
            if hidden_low[i] > hidden_low[last] {
                last = i;
            }
        }
        if low > hidden_low[last] {
            horizon = min(horizon, low);
            hidden_count = kept;
            return false;
        }
        horizon = min(horizon, hidden_low[last]);
        kept--;
        hidden_low[last] = hidden_low[kept];
        hidden_high[last] = hidden_high[kept];
    }
    hidden_low[kept] = low;
    hidden_high[kept] = high;
    hidden_count = kept + 1u;
    return low <= SHORTEST_VISIBLE && high >= 1.0 - SHORTEST_VISIBLE;
}

/// Adds what one polygon hides beyond `reached`.
fn cover_by(view: u32, order: u32, edge: Edge, reached: f32) -> bool {
    let margin = select(-ORDER_MARGIN_PX, ORDER_MARGIN_PX, order < edge.order);
    let s = view * scene.samples + order / 2u;
    var interval = NOTHING;
    if order % 2u == 0u {
        interval = hidden_by_polygon(edge, s, margin);
    } else {
        interval = hidden_by_quad(edge, s, margin);
    }
    return interval.x < interval.y && interval.y > reached && cover(interval.x, interval.y);
}

/// Collects what hides an edge beyond `reached`. True if all of it is hidden.
fn collect_hidden(view: u32, edge: Edge, skip: vec3u, reached: f32) -> bool {
    hidden_count = 0u;
    horizon = NEVER;
    let start = edge.origin + edge.start;
    let end = start + edge.along;
    let query = vec4f(min(start, end), -max(start, end));
    let range = cells_of(view, query);
    for (var y = range.z; y <= range.w; y++) {
        for (var x = range.x; x <= range.y; x++) {
            var entry = filled[head_at(view, x, y)];
            while entry != 0u {
                let order = filled[entry_at(entry)];
                entry = filled[entry_at(entry) + 1u];
                let bounds = box_of(view, order);
                if any(vec3u(order) == skip) || !boxes_touch(bounds, query) {
                    continue;
                }
                // A box in several cells counts only in the first, but a long piece is not in every cell of its box.
                let known = (x > range.x && bounds.x < f32(x) * CELL_PX)
                    || (y > range.z && bounds.y < f32(y) * CELL_PX);
                if known && !is_long(bounds) {
                    continue;
                }
                if cover_by(view, order, edge, reached) {
                    return true;
                }
            }
        }
    }
    let large = filled[LARGE_COUNTS + view];
    for (var i = 0u; i < large; i++) {
        let order = filled[first_large(view) + i];
        if all(vec3u(order) != skip) && boxes_touch(box_of(view, order), query)
            && cover_by(view, order, edge, reached) {
            return true;
        }
    }
    return false;
}

/// Walks the visible parts of an edge, whose u runs from `u.x` to `u.y`.
fn trace_part(view: u32, edge: Edge, skip: vec3u, u: vec2f) {
    var reached = 0.0;
    loop {
        if collect_hidden(view, edge, skip, reached) {
            return;
        }
        loop {
            var next = NEVER;
            var next_end = 0.0;
            for (var i = 0u; i < hidden_count; i++) {
                if hidden_high[i] > reached && hidden_low[i] < next {
                    next = hidden_low[i];
                    next_end = hidden_high[i];
                }
            }
            if next >= horizon {
                break;
            }
            if next > reached + SHORTEST_VISIBLE {
                walk_visible(view, edge, reached, next, u);
            }
            reached = next_end;
        }
        if horizon == NEVER || reached >= 1.0 - SHORTEST_VISIBLE {
            break;
        }
    }
    if reached < 1.0 - SHORTEST_VISIBLE {
        walk_visible(view, edge, reached, 1.0, u);
    }
}

fn walk_visible(view: u32, edge: Edge, low: f32, high: f32, u: vec2f) {
    see(low, high);
    let size = vec2f(f32(scene.view[view].width), f32(scene.view[view].height));
    let seen = part_of(edge, low, high);
    let begin = seen.origin + seen.start;
    let start = clamp(begin, vec2f(), size);
    let end = clamp(begin + seen.along, vec2f(), size);
    walk(view, scene.view[view].width, start, end - start, mix(u.x, u.y, low), (u.y - u.x) * (high - low));
}

/// Cuts an edge into stretches short enough to look up their hiders.
fn trace_edge(view: u32, moving: Moving) {
    let edge = moving.edge;
    if !moving.exists || max(abs(edge.along.x), abs(edge.along.y)) < SHORTEST_EDGE_PX {
        return;
    }
    let inside = clip(edge, vec2f(f32(scene.view[view].width), f32(scene.view[view].height)));
    if inside.x >= inside.y {
        return;
    }
    let parts = max(ceil((inside.y - inside.x) * length(edge.along) / STRETCH_PX), 1.0);
    for (var i = 0.0; i < parts; i += 1.0) {
        let low = inside.x + (inside.y - inside.x) * (i / parts);
        let high = inside.x + (inside.y - inside.x) * ((i + 1.0) / parts);
        let u = vec2f(mix(moving.u.x, moving.u.y, low), mix(moving.u.x, moving.u.y, high));
        stretch = vec2f(low, high);
        trace_part(view, part_of(edge, low, high), moving.skip, u);
    }
}

/// One of a piece's straight edges: its two sides, then the end lines of soft joints. That end lines also turn is left
/// out.
fn straight_edge(view: u32, k: u32, which: u32) -> Moving {
    var moving = Moving();
    let first = view * scene.samples;
    if k >= scene.samples || shapes[first + k].has_sides == 0u {
        return moving;
    }
    let next = joints[first + k].next;
    let order = 2u * k + 1u;
    if which < 2u {
        let origin = vertex_of(view, k);
        let other = vertex_of(view, next);
        let piece = piece_between(origin, other);
        let start = joints[first + k].after[which];
        let end = other.xy - origin.xy + joints[first + next].before[which];
        let per_px = 1.0 / (piece.length * piece.cosine);
        let u = vec2f(-joints[first + k].extension[which], joints[first + next].extension[which]) * per_px
            + vec2f(0.0, 1.0);
        moving.skip = vec3u(order, NONE, NONE);
        if (joints[first + k].shared_sides & (1u << which)) != 0u {
            moving.skip.y = 2u * joints[first + k].previous + 1u;
        }
        if (joints[first + next].shared_sides & (1u << which)) != 0u {
            moving.skip.z = 2u * next + 1u;
        }
        // Counter-clockwise round the piece: the second side runs backwards.
        if which == 0u {
            moving.edge = Edge(origin.xy, start, end - start, order);
            moving.u = u;
        } else {
            moving.edge = Edge(origin.xy, end, start - end, order);
            moving.u = u.yx;
        }
        moving.normal = side_normal(piece, side_of(which));
        moving.radius_weight = 1.0;
        moving.exists = true;
        return moving;
    }
    let at_end = which == 3u;
    let joint = joints[first + select(k, next, at_end)];
    if joint.kind != SOFT {
        return moving;
    }
    var begin = joint.after[1];
    var to = joint.after[0];
    if at_end {
        begin = joint.before[0];
        to = joint.before[1];
    }
    let along = to - begin;
    moving.edge = Edge(vertex_of(view, select(k, next, at_end)).xy, begin, along, order);
    moving.skip = vec3u(order, NONE, NONE);
    moving.normal = vec2f(-along.y, along.x) / max(length(along), 1e-20);
    moving.u = vec2f(select(0.0, 1.0, at_end));
    moving.exists = true;
    return moving;
}

/// Nodes whose straight edges a workgroup of 64 threads traces: first one side of each, then the other, then the end
/// lines, few of which exist. So threads that have nothing to do stand together.
const NODES: u32 = 16u;

fn straight_groups() -> u32 {
    return (scene.samples + NODES - 1u) / NODES;
}

fn node_of(group: u32, local: u32) -> u32 {
    return group * NODES + local % NODES;
}

fn edge_of(local: u32) -> u32 {
    return local / NODES;
}

/// Workgroups that share the polygons a view shows, two at a time, 32 threads each.
fn polygon_groups() -> u32 {
    return (scene.samples + 7u) / 8u;
}

/// A thread's first among the polygons a view shows.
fn first_polygon(group: u32, local: u32) -> u32 {
    return 2u * (group - straight_groups()) + local / 32u;
}

/// How many sides the polygon round a node has.
fn polygon_sides(view: u32, k: u32) -> u32 {
    let ring = shapes[view * scene.samples + k].ring;
    if ring == NONE {
        return 0u;
    }
    return u32(scene.rings[ring].y);
}

fn polygon_edge(view: u32, k: u32, side: u32) -> Moving {
    let s = view * scene.samples + k;
    let ring = scene.rings[shapes[s].ring];
    let radius = shapes[s].radius;
    let normal = circles[u32(ring.x) + side];
    let half_side = radius * ring.w;
    let start = radius * normal + half_side * vec2f(-normal.y, normal.x);
    let along = 2.0 * half_side * vec2f(normal.y, -normal.x);
    return Moving(Edge(shapes[s].origin, start, along, 2u * k), vec3u(2u * k, NONE, NONE), normal, 1.0, vec2f(), true);
}
