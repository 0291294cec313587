//! Evening out: lines move to the middle of what lies nearest to them, as points do in Lloyd's method (1982).
//!
//! Every place of the surface belongs to the line nearest to it, and a line moves, across its own way only, towards the
//! mean of its places. Places of different lines do not mix, so lines keep apart and reach into gaps.
//!
//! The mean square distance alone would be least for a line that wriggles without end: lines also pull straight, as much
//! as makes parallels at the wanted spacing the best. With distances d and length L the energy is ∫ d² + λ L; parallels
//! at spacing s have s²/12 + λ/s for a unit of area, least where λ = s³/6.

use super::refined::RefinedMesh;
use super::stitch::{NODES_A_SPACING, resampled};
use super::strand::{Grid, Node, SAME_SIDE, Strand, Strands, foot};
use crate::parallel;
use glam::DVec3;

/// Samples of the surface for every square spacing.
const SAMPLES_A_SQUARE: f64 = 24.0;
/// How far a sample looks for a line, in spacings: nearly always far enough, and at most.
const REACH: [f64; 2] = [0.7, 2.5];
/// Longest step of a round, in spacings.
const LONGEST_STEP: f64 = 1.0 / 8.0;
/// Against the tension at which the wanted spacing costs least, so that lines run calmly.
const TENSION: f64 = 1.3;
/// Times that pulls are smoothed along the line: few samples make a node's mean uncertain.
const SMOOTHINGS: usize = 4;
/// Rounds in which the moves of a line's nodes are solved for; each leaves about three quarters of the error.
const SOLVING: usize = 12;

/// A place of the surface.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub point: DVec3,
    pub normal: DVec3,
    pub triangle: u32,
}

/// Places spread evenly by area, `a_square` for every square of `spacing`.
pub fn samples(surface: &RefinedMesh, spacing: f64, a_square: f64) -> Vec<Sample> {
    let (mut due, mut all) = (0.0, Vec::new());
    for triangle in 0..surface.triangles.len() as u32 {
        due += 0.5 * surface.area_normal(triangle).length() / (spacing * spacing) * a_square;
        let [a, b, c] = surface.corners(triangle);
        while all.len() as f64 + 0.5 < due {
            // The R2 sequence (Roberts 2018), folded into the triangle.
            let n = all.len() as f64;
            let (mut u, mut v) =
                ((0.5 + n * 0.754_877_666_246_692_8).fract(), (0.5 + n * 0.569_840_290_998_053_3).fract());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let at = [1.0 - u - v, u, v];
            let point = at[0] * a + at[1] * b + at[2] * c;
            all.push(Sample { point, normal: surface.normal_at(triangle, at), triangle });
        }
    }
    all
}

