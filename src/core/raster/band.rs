//! The plain distance band: a cheap stand-in for [`super::ExactRaster`] in the first stage of a fit.
//!
//! A pixel's coverage by one piece is the overlap of `[d - r, d + r]` with a box of one pixel, where `d` is the
//! distance of the pixel's centre to the piece and `r` the radius at the nearest point; strokes combine by the
//! maximum, and the piece that gives the maximum gets the whole gradient. Joints, caps and crossings are therefore
//! only roughly right: never use it for reported figures.

use super::{Raster, piece_indices, usable};
use crate::wire::Stroke;

const NOBODY: u32 = u32::MAX;

/// Distance-band coverage; see the [module](self).
#[derive(Debug, Default)]
pub struct BandRaster {
    width: usize,
    vertices: Vec<[f32; 3]>,
    pieces: Vec<[u32; 2]>,
    coverage: Vec<f32>,
    winner: Vec<u32>,
}

impl BandRaster {
    /// With empty buffers, which grow on the first call.
    pub fn new() -> Self {
        Self::default()
    }
}

/// A piece's centre line and radii in pixels, as the pixel loop wants it.
#[derive(Clone, Copy)]
struct Axis {
    start: [f32; 2],
    along: [f32; 2],
    inverse_length_squared: f32,
    radius: f32,
    radius_slope: f32,
}

impl Axis {
    fn new(a: [f32; 3], b: [f32; 3]) -> Self {
        let along = [b[0] - a[0], b[1] - a[1]];
        let length_squared = along[0] * along[0] + along[1] * along[1];
        let inverse_length_squared = if length_squared > 1e-12 { 1.0 / length_squared } else { 0.0 };
        let (radius, end_radius) = (a[2].max(0.0), b[2].max(0.0));
        Axis { start: [a[0], a[1]], along, inverse_length_squared, radius, radius_slope: end_radius - radius }
    }

    /// Parameter of the nearest point, the offset from it, its length and the radius there.
    #[inline(always)]
    fn nearest(&self, x: f32, y: f32) -> (f32, [f32; 2], f32, f32) {
        let (wx, wy) = (x - self.start[0], y - self.start[1]);
        let t = ((wx * self.along[0] + wy * self.along[1]) * self.inverse_length_squared).clamp(0.0, 1.0);
        let (dx, dy) = (wx - t * self.along[0], wy - t * self.along[1]);
        (t, [dx, dy], (dx * dx + dy * dy).sqrt(), self.radius + t * self.radius_slope)
    }
}

/// Overlap of `[distance - radius, distance + radius]` with `[-1/2, 1/2]`.
#[inline(always)]
fn band(distance: f32, radius: f32) -> f32 {
    ((distance + radius).min(0.5) - (distance - radius).max(-0.5)).max(0.0)
}

impl Raster for BandRaster {
    fn forward(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke]) -> &[f32] {
        self.width = width;
        self.vertices.clear();
        self.vertices.extend_from_slice(vertices);
        self.pieces.clear();
        self.pieces.extend(piece_indices(strokes, vertices.len()).map(|(a, b)| [a as u32, b as u32]));
        self.coverage.clear();
        self.coverage.resize(width * height, 0.0);
        self.winner.clear();
        self.winner.resize(width * height, NOBODY);
        for (id, &[a, b]) in self.pieces.iter().enumerate() {
            let (a, b) = (vertices[a as usize], vertices[b as usize]);
            if !usable(a) || !usable(b) {
                continue;
            }
            let axis = Axis::new(a, b);
            let reach = a[2].max(b[2]).max(0.0) + 0.5;
            let rows = pixel_range(a[1].min(b[1]) - reach, a[1].max(b[1]) + reach, height);
            let columns = (a[0].min(b[0]) - reach, a[0].max(b[0]) + reach);
            for row in rows {
                let y = row as f32 + 0.5;
                let (mut low, mut high) = columns;
                // Within `reach` of the endless centre line: a long slanted piece must not pay for its whole box.
                let [ex, ey] = axis.along;
                if ey.abs() > 1e-3 * ex.abs() {
                    let x = axis.start[0] + (y - axis.start[1]) * ex / ey;
                    let half = reach * (ex * ex + ey * ey).sqrt() / ey.abs();
                    (low, high) = (low.max(x - half), high.min(x + half));
                }
                let span = pixel_range(low, high, width);
                let (first, line) = (span.start, row * width);
                let coverage = &mut self.coverage[line + span.start..line + span.end];
                let winner = &mut self.winner[line + span.start..line + span.end];
                for (i, (best, winner)) in coverage.iter_mut().zip(winner).enumerate() {
                    let (_, _, distance, radius) = axis.nearest((first + i) as f32 + 0.5, y);
                    let value = band(distance, radius);
                    let wins = value > *best;
                    *best = if wins { value } else { *best };
                    *winner = if wins { id as u32 } else { *winner };
                }
            }
        }
        &self.coverage
    }

    fn backward(&mut self, d_coverage: &[f32], d_vertices: &mut Vec<[f32; 3]>) {
        assert_eq!(d_coverage.len(), self.coverage.len(), "one adjoint a pixel of the last forward pass");
        d_vertices.clear();
        d_vertices.resize(self.vertices.len(), [0.0; 3]);
        for (pixel, (&winner, &adjoint)) in self.winner.iter().zip(d_coverage).enumerate() {
            if winner == NOBODY || adjoint == 0.0 {
                continue;
            }
            let [a, b] = self.pieces[winner as usize].map(|i| i as usize);
            let axis = Axis::new(self.vertices[a], self.vertices[b]);
            let (x, y) = ((pixel % self.width) as f32 + 0.5, (pixel / self.width) as f32 + 0.5);
            let (t, [dx, dy], distance, radius) = axis.nearest(x, y);
            let far_side = if distance + radius < 0.5 { 1.0 } else { 0.0 };
            let near_side = if distance - radius > -0.5 { 1.0 } else { 0.0 };
            let (d_distance, d_radius) = (adjoint * (far_side - near_side), adjoint * (far_side + near_side));
            // The distance is least in t, so only the radius feels t move, and only between the ends.
            let free = if t > 0.0 && t < 1.0 { 1.0 } else { 0.0 };
            let d_t = free * d_radius * axis.radius_slope * axis.inverse_length_squared;
            let inverse = if distance > 1e-6 { 1.0 / distance } else { 0.0 };
            let [ex, ey] = axis.along;
            let start = 1.0 - t;
            let (nx, ny) = (dx * inverse * d_distance, dy * inverse * d_distance);
            let d_a = &mut d_vertices[a];
            d_a[0] -= start * nx + d_t * (start * ex + dx);
            d_a[1] -= start * ny + d_t * (start * ey + dy);
            d_a[2] += start * d_radius;
            let d_b = &mut d_vertices[b];
            d_b[0] -= t * nx + d_t * (t * ex - dx);
            d_b[1] -= t * ny + d_t * (t * ey - dy);
            d_b[2] += t * d_radius;
        }
    }
}

