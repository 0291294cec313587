//! How long a wire is beside the lines it was asked to draw.

use super::picture::report_size;
use crate::picture::{Ink, Mask};
use crate::view::{Image, View};
use std::f64::consts::SQRT_2;

/// Pixels of more ink than this are drawn.
const DRAWN: f32 = 0.5;

/// Length of the wire over the length of all pictures' middle lines, both in world units; `None` where there is nothing
/// drawn. Tracing the lines of each view once, and apart, would be 1.
pub fn length_over_lines<'a>(
    length_world: f64,
    pictures: impl IntoIterator<Item = (&'a Image, &'a View)>,
) -> Option<f64> {
    let lines: f64 = pictures.into_iter().map(|(picture, view)| middle_lines_world(picture, view)).sum();
    (lines > 0.0).then_some(length_world / lines)
}

/// Length of the middle lines of what is drawn in a picture, at 256 px, at the depth of the point `view` looks at.
fn middle_lines_world(picture: &Image, view: &View) -> f64 {
    let (width, height) = report_size(picture.width, picture.height);
    let middle = thinned(picture.resized(width, height).threshold(DRAWN));
    let [x, y, z] = view.target;
    let px_per_world: f64 = view.with_size(width, height).camera().pixels_per_world(&[x, y, z, 0.0]);
    steps_px(&middle) / px_per_world
}

/// Lines one pixel wide, or nearly, by peeling borders in parallel (Zhang and Suen 1984).
///
/// [`Mask::thin`] keeps parts and holes whole; this is what lengths of lines are commonly measured by.
fn thinned(mut mask: Mask) -> Mask {
    let mut going = Vec::new();
    loop {
        let mut went = false;
        for second in [false, true] {
            going.extend((0..mask.data.len()).filter(|&i| mask.data[i] && is_border(&ring(&mask, i), second)));
            went |= !going.is_empty();
            going.drain(..).for_each(|i| mask.data[i] = false);
        }
        if !went {
            return mask;
        }
    }
}

/// The eight neighbours, clockwise from the north; beyond the picture is ground.
fn ring(mask: &Mask, i: usize) -> [bool; 8] {
    let (x, y) = (i % mask.width, i / mask.width);
    [(1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1), (0, 0)].map(|(dx, dy)| {
        let (column, row) = (x + dx, y + dy);
        (1..=mask.width).contains(&column) && (1..=mask.height).contains(&row) && mask.at(column - 1, row - 1)
    })
}

/// Whether a pixel goes in the first or second half of a round.
fn is_border(ring: &[bool; 8], second: bool) -> bool {
    let inked = ring.iter().filter(|&&ink| ink).count();
    let begins = (0..8).filter(|&i| !ring[i] && ring[(i + 1) % 8]).count();
    let [north, east, south, west] = [0, 2, 4, 6].map(|i| ring[i]);
    let open = if second { !(north && west && (east || south)) } else { !(east && south && (north || west)) };
    (2..=6).contains(&inked) && begins == 1 && open
}

/// From pixel to pixel: 1 straight on, √2 across a corner that no straight steps go round.
fn steps_px(lines: &Mask) -> f64 {
    let mut length = 0.0;
    for i in (0..lines.data.len()).filter(|&i| lines.data[i]) {
        // Half of the neighbours, so that every pair counts once.
        let [_, _, east, south_east, south, south_west, west, _] = ring(lines, i);
        length += f64::from(u8::from(east)) + f64::from(u8::from(south));
        length += SQRT_2 * f64::from(u8::from(south_east && !east && !south));
        length += SQRT_2 * f64::from(u8::from(south_west && !west && !south));
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 256 px whose pixel is ink where `drawn` says so.
    fn picture(drawn: impl Fn(f64, f64) -> bool) -> Image {
        let mut image = Image::new(256, 256);
        for (i, value) in image.data.iter_mut().enumerate() {
            *value = f32::from(u8::from(drawn((i % 256) as f64 + 0.5, (i / 256) as f64 + 0.5)));
        }
        image
    }

    #[test]
    fn middle_lines_are_as_long_as_what_was_drawn() {
        let [view, ..] = View::canonical(2.56, 256);
        let long = |image: &Image| middle_lines_world(image, &view);
        for width in [3.0, 6.0] {
            let ring = picture(|x, y| ((x - 128.0).hypot(y - 128.0) - 80.0).abs() < width / 2.0);
            // Steps along a grid are up to 8% longer than a line, and thinning leaves some stairs.
            let ratio = long(&ring) / (1.6 * std::f64::consts::PI);
            assert!((1.0..1.15).contains(&ratio), "{ratio}");
            let bar = picture(|x, y| (y - 100.0).abs() < width / 2.0 && (40.0..200.0).contains(&x));
            assert!((long(&bar) - 1.6).abs() < 0.015 * width, "{}", long(&bar));
            let slant = picture(|x, y| (x - y).abs() < width / 2.0 && (40.0..200.0).contains(&x));
            assert!((long(&slant) - 1.6 * SQRT_2).abs() < 0.02 * width, "{}", long(&slant));
        }
        let bar = picture(|x, y| (y - 100.0).abs() < 3.0 && (40.0..200.0).contains(&x));
        assert!((long(&bar.resized(512, 512)) / long(&bar) - 1.0).abs() < 0.02, "whatever the size of the picture");
    }

    #[test]
    fn nothing_drawn_is_nothing_to_compare_with() {
        let [view, ..] = View::canonical(2.0, 256);
        assert_eq!(length_over_lines(3.0, []), None);
        assert_eq!(length_over_lines(3.0, [(&Image::new(256, 256), &view)]), None);
        let bar = picture(|x, y| (y - 100.0).abs() < 2.0 && (28.0..228.0).contains(&x));
        let twice = length_over_lines(3.0, [(&bar, &view), (&bar, &view)]).unwrap();
        assert!((2.0 * twice / length_over_lines(3.0, [(&bar, &view)]).unwrap() - 1.0).abs() < 1e-12);
    }
}
