//! Closed lines on a surface, as nodes with the triangle each lies on, and the grid that finds nodes near a place.

use super::refined::RefinedMesh;
use glam::DVec3;

/// Normals further apart than this (cosine) belong to different sides of the surface: round an edge a line is still
/// seen, through a wall it is not.
pub const SAME_SIDE: f64 = -0.25;

/// A point of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    pub point: DVec3,
    pub normal: DVec3,
    pub triangle: u32,
}

impl Node {
    /// The nearest place of the surface to `point`, walked to from `triangle`.
    pub fn on(surface: &RefinedMesh, point: DVec3, triangle: u32) -> Node {
        let (triangle, at, point) = surface.nearest_from(point, triangle);
        Node { point, normal: surface.normal_at(triangle, at), triangle }
    }
}

/// A closed line.
pub type Strand = Vec<Node>;

pub fn length(strand: &[Node]) -> f64 {
    (0..strand.len()).map(|i| strand[i].point.distance(strand[(i + 1) % strand.len()].point)).sum()
}

/// Nodes at even steps of about `step` along the closed line, at least six.
pub fn resampled(surface: &RefinedMesh, strand: &[Node], step: f64) -> Strand {
    let whole = length(strand);
    let count = ((whole / step).round() as usize).max(6);
    let mut nodes = Vec::with_capacity(count);
    let (mut piece, mut behind) = (0, 0.0);
    for k in 0..count {
        let at = whole * k as f64 / count as f64;
        loop {
            let (a, b) = (strand[piece], strand[(piece + 1) % strand.len()]);
            let span = a.point.distance(b.point);
            if behind + span >= at || piece + 1 == strand.len() {
                let t = if span > 0.0 { ((at - behind) / span).clamp(0.0, 1.0) } else { 0.0 };
                let hint = if t < 0.5 { a.triangle } else { b.triangle };
                nodes.push(Node::on(surface, a.point.lerp(b.point, t), hint));
                break;
            }
            behind += span;
            piece += 1;
        }
    }
    nodes
}

/// Which of some points are near a place.
#[derive(Debug, Clone)]
pub struct Grid {
    low: DVec3,
    cell: f64,
    size: [usize; 3],
    starts: Vec<u32>,
    items: Vec<(DVec3, u32)>,
}

/// Cells at most; beyond that they are larger than asked for.
const MOST_CELLS: f64 = 2e6;

impl Grid {
    /// Cells of `cell` or larger round `points`.
    pub fn new(points: impl Iterator<Item = DVec3> + Clone, cell: f64) -> Grid {
        let low = points.clone().fold(DVec3::splat(f64::INFINITY), DVec3::min);
        let high = points.clone().fold(DVec3::splat(f64::NEG_INFINITY), DVec3::max);
        let extent = (high - low).max(DVec3::ZERO);
        let mut cell = cell;
        let size = loop {
            let size = (extent / cell).floor() + DVec3::ONE;
            if size.element_product() <= MOST_CELLS || !extent.is_finite() {
                break size.to_array().map(|n| if n.is_finite() { n as usize } else { 1 });
            }
            cell *= 1.3;
        };
        let mut grid = Grid { low, cell, size, starts: vec![0; size.iter().product::<usize>() + 1], items: Vec::new() };
        let cells: Vec<usize> = points.clone().map(|point| grid.cell_of(point)).collect();
        for &cell in &cells {
            grid.starts[cell + 1] += 1;
        }
        for i in 1..grid.starts.len() {
            grid.starts[i] += grid.starts[i - 1];
        }
        let mut next = grid.starts.clone();
        grid.items = vec![(DVec3::ZERO, 0); cells.len()];
        for ((i, point), &cell) in points.enumerate().zip(&cells) {
            grid.items[next[cell] as usize] = (point, i as u32);
            next[cell] += 1;
        }
        grid
    }

    fn place(&self, point: DVec3) -> [usize; 3] {
        let at = ((point - self.low) / self.cell).to_array();
        std::array::from_fn(|c| (at[c].max(0.0) as usize).min(self.size[c] - 1))
    }

    fn cell_of(&self, point: DVec3) -> usize {
        let [x, y, z] = self.place(point);
        (z * self.size[1] + y) * self.size[0] + x
    }

