//! A target that bends a little: one spline displacement field a view, resampling the clean ink, with its gradient.
//!
//! `bent(x) = clean(x + d(x))`, d a uniform cubic B-spline over a `grid` x `grid` net of control vectors in pixels of a
//! 256 px picture (larger side), whatever size is fitted. The resampling always starts from the clean ink.

use super::net::{Basis, bases};
use super::straight::Straightness;
use crate::view::Image;
use crate::wire::Real;

/// Weights that keep a field small and smooth. All energies are in squared pixels at 256.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct WarpWeights {
    /// On the mean squared difference of neighbouring control vectors.
    pub smooth: f64,
    /// On the mean squared length of control vectors.
    pub magnitude: f64,
    /// On the mean squared sagitta that straight strokes gain, see [`Warp`]: strokes may move, turn and stretch but
    /// resist being curved, and that keeps letters upright and legible.
    pub straight: f64,
}

/// How far ink has moved.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct Displacement {
    /// Mean over the bent ink, pixels at 256.
    pub mean_px: f64,
    /// Largest over the bent ink, pixels at 256.
    pub max_px: f64,
}

/// Displacements up to this, in pixels at 256, leave calm pixels as they are without a look.
const REACH_PX: f64 = 8.0;

/// Resamples one view's ink through a displacement field, and back.
#[derive(Debug, Clone)]
pub struct Warp<R> {
    grid: usize,
    width: usize,
    height: usize,
    /// Pixels of this picture in one pixel at 256.
    scale: R,
    clean: Vec<R>,
    /// Whether all 4 x 4 texels round a sample right and below of this one are alike.
    flat: Vec<bool>,
    /// Whether everything within [`REACH_PX`] is flat, so that no usual displacement matters: most of any drawing.
    calm: Vec<bool>,
    /// Slope of the bent ink at each pixel by its displacement along x and y, of the last [`Warp::bend`].
    slopes: Vec<[R; 2]>,
    columns: Vec<Basis<R>>,
    rows: Vec<Basis<R>>,
    straightness: Straightness<R>,
    /// Control vectors already blended for one row of pixels, and their adjoints.
    row_field: Vec<[R; 2]>,
    d_row_field: Vec<[R; 2]>,
}

/// A displaced sample: the texel to its upper left, its offset from it, and whether it was held at the border.
struct Tap<R> {
    texel: [usize; 2],
    offset: [R; 2],
    free: [bool; 2],
}

/// Weights of the four texels round a sample (Catmull-Rom: interpolates, and keeps thin lines sharper than bilinear
/// sampling does), and their derivative.
#[inline]
fn catmull_rom<R: Real>(u: R) -> ([R; 4], [R; 4]) {
    let [half, two, three, four] = [0.5, 2.0, 3.0, 4.0].map(R::from_f64);
    let (five, nine, ten, one) = (R::from_f64(5.0), R::from_f64(9.0), R::from_f64(10.0), R::one());
    let weights = [
        ((two - u) * u - one) * u,
        (three * u - five) * u * u + two,
        ((four - three * u) * u + one) * u,
        (u - one) * u * u,
    ];
    let slopes = [
        (four - three * u) * u - one,
        (nine * u - ten) * u,
        (R::from_f64(8.0) - nine * u) * u + one,
        (three * u - two) * u,
    ];
    (weights.map(|w| half * w), slopes.map(|w| half * w))
}

impl<R: Real> Warp<R> {
    /// For `ink` at the size that is fitted, with a net of `grid` x `grid` control vectors (at least 4).
    pub fn new(ink: &Image, grid: usize) -> Self {
        let grid = grid.max(4);
        let (width, height) = (ink.width, ink.height);
        let flat: Vec<bool> = (0..width * height)
            .map(|i| {
                let (x, y) = (i % width, i / width);
                let columns = x.saturating_sub(1)..(x + 3).min(width);
                let mut rows = y.saturating_sub(1)..(y + 3).min(height);
                rows.all(|j| columns.clone().all(|i| ink.at(i, j) == ink.at(x, y)))
            })
            .collect();
        let scale = width.max(height) as f64 / 256.0;
        Warp {
            calm: eroded(&flat, width, height, (REACH_PX * scale).ceil() as usize + 1),
            flat,
            slopes: vec![[R::zero(); 2]; width * height],
            grid,
            width: ink.width,
            height: ink.height,
            scale: R::from_f64(scale),
            clean: ink.data.iter().map(|&v| R::from_f64(f64::from(v))).collect(),
            columns: bases(ink.width, grid),
            rows: bases(ink.height, grid),
            straightness: Straightness::new(ink, grid),
            row_field: vec![[R::zero(); 2]; grid],
            d_row_field: vec![[R::zero(); 2]; grid],
        }
    }

