//! Views: cameras, projection with its adjoint and error bound, and the pictures seen through them.

mod camera;
mod flatten;
mod image;
mod spec;
mod structure;
mod visibility;

pub use camera::{Camera, Projection, View};
pub use flatten::{Flattening, PROJECTION_TOLERANCE_PX, pieces_per_span, projection_error_bound_px};
pub use image::{Image, MAX_PICTURE_PX, PixelBox};
pub use spec::{MAX_VIEW_PX, ViewSpec, parse_placed_picture};
pub use structure::StructureTensor;
pub use visibility::{LEAST_VISIBILITY, Occluder, drop_hidden};

/// A view and what it should show: the picture's ink as seen through that view.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The view; its size in pixels equals the ink's.
    pub view: View,
    /// Ink, 0 (ground) to 1 (ink).
    pub ink: Image,
}
