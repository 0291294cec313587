//! Views: cameras, projection with its adjoint and error bound, and the pictures seen through them.

mod camera;
mod image;
mod mask;
mod spec;

pub use camera::{Camera, Projection, View};
pub use image::Image;
pub use mask::{Components, Mask, NOWHERE, PixelBox};
pub use spec::{MAX_VIEW_PX, ViewSpec, parse_placed_picture};

/// A view and what it should show: the picture's ink as seen through that view.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The view; its size in pixels equals the ink's.
    pub view: View,
    /// Ink, 0 (ground) to 1 (ink).
    pub ink: Image,
}