    /// Number of control vectors, row by row from the top left.
    pub fn control_count(&self) -> usize {
        self.grid * self.grid
    }

    /// Blends the control vectors for row `y`; says whether none of its displacements exceeds [`REACH_PX`].
    fn blend_row(&mut self, field: &[[R; 2]], y: usize) -> bool {
        let Basis { first, weights } = self.rows[y];
        let row = |k: usize| &field[(first + k) * self.grid..(first + k + 1) * self.grid];
        let rows = [row(0), row(1), row(2), row(3)];
        let mut most = R::zero();
        for (i, out) in self.row_field.iter_mut().enumerate() {
            for c in 0..2 {
                out[c] = weights[0] * rows[0][i][c]
                    + weights[1] * rows[1][i][c]
                    + weights[2] * rows[2][i][c]
                    + weights[3] * rows[3][i][c];
                most = most.max(out[c].abs());
            }
        }
        // A spline never leaves the range of its control values.
        most <= R::from_f64(REACH_PX)
    }

    /// The displacement at column `x` of the row last blended, pixels at 256.
    #[inline]
    fn displacement_at(&self, x: usize) -> [R; 2] {
        let Basis { first, weights } = &self.columns[x];
        let v = &self.row_field[*first..first + 4];
        [0, 1].map(|c| weights[0] * v[0][c] + weights[1] * v[1][c] + weights[2] * v[2][c] + weights[3] * v[3][c])
    }

    #[inline]
    fn tap(&self, x: usize, y: usize, displacement: [R; 2]) -> Tap<R> {
        let along = |i: usize, d: R, count: usize| {
            let wanted = R::from_f64(i as f64) + self.scale * d;
            let last = R::from_f64((count - 1) as f64);
            let at = wanted.max(R::zero()).min(last);
            let low = at.to_usize().unwrap_or(0);
            (low, at - R::from_f64(low as f64), wanted == at)
        };
        let (x, u, free_x) = along(x, displacement[0], self.width);
        let (y, v, free_y) = along(y, displacement[1], self.height);
        Tap { texel: [x, y], offset: [u, v], free: [free_x, free_y] }
    }

    /// The clean ink at a tap, held within 0 and 1, and its slope along x and y in pixels of this picture.
    #[inline]
    fn sample(&self, tap: &Tap<R>) -> (R, [R; 2]) {
        let [x, y] = tap.texel;
        if self.flat[y * self.width + x] {
            return (self.clean[y * self.width + x], [R::zero(); 2]);
        }
        let ((wx, sx), (wy, sy)) = (catmull_rom(tap.offset[0]), catmull_rom(tap.offset[1]));
        let columns = [0, 1, 2, 3].map(|i| (x + i).saturating_sub(1).min(self.width - 1));
        let mut value = R::zero();
        let mut slope = [R::zero(); 2];
        for j in 0..4 {
            let row = (y + j).saturating_sub(1).min(self.height - 1) * self.width;
            let texels = columns.map(|column| self.clean[row + column]);
            let blend = |w: &[R; 4]| w[0] * texels[0] + w[1] * texels[1] + w[2] * texels[2] + w[3] * texels[3];
            let across = blend(&wx);
            value = value + wy[j] * across;
            slope[0] = slope[0] + wy[j] * blend(&sx);
            slope[1] = slope[1] + sy[j] * across;
        }
        let held = value.max(R::zero()).min(R::one());
        (held, if held == value { slope } else { [R::zero(); 2] })
    }

    /// Writes the bent ink: the clean ink at `x + d(x)`, interpolated.
    pub fn bend(&mut self, field: &[[R; 2]], bent: &mut [R]) {
        for y in 0..self.height {
            let near = self.blend_row(field, y);
            for x in 0..self.width {
                let i = y * self.width + x;
                if near && self.calm[i] {
                    bent[i] = self.clean[i];
                    self.slopes[i] = [R::zero(); 2];
                    continue;
                }
                let tap = self.tap(x, y, self.displacement_at(x));
                let (value, slope) = self.sample(&tap);
                bent[i] = value;
                self.slopes[i] = [0, 1].map(|c| if tap.free[c] { self.scale * slope[c] } else { R::zero() });
            }
        }
    }

