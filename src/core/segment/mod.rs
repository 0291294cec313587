//! What cutting an object out of a picture comes down to: least cuts of a grid, and mixtures of colours. Here since a person
//! waits for them at every stroke, and this crate is compiled for speed.

mod colours;
mod flow;

pub use colours::{Mixture, Palette};
pub use flow::{GridFlow, NEIGHBOURS};
