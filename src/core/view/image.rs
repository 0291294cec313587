//! One-channel pictures: ink or coverage, 0 to 1, rows from the top.

/// Largest side of a picture: longer ones are averaged down when they are made; drawings are fitted at a few hundred
/// pixels.
pub const MAX_PICTURE_PX: usize = 2048;

/// A rectangle of pixels: columns `left..right`, rows `top..bottom`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PixelBox {
    /// First column.
    pub left: usize,
    /// First row.
    pub top: usize,
    /// One past the last column.
    pub right: usize,
    /// One past the last row.
    pub bottom: usize,
}

impl PixelBox {
    /// Columns.
    pub fn width(&self) -> usize {
        self.right - self.left
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.bottom - self.top
    }
}
use crate::{Error, Result};

/// A grey picture, row by row from the top left; ink (or coverage) is 1, ground 0.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Image {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// `width * height` values.
    pub data: Vec<f32>,
}

impl Image {
    /// A picture of nothing but ground.
    pub fn new(width: usize, height: usize) -> Self {
        Image { width, height, data: vec![0.0; width * height] }
    }

    /// From one byte a pixel, 0 (ground) to 255 (ink), row by row from the top left; `name` is what the person calls it.
    ///
    /// # Errors
    /// [`Error::Picture`] if there are no pixels, too many, or not one byte for each.
    pub fn from_bytes(name: &str, width: usize, height: usize, bytes: &[u8]) -> Result<Image> {
        let refuse = |problem: String, remedy: &str| Err(Error::picture(name, problem, remedy));
        if width == 0 || height == 0 || width.max(height) > MAX_PICTURE_PX {
            return refuse(format!("{width} x {height} pixels"), "give 1 to 2048 pixels a side");
        }
        if bytes.len() != width * height {
            return refuse(format!("{} bytes for {width} x {height} px", bytes.len()), "give one byte a pixel");
        }
        Ok(Image { width, height, data: bytes.iter().map(|&byte| f32::from(byte) / 255.0).collect() })
    }

    /// The value at column `x`, row `y`.
    pub fn at(&self, x: usize, y: usize) -> f32 {
        self.data[y * self.width + x]
    }

    /// The same picture at another size, by exact area averaging (also for sizes that do not divide).
    pub fn resized(&self, width: usize, height: usize) -> Image {
        let horizontal = area_weights(self.width, width);
        let vertical = area_weights(self.height, height);
        let mut rows = vec![0.0f32; width * self.height];
        for y in 0..self.height {
            for (x, window) in horizontal.iter().enumerate() {
                rows[y * width + x] =
                    window.iter().map(|&(source, weight)| weight * self.data[y * self.width + source]).sum();
            }
        }
        let mut out = Image::new(width, height);
        for (y, window) in vertical.iter().enumerate() {
            for &(source, weight) in window {
                for x in 0..width {
                    out.data[y * width + x] += weight * rows[source * width + x];
                }
            }
        }
        out
    }

    /// What a window onto the picture shows: `[left, top, right, bottom]` in pixels, which may reach beyond the picture
    /// (ground there), as a picture of `width` x `height`. Averages areas when shrinking, bilinear when enlarging.
    pub fn window(&self, [left, top, right, bottom]: [f64; 4], width: usize, height: usize) -> Image {
        let horizontal = window_weights(self.width, left, right, width);
        let vertical = window_weights(self.height, top, bottom, height);
        let mut out = Image::new(width, height);
        let mut rows = vec![0.0f32; width * self.height];
        for y in 0..self.height {
            for (x, weights) in horizontal.iter().enumerate() {
                let source = &self.data[y * self.width..][..self.width];
                rows[y * width + x] = weights.iter().map(|&(column, weight)| weight * source[column]).sum();
            }
        }
        for (y, weights) in vertical.iter().enumerate() {
            for &(row, weight) in weights {
                for x in 0..width {
                    out.data[y * width + x] += weight * rows[row * width + x];
                }
            }
        }
        out
    }

