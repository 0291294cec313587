//! Reading as the page's worker sees it: a module of its own, which hands over to the main one what it read.

use wasm_bindgen::prelude::*;
use wire4d_model::{Mended, Up};

/// A mesh from a file, read and mended.
#[wasm_bindgen]
pub struct MeshFile(Mended);

#[wasm_bindgen]
impl MeshFile {
    /// Reads a file; `name` is what the person calls it, and `up` the axis that points up in it: `y`, `z`, or nothing for
    /// what is usual for its kind.
    pub fn read(name: &str, file: &[u8], up: Option<String>) -> Result<MeshFile, JsError> {
        Ok(MeshFile(wire4d_model::read_mesh(name, file, up.as_deref().and_then(Up::named))?))
    }

    /// x, y, z of each corner, world units, again and again.
    pub fn positions(&self) -> Vec<f64> {
        self.0.mesh.positions().as_flattened().to_vec()
    }

    /// Three corners a triangle, counter-clockwise from outside.
    pub fn triangles(&self) -> Vec<u32> {
        self.0.mesh.triangles().as_flattened().to_vec()
    }

    /// What was mended about it, as a JSON list of sentences.
    pub fn notes(&self) -> String {
        serde_json::to_string(&self.0.notes).unwrap_or_default()
    }

    /// The axis that was taken for up: `y` or `z`.
    #[wasm_bindgen(getter)]
    pub fn up(&self) -> String {
        self.0.up.name().to_owned()
    }
}
