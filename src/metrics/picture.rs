//! How well a rendering matches a drawing.

use super::REPORT_SIZE_PX;
use super::perceptual::{Perceptual, YARDSTICKS};
use crate::view::Image;
use std::collections::BTreeMap;

/// Ink and rendering of more than this count as drawn, for precision and recall.
const DRAWN: f32 = 0.5;
/// How far apart, in pixels at [`REPORT_SIZE_PX`], rendered and drawn ink may be to count as met.
const REACH_PX: usize = 2;
/// What identical pictures get instead of infinity.
const MAX_PSNR_DB: f64 = 100.0;

/// All measures of one view.
#[derive(Debug, Clone, PartialEq)]
pub struct PictureMatch {
    /// [`soft_iou`].
    pub soft_iou: f64,
    /// [`psnr_db`].
    pub psnr_db: f64,
    /// [`precision_2px`].
    pub precision_2px: f64,
    /// [`recall_2px`].
    pub recall_2px: f64,
    /// Scores of the perceptual yardsticks by name.
    pub perceptual: BTreeMap<String, f64>,
}

/// Compares what `render` shows with the drawing: overlap and noise at the drawing's own size, precision, recall and
/// [`YARDSTICKS`] at 256 px. `render` is asked for a picture of the width and height given.
pub fn match_pictures(target: &Image, render: impl FnMut(usize, usize) -> Image) -> PictureMatch {
    match_pictures_with(target, &YARDSTICKS, render)
}

/// [`match_pictures`] with other yardsticks.
pub fn match_pictures_with(
    target: &Image,
    yardsticks: &[&dyn Perceptual],
    mut render: impl FnMut(usize, usize) -> Image,
) -> PictureMatch {
    let own = render(target.width, target.height);
    let (soft_iou, psnr_db) = (soft_iou(&own, target), psnr_db(&own, target));
    let (rendered, target) = for_report(target, render, Some(own));
    let (precision_2px, recall_2px) = (precision_2px(&rendered, &target), recall_2px(&rendered, &target));
    let perceptual = scores(&rendered, &target, yardsticks);
    PictureMatch { soft_iou, psnr_db, precision_2px, recall_2px, perceptual }
}

/// Scores of `yardsticks` by name, at 256 px: for those that are no part of every report, such as ones that read a file.
pub fn perceive(
    target: &Image,
    yardsticks: &[&dyn Perceptual],
    render: impl FnMut(usize, usize) -> Image,
) -> BTreeMap<String, f64> {
    let (rendered, target) = for_report(target, render, None);
    scores(&rendered, &target, yardsticks)
}

fn scores(rendered: &Image, target: &Image, yardsticks: &[&dyn Perceptual]) -> BTreeMap<String, f64> {
    yardsticks.iter().map(|yardstick| (yardstick.name().to_owned(), yardstick.score(rendered, target))).collect()
}

/// Rendering and drawing at the report's size; `own` is what is rendered at the drawing's, if that is known.
fn for_report(target: &Image, mut render: impl FnMut(usize, usize) -> Image, own: Option<Image>) -> (Image, Image) {
    let (width, height) = report_size(target.width, target.height);
    match own {
        Some(own) if (width, height) == (target.width, target.height) => (own, target.clone()),
        _ => (render(width, height), target.resized(width, height)),
    }
}

/// The size whose longer side is [`REPORT_SIZE_PX`].
pub(super) fn report_size(width: usize, height: usize) -> (usize, usize) {
    let longer = width.max(height).max(1);
    let scaled = |side: usize| ((side * REPORT_SIZE_PX + longer / 2) / longer).max(1);
    (scaled(width), scaled(height))
}

/// Σ min(I, T) / Σ max(I, T) over pixels, 0 to 1; two blank pictures match fully. Same size both.
pub fn soft_iou(rendered: &Image, target: &Image) -> f64 {
    let (mut least, mut most) = (0.0, 0.0);
    for (&i, &t) in pixels(rendered, target) {
        least += f64::from(i.min(t));
        most += f64::from(i.max(t));
    }
    if most > 0.0 { least / most } else { 1.0 }
}

/// Peak signal-to-noise ratio, 10 log10(1 / mean squared difference), in decibel; at most 100. Same size both.
pub fn psnr_db(rendered: &Image, target: &Image) -> f64 {
    let sum: f64 = pixels(rendered, target).map(|(&i, &t)| f64::from(i - t).powi(2)).sum();
    let mean = sum / rendered.data.len().max(1) as f64;
    if mean > 0.0 { (-10.0 * mean.log10()).min(MAX_PSNR_DB) } else { MAX_PSNR_DB }
}

/// Share of rendered ink (more than ½) with target ink (more than ½) within 2 px between pixel centres. Pictures of
/// [`REPORT_SIZE_PX`]. 0 where nothing is rendered, 1 where the target is blank too.
pub fn precision_2px(rendered: &Image, target: &Image) -> f64 {
    share_within_reach(rendered, target)
}