    /// Calls `visit` with the index and squared distance of every point within `radius` of `place`.
    pub fn near(&self, place: DVec3, radius: f64, mut visit: impl FnMut(u32, f64)) {
        if self.items.is_empty() {
            return;
        }
        let (low, high) = (self.place(place - radius), self.place(place + radius));
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                let row = (z * self.size[1] + y) * self.size[0];
                let (from, to) = (self.starts[row + low[0]] as usize, self.starts[row + high[0] + 1] as usize);
                for &(point, index) in &self.items[from..to] {
                    let squared = point.distance_squared(place);
                    if squared <= radius * radius {
                        visit(index, squared);
                    }
                }
            }
        }
    }

    /// The nearest of the points within `radius` that `accept` takes.
    pub fn nearest(&self, place: DVec3, radius: f64, accept: impl Fn(u32) -> bool) -> Option<u32> {
        let mut best = (f64::INFINITY, u32::MAX);
        self.near(place, radius, |index, squared| {
            if (squared, index) < best && accept(index) {
                best = (squared, index);
            }
        });
        (best.1 != u32::MAX).then_some(best.1)
    }
}

/// The nodes of several closed lines one after the other, with who follows whom.
#[derive(Debug, Clone, Default)]
pub struct Strands {
    pub nodes: Vec<Node>,
    pub next: Vec<u32>,
    pub previous: Vec<u32>,
    pub strand_of: Vec<u32>,
}

impl Strands {
    pub fn new(strands: &[Strand]) -> Strands {
        let mut all = Strands::default();
        for (name, strand) in strands.iter().enumerate() {
            let (first, count) = (all.nodes.len() as u32, strand.len() as u32);
            all.nodes.extend_from_slice(strand);
            all.next.extend((0..count).map(|i| first + (i + 1) % count));
            all.previous.extend((0..count).map(|i| first + (i + count - 1) % count));
            all.strand_of.extend(std::iter::repeat_n(name as u32, strand.len()));
        }
        all
    }

    pub fn grid(&self, cell: f64) -> Grid {
        Grid::new(self.nodes.iter().map(|node| node.point), cell)
    }

    /// The unit direction of travel at a node.
    pub fn tangent(&self, i: usize) -> DVec3 {
        (self.nodes[self.next[i] as usize].point - self.nodes[self.previous[i] as usize].point).normalize_or_zero()
    }

    /// Joins two lines into one: from `a0` over to `first`, along the whole second line to `last` and on to `a1`. `a1`
    /// comes after `a0` and `first` and `last` beside each other, but for nodes between that no line holds any more.
    pub fn join(&mut self, [a0, a1]: [u32; 2], [first, last]: [u32; 2], is_ahead: bool) {
        if is_ahead {
            self.reverse(first);
        }
        self.next[a0 as usize] = first;
        self.previous[first as usize] = a0;
        self.next[last as usize] = a1;
        self.previous[a1 as usize] = last;
    }

    /// Turns the whole line through `start` round.
    fn reverse(&mut self, start: u32) {
        let mut at = start;
        loop {
            let i = at as usize;
            at = self.next[i];
            (self.next[i], self.previous[i]) = (self.previous[i], at);
            if at == start {
                return;
            }
        }
    }

    /// The lines there are now, without the nodes that are `removed`.
    pub fn walked(&self, removed: &[bool]) -> Vec<Strand> {
        let mut seen = removed.to_vec();
        let mut lines = Vec::new();
        for start in 0..seen.len() {
            let (mut line, mut at) = (Vec::new(), start);
            while !seen[at] {
                seen[at] = true;
                line.push(self.nodes[at]);
                at = self.next[at] as usize;
            }
            if !line.is_empty() {
                lines.push(line);
            }
        }
        lines
    }

    /// Segments (by their first node) that cross another on the same side of the surface.
    pub fn crossings(&self, spacing: f64) -> Vec<(u32, u32)> {
        let grid = self.grid(0.6 * spacing);
        let segment = |i: u32| (self.nodes[i as usize].point, self.nodes[self.next[i as usize] as usize].point);
        let mut found = Vec::new();
        for i in 0..self.nodes.len() as u32 {
            let (a, b) = segment(i);
            grid.near(a, 0.6 * spacing, |j, _| {
                let touch = self.next[i as usize] == j || self.next[j as usize] == i;
                let normal = self.nodes[i as usize].normal + self.nodes[j as usize].normal;
                let same_side = self.nodes[i as usize].normal.dot(self.nodes[j as usize].normal) > SAME_SIDE;
                if i < j && !touch && same_side {
                    let (c, d) = segment(j);
                    if cross([a, b], [c, d], normal.normalize_or(self.nodes[i as usize].normal), 0.4 * spacing) {
                        found.push((i, j));
                    }
                }
            });
        }
        found
    }
}

