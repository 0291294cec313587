//! A finished wire: shown, measured, saved and shared.

use crate::json;
use crate::pictures::{Ink, ViewTarget};
use wasm_bindgen::prelude::*;
use wire4d::export::{self, Opened};
use wire4d::metrics::{ResultReport, elegance};
use wire4d::sculpture::Sculpture;
use wire4d::wire::Wire;

/// A wire as numbers.
#[wasm_bindgen]
pub struct WireData(pub(crate) Wire);

#[wasm_bindgen]
impl WireData {
    /// Whether the curve is periodic.
    #[wasm_bindgen(getter)]
    pub fn closed(&self) -> bool {
        self.0.closed()
    }

    /// Open: n + 4, clamped. Closed: n + 7.
    pub fn knots(&self) -> Vec<f64> {
        self.0.knots().to_vec()
    }

    /// x, y, z, width, again and again.
    pub fn control_points(&self) -> Vec<f32> {
        self.0.control_points().iter().flatten().map(|&c| c as f32).collect()
    }
}

/// A finished wire, from a run, a link or a file.
#[wasm_bindgen]
pub struct Made {
    sculpture: Sculpture,
    targets: Vec<ViewTarget>,
    shown: Vec<Ink>,
    result: ResultReport,
    /// The share code that it came with.
    code: Option<String>,
    /// What could not be read of the file it is from.
    notes: Vec<String>,
}

impl Made {
    pub(crate) fn new(sculpture: Sculpture, targets: Vec<ViewTarget>, result: ResultReport) -> Made {
        Made { sculpture, targets, shown: Vec::new(), result, code: None, notes: Vec::new() }
    }

    /// With what each view shows of it as the fit sees it.
    pub(crate) fn with_shown(self, shown: Vec<Ink>) -> Made {
        Made { shown, ..self }
    }

    /// Without drawings to compare with.
    fn alone(sculpture: Sculpture) -> Made {
        let result = ResultReport::measure(&sculpture, &[]);
        Made::new(sculpture, Vec::new(), result)
    }
}

#[wasm_bindgen]
impl Made {
    /// Opens what a link carries.
    pub fn from_share_code(code: &str) -> Result<Made, JsError> {
        Ok(Made { code: Some(code.to_owned()), ..Made::alone(export::open_share_code(code)?) })
    }

    /// Opens a file that carries a wire; `name` is what the person calls it.
    pub fn from_file(name: &str, file: &[u8]) -> Result<Made, JsError> {
        let Opened { sculpture, code, notes } = export::open_file(name, file)?;
        Ok(Made { code, notes, ..Made::alone(sculpture) })
    }

    /// What could not be read of what it was made of: a sentence each.
    pub fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// What a link carries: as it came, if it came with one.
    pub fn share_code(&self) -> String {
        self.code.clone().unwrap_or_else(|| export::share_code(&self.sculpture))
    }

    /// The wire.
    pub fn wire(&self) -> WireData {
        WireData(self.sculpture.wire.clone())
    }

    /// Its views as JSON, as in wire.json.
    pub fn views(&self) -> String {
        json(&self.sculpture.views)
    }

    /// The `result` part of report.json.
    pub fn result(&self) -> String {
        json(&self.result)
    }

    /// Where it fails, as JSON: see [`wire4d::metrics::Faults`].
    pub fn faults(&self) -> String {
        json(&elegance(&self.sculpture.wire).1)
    }

    /// Number of targets; none for a wire from a link.
    #[wasm_bindgen(getter)]
    pub fn target_count(&self) -> usize {
        self.targets.len()
    }

    /// A view's target.
    pub fn target(&self, index: usize) -> ViewTarget {
        self.targets[index].clone()
    }

    /// Number of pictures of what its views show; none where nothing hides any of it.
    #[wasm_bindgen(getter)]
    pub fn shown_count(&self) -> usize {
        self.shown.len()
    }

    /// What a view shows of it, in the order of the views.
    pub fn shown(&self, index: usize) -> Ink {
        self.shown[index].clone()
    }

    /// The wire.json file.
    pub fn file(&self) -> Vec<u8> {
        self.sculpture.to_json().into_bytes()
    }
}
