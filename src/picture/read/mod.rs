//! Picture files: PNG, JPEG, WebP, GIF (its first picture), BMP and TIFF of 8 and 16 bits, turned upright as their EXIF
//! data say, and SVG drawings.

mod foreign;
mod jpeg;
mod levels;
mod svg;

use super::Picture;
use crate::files::read_at_most;
use crate::view::MAX_PICTURE_PX;
use crate::{Error, Result};
use image::{DynamicImage, GenericImageView, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};
use levels::Values;
use std::io::{self, Cursor};
use std::path::Path;

/// Largest file that is opened.
const MAX_FILE_BYTES: usize = 256 << 20;

/// Most memory a decoder may take, in bytes: a photo of 200 megapixels.
const MAX_DECODER_BYTES: u64 = 640 << 20;

const FORMATS: &str = "use a PNG, JPEG, WebP, GIF, BMP, TIFF or SVG picture";
const SMALLER: &str = "scale it down, 2048 px a side are plenty";

/// Reads and decodes a picture file. Large ones are averaged down to at most [`MAX_PICTURE_PX`] a side.
///
/// # Errors
/// [`Error::Picture`] if there is no such file, it is none of the formats, it is damaged or cut off, or too large;
/// the size is looked at before memory is taken for it.
pub fn read_picture(path: &Path) -> Result<Picture> {
    read(path, Values::Shades)
}

/// Reads a depth picture: of 16 bits, all the values that it uses become 1 to 255, and 0 stays 0, where nothing was measured.
///
/// # Errors
/// As [`read_picture`].
pub fn read_depth(path: &Path) -> Result<Picture> {
    read(path, Values::Depths)
}

/// Decodes the bytes of a picture file; `name` is for messages.
///
/// # Errors
/// As [`read_picture`].
pub fn decode_picture(name: &str, bytes: &[u8]) -> Result<Picture> {
    decode(name, bytes, Values::Shades)
}

fn read(path: &Path, values: Values) -> Result<Picture> {
    let name = path.display().to_string();
    let unreadable = |problem: io::Error| {
        Error::picture(&name, format!("cannot be read ({problem})"), "check the name and that you may read it")
    };
    if path.is_dir() {
        return Err(Error::picture(name, "is a folder", "give a picture file"));
    }
    match read_at_most(path, MAX_FILE_BYTES).map_err(unreadable)? {
        Some(bytes) => decode(&name, &bytes, values),
        None => {
            let problem = format!("is a file of more than {} MB", MAX_FILE_BYTES >> 20);
            Err(Error::picture(name, problem, "use a smaller picture, 2048 px a side are plenty"))
        }
    }
}

fn decode(name: &str, bytes: &[u8], values: Values) -> Result<Picture> {
    if bytes.is_empty() {
        return Err(Error::picture(name, "is an empty file", FORMATS));
    }
    if let Some((problem, remedy)) = foreign::named(bytes) {
        return Err(Error::picture(name, problem, remedy));
    }
    if svg::is_svg(bytes) {
        return svg::drawn(name, bytes);
    }
    let cut_off = || Error::picture(name, "is cut off", "save or download it again");
    let mut decoded = if image::guess_format(bytes).ok() == Some(ImageFormat::Jpeg) {
        match jpeg::extent(bytes) {
            jpeg::Extent::Whole(length) => decoded(name, &bytes[..length])?,
            // A decoder fills what is missing with grey, which would pass for a drawing. Where nothing is missing, it
            // does not matter what follows.
            jpeg::Extent::Unended => {
                let [one, other] = [0x55, 0xaa].map(|filler| decoded(name, &jpeg::ended(bytes, filler)));
                let (one, other) = (one?, other?);
                if one != other {
                    return Err(cut_off());
                }
                one
            }
            jpeg::Extent::Nothing => return Err(cut_off()),
        }
    } else {
        decoded(name, bytes)?
    };
    let measured = levels::spread(&mut decoded.0, values);
    let (image, orientation) = decoded;
    let (width, height) = image.dimensions();
    let factor = width.max(height).div_ceil(MAX_PICTURE_PX as u32);
    // In one go where it is large, without a copy of it in colour.
    let mut small = if factor > 1 { DynamicImage::from(averaged(&image, factor)) } else { image };
    small.apply_orientation(orientation);
    let turned = small.width() != width.div_ceil(factor);
    let given = if turned { [height, width] } else { [width, height] };
    let rgba = small.into_rgba8();
    let picture = Picture::new(name, rgba.width() as usize, rgba.height() as usize, rgba.into_raw())?;
    Ok(picture.as_given(given.map(|side| side as usize), measured))
}

/// A decoded picture of one of `image`'s formats and how it is to be turned.
fn decoded(name: &str, bytes: &[u8]) -> Result<(DynamicImage, image::metadata::Orientation)> {
    let failed = |problem: ImageError| match problem {
        ImageError::Unsupported(problem) if image::guess_format(bytes).is_ok() => {
            let problem = format!("is a picture of a kind that cannot be read ({problem})");
            Error::picture(name, problem, "save it as a PNG of 8 or 16 bits")
        }
        ImageError::Unsupported(_) => Error::picture(name, "is no picture that can be read", FORMATS),
        ImageError::Limits(_) => Error::picture(name, "needs more memory than allowed", SMALLER),
        problem => Error::picture(name, format!("is damaged or cut off ({problem})"), "save or download it again"),
    };
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_DECODER_BYTES);
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|problem| failed(ImageError::IoError(problem)))?;
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(failed)?;
    let (width, height) = decoder.dimensions();
    if width == 0 || height == 0 {
        return Err(Error::picture(name, "has no pixels", "choose another picture"));
    }
    if decoder.total_bytes() > MAX_DECODER_BYTES {
        return Err(Error::picture(name, format!("{width} x {height} px is more than can be read"), SMALLER));
    }
    // A picture whose EXIF data cannot be read is as it is.
    let orientation = decoder.orientation().unwrap_or(image::metadata::Orientation::NoTransforms);
    Ok((DynamicImage::from_decoder(decoder).map_err(failed)?, orientation))
}

/// Squares of `factor` pixels made one, colours weighted by their alpha.
fn averaged(image: &DynamicImage, factor: u32) -> image::RgbaImage {
    let (width, height) = image.dimensions();
    image::RgbaImage::from_fn(width.div_ceil(factor), height.div_ceil(factor), |x, y| {
        let (mut sums, mut count) = ([0u64; 4], 0u64);
        for v in y * factor..height.min((y + 1) * factor) {
            for u in x * factor..width.min((x + 1) * factor) {
                let [r, g, b, a] = image.get_pixel(u, v).0.map(u64::from);
                sums = [sums[0] + r * a, sums[1] + g * a, sums[2] + b * a, sums[3] + a];
                count += 1;
            }
        }
        let alpha = sums[3].max(1);
        let [r, g, b] = [0, 1, 2].map(|c| ((sums[c] + alpha / 2) / alpha) as u8);
        image::Rgba([r, g, b, ((sums[3] + count / 2) / count) as u8])
    })
}