/// `rounds` of evening out. `progress` is told the share that is done and stops everything by returning false: then
/// there is no result.
pub fn relaxed(
    surface: &RefinedMesh,
    lines: &[Strand],
    spacing: f64,
    rounds: usize,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Option<Vec<Strand>> {
    let samples = samples(surface, spacing, SAMPLES_A_SQUARE);
    let mut lines: Vec<Strand> = lines.iter().map(|line| resampled(surface, line, spacing)).collect();
    for round in 0..rounds {
        if !progress(round as f64 / rounds as f64) {
            return None;
        }
        let mut strands = Strands::new(&lines);
        let moves = moves(&strands, &samples, spacing);
        let before = strands.nodes.clone();
        for (node, by) in strands.nodes.iter_mut().zip(&moves) {
            *node = Node::on(surface, node.point + *by, node.triangle);
        }
        undo_crossings(&mut strands, &before, spacing);
        let mut at = 0;
        for line in &mut lines {
            let moved = &strands.nodes[at..at + line.len()];
            at += line.len();
            *line = respaced(surface, moved, spacing / NODES_A_SPACING);
        }
    }
    Some(lines)
}

/// How far each node goes.
fn moves(strands: &Strands, samples: &[Sample], spacing: f64) -> Vec<DVec3> {
    let count = strands.nodes.len();
    let grid = strands.grid(spacing);
    let mut pulls = vec![(DVec3::ZERO, 0.0); count];
    for found in parallel::map(samples, 1024, |sample| pull(strands, &grid, sample, spacing)).into_iter().flatten() {
        let Pull { segment, t, by } = found;
        for (node, share) in [(segment, 1.0 - t), (strands.next[segment as usize], t)] {
            let sum = &mut pulls[node as usize];
            *sum = (sum.0 + share * by, sum.1 + share);
        }
    }
    for _ in 0..SMOOTHINGS {
        let blurred = |i: usize| {
            let (p, c, n) = (pulls[strands.previous[i] as usize], pulls[i], pulls[strands.next[i] as usize]);
            (0.25 * p.0 + 0.5 * c.0 + 0.25 * n.0, 0.25 * p.1 + 0.5 * c.1 + 0.25 * n.1)
        };
        pulls = (0..count).map(blurred).collect();
    }
    // A node stands for `step` of the line and so for `step * spacing` of the surface. The move u that makes the energy
    // least with what belongs to each node held: u + c (2 u - u₋ - u₊) = mean + c (x₋ + x₊ - 2 x), c = λ / (2 step² s).
    let c = TENSION * NODES_A_SPACING * NODES_A_SPACING / 12.0;
    let point = |j: u32| strands.nodes[j as usize].point;
    let wanted = |i: usize| {
        let bend = point(strands.previous[i]) + point(strands.next[i]) - 2.0 * strands.nodes[i].point;
        // As if twice sampled: a node that few samples belong to is unsure of their mean.
        let (sum, weight) = pulls[i];
        across(strands, i, sum / weight.max(0.5 * SAMPLES_A_SQUARE / NODES_A_SPACING) + c * bend)
    };
    let wanted: Vec<DVec3> = (0..count).map(wanted).collect();
    let mut moves = vec![DVec3::ZERO; count];
    for _ in 0..SOLVING {
        let solved = |i: usize| {
            let beside = moves[strands.previous[i] as usize] + moves[strands.next[i] as usize];
            (wanted[i] + c * beside) / (1.0 + 2.0 * c)
        };
        moves = (0..count).map(solved).collect();
    }
    (0..count).map(|i| across(strands, i, moves[i]).clamp_length_max(LONGEST_STEP * spacing)).collect()
}

/// The part of `by` that is not along the line.
fn across(strands: &Strands, i: usize, by: DVec3) -> DVec3 {
    let along = strands.tangent(i);
    by - along * along.dot(by)
}

/// A sample's pull at the nearest segment (named by its first node), `t` along it.
struct Pull {
    segment: u32,
    t: f64,
    by: DVec3,
}

fn pull(strands: &Strands, grid: &Grid, sample: &Sample, spacing: f64) -> Option<Pull> {
    let same_side = |i: u32| strands.nodes[i as usize].normal.dot(sample.normal) > SAME_SIDE;
    let nearest = REACH.iter().find_map(|reach| grid.nearest(sample.point, reach * spacing, same_side))?;
    let on = |segment: u32| {
        let (a, b) =
            (strands.nodes[segment as usize].point, strands.nodes[strands.next[segment as usize] as usize].point);
        let t = foot(sample.point, a, b);
        Pull { segment, t, by: sample.point - a.lerp(b, t) }
    };
    let (behind, ahead) = (on(strands.previous[nearest as usize]), on(nearest));
    Some(if behind.by.length_squared() < ahead.by.length_squared() { behind } else { ahead })
}

/// Takes back the moves of nodes round crossings, in growing stretches, and in the end all of them.
fn undo_crossings(strands: &mut Strands, before: &[Node], spacing: f64) {
    for steps in [1, 3, 6, 12] {
        let crossings = strands.crossings(spacing);
        if crossings.is_empty() {
            return;
        }
        for node in crossings.into_iter().flat_map(|(i, j)| [i, j]) {
            let (mut ahead, mut behind) = (node, node);
            for _ in 0..=steps {
                strands.nodes[ahead as usize] = before[ahead as usize];
                strands.nodes[behind as usize] = before[behind as usize];
                (ahead, behind) = (strands.next[ahead as usize], strands.previous[behind as usize]);
            }
        }
    }
    let left = strands.crossings(spacing).len();
    let moved = std::mem::replace(&mut strands.nodes, before.to_vec());
    if left > 0 && left <= strands.crossings(spacing).len() {
        strands.nodes = moved;
    }
}

/// Without nodes much nearer than `step` to each other and with new ones in the middle of long segments.
fn respaced(surface: &RefinedMesh, line: &[Node], step: f64) -> Strand {
    let mut nodes: Strand = Vec::with_capacity(line.len() + 8);
    let gap = |a: &Node, b: &Node| a.point.distance(b.point);
    let mut dispensable = line.len().saturating_sub(6);
    for (i, node) in line.iter().enumerate() {
        let next = &line[(i + 1) % line.len()];
        let behind = nodes.last().map_or(f64::INFINITY, |last| gap(last, node));
        let seam = i + 1 == line.len() && gap(node, next) < 0.6 * step;
        if dispensable > 0 && (behind < 0.6 * step || seam) {
            dispensable -= 1;
            continue;
        }
        if behind.is_finite() && behind > 1.5 * step {
            let last = nodes[nodes.len() - 1];
            nodes.push(Node::on(surface, last.point.midpoint(node.point), last.triangle));
        }
        nodes.push(*node);
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::super::strand::length;
    use super::super::testing::{circle, sheet};
    use super::*;
    use crate::mesh::Shape;

    #[test]
    fn samples_are_spread_by_area() {
        let surface = RefinedMesh::new(&Shape::Creature.mesh(), 0.1).unwrap();
        let all = samples(&surface, 0.05, 10.0);
        let wanted = surface.area() / 0.0025 * 10.0;
        assert!((all.len() as f64 - wanted).abs() <= 1.0);
        let upper = all.iter().filter(|sample| sample.point.y > 0.0).count() as f64 / all.len() as f64;
        let middle = |t: u32| surface.corners(t).iter().sum::<DVec3>().y > 0.0;
        let area = |t: u32| surface.area_normal(t).length() / 2.0 / surface.area();
        let share: f64 = (0..surface.triangles.len() as u32).filter(|&t| middle(t)).map(area).sum();
        assert!((upper - share).abs() < 0.01, "{upper} of the samples on {share} of the area");
    }

    #[test]
    fn a_ring_between_two_others_goes_to_the_middle() {
        let surface = RefinedMesh::new(&sheet(30), 0.03).unwrap();
        // Rings a spacing apart but for one of them.
        let wanted = |k: usize| 0.05 * k as f64 + 0.025;
        let ring = |k: usize| circle(&surface, [0.0, 0.0], wanted(k) + if k == 4 { 0.02 } else { 0.0 });
        let rings: Vec<Strand> = (0..9).map(ring).collect();
        let relaxed = relaxed(&surface, &rings, 0.05, 15, &mut |_| true).unwrap();
        let radius = |k: usize| length(&relaxed[k]) / std::f64::consts::TAU;
        for k in 3..6 {
            assert!((radius(k) - wanted(k)).abs() < 0.012, "{k}: {} not {}", radius(k), wanted(k));
        }
        assert!(relaxed_none(&surface, &rings));
    }

    fn relaxed_none(surface: &RefinedMesh, rings: &[Strand]) -> bool {
        relaxed(surface, rings, 0.05, 3, &mut |share| share < 0.5).is_none()
    }

    #[test]
    fn moves_that_cross_are_taken_back() {
        let surface = RefinedMesh::new(&sheet(30), 0.05).unwrap();
        let rings = [circle(&surface, [0.0, 0.0], 0.2), circle(&surface, [0.0, 0.0], 0.22)];
        let mut strands = Strands::new(&rings);
        let before = strands.nodes.clone();
        for node in &mut strands.nodes[40..60] {
            node.point *= 1.2;
        }
        strands.nodes[120].point *= 1.02;
        assert!(!strands.crossings(0.05).is_empty());
        undo_crossings(&mut strands, &before, 0.05);
        assert!(strands.crossings(0.05).is_empty());
        assert_ne!(strands.nodes[120], before[120], "what does not cross stays moved");
    }
}
