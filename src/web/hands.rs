//! What a hand does to a finished wire.

use wasm_bindgen::prelude::*;
use wire4d::Error;
use wire4d::sculpture::{Carried, Sculpture};
use wire4d::wire::{Edit, Edited};

/// A wire.json after an edit by hand.
#[wasm_bindgen]
pub struct EditedFile {
    file: Vec<u8>,
    held: usize,
    strayed: f64,
}

/// Does what `kind` says with control points `first` and `last` (from 0; the same one where there is but one), which a move puts to
/// `place` (x, y, z, full width, world units). How the wire was found no longer leads to it, and is left out.
#[wasm_bindgen]
pub fn edit_file(file: &[u8], kind: &str, first: usize, last: usize, place: &[f64]) -> Result<EditedFile, JsError> {
    let edit = match (kind, place) {
        ("move", &[x, y, z, width]) => Edit::Move { index: first, to: [x, y, z, width] },
        ("insert", _) => Edit::Insert { after: first },
        ("remove", _) => Edit::Remove { index: first },
        ("smooth", _) => Edit::Smooth { from: first, to: last },
        ("straighten", _) => Edit::Straighten { from: first, to: last },
        _ => return Err(Error::input("the edit", "is of no kind that is known", "reload the page").into()),
    };
    let mut sculpture = Sculpture::from_json("wire.json", file)?;
    let Edited { wire, held, strayed } = sculpture.wire.edited(&edit)?;
    sculpture.wire = wire;
    sculpture.carried.replay = Carried::default().replay;
    Ok(EditedFile { file: sculpture.to_json().into_bytes(), held, strayed })
}

#[wasm_bindgen]
impl EditedFile {
    /// The wire.json.
    pub fn file(&self) -> Vec<u8> {
        self.file.clone()
    }

    /// The control point that a hand would hold now, from 0.
    #[wasm_bindgen(getter)]
    pub fn held(&self) -> usize {
        self.held
    }

    /// How far the curve may have moved though nobody moved it, world units.
    #[wasm_bindgen(getter)]
    pub fn strayed(&self) -> f64 {
        self.strayed
    }
}
