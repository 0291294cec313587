//! A photograph as tasks read it: its object, and the lines that are drawn of it.

use crate::Result;
use crate::picture::cut::{Cut, Cutter, Hints, Stroke};
use crate::picture::drawing::{self, Budget, Line};
use crate::picture::{Ink, PHOTO_PX, Photo, Picture};
use crate::settings::Settings;
use crate::view::Image;

/// The object: what hints in px of the picture point at, or what stands out. `kept` is what is known of the same picture
/// from before.
///
/// # Errors
/// As [`Cutter::cut`].
pub(super) fn cut(picture: &Picture, hints: &Hints, kept: &mut Option<Cutter>) -> Result<Cut> {
    let cutter = kept.get_or_insert_with(|| Cutter::new(Photo::of(picture)));
    let scale = cutter.photo().scale as f32;
    cutter.cut(&scaled(hints, scale))
}

fn scaled(hints: &Hints, scale: f32) -> Hints {
    let stroke = |stroke: &Stroke| Stroke {
        points: stroke.points.iter().map(|point| point.map(|c| c * scale)).collect(),
        radius_px: stroke.radius_px * scale,
    };
    Hints {
        bounds: hints.bounds.map(|bounds| bounds.map(|side| side * scale)),
        object: hints.object.iter().map(stroke).collect(),
        ground: hints.ground.iter().map(stroke).collect(),
    }
}

/// An object whose longer side takes at most this share of what is looked at of its photograph is looked at more closely.
const SMALL: f64 = 0.75;
/// Margin round it then, as a share of its longer side.
const MARGIN: f64 = 0.1;

/// The part of a photograph that holds the object that `mask` (0 to 1, any size) says, at its own pixels, with the mask of
/// that part: a small object in a large photograph has more to show than the whole at its working size. `None` if it is
/// large, or the photograph is not.
pub(super) fn closer(picture: &Picture, mask: &Image) -> Option<(Picture, Image)> {
    let part = mask.threshold(0.5).bounding_box()?;
    let (width, height) = (picture.width(), picture.height());
    let [across, down] = [width as f64 / mask.width as f64, height as f64 / mask.height as f64];
    let longer = (across * part.width() as f64).max(down * part.height() as f64);
    if longer > SMALL * width.max(height) as f64 || width.max(height) <= PHOTO_PX {
        return None;
    }
    let margin = MARGIN * longer;
    let low = |at: usize, scale: f64| (at as f64 * scale - margin).max(0.0) as usize;
    let high = |at: usize, scale: f64, side: usize| ((at as f64 * scale + margin).ceil() as usize).min(side);
    let [left, top] = [low(part.left, across), low(part.top, down)];
    let [right, bottom] = [high(part.right, across, width), high(part.bottom, down, height)];
    let rows = (top..bottom).flat_map(|y| &picture.rgba()[4 * (y * width + left)..4 * (y * width + right)]);
    let near = Picture::new(picture.name(), right - left, bottom - top, rows.copied().collect()).ok()?;
    let shrunk = (PHOTO_PX as f64 / near.width().max(near.height()) as f64).min(1.0);
    let [columns, lines] = [near.width(), near.height()].map(|side| ((side as f64 * shrunk).round() as usize).max(1));
    let window = [left as f64 / across, top as f64 / down, right as f64 / across, bottom as f64 / down];
    Some((near, mask.window(window, columns, lines)))
}

/// The lines of the object that `mask` (0 to 1, any size) says.
pub(super) fn lines(photo: &Photo, mask: &Image, settings: &Settings) -> Vec<Line> {
    drawing::draw(photo, &mask.resized(photo.width, photo.height), budget(settings))
}

/// All lines in a box (left, top, right, bottom, px of the picture), without an outline.
pub(super) fn lines_in(photo: &Photo, bounds: [f64; 4], settings: &Settings) -> Vec<Line> {
    drawing::draw_in_box(photo, bounds.map(|side| (side * photo.scale) as f32), budget(settings))
}

fn budget(settings: &Settings) -> Budget {
    if settings.lines == 0 { Budget::default() } else { Budget::Lines(settings.lines) }
}
