//! Pictures for the repository, as small as PNG makes them.

use crate::Result;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{DynamicImage, GrayImage};
use std::path::Path;

/// Writes a picture in the slow, small way.
pub fn save(picture: &DynamicImage, path: &Path) -> Result {
    let file = std::fs::File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::Adaptive);
    picture.write_with_encoder(encoder).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The same in 16 greys, which is enough for lines and a fifth of the bytes.
pub fn save_lines(mut picture: GrayImage, path: &Path) -> Result {
    picture.pixels_mut().for_each(|pixel| pixel.0[0] = ((u16::from(pixel.0[0]) + 8) / 17 * 17) as u8);
    save(&picture.into(), path)
}
