//! How much a displacement field curves strokes that are straight.
//!
//! The structure tensor of the ink (Förstner & Gülch 1987) tells where strokes run one way only, and which way: with
//! unit tangent t and normal n, n · ∂²d/∂t² is the curvature that a straight stroke gains. Moving, turning and
//! stretching along the stroke are free. Corners, ends and tight curves run more than one way and are left alone.

use super::net::cell;
use crate::view::{Image, StructureTensor};
use crate::wire::Real;

/// Larger side of the picture that is analysed.
const ANALYSED_PX: usize = 128;
/// Standard deviation of the window in which directions are compared, in the analysed picture.
const WINDOW_SIGMA_PX: f64 = 4.0;
/// Half the chord over which a sagitta is measured, pixels at 256.
const HALF_CHORD_PX: f64 = 16.0;

/// One place on a straight stroke: `normal · Σ_k second[k] d[first + k]` is the sagitta gained there.
#[derive(Debug, Clone)]
struct Sample<R> {
    first: usize,
    normal: [R; 2],
    /// Second derivative along the stroke of the 4 x 4 basis functions, times half the squared half chord.
    second: [[R; 4]; 4],
    /// How much ink and how straight, as a share of the picture's area.
    weight: R,
}

#[derive(Debug, Clone)]
pub(super) struct Straightness<R> {
    grid: usize,
    samples: Vec<Sample<R>>,
}

impl<R: Real> Straightness<R> {
    pub(super) fn new(ink: &Image, grid: usize) -> Self {
        let shrink = ink.width.max(ink.height) as f64 / ANALYSED_PX as f64;
        let size = |side: usize| ((side as f64 / shrink).round() as usize).max(1);
        let ink = ink.resized(size(ink.width), size(ink.height));
        let (width, height) = (ink.width, ink.height);
        let at = |x: isize, y: isize| {
            let inside = |i: isize, n: usize| i.clamp(0, n as isize - 1) as usize;
            f64::from(ink.at(inside(x, width), inside(y, height)))
        };
        let tensor = StructureTensor::new([width, height], WINDOW_SIGMA_PX, |x, y| {
            let (i, j) = (x as isize, y as isize);
            [[0.5 * (at(i + 1, j) - at(i - 1, j)), 0.5 * (at(i, j + 1) - at(i, j - 1))]]
        });
        let mut samples = Vec::new();
        let area_share = 1.0 / (width * height) as f64;
        for y in 0..height {
            for x in 0..width {
                let amount = f64::from(ink.at(x, y));
                let (trace, angle, coherence) = tensor.at(y * width + x);
                if amount < 0.3 || trace < 1e-6 {
                    continue;
                }
                let normal = [angle.cos(), angle.sin()];
                let (first, second) = second_derivative(
                    [(x as f64 + 0.5) / width as f64, (y as f64 + 0.5) / height as f64],
                    [width, height].map(|side| (grid - 3) as f64 / (side as f64 * 256.0 / ANALYSED_PX as f64)),
                    [-normal[1], normal[0]],
                    grid,
                );
                let sagitta = 0.5 * HALF_CHORD_PX * HALF_CHORD_PX;
                samples.push(Sample {
                    first,
                    normal: normal.map(R::from_f64),
                    second: second.map(|row| row.map(|b| R::from_f64(sagitta * b))),
                    weight: R::from_f64(area_share * amount * coherence.powi(4)),
                });
            }
        }
        Straightness { grid, samples }
    }

    /// `weight` · Σ samples' weight · sagitta², adding its gradient.
    pub(super) fn energy_and_gradient(&self, field: &[[R; 2]], weight: R, d_field: &mut [[R; 2]]) -> R {
        if weight == R::zero() {
            return R::zero();
        }
        let mut energy = R::zero();
        for sample in &self.samples {
            let mut sagitta = R::zero();
            for (j, row) in sample.second.iter().enumerate() {
                for (i, &b) in row.iter().enumerate() {
                    let d = field[sample.first + j * self.grid + i];
                    sagitta = sagitta + b * (sample.normal[0] * d[0] + sample.normal[1] * d[1]);
                }
            }
            let pull = weight * sample.weight * sagitta;
            energy = energy + pull * sagitta;
            for (j, row) in sample.second.iter().enumerate() {
                for (i, &b) in row.iter().enumerate() {
                    let d = &mut d_field[sample.first + j * self.grid + i];
                    for c in 0..2 {
                        d[c] = d[c] + (pull + pull) * b * sample.normal[c];
                    }
                }
            }
        }
        energy
    }
}

