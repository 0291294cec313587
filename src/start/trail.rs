//! From the tree to one trail: every branch is walked there and back (which costs no visible ink and fills strokes with
//! two strands), except one path from end to end; at forks the trail goes on as straight as it can. A shorter trail
//! takes shortcuts instead of walking back.

use super::Path;
use super::grid::{Grid, OFF_PICTURE};
use super::shortcuts::take_shortcuts;
use super::tree::Tree;
use std::collections::{HashMap, HashSet};

/// How the tree becomes a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrailOptions {
    /// Standard deviation of the smoothing along the path, steps of the reference grid of 64 voxels. Enough for the
    /// grid's stairs; more (such as 1.5) pulls small curls flat and costs .01 soft IoU after the fit.
    pub smoothing_steps: f64,
    /// Width where the path shows ink only, px of a 128 px picture.
    pub width_px_at_128: f64,
    /// Width where some view shows blank paper, px of a 128 px picture.
    pub stray_width_px_at_128: f64,
    /// Whether to take shortcuts through ink instead of walking branches there and back: the wire gets shorter, but
    /// fewer strokes have two strands to fill them.
    pub shorter: bool,
}

impl Default for TrailOptions {
    fn default() -> Self {
        TrailOptions { smoothing_steps: 0.6, width_px_at_128: 2.0, stray_width_px_at_128: 0.6, shorter: false }
    }
}

/// The smoothed path along the tree's trail.
pub fn path_along(grid: &Grid, tree: &Tree, options: &TrailOptions) -> Path {
    let voxels = voxel_trail(grid, tree, options.shorter);
    let across = grid.plane_size.iter().map(|size| size[1]).max().unwrap_or(64) as f64;
    // World units a pixel of a 128 px picture.
    let pixel_world = grid.spacing_world * across / 128.0;
    let on_ink = |voxel: u32| {
        tree.planes.iter().zip(&grid.pixel).all(|(plane, pixel)| {
            let p = pixel[voxel as usize];
            p == OFF_PICTURE || plane.stray_px[p as usize] <= 0.9 * across as f32 / 64.0
        })
    };
    let mut points: Vec<[f64; 4]> = voxels
        .iter()
        .map(|&voxel| {
            let [x, y, z] = grid.position(voxel as usize);
            let width_px = if on_ink(voxel) { options.width_px_at_128 } else { options.stray_width_px_at_128 };
            [x, y, z, width_px * pixel_world]
        })
        .collect();
    smooth(&mut points, options.smoothing_steps * across / 64.0);
    Path { points, closed: false }
}

/// Gaussian smoothing of position and width along the index; the window shrinks towards both ends, which stay.
pub fn smooth(points: &mut [[f64; 4]], sigma: f64) {
    if sigma <= 0.0 {
        return;
    }
    let source = points.to_vec();
    let reach = (3.0 * sigma).ceil() as usize;
    let weights: Vec<f64> = (0..=reach).map(|k| (-0.5 * (k as f64 / sigma).powi(2)).exp()).collect();
    for i in 0..points.len() {
        let window = reach.min(i).min(points.len() - 1 - i);
        let mut sum = [0.0; 4];
        let mut total = 0.0;
        for j in i - window..=i + window {
            let weight = weights[i.abs_diff(j)];
            total += weight;
            for c in 0..4 {
                sum[c] += weight * source[j][c];
            }
        }
        points[i] = sum.map(|s| s / total);
    }
}

/// The voxels in the order of the trail, with shortcuts if it should be `shorter`.
pub fn voxel_trail(grid: &Grid, tree: &Tree, shorter: bool) -> Vec<u32> {
    if tree.edges.is_empty() {
        return vec![tree.root; 2];
    }
    let graph = Graph::new(grid, &tree.edges);
    let mut twice: Vec<bool> = graph.longest_path().into_iter().map(|once| !once).collect();
    let shortcuts = if shorter { take_shortcuts(grid, tree, &graph, &mut twice) } else { Vec::new() };
    // Every step of the trail: the tree's, those walked twice, the shortcuts'.
    let again = tree.edges.iter().zip(&twice).filter(|(_, twice)| **twice).map(|(edge, _)| *edge);
    let steps: Vec<[u32; 2]> = tree.edges.iter().copied().chain(again).chain(shortcuts).collect();
    let mut known = HashSet::with_capacity(steps.len());
    let distinct: Vec<[u32; 2]> = steps.iter().copied().filter(|&[a, b]| known.insert([a.min(b), a.max(b)])).collect();
    let graph = Graph::new(grid, &distinct);
    let mut pairing = Pairing::new(&graph, &steps);
    pairing.join_trails(&graph);
    pairing.walk().into_iter().map(|vertex| graph.voxels[vertex as usize]).collect()
}

