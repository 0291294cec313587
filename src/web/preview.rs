//! What a person should know before a run.

use crate::pictures::{DrawingSet, Ink};
use crate::{json, parse_settings};
use wasm_bindgen::prelude::*;
use wire4d::settings::Task;
use wire4d::tasks::multiview::preview;

/// What two or three drawings come to before a run.
#[wasm_bindgen]
pub struct Preview(preview::Preview);

#[wasm_bindgen]
impl Preview {
    /// Looks at drawings with settings (a JSON object of texts by name).
    pub fn of(drawings: &DrawingSet, settings: &str) -> Result<Preview, JsError> {
        Ok(Preview(preview::preview(drawings.drawings(), &parse_settings(Task::Multiview, settings)?)?))
    }

    /// Everything but the pictures, as JSON.
    pub fn words(&self) -> String {
        json(&self.0)
    }

    /// Drawing `index` as the fit will see it.
    pub fn seen(&self, index: usize) -> Ink {
        Ink::new(&self.0.drawings[index].seen)
    }

    /// The part of it that no object can show together with the other drawings.
    pub fn missing(&self, index: usize) -> Ink {
        Ink::new(&self.0.drawings[index].missing)
    }
}
