//! How calm a wire is and whether a hand could bend it, from its curve alone.
//!
//! The curve is moved to its box's centre and scaled until its farthest point has distance 1. There a gauge of
//! [`GAUGE`] is a wire 1.5 mm thick in a sculpture 200 mm across. Directions are taken over one gauge, so that neither
//! tessellation nor a wave too small to see is a bend.

use crate::start::filling::Grid;
use crate::wire::Wire;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// The wire's thickness that bends and strands are measured by, in units of the farthest point's distance.
pub const GAUGE: f64 = 0.015;
/// Bends of a smaller radius are tight, in gauges.
pub const TIGHT_GAUGES: f64 = 1.5;
/// A turn by more than this within a gauge is a kink.
const KINK_RAD: f64 = std::f64::consts::FRAC_PI_3;
/// Strands farther apart along the wire than this may touch.
const OTHER_STRAND: f64 = 0.1;
/// Strands farther apart along the wire than this, and than so many of their diameters, may penetrate each other.
const OTHER_STRAND_NEAR: f64 = OTHER_STRAND / 8.0;
const OTHER_STRAND_DIAMETERS: f64 = 6.0;
/// Tubes that overlap by less than a tenth only touch.
const PENETRATING: f64 = 0.9;
/// No farther than this are wide strands looked for.
const FARTHEST: f64 = 0.2;
/// Between places that are measured, along the wire; and the most of them, for wires that would take minutes.
const STEP: f64 = 0.002;
const MOST_STEPS: usize = 500_000;
/// Samples from which these are interpolated, a control point.
const SAMPLES_PER_POINT: usize = 60;
/// Samples nearer to the last are the same point.
const SAME: f64 = 1e-9;
/// One in so many places looks for other strands.
const LOOK_EVERY: usize = 4;
/// Side of the cells in which they are looked for.
const CELL: f64 = 2.0 * GAUGE;

/// Figures of how a wire runs; all 0 for one that has no length. Units are the farthest point's distance from the
/// middle of the wire's box.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(default)]
pub struct Elegance {
    /// Mean curvature, radians a unit.
    pub turning_per_unit: f64,
    /// Places where the direction turns by more than 60 degrees within a gauge, at most one every two gauges.
    pub kinks: usize,
    /// Share of the length that is bent tighter than 1.5 gauges.
    pub tight_share: f64,
    /// Share of the length with another strand (more than 0.1 along the wire away) nearer than a gauge.
    pub touching_share: f64,
    /// Share of the length where another strand (more than six of its own diameters along the wire away) is nearer than
    /// 0.9 of the sum of both radii.
    pub penetrating_share: f64,
}

/// Where a wire fails, world units: a place for every stretch that does.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Faults {
    /// Where it has kinks.
    pub kinks: Vec<[f64; 3]>,
    /// The tightest place of every stretch that is bent too tightly; kinks are among them.
    pub tight: Vec<[f64; 3]>,
    /// The deepest place of every stretch inside another strand, between the two; one for both.
    pub penetrating: Vec<[f64; 3]>,
}

/// Measures how `wire` runs, and where it fails.
pub fn elegance(wire: &Wire) -> (Elegance, Faults) {
    let Some(walk) = Walk::along(wire) else { return Default::default() };
    let (mut figures, mut faults) = Default::default();
    walk.bends(&mut figures, &mut faults);
    walk.contacts(&mut figures, &mut faults);
    (figures, faults)
}

/// Places at equal steps along the wire, scaled.
struct Walk {
    points: Vec<DVec3>,
    widths: Vec<f64>,
    step: f64,
    closed: bool,
    /// Back to the world.
    centre: DVec3,
    scale: f64,
}

impl Walk {
    /// `None` for a wire whose points coincide.
    fn along(wire: &Wire) -> Option<Walk> {
        let mut points = samples(wire);
        let [low, high] = [DVec3::min, DVec3::max]
            .map(|choose| points.iter().map(|&(point, _)| point).reduce(choose).unwrap_or_default());
        let centre = (low + high) / 2.0;
        let scale = points.iter().map(|&(point, _)| point.distance(centre)).fold(0.0, f64::max);
        // Smaller than that it is rounding.
        if scale <= SAME * (1.0 + centre.length()) {
            return None;
        }
        for (point, width) in &mut points {
            *point = (*point - centre) / scale;
            *width /= scale;
        }
        let mut last = DVec3::INFINITY;
        points.retain(|&(point, _)| std::mem::replace(&mut last, point).distance(point) > SAME);
        let mut walk = Walk { points: vec![], widths: vec![], step: STEP, closed: wire.closed(), centre, scale };
        walk.step_along(&points);
        Some(walk)
    }