    /// What is inside `part`, at the largest size that leaves `margin_px` on every side of a picture of `width` x
    /// `height`, centred. Keeps its aspect, with ground beside it, unless `squash` lets it fill both sides.
    pub fn letterboxed(&self, part: PixelBox, width: usize, height: usize, margin_px: f64, squash: bool) -> Image {
        let inner = |size: usize| (size as f64 - 2.0 * margin_px).max(1.0);
        let mut scale_x = part.width() as f64 / inner(width);
        let mut scale_y = part.height() as f64 / inner(height);
        if !squash {
            scale_x = scale_x.max(scale_y);
            scale_y = scale_x;
        }
        let middle_x = 0.5 * (part.left + part.right) as f64;
        let middle_y = 0.5 * (part.top + part.bottom) as f64;
        let (half_x, half_y) = (0.5 * scale_x * width as f64, 0.5 * scale_y * height as f64);
        self.window([middle_x - half_x, middle_y - half_y, middle_x + half_x, middle_y + half_y], width, height)
    }

    /// Gaussian blur; ground outside. The kernel is cut at 4 `sigma_px` and sums to 1; sigma 0 changes nothing.
    pub fn blurred(&self, sigma_px: f64) -> Image {
        let reach = (4.0 * sigma_px).ceil() as usize;
        if reach == 0 || self.data.is_empty() {
            return self.clone();
        }
        let bell = |k: usize| (-0.5 * ((k as f64 - reach as f64) / sigma_px).powi(2)).exp();
        let sum: f64 = (0..=2 * reach).map(bell).sum();
        let kernel: Vec<f32> = (0..=2 * reach).map(|k| (bell(k) / sum) as f32).collect();
        let (width, height) = (self.width, self.height);
        let mut rows = vec![0.0f32; self.data.len()];
        for (blurred, row) in rows.chunks_exact_mut(width).zip(self.data.chunks_exact(width)) {
            // Weight by weight, so that many pixels are computed at once.
            for (k, weight) in kernel.iter().enumerate() {
                let (to, from) = (reach.saturating_sub(k), k.saturating_sub(reach));
                for (out, value) in blurred.iter_mut().skip(to).zip(row.iter().skip(from)) {
                    *out += weight * value;
                }
            }
        }
        let mut out = Image::new(width, height);
        for (y, blurred) in out.data.chunks_exact_mut(width).enumerate() {
            for source in y.saturating_sub(reach)..height.min(y + reach + 1) {
                let weight = kernel[source + reach - y];
                for (out, value) in blurred.iter_mut().zip(&rows[source * width..]) {
                    *out += weight * value;
                }
            }
        }
        out
    }

    /// The value at a point in pixels (centres at +0.5), bilinear between centres, the nearest value outside.
    pub fn sample(&self, x_px: f32, y_px: f32) -> f32 {
        let place = |p: f32, size: usize| {
            let p = (p - 0.5).clamp(0.0, (size - 1) as f32);
            let low = (p as usize).min(size.saturating_sub(2));
            (low, (low + 1).min(size - 1), p - low as f32)
        };
        let (x0, x1, u) = place(x_px, self.width);
        let (y0, y1, v) = place(y_px, self.height);
        let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
        mix(mix(self.at(x0, y0), self.at(x1, y0), u), mix(self.at(x0, y1), self.at(x1, y1), u), v)
    }
}

/// For each of `to` cells, the source cells of `from` it overlaps with their share of it.
fn area_weights(from: usize, to: usize) -> Vec<Vec<(usize, f32)>> {
    let scale = from as f64 / to as f64;
    (0..to)
        .map(|i| {
            let (low, high) = (i as f64 * scale, (i + 1) as f64 * scale);
            (low as usize..from.min(high.ceil() as usize))
                .map(|s| (s, ((high.min((s + 1) as f64) - low.max(s as f64)) / scale) as f32))
                .filter(|&(_, weight)| weight > 0.0)
                .collect()
        })
        .collect()
}

