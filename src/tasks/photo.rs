//! A photograph as tasks read it: its object, and the lines that are drawn of it.

use crate::Result;
use crate::picture::cut::{Cut, Cutter, Hints};
use crate::picture::drawing::{self, Budget, Line};
use crate::picture::{Photo, Picture};
use crate::settings::Settings;
use crate::view::Image;

/// The object: what is in the box (left, top, right, bottom, px of the picture), or what stands out.
///
/// # Errors
/// As [`Cutter::cut`].
pub(super) fn cut(picture: &Picture, bounds: Option<[f64; 4]>) -> Result<Cut> {
    let photo = Photo::of(picture);
    let bounds = bounds.map(|bounds| bounds.map(|side| (side * photo.scale) as f32));
    Cutter::new(photo).cut(&Hints { bounds, ..Hints::default() })
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
