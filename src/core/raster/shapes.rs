//! The convex polygons whose union is drawn, as half-planes: one quad a piece, one regular polygon a hard joint.
//!
//! The same polygons hide each other's outlines, so drawn and hiding shape agree to the last bit that matters. They
//! stand in one total order, see [`quad_order`] and [`polygon_order`]: of two edges that lie on each other exactly
//! one stays, because a polygon of lower order hides a touch more and one of higher order a touch less.

use super::extremes::least;
use super::joints::{Joint, Kind};
use super::pieces::{NONE, Node, Piece};
use wide::f32x4;

/// By how much (in pixels) a polygon grows or shrinks when it hides.
pub(super) const ORDER_MARGIN_PX: f32 = 1e-5;
/// By how much (in pixels) boxes are larger than what they hold: their borders are places in the picture, rounded.
pub(super) const BOX_MARGIN_PX: f32 = 1e-3;
/// How far (in pixels) a vertex polygon may stick out of its disc.
pub(super) const ARC_TOLERANCE_PX: f32 = 0.01;
/// Vertex polygons have 8, 10, … 64 sides, then powers of two up to this.
const MOST_SIDES: usize = 4096;
const MOST_EVEN_SIDES: usize = 64;
/// Discs below this radius (in pixels) are points.
pub(super) const SMALLEST_RADIUS_PX: f32 = 1e-6;

/// Place in the total order of the polygon round node `k`.
pub(super) fn polygon_order(k: usize) -> u32 {
    2 * k as u32
}
/// Place in the total order of the quad of piece `k`.
pub(super) fn quad_order(k: usize) -> u32 {
    2 * k as u32 + 1
}

/// The four half-planes `normal . (p - origin) <= offset` of a piece: two sides, then the two end lines.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quad {
    pub normal_x: f32x4,
    pub normal_y: f32x4,
    pub offset: f32x4,
    /// 1 for lines that move with the order margin, 0 for end lines that are never drawn.
    pub margin: f32x4,
    pub origin: [f32; 2],
}

/// A regular polygon round a disc, its sides tangent to it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Polygon {
    pub center: [f32; 2],
    /// Radius of the inscribed circle.
    pub radius: f32,
    /// Number of sides; 0 where there is no polygon.
    pub sides: u32,
    /// Circumscribed over inscribed radius.
    pub stretch: f32,
}

/// Axis-parallel box in pixels as `[x_min, y_min, -x_max, -y_max]`.
pub(super) type NegatedBox = [f32; 4];

pub(super) const EMPTY_BOX: NegatedBox = [f32::INFINITY; 4];

pub(super) fn hull(a: NegatedBox, b: NegatedBox) -> NegatedBox {
    std::array::from_fn(|i| least(a[i], b[i]))
}

pub(super) fn disc_box(center: [f32; 2], radius: f32) -> NegatedBox {
    [center[0] - radius, center[1] - radius, -center[0] - radius, -center[1] - radius]
}

/// All hiders of one pass. Everything is indexed by node; `boxes` by order.
#[derive(Debug, Default)]
pub(super) struct Shapes {
    pub quads: Vec<Quad>,
    pub polygons: Vec<Polygon>,
    pub boxes: Vec<NegatedBox>,
}

impl Shapes {
    pub fn build(&mut self, nodes: &[Node], pieces: &[Piece], joints: &[Joint], circles: &Circles) {
        self.quads.clear();
        self.polygons.clear();
        self.boxes.clear();
        for (k, (node, piece)) in nodes.iter().zip(pieces).enumerate() {
            let polygon = match joints[k].kind {
                Kind::Hard if node.radius > SMALLEST_RADIUS_PX => circles.polygon(node),
                _ => Polygon::default(),
            };
            self.boxes.push(match polygon.sides {
                0 => EMPTY_BOX,
                _ => disc_box(node.center, polygon.radius * polygon.stretch + BOX_MARGIN_PX),
            });
            self.polygons.push(polygon);
            if piece.has_sides && node.next != NONE {
                let (start, end) = (&joints[k], &joints[node.next as usize]);
                self.quads.push(quad(node, &nodes[node.next as usize], piece, start, end));
                let next = &nodes[node.next as usize];
                let at =
                    |node: &Node, [x, y]: [f32; 2]| disc_box([node.center[0] + x, node.center[1] + y], BOX_MARGIN_PX);
                let first = hull(at(node, start.after[0]), at(node, start.after[1]));
                let last = hull(at(next, end.before[0]), at(next, end.before[1]));
                self.boxes.push(hull(first, last));
            } else {
                self.quads.push(Quad {
                    normal_x: f32x4::ZERO,
                    normal_y: f32x4::ZERO,
                    offset: f32x4::splat(-1.0),
                    margin: f32x4::ZERO,
                    origin: [0.0; 2],
                });
                self.boxes.push(EMPTY_BOX);
            }
        }
    }
}

