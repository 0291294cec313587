//! Multi-scale mean squared error: the picture compared at every level of a pyramid, with its exact gradient.
//!
//! Both pyramids are linear, so one pyramid of the *difference* picture serves image and target alike, and the gradient
//! is the transposed pyramid applied from the coarsest level up.

use crate::wire::Real;

/// How one level of the pyramid is made from the one below.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pyramid {
    /// Gaussian blur (σ 1 px, 5 taps, reflected at the border), then every second pixel: the multi-scale loss of Berio et al.'s calligraph, the one
    /// the paper builds on.
    #[default]
    Gaussian,
    /// Means of 2 x 2 pixels; an odd last row or column does not reach the next level.
    AveragePool,
}

/// Half of the symmetric 5-tap kernel exp(-x² / 2), normalised: centre, first, second neighbour.
fn gaussian_taps<R: Real>() -> [R; 5] {
    let half = [(-2.0f64).exp(), (-0.5f64).exp(), 1.0];
    let sum = 2.0 * (half[0] + half[1]) + half[2];
    [half[0], half[1], half[2], half[1], half[0]].map(|tap| R::from_f64(tap / sum))
}

/// Index `i` reflected into `0..n` without repeating the border (n ≥ 3, at most two beyond it).
fn reflect(i: isize, n: usize) -> usize {
    let last = n as isize - 1;
    let i = i.abs();
    (if i > last { 2 * last - i } else { i }) as usize
}

#[derive(Debug, Clone)]
struct Level<R> {
    width: usize,
    height: usize,
    /// First image - target at this level, then the gradient.
    values: Vec<R>,
}

/// Widths and heights of a picture's levels: max(⌈log2 height⌉ - 2, 1) of them, fewer where the picture is so narrow that
/// a level would have no pixel.
pub fn level_sizes(width: usize, height: usize) -> Vec<(usize, usize)> {
    let wanted = (usize::BITS - height.saturating_sub(1).leading_zeros()).saturating_sub(2).max(1) as usize;
    let halved = |&(width, height): &(usize, usize)| (width.min(height) >= 3).then_some((width / 2, height / 2));
    std::iter::successors(Some((width, height)), halved).take(wanted).collect()
}

/// Σ_l m^l · mean((I_l - T_l)²) over the levels l of a pyramid, with buffers that live across iterations.
#[derive(Debug, Clone)]
pub struct MultiscaleMse<R> {
    pyramid: Pyramid,
    taps: [R; 5],
    levels: Vec<Level<R>>,
    rows: Vec<R>,
}

impl<R: Real> MultiscaleMse<R> {
    /// For pictures of `width` x `height` pixels, with the levels of [`level_sizes`].
    pub fn new(pyramid: Pyramid, width: usize, height: usize) -> Self {
        let level = |(width, height)| Level { width, height, values: vec![R::zero(); width * height] };
        let levels = level_sizes(width, height).into_iter().map(level).collect();
        MultiscaleMse { pyramid, taps: gaussian_taps(), levels, rows: vec![R::zero(); width * height.div_ceil(2)] }
    }

    /// Number of levels.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// A picture at every level, finest first: width, height and values, one a pixel.
    pub fn levels_of(&mut self, picture: &[R]) -> impl Iterator<Item = (usize, usize, &[R])> {
        self.levels[0].values.copy_from_slice(picture);
        self.coarsen();
        self.levels.iter().map(|level| (level.width, level.height, &level.values[..]))
    }

    /// Makes all coarser levels from the finest one.
    fn coarsen(&mut self) {
        for l in 1..self.levels.len() {
            let (below, above) = self.levels.split_at_mut(l);
            let (below, above) = (&below[l - 1], &mut above[0]);
            match self.pyramid {
                Pyramid::Gaussian => blur_down(&self.taps, below, above, &mut self.rows),
                Pyramid::AveragePool => pool(below, above),
            }
        }
    }

