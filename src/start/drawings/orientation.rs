//! A drawing cut out along its ink, mirrored, turned and laid into a picture.

use crate::picture::Ink;
use crate::view::Image;

/// Ink below this does not count when a drawing is cut out: paper grain and compression noise.
const FAINT: f32 = 0.25;

/// Mirrored left to right first, then turned counter-clockwise by quarters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Orientation {
    /// Left and right exchanged.
    pub mirrored: bool,
    /// Quarter turns counter-clockwise, 0 to 3.
    pub quarter_turns: u8,
}

impl Orientation {
    /// Whether width and height change places.
    pub fn lies_down(self) -> bool {
        self.quarter_turns % 2 == 1
    }

    /// The place in the drawing (0..1, y down) that shows at (u, v) of the result.
    pub(super) fn source_of(self, mut u: f64, mut v: f64) -> (f64, f64) {
        for _ in 0..self.quarter_turns % 4 {
            (u, v) = (1.0 - v, u);
        }
        (if self.mirrored { 1.0 - u } else { u }, v)
    }

    /// The same, the drawing itself being mirrored or turned by `first` before.
    pub fn after(self, first: Orientation) -> Orientation {
        // Mirrored, a turn goes the other way round.
        let turns = if self.mirrored { 4 - first.quarter_turns % 4 } else { first.quarter_turns };
        Orientation { mirrored: self.mirrored != first.mirrored, quarter_turns: (self.quarter_turns + turns) % 4 }
    }

    /// What brings a picture back to how it lay before.
    pub fn inverse(self) -> Orientation {
        // A mirrored picture comes back by the same turn: mirroring turns it round.
        let turns = if self.mirrored { self.quarter_turns } else { 4 - self.quarter_turns % 4 };
        Orientation { quarter_turns: turns % 4, ..self }
    }

    /// A whole picture mirrored and turned, pixel by pixel.
    pub fn applied(self, picture: &Image) -> Image {
        let (w, h) = (picture.width, picture.height);
        let (width, height) = if self.lies_down() { (h, w) } else { (w, h) };
        let mut out = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                let (u, v) = match self.quarter_turns % 4 {
                    0 => (x, y),
                    1 => (w - 1 - y, x),
                    2 => (w - 1 - x, h - 1 - y),
                    _ => (y, h - 1 - x),
                };
                out.data[y * width + x] = picture.at(if self.mirrored { w - 1 - u } else { u }, v);
            }
        }
        out
    }
}

/// A drawing cut to the box of its ink, at no more pixels than are of use.
#[derive(Debug, Clone)]
pub struct Cutout {
    ink: Image,
    /// The ink's box in `ink`, px: left, top, width, height.
    bounds: [f64; 4],
    /// The ink's box on the drawing, as shares of its sides: left, top, width, height.
    on_drawing: [f64; 4],
}

/// A cut-out keeps at most this many pixels a side.
const MOST_PX: usize = 1024;
/// Ground kept round the ink, so that its soft edge is not cut.
const RIM_PX: usize = 2;

