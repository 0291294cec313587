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
    let budget = if settings.lines == 0 { Budget::default() } else { Budget::Lines(settings.lines) };
    drawing::draw(photo, &mask.resized(photo.width, photo.height), budget)
}