/// Whether two segments cross as seen along `normal`, no more than `apart` over each other.
pub fn cross([a, b]: [DVec3; 2], [c, d]: [DVec3; 2], normal: DVec3, apart: f64) -> bool {
    let side = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal);
    let (ca, cb) = (side(c, d, a), side(c, d, b));
    let (ac, ad) = (side(a, b, c), side(a, b, d));
    // Segments in one line meet in rounding only.
    let parallel = (ca - cb).abs() <= 1e-9 * a.distance(b) * c.distance(d);
    if parallel || ca * cb >= 0.0 || ac * ad >= 0.0 {
        return false;
    }
    let (on, other) = (a.lerp(b, ca / (ca - cb)), c.lerp(d, ac / (ac - ad)));
    on.distance(other) <= apart
}

/// Where between `a` and `b` the nearest point to `p` lies, 0 to 1.
pub fn foot(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let squared = a.distance_squared(b);
    if squared > 0.0 { ((p - a).dot(b - a) / squared).clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{anywhere, circle, sheet};
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn the_grid_finds_what_asking_everybody_finds() {
        let mut rng = Rng::new(8, 0);
        let points: Vec<DVec3> = (0..500).map(|_| DVec3::from(rng.in_ball(1.0))).collect();
        let grid = Grid::new(points.iter().copied(), 0.2);
        for _ in 0..100 {
            let (place, radius) = (DVec3::from(rng.in_ball(1.3)), rng.range(0.01, 0.5));
            let mut found = Vec::new();
            grid.near(place, radius, |i, squared| {
                assert_eq!(squared, points[i as usize].distance_squared(place));
                found.push(i);
            });
            found.sort_unstable();
            let wanted: Vec<u32> = (0..500).filter(|&i| points[i as usize].distance(place) <= radius).collect();
            assert_eq!(found, wanted);
            let nearest = wanted
                .iter()
                .copied()
                .filter(|i| i % 2 == 0)
                .min_by(|&a, &b| points[a as usize].distance(place).total_cmp(&points[b as usize].distance(place)));
            assert_eq!(grid.nearest(place, radius, |i| i % 2 == 0), nearest);
        }
    }

    #[test]
    fn crossings_are_seen_on_one_side_only() {
        let surface = RefinedMesh::new(&sheet(30), 0.05).unwrap();
        let rings = [circle(&surface, [-0.1, 0.0], 0.2), circle(&surface, [0.11, 0.0], 0.2)];
        let mut strands = Strands::new(&rings);
        assert_eq!(strands.crossings(0.05).len(), 2);
        for node in &mut strands.nodes[200..] {
            node.normal = -node.normal;
        }
        assert!(strands.crossings(0.05).is_empty(), "the other side of a wall");
        let apart = [circle(&surface, [-0.2, 0.0], 0.2), circle(&surface, [0.21, 0.0], 0.2)];
        assert!(Strands::new(&apart).crossings(0.05).is_empty());
        let in_line = [[0.0, 0.0], [0.2, 0.1], [0.4, 0.2]].map(|[x, y]| DVec3::new(x, y, 0.0));
        assert!(!cross([in_line[0], in_line[1]], [in_line[1], in_line[2]], DVec3::Z, 1.0));
    }

    #[test]
    fn resampling_keeps_length_and_evens_steps() {
        let surface = RefinedMesh::new(&sheet(30), 0.05).unwrap();
        let mut line = circle(&surface, [0.0, 0.0], 0.3);
        line.drain(20..60);
        let even = resampled(&surface, &line, 0.01);
        assert!((length(&even) - length(&line)).abs() < 0.01);
        for i in 0..even.len() {
            assert!((even[i].point.distance(even[(i + 1) % even.len()].point) - 0.01).abs() < 5e-4);
        }
    }

    #[test]
    fn joined_lines_are_walked_in_either_direction() {
        let surface = RefinedMesh::new(&sheet(10), 0.1).unwrap();
        for (beside, is_ahead) in [([201, 202], true), ([202, 201], false)] {
            let mut strands = Strands::new(&[circle(&surface, [-0.2, 0.0], 0.1), circle(&surface, [0.2, 0.0], 0.1)]);
            strands.join([10, 11], beside, is_ahead);
            let lines = strands.walked(&[false; 400]);
            assert_eq!((lines.len(), lines[0].len()), (1, 400));
            for i in 0..400usize {
                assert_eq!(strands.previous[strands.next[i] as usize] as usize, i);
            }
        }
        let node = anywhere(&surface, DVec3::new(0.1, 0.2, 0.3));
        assert!(node.point.distance(DVec3::new(0.1, 0.2, 0.0)) < 1e-12 && node.normal.dot(DVec3::Z).abs() > 0.999);
    }
}
