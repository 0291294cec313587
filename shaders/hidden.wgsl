// Which part of an edge a polygon hides: exact intervals of its parameter. Twin of src/core/raster/hidden.rs.

/// A straight stretch of a polygon's border, from `origin + start` to `origin + start + along`.
struct Edge {
    origin: vec2f,
    start: vec2f,
    along: vec2f,
    /// Place of its polygon in the total order.
    order: u32,
}

/// From 1 to 0: nothing is hidden.
const NOTHING: vec2f = vec2f(1.0, 0.0);

fn part_of(edge: Edge, low: f32, high: f32) -> Edge {
    return Edge(edge.origin, edge.start + edge.along * low, edge.along * (high - low), edge.order);
}

fn long_enough(low: f32, high: f32) -> vec2f {
    return select(NOTHING, vec2f(low, high), high - low > SHORTEST_HIDDEN);
}

/// Where an edge begins, relative to `origin`.
fn seen_from(origin: vec2f, edge: Edge) -> vec2f {
    return edge.origin - origin + edge.start;
}

/// The part inside four half-planes: signed distances at the edge's middle, and their change from start to end.
fn hidden_by_quad(edge: Edge, s: u32, margin: f32) -> vec2f {
    if shapes[s].has_sides == 0u {
        return NOTHING;
    }
    let normal_x = shapes[s].normal_x;
    let normal_y = shapes[s].normal_y;
    let w = seen_from(shapes[s].origin, edge) + 0.5 * edge.along;
    let value = normal_x * w.x + normal_y * w.y - (shapes[s].offset + vec4f(1.0, 1.0, shapes[s].drawn) * margin);
    let change = normal_x * edge.along.x + normal_y * edge.along.y;
    let swing = abs(change) * 0.5;
    if any(value - swing >= vec4f()) {
        return NOTHING;
    }
    if all(value + swing < vec4f()) {
        return vec2f(0.0, 1.0);
    }
    let root = 0.5 - value / select(change, vec4f(1.0), change == vec4f());
    let enters = select(vec4f(), root, change < vec4f());
    let leaves = select(vec4f(1.0), root, change > vec4f());
    let low = max(max(max(enters.x, enters.y), max(enters.z, enters.w)), 0.0);
    let high = min(min(min(leaves.x, leaves.y), min(leaves.z, leaves.w)), 1.0);
    return long_enough(low, high);
}

fn hidden_by_polygon(edge: Edge, s: u32, margin: f32) -> vec2f {
    let radius = shapes[s].radius + margin;
    if radius <= 0.0 || shapes[s].ring == NONE {
        return NOTHING;
    }
    let ring = scene.rings[shapes[s].ring];
    let w = seen_from(shapes[s].origin, edge);
    let end = w + edge.along;
    if dot(w, w) < radius * radius && dot(end, end) < radius * radius {
        return vec2f(0.0, 1.0);
    }
    // Nearest point of the edge against the circumscribed circle.
    let length_squared = dot(edge.along, edge.along);
    let t = clamp(-dot(w, edge.along), 0.0, length_squared);
    let p = w * length_squared + t * edge.along;
    let outer = radius * ring.z * length_squared;
    if dot(p, p) > outer * outer {
        return NOTHING;
    }
    let first = u32(ring.x);
    let sides = u32(ring.y);
    var low = 0.0;
    var high = 1.0;
    for (var i = 0u; i < sides; i++) {
        let normal = circles[first + i];
        let value = dot(normal, w) - radius;
        var change = dot(normal, edge.along);
        if abs(change) < 1e-20 {
            change = 1e-20;
        }
        let root = -value / change;
        if change < 0.0 {
            low = max(low, root);
        } else {
            high = min(high, root);
        }
    }
    return long_enough(low, high);
}
