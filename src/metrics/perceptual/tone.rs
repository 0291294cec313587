//! How well ink follows the tones of a picture once an eye no longer parts its strokes.

use super::Perceptual;
use crate::view::Image;

/// σ of the blur, pixels of 256. It lets 7% of a ripple of 11 px through (exp(-2 π² σ² / 11²)), the distance at which
/// strokes are hatched by default: from where strokes that far apart merge, this is what is seen.
const SIGMA_PX: f64 = 4.0;

/// `Σ min(B I, B T) / Σ max(B I, B T)` over pixels, B a Gaussian blur of σ 4 px at 256 px, I the rendered and T the
/// wanted ink: the overlap of the tones, 0 to 1, identical pictures 1, two blank ones 1.
pub struct ToneMatch;

impl Perceptual for ToneMatch {
    fn name(&self) -> &'static str {
        "tone_match"
    }

    fn best(&self) -> f64 {
        1.0
    }

    fn score(&self, rendered: &Image, target: &Image) -> f64 {
        crate::metrics::soft_iou(&rendered.blurred(SIGMA_PX), &target.blurred(SIGMA_PX))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hatching_matches_the_grey_it_stands_for() {
        let stripes = |period: usize| {
            let data = (0..256 * 256).map(|i| f32::from((i % 256) % period < period / 2)).collect();
            Image { width: 256, height: 256, data }
        };
        let grey = |ink: f32| Image { width: 256, height: 256, data: vec![ink; 256 * 256] };
        let fine = ToneMatch.score(&stripes(10), &grey(0.5));
        assert!(fine > 0.93, "{fine}");
        assert!(crate::metrics::soft_iou(&stripes(10), &grey(0.5)) < 0.4, "pixel by pixel they differ");
        assert!(ToneMatch.score(&stripes(40), &grey(0.5)) < 0.75, "wide stripes do not merge");
        // The blur keeps the shares of even greys: a quarter of the ink is a quarter of the tone.
        let quarter = ToneMatch.score(&grey(0.2), &grey(0.8));
        assert!((quarter - 0.25).abs() < 1e-6, "{quarter}");
    }
}