/// The first control vector at `share` of the picture and the 4 x 4 basis functions' second derivative along
/// `direction` per squared pixel at 256; `cells_per_px` is the net's density along x and y.
fn second_derivative(
    share: [f64; 2],
    cells_per_px: [f64; 2],
    direction: [f64; 2],
    grid: usize,
) -> (usize, [[f64; 4]; 4]) {
    let along = [0, 1].map(|axis: usize| {
        let (first, u) = cell(share[axis], grid);
        (first, derivatives(u))
    });
    let ([bx, dx, ddx], [by, dy, ddy]) = (along[0].1, along[1].1);
    let (s, t) = (direction[0] * cells_per_px[0], direction[1] * cells_per_px[1]);
    let second = std::array::from_fn(|j| {
        std::array::from_fn(|i| s * s * ddx[i] * by[j] + 2.0 * s * t * dx[i] * dy[j] + t * t * bx[i] * ddy[j])
    });
    (along[1].0 * grid + along[0].0, second)
}

/// Value, first and second derivative of the four uniform cubic basis functions at `u` in a cell.
fn derivatives(u: f64) -> [[f64; 4]; 3] {
    let v = 1.0 - u;
    [
        [
            v * v * v / 6.0,
            (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
            (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
            u * u * u / 6.0,
        ],
        [-0.5 * v * v, 1.5 * u * u - 2.0 * u, -1.5 * v * v + 2.0 * v, 0.5 * u * u],
        [v, 3.0 * u - 2.0, 3.0 * v - 2.0, u],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stroke 6 px wide at 256 from the left to the right, at an angle.
    fn stroke(slope: f32) -> Image {
        let mut ink = Image::new(128, 128);
        for y in 0..128 {
            for x in 16..112 {
                let off = (y as f32 - 64.0) - slope * (x as f32 - 64.0);
                ink.data[y * 128 + x] = (2.0 - off.abs() / (1.0 + slope * slope).sqrt()).clamp(0.0, 1.0);
            }
        }
        ink
    }

    fn energy(ink: &Image, field: impl Fn(f64, f64) -> [f64; 2]) -> f64 {
        let straight = Straightness::<f64>::new(ink, 24);
        // Control vector (i, j) of a uniform cubic net sits at cell coordinate i - 1.
        let at = |i: usize| (i as f64 - 1.0) / 21.0 * 256.0 - 128.0;
        let field: Vec<[f64; 2]> = (0..576).map(|k| field(at(k % 24), at(k / 24))).collect();
        straight.energy_and_gradient(&field, 1.0, &mut vec![[0.0; 2]; 576])
    }

    #[test]
    fn straight_strokes_may_move_turn_and_stretch_but_not_curve() {
        for slope in [0.0f32, 0.7] {
            let ink = stroke(slope);
            let length = f64::from(1.0 + slope * slope).sqrt();
            let (t, n) = ([1.0 / length, f64::from(slope) / length], [-f64::from(slope) / length, 1.0 / length]);
            let along = move |x: f64, y: f64| t[0] * x + t[1] * y;
            let moved = energy(&ink, |x, y| [3.0 + 0.1 * y, -2.0 - 0.1 * x + 0.05 * y]);
            let stretched = energy(&ink, |x, y| t.map(|c| c * 1e-3 * along(x, y).powi(2)));
            let curved = energy(&ink, |x, y| n.map(|c| c * 1e-3 * along(x, y).powi(2)));
            assert!(moved < 1e-9 * curved, "{moved} {curved}");
            assert!(stretched < 0.02 * curved, "{stretched} {curved}");
            // d = 1e-3 s² has second derivative 2e-3: a sagitta of .256 px over a chord of 32.
            let ink_share = ink.data.iter().filter(|&&v| v >= 0.3).map(|&v| f64::from(v)).sum::<f64>() / 16384.0;
            assert!(curved > 0.7 * ink_share * 0.256f64.powi(2) && curved < 1.1 * ink_share * 0.256f64.powi(2));
        }
    }
}