/// Share of target ink with rendered ink within 2 px: [`precision_2px`] the other way.
pub fn recall_2px(rendered: &Image, target: &Image) -> f64 {
    share_within_reach(target, rendered)
}

fn pixels<'a>(a: &'a Image, b: &'a Image) -> impl Iterator<Item = (&'a f32, &'a f32)> {
    debug_assert_eq!((a.width, a.height), (b.width, b.height));
    a.data.iter().zip(&b.data)
}

fn share_within_reach(of: &Image, near: &Image) -> f64 {
    debug_assert_eq!((of.width, of.height), (near.width, near.height));
    let (mut drawn, mut met) = (0usize, 0usize);
    for y in 0..of.height {
        for x in 0..of.width {
            if of.at(x, y) > DRAWN {
                drawn += 1;
                met += usize::from(ink_within_reach(near, x, y));
            }
        }
    }
    match drawn {
        0 if near.data.iter().all(|&ink| ink <= DRAWN) => 1.0,
        0 => 0.0,
        _ => met as f64 / drawn as f64,
    }
}

fn ink_within_reach(image: &Image, x: usize, y: usize) -> bool {
    let reached = |from: usize, count: usize| from.saturating_sub(REACH_PX)..(from + REACH_PX + 1).min(count);
    reached(y, image.height).any(|v| {
        reached(x, image.width)
            .any(|u| u.abs_diff(x).pow(2) + v.abs_diff(y).pow(2) <= REACH_PX * REACH_PX && image.at(u, v) > DRAWN)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(size: usize, x: usize, y: usize) -> Image {
        let mut image = Image::new(size, size);
        image.data[y * size + x] = 1.0;
        image
    }

    #[test]
    fn overlap_is_the_ratio_of_sums() {
        let a = Image { width: 2, height: 1, data: vec![1.0, 0.25] };
        let b = Image { width: 2, height: 1, data: vec![0.5, 0.75] };
        assert!((soft_iou(&a, &b) - 0.75 / 1.75).abs() < 1e-12);
        assert_eq!(soft_iou(&a, &a), 1.0);
        assert_eq!(soft_iou(&Image::new(3, 3), &Image::new(3, 3)), 1.0);
        assert_eq!(soft_iou(&dot(3, 0, 0), &dot(3, 1, 0)), 0.0);
    }

    #[test]
    fn noise_is_in_decibel_and_finite() {
        let grey = |value: f32| Image { width: 4, height: 4, data: vec![value; 16] };
        assert!((psnr_db(&grey(0.6), &grey(0.5)) - 20.0).abs() < 1e-4);
        assert_eq!(psnr_db(&grey(0.5), &grey(0.5)), 100.0);
    }

    #[test]
    fn ink_counts_as_met_up_to_two_pixels() {
        let target = dot(9, 4, 4);
        for (x, y, met) in [(4, 4, 1.0), (6, 4, 1.0), (5, 5, 1.0), (4, 2, 1.0), (6, 5, 0.0), (6, 6, 0.0), (7, 4, 0.0)] {
            assert_eq!(precision_2px(&dot(9, x, y), &target), met, "{x}, {y}");
            assert_eq!(recall_2px(&dot(9, x, y), &target), met, "{x}, {y}");
        }
        let mut both = dot(9, 4, 4);
        both.data[0] = 1.0;
        assert_eq!((precision_2px(&both, &target), recall_2px(&both, &target)), (0.5, 1.0));
        let blank = Image::new(9, 9);
        assert_eq!((precision_2px(&blank, &target), recall_2px(&blank, &target)), (0.0, 0.0));
        assert_eq!((precision_2px(&blank, &blank), recall_2px(&blank, &blank)), (1.0, 1.0));
    }

    #[test]
    fn precision_is_taken_at_256_whatever_the_targets_size() {
        for size in [128, 256, 512] {
            // A square, and the same square 3 px of 256 to the right: only its last column is out of reach.
            let square = |size: usize, shift: usize| {
                let mut image = Image::new(size, size);
                let unit = size as f64 / 256.0;
                for y in 0..size {
                    for x in 0..size {
                        let (u, v) = ((x as f64 + 0.5) / unit, (y as f64 + 0.5) / unit);
                        let inside = u > 100.0 + shift as f64 && u < 120.0 + shift as f64 && v > 100.0 && v < 120.0;
                        image.data[y * size + x] = f32::from(inside);
                    }
                }
                image
            };
            let sizes = std::cell::RefCell::new(vec![]);
            let found = match_pictures(&square(size, 0), |width, height| {
                sizes.borrow_mut().push((width, height));
                square(width, 4)
            });
            assert!((found.precision_2px - 0.9).abs() < 1e-9, "{size}: {found:?}");
            assert!((found.soft_iou - 16.0 / 24.0).abs() < 1e-6, "{size}: {found:?}");
            assert_eq!(sizes.borrow()[0], (size, size));
            assert_eq!(sizes.borrow().last(), Some(&(256, 256)));
        }
        assert_eq!(report_size(1000, 500), (256, 128));
    }
}
