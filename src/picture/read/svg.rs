//! SVG drawings, as they are without fonts and other files: the same on every machine.

use super::super::Picture;
use crate::{Error, Result};
use resvg::{tiny_skia, usvg};

/// Longer side of the picture drawn, px.
const SIDE_PX: f32 = 1024.0;
/// Largest SVG that is drawn.
const MAX_BYTES: usize = 16 << 20;

/// Whether a file is an SVG: XML whose first element is `svg`, or that packed by gzip.
pub fn is_svg(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let text = text.trim_start_matches('\u{feff}').trim_start();
    bytes.starts_with(b"\x1f\x8b") || text.starts_with('<') && text.contains("<svg")
}

/// Draws it, its longer side [`SIDE_PX`]. What is not drawn stays transparent.
///
/// # Errors
/// [`Error::Picture`] if it is no SVG after all, too large, or all of it is text, whose fonts are not in the file.
pub fn drawn(name: &str, bytes: &[u8]) -> Result<Picture> {
    let fail = |problem: String, remedy: &str| Err(Error::picture(name, problem, remedy));
    if bytes.len() > MAX_BYTES {
        return fail(format!("is an SVG of more than {} MB", MAX_BYTES >> 20), "save it as a PNG picture");
    }
    let image_href_resolver =
        usvg::ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = usvg::Options { image_href_resolver, ..usvg::Options::default() };
    let tree = match usvg::Tree::from_data(bytes, &options) {
        Ok(tree) => tree,
        Err(problem) => {
            return fail(format!("is no SVG that can be read ({problem})"), "save it again, or as a PNG picture");
        }
    };
    let text = bytes.windows(5).any(|part| part == b"<text");
    if tree.root().children().is_empty() {
        return if text {
            fail("has words and no lines".into(), "convert its text to paths, since its fonts are not in it")
        } else {
            fail("shows nothing".into(), "save it again, or as a PNG picture")
        };
    }
    let size = tree.size();
    let scale = SIDE_PX / size.width().max(size.height());
    let side = |length: f32| ((length * scale).round() as u32).clamp(1, SIDE_PX as u32);
    let (width, height) = (side(size.width()), side(size.height()));
    let Some(mut pixels) = tiny_skia::Pixmap::new(width, height) else {
        return fail("has no size".into(), "save it again, or as a PNG picture");
    };
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixels.as_mut());
    let rgba = pixels.pixels().iter().flat_map(|pixel| {
        let colour = pixel.demultiply();
        [colour.red(), colour.green(), colour.blue(), colour.alpha()]
    });
    let picture = Picture::new(name, width as usize, height as usize, rgba.collect())?;
    Ok(if text { picture.noted("its words are left out; convert text to paths to have them") } else { picture })
}
