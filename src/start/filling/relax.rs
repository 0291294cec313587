//! Evening out: lines move to the middle of what lies nearest to them, as points do in Lloyd's method (1982).
//!
//! Every place of the surface belongs to the line nearest to it, and a line moves, across its own way only, to the mean
//! of its places. Places of different lines do not mix, so lines keep apart and reach into gaps.

use super::stitch::{NODES_A_SPACING, resampled};
use super::strand::{Grid, Node, SAME_SIDE, Strand, Strands, foot};
use super::surface::Surface;
use glam::DVec3;

/// Samples of the surface for every square spacing.
const SAMPLES_A_SQUARE: f64 = 24.0;
/// How far a sample looks for a line, in spacings: nearly always far enough, and at most.
const REACH: [f64; 2] = [0.7, 2.5];
/// Of the way to the mean a line goes in one round (more than all: rounds are few).
const EAGERNESS: f64 = 1.3;
/// Longest step of a round, in spacings.
const LONGEST_STEP: f64 = 1.0 / 8.0;
/// Times that what lies nearest is smoothed along the line.
const SMOOTHINGS: usize = 4;
/// Of the bend of a line, straightened in one round.
const STRAIGHTENING: f64 = 0.1;

/// A place of the surface.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub point: DVec3,
    pub normal: DVec3,
    pub triangle: u32,
}

/// Places spread evenly by area, `a_square` for every square of `spacing`.
pub fn samples(surface: &Surface, spacing: f64, a_square: f64) -> Vec<Sample> {
    let (mut due, mut all) = (0.0, Vec::new());
    for triangle in 0..surface.triangles.len() as u32 {
        due += 0.5 * surface.area_normal(triangle).length() / (spacing * spacing) * a_square;
        let [a, b, c] = surface.corners(triangle);
        while all.len() as f64 + 0.5 < due {
            // The R2 sequence (Roberts 2018), folded into the triangle.
            let n = all.len() as f64;
            let (mut u, mut v) = ((0.5 + n * 0.754_877_666_246_692_8).fract(), (0.5 + n * 0.569_840_290_998_053_3).fract());
            if u + v > 1.0 {
                (u, v) = (1.0 - u, 1.0 - v);
            }
            let at = [1.0 - u - v, u, v];
            all.push(Sample {
                point: at[0] * a + at[1] * b + at[2] * c,
                normal: surface.normal_at(triangle, at),
                triangle,
            });
        }
    }
    all
}

/// `rounds` of evening out. `progress` is told the share that is done and stops everything by returning false: then
/// there is no result.
pub fn relaxed(
    surface: &Surface,
    lines: Vec<Strand>,
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
    for found in for_all(samples, |sample| pull(strands, &grid, sample, spacing)).into_iter().flatten() {
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
    let step = |i: usize| {
        let point = |j: u32| strands.nodes[j as usize].point;
        let bend = 0.5 * (point(strands.previous[i]) + point(strands.next[i])) - strands.nodes[i].point;
        let (sum, weight) = pulls[i];
        let centre = if weight > 0.0 { sum / weight } else { DVec3::ZERO };
        let along = strands.tangent(i);
        let by = EAGERNESS * centre + STRAIGHTENING * bend;
        (by - along * along.dot(by)).clamp_length_max(LONGEST_STEP * spacing)
    };
    (0..count).map(step).collect()
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
        let (a, b) = (strands.nodes[segment as usize].point, strands.nodes[strands.next[segment as usize] as usize].point);
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
fn respaced(surface: &Surface, line: &[Node], step: f64) -> Strand {
    let mut nodes: Strand = Vec::with_capacity(line.len() + 8);
    for (i, node) in line.iter().enumerate() {
        if let Some(last) = nodes.last() {
            let gap = last.point.distance(node.point);
            if gap < 0.6 * step && line.len() - i + nodes.len() > 6 {
                continue;
            }
            if gap > 1.5 * step {
                let middle = Node::on(surface, last.point.midpoint(node.point), last.triangle);
                nodes.push(middle);
            }
        }
        nodes.push(*node);
    }
    nodes
}

#[cfg(feature = "threads")]
fn for_all<T: Send>(samples: &[Sample], of: impl Fn(&Sample) -> T + Sync + Send) -> Vec<T> {
    use rayon::prelude::*;
    samples.par_iter().with_min_len(1024).map(of).collect()
}

#[cfg(not(feature = "threads"))]
fn for_all<T>(samples: &[Sample], of: impl Fn(&Sample) -> T) -> Vec<T> {
    samples.iter().map(of).collect()
}
