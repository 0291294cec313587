//! A photograph's object and the lines that are drawn of it.

use super::given::Given;
use crate::picture::cut::{Cut, Cutter};
use crate::picture::drawing::{Kind, Line};
use crate::picture::{
    Ink, JOINED_WITHIN, Mask, OBJECT_PX, Object, ObjectFinder, Outlined, PHOTO_PX, Photo, Picture, is_photograph,
};
use crate::settings::{Read, Settings, Shade, Shading};
use crate::start::Stroke;
use crate::tasks::photo;
use crate::view::{Image, PixelBox};
use crate::{Error, Result};

/// Whether lines are drawn, as of a photograph: where that is asked for, or it is one and nothing else is.
fn is_drawn(given: &Given, settings: &Settings, kept: &mut Kept) -> bool {
    match settings.read {
        Read::Lines => true,
        // The paper's own way is to fit the picture's greys.
        Read::Auto => {
            settings.shading == Shading::Lines
                && *kept.is_photograph.get_or_insert_with(|| is_photograph(&given.picture))
        }
        Read::Ink | Read::Tone => false,
    }
}

/// What was found in a picture.
pub struct Found {
    /// The object, with what makes it doubtful.
    pub object: Object,
    /// Whether its lines are drawn, as of a photograph; else it is filled.
    pub is_drawn: bool,
    /// How likely it is what a person would point at, 0 to 1; below [`SURE`](crate::picture::cut::SURE) better ask.
    pub sure: f32,
    /// The box (left, top, right, bottom, px of the picture) of which all lines are drawn, since no object was seen in it.
    pub unseen: Option<[f64; 4]>,
}

/// What is known of a picture from before, when it is looked at again and again. It changes nothing that is found.
#[derive(Default)]
pub struct Kept {
    cutter: Option<Cutter>,
    finder: Option<ObjectFinder>,
    is_photograph: Option<bool>,
}

impl Kept {
    pub(super) fn finder(&mut self, picture: &Picture) -> &ObjectFinder {
        self.finder.get_or_insert_with(|| ObjectFinder::new(picture))
    }

    /// At its working size.
    pub(super) fn photo(&mut self, picture: &Picture) -> &Photo {
        self.cutter.get_or_insert_with(|| Cutter::new(Photo::of(picture))).photo()
    }
}

/// Where an object was seen, without how it looks.
pub struct Sighted {
    /// Where it is, with what makes that doubtful.
    pub outlined: Outlined,
    /// See [`Found::sure`].
    pub sure: f32,
}

/// Finds the object: what the mask, the box or the strokes say, or what stands out.
///
/// # Errors
/// As [`find_object`], and as [`Cutter::cut`] for photographs and where there is a box or a stroke.
pub fn find(given: &Given, settings: &Settings) -> Result<Found> {
    find_with(given, settings, &mut Kept::default())
}

/// [`find`] with what is known of the picture.
pub(super) fn find_with(given: &Given, settings: &Settings, kept: &mut Kept) -> Result<Found> {
    let is_drawn = is_drawn(given, settings, kept);
    let cut = cut(given, settings, kept)?;
    let mask = cut.as_ref().map_or(given.mask.as_ref(), |cut| Some(&cut.mask));
    let mut object = kept.finder(&given.picture).object(mask, settings.object)?;
    let Some(Sure { sure, unseen, notes, .. }) = cut else {
        return Ok(Found { object, is_drawn, sure: 1.0, unseen: None });
    };
    object.notes.splice(0..0, notes);
    Ok(Found { object, is_drawn, sure, unseen })
}

/// Looks for what [`find`] finds, as quickly as a person draws.
///
/// # Errors
/// As [`find`].
pub fn look(given: &Given, settings: &Settings, kept: &mut Kept) -> Result<Sighted> {
    let cut = cut(given, settings, kept)?;
    let mask = cut.as_ref().map_or(given.mask.as_ref(), |cut| Some(&cut.mask));
    let mut outlined = kept.finder(&given.picture).outlined(mask, settings.object)?;
    let Some(Sure { sure, notes, .. }) = cut else { return Ok(Sighted { outlined, sure: 1.0 }) };
    outlined.notes.splice(0..0, notes);
    Ok(Sighted { outlined, sure })
}

/// A cut, with what is known of it.
struct Sure {
    mask: Image,
    sure: f32,
    unseen: Option<[f64; 4]>,
    notes: Vec<String>,
}

/// The object cut out, where it is to be.
fn cut(given: &Given, settings: &Settings, kept: &mut Kept) -> Result<Option<Sure>> {
    let picture = &given.picture;
    let is_pointed_at = given.bounds.is_some() || given.has_strokes();
    if given.mask.is_some() || !is_pointed_at && (picture.is_cut_out() || !is_drawn(given, settings, kept)) {
        return Ok(None);
    }
    let mut cut = match photo::cut(picture, &given.hints(), &mut kept.cutter) {
        Ok(cut) => cut,
        // A box in which no object is found still says what is meant.
        Err(Error::Picture { .. })
            if given.bounds.is_some() && !given.has_strokes() && is_drawn(given, settings, kept) =>
        {
            let [width, height] = [picture.width(), picture.height()].map(|side| side.min(PHOTO_PX));
            Cut { mask: Image::new(width, height), sure: 0.0, notes: Vec::new() }
        }
        Err(error) => return Err(error),
    };
    let is_missed = |bounds: &[f64; 4]| cut.sure < LEAST_SURE && !spans(&cut.mask, *bounds, picture);
    let unseen = given.bounds.filter(|bounds| is_missed(bounds) && is_drawn(given, settings, kept));
    if let Some(bounds) = unseen {
        let name = picture.name();
        cut.mask = filling(bounds, picture.width(), picture.height(), &cut.mask);
        cut.notes =
            vec![format!("{name}: cannot be told from its ground, so all lines in the box are drawn; a mask helps")];
    }
    if !given.object.is_empty() {
        keep_marked(&mut cut.mask, given);
    }
    Ok(Some(Sure { mask: cut.mask, sure: cut.sure, unseen, notes: cut.notes }))
}

