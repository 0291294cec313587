//! Picture files: PNG (8 and 16 bits), JPEG and WebP, turned upright as their EXIF data say.

use super::{Picture, ink::check_size};
use crate::files::read_at_most;
use crate::{Error, Result};
use image::{DynamicImage, ImageDecoder, ImageError, ImageReader, Limits};
use std::io::{self, Cursor};
use std::path::Path;

/// Largest file that is opened.
const MAX_FILE_BYTES: usize = 256 << 20;

/// Most memory a decoder may take, in bytes.
const MAX_DECODER_BYTES: u64 = 512 << 20;

const FORMATS: &str = "use a PNG, JPEG or WebP picture";

/// Reads and decodes a picture file.
///
/// # Errors
/// [`Error::Picture`] if there is no such file, it is none of the formats, it is damaged or cut off, or too large;
/// the size is looked at before memory is taken for it.
pub fn read_picture(path: &Path) -> Result<Picture> {
    let name = path.display().to_string();
    let unreadable = |problem: io::Error| {
        Error::picture(&name, format!("cannot be read ({problem})"), "check the name and that you may read it")
    };
    if path.is_dir() {
        return Err(Error::picture(name, "is a folder", "give a picture file"));
    }
    match read_at_most(path, MAX_FILE_BYTES).map_err(unreadable)? {
        Some(bytes) => decode_picture(&name, &bytes),
        None => {
            let problem = format!("is a file of more than {} MB", MAX_FILE_BYTES >> 20);
            Err(Error::picture(name, problem, "use a smaller picture, 2048 px a side are plenty"))
        }
    }
}

/// Decodes the bytes of a picture file; `name` is for messages.
///
/// # Errors
/// As [`read_picture`].
pub fn decode_picture(name: &str, bytes: &[u8]) -> Result<Picture> {
    if bytes.is_empty() {
        return Err(Error::picture(name, "is an empty file", FORMATS));
    }
    let failed = |problem: ImageError| match problem {
        ImageError::Unsupported(_) => Error::picture(name, "is no picture that can be read", FORMATS),
        ImageError::Limits(_) => {
            Error::picture(name, "needs more memory than allowed", "scale it down, 2048 px a side are plenty")
        }
        problem => Error::picture(name, format!("is damaged or cut off ({problem})"), "save or download it again"),
    };
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_DECODER_BYTES);
    let mut reader = ImageReader::new(Cursor::new(bytes))
        .with_guessed_format()
        .map_err(|problem| failed(ImageError::IoError(problem)))?;
    reader.limits(limits);
    if reader.format() == Some(image::ImageFormat::Jpeg) && jpeg_is_cut_off(bytes) {
        return Err(Error::picture(name, "is cut off", "save or download it again"));
    }
    let mut decoder = reader.into_decoder().map_err(failed)?;
    let (width, height) = decoder.dimensions();
    check_size(name, width as usize, height as usize)?;
    if decoder.total_bytes() > MAX_DECODER_BYTES {
        let problem = format!("{width} x {height} px of this kind need more memory than allowed");
        return Err(Error::picture(name, problem, "scale it down, 2048 px a side are plenty"));
    }
    // A picture whose EXIF data cannot be read is as it is.
    let orientation = decoder.orientation().unwrap_or(image::metadata::Orientation::NoTransforms);
    let mut decoded = DynamicImage::from_decoder(decoder).map_err(failed)?;
    decoded.apply_orientation(orientation);
    let rgba = decoded.into_rgba8();
    let (width, height) = rgba.dimensions();
    Picture::new(name, width as usize, height as usize, rgba.into_raw())
}

/// Whether the last scan of a JPEG has no end marker. Decoders fill the rest with grey, which would pass for a drawing.
/// Inside scans 0xFF is always followed by 0 or a restart marker, so the two markers can be looked for as bytes.
fn jpeg_is_cut_off(bytes: &[u8]) -> bool {
    let scan = bytes.windows(2).rposition(|pair| pair == [0xff, 0xda]);
    scan.is_none_or(|at| !bytes[at..].windows(2).any(|pair| pair == [0xff, 0xd9]))
}
