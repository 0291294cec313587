//! Straight pieces of wire in a tree of boxes: who touches whom, who is nearest.

use glam::DVec3;

/// A straight piece of a tube, with the group it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    start: DVec3,
    end: DVec3,
    radii: [f64; 2],
    /// Label of the part it belongs to.
    pub group: usize,
}

/// The nearest points of two centre lines.
#[derive(Debug, Clone, Copy)]
pub struct Nearest {
    /// Between them.
    pub distance: f64,
    /// Sum of the tubes' radii there.
    pub radii: f64,
}

impl Piece {
    /// From two points `[x, y, z, width]`.
    pub fn new(start: [f64; 4], end: [f64; 4], group: usize) -> Piece {
        let position = |p: [f64; 4]| DVec3::new(p[0], p[1], p[2]);
        Piece { start: position(start), end: position(end), radii: [start[3] / 2.0, end[3] / 2.0], group }
    }

    /// Nearest points of two segments (Ericson, Real-Time Collision Detection, 5.1.9).
    pub fn nearest(&self, other: &Piece) -> Nearest {
        let (u, v, w) = (self.end - self.start, other.end - other.start, self.start - other.start);
        let (a, e, f) = (u.length_squared(), v.length_squared(), v.dot(w));
        let ratio = |x: f64, y: f64| if y > 0.0 { (x / y).clamp(0.0, 1.0) } else { 0.0 };
        let (s, t) = if e <= 0.0 {
            (ratio(-u.dot(w), a), 0.0)
        } else {
            let (b, c) = (u.dot(v), u.dot(w));
            let s = ratio(b * f - c * e, a * e - b * b);
            let t = (b * s + f) / e;
            if t < 0.0 {
                (ratio(-c, a), 0.0)
            } else if t > 1.0 {
                (ratio(b - c, a), 1.0)
            } else {
                (s, t)
            }
        };
        let radius = |piece: &Piece, s: f64| piece.radii[0] + (piece.radii[1] - piece.radii[0]) * s;
        Nearest { distance: (w + u * s - v * t).length(), radii: radius(self, s) + radius(other, t) }
    }

    fn bounds(&self) -> Bounds {
        Bounds { low: self.start.min(self.end), high: self.start.max(self.end) }
    }

    fn radius(&self) -> f64 {
        self.radii[0].max(self.radii[1])
    }
}

#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    fn union(self, other: Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn distance(&self, other: &Bounds) -> f64 {
        (self.low - other.high).max(other.low - self.high).max(DVec3::ZERO).length()
    }
}

/// A box round some pieces.
#[derive(Debug, Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// Largest radius inside.
    radius: f64,
    /// The group of all inside, if they share one.
    group: Option<usize>,
    first: u32,
    count: u32,
    /// Index of the second child (the first follows its parent); 0 for leaves.
    second: u32,
}

const LEAF_PIECES: usize = 4;

/// A bounding volume hierarchy over the centre lines of pieces.
#[derive(Debug)]
pub struct PieceTree {
    pieces: Vec<Piece>,
    nodes: Vec<Node>,
}

impl PieceTree {
    /// Over at least one piece.
    pub fn new(pieces: Vec<Piece>) -> PieceTree {
        let mut tree = PieceTree { nodes: Vec::with_capacity(pieces.len()), pieces };
        tree.build(0, tree.pieces.len());
        tree.relabel(|group| group);
        tree
    }

    /// The pieces, in the tree's own order.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Depth is the logarithm of the count: every box is halved at the median of its longest side.
    fn build(&mut self, first: usize, count: usize) {
        let pieces = &mut self.pieces[first..first + count];
        let bounds = pieces.iter().map(Piece::bounds).reduce(Bounds::union);
        let bounds = bounds.unwrap_or(Bounds { low: DVec3::ZERO, high: DVec3::ZERO });
        let radius = pieces.iter().map(Piece::radius).fold(0.0, f64::max);
        let index = self.nodes.len();
        let node = Node { bounds, radius, group: None, first: first as u32, count: count as u32, second: 0 };
        self.nodes.push(node);
        if count <= LEAF_PIECES {
            return;
        }
        let size = bounds.high - bounds.low;
        let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
        let middle = |piece: &Piece| piece.start[axis] + piece.end[axis];
        pieces.select_nth_unstable_by(count / 2, |a, b| middle(a).total_cmp(&middle(b)));
        self.build(first, count / 2);
        self.nodes[index].second = self.nodes.len() as u32;
        self.build(first + count / 2, count - count / 2);
    }

    /// Gives every piece the group `label` says, and tells the boxes.
    pub fn relabel(&mut self, mut label: impl FnMut(usize) -> usize) {
        for piece in &mut self.pieces {
            piece.group = label(piece.group);
        }
        // Children come after their parents.
        for i in (0..self.nodes.len()).rev() {
            let node = self.nodes[i];
            self.nodes[i].group = if node.second == 0 {
                let mut groups = self.pieces[node.first as usize..][..node.count as usize].iter().map(|p| p.group);
                let first = groups.next();
                first.filter(|&first| groups.all(|group| group == first))
            } else {
                let (left, right) = (self.nodes[i + 1].group, self.nodes[node.second as usize].group);
                left.filter(|_| left == right)
            };
        }
    }

    /// Calls `found` with the group of every piece of another group whose tube touches `piece`'s.
    pub fn for_each_touching(&self, piece: &Piece, mut found: impl FnMut(usize)) {
        let bounds = piece.bounds();
        let mut stack = vec![0usize];
        while let Some(i) = stack.pop() {
            let node = &self.nodes[i];
            if node.group == Some(piece.group) || node.bounds.distance(&bounds) > node.radius + piece.radius() {
                continue;
            }
            if node.second != 0 {
                stack.extend([node.second as usize, i + 1]);
                continue;
            }
            for other in &self.pieces[node.first as usize..][..node.count as usize] {
                if other.group != piece.group {
                    let near = piece.nearest(other);
                    if near.distance <= near.radii {
                        found(other.group);
                    }
                }
            }
        }
    }

    /// Distance and group of the nearest piece of another group, if nearer than `limit`.
    pub fn nearest_of_another_group(&self, piece: &Piece, limit: f64) -> Option<(f64, usize)> {
        let bounds = piece.bounds();
        let mut best = (limit, None);
        let mut stack = vec![(self.nodes[0].bounds.distance(&bounds), 0usize)];
        while let Some((distance, i)) = stack.pop() {
            let node = &self.nodes[i];
            if distance >= best.0 || node.group == Some(piece.group) {
                continue;
            }
            if node.second != 0 {
                let [first, second] =
                    [i + 1, node.second as usize].map(|child| (self.nodes[child].bounds.distance(&bounds), child));
                // The nearer one is looked at first.
                stack.extend(if first.0 < second.0 { [second, first] } else { [first, second] });
                continue;
            }
            for other in &self.pieces[node.first as usize..][..node.count as usize] {
                if other.group != piece.group {
                    let near = piece.nearest(other).distance;
                    if near < best.0 {
                        best = (near, Some(other.group));
                    }
                }
            }
        }
        best.1.map(|group| (best.0, group))
    }
}
