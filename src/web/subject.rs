//! One picture and its object on their way in.

use crate::json;
use crate::pictures::Ink;
use wasm_bindgen::prelude::*;
use wire4d::picture::Picture;
use wire4d::picture::cut::SURE;
use wire4d::settings::{Preset, Settings, Task};
use wire4d::tasks::stroke::{Found, Given, find};
use wire4d::view::Image;

/// One picture for a run, and what a person says of it.
#[wasm_bindgen]
pub struct Subject(Given);

#[wasm_bindgen]
impl Subject {
    /// A picture of straight (not premultiplied) RGBA, rows from the top.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, width: usize, height: usize, rgba: Vec<u8>) -> Result<Subject, JsError> {
        Ok(Subject(Given::picture(Picture::new(name, width, height, rgba)?)))
    }

    /// What of it is the object, one byte a pixel, 0 (ground) to 255 (object), of any size.
    pub fn set_mask(&mut self, width: usize, height: usize, mask: &[u8]) -> Result<(), JsError> {
        self.0.mask = Some(Image::from_bytes("the mask", width, height, mask)?);
        Ok(())
    }

    /// A box round the object, px of the picture.
    pub fn set_bounds(&mut self, left: f64, top: f64, right: f64, bottom: f64) {
        self.0.bounds = Some([left, top, right, bottom]);
    }

    /// How near each pixel is: a picture of the same size, light is near; `measured` from values of 16 bits, it may be
    /// distances.
    pub fn set_depth(
        &mut self,
        name: &str,
        width: usize,
        height: usize,
        rgba: Vec<u8>,
        measured: bool,
    ) -> Result<(), JsError> {
        self.0.depth = Some(Picture::new(name, width, height, rgba)?.as_given([width, height], measured));
        Ok(())
    }
}

impl Subject {
    pub(crate) fn given(&self) -> &Given {
        &self.0
    }
}

/// The objects of a picture.
#[wasm_bindgen]
pub struct FoundObject(Found);

/// Finds the `object`th of a picture's objects, the largest first, from 1.
#[wasm_bindgen]
pub fn find_object(subject: &Subject, object: usize) -> Result<FoundObject, JsError> {
    let settings = Settings { object, ..Task::Stroke.preset(Preset::Best) };
    Ok(FoundObject(find(&subject.0, &settings)?))
}

#[wasm_bindgen]
impl FoundObject {
    /// How much of each pixel is the object; the picture's own aspect.
    pub fn mask(&self) -> Ink {
        Ink::new(&self.0.object.mask)
    }

    /// Which object each pixel of the mask's picture is of, the largest first, from 1; 0 is none.
    pub fn labels(&self) -> Vec<u8> {
        self.0.object.parts.labels.iter().map(|&label| u8::try_from(label).unwrap_or(0)).collect()
    }

    /// How many there are.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> usize {
        self.0.object.parts.shares.len()
    }

    /// Whether it is likely what a person would point at.
    #[wasm_bindgen(getter)]
    pub fn is_sure(&self) -> bool {
        self.0.sure >= SURE
    }

    /// What a person should know, as a JSON list of sentences.
    pub fn notes(&self) -> String {
        json(&self.0.object.notes)
    }
}
