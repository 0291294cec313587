//! The wire and what moves it: everything an iteration needs, and nothing that knows pictures, files or people.
//!
//! It is a crate of its own so that the page's module can be small and its fits fast: this one is compiled for speed
//! where the rest is compiled for size. [`wire4d`](../wire4d/index.html) shows all of it under its own name and says what
//! the spaces and units are.
//!
//! ```
//! use wire4d_core::optimize::{Problem, Recipe, Session};
//! use wire4d_core::view::{Image, Target, View};
//! use wire4d_core::wire::Wire;
//!
//! # fn main() -> wire4d_core::Result<()> {
//! // A line that is to be seen from the front, and a thinner wire near to it.
//! let mut ink = Image::new(64, 64);
//! (32..36).for_each(|row| (12..52).for_each(|column| ink.data[64 * row + column] = 1.0));
//! let [view, ..] = View::canonical(2.2, 64);
//! let points = (0..8).map(|i| [0.2 * f64::from(i) - 0.7, 0.0, 0.0, 0.05]).collect();
//! let mut recipe = Recipe::best();
//! recipe.set_iterations(200, 0.5);
//! let problem = Problem::for_drawings(Wire::open_uniform(points)?, vec![Target { view, ink }], recipe);
//! let mut session = Session::new(problem)?;
//! session.step(usize::MAX);
//! // Row 34 of 64 is a little below the middle, and four rows are .14 world units.
//! let [_, y, _, width] = session.best().evaluate(2.5);
//! assert!((y + 0.07).abs() < 0.02 && (width - 0.14).abs() < 0.03);
//! # Ok(())
//! # }
//! ```

pub mod error;
pub mod parallel;
pub mod rng;
pub mod sorting;
pub mod work;

pub mod geometry;
pub mod mesh;
pub mod objective;
pub mod raster;
pub mod segment;
pub mod view;
pub mod wire;

pub mod optimize;

#[cfg(test)]
mod few_cases;

pub use error::{Error, Result};