    /// Adjoint of the last [`Warp::bend`]: `d_field += (∂bent/∂field)ᵀ d_bent`.
    pub fn bend_vjp(&mut self, d_bent: &[R], d_field: &mut [[R; 2]]) {
        for y in 0..self.height {
            self.d_row_field.fill([R::zero(); 2]);
            let row = y * self.width..(y + 1) * self.width;
            let mut touched = false;
            for ((slope, &d), Basis { first, weights }) in
                self.slopes[row.clone()].iter().zip(&d_bent[row]).zip(&self.columns)
            {
                if *slope == [R::zero(); 2] {
                    continue;
                }
                touched = true;
                let pull = slope.map(|s| d * s);
                for (out, &weight) in self.d_row_field[*first..first + 4].iter_mut().zip(weights) {
                    *out = [out[0] + weight * pull[0], out[1] + weight * pull[1]];
                }
            }
            if !touched {
                continue;
            }
            let Basis { first, weights } = self.rows[y];
            for k in 0..4 {
                let out = &mut d_field[(first + k) * self.grid..(first + k + 1) * self.grid];
                for (out, d) in out.iter_mut().zip(&self.d_row_field) {
                    for c in 0..2 {
                        out[c] = out[c] + weights[k] * d[c];
                    }
                }
            }
        }
    }

    /// The energy that keeps the field small, smooth and kind to straight strokes; adds its gradient to `d_field`.
    pub fn regularise(&self, field: &[[R; 2]], weights: &WarpWeights, d_field: &mut [[R; 2]]) -> R {
        let share = 1.0 / self.control_count() as f64;
        let (smooth, magnitude) = (R::from_f64(weights.smooth * share), R::from_f64(weights.magnitude * share));
        let (grid, two) = (self.grid, R::from_f64(2.0));
        let mut energy = R::zero();
        for i in 0..field.len() {
            for c in 0..2 {
                energy = energy + magnitude * field[i][c] * field[i][c];
                d_field[i][c] = d_field[i][c] + two * magnitude * field[i][c];
            }
            let right = (i % grid + 1 < grid).then_some(i + 1);
            let below = (i + grid < field.len()).then_some(i + grid);
            for j in right.into_iter().chain(below) {
                for c in 0..2 {
                    let step = field[j][c] - field[i][c];
                    energy = energy + smooth * step * step;
                    d_field[j][c] = d_field[j][c] + two * smooth * step;
                    d_field[i][c] = d_field[i][c] - two * smooth * step;
                }
            }
        }
        energy + self.straightness.energy_and_gradient(field, R::from_f64(weights.straight), d_field)
    }

    /// The displacement of every pixel, px at 256, row by row.
    pub fn displacements(&mut self, field: &[[R; 2]]) -> Vec<[R; 2]> {
        let mut all = Vec::with_capacity(self.width * self.height);
        for y in 0..self.height {
            self.blend_row(field, y);
            all.extend((0..self.width).map(|x| self.displacement_at(x)));
        }
        all
    }

    /// How far the ink of `bent`, made from this field, has moved.
    pub fn displacement(&mut self, field: &[[R; 2]], bent: &[R]) -> Displacement {
        let (mut sum, mut max, mut count) = (0.0, 0.0f64, 0usize);
        for (&[x, y], &ink) in self.displacements(field).iter().zip(bent) {
            if ink > R::from_f64(0.5) {
                let length = x.to_f64().unwrap_or(0.0).hypot(y.to_f64().unwrap_or(0.0));
                (sum, max, count) = (sum + length, max.max(length), count + 1);
            }
        }
        Displacement { mean_px: sum / count.max(1) as f64, max_px: max }
    }
}

/// `ink` bent by a field over a net of `grid` x `grid` control vectors, at its own size, and how far its ink moved.
pub fn bend_ink(ink: &Image, grid: usize, field: &[[f32; 2]]) -> (Image, Displacement) {
    let mut warp = Warp::new(ink, grid);
    let mut bent = Image::new(ink.width, ink.height);
    warp.bend(field, &mut bent.data);
    let displacement = warp.displacement(field, &bent.data);
    (bent, displacement)
}

