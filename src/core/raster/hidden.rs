//! Which part of an edge other polygons hide: exact intervals, no samples, no square roots but one a polygon.

use super::extremes::{least, most};
use super::shapes::{Circles, ORDER_MARGIN_PX, Polygon, Quad, Shapes};
use wide::f32x4;

/// A straight stretch of one polygon's border, from `origin + start` to `origin + start + step`. Relative to a node
/// of its own, so that it is known far better than places in the picture are in f32: two polygons must agree on
/// which of them reaches further.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub origin: [f32; 2],
    pub start: [f32; 2],
    pub step: [f32; 2],
    /// Place of its polygon in the total order.
    pub order: u32,
}

impl Edge {
    /// Where it begins in the picture.
    pub fn place(&self) -> [f32; 2] {
        [self.origin[0] + self.start[0], self.origin[1] + self.start[1]]
    }

    /// Where it begins, relative to `origin`.
    #[inline(always)]
    fn seen_from(&self, origin: [f32; 2]) -> [f32; 2] {
        [self.origin[0] - origin[0] + self.start[0], self.origin[1] - origin[1] + self.start[1]]
    }

    /// The stretch of this edge between two of its parameters.
    pub fn part(&self, from: f32, to: f32) -> Edge {
        let ([x, y], [dx, dy]) = (self.start, self.step);
        Edge { start: [x + dx * from, y + dy * from], step: [dx * (to - from), dy * (to - from)], ..*self }
    }
}

/// What one hider does to an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Hidden {
    Nothing,
    Everything,
    Between(f32, f32),
}

/// Shorter stretches, as shares of the edge, are rounding.
pub(super) const SHORTEST_HIDDEN: f32 = 1e-6;
pub(super) const SHORTEST_VISIBLE: f32 = 1e-5;

/// Replaces `visible` by the parts of `edge` (as parameter intervals, in order) that none of `candidates` hides.
/// A candidate that hides all of it moves to the front, as it will likely hide the next edge as well.
#[inline]
pub(super) fn visible_parts(
    edge: &Edge,
    shapes: &Shapes,
    circles: &Circles,
    candidates: &mut [u32],
    hidden: &mut Vec<[f32; 2]>,
    visible: &mut Vec<[f32; 2]>,
) {
    visible.clear();
    hidden.clear();
    for i in 0..candidates.len() {
        let order = candidates[i];
        let margin = if order < edge.order { ORDER_MARGIN_PX } else { -ORDER_MARGIN_PX };
        let node = (order / 2) as usize;
        let effect = match order % 2 {
            0 => hidden_by_polygon(edge, &shapes.polygons[node], circles, margin),
            _ => hidden_by_quad(edge, &shapes.quads[node], margin),
        };
        match effect {
            Hidden::Nothing => {}
            Hidden::Everything => {
                candidates[..=i].rotate_right(1);
                return;
            }
            Hidden::Between(from, to) => hidden.push([from, to]),
        }
    }
    if hidden.len() > 1 {
        hidden.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    }
    let mut reached = 0.0f32;
    for &[from, to] in hidden.iter() {
        if from > reached + SHORTEST_VISIBLE {
            visible.push([reached, from]);
        }
        reached = most(reached, to);
    }
    if reached < 1.0 - SHORTEST_VISIBLE {
        visible.push([reached, 1.0]);
    }
}

#[inline(always)]
fn last_of(lanes: f32x4) -> f32 {
    let [a, b, c, d] = lanes.to_array();
    most(most(a, b), most(c, d))
}

#[inline(always)]
fn first_of(lanes: f32x4) -> f32 {
    let [a, b, c, d] = lanes.to_array();
    least(least(a, b), least(c, d))
}

/// The part of the edge inside four half-planes. `value` is the signed distance at the edge's middle, `change` its
/// change from start to end.
#[inline(always)]
fn hidden_by_quad(edge: &Edge, quad: &Quad, margin: f32) -> Hidden {
    let ([x, y], [dx, dy]) = (edge.seen_from(quad.origin), edge.step);
    let wx = f32x4::splat(x + 0.5 * dx);
    let wy = f32x4::splat(y + 0.5 * dy);
    let value = quad.normal_x * wx + quad.normal_y * wy - (quad.offset + quad.margin * f32x4::splat(margin));
    let change = quad.normal_x * f32x4::splat(dx) + quad.normal_y * f32x4::splat(dy);
    let half = change.abs() * f32x4::splat(0.5);
    let zero = f32x4::ZERO;
    if (value - half).simd_ge(zero).any() {
        return Hidden::Nothing;
    }
    if (value + half).simd_lt(zero).all() {
        return Hidden::Everything;
    }
    // Lanes that do not change divide by zero; neither mask takes them.
    let root = f32x4::splat(0.5) - value / change;
    let enters = change.simd_lt(zero).bitselect(root, zero);
    let leaves = change.simd_gt(zero).bitselect(root, f32x4::ONE);
    let [from, to] = [most(last_of(enters), 0.0), least(first_of(leaves), 1.0)];
    if to - from > SHORTEST_HIDDEN { Hidden::Between(from, to) } else { Hidden::Nothing }
}

#[inline(always)]
fn hidden_by_polygon(edge: &Edge, polygon: &Polygon, circles: &Circles, margin: f32) -> Hidden {
    let radius = polygon.radius + margin;
    if radius <= 0.0 || polygon.sides == 0 {
        return Hidden::Nothing;
    }
    let ([wx, wy], [dx, dy]) = (edge.seen_from(polygon.center), edge.step);
    let (ex, ey) = (wx + dx, wy + dy);
    let inner = radius * radius;
    if wx * wx + wy * wy < inner && ex * ex + ey * ey < inner {
        return Hidden::Everything;
    }
    // Nearest point of the edge against the circumscribed circle.
    let length_squared = dx * dx + dy * dy;
    let t = (-(wx * dx + wy * dy)).clamp(0.0, length_squared);
    let (px, py) = (wx * length_squared + t * dx, wy * length_squared + t * dy);
    let outer = radius * polygon.stretch * length_squared;
    if px * px + py * py > outer * outer {
        return Hidden::Nothing;
    }
    let (wx, wy, dx, dy) = (f32x4::splat(wx), f32x4::splat(wy), f32x4::splat(dx), f32x4::splat(dy));
    let (zero, radius) = (f32x4::ZERO, f32x4::splat(radius));
    let (mut enters, mut leaves) = (zero, f32x4::ONE);
    for [nx, ny] in circles.lanes(polygon.sides) {
        let value = *nx * wx + *ny * wy - radius;
        let change = *nx * dx + *ny * dy;
        let still = change.abs().simd_lt(f32x4::splat(1e-20));
        let root = -value / still.bitselect(f32x4::splat(1e-20), change);
        let rising = !change.simd_lt(zero);
        enters = enters.fast_max(rising.bitselect(enters, root));
        leaves = leaves.fast_min(rising.bitselect(root, leaves));
    }
    let [from, to] = [last_of(enters), first_of(leaves)];
    if from <= 0.0 && to >= 1.0 {
        Hidden::Everything
    } else if to - from > SHORTEST_HIDDEN {
        Hidden::Between(from, to)
    } else {
        Hidden::Nothing
    }
}
