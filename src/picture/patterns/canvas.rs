//! A sheet that repeats in both directions, painted on from back to front with smooth edges.

use crate::view::Image;
use glam::DVec2;

/// A point of a stroke and the stroke's width there, both in tiles.
pub(super) type Nib = (DVec2, f64);

/// The sheet is one tile wide and high; y points down. What reaches over a border comes in at the other, or is cut off:
/// then it is for the painter to paint what comes in, so that it lies before and behind what it should.
pub(super) struct Canvas {
    image: Image,
    cut: bool,
    /// How much of each pixel the present shape covers, where [`Canvas::touched`] says so.
    cover: Vec<f32>,
    touched: Vec<usize>,
}

impl Canvas {
    pub(super) fn new(size_px: usize) -> Canvas {
        Canvas {
            image: Image::new(size_px, size_px),
            cut: false,
            cover: vec![0.0; size_px * size_px],
            touched: Vec::new(),
        }
    }

    /// From now on cuts off what reaches over a border.
    pub(super) fn cut(&mut self) {
        self.cut = true;
    }

    pub(super) fn into_image(self) -> Image {
        self.image
    }

    /// A stroke through the points with round ends, its width changing between them.
    pub(super) fn stroke(&mut self, line: &[Nib], ink: f32) {
        for pair in line.windows(2) {
            let [(a, wa), (b, wb)] = [pair[0], pair[1]];
            let reach = 0.5 * wa.max(wb);
            self.cover(a.min(b) - reach, a.max(b) + reach, |p| {
                let along = b - a;
                let t = if along == DVec2::ZERO {
                    0.0
                } else {
                    ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0)
                };
                p.distance(a + t * along) - 0.5 * (wa + t * (wb - wa))
            });
        }
        self.paint(ink);
    }

    /// A disc.
    pub(super) fn dot(&mut self, centre: DVec2, radius: f64, ink: f32) {
        self.cover(centre - radius, centre + radius, |p| p.distance(centre) - radius);
        self.paint(ink);
    }

    /// The inside of a closed line.
    pub(super) fn fill(&mut self, outline: &[DVec2], ink: f32) {
        let low = outline.iter().copied().fold(DVec2::MAX, DVec2::min);
        let high = outline.iter().copied().fold(DVec2::MIN, DVec2::max);
        self.cover(low, high, |p| {
            let (mut nearest, mut inside) = (f64::INFINITY, false);
            for (i, &b) in outline.iter().enumerate() {
                let a = outline[(i + outline.len() - 1) % outline.len()];
                let along = b - a;
                let t = ((p - a).dot(along) / along.length_squared().max(1e-300)).clamp(0.0, 1.0);
                nearest = nearest.min(p.distance_squared(a + t * along));
                if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                    inside = !inside;
                }
            }
            if inside { -nearest.sqrt() } else { nearest.sqrt() }
        });
        self.paint(ink);
    }

    /// Adds a shape between two corners, given by the signed distance to its edge, to the present one.
    fn cover(&mut self, low: DVec2, high: DVec2, distance: impl Fn(DVec2) -> f64) {
        let size = self.image.width as i64;
        if size == 0 {
            return;
        }
        let pixels = |low: f64, high: f64| {
            let (low, high) = ((low * size as f64 - 1.0).floor() as i64, (high * size as f64 + 1.0).ceil() as i64);
            if self.cut { low.max(0)..high.min(size) } else { low..high }
        };
        for y in pixels(low.y, high.y) {
            for x in pixels(low.x, high.x) {
                let at = DVec2::new(x as f64 + 0.5, y as f64 + 0.5) / size as f64;
                let cover = (0.5 - distance(at) * size as f64).clamp(0.0, 1.0) as f32;
                if cover > 0.0 {
                    let pixel = (y.rem_euclid(size) * size + x.rem_euclid(size)) as usize;
                    if self.cover[pixel] == 0.0 {
                        self.touched.push(pixel);
                    }
                    self.cover[pixel] = self.cover[pixel].max(cover);
                }
            }
        }
    }

    /// Paints the present shape and begins a new one.
    fn paint(&mut self, ink: f32) {
        for pixel in self.touched.drain(..) {
            let cover = std::mem::take(&mut self.cover[pixel]);
            self.image.data[pixel] += cover * (ink - self.image.data[pixel]);
        }
    }
}

/// `count + 1` values of `f` at even steps from 0 to 1.
pub(super) fn along<T>(count: usize, f: impl Fn(f64) -> T) -> Vec<T> {
    (0..=count).map(|i| f(i as f64 / count as f64)).collect()
}
