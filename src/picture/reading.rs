//! How ink is read from a picture: which shade is ink, and from which strength on.

use super::{Ground, Ink, Picture, Polarity, ink};
use crate::view::Image;
use crate::{Error, Result};

/// What a person may say about a picture.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reading {
    /// Which shade is ink.
    pub polarity: Polarity,
    /// Least strength that counts as ink, above 0 up to 1, edges kept soft; 0 leaves tones as they are.
    pub threshold: f32,
}

/// Bare ground never becomes ink nor full ink ground, whatever the threshold.
const THRESHOLDS: [f32; 2] = [0.05, 0.95];
/// A picture with a greater share of ink has no ground to speak of.
const MOST_INKED: f64 = 0.985;
/// Least change of strength a pixel that an edge is taken to have: what changes less is flat and falls to one side.
const LEAST_SLOPE: f32 = 0.1;

/// Side of the pictures that drawings are fitted at unless something else is asked for, px.
const FIT_PX: usize = 256;

impl Reading {
    /// The ink of a drawing: as [`Reading::of`], with its thin lines kept through scaling down
    /// ([`Ink::with_hair_lines`](super::Ink::with_hair_lines)).
    ///
    /// # Errors
    /// As [`Reading::of`].
    pub fn of_drawing(&self, picture: &Picture) -> Result<(Image, Ground)> {
        let (ink, ground) = self.of(picture)?;
        Ok((ink.with_hair_lines(FIT_PX), ground))
    }

    /// The ink of a picture, 0 (ground) to 1 (ink), and its ground.
    ///
    /// # Errors
    /// As [`ink`]; [`Error::Setting`] for a threshold out of range; [`Error::Picture`] where it leaves nothing, or
    /// nothing but ink.
    pub fn of(&self, picture: &Picture) -> Result<(Image, Ground)> {
        if !(0.0..=1.0).contains(&self.threshold) {
            let problem = format!("{} is not a strength of ink", self.threshold);
            return Err(Error::setting("threshold", problem, "give a number from 0 to 1"));
        }
        let (mut image, ground) = ink(picture, self.polarity)?;
        if self.threshold > 0.0 {
            let [low, high] = THRESHOLDS;
            image = cut(&image, self.threshold.clamp(low, high));
            check(picture.name(), &image)?;
        }
        Ok((image, ground))
    }
}

/// Whether a threshold left both ink and ground.
fn check(name: &str, image: &Image) -> Result<()> {
    let inked = image.data.iter().filter(|&&value| value > 0.5).count();
    if inked == 0 {
        return Err(Error::picture(name, "no ink is as strong as the threshold", "lower the threshold"));
    }
    if inked as f64 > MOST_INKED * image.data.len() as f64 {
        return Err(Error::picture(name, "is inked all over above the threshold", "raise the threshold"));
    }
    Ok(())
}

/// Ink where the strength is at least `level`. The border runs where the strength passes the level, about one pixel
/// soft: how far a pixel is from there is its strength's distance from the level over the strength's slope.
fn cut(image: &Image, level: f32) -> Image {
    let (width, height) = (image.width, image.height);
    let slope = |low: usize, high: usize, apart: usize| (image.data[high] - image.data[low]) / apart.max(1) as f32;
    let mut out = Image::new(width, height);
    for (i, value) in out.data.iter_mut().enumerate() {
        let (x, y) = (i % width, i / width);
        let (left, right) = (x.saturating_sub(1), (x + 1).min(width - 1));
        let (above, below) = (y.saturating_sub(1), (y + 1).min(height - 1));
        let across = slope(y * width + left, y * width + right, right - left);
        let down = slope(above * width + x, below * width + x, below - above);
        *value = ((image.data[i] - level) / across.hypot(down).max(LEAST_SLOPE) + 0.5).clamp(0.0, 1.0);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 96;

    /// Strength of ink: a disc of full ink with an antialiased edge, and a pale line beside it.
    fn strength(x: usize, y: usize) -> f32 {
        let disc = (20.5 - (x as f32 + 0.5 - 30.0).hypot(y as f32 + 0.5 - 48.0)).clamp(0.0, 1.0);
        let pale = (60..84).contains(&x) && (47..49).contains(&y);
        disc.max(if pale { 0.4 } else { 0.0 })
    }

    fn picture(strength: impl Fn(usize, usize) -> f32) -> Picture {
        let grey = |i: usize| (255.0 * (1.0 - strength(i % SIDE, i / SIDE))).round() as u8;
        let rgba = (0..SIDE * SIDE).flat_map(|i| [grey(i), grey(i), grey(i), 255]).collect();
        Picture::new("Front", SIDE, SIDE, rgba).unwrap()
    }

    fn read(threshold: f32) -> Image {
        Reading { threshold, ..Reading::default() }.of(&picture(strength)).unwrap().0
    }

    #[test]
    fn strengths_fall_to_either_side_and_edges_stay_soft() {
        let tones = read(0.0);
        assert!((tones.at(72, 48) - 0.4).abs() < 0.03, "0 leaves tones: {}", tones.at(72, 48));
        let (low, high) = (read(0.2), read(0.6));
        assert_eq!((low.at(72, 48), high.at(72, 48)), (1.0, 0.0));
        for image in [&low, &high] {
            assert_eq!((image.at(30, 48), image.at(2, 2)), (1.0, 0.0));
            let soft = image.data.iter().filter(|&&value| value > 0.02 && value < 0.98).count();
            assert!((60..400).contains(&soft), "about a pixel all along the disc: {soft}");
        }
        // The disc keeps its area at the middle level and does not lose more than a soft edge at the ends.
        let area =
            |image: &Image| image.data[..].iter().enumerate().filter(|(i, _)| i % SIDE < 56).map(|(_, v)| v).sum();
        let whole: f32 = area(&tones);
        for (threshold, most) in [(0.5, 0.01), (0.05, 0.06), (1.0, 0.06)] {
            let found: f32 = area(&read(threshold));
            assert!((found / whole - 1.0).abs() < most, "{threshold}: {found} of {whole}");
        }
    }

    #[test]
    fn what_leaves_nothing_or_everything_is_refused_by_name() {
        let faint = picture(|x, y| 0.45 * f32::from(x.abs_diff(48) < 3 || y.abs_diff(48) < 3));
        let light = Reading { polarity: Polarity::LightInk, threshold: 0.5 };
        assert_eq!(light.of(&picture(strength)).unwrap().1.polarity, Polarity::LightInk);
        // Ink is stretched to full strength first, so even a faint cross is there at any threshold.
        assert!(Reading { threshold: 1.0, ..Reading::default() }.of(&faint).is_ok());
        for threshold in [-0.1, 1.1, f32::NAN] {
            let error = Reading { threshold, ..Reading::default() }.of(&faint).unwrap_err();
            assert!(matches!(error, Error::Setting { .. }), "{error:?}");
        }
        let filled = |share: f32| {
            let data = (0..1000).map(|i| f32::from((i as f32) < 1000.0 * share)).collect();
            check("Front", &Image { width: 100, height: 10, data }).map_err(|error| error.to_string())
        };
        assert_eq!(filled(0.5), Ok(()));
        assert_eq!(filled(0.0).unwrap_err(), "Front: no ink is as strong as the threshold; lower the threshold");
        assert_eq!(filled(1.0).unwrap_err(), "Front: is inked all over above the threshold; raise the threshold");
    }

    #[test]
    fn one_pixel_pictures_do_not_trip_it() {
        let image = Image { width: 1, height: 1, data: vec![0.7] };
        assert_eq!(cut(&image, 0.5).data, [1.0]);
    }
}