/// For each of `to` cells over `low..high`, the cells of `0..from` it sees with their weights.
fn window_weights(from: usize, low: f64, high: f64, to: usize) -> Vec<Vec<(usize, f32)>> {
    let scale = (high - low) / to as f64;
    let cells = |from_cell: f64, to_cell: f64| from_cell.max(0.0) as usize..to_cell.clamp(0.0, from as f64) as usize;
    (0..to)
        .map(|i| {
            let weights: Vec<(usize, f32)> = if scale > 1.0 {
                let (start, end) = (low + i as f64 * scale, low + (i + 1) as f64 * scale);
                let overlap = |s: usize| (end.min((s + 1) as f64) - start.max(s as f64)) / scale;
                cells(start.floor(), end.ceil()).map(|s| (s, overlap(s) as f32)).collect()
            } else {
                let centre = low + (i as f64 + 0.5) * scale - 0.5;
                let tent = |s: usize| 1.0 - (centre - s as f64).abs();
                cells(centre.floor(), centre.floor() + 2.0).map(|s| (s, tent(s) as f32)).collect()
            };
            weights.into_iter().filter(|&(_, weight)| weight > 0.0).collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn random(width: usize, height: usize) -> Image {
        let mut rng = Rng::new(5, 0);
        Image { width, height, data: (0..width * height).map(|_| rng.unit() as f32).collect() }
    }

    #[test]
    fn resizing_keeps_the_mean() {
        let image = random(31, 18);
        let mean = |image: &Image| image.data.iter().map(|&v| f64::from(v)).sum::<f64>() / image.data.len() as f64;
        for (width, height) in [(7, 5), (31, 18), (64, 64), (1, 1), (30, 19)] {
            assert!((mean(&image.resized(width, height)) - mean(&image)).abs() < 1e-6, "{width} x {height}");
        }
        assert_eq!(image.resized(62, 36).at(5, 7), image.at(2, 3), "doubling repeats pixels");
    }

    #[test]
    fn windows_shrink_by_area_and_enlarge_smoothly() {
        let image = random(31, 18);
        assert_eq!(image.window([0.0, 0.0, 31.0, 18.0], 31, 18), image);
        let (shrunk, resized) = (image.window([0.0, 0.0, 31.0, 18.0], 7, 5), image.resized(7, 5));
        assert!(shrunk.data.iter().zip(&resized.data).all(|(a, b)| (a - b).abs() < 1e-6));
        let larger = image.window([0.0, 0.0, 31.0, 18.0], 93, 54);
        assert_eq!(larger.at(4, 7), image.at(1, 2), "centres fall on centres at three times the size");
        let part = image.window([4.0, 3.0, 9.0, 8.0], 5, 5);
        assert_eq!(part.at(2, 1), image.at(6, 4));
        let beyond = image.window([-10.0, -10.0, -2.0, -2.0], 8, 4);
        assert!(beyond.data.iter().all(|&value| value == 0.0), "ground outside");
        assert!(image.window([-1e9, 0.0, 1e9, 1.0], 3, 3).data.iter().all(|value| value.is_finite()));
    }

    #[test]
    fn blur_is_a_unit_gaussian() {
        let mut dot = Image::new(41, 33);
        dot.data[16 * 41 + 20] = 1.0;
        let sigma = 2.5;
        let blurred = dot.blurred(sigma);
        assert!((blurred.data.iter().sum::<f32>() - 1.0).abs() < 1e-5);
        let second = |power: i32| -> f64 {
            let each = blurred.data.iter().enumerate();
            each.map(|(i, &v)| f64::from(v) * ((i % 41) as f64 - 20.0).powi(power)).sum()
        };
        assert!(second(1).abs() < 1e-5);
        assert!((second(2).sqrt() - sigma).abs() < 0.01, "{}", second(2).sqrt());
        assert!((dot.blurred(3.0).at(20, 16) - blurred.at(20, 16)).abs() > 1e-3, "another sigma is another picture");
        assert_eq!(dot.blurred(0.0), dot);
    }

    #[test]
    fn sampling_meets_the_centres() {
        let image = random(9, 7);
        assert_eq!(image.sample(4.5, 3.5), image.at(4, 3));
        assert!((image.sample(5.0, 3.5) - 0.5 * (image.at(4, 3) + image.at(5, 3))).abs() < 1e-6);
        assert_eq!(image.sample(-3.0, 99.0), image.at(0, 6));
        assert_eq!(Image { width: 1, height: 1, data: vec![0.25] }.sample(7.0, 0.0), 0.25);
    }
}
