// Nodes and the straight pieces between them. Twin of src/core/raster/pieces.rs. A node is a usable vertex.

/// The straight stretch between two nodes: its axis and how it tapers.
struct Piece {
    axis: vec2f,
    length: f32,
    /// Sine and cosine of the angle between a side and the axis.
    sine: f32,
    cosine: f32,
    /// False where one disc all but contains the other.
    has_sides: bool,
}

fn vertex_of(view: u32, k: u32) -> vec4f {
    return vertices[view * scene.samples + k];
}

fn piece_between(a: vec4f, b: vec4f) -> Piece {
    let along = b.xy - a.xy;
    let length = sqrt(along.x * along.x + along.y * along.y);
    let rise = b.z - a.z;
    let outcrop = length - abs(rise);
    if length < SHORTEST_PX || outcrop < min(LEAST_OUTCROP_PX, 0.02 * length) {
        return Piece(vec2f(), length, 0.0, 0.0, false);
    }
    let sine = rise / length;
    // 1 - sine^2, without the loss of digits.
    let cosine = sqrt(outcrop / length * (1.0 + abs(sine)));
    return Piece(along / length, length, sine, cosine, true);
}

/// Outward unit normal of the side at `side` = +1 (to the axis turned a quarter from x to y) or -1.
fn side_normal(piece: Piece, side: f32) -> vec2f {
    let across = side * piece.cosine;
    let u = piece.axis;
    return vec2f(-across * u.y - piece.sine * u.x, across * u.x - piece.sine * u.y);
}

/// A box as [x_min, y_min, -x_max, -y_max].
fn disc_box(center: vec2f, radius: f32) -> vec4f {
    return vec4f(center - radius, -center - radius);
}

const MITRED: u32 = 0u;
const SOFT: u32 = 1u;
const HARD: u32 = 2u;
/// No node at all.
const ABSENT: u32 = 3u;

fn side_of(i: u32) -> f32 {
    return 1.0 - 2.0 * f32(i);
}
