//! The core as the page's worker sees it: a wasm-bindgen façade and no maths.

use wasm_bindgen::prelude::*;

/// Panics become readable errors in the browser's console.
#[wasm_bindgen(start)]
fn start() {
    console_error_panic_hook::set_once();
}

/// This crate's version.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
