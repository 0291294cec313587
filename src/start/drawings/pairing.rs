//! Which step of a trail follows which: at every voxel the ends of its edges are paired, straightest first, and where
//! that leaves several trails they are joined where it bends them least.

use super::grid::Grid;
use crate::geometry::DisjointSets;
use crate::sorting::sort_by;
use std::collections::HashMap;

/// No vertex, edge or end.
const NONE: u32 = u32::MAX;
/// Cosine between two ends from which going from one to the other is a turn back.
const HAIRPIN: f64 = 0.7;

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
    pub fn new(grid: &Grid, steps: &[[u32; 2]]) -> Graph {
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
    pub fn longest_path(&self) -> Vec<bool> {
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
pub(super) struct Pairing {
    edges: Vec<[u32; 2]>,
    partner: Vec<u32>,
    direction: Vec<[f64; 3]>,
    /// Ends at each vertex.
    at: Vec<Vec<u32>>,
    /// Added to the bend of a turn back.
    hairpin: f64,
}

impl Pairing {
    /// Pairs the ends at each vertex, straightest first. `steps` are pairs of voxels that the graph has as edges; `hairpin`
    /// is what a turn back costs beside its bend.
    pub fn new(graph: &Graph, steps: &[[u32; 2]], hairpin: f64) -> Pairing {
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
        let mut pairing = Pairing { partner: vec![NONE; 2 * steps.len()], edges, direction, at, hairpin };
        let mut pairs = Vec::new();
        for ends in &pairing.at {
            pairs.clear();
            for (i, &a) in ends.iter().enumerate() {
                pairs.extend(ends[..i].iter().map(|&b| (pairing.bend(a, b), a, b)));
            }
            sort_by(&mut pairs, |x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
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
        let bend: f64 = (0..3).map(|c| a[c] * b[c]).sum();
        if bend > HAIRPIN { bend + self.hairpin } else { bend }
    }

    /// Joins closed trails to the others where that bends the trail least, until there is one.
    pub fn join_trails(&mut self, graph: &Graph) {
        let mut sets = DisjointSets::new(self.edges.len());
        for end in 0..self.partner.len() {
            if self.partner[end] != NONE {
                sets.join(end / 2, self.partner[end] as usize / 2);
            }
        }
        while sets.count() > 1 {
            let mut best: Option<(f64, u32, u32)> = None;
            for ends in self.at.iter().take(graph.voxels.len()).filter(|ends| ends.len() > 2) {
                for (i, &a) in ends.iter().enumerate() {
                    // Both orders, for (a b)(a' b') and (a b')(a' b) are two ways of joining.
                    for &b in &ends[..i] {
                        if sets.root(a as usize / 2) != sets.root(b as usize / 2) {
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
            sets.join(a as usize / 2, b as usize / 2);
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
    pub fn walk(&self) -> Vec<u32> {
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
