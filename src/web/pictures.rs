//! Pictures on their way in, and ink on its way out.

use super::{json, parse_settings};
use crate::Result;
use crate::settings::Settings;
use crate::tasks::multiview::{Drawing, Plan};
use crate::view::{Image, Picture, View};
use wasm_bindgen::prelude::*;

/// Pictures for a run, in the order front, side, top.
#[wasm_bindgen]
#[derive(Default)]
pub struct PictureSet(Vec<Picture>);

#[wasm_bindgen]
impl PictureSet {
    /// None yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> PictureSet {
        PictureSet::default()
    }

    /// Adds straight (not premultiplied) RGBA, rows from the top.
    pub fn add(&mut self, name: &str, width: usize, height: usize, rgba: Vec<u8>) -> Result<(), JsError> {
        self.0.push(Picture::new(name, width, height, rgba)?);
        Ok(())
    }
}

impl PictureSet {
    pub(super) fn drawings(&self, settings: &Settings) -> Result<Vec<Drawing>> {
        self.0.iter().map(|picture| Drawing::new(picture, None, settings)).collect()
    }
}

/// What the core sees in a picture.
#[wasm_bindgen]
pub fn read_ink(name: &str, width: usize, height: usize, rgba: Vec<u8>, settings: &str) -> Result<Ink, JsError> {
    let picture = Picture::new(name, width, height, rgba)?;
    let drawing = Drawing::new(&picture, None, &parse_settings(settings)?)?;
    Ok(Ink::new(&drawing.ink))
}

/// One channel, 0 (ground) to 255 (ink).
#[wasm_bindgen]
#[derive(Clone)]
pub struct Ink {
    /// Pixels.
    #[wasm_bindgen(readonly)]
    pub width: usize,
    /// Pixels.
    #[wasm_bindgen(readonly)]
    pub height: usize,
    bytes: Vec<u8>,
}

impl Ink {
    pub(super) fn new(image: &Image) -> Ink {
        let bytes = image.data.iter().map(|&ink| (ink * 255.0).round() as u8).collect();
        Ink { width: image.width, height: image.height, bytes }
    }
}

#[wasm_bindgen]
impl Ink {
    /// Row by row from the top left.
    pub fn bytes(&self) -> Vec<u8> {
        self.bytes.clone()
    }
}

/// A view and the ink it should show.
#[wasm_bindgen]
#[derive(Clone)]
pub struct ViewTarget {
    /// Share of the drawing's ink that any object at all could show, 0 to 1.
    #[wasm_bindgen(readonly)]
    pub coverable: f32,
    /// Which of the run's pictures it is, from 0.
    #[wasm_bindgen(readonly)]
    pub source: usize,
    /// Whether that picture is seen mirrored.
    #[wasm_bindgen(readonly)]
    pub mirrored: bool,
    /// By how many quarters it is turned.
    #[wasm_bindgen(readonly)]
    pub quarter_turns: u8,
    view: View,
    ink: Ink,
}

impl ViewTarget {
    /// View `index` of a plan, with `image` as what it should show.
    pub(super) fn new(plan: &Plan, index: usize, image: &Image) -> ViewTarget {
        let placement = &plan.arrangement.placements[index];
        ViewTarget {
            coverable: plan.coverable[index].share,
            source: placement.source,
            mirrored: placement.orientation.mirrored,
            quarter_turns: placement.orientation.quarter_turns,
            view: plan.arrangement.targets[index].view.clone(),
            ink: Ink::new(image),
        }
    }
}

#[wasm_bindgen]
impl ViewTarget {
    /// The view as JSON, as in wire.json.
    pub fn view(&self) -> String {
        json(&self.view)
    }

    /// What it should show.
    pub fn ink(&self) -> Ink {
        self.ink.clone()
    }
}