/// No vertex, edge or end.
const NONE: u32 = u32::MAX;

/// Steps between voxels over dense vertex numbers.
pub(super) struct Graph {
    /// The voxel of each vertex.
    pub voxels: Vec<u32>,
    positions: Vec<[f64; 3]>,
    edges: Vec<[u32; 2]>,
    /// Edges at each vertex.
    pub incident: Vec<Vec<u32>>,
}

impl Graph {
    fn new(grid: &Grid, steps: &[[u32; 2]]) -> Graph {
        let mut vertex_of = vec![NONE; grid.voxels()];
        let mut voxels = Vec::with_capacity(steps.len() + 1);
        let mut vertex = |voxel: u32| {
            let slot = &mut vertex_of[voxel as usize];
            if *slot == NONE {
                *slot = voxels.len() as u32;
                voxels.push(voxel);
            }
            *slot
        };
        let edges: Vec<[u32; 2]> = steps.iter().map(|&[a, b]| [vertex(a), vertex(b)]).collect();
        let mut incident = vec![Vec::new(); voxels.len()];
        for (e, &[a, b]) in edges.iter().enumerate() {
            incident[a as usize].push(e as u32);
            incident[b as usize].push(e as u32);
        }
        let positions = voxels.iter().map(|&voxel| grid.position(voxel as usize)).collect();
        Graph { voxels, positions, edges, incident }
    }

    /// The edge's other vertex.
    pub fn across(&self, edge: u32, vertex: u32) -> u32 {
        let [a, b] = self.edges[edge as usize];
        if a == vertex { b } else { a }
    }

    /// Length of an edge, world units.
    pub fn length(&self, edge: u32) -> f64 {
        let [a, b] = self.edges[edge as usize].map(|v| self.positions[v as usize]);
        (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt()
    }

    /// Marks the edges of a tree's longest path, the one that need not be walked back.
    fn longest_path(&self) -> Vec<bool> {
        let (far, _) = self.farthest(0);
        let (mut end, back) = self.farthest(far);
        let mut marked = vec![false; self.edges.len()];
        while back[end as usize] != NONE {
            let edge = back[end as usize];
            marked[edge as usize] = true;
            end = self.across(edge, end);
        }
        marked
    }

    /// The vertex farthest from `from` along the tree, and each vertex's edge towards `from`.
    fn farthest(&self, from: u32) -> (u32, Vec<u32>) {
        let mut back = vec![NONE; self.voxels.len()];
        let mut stack = vec![(from, NONE, 0.0)];
        let mut best = (from, 0.0);
        while let Some((vertex, edge, distance)) = stack.pop() {
            back[vertex as usize] = edge;
            if distance > best.1 {
                best = (vertex, distance);
            }
            for &next in &self.incident[vertex as usize] {
                if next != edge {
                    stack.push((self.across(next, vertex), next, distance + self.length(next)));
                }
            }
        }
        (best.0, back)
    }

    /// Unit direction in which the tree leaves `vertex` by `edge`, seen a few steps ahead.
    fn direction(&self, mut edge: u32, vertex: u32) -> [f64; 3] {
        let mut at = vertex;
        for _ in 0..4 {
            at = self.across(edge, at);
            match self.incident[at as usize][..] {
                [a, b] => edge = if a == edge { b } else { a },
                _ => break,
            }
        }
        let (a, b) = (self.positions[vertex as usize], self.positions[at as usize]);
        let d: [f64; 3] = std::array::from_fn(|c| b[c] - a[c]);
        let length = d.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-12);
        d.map(|x| x / length)
    }
}

/// Which edge follows which at each vertex. An edge has two ends, 2 e and 2 e + 1, at its two vertices.
struct Pairing {
    edges: Vec<[u32; 2]>,
    partner: Vec<u32>,
    direction: Vec<[f64; 3]>,
    /// Ends at each vertex.
    at: Vec<Vec<u32>>,
}

