//! The wire and what moves it: everything an iteration needs, and nothing that knows pictures, files or people.
//!
//! It is a crate of its own so that the page's module can be small and its fits fast: this one is compiled for speed
//! where the rest is compiled for size. [`wire4d`](../wire4d/index.html) shows all of it under its own name and says what
//! the spaces and units are.

pub mod error;
pub mod rng;

pub mod mesh;
pub mod objective;
pub mod raster;
pub mod view;
pub mod wire;

pub mod optimize;

#[cfg(test)]
mod few_cases;

pub use error::{Error, Result};
