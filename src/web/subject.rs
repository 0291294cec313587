//! One picture and its object on their way in.

use crate::json;
use crate::pictures::Ink;
use wasm_bindgen::prelude::*;
use wire4d::Result;
use wire4d::picture::Picture;
use wire4d::picture::cut::{SURE, Stroke};
use wire4d::settings::{Preset, Settings, Task};
use wire4d::tasks::stroke::{self, Given, Kept, Plan, Sighted, look};
use wire4d::view::Image;

/// One picture for a run or to be looked at again and again, and what a person says of it.
#[wasm_bindgen]
pub struct Subject {
    given: Given,
    /// What was learnt of the picture when it was looked at before.
    kept: Kept,
}

#[wasm_bindgen]
impl Subject {
    /// A picture of straight (not premultiplied) RGBA, rows from the top.
    #[wasm_bindgen(constructor)]
    pub fn new(name: &str, width: usize, height: usize, rgba: Vec<u8>) -> Result<Subject, JsError> {
        Ok(Subject { given: Given::picture(Picture::new(name, width, height, rgba)?), kept: Kept::default() })
    }

    /// What of it is the object, one byte a pixel, 0 (ground) to 255 (object), of any size.
    pub fn set_mask(&mut self, width: usize, height: usize, mask: &[u8]) -> Result<(), JsError> {
        self.given.mask = Some(Image::from_bytes("the mask", width, height, mask)?);
        Ok(())
    }

    /// A box round the object, px of the picture.
    pub fn set_bounds(&mut self, left: f64, top: f64, right: f64, bottom: f64) {
        self.given.bounds = Some([left, top, right, bottom]);
    }

    /// A stroke on the object or on its ground: x, y, x, y, … and half its width, px of the picture.
    pub fn add_stroke(&mut self, on_object: bool, points: &[f32], radius_px: f32) {
        let stroke = Stroke { points: points.chunks_exact(2).map(|point| [point[0], point[1]]).collect(), radius_px };
        let strokes = if on_object { &mut self.given.object } else { &mut self.given.ground };
        strokes.push(stroke);
    }

    /// Forgets what a person says of it: the mask, the box, the strokes and the depth.
    pub fn clear_hints(&mut self) {
        self.given.mask = None;
        self.given.bounds = None;
        self.given.object.clear();
        self.given.ground.clear();
        self.given.depth = None;
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
        self.given.depth = Some(Picture::new(name, width, height, rgba)?.as_given([width, height], measured));
        Ok(())
    }
}

impl Subject {
    pub(crate) fn plan(&mut self, settings: &Settings) -> Result<Plan> {
        stroke::plan_with(&self.given, settings, &mut self.kept)
    }
}

/// The objects of a picture.
#[wasm_bindgen]
pub struct FoundObject(Sighted);

/// Finds the `object`th of a picture's objects, the largest first, from 1.
#[wasm_bindgen]
pub fn find_object(subject: &mut Subject, object: usize) -> Result<FoundObject, JsError> {
    let settings = Settings { object, ..Task::Stroke.preset(Preset::Best) };
    Ok(FoundObject(look(&subject.given, &settings, &mut subject.kept)?))
}

#[wasm_bindgen]
impl FoundObject {
    /// How much of each pixel is the object; the picture's own aspect.
    pub fn mask(&self) -> Ink {
        Ink::new(&self.0.outlined.mask)
    }

    /// Which object each pixel of the mask's picture is of, the largest first, from 1; 0 is none.
    pub fn labels(&self) -> Vec<u8> {
        self.0.outlined.parts.labels.iter().map(|&label| u8::try_from(label).unwrap_or(0)).collect()
    }

    /// How many there are.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> usize {
        self.0.outlined.parts.shares.len()
    }

    /// Whether it is likely what a person would point at.
    #[wasm_bindgen(getter)]
    pub fn is_sure(&self) -> bool {
        self.0.sure >= SURE
    }

    /// What a person should know, as a JSON list of sentences.
    pub fn notes(&self) -> String {
        json(&self.0.outlined.notes)
    }
}