    /// Takes a place at every step along the polyline, its last point not among them.
    fn step_along(&mut self, line: &[(DVec3, f64)]) {
        let length: f64 = line.windows(2).map(|ends| ends[0].0.distance(ends[1].0)).sum();
        self.step = STEP.max(length / MOST_STEPS as f64);
        let count = (length / self.step) as usize;
        let mut passed = 0.0;
        for ends in line.windows(2) {
            let [(a, a_width), (b, b_width)] = [ends[0], ends[1]];
            let piece = a.distance(b);
            while self.points.len() < count {
                let beyond = self.points.len() as f64 * self.step - passed;
                if beyond > piece {
                    break;
                }
                let share = if piece > 0.0 { beyond / piece } else { 0.0 };
                self.points.push(a.lerp(b, share));
                self.widths.push(a_width + (b_width - a_width) * share);
            }
            passed += piece;
        }
    }

    fn world(&self, point: DVec3) -> [f64; 3] {
        (point * self.scale + self.centre).to_array()
    }

    /// Steps between two places along the wire, the shorter way round.
    fn apart(&self, i: usize, j: usize) -> f64 {
        let steps = i.abs_diff(j);
        (if self.closed { steps.min(self.points.len() - steps) } else { steps }) as f64
    }

    fn bends(&self, figures: &mut Elegance, faults: &mut Faults) {
        let half = ((GAUGE / 2.0 / self.step).round() as usize).max(1);
        let across = 2 * half;
        let directions: Vec<DVec3> = self
            .points
            .windows(across + 1)
            .map(|part| part[across] - part[0])
            .map(|chord| chord / (chord.length() + 1e-12))
            .collect();
        let turns: Vec<f64> =
            directions.windows(across + 1).map(|part| part[across].dot(part[0]).clamp(-1.0, 1.0).acos()).collect();
        if turns.is_empty() {
            return;
        }
        // The turn at `i` is that round the place one chord further.
        let place = |i: usize| self.world(self.points[i + across]);
        let mut next = 0;
        for (i, &turn) in turns.iter().enumerate() {
            if i >= next && turn > KINK_RAD {
                faults.kinks.push(place(i));
                next = i + 2 * across;
            }
        }
        let gauge = across as f64 * self.step;
        let is_tight = |turn: f64| turn * TIGHT_GAUGES * GAUGE > gauge;
        let tight: Vec<(usize, f64)> = turns.iter().copied().enumerate().filter(|&(_, turn)| is_tight(turn)).collect();
        faults.tight = worst_of_stretches(&tight, across).map(|at| place(tight[at].0)).collect();
        figures.turning_per_unit = turns.iter().sum::<f64>() / turns.len() as f64 / gauge;
        figures.kinks = faults.kinks.len();
        figures.tight_share = tight.len() as f64 / turns.len() as f64;
    }

    fn contacts(&self, figures: &mut Elegance, faults: &mut Faults) {
        let grid = Grid::new(self.points.iter().copied(), CELL);
        let widest = self.widths.iter().copied().fold(0.0, f64::max);
        let steps = |length: f64| (length / self.step).floor();
        let (mut looks, mut touching) = (0, 0);
        let (mut inside, mut between) = (Vec::new(), Vec::new());
        for i in (0..self.points.len()).step_by(LOOK_EVERY) {
            let (here, width) = (self.points[i], self.widths[i]);
            let other_strand = steps(OTHER_STRAND_NEAR).max(OTHER_STRAND_DIAMETERS * width / self.step);
            let within = FARTHEST.min(PENETRATING / 2.0 * (width + widest));
            let (mut touches, mut deepest) = (false, None);
            grid.near(here, GAUGE.max(within), |j, squared| {
                let (j, distance) = (j as usize, squared.sqrt());
                let (apart, radii) = (self.apart(i, j), (width + self.widths[j]) / 2.0);
                touches |= distance <= GAUGE && apart > steps(OTHER_STRAND);
                let penetrates = distance < PENETRATING * radii && distance <= FARTHEST && apart > other_strand;
                if penetrates && deepest.is_none_or(|(depth, _)| radii - distance > depth) {
                    deepest = Some((radii - distance, j));
                }
            });
            looks += 1;
            touching += usize::from(touches);
            if let Some((depth, j)) = deepest {
                inside.push((i, depth));
                between.push((here + self.points[j]) / 2.0);
            }
        }
        let share = |count: usize| count as f64 / f64::max(looks as f64, 1.0);
        figures.touching_share = share(touching);
        figures.penetrating_share = share(inside.len());
        // Both strands have a stretch, and their deepest places are nearly one.
        let mut kept: Vec<DVec3> = Vec::new();
        for at in worst_of_stretches(&inside, (2.0 * GAUGE / self.step) as usize) {
            if kept.iter().all(|other| other.distance(between[at]) > GAUGE) {
                kept.push(between[at]);
            }
        }
        faults.penetrating = kept.into_iter().map(|point| self.world(point)).collect();
    }
}

