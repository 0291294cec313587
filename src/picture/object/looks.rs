//! How an object looks: its tone, what of it catches the eye, its highlights. Colours are Oklab's.

use super::super::Mask;
use super::super::colour::distance;
use super::super::spread::quantile;
use super::ground::{Ground, Pixels};
use super::parts::filled;
use crate::picture::Ink;
use crate::sorting::sort_by_key;
use crate::view::Image;
use std::cmp::Reverse;

/// Lightnesses within this range are one shade.
const ONE_SHADE: f32 = 0.2;
/// Strokes up to this share of the object's longer side are slender.
const SLENDER: f32 = 0.2;
/// As light as white, and as colourless.
const WHITE: f32 = 0.88;
const COLOURLESS: f32 = 0.04;
/// Scales of centres, as shares of the object's longer side; a surround is three times as large.
const CENTRES: [f64; 3] = [0.01, 0.02, 0.04];
/// Differences from the surround, in Oklab units, that are nothing to look at.
const LEAST_CONTRAST: f32 = 0.04;
/// Surround of a highlight as a share of the object's longer side, and how much lighter a clear highlight is.
const HIGHLIGHT_SURROUND: f64 = 0.12;
const CLEAR_HIGHLIGHT: f32 = 0.2;
/// Highlights that the ground's colour makes holes of: up to this share of the object, so many of them, and round them, at
/// these distances in pixels, this much lighter than the object is elsewhere.
const LARGEST_HIGHLIGHT_HOLE: f64 = 0.03;
const MOST_HIGHLIGHT_HOLES: usize = 12;
const ROUND_HIGHLIGHT_PX: [f32; 2] = [1.5, 4.0];
const LIGHTER_ROUND_HIGHLIGHT: f32 = 0.08;

/// See [`super::Object::tone`].
pub fn tone(pixels: &Pixels, mask: &Image, drawn: bool, ground: &Ground) -> Image {
    let inside: Vec<usize> = (0..pixels.lab.len()).filter(|&i| mask.data[i] > 0.5).collect();
    let ink = drawn || is_ink(pixels, mask);
    let off = |i: usize| distance(pixels.lab[i], ground.at(pixels, i));
    // Ink is ink in any colour.
    let full = quantile(&mut inside.iter().map(|&i| off(i)).collect::<Vec<_>>(), 0.95).max(1e-3);
    let tone = |i: usize| {
        let tone = if ink { off(i) / full } else { 1.0 - pixels.lab[i][0] };
        tone.clamp(0.0, 1.0) * mask.data[i]
    };
    Image { width: pixels.width, height: pixels.height, data: (0..pixels.lab.len()).map(tone).collect() }
}

/// Of one shade, and slender (letters, signs) or white (a logo on dark ground).
fn is_ink(pixels: &Pixels, mask: &Image) -> bool {
    let solid = mask.threshold(0.5);
    // Soft edges are mixed with the ground.
    let full = mask.threshold(0.9);
    let unmixed = if 4 * full.count() > solid.count() { &full } else { &solid };
    let inside = || (0..solid.data.len()).filter(|&i| unmixed.data[i]);
    let shade = |share: f64| quantile(&mut inside().map(|i| pixels.lab[i][0]).collect::<Vec<_>>(), share);
    if shade(0.95) - shade(0.05) > ONE_SHADE {
        return false;
    }
    let chroma = quantile(&mut inside().map(|i| pixels.lab[i][1].hypot(pixels.lab[i][2])).collect::<Vec<_>>(), 0.5);
    let deepest = solid.inverted().distance_px().data.into_iter().fold(0.0, f32::max);
    2.0 * deepest <= SLENDER * longer_side(&solid) || shade(0.5) > WHITE && chroma < COLOURLESS
}

