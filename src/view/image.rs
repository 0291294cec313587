//! One-channel pictures: ink or coverage, 0 to 1, rows from the top.

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
