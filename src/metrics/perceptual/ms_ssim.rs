//! Multi-scale structural similarity: Wang, Simoncelli and Bovik, "Multi-scale structural similarity for image quality
//! assessment", Asilomar 2003.

use super::Perceptual;
use crate::view::Image;

/// Weights of contrast and structure from the finest level to the coarsest, β₁ to β₅ (their table 1; the last one is the
/// luminance's too), as printed: they sum to 1.0001.
const WEIGHTS: [f64; 5] = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333];
/// (K₁ L)² and (K₂ L)² with K₁ = 0.01, K₂ = 0.03 and values from 0 to L = 1.
const C1: f64 = 1e-4;
const C2: f64 = 9e-4;
/// Side of the Gaussian window and its σ, pixels of each level.
const WINDOW_PX: usize = 11;
const SIGMA_PX: f64 = 1.5;

/// Multi-scale structural similarity of dark ink on a light ground, 0 to 1, identical pictures 1.
///
/// Over five levels, each half the size of the one before (means of 2 x 2 pixels),
/// `Π_l mean(c_l)^β_l · mean(l₅)^β₅` with `c = (2 σ_xy + C₂) / (σ_x² + σ_y² + C₂)` and
/// `l = (2 μ_x μ_y + C₁) / (μ_x² + μ_y² + C₁)` in every whole Gaussian window of 11 px, σ 1.5 px. A mean below 0 (where
/// one picture is the other's negative) counts as 0. Pictures too small for five windows use the levels they have, with
/// those weights scaled to the same sum.
pub struct MsSsim;

impl Perceptual for MsSsim {
    fn name(&self) -> &'static str {
        "ms_ssim"
    }

    fn best(&self) -> f64 {
        1.0
    }

    fn score(&self, rendered: &Image, target: &Image) -> f64 {
        let mut pair = [Level::light(rendered), Level::light(target)];
        let window = |side: usize| side.min(WINDOW_PX);
        let side = rendered.width.min(rendered.height);
        let levels = (1..WEIGHTS.len()).take_while(|l| side >> l >= WINDOW_PX).count() + 1;
        let scale = WEIGHTS.iter().sum::<f64>() / WEIGHTS[..levels].iter().sum::<f64>();
        let mut score = 1.0;
        for (l, weight) in WEIGHTS[..levels].iter().enumerate() {
            if l > 0 {
                pair = pair.map(|level| level.halved());
            }
            let kernels = [pair[0].width, pair[0].height].map(|side| gaussian(window(side)));
            let (luminance, contrast) = similarity(&pair, &kernels);
            score *= contrast.max(0.0).powf(weight * scale);
            if l + 1 == levels {
                score *= luminance.powf(weight * scale);
            }
        }
        score
    }
}

/// A picture in double precision: variances are small differences of large sums.
#[derive(Clone)]
struct Level {
    width: usize,
    height: usize,
    data: Vec<f64>,
}

impl Level {
    /// Dark ink on a light ground.
    fn light(ink: &Image) -> Level {
        let data = ink.data.iter().map(|&ink| 1.0 - f64::from(ink)).collect();
        Level { width: ink.width, height: ink.height, data }
    }

    /// Means of 2 x 2 pixels; an odd last row or column is left out.
    fn halved(&self) -> Level {
        let (width, height) = (self.width / 2, self.height / 2);
        let at = |x: usize, y: usize| self.data[y * self.width + x];
        let mean = |x: usize, y: usize| 0.25 * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1));
        let data = (0..width * height).map(|i| mean(i % width * 2, i / width * 2)).collect();
        Level { width, height, data }
    }
}

fn gaussian(size: usize) -> Vec<f64> {
    let bell = |i: usize| (-0.5 * ((i as f64 - 0.5 * (size as f64 - 1.0)) / SIGMA_PX).powi(2)).exp();
    let sum: f64 = (0..size).map(bell).sum();
    (0..size).map(|i| bell(i) / sum).collect()
}

