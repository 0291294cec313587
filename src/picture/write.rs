//! Grey PNG files of one-channel pictures: coverage and targets, ink white.

use crate::view::Image;
use crate::{Error, Result, files::write_whole};
use image::{ImageBuffer, ImageFormat, Luma, Rgb};
use std::{io::Cursor, path::Path};

/// Grey levels a PNG file has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GreyDepth {
    /// 256: small files to look at.
    Bits8,
    /// 65,536: coverage to measure with.
    Bits16,
}

/// The bytes of a grey PNG, 0 black and 1 white; values beyond are clamped.
///
/// # Errors
/// [`Error::Output`] for a picture without pixels; `name` is for the message.
pub fn encode_png(name: &str, picture: &Image, depth: GreyDepth) -> Result<Vec<u8>> {
    let fail = |problem: &str| Error::output(name, problem, "render at 1 to 8192 px a side");
    let (Ok(width), Ok(height)) = (u32::try_from(picture.width), u32::try_from(picture.height)) else {
        return Err(fail("is too large for a PNG"));
    };
    let level = |value: f32, white: f32| (value.clamp(0.0, 1.0) * white).round();
    let mut bytes = Cursor::new(Vec::new());
    let written = match depth {
        GreyDepth::Bits8 => {
            let levels: Vec<u8> = picture.data.iter().map(|&value| level(value, 255.0) as u8).collect();
            ImageBuffer::<Luma<u8>, _>::from_raw(width, height, levels)
                .map(|buffer| buffer.write_to(&mut bytes, ImageFormat::Png))
        }
        GreyDepth::Bits16 => {
            let levels: Vec<u16> = picture.data.iter().map(|&value| level(value, 65_535.0) as u16).collect();
            ImageBuffer::<Luma<u16>, _>::from_raw(width, height, levels)
                .map(|buffer| buffer.write_to(&mut bytes, ImageFormat::Png))
        }
    };
    match written {
        Some(Ok(())) => Ok(bytes.into_inner()),
        Some(Err(problem)) => Err(fail(&format!("cannot be encoded ({problem})"))),
        None => Err(fail("has fewer values than pixels")),
    }
}

/// The bytes of a PNG in colours: `rgb` has 3 bytes a pixel, sRGB, rows from the top.
///
/// # Errors
/// As [`encode_png`].
pub fn encode_colour_png(name: &str, [width, height]: [usize; 2], rgb: Vec<u8>) -> Result<Vec<u8>> {
    let fail = |problem: &str| Error::output(name, problem, "render at 1 to 8192 px a side");
    let mut bytes = Cursor::new(Vec::new());
    let buffer = match (u32::try_from(width), u32::try_from(height)) {
        (Ok(width), Ok(height)) => ImageBuffer::<Rgb<u8>, _>::from_raw(width, height, rgb),
        _ => None,
    };
    let buffer = buffer.ok_or_else(|| fail("has fewer values than pixels"))?;
    buffer.write_to(&mut bytes, ImageFormat::Png).map_err(|problem| fail(&format!("cannot be encoded ({problem})")))?;
    Ok(bytes.into_inner())
}

/// Writes a grey PNG whole or not at all.
///
/// # Errors
/// [`Error::Output`] as [`encode_png`] and [`write_whole`].
pub fn write_png(path: &Path, picture: &Image, depth: GreyDepth) -> Result<()> {
    write_whole(path, &encode_png(&path.display().to_string(), picture, depth)?)
}
