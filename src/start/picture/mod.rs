//! Where a wire of one picture starts: the solid behind it, its lines and a walk along them.

mod envelope;
mod lines;
mod solid;

pub use lines::{Hatching, Layers, LineOptions, Lines, Stroke};
pub use solid::{Solid, SolidOptions};
