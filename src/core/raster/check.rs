//! A small drawing that every machine should draw alike: what a start-up self-check compares.

use super::{ExactRaster, Raster, sampled_union};
use crate::wire::Stroke;

/// Largest difference that passes, in coverage: the reference's 24 x 24 points a pixel are good to about 0.02.
pub const SELF_CHECK_TOLERANCE: f32 = 0.05;

/// Draws a tapered, doubled-back, self-crossing stroke and returns the largest difference in coverage to the slow
/// reference. Above [`SELF_CHECK_TOLERANCE`] the machine's arithmetic is not to be trusted.
pub fn self_check() -> f32 {
    const SIZE: usize = 32;
    let there = (0..24).map(|i| {
        let t = i as f32 / 23.0;
        let (sin, cos) = (7.0 * t).sin_cos();
        [16.0 + (4.0 + 9.0 * t) * cos, 16.0 + (11.0 - 5.0 * t) * sin, 0.3 + 1.5 * t]
    });
    let mut vertices: Vec<[f32; 3]> = there.collect();
    vertices.extend(vertices.clone().into_iter().rev().skip(1));
    let strokes = [Stroke { start: 0, count: vertices.len(), closed: false }];
    let mut raster = ExactRaster::new();
    let exact = raster.forward(SIZE, SIZE, &vertices, &strokes);
    let sampled = sampled_union(SIZE, SIZE, &vertices, &strokes, 24);
    exact.iter().zip(&sampled).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn this_machine_passes() {
        let difference = self_check();
        assert!(difference < SELF_CHECK_TOLERANCE, "{difference}");
        assert!(difference > 0.0, "a sampled reference never agrees to the last bit");
    }
}
