//! How alike two pictures look, by yardsticks that need no data.
//!
//! A learned one reads a file that is not part of this crate: it is one more implementation of [`Perceptual`], and enters
//! through [`super::perceive`].

mod edges;
mod ms_ssim;
mod tone;

pub use edges::{EdgeDistance, edges};
pub use ms_ssim::MsSsim;
pub use tone::ToneMatch;

use crate::view::Image;

/// A measure of how alike two pictures of ink (0 ground, 1 ink) look.
pub trait Perceptual {
    /// Its field in report.json: snake case, with the unit where there is one.
    fn name(&self) -> &'static str;

    /// What identical pictures get; the farther from it, the less alike.
    fn best(&self) -> f64;

    /// Compares what is rendered with what it should show, both of the same size, the longer side
    /// [`super::REPORT_SIZE_PX`]. Finite for finite pictures.
    fn score(&self, rendered: &Image, target: &Image) -> f64;
}

/// The yardsticks of every report.
pub const YARDSTICKS: [&dyn Perceptual; 3] = [&MsSsim, &EdgeDistance, &ToneMatch];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    /// A scene of strokes, `shift_px` to the right.
    fn scene(shift_px: usize) -> Image {
        let mut image = Image::new(256, 256);
        let mut rng = Rng::new(2, 0);
        for _ in 0..12 {
            let (x, y) = (rng.range(40.0, 160.0) as usize, rng.range(40.0, 160.0) as usize);
            let (w, h) = (rng.range(4.0, 60.0) as usize, rng.range(4.0, 60.0) as usize);
            for row in y..y + h {
                image.data[row * 256 + x + shift_px..][..w].fill(1.0);
            }
        }
        image
    }

    /// Whether each is farther from the best than the one before.
    fn worsens(yardstick: &dyn Perceptual, scores: &[f64]) -> bool {
        let far = |score: &f64| (score - yardstick.best()).abs();
        scores.windows(2).all(|pair| far(&pair[0]) < far(&pair[1]))
    }

    #[test]
    fn identical_pictures_get_the_best_and_others_do_not() {
        let (scene, blank) = (scene(0), Image::new(256, 256));
        let other = Image { data: scene.data.iter().map(|ink| 1.0 - ink).collect(), ..scene.clone() };
        for yardstick in YARDSTICKS {
            for picture in [&scene, &blank, &other] {
                let score = yardstick.score(picture, picture);
                assert!((score - yardstick.best()).abs() < 1e-6, "{}: {score}", yardstick.name());
            }
            for (a, b) in [(&scene, &blank), (&blank, &scene)] {
                let score = yardstick.score(a, b);
                assert!(score.is_finite(), "{}", yardstick.name());
                assert!((score - yardstick.best()).abs() > 0.2, "{}: {score}", yardstick.name());
            }
        }
    }

    #[test]
    fn more_blur_and_more_shift_are_worse() {
        let still = scene(0);
        for yardstick in YARDSTICKS {
            let shifted: Vec<f64> =
                [0, 1, 2, 3, 5, 8, 12].iter().map(|&shift| yardstick.score(&scene(shift), &still)).collect();
            assert!(worsens(yardstick, &shifted), "{}: {shifted:?}", yardstick.name());
            // Blur leaves straight edges where they are, so that their distance grows last.
            let blurs: &[f64] = if yardstick.name() == "edge_distance_px" {
                &[0.0, 3.0, 6.0, 12.0]
            } else {
                &[0.0, 0.5, 1.0, 2.0, 4.0, 8.0]
            };
            let blurred: Vec<f64> = blurs.iter().map(|&sigma| yardstick.score(&still.blurred(sigma), &still)).collect();
            assert!(worsens(yardstick, &blurred), "{}: {blurred:?}", yardstick.name());
            // The same scores in another order are not monotone.
            let mut swapped = shifted.clone();
            swapped.swap(2, 4);
            assert!(!worsens(yardstick, &swapped), "{}", yardstick.name());
        }
    }

    #[test]
    fn which_picture_comes_first_does_not_matter() {
        let (a, b) = (scene(0), scene(7).blurred(1.5));
        for yardstick in YARDSTICKS {
            let (there, back) = (yardstick.score(&a, &b), yardstick.score(&b, &a));
            assert!((there - back).abs() < 1e-9, "{}: {there} {back}", yardstick.name());
            let other = yardstick.score(&a, &scene(8));
            assert!((there - other).abs() > 1e-6, "{}: any picture would do", yardstick.name());
        }
    }
}
