//! From strokes to nodes and straight pieces: the first stage of the exact rasteriser.

use super::extremes::{least, most};
use super::usable;
use crate::wire::Stroke;

/// No such node, piece or polygon.
pub(super) const NONE: u32 = u32::MAX;

/// One drawn vertex. Piece `k` runs from node `k` to node `next`, if there is one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub center: [f32; 2],
    pub radius: f32,
    /// Index of the vertex it came from.
    pub vertex: u32,
    pub previous: u32,
    pub next: u32,
}

/// The straight stretch between two nodes: its axis and how it tapers.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Piece {
    /// Unit direction of the axis; zero where there is no piece.
    pub axis: [f32; 2],
    pub length: f32,
    /// Sine and cosine of the angle between a side and the axis: `sine = (r_end - r_start) / length`.
    pub sine: f32,
    pub cosine: f32,
    /// False where there is no piece, or one disc all but contains the other: such a piece has no sides.
    pub has_sides: bool,
}

/// A piece whose smaller disc sticks out of its larger by less than this (in pixels) is two discs.
pub(super) const LEAST_OUTCROP_PX: f32 = 0.01;
/// Two nodes nearer than this (in pixels) coincide.
pub(super) const SHORTEST_PX: f32 = 1e-5;

impl Piece {
    fn new(a: &Node, b: &Node) -> Self {
        let [dx, dy] = [b.center[0] - a.center[0], b.center[1] - a.center[1]];
        let length = (dx * dx + dy * dy).sqrt();
        let rise = b.radius - a.radius;
        let outcrop = length - rise.abs();
        if length < SHORTEST_PX || outcrop < least(LEAST_OUTCROP_PX, 0.02 * length) {
            return Piece { length, ..Piece::default() };
        }
        let sine = rise / length;
        // 1 - sine^2, without the loss of digits.
        let cosine = (outcrop / length * (1.0 + sine.abs())).sqrt();
        Piece { axis: [dx / length, dy / length], length, sine, cosine, has_sides: true }
    }

    /// Outward unit normal of the side at `side` = +1 (to the axis turned a quarter from x to y) or -1. The side is
    /// the line `normal . (p - a) = r_a`, tangent to both discs.
    #[inline(always)]
    pub fn normal(&self, side: f32) -> [f32; 2] {
        let ([ux, uy], across) = (self.axis, side * self.cosine);
        [-across * uy - self.sine * ux, across * ux - self.sine * uy]
    }
}

/// Fills `nodes` and `pieces` (one a node) from the strokes. Vertices that cannot be drawn break their stroke.
pub(super) fn build(vertices: &[[f32; 3]], strokes: &[Stroke], nodes: &mut Vec<Node>, pieces: &mut Vec<Piece>) {
    nodes.clear();
    for stroke in strokes {
        let end = stroke.start.saturating_add(stroke.count).min(vertices.len());
        let first = nodes.len();
        let mut unbroken = true;
        let mut joined = false;
        for vertex in stroke.start..end {
            let [x, y, radius] = vertices[vertex];
            if !usable(vertices[vertex]) {
                (joined, unbroken) = (false, false);
                continue;
            }
            let index = nodes.len() as u32;
            let previous = if joined { index - 1 } else { NONE };
            if joined {
                nodes[index as usize - 1].next = index;
            }
            let radius = most(radius, 0.0);
            nodes.push(Node { center: [x, y], radius, vertex: vertex as u32, previous, next: NONE });
            joined = true;
        }
        let last = nodes.len().wrapping_sub(1);
        if stroke.closed && unbroken && nodes.len() > first + 1 {
            nodes[last].next = first as u32;
            nodes[first].previous = last as u32;
        } else if stroke.closed && nodes.len() > first + 1 {
            // Broken elsewhere, but the last vertex may still join the first.
            let ends_drawn = nodes[last].vertex as usize + 1 == end && nodes[first].vertex as usize == stroke.start;
            if ends_drawn {
                nodes[last].next = first as u32;
                nodes[first].previous = last as u32;
            }
        }
    }
    pieces.clear();
    pieces.extend(nodes.iter().map(|node| match node.next {
        NONE => Piece::default(),
        next => Piece::new(node, &nodes[next as usize]),
    }));
}
