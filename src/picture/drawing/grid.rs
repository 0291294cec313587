//! Sampling of pictures between pixels, several channels at once.

/// A picture of `N` channels, rows from the top.
pub struct Grid<const N: usize> {
    pub width: usize,
    pub height: usize,
    pub data: Vec<[f32; N]>,
}

impl<const N: usize> Grid<N> {
    /// Bilinear between pixels' middles, which are whole numbers here; the nearest value outside.
    pub fn at(&self, x: f32, y: f32) -> [f32; N] {
        let place = |p: f32, side: usize| {
            let p = p.clamp(0.0, (side - 1) as f32);
            let low = (p as usize).min(side.saturating_sub(2));
            (low, (low + 1).min(side - 1), p - low as f32)
        };
        let (x0, x1, u) = place(x, self.width);
        let (y0, y1, v) = place(y, self.height);
        let [a, b, c, d] = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)].map(|(x, y)| &self.data[y * self.width + x]);
        std::array::from_fn(|k| {
            let top = a[k] + (b[k] - a[k]) * u;
            top + (c[k] + (d[k] - c[k]) * u - top) * v
        })
    }
}
