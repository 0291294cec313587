//! A wire as things to print: one solid, on a plate if wanted, and a jig to bend real wire in; as STL and 3MF.
//!
//! Lengths are millimetres. Everything stands as it does on a printer's bed: x to the right, y away from who looks at
//! the front, z up.

mod contour;
mod mesh;
mod solid;
mod strands;

pub use mesh::{Mesh, Part};
pub use solid::{Print, print};
pub use strands::{Gauge, Strands};