/// Means of luminance and of contrast and structure over all whole windows.
fn similarity([a, b]: &[Level; 2], kernels: &[Vec<f64>; 2]) -> (f64, f64) {
    let (width, height) = (a.width, a.height);
    if a.data.is_empty() {
        return (1.0, 1.0);
    }
    let filtered = |of: &dyn Fn(f64, f64) -> f64| {
        let product: Vec<f64> = a.data.iter().zip(&b.data).map(|(&a, &b)| of(a, b)).collect();
        whole_windows(&product, width, height, kernels)
    };
    let [mean_a, mean_b] = [filtered(&|a, _| a), filtered(&|_, b| b)];
    let [square_a, square_b] = [filtered(&|a, _| a * a), filtered(&|_, b| b * b)];
    let product = filtered(&|a, b| a * b);
    let (mut luminance, mut contrast) = (0.0, 0.0);
    for i in 0..product.len() {
        let (ma, mb) = (mean_a[i], mean_b[i]);
        let variances = (square_a[i] - ma * ma) + (square_b[i] - mb * mb);
        luminance += (2.0 * ma * mb + C1) / (ma * ma + mb * mb + C1);
        contrast += (2.0 * (product[i] - ma * mb) + C2) / (variances + C2);
    }
    (luminance / product.len() as f64, contrast / product.len() as f64)
}

/// Weighted means over every window that lies wholly inside.
fn whole_windows(data: &[f64], width: usize, height: usize, [across, down]: &[Vec<f64>; 2]) -> Vec<f64> {
    let (inner_width, inner_height) = (width + 1 - across.len(), height + 1 - down.len());
    let mut rows = Vec::with_capacity(inner_width * height);
    for row in data.chunks_exact(width) {
        rows.extend(row.windows(across.len()).map(|part| part.iter().zip(across).map(|(v, w)| v * w).sum::<f64>()));
    }
    let mut out = vec![0.0; inner_width * inner_height];
    for (y, out) in out.chunks_exact_mut(inner_width).enumerate() {
        for (k, weight) in down.iter().enumerate() {
            for (out, value) in out.iter_mut().zip(&rows[(y + k) * inner_width..]) {
                *out += weight * value;
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grey(value: impl Fn(usize, usize) -> f64) -> Image {
        let data = (0..256 * 256).map(|i| (1.0 - value(i % 256, i / 256)) as f32).collect();
        Image { width: 256, height: 256, data }
    }

    #[test]
    fn flat_greys_differ_in_luminance_alone() {
        // Contrast is C₂ / C₂ at every level, so what is left is the luminance of the coarsest to the power β₅.
        let (a, b) = (0.25f64, 0.75f64);
        let by_hand = ((2.0 * a * b + 1e-4) / (a * a + b * b + 1e-4)).powf(0.1333);
        let score = MsSsim.score(&grey(|_, _| a), &grey(|_, _| b));
        assert!((score - by_hand).abs() < 1e-6, "{score} {by_hand}");
        assert!((score - by_hand.powf(0.2363 / 0.1333)).abs() > 1e-2, "another level's weight is another number");
    }

    #[test]
    fn a_fainter_chequerboard_differs_in_the_finest_contrast_alone() {
        // Contrast k of a chequerboard ½ ± a: covariance k a², variances a² and k² a²; halved, both are flat ½.
        let board = |contrast: f64| grey(move |x, y| if (x + y) % 2 == 0 { 0.5 + contrast } else { 0.5 - contrast });
        let (a, k) = (0.4, 0.25);
        let by_hand: f64 = ((2.0 * k * a * a + 9e-4) / ((1.0 + k * k) * a * a + 9e-4f64)).powf(0.0448);
        let score = MsSsim.score(&board(k * a), &board(a));
        assert!((score - by_hand).abs() < 1e-4, "{score} {by_hand}");
        // Its negative has covariance -a²: below 0 counts as 0.
        assert_eq!(MsSsim.score(&board(-a), &board(a)), 0.0);
    }

    #[test]
    fn small_and_oblong_pictures_have_scores_too() {
        for (width, height) in [(256, 100), (30, 256), (9, 4), (1, 1), (0, 0)] {
            let picture = |value: f32| Image { width, height, data: vec![value; width * height] };
            assert!((MsSsim.score(&picture(0.3), &picture(0.3)) - 1.0).abs() < 1e-9, "{width} x {height}");
            let apart = MsSsim.score(&picture(0.1), &picture(0.9));
            assert!(apart.is_finite() && (apart < 0.99 || width == 0), "{width} x {height}: {apart}");
        }
    }
}