/// Where everything within `reach` pixels along both axes is set; beyond the border nothing speaks against it.
fn eroded(set: &[bool], width: usize, height: usize, reach: usize) -> Vec<bool> {
    let pass = |set: &[bool], count: usize, lines: usize, index: &dyn Fn(usize, usize) -> usize| {
        let mut out = vec![false; set.len()];
        for line in 0..lines {
            // How many pixels of the window ending `reach` ahead are not set.
            let mut unset = (0..reach.min(count)).filter(|&i| !set[index(line, i)]).count();
            for i in 0..count {
                unset += usize::from(i + reach < count && !set[index(line, i + reach)]);
                out[index(line, i)] = unset == 0;
                unset -= usize::from(i >= reach && !set[index(line, i - reach)]);
            }
        }
        out
    };
    let rows = pass(set, width, height, &|y, x| y * width + x);
    pass(&rows, height, width, &|x, y| y * width + x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn smooth_ink(width: usize, height: usize) -> Image {
        let mut ink = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                let (u, v) = (x as f32 / width as f32 - 0.45, y as f32 / height as f32 - 0.55);
                ink.data[y * width + x] = (-40.0 * (u * u - 0.3 * u * v + v * v - 0.06).powi(2) / 0.02).exp();
            }
        }
        ink
    }

    fn random_field(count: usize, size: f64) -> Vec<[f64; 2]> {
        let mut rng = Rng::new(3, 0);
        (0..count).map(|_| [rng.range(-size, size), rng.range(-size, size)]).collect()
    }

    #[test]
    fn no_field_no_change_and_a_constant_field_shifts() {
        let ink = smooth_ink(32, 20);
        let mut warp = Warp::<f64>::new(&ink, 6);
        let mut bent = vec![0.0; 640];
        warp.bend(&vec![[0.0; 2]; 36], &mut bent);
        assert!(bent.iter().zip(&ink.data).all(|(&b, &i)| b == f64::from(i)));
        // 16 px at 256 are two pixels of a picture 32 wide.
        warp.bend(&vec![[16.0, 0.0]; 36], &mut bent);
        assert!((bent[10 * 32 + 12] - f64::from(ink.at(14, 10))).abs() < 1e-9);
        let moved = warp.displacement(&vec![[16.0, 0.0]; 36], &bent);
        assert!((moved.mean_px - 16.0).abs() < 1e-9 && (moved.max_px - 16.0).abs() < 1e-9);
    }

    #[test]
    fn calm_places_are_skipped_without_a_trace() {
        // A line on blank paper, drawn at a size where reach is far less than the picture.
        let mut ink = Image::new(96, 80);
        for y in 30..33 {
            ink.data[y * 96 + 20..y * 96 + 70].fill(1.0);
        }
        let mut quick = Warp::<f64>::new(&ink, 6);
        let mut slow = quick.clone();
        assert!(quick.calm.iter().filter(|&&calm| calm).count() > 96 * 80 / 2);
        slow.calm.fill(false);
        for size in [1.0, 7.0, 20.0] {
            let field = random_field(36, size);
            let (mut a, mut b) = (vec![0.0; 96 * 80], vec![0.0; 96 * 80]);
            quick.bend(&field, &mut a);
            slow.bend(&field, &mut b);
            assert!(a == b && quick.slopes == slow.slopes, "displacements up to {size} px");
        }
    }

    #[test]
    fn gradients_agree_with_central_differences() {
        let ink = smooth_ink(41, 30);
        let mut warp = Warp::<f64>::new(&ink, 5);
        let mut field = random_field(25, 9.0);
        let mut rng = Rng::new(4, 0);
        let d_bent: Vec<f64> = (0..41 * 30).map(|_| rng.range(-1.0, 1.0)).collect();
        let weights = WarpWeights { smooth: 0.3, magnitude: 0.1, straight: 50.0 };
        let mut gradient = vec![[0.0; 2]; 25];
        warp.bend(&field, &mut vec![0.0; 41 * 30]);
        warp.bend_vjp(&d_bent, &mut gradient);
        warp.regularise(&field, &weights, &mut gradient);
        let mut bent = vec![0.0; 41 * 30];
        let mut value = |field: &[[f64; 2]], weights: &WarpWeights| {
            warp.bend(field, &mut bent);
            let image: f64 = bent.iter().zip(&d_bent).map(|(b, d)| b * d).sum();
            image + warp.regularise(field, weights, &mut vec![[0.0; 2]; 25])
        };
        let mut off = |weights: &WarpWeights| {
            let (mut worst, mut scale) = (0.0f64, 0.0f64);
            for i in 0..25 {
                for c in 0..2 {
                    let (h, before) = (1e-5, field[i][c]);
                    field[i][c] = before + h;
                    let above = value(&field, weights);
                    field[i][c] = before - h;
                    let below = value(&field, weights);
                    field[i][c] = before;
                    worst = worst.max(((above - below) / (2.0 * h) - gradient[i][c]).abs());
                    scale = scale.max(gradient[i][c].abs());
                }
            }
            worst / scale
        };
        let right = off(&weights);
        assert!(right < 1e-4, "relative error {right}");
        for other in [
            WarpWeights { smooth: 0.2, ..weights },
            WarpWeights { magnitude: 0.0, ..weights },
            WarpWeights { straight: 0.0, ..weights },
        ] {
            assert!(off(&other) > 1e-3, "{other:?} is another energy");
        }
    }
}