/// Takes away the parts of a cut without a stroke on them, where the largest, which would be taken, is one of these.
fn keep_marked(mask: &mut Image, Given { picture, object, .. }: &Given) {
    let solid = mask.threshold(0.5);
    if solid.components().sizes.len() < 2 {
        return;
    }
    let parts = solid.dilated(0.5 * JOINED_WITHIN * mask.width.max(mask.height) as f32).components();
    let scale = [mask.width as f32 / picture.width() as f32, mask.height as f32 / picture.height() as f32];
    let label = |[x, y]: [f32; 2]| {
        let [column, row] = [(x * scale[0]).floor(), (y * scale[1]).floor()];
        let inside = column >= 0.0 && row >= 0.0 && column < mask.width as f32 && row < mask.height as f32;
        if inside { parts.labels[row as usize * mask.width + column as usize] } else { 0 }
    };
    let marked: Vec<u32> =
        object.iter().flat_map(|stroke| &stroke.points).map(|&point| label(point)).filter(|&label| label > 0).collect();
    let mut sizes = vec![0usize; parts.sizes.len()];
    solid.data.iter().zip(&parts.labels).filter(|(on, _)| **on).for_each(|(_, &label)| sizes[label as usize - 1] += 1);
    let largest = (1..).zip(&sizes).max_by_key(|(_, size)| **size).map_or(0, |(label, _)| label);
    if !marked.is_empty() && !marked.contains(&largest) {
        let is_gone = |label: u32| label > 0 && !marked.contains(&label);
        mask.data.iter_mut().zip(&parts.labels).filter(|(_, label)| is_gone(**label)).for_each(|(on, _)| *on = 0.0);
    }
}

/// A cut inside a box that is less sure than this, and in one piece spans less than this share of its sides, is not what was
/// meant.
const LEAST_SURE: f32 = 0.3;
const LEAST_SPAN: f64 = 0.6;

/// Whether the largest piece of a mask reaches across most of a box, px of the picture.
fn spans(mask: &Image, [left, top, right, bottom]: [f64; 4], picture: &Picture) -> bool {
    let solid = mask.threshold(0.5);
    let pieces = solid.components();
    let largest = pieces.sizes.iter().enumerate().max_by_key(|(_, size)| **size).map_or(0, |(k, _)| k as u32 + 1);
    let piece = Mask { data: pieces.labels.iter().map(|&label| label == largest).collect(), ..solid };
    let [across, down] = [mask.width as f64 / picture.width() as f64, mask.height as f64 / picture.height() as f64];
    piece.bounding_box().is_some_and(|piece| {
        piece.width() as f64 > LEAST_SPAN * across * (right - left)
            && piece.height() as f64 > LEAST_SPAN * down * (bottom - top)
    })
}

/// Exponent of the round shape that fills a box instead: between an ellipse and the box.
const ROUND: f64 = 3.0;

/// Something round that fills a box (px of a picture of `width` x `height`), of the size of another mask.
fn filling([left, top, right, bottom]: [f64; 4], width: usize, height: usize, like: &Image) -> Image {
    let [across, down] = [like.width as f64 / width as f64, like.height as f64 / height as f64];
    let from_middle = |place: f64, low: f64, high: f64| ((place - 0.5 * (low + high)) / (0.5 * (high - low))).abs();
    let inside = |i: usize| {
        let (x, y) = ((i % like.width) as f64 + 0.5, (i / like.width) as f64 + 0.5);
        let off = from_middle(x / across, left, right).powf(ROUND) + from_middle(y / down, top, bottom).powf(ROUND);
        if off < 1.0 { 1.0 } else { 0.0 }
    };
    Image { data: (0..like.data.len()).map(inside).collect(), ..*like }
}

/// The lines that a draughtsman would draw of the object of a photograph, px of its layers: a picture of [`OBJECT_PX`] in which the object
/// is laid with `margin_px` around it.
///
/// # Errors
/// [`Error::Picture`] where nothing can be drawn.
pub(super) fn strokes(
    photo: &Photo,
    object: &Object,
    unseen: Option<[f64; 4]>,
    margin_px: f64,
    settings: &Settings,
) -> Result<Vec<Stroke>> {
    let lines = match unseen {
        Some(bounds) => photo::lines_in(photo, bounds, settings),
        None => photo::lines(photo, &object.mask, settings),
    };
    let Some(part) = object.mask.threshold(0.5).bounding_box().filter(|_| !lines.is_empty()) else {
        return Err(Error::picture(&photo.name, "has no lines that could be drawn", "use a sharper picture"));
    };
    let longer = photo.width.max(photo.height) as f32;
    let place = Placement::new(&object.mask, photo, part, margin_px);
    let stroke = |line: Line| Stroke {
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