/// Points and widths at equal steps of the parameter, the end not among them.
fn samples(wire: &Wire) -> Vec<(DVec3, f64)> {
    let mut corners = Vec::new();
    wire.bezier_map::<f64>().apply(wire.control_points(), &mut corners);
    let spans: Vec<_> = wire.spans().collect();
    // The first three points of a closed wire come again.
    let count = SAMPLES_PER_POINT * (wire.control_points().len() + if wire.closed() { 3 } else { 0 });
    let (start, end) = wire.domain();
    let step = (end - start) / count as f64;
    let mut k = 0;
    let sample = |i| {
        let t = start + step * i as f64;
        while k + 1 < spans.len() && spans[k].end <= t {
            k += 1;
        }
        let u = (t - spans[k].start) / spans[k].width();
        let v = 1.0 - u;
        let weights = [v * v * v, 3.0 * v * v * u, 3.0 * v * u * u, u * u * u];
        let [x, y, z, width] = [0, 1, 2, 3].map(|c| (0..4).map(|j| weights[j] * corners[4 * k + j][c]).sum());
        (DVec3::new(x, y, z), width)
    };
    (0..count).map(sample).collect()
}

/// Of places found along the wire, in order, each with how bad it is: the worst of every stretch, as its index. Places
/// up to `most_apart` steps from the next are of one stretch.
fn worst_of_stretches(found: &[(usize, f64)], most_apart: usize) -> impl Iterator<Item = usize> {
    let mut first = 0;
    found.chunk_by(move |a, b| b.0 - a.0 <= most_apart).map(move |stretch| {
        let at = first;
        first += stretch.len();
        let worst = (0..stretch.len()).reduce(|a, b| if stretch[b].1 > stretch[a].1 { b } else { a });
        at + worst.unwrap_or(0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_has_one_place() {
        let found = [(3, 0.1), (5, 0.4), (9, 0.2), (20, 0.1), (24, 0.3)];
        assert_eq!(worst_of_stretches(&found, 4).collect::<Vec<_>>(), [1, 4]);
        assert_eq!(worst_of_stretches(&found, 3).collect::<Vec<_>>(), [1, 2, 3, 4]);
        assert_eq!(worst_of_stretches(&[], 3).count(), 0);
    }

    #[test]
    fn a_circle_turns_evenly() {
        let point = |i: usize| {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / 48.0).sin_cos();
            [3.0 + 0.2 * cos, 0.2 * sin, -1.0, 0.01]
        };
        let (figures, faults) = elegance(&Wire::closed_uniform((0..48).map(point).collect()).unwrap());
        assert!((figures.turning_per_unit - 1.0).abs() < 1e-3, "{figures:?}");
        assert_eq!(figures, Elegance { turning_per_unit: figures.turning_per_unit, ..Elegance::default() });
        assert_eq!(faults, Faults::default());
    }

    #[test]
    fn wires_without_length_have_no_figures() {
        for points in [vec![[0.3; 4]; 7], vec![[0.0; 4]; 4]] {
            assert_eq!(elegance(&Wire::open_uniform(points).unwrap()), Default::default());
        }
        let tiny = (0..9).map(|i| [0.5 + 1e-12 * i as f64, 0.0, 0.0, 0.1]).collect();
        let (figures, _) = elegance(&Wire::open_uniform(tiny).unwrap());
        assert!(figures.turning_per_unit.is_finite(), "{figures:?}");
    }
}
