//! Pictures of 16 bits, looked at before they are cut to 8: cameras of 12 bits and depths in millimetres use a small part of
//! the range, of which 8 bits would leave a few steps.

use image::DynamicImage;

/// What a picture's values mean.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Values {
    /// From black to white.
    Shades,
    /// Nearness or distance in any unit; 0 is nothing measured.
    Depths,
}

/// Shades that use less than this are spread over the whole range: a quarter, which 8 bits would leave 64 steps.
const NARROW: u16 = 1 << 14;
/// Depths beyond all but this share of them are errors of measurement.
const OUTLIERS: f64 = 5e-4;

/// Spreads the values of a picture of 16 bits over the whole range, in order; whether it has 16 bits.
pub fn spread(image: &mut DynamicImage, values: Values) -> bool {
    // Samples of a pixel, and how many of them are colour.
    let (samples, channels, colours): (&mut [u16], usize, usize) = match image {
        DynamicImage::ImageLuma16(image) => (image, 1, 1),
        DynamicImage::ImageLumaA16(image) => (image, 2, 1),
        DynamicImage::ImageRgb16(image) => (image, 3, 3),
        DynamicImage::ImageRgba16(image) => (image, 4, 3),
        _ => return false,
    };
    let depths = values == Values::Depths;
    let mut counts = vec![0usize; 1 << 16];
    for pixel in samples.chunks_exact(channels) {
        pixel[..colours].iter().for_each(|&value| counts[usize::from(value)] += 1);
    }
    if depths {
        counts[0] = 0;
    }
    let beyond = if depths { (OUTLIERS * counts.iter().sum::<usize>() as f64) as usize } else { 0 };
    let (Some(low), Some(high)) = (reached(counts.iter(), beyond), reached(counts.iter().rev(), beyond)) else {
        return true;
    };
    let high = u16::MAX - high;
    if !depths && high - low >= NARROW {
        return true;
    }
    // The least depth is still told from nothing.
    let first = if depths { 257.0 } else { 0.0 };
    let scale = (65_535.0 - first) / f64::from(high.saturating_sub(low).max(1));
    for pixel in samples.chunks_exact_mut(channels) {
        for value in pixel[..colours].iter_mut().filter(|value| !depths || **value > 0) {
            *value = (first + scale * (f64::from(*value) - f64::from(low))).round().clamp(first, 65_535.0) as u16;
        }
    }
    true
}

/// The first bin up to which there is more than `beyond`.
fn reached<'a>(counts: impl Iterator<Item = &'a usize>, beyond: usize) -> Option<u16> {
    let mut sum = 0;
    let mut found = counts.enumerate().map(|(bin, &count)| {
        sum += count;
        (bin, sum)
    });
    found.find(|&(_, sum)| sum > beyond).map(|(bin, _)| bin as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{ImageBuffer, Luma};

    fn spread_of(values: &[u16], kind: Values) -> Vec<u16> {
        let buffer = ImageBuffer::<Luma<u16>, _>::from_raw(values.len() as u32, 1, values.to_vec()).unwrap();
        let mut image = DynamicImage::ImageLuma16(buffer);
        assert!(spread(&mut image, kind));
        image.into_luma16().into_raw()
    }

    #[test]
    fn narrow_ranges_are_spread_and_others_stay() {
        assert_eq!(spread_of(&[300, 550, 800], Values::Shades), [0, 32_768, 65_535]);
        assert_eq!(spread_of(&[0, 40_000, 65_535], Values::Shades), [0, 40_000, 65_535]);
        assert_eq!(spread_of(&[7; 3], Values::Shades), [0; 3], "one value has no range");
        assert!(!spread(&mut DynamicImage::new_luma8(2, 2), Values::Depths));
    }

    #[test]
    fn depths_keep_zero_for_nothing_whatever_their_range() {
        assert_eq!(spread_of(&[0, 500, 750, 1000], Values::Depths), [0, 257, 32_896, 65_535]);
        assert_eq!(spread_of(&[0, 20_000, 60_000], Values::Depths), [0, 257, 65_535]);
        assert_eq!(spread_of(&[0; 3], Values::Depths), [0; 3]);
    }
}
