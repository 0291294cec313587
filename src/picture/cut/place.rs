//! What a box says of the places in it: objects are in its middle and reach near its sides, not into its corners.
//!
//! Boxes that people draw are tight (Lempitsky, Kohli, Rother and Sharp 2009), so a pixel's place alone tells something.
//! It counts little against colours that are of one side only, and decides where both sides have them.

/// How much the middle leans to the object, in the units of surprise.
const MIDDLE: f64 = 2.0;
/// Most that a corner leans to the ground: what fills its box to the corners is still found.
const CORNER: f64 = -1.0;
/// Where neither is likelier, share of the way from the box's middle to its sides, and the exponent of the round shape
/// that is so far away everywhere: between an ellipse and the box.
const EVEN: f64 = 0.85;
const ROUND: f64 = 3.0;
/// Boxes that come nearer to the picture's rim than this share of its longer side are meant to touch it, as hands shake.
const TOUCHING: f64 = 0.03;
/// By how much of its side an object that the rim cuts off may go on beyond it.
const BEYOND: f64 = 0.15;

/// Where a box's object is looked for.
pub struct Place {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Place {
    /// For a box (first columns and rows, and one past the last) in a picture that spans `frame`.
    pub fn new([left, top, right, bottom]: [usize; 4], frame: [usize; 4]) -> Place {
        let near = TOUCHING * (frame[2] - frame[0]).max(frame[3] - frame[1]) as f64;
        let axis = |low: usize, high: usize, first: usize, last: usize| {
            let (beyond, [low, high]) = (BEYOND * (high - low) as f64, [low as f64, high as f64]);
            let start = if low <= first as f64 + near { low - beyond } else { low };
            let end = if high + near >= last as f64 { high + beyond } else { high };
            (0.5 * (start + end), 0.5 * (end - start))
        };
        let (x, y) = (axis(left, right, frame[0], frame[2]), axis(top, bottom, frame[1], frame[3]));
        Place { middle: [x.0, y.0], half: [x.1, y.1] }
    }

    /// How much a place, px of the picture, leans to the object; below 0 to the ground.
    pub fn lean(&self, at: [f64; 2]) -> f32 {
        let off = [0, 1].map(|c: usize| ((at[c] - self.middle[c]).abs() / self.half[c]).powf(ROUND));
        let away = (off[0] + off[1]).powf(1.0 / ROUND);
        (MIDDLE * (1.0 - (away / EVEN).powi(2))).max(CORNER) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_leans_to_the_object_and_corners_to_the_ground() {
        let place = Place::new([100, 100, 300, 200], [0, 0, 512, 512]);
        assert_eq!(place.lean([200.0, 150.0]), MIDDLE as f32);
        assert!(place.lean([200.0, 110.0]) > 0.0 && place.lean([118.0, 150.0]) > 0.0);
        assert!(place.lean([105.0, 105.0]) < 0.0 && place.lean([0.0, 0.0]) == CORNER as f32);
        assert_eq!(place.lean([130.0, 120.0]), place.lean([270.0, 180.0]));
    }

    #[test]
    fn what_the_rim_cuts_off_goes_on_beyond_it() {
        let place = Place::new([100, 300, 300, 508], [0, 0, 512, 512]);
        assert!(place.lean([200.0, 508.0]) > 0.0 && place.lean([200.0, 302.0]) < 0.0);
    }
}