/// See [`super::Attention::saliency`]; `solid` is where the mask is more than half.
pub fn saliency(pixels: &Pixels, mask: &Image, solid: &Mask) -> Image {
    let long = f64::from(longer_side(solid));
    let mut contrast = Image::new(pixels.width, pixels.height);
    for share in CENTRES {
        let [centre, surround] = [share, 3.0 * share].map(|share| blurred(pixels, [0, 1, 2], solid, share * long));
        for i in 0..contrast.data.len() {
            let squared: f32 = (0..3).map(|c| (centre[c].data[i] - surround[c].data[i]).powi(2)).sum();
            contrast.data[i] += squared.sqrt();
        }
    }
    let mut inside: Vec<f32> =
        contrast.data.iter().zip(&solid.data).filter(|(_, solid)| **solid).map(|(value, _)| *value).collect();
    let most = quantile(&mut inside, 0.98).max(LEAST_CONTRAST * CENTRES.len() as f32);
    contrast.data.iter_mut().zip(&mask.data).for_each(|(value, mask)| *value = (*value / most).min(1.0) * mask);
    contrast
}

/// See [`super::Attention::highlight`]; `solid` likewise.
pub fn highlight(pixels: &Pixels, mask: &Image, solid: &Mask) -> Image {
    let [around] = blurred(pixels, [0], solid, HIGHLIGHT_SURROUND * f64::from(longer_side(solid)));
    let lighter = |i: usize| ((pixels.lab[i][0] - around.data[i]) / CLEAR_HIGHLIGHT).clamp(0.0, 1.0) * mask.data[i];
    Image { width: pixels.width, height: pixels.height, data: (0..pixels.lab.len()).map(lighter).collect() }
}

/// Closes holes that are highlights: the object gets lighter towards them, which round a hole with the ground behind it
/// does not.
pub fn close_highlights(pixels: &Pixels, mask: &mut Image) {
    let solid = mask.threshold(0.5);
    let holes =
        Mask { data: filled(&solid).data.iter().zip(&solid.data).map(|(all, on)| *all && !on).collect(), ..solid };
    let parts = holes.components();
    let lightness =
        |at: &[usize], share| quantile(&mut at.iter().map(|&i| pixels.lab[i][0]).collect::<Vec<_>>(), share);
    let inside: Vec<usize> = (0..solid.data.len()).filter(|&i| solid.data[i]).collect();
    let usual = lightness(&inside, 0.5);
    let small = |size: usize| size as f64 <= LARGEST_HIGHLIGHT_HOLE * inside.len() as f64;
    let mut labels: Vec<u32> =
        (1..).zip(&parts.sizes).filter(|(_, size)| small(**size)).map(|(label, _)| label).collect();
    sort_by_key(&mut labels, |&label| (Reverse(parts.sizes[label as usize - 1]), label));
    for label in labels.into_iter().take(MOST_HIGHLIGHT_HOLES) {
        let hole = Mask { data: parts.labels.iter().map(|&part| part == label).collect(), ..solid };
        let away = hole.distance_px().data;
        let [near, far] = ROUND_HIGHLIGHT_PX;
        let round: Vec<usize> = inside.iter().copied().filter(|&i| away[i] > near && away[i] <= far).collect();
        let opaque = (0..away.len()).all(|i| !hole.data[i] || pixels.alpha[i] > 0.5);
        if opaque && lightness(&round, 0.1) > usual + LIGHTER_ROUND_HIGHLIGHT {
            let rim = |i: &usize| away[*i] <= near;
            (0..away.len()).filter(rim).for_each(|i| mask.data[i] = 1.0);
        }
    }
}

/// Some of the three channels blurred within the object: its ground has no say.
fn blurred<const N: usize>(pixels: &Pixels, channels: [usize; N], solid: &Mask, sigma_px: f64) -> [Image; N] {
    let inside = solid.to_image();
    let weight = inside.blurred(sigma_px);
    channels.map(|channel| {
        let data = pixels.lab.iter().zip(&inside.data).map(|(lab, inside)| lab[channel] * inside).collect();
        let mut blurred = Image { data, ..inside }.blurred(sigma_px);
        blurred.data.iter_mut().zip(&weight.data).for_each(|(value, weight)| *value /= weight.max(1e-4));
        blurred
    })
}

fn longer_side(solid: &Mask) -> f32 {
    solid.bounding_box().map_or(1, |part| part.width().max(part.height())) as f32
}
