//! A finished wire: shown, measured, saved and shared.

use super::json;
use super::pictures::ViewTarget;
use crate::export::{self, ExportOptions, Format};
use crate::metrics::ResultReport;
use crate::sculpture::Sculpture;
use crate::wire::Wire;
use wasm_bindgen::prelude::*;

/// A wire as numbers.
#[wasm_bindgen]
pub struct WireData(pub(super) Wire);

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

/// A finished wire, from a run or from a link.
#[wasm_bindgen]
pub struct Made {
    sculpture: Sculpture,
    targets: Vec<ViewTarget>,
    result: ResultReport,
}

impl Made {
    pub(super) fn new(sculpture: Sculpture, targets: Vec<ViewTarget>, result: ResultReport) -> Made {
        Made { sculpture, targets, result }
    }
}

#[wasm_bindgen]
impl Made {
    /// Opens what a link carries.
    pub fn from_share_code(code: &str) -> Result<Made, JsError> {
        let sculpture = export::open_share_code(code)?;
        let result = ResultReport::measure(&sculpture, &[]);
        Ok(Made { sculpture, targets: Vec::new(), result })
    }

    /// What a link carries.
    pub fn share_code(&self) -> String {
        export::share_code(&self.sculpture)
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

    /// Number of targets; none for a wire from a link.
    #[wasm_bindgen(getter)]
    pub fn target_count(&self) -> usize {
        self.targets.len()
    }

    /// A view's target.
    pub fn target(&self, index: usize) -> ViewTarget {
        self.targets[index].clone()
    }

    /// The tube as a GLB file.
    pub fn glb(&self) -> Result<Vec<u8>, JsError> {
        self.file(Format::Glb)
    }

    /// The wire.json file.
    pub fn wire_json(&self) -> Result<Vec<u8>, JsError> {
        self.file(Format::WireJson)
    }

    fn file(&self, format: Format) -> Result<Vec<u8>, JsError> {
        Ok(export::export(&self.sculpture, format, None, &ExportOptions::default())?)
    }
}