impl Pairing {
    /// Pairs the ends at each vertex, straightest first. `steps` are pairs of voxels that the graph has as edges.
    fn new(graph: &Graph, steps: &[[u32; 2]]) -> Pairing {
        let edge_of: HashMap<[u32; 2], u32> = (0u32..)
            .zip(&graph.edges)
            .map(|(e, edge)| (edge.map(|vertex| graph.voxels[vertex as usize]), e))
            .flat_map(|([a, b], e)| [([a, b], e), ([b, a], e)])
            .collect();
        let mut at = vec![Vec::new(); graph.voxels.len()];
        let mut direction = Vec::with_capacity(2 * steps.len());
        let mut edges = Vec::with_capacity(steps.len());
        for (k, step) in steps.iter().enumerate() {
            let own = edge_of[step];
            let edge = graph.edges[own as usize];
            for side in 0..2 {
                at[edge[side] as usize].push((2 * k + side) as u32);
                direction.push(graph.direction(own, edge[side]));
            }
            edges.push(edge);
        }
        let mut pairing = Pairing { partner: vec![NONE; 2 * steps.len()], edges, direction, at };
        let mut pairs = Vec::new();
        for ends in &pairing.at {
            pairs.clear();
            for (i, &a) in ends.iter().enumerate() {
                pairs.extend(ends[..i].iter().map(|&b| (pairing.bend(a, b), a, b)));
            }
            pairs.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
            for &(_, a, b) in &pairs {
                if pairing.partner[a as usize] == NONE && pairing.partner[b as usize] == NONE {
                    pairing.partner[a as usize] = b;
                    pairing.partner[b as usize] = a;
                }
            }
        }
        pairing
    }

    /// How sharply the trail turns from end `a` to end `b` of one vertex: -1 straight on, 1 back again; 0 at the
    /// trail's own two ends.
    fn bend(&self, a: u32, b: u32) -> f64 {
        if a == NONE || b == NONE {
            return 0.0;
        }
        let (a, b) = (self.direction[a as usize], self.direction[b as usize]);
        (0..3).map(|c| a[c] * b[c]).sum()
    }

    /// Joins closed trails to the others where that bends the trail least, until there is one.
    fn join_trails(&mut self, graph: &Graph) {
        let mut sets = Sets((0..self.edges.len() as u32).collect());
        for end in 0..self.partner.len() {
            if self.partner[end] != NONE {
                sets.unite(end as u32 / 2, self.partner[end] / 2);
            }
        }
        let mut trails = (0..self.edges.len() as u32).filter(|&e| sets.find(e) == e).count();
        while trails > 1 {
            let mut best: Option<(f64, u32, u32)> = None;
            for ends in self.at.iter().take(graph.voxels.len()).filter(|ends| ends.len() > 2) {
                for (i, &a) in ends.iter().enumerate() {
                    // Both orders, for (a b)(a' b') and (a b')(a' b) are two ways of joining.
                    for &b in &ends[..i] {
                        if sets.find(a / 2) != sets.find(b / 2) {
                            let (pa, pb) = (self.partner[a as usize], self.partner[b as usize]);
                            let change = self.bend(a, b) + self.bend(pa, pb) - self.bend(a, pa) - self.bend(b, pb);
                            if best.is_none_or(|found| change < found.0) {
                                best = Some((change, a, b));
                            }
                        }
                    }
                }
            }
            let Some((_, a, b)) = best else { return };
            let (pa, pb) = (self.partner[a as usize], self.partner[b as usize]);
            self.pair(a, b);
            self.pair(pa, pb);
            sets.unite(a / 2, b / 2);
            trails -= 1;
        }
    }

    fn pair(&mut self, a: u32, b: u32) {
        if a != NONE {
            self.partner[a as usize] = b;
        }
        if b != NONE {
            self.partner[b as usize] = a;
        }
    }

    /// Walks the trail from one of its open ends (or, if closed, from anywhere).
    fn walk(&self) -> Vec<u32> {
        let start = self.partner.iter().position(|&p| p == NONE).unwrap_or(0) as u32;
        let vertex = |end: u32| self.edges[end as usize / 2][end as usize % 2];
        let mut trail = vec![vertex(start)];
        let mut end = start;
        for _ in 0..self.edges.len() {
            let far = end ^ 1;
            trail.push(vertex(far));
            end = self.partner[far as usize];
            if end == NONE || end == start {
                break;
            }
        }
        trail
    }
}