fn quad(node: &Node, next: &Node, piece: &Piece, start: &Joint, end: &Joint) -> Quad {
    let (left, right) = (piece.normal(1.0), piece.normal(-1.0));
    // The line through two corners, its normal towards `outward` along the axis.
    let end_line = |p: [f32; 2], q: [f32; 2], outward: f32| {
        let (dx, dy) = (p[0] - q[0], p[1] - q[1]);
        let length = (dx * dx + dy * dy).sqrt();
        let [ux, uy] = piece.axis;
        let mut normal = if length > 1e-6 { [dy / length, -dx / length] } else { [ux, uy] };
        if (normal[0] * ux + normal[1] * uy) * outward < 0.0 {
            normal = normal.map(|c| -c);
        }
        (normal, normal[0] * p[0] + normal[1] * p[1])
    };
    let (first, first_offset) = end_line(start.after[0], start.after[1], -1.0);
    let (last, last_offset) = end_line(end.before[0], end.before[1], 1.0);
    let last_offset =
        last_offset + last[0] * (next.center[0] - node.center[0]) + last[1] * (next.center[1] - node.center[1]);
    let drawn = |joint: &Joint| if joint.kind == Kind::Soft { 1.0 } else { 0.0 };
    let (drawn_first, drawn_last) = (drawn(start), drawn(end));
    // An end line that is not drawn lies inside a neighbour: reach into it.
    let reach = 2.0 * ORDER_MARGIN_PX;
    Quad {
        normal_x: f32x4::new([left[0], right[0], first[0], last[0]]),
        normal_y: f32x4::new([left[1], right[1], first[1], last[1]]),
        offset: f32x4::new([
            node.radius,
            node.radius,
            first_offset + (1.0 - drawn_first) * reach,
            last_offset + (1.0 - drawn_last) * reach,
        ]),
        margin: f32x4::new([1.0, 1.0, drawn_first, drawn_last]),
        origin: node.center,
    }
}

/// Unit normals of the regular polygons. All polygons with as many sides have the same ones.
#[derive(Debug)]
pub(super) struct Circles {
    normals: Vec<Vec<[f32; 2]>>,
    lanes: Vec<Vec<[f32x4; 2]>>,
}

/// The first number of sides we keep that is at least `wanted`, and its place in [`Circles`].
fn ring(wanted: usize) -> (usize, usize) {
    let sides = if wanted <= MOST_EVEN_SIDES { wanted.next_multiple_of(2).max(8) } else { wanted.next_power_of_two() };
    let sides = sides.min(MOST_SIDES);
    let powers = (sides / MOST_EVEN_SIDES).max(1).ilog2() as usize;
    (sides, sides.min(MOST_EVEN_SIDES) / 2 - 4 + powers)
}

/// Unit normals of the regular polygons we keep, in the order of [`ring`].
fn normals() -> impl Iterator<Item = Vec<[f32; 2]>> {
    let normals_of = |sides: usize| {
        let turn = std::f64::consts::TAU / sides as f64;
        (0..sides).map(|i| (turn * i as f64).sin_cos()).map(|(s, c)| [c as f32, s as f32]).collect()
    };
    let evens = (8..=MOST_EVEN_SIDES).step_by(2);
    let powers = (1..).map(|i| MOST_EVEN_SIDES << i).take_while(|&sides| sides <= MOST_SIDES);
    evens.chain(powers).map(normals_of)
}

/// A regular polygon as shaders are given it.
#[cfg(feature = "gpu")]
pub struct Ring {
    pub normals: Vec<[f32; 2]>,
    /// Circumscribed over inscribed radius.
    pub stretch: f32,
    /// Half a side over the inscribed radius.
    pub half_side: f32,
}

/// All regular polygons we keep.
#[cfg(feature = "gpu")]
pub fn rings() -> impl Iterator<Item = Ring> {
    normals().map(|normals| {
        let half_turn = std::f32::consts::PI / normals.len() as f32;
        Ring { normals, stretch: 1.0 / half_turn.cos(), half_side: half_turn.tan() }
    })
}

impl Default for Circles {
    fn default() -> Self {
        let normals: Vec<_> = normals().collect();
        // The last group repeats its last normal, which changes nothing.
        let group = |ring: &Vec<[f32; 2]>| {
            let lane = |group: &[[f32; 2]], axis: usize| {
                f32x4::new(std::array::from_fn(|i| group[i.min(group.len() - 1)][axis]))
            };
            ring.chunks(4).map(|group| [lane(group, 0), lane(group, 1)]).collect()
        };
        Circles { lanes: normals.iter().map(group).collect(), normals }
    }
}

impl Circles {
    fn polygon(&self, node: &Node) -> Polygon {
        let step = least((8.0 * ARC_TOLERANCE_PX / node.radius).sqrt(), std::f32::consts::FRAC_PI_4);
        let sides = ring(2 * (std::f32::consts::PI / step).ceil() as usize).0;
        let stretch = 1.0 / (std::f32::consts::PI / sides as f32).cos();
        Polygon { center: node.center, radius: node.radius, sides: sides as u32, stretch }
    }

    /// Normals of a polygon with `sides` sides.
    pub fn normals(&self, sides: u32) -> &[[f32; 2]] {
        &self.normals[ring(sides as usize).1]
    }

    /// The same, x and y in groups of four.
    pub fn lanes(&self, sides: u32) -> &[[f32x4; 2]] {
        &self.lanes[ring(sides as usize).1]
    }
}
