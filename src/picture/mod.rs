//! Pictures as people bring them: decoding, ink, masks, the object in a picture; patterns by formula.

mod colour;
pub mod cut;
mod cutout;
pub mod drawing;
mod ink;
mod kind;
mod mask;
mod object;
mod patterns;
mod photo;
#[cfg(feature = "files")]
mod read;
mod reading;
mod sheet;
mod spread;
mod strokes;
#[cfg(feature = "files")]
mod write;

pub use ink::{Because, Ground, MAX_PICTURE_PIXELS, Picture, Polarity, ink};
pub use kind::is_photograph;
pub use mask::{Components, Mask, NOWHERE};
pub use object::{Attention, JOINED_WITHIN, OBJECT_PX, Object, ObjectFinder, Outlined, Parts, find_object};
pub use patterns::Pattern;
pub use photo::{PHOTO_PX, Photo};
#[cfg(feature = "files")]
pub use read::{decode_picture, read_depth, read_picture};
pub use reading::Reading;
pub use strokes::Ink;
#[cfg(feature = "files")]
pub use write::{GreyDepth, encode_colour_png, encode_png, write_png};
