//! Closed lines joined into one: where two run side by side both are cut and the ends joined across the band between
//! them, which leaves two hairpins that face each other. Two different lines so joined are always one line.

use super::refined::RefinedMesh;
use super::strand::{Grid, Node, SAME_SIDE, Strand, Strands};
use crate::geometry::DisjointSets;
use crate::sorting::sort_by;

/// How far a place for a join reaches for the other line, in spacings, at first and when nothing else is left.
const REACH: [f64; 4] = [1.5, 1.5, 2.0, 3.0];
/// Joins keep this far apart, in spacings.
const CLEARANCE: [f64; 4] = [3.0, 1.5, 0.8, 0.0];
/// Nodes a spacing.
pub const NODES_A_SPACING: f64 = 4.0;

/// Joins the lines of every part of the surface by way of the calmest places. The lines are resampled, several nodes a
/// spacing. `progress` is told the share that is done and stops everything by returning false: then there is no result.
pub fn stitched(
    surface: &RefinedMesh,
    lines: &[Strand],
    spacing: f64,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Option<Vec<Strand>> {
    let lines: Vec<Strand> = lines.iter().map(|line| resampled(surface, line, spacing)).collect();
    let strands = Strands::new(&lines);
    let count = strands.nodes.len();
    let mut parts = vec![Vec::new(); surface.parts];
    for (i, node) in strands.nodes.iter().enumerate() {
        parts[surface.part(node.triangle) as usize].push(i as u32);
    }
    let mut work = Stitching { strands, parts, spacing, removed: vec![false; count], near_cut: vec![false; count] };
    let mut classes = DisjointSets::new(lines.len());
    let mut joins: Vec<Node> = Vec::new();
    for (round, (reach, clearance)) in REACH.into_iter().zip(CLEARANCE).enumerate() {
        if !progress(round as f64 / REACH.len() as f64) {
            return None;
        }
        for nodes in work.places(&mut classes, reach * spacing) {
            let [a, b] = nodes.map(|i| work.strands.strand_of[i as usize] as usize);
            let node = work.strands.nodes[nodes[0] as usize];
            let crowded = |join: &Node| {
                join.point.distance_squared(node.point) < (clearance * spacing).powi(2)
                    && join.normal.dot(node.normal) > SAME_SIDE
            };
            if classes.root(a) == classes.root(b) || joins.iter().any(crowded) {
                continue;
            }
            if work.splice(nodes) {
                classes.join(a, b);
                joins.push(node);
            }
        }
    }
    Some(work.strands.walked(&work.removed))
}

/// As [`super::strand::resampled`] at the step that joins and relaxation use.
pub fn resampled(surface: &RefinedMesh, line: &[Node], spacing: f64) -> Strand {
    super::strand::resampled(surface, line, spacing / NODES_A_SPACING)
}

/// Lines in the middle of being joined.
struct Stitching {
    strands: Strands,
    /// The nodes that lie on each part of the surface.
    parts: Vec<Vec<u32>>,
    spacing: f64,
    /// Nodes that no line holds any more.
    removed: Vec<bool>,
    /// Nodes that a join has changed.
    near_cut: Vec<bool>,
}

impl Stitching {
    /// Where nodes of different lines face each other, those most like two calm parallels first.
    fn places(&self, classes: &mut DisjointSets, reach: f64) -> Vec<[u32; 2]> {
        let strands = &self.strands;
        let class_of: Vec<usize> = strands.strand_of.iter().map(|&name| classes.root(name as usize)).collect();
        let bends: Vec<f64> = (0..strands.nodes.len()).map(|i| self.bend(i)).collect();
        let mut places: Vec<(f64, [u32; 2])> = Vec::new();
        let is_split = |part: &&Vec<u32>| part.iter().any(|&i| class_of[i as usize] != class_of[part[0] as usize]);
        // Part by part: many that lie in one place cost no more than apart.
        for part in self.parts.iter().filter(is_split) {
            let here: Vec<u32> = part.iter().copied().filter(|&i| !self.removed[i as usize]).collect();
            let grid = Grid::new(here.iter().map(|&i| strands.nodes[i as usize].point), reach);
            for i in here.iter().map(|&i| i as usize) {
                let (node, along) = (&strands.nodes[i], strands.tangent(i));
                for side in [-1.0, 1.0] {
                    let across = side * node.normal.cross(along);
                    let mut best = (f64::INFINITY, 0);
                    grid.near(node.point, reach, |k, squared| {
                        let j = here[k as usize];
                        let other = &strands.nodes[j as usize];
                        let faces = (other.point - node.point).dot(across) > 0.7 * squared.sqrt();
                        let same_side = other.normal.dot(node.normal) > SAME_SIDE;
                        if faces && same_side && (squared, j) < best {
                            best = (squared, j);
                        }
                    });
                    let j = best.1 as usize;
                    if best.0.is_finite() && class_of[i] < class_of[j] {
                        let apart = (best.0.sqrt() / self.spacing - 1.0).abs();
                        let turned = 1.0 - along.dot(strands.tangent(j)).abs();
                        let fold = 1.0 - node.normal.dot(strands.nodes[j].normal);
                        places.push((apart + 2.0 * turned + fold + bends[i] + bends[j], [i as u32, best.1]));
                    }
                }
            }
        }
        sort_by(&mut places, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        places.into_iter().map(|place| place.1).collect()
    }

    /// How much the line turns within a spacing to both sides of a node: 0 straight, 2 back.
    fn bend(&self, i: usize) -> f64 {
        if self.removed[i] {
            return 0.0;
        }
        let (mut ahead, mut behind) = (i, i);
        for _ in 0..NODES_A_SPACING as usize {
            ahead = self.strands.next[ahead] as usize;
            behind = self.strands.previous[behind] as usize;
        }
        1.0 - self.strands.tangent(ahead).dot(self.strands.tangent(behind))
    }

    /// Cuts half a spacing to both sides of two facing nodes and joins the ends; false if an earlier join is in the way.
    fn splice(&mut self, nodes: [u32; 2]) -> bool {
        let ([a0, a1], mut removed) = self.gap(nodes[0]);
        let ([b0, b1], more) = self.gap(nodes[1]);
        removed.extend(more);
        let touched = || removed.iter().copied().chain([a0, a1, b0, b1]).map(|i| i as usize);
        if touched().any(|i| self.near_cut[i]) {
            return false;
        }
        touched().for_each(|i| self.near_cut[i] = true);
        let point = |i: u32| self.strands.nodes[i as usize].point;
        let same_way = point(a0).distance(point(b0)) + point(a1).distance(point(b1));
        let other_way = point(a0).distance(point(b1)) + point(a1).distance(point(b0));
        let is_ahead = same_way < other_way;
        self.strands.join([a0, a1], if is_ahead { [b0, b1] } else { [b1, b0] }, is_ahead);
        for i in removed {
            self.removed[i as usize] = true;
        }
        true
    }

    /// The nodes half a spacing before and after `node`, and those between. A short line keeps two thirds of itself.
    fn gap(&self, node: u32) -> ([u32; 2], Vec<u32>) {
        let half = NODES_A_SPACING as usize / 2;
        let mut around = 1;
        let mut at = self.strands.next[node as usize];
        while at != node && around < 6 * half {
            (at, around) = (self.strands.next[at as usize], around + 1);
        }
        let (mut ends, mut between) = ([node; 2], vec![node]);
        for step in 0..half.min(around / 6).max(1) {
            if step > 0 {
                between.extend(ends);
            }
            ends = [self.strands.previous[ends[0] as usize], self.strands.next[ends[1] as usize]];
        }
        (ends, between)
    }
}

#[cfg(test)]
mod tests {
    use super::super::strand::length;
    use super::super::testing::{circle, sheet};
    use super::*;
    use crate::mesh::Mesh;

    #[test]
    fn rings_become_one_line_as_long_as_they_were() {
        let surface = RefinedMesh::new(&sheet(30), 0.025).unwrap();
        let rings: Vec<Strand> = (1..9).map(|k| circle(&surface, [0.0, 0.0], 0.05 * f64::from(k) + 0.01)).collect();
        let line = stitched(&surface, &rings, 0.05, &mut |_| true).unwrap();
        assert_eq!(line.len(), 1);
        let before: f64 = rings.iter().map(|ring| length(ring)).sum();
        assert!((length(&line[0]) / before - 1.0).abs() < 0.03, "{} from {before}", length(&line[0]));
        assert!(Strands::new(&line).crossings(0.05).is_empty());
        let far = [circle(&surface, [-0.3, 0.0], 0.1), circle(&surface, [0.3, 0.0], 0.1)];
        let far = stitched(&surface, &far, 0.05, &mut |_| true).unwrap();
        assert_eq!(far.len(), 2, "what is far apart stays apart");
    }

    #[test]
    fn parts_that_lie_in_one_place_are_each_joined_and_only_to_themselves() {
        // Sheets on top of each other, two rings on each.
        let sheets = 2000;
        let one = sheet(2);
        let count = one.positions().len() as u32;
        let positions = (0..sheets).flat_map(|_| one.positions().to_vec()).collect();
        let triangles = (0..sheets).flat_map(|k| one.triangles().iter().map(move |t| t.map(|v| v + k * count)));
        let mesh = Mesh::new("sheets", positions, triangles.collect()).unwrap();
        let surface = RefinedMesh::new(&mesh, 1.0).unwrap();
        let each = surface.triangles.len() as u32 / sheets;
        let own = RefinedMesh::new(&one, 1.0).unwrap();
        let rings = [0.2, 0.35].map(|radius| resampled(&own, &circle(&own, [0.0, 0.0], radius), 0.2));
        let on = |k: u32| move |node: &Node| Node { triangle: node.triangle + k * each, ..*node };
        let rings = (0..sheets).flat_map(|k| rings.iter().map(move |ring| ring.iter().map(on(k)).collect()));
        let rings: Vec<Strand> = rings.collect();
        let lines = stitched(&surface, &rings, 0.15, &mut |_| true).unwrap();
        assert_eq!(lines.len(), sheets as usize);
        assert_eq!(stitched(&surface, &rings, 0.15, &mut |share| share < 0.5), None);
    }
}