impl Cutout {
    /// Cuts the drawing out; `None` if it is blank.
    pub fn new(drawing: &Image) -> Option<Cutout> {
        let bounds = drawing.threshold(FAINT).bounding_box()?;
        let (width, height) = (bounds.width() + 2 * RIM_PX, bounds.height() + 2 * RIM_PX);
        let mut ink = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                let (from_x, from_y) = ((bounds.left + x).wrapping_sub(RIM_PX), (bounds.top + y).wrapping_sub(RIM_PX));
                if from_x < drawing.width && from_y < drawing.height {
                    ink.data[y * width + x] = drawing.at(from_x, from_y);
                }
            }
        }
        let sides = [drawing.width, drawing.height].map(|side| side as f64);
        let box_px = [bounds.left, bounds.top, bounds.width(), bounds.height()].map(|n| n as f64);
        let on_drawing = std::array::from_fn(|i| box_px[i] / sides[i % 2]);
        let bounds = [RIM_PX, RIM_PX, bounds.width(), bounds.height()].map(|n| n as f64);
        let cutout = Cutout { ink, bounds, on_drawing };
        Some(cutout.shrunk_to(MOST_PX))
    }

    /// The same with at most `most_px` pixels a side.
    pub fn shrunk_to(&self, most_px: usize) -> Cutout {
        let (width, height) = (self.ink.width.min(most_px), self.ink.height.min(most_px));
        if (width, height) == (self.ink.width, self.ink.height) {
            return self.clone();
        }
        let (sx, sy) = (width as f64 / self.ink.width as f64, height as f64 / self.ink.height as f64);
        let [left, top, w, h] = self.bounds;
        let bounds = [left * sx, top * sy, w * sx, h * sy];
        Cutout { ink: self.ink.resized(width, height), bounds, on_drawing: self.on_drawing }
    }

    /// Shrunk to `most_px` a side, every stroke at least `stroke_px` wide there: what is left of hair lines in a coarse
    /// picture must not be chance.
    pub fn traced(&self, most_px: usize, stroke_px: f32) -> Cutout {
        let mut small = self.shrunk_to(most_px);
        // A hair line is faint once it is shrunk; tracing wants a third of full ink.
        small.ink.data.iter_mut().for_each(|value| *value = (2.0 * *value).min(1.0));
        small.ink = small.ink.with_min_stroke(stroke_px);
        small
    }

    /// Width / height of the ink's box; only right before [`Cutout::shrunk_to`].
    pub fn aspect(&self) -> f64 {
        self.bounds[2] / self.bounds[3]
    }

    /// The ink's box on the drawing, as shares of its sides: left, top, width, height.
    pub fn on_drawing(&self) -> [f64; 4] {
        self.on_drawing
    }

    /// Lays the ink's box onto `area` (left, top, width, height in px) of a blank picture.
    pub fn laid(&self, orientation: Orientation, area: [f64; 4], width: usize, height: usize) -> Image {
        // Shrunk by exact averaging to twice the size it is laid down at, then sampled four times a pixel.
        let wanted = if orientation.lies_down() { [area[3], area[2]] } else { [area[2], area[3]] };
        let shrink = |have: f64, total: usize, want: f64| {
            if have > 2.0 * want { ((total as f64 * 2.0 * want / have).ceil() as usize).max(1) } else { total }
        };
        let (w, h) =
            (shrink(self.bounds[2], self.ink.width, wanted[0]), shrink(self.bounds[3], self.ink.height, wanted[1]));
        let small = self.ink.resized(w, h);
        let (sx, sy) = (w as f64 / self.ink.width as f64, h as f64 / self.ink.height as f64);
        let mut picture = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                let mut sum = 0.0;
                for (dx, dy) in [(0.25, 0.25), (0.75, 0.25), (0.25, 0.75), (0.75, 0.75)] {
                    let u = (x as f64 + dx - area[0]) / area[2];
                    let v = (y as f64 + dy - area[1]) / area[3];
                    let (u, v) = orientation.source_of(u, v);
                    let (px, py) =
                        ((self.bounds[0] + u * self.bounds[2]) * sx, (self.bounds[1] + v * self.bounds[3]) * sy);
                    if px >= 0.0 && py >= 0.0 && px <= w as f64 && py <= h as f64 {
                        sum += small.sample(px as f32, py as f32);
                    }
                }
                picture.data[y * width + x] = 0.25 * sum;
            }
        }
        picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flag() -> Image {
        // Ink box columns 10..50, rows 20..40; the upper left quarter of it and the lower edge are ink.
        let mut image = Image::new(64, 64);
        for y in 20..40 {
            for x in 10..50 {
                if (x < 30 && y < 30) || y >= 38 || x == 49 {
                    image.data[y * 64 + x] = 1.0;
                }
            }
        }
        image
    }

    #[test]
    fn laid_upright_fills_its_area() {
        let cutout = Cutout::new(&flag()).unwrap();
        assert_eq!(cutout.aspect(), 2.0);
        let laid = cutout.laid(Orientation::default(), [4.0, 6.0, 40.0, 20.0], 48, 32);
        for y in 0..20 {
            for x in 0..40 {
                let original = flag().at(x + 10, y + 20);
                assert!((laid.at(x + 4, y + 6) - original).abs() < 0.8, "soft at edges only");
                if x % 19 < 17 && y % 9 < 7 && x > 1 && y > 1 {
                    assert!((laid.at(x + 4, y + 6) - original).abs() < 0.3, "{x} {y}");
                }
            }
        }
        assert!(laid.data.iter().enumerate().all(|(i, &v)| v == 0.0 || (3..45).contains(&(i % 48))));
    }

    #[test]
    fn orientations_move_the_corner() {
        let cutout = Cutout::new(&flag()).unwrap();
        // The inked quarter is upper left; counter-clockwise it goes to the lower left.
        let corner = |mirrored, quarter_turns| {
            let orientation = Orientation { mirrored, quarter_turns };
            let laid = cutout.laid(orientation, [0.0, 0.0, 32.0, 32.0], 32, 32);
            let at = [(8, 8), (24, 8), (8, 24), (24, 24)].map(|(x, y)| laid.at(x, y) > 0.9);
            at.iter().position(|&ink| ink).unwrap()
        };
        assert_eq!((0..4).map(|turns| corner(false, turns)).collect::<Vec<_>>(), [0, 2, 3, 1]);
        assert_eq!((0..4).map(|turns| corner(true, turns)).collect::<Vec<_>>(), [1, 0, 2, 3]);
    }

    #[test]
    fn blank_has_no_cutout() {
        assert!(Cutout::new(&Image::new(9, 9)).is_none());
    }
}