    /// The loss times `weight` with level weights `level_ratio`^l, and its gradient to `image`, one value a pixel.
    pub fn evaluate(&mut self, image: &[R], target: &[R], level_ratio: R, weight: R) -> (R, &[R]) {
        for ((difference, &i), &t) in self.levels[0].values.iter_mut().zip(image).zip(target) {
            *difference = i - t;
        }
        self.coarsen();
        let (mut loss, mut level_weight) = (R::zero(), weight);
        for level in &mut self.levels {
            let share = level_weight / R::from_f64(level.values.len() as f64);
            loss = loss + share * sum_of_squares(&level.values);
            let twice = share + share;
            level.values.iter_mut().for_each(|value| *value = *value * twice);
            level_weight = level_weight * level_ratio;
        }
        for l in (1..self.levels.len()).rev() {
            let (below, above) = self.levels.split_at_mut(l);
            let (below, above) = (&mut below[l - 1], &above[0]);
            match self.pyramid {
                Pyramid::Gaussian => blur_down_transpose(&self.taps, above, below, &mut self.rows),
                Pyramid::AveragePool => pool_transpose(above, below),
            }
        }
        (loss, &self.levels[0].values)
    }
}

/// In eight interleaved sums, so that it can use vector registers.
fn sum_of_squares<R: Real>(values: &[R]) -> R {
    let mut sums = [R::zero(); 8];
    let chunks = values.chunks_exact(8);
    let rest: R = chunks.remainder().iter().map(|&v| v * v).sum();
    for chunk in chunks {
        for k in 0..8 {
            sums[k] = sums[k] + chunk[k] * chunk[k];
        }
    }
    sums.into_iter().sum::<R>() + rest
}

/// Blur and take every second pixel: only what is kept is computed. Columns first, because they vectorise.
fn blur_down<R: Real>(taps: &[R; 5], from: &Level<R>, to: &mut Level<R>, rows: &mut [R]) {
    let width = from.width;
    for y in 0..to.height {
        let row = |k: isize| {
            let source = reflect(2 * y as isize + k, from.height);
            &from.values[source * width..(source + 1) * width]
        };
        let (a, b, c, d, e) = (row(-2), row(-1), row(0), row(1), row(2));
        let out = &mut rows[y * width..(y + 1) * width];
        for x in 0..width {
            out[x] = taps[0] * (a[x] + e[x]) + taps[1] * (b[x] + d[x]) + taps[2] * c[x];
        }
    }
    for y in 0..to.height {
        let row = &rows[y * width..(y + 1) * width];
        for (x, out) in to.values[y * to.width..(y + 1) * to.width].iter_mut().enumerate() {
            *out = if x > 0 && 2 * x + 2 < width {
                let w = &row[2 * x - 2..2 * x + 3];
                taps[0] * (w[0] + w[4]) + taps[1] * (w[1] + w[3]) + taps[2] * w[2]
            } else {
                let at = |k: isize| row[reflect(2 * x as isize + k, width)];
                taps[0] * (at(-2) + at(2)) + taps[1] * (at(-1) + at(1)) + taps[2] * at(0)
            };
        }
    }
}

/// `to += blur_downᵀ from`.
fn blur_down_transpose<R: Real>(taps: &[R; 5], from: &Level<R>, to: &mut Level<R>, rows: &mut [R]) {
    let width = to.width;
    for y in 0..from.height {
        let row = &mut rows[y * width..(y + 1) * width];
        row.fill(R::zero());
        for (x, &value) in from.values[y * from.width..(y + 1) * from.width].iter().enumerate() {
            if x > 0 && 2 * x + 2 < width {
                for (out, &tap) in row[2 * x - 2..2 * x + 3].iter_mut().zip(taps) {
                    *out = *out + tap * value;
                }
            } else {
                for (k, &tap) in taps.iter().enumerate() {
                    let out = &mut row[reflect(2 * x as isize + k as isize - 2, width)];
                    *out = *out + tap * value;
                }
            }
        }
    }
    for y in 0..from.height {
        let row = &rows[y * width..(y + 1) * width];
        for (k, &tap) in taps.iter().enumerate() {
            let target = reflect(2 * y as isize + k as isize - 2, to.height);
            for (out, &value) in to.values[target * width..(target + 1) * width].iter_mut().zip(row) {
                *out = *out + tap * value;
            }
        }
    }
}

