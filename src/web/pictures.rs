//! Pictures and drawings on their way in, and ink on its way out.

use crate::json;
use wasm_bindgen::prelude::*;
use wire4d::picture::{Because, Picture, Polarity, Reading};
use wire4d::settings::{self, Settings};
use wire4d::tasks::Placed;
use wire4d::tasks::multiview::Drawing;
use wire4d::view::{Image, ViewSpec};

/// Drawings for a preview or a run, in the order front, side, top, and views that are drawn by nobody.
#[wasm_bindgen]
#[derive(Default)]
pub struct DrawingSet {
    drawings: Vec<Drawing>,
    guided: Vec<ViewSpec>,
}

#[wasm_bindgen]
impl DrawingSet {
    /// None yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> DrawingSet {
        DrawingSet::default()
    }

    /// Adds ink, one byte a pixel, 0 (ground) to 255 (ink), rows from the top.
    pub fn add(&mut self, name: &str, width: usize, height: usize, ink: &[u8]) -> Result<(), JsError> {
        self.drawings.push(Drawing::from_ink(name, width, height, ink)?);
        Ok(())
    }

    /// Adds a view, by its name, for a run to show that is guided there and compared with nothing.
    pub fn guide(&mut self, view: &str) -> Result<(), JsError> {
        self.guided.push(view.parse()?);
        Ok(())
    }
}

impl DrawingSet {
    pub(crate) fn drawings(&self) -> &[Drawing] {
        &self.drawings
    }

    pub(crate) fn guided(&self) -> &[ViewSpec] {
        &self.guided
    }
}

/// What the core sees in a picture of straight (not premultiplied) RGBA, rows from the top. `ink` is `auto`, `dark` or
/// `light`, `threshold` the least strength of ink, 0 to leave tones.
#[wasm_bindgen]
pub fn read_ink(
    name: &str,
    width: usize,
    height: usize,
    rgba: Vec<u8>,
    ink: &str,
    threshold: f32,
) -> Result<FoundInk, JsError> {
    let mut settings = Settings::default();
    settings.set("ink", ink)?;
    let picture = Picture::new(name, width, height, rgba)?;
    let (image, ground) = if settings.ink == settings::Ink::Auto && threshold == 0.0 {
        let (drawing, ground) = Drawing::new(&picture, None, &settings)?;
        (drawing.ink, ground)
    } else {
        Reading { polarity: Polarity::from(settings.ink), threshold }.of_drawing(&picture)?
    };
    let note = match ground.because {
        Because::Sheet | Because::Photograph | Because::Doubtful => ground.words(),
        _ => String::new(),
    };
    Ok(FoundInk { ink: Ink::new(&image), is_light: ground.polarity == Polarity::LightInk, note })
}

/// What the ink finder saw.
#[wasm_bindgen]
pub struct FoundInk {
    /// Whether the ink is lighter than its ground.
    #[wasm_bindgen(readonly)]
    pub is_light: bool,
    ink: Ink,
    note: String,
}

#[wasm_bindgen]
impl FoundInk {
    /// What a person should know of how it was found, or empty.
    pub fn note(&self) -> String {
        self.note.clone()
    }

    /// The ink.
    pub fn ink(&self) -> Ink {
        self.ink.clone()
    }
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
    pub(crate) fn new(image: &Image) -> Ink {
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
    placed: Placed,
    ink: Ink,
}

impl ViewTarget {
    /// A view with `image` as what it should show.
    pub(crate) fn new(placed: Placed, image: &Image) -> ViewTarget {
        ViewTarget { placed, ink: Ink::new(image) }
    }
}

#[wasm_bindgen]
impl ViewTarget {
    /// The view, as in wire.json, and how its drawing was laid into it, as JSON.
    pub fn placed(&self) -> String {
        json(&self.placed)
    }

    /// What it should show.
    pub fn ink(&self) -> Ink {
        self.ink.clone()
    }
}
