//! From a view's picture back to the drawing it was made from.

use super::arrange::Placement;
use crate::view::Image;

/// Samples a side of one pixel at most, where the drawing is small on its paper.
const MOST_SAMPLES: f64 = 4.0;

impl Placement {
    /// What a picture of this view looks like on the drawing as it was given, upright and not stretched, on paper of
    /// `width` x `height` pixels (of the drawing's aspect). Ground where the view shows nothing of the drawing.
    pub fn laid_back(&self, picture: &Image, width: usize, height: usize) -> Image {
        let [left, top, across, down] = self.from;
        let [onto_left, onto_top, onto_across, onto_down] = self.onto;
        let (w, h) = (picture.width as f64, picture.height as f64);
        let (shown_across, shown_down) = if self.orientation.lies_down() {
            (onto_down * h, onto_across * w)
        } else {
            (onto_across * w, onto_down * h)
        };
        let density = (shown_across / (across * width as f64)).max(shown_down / (down * height as f64));
        let samples = density.ceil().clamp(1.0, MOST_SAMPLES) as usize;
        let mut paper = Image::new(width, height);
        for (i, value) in paper.data.iter_mut().enumerate() {
            let mut sum = 0.0;
            for sample in 0..samples * samples {
                let part = |k: usize| (k as f64 + 0.5) / samples as f64;
                let x = ((i % width) as f64 + part(sample % samples)) / width as f64;
                let y = ((i / width) as f64 + part(sample / samples)) / height as f64;
                let (u, v) = self.orientation.place_of((x - left) / across, (y - top) / down);
                let (x_px, y_px) = ((onto_left + u * onto_across) * w, (onto_top + v * onto_down) * h);
                if x_px >= 0.0 && y_px >= 0.0 && x_px <= w && y_px <= h {
                    sum += picture.sample(x_px as f32, y_px as f32);
                }
            }
            *value = sum / (samples * samples) as f32;
        }
        paper
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use crate::start::arrange::{Cutouts, Drawing};
    use crate::start::placing::Orientation;
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
        let mut image = Image::new(40, 40);
        for (x, y, value) in [(12, 9, 1.0), (30, 9, 0.9), (12, 33, 0.8), (31, 30, 0.7)] {
            image.data[y * 40 + x] = value;
        }
        let turned = |image: &Image, way: Orientation| {
            let mut out = image.clone();
            for i in 0..1600 {
                let (x, y) = ((i % 40) as f64 + 0.5, (i / 40) as f64 + 0.5);
                let (u, v) = way.place_of(x / 40.0, y / 40.0);
                out.data[(v * 40.0) as usize * 40 + (u * 40.0) as usize] = image.data[i];
            }
            out
        };
        let all = (0..8).map(|k| Orientation { mirrored: k >= 4, quarter_turns: k % 4 });
        for first in all.clone() {
            for then in all.clone() {
                assert_eq!(
                    turned(&turned(&image, first), then),
                    turned(&image, then.after(first)),
                    "{first:?} {then:?}"
                );
            }
        }
    }
}
