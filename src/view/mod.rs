//! Views: cameras, projection with its adjoint and error bound, and the pictures seen through them.

mod camera;
mod flatten;
mod image;
mod mask;
mod object;
mod patterns;
mod picture;
#[cfg(feature = "cli")]
mod read;
mod reading;
mod spec;
mod stroke_width;
mod visibility;
#[cfg(feature = "cli")]
mod write;

pub use camera::{Camera, Projection, View};
pub use flatten::{Flattening, PROJECTION_TOLERANCE_PX, pieces_per_span, projection_error_bound_px};
pub use image::Image;
pub use mask::{Components, Mask, NOWHERE, PixelBox};
pub use object::{OBJECT_PX, Object, Parts, find_object};
pub use patterns::Pattern;
pub use picture::{MAX_PICTURE_PIXELS, MAX_PICTURE_PX, Picture, Polarity, ink};
#[cfg(feature = "cli")]
pub use read::{decode_picture, read_picture};
pub use reading::Reading;
pub use spec::{MAX_VIEW_PX, ViewSpec, parse_placed_picture};
pub use visibility::{LEAST_VISIBILITY, Occluder, drop_hidden};
#[cfg(feature = "cli")]
pub use write::{GreyDepth, encode_png, write_png};

/// A view and what it should show: the picture's ink as seen through that view.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// The view; its size in pixels equals the ink's.
    pub view: View,
    /// Ink, 0 (ground) to 1 (ink).
    pub ink: Image,
}
