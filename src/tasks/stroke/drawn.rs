//! A photograph's object and the lines that are drawn of it.

use super::given::Given;
use crate::picture::cut::{Cutter, Hints};
use crate::picture::drawing::{self, Budget, Kind};
use crate::picture::{Ink, OBJECT_PX, Object, Photo, find_object};
use crate::settings::{Read, Settings, Shade};
use crate::start::Stroke;
use crate::view::{Image, PixelBox};
use crate::{Error, Result};

/// Whether the lines of a photograph are drawn.
pub(super) fn draws_lines(settings: &Settings) -> bool {
    settings.read == Read::Lines && settings.shade != Shade::Full
}

/// The object: what the mask or the box says, or what stands out.
///
/// # Errors
/// As [`find_object`] and [`Cutter::cut`].
pub(super) fn object(given: &Given, settings: &Settings, notes: &mut Vec<String>) -> Result<Object> {
    let picture = &given.picture;
    let points = given.bounds.is_some() || settings.read == Read::Lines;
    if given.mask.is_some() || !points || picture.is_cut_out() {
        return find_object(picture, given.mask.as_ref(), settings.object);
    }
    let photo = Photo::of(picture);
    let bounds = given.bounds.map(|bounds| bounds.map(|side| (side * photo.scale) as f32));
    let cut = Cutter::new(photo).cut(&Hints { bounds, ..Hints::default() })?;
    notes.extend(cut.notes);
    find_object(picture, Some(&cut.mask), 1)
}

/// The lines that a draughtsman would draw of the object, px of its layers: a picture of [`OBJECT_PX`] in which the object
/// is laid with `margin_px` around it.
///
/// # Errors
/// [`Error::Picture`] where nothing can be drawn.
pub(super) fn strokes(given: &Given, object: &Object, margin_px: f64, settings: &Settings) -> Result<Vec<Stroke>> {
    let photo = Photo::of(&given.picture);
    let mask = object.mask.resized(photo.width, photo.height);
    let budget = if settings.lines == 0 { Budget::default() } else { Budget::Lines(settings.lines) };
    let lines = drawing::draw(&photo, &mask, budget);
    let Some(part) = object.mask.threshold(0.5).bounding_box().filter(|_| !lines.is_empty()) else {
        return Err(Error::picture(given.picture.name(), "has no lines that could be drawn", "use a sharper picture"));
    };
    let longer = photo.width.max(photo.height) as f32;
    let place = Placement::new(&object.mask, &photo, part, margin_px);
    let stroke = |line: drawing::Line| Stroke {
        points: line.points.iter().map(|&point| place.of(point)).collect(),
        width_px: match settings.shade {
            Shade::None => settings.outline as f32 * OBJECT_PX as f32 / 256.0,
            Shade::Accent | Shade::Full => line.width_px * OBJECT_PX as f32 / longer,
        },
        is_outline: line.kind == Kind::Outline,
    };
    Ok(lines.into_iter().map(stroke).collect())
}

/// From a photograph's pixels to those of the object's layers ([`Image::letterboxed`]).
struct Placement {
    scale: [f32; 2],
    middle: [f32; 2],
    zoom: f32,
}

impl Placement {
    fn new(mask: &Image, photo: &Photo, part: PixelBox, margin_px: f64) -> Placement {
        Placement {
            scale: [mask.width as f32 / photo.width as f32, mask.height as f32 / photo.height as f32],
            middle: [0.5 * (part.left + part.right) as f32, 0.5 * (part.top + part.bottom) as f32],
            zoom: (OBJECT_PX as f64 - 2.0 * margin_px) as f32 / part.width().max(part.height()) as f32,
        }
    }

    fn of(&self, point: [f32; 2]) -> [f32; 2] {
        let Placement { scale, middle, zoom } = self;
        [0, 1].map(|c: usize| 0.5 * OBJECT_PX as f32 + (point[c] * scale[c] - middle[c]) * zoom)
    }
}