fn pool<R: Real>(from: &Level<R>, to: &mut Level<R>) {
    let (width, quarter) = (from.width, R::from_f64(0.25));
    for y in 0..to.height {
        let (upper, lower) = from.values[2 * y * width..(2 * y + 2) * width].split_at(width);
        let out = &mut to.values[y * to.width..(y + 1) * to.width];
        for ((out, u), l) in out.iter_mut().zip(upper.chunks_exact(2)).zip(lower.chunks_exact(2)) {
            *out = quarter * ((u[0] + u[1]) + (l[0] + l[1]));
        }
    }
}

/// `to += poolᵀ from`.
fn pool_transpose<R: Real>(from: &Level<R>, to: &mut Level<R>) {
    let (width, quarter) = (to.width, R::from_f64(0.25));
    for y in 0..from.height {
        let row = &from.values[y * from.width..(y + 1) * from.width];
        for out in to.values[2 * y * width..(2 * y + 2) * width].chunks_exact_mut(width) {
            for (pair, &value) in out.chunks_exact_mut(2).zip(row) {
                pair[0] = pair[0] + quarter * value;
                pair[1] = pair[1] + quarter * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn random(count: usize, stream: u64) -> Vec<f64> {
        let mut rng = Rng::new(5, stream);
        (0..count).map(|_| rng.unit()).collect()
    }

    const SIZES: [(usize, usize); 6] = [(16, 16), (33, 21), (7, 64), (5, 3), (2, 40), (1, 1)];

    #[test]
    fn level_counts_follow_the_height() {
        let levels = |w, h| MultiscaleMse::<f32>::new(Pyramid::Gaussian, w, h).levels();
        assert_eq!(
            [levels(512, 512), levels(256, 256), levels(224, 224), levels(128, 128), levels(8, 8)],
            [7, 6, 6, 5, 1]
        );
        assert!(levels(1, 500) == 1 && levels(5, 500) == 2, "a narrow picture has fewer");
    }

    /// Slow and plain: blur with explicit reflection, then take every second pixel.
    fn reference_level(from: &[f64], width: usize, height: usize) -> Vec<f64> {
        let taps: Vec<f64> = (-2..=2).map(|x| (-0.5 * f64::from(x * x)).exp()).collect();
        let sum: f64 = taps.iter().sum();
        let mirrored = |i: isize, n: usize| {
            if i < 0 {
                -i as usize
            } else if i as usize >= n {
                2 * n - 2 - i as usize
            } else {
                i as usize
            }
        };
        let mut out = vec![];
        for y in (0..height / 2).map(|y| 2 * y as isize) {
            for x in (0..width / 2).map(|x| 2 * x as isize) {
                let mut value = 0.0;
                for j in -2..=2isize {
                    for i in -2..=2isize {
                        let weight = taps[(i + 2) as usize] * taps[(j + 2) as usize] / (sum * sum);
                        value += weight * from[mirrored(y + j, height) * width + mirrored(x + i, width)];
                    }
                }
                out.push(value);
            }
        }
        out
    }

    #[test]
    fn the_gaussian_loss_is_what_its_definition_says() {
        for (width, height) in [(16, 32), (33, 21)] {
            let (image, target) = (random(width * height, 1), random(width * height, 2));
            let mut mse = MultiscaleMse::new(Pyramid::Gaussian, width, height);
            let (mut size, mut difference) = ((width, height), Vec::new());
            difference.extend(image.iter().zip(&target).map(|(i, t)| i - t));
            let (mut expected, mut weight) = (0.0, 0.5);
            for _ in 0..mse.levels() {
                expected += weight * difference.iter().map(|d| d * d).sum::<f64>() / difference.len() as f64;
                difference = reference_level(&difference, size.0, size.1);
                size = (size.0 / 2, size.1 / 2);
                weight *= 1.5;
            }
            let (loss, _) = mse.evaluate(&image, &target, 1.5, 0.5);
            assert!((loss - expected).abs() < 1e-12 * expected);
            let (other, _) = mse.evaluate(&image, &target, 1.4, 0.5);
            assert!((other - expected).abs() > 1e-4 * expected, "another level weight is another loss");
        }
    }

    #[test]
    fn gradients_agree_with_central_differences() {
        for pyramid in [Pyramid::Gaussian, Pyramid::AveragePool] {
            for (width, height) in SIZES {
                let (mut image, target) = (random(width * height, 1), random(width * height, 2));
                let mut mse = MultiscaleMse::new(pyramid, width, height);
                let gradient = mse.evaluate(&image, &target, 0.7, 2.0).1.to_vec();
                let mut worst = 0.0f64;
                for i in 0..image.len() {
                    let (h, before) = (1e-4, image[i]);
                    image[i] = before + h;
                    let above = mse.evaluate(&image, &target, 0.7, 2.0).0;
                    image[i] = before - h;
                    let below = mse.evaluate(&image, &target, 0.7, 2.0).0;
                    image[i] = before;
                    worst = worst.max(((above - below) / (2.0 * h) - gradient[i]).abs());
                }
                let scale = gradient.iter().fold(0.0f64, |a, g| a.max(g.abs()));
                assert!(worst < 1e-8 * scale.max(1e-3), "{pyramid:?} {width} x {height}: {worst} of {scale}");
                // Sibling: a gradient that forgot the coarse levels is rejected by the same measure.
                if mse.levels() > 1 {
                    let forgot = mse.evaluate(&image, &target, 0.0, 2.0).1.to_vec();
                    let off = forgot.iter().zip(&gradient).fold(0.0f64, |a, (f, g)| a.max((f - g).abs()));
                    assert!(off > 1e-3 * scale);
                }
            }
        }
    }

    #[test]
    fn pyramids_and_their_transposes_are_adjoint() {
        type Down = fn(&Level<f64>, &mut Level<f64>, &mut [f64]);
        let gaussian: (Down, Down) = (
            |from, to, rows| blur_down(&gaussian_taps(), from, to, rows),
            |from, to, rows| blur_down_transpose(&gaussian_taps(), from, to, rows),
        );
        let average: (Down, Down) = (|from, to, _| pool(from, to), |from, to, _| pool_transpose(from, to));
        for (down, up) in [gaussian, average] {
            for (width, height) in [(16, 16), (33, 21), (7, 64), (3, 3)] {
                let fine = Level { width, height, values: random(width * height, 3) };
                let (w, h) = (width / 2, height / 2);
                let coarse = Level { width: w, height: h, values: random(w * h, 4) };
                let mut rows = vec![0.0; width * height];
                let mut downed = Level { values: vec![0.0; w * h], ..coarse.clone() };
                down(&fine, &mut downed, &mut rows);
                let mut upped = Level { values: vec![0.0; width * height], ..fine.clone() };
                up(&coarse, &mut upped, &mut rows);
                let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
                let (left, right) = (dot(&downed.values, &coarse.values), dot(&fine.values, &upped.values));
                assert!((left - right).abs() < 1e-12 * left.abs(), "{width} x {height}");
                upped.values[width + 1] += 0.01;
                assert!((left - dot(&fine.values, &upped.values)).abs() > 1e-6 * left.abs());
            }
        }
    }
}
