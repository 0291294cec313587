//! How two pieces meet at a node, decided for both sides at once.

use super::extremes::least;
use super::pieces::{NONE, Node, Piece};

/// How the sides of the two pieces at a node end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Kind {
    /// Both sides meet in the intersection of the neighbouring tangents; the pieces share their end line, which is
    /// never drawn.
    Mitred,
    /// The inner side is too tight to be trimmed: only the outer sides meet, and each piece draws its end line.
    Soft,
    /// The sides end at the tangent points and a whole polygon round the node closes the gap (also: ends, turns of
    /// more than 30 degrees, pieces without sides).
    #[default]
    Hard,
}

/// Index 0 is the side with the axis turned from x to y, index 1 the other. Points are relative to the node, where f32
/// has digits to spare.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Joint {
    pub kind: Kind,
    /// Where the sides of the piece before end.
    pub before: [[f32; 2]; 2],
    /// Where the sides of the piece after begin.
    pub after: [[f32; 2]; 2],
    /// How far each side reaches past its tangent point (in pixels; negative where it stops short).
    pub extension: [f32; 2],
    /// Whether the two pieces meet in one point on this side.
    pub shared: [bool; 2],
}

/// Sine of the sharpest turn of a side that is still mitred.
pub(super) const SHARPEST_MITRE: f32 = 0.5;
/// A side may lose this share of its length to a mitre at either end.
pub(super) const TRIM_SHARE: f32 = 0.45;

pub(super) fn build(nodes: &[Node], pieces: &[Piece], joints: &mut Vec<Joint>) {
    joints.clear();
    joints.extend(nodes.iter().enumerate().map(|(k, node)| {
        let after = &pieces[k];
        match node.previous {
            NONE => hard(node, &Piece::default(), after),
            previous => joint(node, &pieces[previous as usize], after),
        }
    }));
}

const SIDES: [f32; 2] = [1.0, -1.0];

fn tangent_point(node: &Node, piece: &Piece, side: f32) -> [f32; 2] {
    let [nx, ny] = piece.normal(side);
    [node.radius * nx, node.radius * ny]
}

fn hard(node: &Node, before: &Piece, after: &Piece) -> Joint {
    Joint {
        kind: Kind::Hard,
        before: SIDES.map(|side| tangent_point(node, before, side)),
        after: SIDES.map(|side| tangent_point(node, after, side)),
        ..Joint::default()
    }
}

fn joint(node: &Node, before: &Piece, after: &Piece) -> Joint {
    if !before.has_sides || !after.has_sides {
        return hard(node, before, after);
    }
    let tightest = TRIM_SHARE * least(before.length, after.length) * least(before.cosine, after.cosine);
    let mut joint = Joint { kind: Kind::Mitred, shared: [true; 2], ..Joint::default() };
    for (i, side) in SIDES.into_iter().enumerate() {
        let (a, b) = (before.normal(side), after.normal(side));
        let along = a[0] * b[0] + a[1] * b[1];
        let turn = a[0] * b[1] - a[1] * b[0];
        if along <= 0.0 || turn.abs() >= SHARPEST_MITRE {
            return hard(node, before, after);
        }
        let reach = node.radius / (1.0 + along);
        let extension = reach * turn.abs();
        let outer = turn * side < 0.0;
        if !outer && extension >= tightest {
            joint.kind = Kind::Soft;
            joint.shared[i] = false;
            joint.before[i] = tangent_point(node, before, side);
            joint.after[i] = tangent_point(node, after, side);
        } else {
            let meet = [reach * (a[0] + b[0]), reach * (a[1] + b[1])];
            joint.before[i] = meet;
            joint.after[i] = meet;
            joint.extension[i] = if outer { extension } else { -extension };
        }
    }
    joint
}
