//! What a person gives: drawings, with the sides they are seen from.

use crate::Result;
use crate::picture::cut::{Hints, SURE};
use crate::picture::{Because, Ground, Photo, Picture, Polarity, Reading, drawing, find_object, is_photograph};
use crate::settings::{Read, Settings};
use crate::start;
use crate::tasks::photo;
use crate::view::{Image, ViewSpec};

/// A drawing and, for views other than front, side and top, where it is seen from.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// File or pad name as the person knows it.
    pub name: String,
    /// Ink, 0 to 1, of any size and aspect.
    pub ink: Image,
    /// Where it is seen from; `None` takes the next of front, side, top.
    pub seen_from: Option<ViewSpec>,
}

impl Drawing {
    /// Finds the ink of a picture, dark or light as the settings say, or draws the lines of a photograph; and what was taken
    /// for its ground.
    ///
    /// # Errors
    /// As [`Reading::of`], and as [`Cutter::cut`](crate::picture::cut::Cutter::cut) for photographs.
    pub fn new(picture: &Picture, seen_from: Option<ViewSpec>, settings: &Settings) -> Result<(Drawing, Ground)> {
        if settings.read == Read::Lines || settings.read == Read::Auto && is_photograph(picture) {
            return Drawing::of_photo(picture, seen_from, settings);
        }
        let reading = Reading { polarity: settings.ink.into(), threshold: 0.0 };
        let (ink, ground) = reading.of_drawing(picture)?;
        Ok((Drawing { name: picture.name().to_owned(), ink, seen_from }, ground))
    }

    fn of_photo(picture: &Picture, seen_from: Option<ViewSpec>, settings: &Settings) -> Result<(Drawing, Ground)> {
        let (mask, sure) = if picture.is_cut_out() {
            (find_object(picture, None, 1)?.mask, 1.0)
        } else {
            let cut = photo::cut(picture, &Hints::default(), &mut None)?;
            (cut.mask, cut.sure)
        };
        let (near, mask) = photo::closer(picture, &mask).unwrap_or_else(|| (picture.clone(), mask));
        let photo = Photo::of(&near);
        let ink = drawing::ink(&photo::lines(&photo, &mask, settings), photo.width, photo.height);
        let because = if sure < SURE { Because::Doubtful } else { Because::Photograph };
        let drawing = Drawing { name: picture.name().to_owned(), ink, seen_from };
        Ok((drawing, Ground { polarity: Polarity::DarkInk, because }))
    }

    /// From ink as bytes, 0 (ground) to 255 (ink), row by row from the top left.
    ///
    /// # Errors
    /// As [`Image::from_bytes`].
    pub fn from_ink(name: &str, width: usize, height: usize, bytes: &[u8]) -> Result<Drawing> {
        let ink = Image::from_bytes(name, width, height, bytes)?;
        Ok(Drawing { name: name.to_owned(), ink, seen_from: None })
    }
}

/// Drawings as the start knows them.
pub(super) fn named(drawings: &[Drawing]) -> Vec<start::Drawing> {
    drawings.iter().map(|drawing| start::Drawing { name: drawing.name.clone(), ink: drawing.ink.clone() }).collect()
}
