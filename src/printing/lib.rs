//! A wire as things to print: one solid, on a plate if wanted, and a jig to bend real wire in; as STL and 3MF.
//!
//! Lengths are millimetres. Everything stands as it does on a printer's bed: x to the right, y away from who looks at
//! the front, z up.

mod body;
mod contour;
mod jig;
mod letters;
mod mesh;
mod plate;
mod solid;
mod stl;
mod strands;
mod three_mf;

pub use jig::{Jig, Printer, jig};
pub use mesh::{Mesh, Part};
pub use plate::Plate;
pub use solid::{Print, print};
pub use stl::stl;
pub use strands::{Gauge, Strands};
pub use three_mf::three_mf;
