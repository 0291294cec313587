//! From a view's picture back to the drawing it was made from.

use super::arrange::Placement;
use crate::view::Image;

impl Placement {
    /// What a picture of this view looks like on the drawing as it was given, upright and not stretched, on paper of
    /// `width` x `height` pixels (of the drawing's aspect). Ground where the view shows nothing of the drawing.
    pub fn laid_back(&self, picture: &Image, width: usize, height: usize) -> Image {
        let upright = self.orientation.inverse().applied(picture);
        let [left, top, across, down] = self.onto;
        // Two opposite corners of where the drawing lies, as shares of the upright picture.
        let (ax, ay) = self.orientation.source_of(left, top);
        let (bx, by) = self.orientation.source_of(left + across, top + down);
        let [from_left, from_top, from_across, from_down] = self.from;
        // The whole paper in the picture's pixels, given that the part `from..from + share` of it lies on `a..b`.
        let paper = |a: f64, b: f64, from: f64, share: f64, size: usize| {
            let (low, scale) = (a.min(b), (b - a).abs() / share);
            [low - from * scale, low + (1.0 - from) * scale].map(|place| place * size as f64)
        };
        let [x0, x1] = paper(ax, bx, from_left, from_across, upright.width);
        let [y0, y1] = paper(ay, by, from_top, from_down, upright.height);
        upright.window([x0, y0, x1, y1], width, height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use crate::start::drawings::arrange::{Cutouts, Drawing};
    use crate::start::drawings::orientation::Orientation;
    use crate::view::Image;

    /// Some strokes on oblong paper, without any symmetry.
    fn drawing(rng: &mut Rng) -> Image {
        let (width, height) = (160 + rng.below(80), 160 + rng.below(80));
        let mut image = Image::new(width, height);
        for _ in 0..4 {
            let mut place = || (rng.range(25.0, width as f64 - 25.0), rng.range(25.0, height as f64 - 25.0));
            let ((ax, ay), (bx, by)) = (place(), place());
            for i in 0..width * height {
                let (x, y) = ((i % width) as f64 + 0.5 - ax, (i / width) as f64 + 0.5 - ay);
                let (dx, dy) = (bx - ax, by - ay);
                let t = ((x * dx + y * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
                let ink = (4.0 - (x - t * dx).hypot(y - t * dy)).clamp(0.0, 1.0) as f32;
                image.data[i] = image.data[i].max(ink);
            }
        }
        image
    }

    /// Σ |a - b| / Σ a.
    fn difference(a: &Image, b: &Image) -> f32 {
        let apart: f32 = a.data.iter().zip(&b.data).map(|(a, b)| (a - b).abs()).sum();
        apart / a.data.iter().sum::<f32>()
    }

    #[test]
    fn what_was_laid_down_comes_back_as_it_was_drawn() {
        let mut rng = Rng::new(7, 0);
        for _ in 0..12 {
            let inks = [drawing(&mut rng), drawing(&mut rng), drawing(&mut rng)];
            let named: Vec<Drawing> = inks.iter().map(|ink| Drawing { name: "it".into(), ink: ink.clone() }).collect();
            let ways: Vec<(usize, Orientation)> = [1, 2, 0]
                .map(|source| {
                    let orientation = Orientation { mirrored: rng.below(2) == 1, quarter_turns: rng.below(4) as u8 };
                    (source, orientation)
                })
                .to_vec();
            let laid = Cutouts::new(&named).unwrap().lay_out(&ways, 1.35, 512);
            for (placement, target) in laid.placements.iter().zip(&laid.targets) {
                let ink = &inks[placement.source];
                let back = |placement: &Placement| placement.laid_back(&target.ink, ink.width, ink.height);
                let right = difference(ink, &back(placement));
                assert!(right < 0.12, "{placement:?}: {right}");
                for other in 0..8u8 {
                    let orientation = Orientation { mirrored: other >= 4, quarter_turns: other % 4 };
                    if orientation != placement.orientation {
                        let wrong = difference(ink, &back(&Placement { orientation, ..*placement }));
                        assert!(wrong > 0.4, "{orientation:?} instead of {placement:?}: {wrong}");
                    }
                }
            }
        }
    }

    #[test]
    fn turning_the_drawing_first_adds_up() {
        let image = Image { width: 3, height: 2, data: (0..6).map(|i| i as f32).collect() };
        let turned = Orientation { mirrored: false, quarter_turns: 1 }.applied(&image);
        assert_eq!(turned.data, [2.0, 5.0, 1.0, 4.0, 0.0, 3.0], "counter-clockwise");
        let all = (0..8).map(|k| Orientation { mirrored: k >= 4, quarter_turns: k % 4 });
        for first in all.clone() {
            assert_eq!(first.inverse().applied(&first.applied(&image)), image);
            assert_eq!(first.after(first.inverse()), Orientation::default());
            for then in all.clone() {
                let twice = then.applied(&first.applied(&image));
                assert_eq!(twice, then.after(first).applied(&image), "{first:?} {then:?}");
            }
        }
    }
}
