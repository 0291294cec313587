//! Closed lines a spacing apart along a field, as many as make the curve as long as it should be.

use super::contour;
use super::hierarchy::Level;
use super::phase;
use super::refined::RefinedMesh;
use super::strand::{Strand, length};
use glam::DVec3;
use std::f64::consts::PI;

/// Parts of less than this many square spacings are not covered.
const SMALLEST_PART: f64 = 0.5;
/// Stripes in which the phase's cosine stays within this are a third of a spacing wide at most, and left out.
const LEAST_PEAK: f64 = 0.5;
/// Periods of the stripes that are tried until their length is right.
const PERIODS_TRIED: usize = 3;
/// Area over length of the stripes, in spacings, such that it is 1 in the end: evening out shortens the curve.
const STRIPE_RATIO: f64 = 0.985;

/// The lines of all parts that are not too small.
pub fn stripes(surface: &RefinedMesh, levels: &[Level], field: &[DVec3], spacing: f64, seed: u64) -> Vec<Strand> {
    let areas = surface.part_areas();
    let rim = surface.rim_distances();
    let mut found: (f64, Vec<Strand>) = (f64::INFINITY, Vec::new());
    let mut period = spacing;
    for _ in 0..PERIODS_TRIED {
        let mut values = phase::waves(levels, field, period, seed);
        for (v, value) in values.iter_mut().enumerate() {
            // Along a rim the lines turn back half a spacing before it.
            *value = value.min((rim[v] - spacing / 2.0) * PI / spacing);
        }
        contour::without_slivers(surface, &mut values, LEAST_PEAK);
        contour::cross_zero(surface, &mut values, &rim);
        let mut lines = contour::zero_lines(surface, &values);
        lines.retain(|line| areas[surface.part(line[0].triangle) as usize] >= SMALLEST_PART * spacing * spacing);
        let whole: f64 = lines.iter().map(|line| length(line)).sum();
        let ratio = areas.iter().sum::<f64>() / whole.max(spacing) / spacing / STRIPE_RATIO;
        if (ratio - 1.0).abs() < found.0 {
            found = ((ratio - 1.0).abs(), lines);
        }
        if found.0 < 0.01 {
            break;
        }
        period = (period / ratio).clamp(0.7 * spacing, 1.3 * spacing);
    }
    found.1
}