/// Union-find.
struct Sets(Vec<u32>);

impl Sets {
    fn find(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            self.0[i as usize] = self.0[self.0[i as usize] as usize];
            i = self.0[i as usize];
        }
        i
    }
    fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::testing::letters;
    use crate::start::{TreeOptions, grow_tree};

    fn walks_all(grid: &Grid, tree: &Tree, trail: &[u32]) -> Result<(), String> {
        let mut times: HashMap<[u32; 2], usize> = tree.edges.iter().map(|&[a, b]| ([a.min(b), a.max(b)], 0)).collect();
        let neighbours = grid.neighbours();
        for step in trail.windows(2) {
            let apart = step[1] as isize - step[0] as isize;
            if !neighbours.iter().any(|n| n.0 == apart) {
                return Err(format!("a jump from {} to {}", step[0], step[1]));
            }
            *times.get_mut(&[step[0].min(step[1]), step[0].max(step[1])]).ok_or("a step off the tree")? += 1;
        }
        match times.values().find(|&&count| !(1..=2).contains(&count)) {
            Some(count) => Err(format!("an edge walked {count} times")),
            None => Ok(()),
        }
    }

    #[test]
    fn trail_walks_every_edge_once_or_twice() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| true).unwrap();
        let trail = voxel_trail(&grid, &tree, false);
        walks_all(&grid, &tree, &trail).unwrap();
        assert!(trail.len() < 2 * tree.edges.len(), "one path is walked only once");
        let mut jumps = trail.clone();
        jumps.swap(3, trail.len() / 2);
        assert!(walks_all(&grid, &tree, &jumps).is_err() && walks_all(&grid, &tree, &trail[..9]).is_err());
        let path = path_along(&grid, &tree, &TrailOptions::default());
        assert_eq!(path.points.len(), trail.len());
        assert!(path.points.iter().flatten().all(|x| x.is_finite()));
    }

    #[test]
    fn shorter_trail_still_walks_every_edge() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| true).unwrap();
        let neighbours = grid.neighbours();
        let steps = |trail: &[u32]| -> Result<(f32, HashSet<[u32; 2]>), String> {
            let mut length = 0.0;
            for step in trail.windows(2) {
                let apart = step[1] as isize - step[0] as isize;
                length += neighbours.iter().find(|n| n.0 == apart).ok_or("a jump")?.1;
            }
            Ok((length, trail.windows(2).map(|step| [step[0].min(step[1]), step[0].max(step[1])]).collect()))
        };
        let all = |steps: &HashSet<[u32; 2]>| tree.edges.iter().all(|&[a, b]| steps.contains(&[a.min(b), a.max(b)]));
        let (doubled, short) = (voxel_trail(&grid, &tree, false), voxel_trail(&grid, &tree, true));
        let ((long_length, _), (short_length, walked)) = (steps(&doubled).unwrap(), steps(&short).unwrap());
        assert!(short_length < long_length, "{short_length} against {long_length}");
        assert!(all(&walked), "an edge of the tree is left out");
        // The checks can fail.
        assert!(!all(&steps(&short[..short.len() / 2]).unwrap().1));
        assert!(steps(&[short[0], short[short.len() / 2]]).is_err());
    }

    #[test]
    fn smoothing_keeps_ends_and_straight_lines() {
        let line: Vec<[f64; 4]> = (0..30).map(|i| [f64::from(i), 2.0 * f64::from(i), -f64::from(i), 0.1]).collect();
        let mut smoothed = line.clone();
        smooth(&mut smoothed, 2.5);
        for (a, b) in line.iter().zip(&smoothed) {
            assert!((0..4).all(|c| (a[c] - b[c]).abs() < 1e-12));
        }
        let mut zigzag = line.clone();
        zigzag.iter_mut().enumerate().for_each(|(i, p)| p[0] += if i % 2 == 0 { 1.0 } else { -1.0 });
        let rough = zigzag[15][0] - line[15][0];
        smooth(&mut zigzag, 2.5);
        assert!((zigzag[15][0] - line[15][0]).abs() < 0.01 * rough.abs());
    }
}
