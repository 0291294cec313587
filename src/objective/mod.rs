//! What makes a wire good: image losses over a pyramid, regularisers of the curve, and targets that bend a little.

mod mmse;
mod net;
mod regularisers;
mod straight;
mod surface;
mod warp;

pub use mmse::{MultiscaleMse, Pyramid, level_sizes};
pub use regularisers::length_and_gradient;
pub use surface::surface_and_gradient;
pub use warp::{Displacement, Warp, WarpWeights};