/// The pixels whose centres may lie in `low..=high`, within `0..count`.
fn pixel_range(low: f32, high: f32, count: usize) -> std::ops::Range<usize> {
    // Casts saturate (far-off pieces give empty ranges) and are cheaper than `floor`; one pixel more does no harm.
    let end = ((high + 0.5) as usize).min(count);
    let start = ((low + 0.5) as usize).min(end);
    start..end
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn scene(seed: u64) -> (Vec<[f32; 3]>, Vec<Stroke>) {
        let mut rng = Rng::new(seed, 0);
        let mut at = || [rng.range(2.0, 30.0) as f32, rng.range(2.0, 22.0) as f32, rng.range(0.1, 3.0) as f32];
        let vertices = (0..7).map(|_| at()).collect();
        (vertices, vec![Stroke { start: 0, count: 4, closed: false }, Stroke { start: 4, count: 3, closed: true }])
    }

    #[test]
    fn a_straight_stroke_has_its_area() {
        let mut raster = BandRaster::new();
        let stroke = [Stroke { start: 0, count: 2, closed: false }];
        let image = raster.forward(32, 24, &[[8.0, 12.0, 1.5], [24.0, 12.0, 1.5]], &stroke);
        let column: f32 = (0..24).map(|y| image[y * 32 + 16]).sum();
        assert!((column - 3.0).abs() < 1e-5, "{column}");
        assert_eq!(image[0], 0.0);
    }

    #[test]
    fn gradient_is_the_derivative_of_the_image() {
        let (mut raster, mut gradient) = (BandRaster::new(), Vec::new());
        let (mut steep, mut total) = (0, 0);
        for seed in 0..6 {
            let (mut vertices, strokes) = scene(seed);
            let mut rng = Rng::new(seed, 1);
            let adjoint: Vec<f32> = (0..32 * 24).map(|_| rng.range(-1.0, 1.0) as f32).collect();
            let mut energy = |vertices: &[[f32; 3]]| {
                let image = raster.forward(32, 24, vertices, &strokes);
                image.iter().zip(&adjoint).map(|(&c, &a)| f64::from(c) * f64::from(a)).sum::<f64>()
            };
            let h = 1e-3f32;
            let mut differences = Vec::new();
            for i in 0..vertices.len() * 3 {
                let keep = vertices[i / 3][i % 3];
                vertices[i / 3][i % 3] = keep + h;
                let up = energy(&vertices);
                vertices[i / 3][i % 3] = keep - h;
                let down = energy(&vertices);
                vertices[i / 3][i % 3] = keep;
                differences.push((up - down) / f64::from(2.0 * h));
            }
            energy(&vertices);
            raster.backward(&adjoint, &mut gradient);
            for (i, difference) in differences.iter().enumerate() {
                let error = (f64::from(gradient[i / 3][i % 3]) - difference).abs();
                total += 1;
                steep += usize::from(error > 0.05 + 0.02 * difference.abs());
            }
        }
        // A few differences straddle a change of winner.
        assert!(steep * 20 < total, "{steep} of {total} differ");
        assert!(gradient.iter().any(|g| g[2].abs() > 0.1), "a zero gradient would pass for nothing");
    }

    #[test]
    fn hostile_vertices_do_no_harm() {
        let nan = f32::NAN;
        let vertices =
            [[nan, 1.0, 1.0], [5.0, 5.0, 1.0], [1e30, 1e30, 1.0], [-4e5, 8.0, 2.0], [4e5, 9.0, f32::INFINITY]];
        let strokes = [
            Stroke { start: 0, count: 5, closed: true },
            Stroke { start: 1, count: 1, closed: false },
            Stroke { start: 4, count: 9, closed: false },
        ];
        let mut raster = BandRaster::new();
        let image = raster.forward(16, 16, &vertices, &strokes);
        assert!(image.iter().all(|c| (0.0..=1.0).contains(c)));
        assert!(image[5 * 16 + 5] > 0.5, "the single vertex is drawn as a disc");
        let mut gradient = Vec::new();
        raster.backward(&[1.0; 256], &mut gradient);
        assert!(gradient.iter().flatten().all(|g| g.is_finite()));
    }
}
