//! Writing as the page's worker sees it: a module of its own, which takes wires as wire.json files.

use wasm_bindgen::prelude::*;
use wire4d::export::{self, ExportOptions, Format};
use wire4d::mesh::Mesh;
use wire4d::sculpture::Sculpture;
use wire4d::{Error, Result};

/// A wire.json as a file of another format, by its ending; `view` is the name of the view that an SVG shows, without what is
/// behind the solid of these triangles: x, y, z of each corner, world units, and three corners a triangle, or nothing.
#[wasm_bindgen]
pub fn export_file(
    file: &[u8],
    format: &str,
    view: &str,
    positions: &[f32],
    triangles: &[u32],
) -> Result<Vec<u8>, JsError> {
    let corners = positions.as_chunks().0.iter().map(|&corner: &[f32; 3]| corner.map(f64::from)).collect();
    let solid = match triangles {
        [] => None,
        triangles => Some(Mesh::new("the shape", corners, triangles.as_chunks().0.to_vec())?),
    };
    Ok(exported(file, format, view, solid.as_ref())?)
}

/// A PNG picture of the wire of a wire.json, with all that this has: it opens again.
#[wasm_bindgen]
pub fn picture_with_wire(picture: &[u8], file: &[u8]) -> Result<Vec<u8>, JsError> {
    Ok(export::in_png(picture, &opened(file)?)?)
}

/// A wire.json made simpler, for a link of at most so many characters: as JSON, see [`export::Simplified`]. Nothing where it
/// cannot be.
#[wasm_bindgen]
pub fn simplify(file: &[u8], characters: usize) -> Result<Option<String>, JsError> {
    let simplified = export::simplified_code(&opened(file)?, characters);
    Ok(simplified.map(|simplified| serde_json::to_string(&simplified).unwrap_or_default()))
}

fn opened(file: &[u8]) -> Result<Sculpture> {
    Sculpture::from_json("wire.json", file)
}

fn exported(file: &[u8], format: &str, view: &str, solid: Option<&Mesh>) -> Result<Vec<u8>> {
    let sculpture = opened(file)?;
    let format = Format::from_path(&format!("wire.{format}"))?;
    let drawn = sculpture.views.iter().find(|known| known.name == view);
    if format.draws_a_view() && drawn.is_none() && !sculpture.views.is_empty() {
        let names: Vec<&str> = sculpture.views.iter().map(|view| view.name.as_str()).collect();
        let problem = format!("the wire has no view {view:?}");
        return Err(Error::setting("view", problem, format!("give one of {}", names.join(", "))));
    }
    export::export(&sculpture, format, drawn, solid, &ExportOptions::default())
}
