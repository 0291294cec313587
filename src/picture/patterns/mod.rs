//! Style pictures by formula: drawn here, so that no foreign picture is shipped.

mod canvas;
mod garden;
mod script;
mod water;

use crate::view::Image;
use canvas::Canvas;

/// A style picture that repeats in both directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// Flowers with outlined petals and dark hearts, small ones between.
    Petals,
    /// Rings of waves on a heaving sea.
    Waves,
    /// Looping script of a broad nib.
    Calligraphy,
    /// Overlapping pointed scales with rays.
    Scales,
    /// Leaves on curling stems.
    Leaves,
}

impl Pattern {
    /// All of them, in the order people are shown.
    pub const ALL: [Pattern; 5] =
        [Pattern::Petals, Pattern::Waves, Pattern::Calligraphy, Pattern::Scales, Pattern::Leaves];

    /// A lower-case word.
    pub fn name(self) -> &'static str {
        match self {
            Pattern::Petals => "petals",
            Pattern::Waves => "waves",
            Pattern::Calligraphy => "calligraphy",
            Pattern::Scales => "scales",
            Pattern::Leaves => "leaves",
        }
    }

    /// The pattern with that [`Pattern::name`].
    pub fn named(word: &str) -> Option<Pattern> {
        Pattern::ALL.into_iter().find(|pattern| pattern.name() == word)
    }

    /// Its ink, 0 to 1, in a square of `size_px` that repeats in both directions; always the same.
    pub fn picture(self, size_px: usize) -> Image {
        let mut canvas = Canvas::new(size_px);
        match self {
            Pattern::Petals => garden::petals(&mut canvas),
            Pattern::Waves => water::waves(&mut canvas),
            Pattern::Calligraphy => script::calligraphy(&mut canvas),
            Pattern::Scales => water::scales(&mut canvas),
            Pattern::Leaves => garden::leaves(&mut canvas),
        }
        canvas.into_image()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_have_ink_and_ground_repeat_and_differ() {
        let pictures = Pattern::ALL.map(|pattern| pattern.picture(128));
        for (i, (pattern, picture)) in Pattern::ALL.iter().zip(&pictures).enumerate() {
            assert_eq!(Pattern::named(pattern.name()), Some(*pattern));
            assert!(picture.data.iter().all(|ink| (0.0..=1.0).contains(ink)));
            let mean = picture.data.iter().sum::<f32>() / picture.data.len() as f32;
            assert!((0.12..0.6).contains(&mean), "{}: {mean}", pattern.name());
            // The seam is no rougher than any other two neighbouring columns or rows.
            let column =
                |a: usize, b: usize| (0..128).map(|y| (picture.at(a, y) - picture.at(b, y)).abs()).sum::<f32>();
            let row = |a: usize, b: usize| (0..128).map(|x| (picture.at(x, a) - picture.at(x, b)).abs()).sum::<f32>();
            let most = (1..128).map(|i| column(i - 1, i).max(row(i - 1, i))).fold(0.0, f32::max);
            assert!(column(127, 0) <= most && row(127, 0) <= most, "{}", pattern.name());
            for other in &pictures[..i] {
                let apart = picture.data.iter().zip(&other.data).map(|(a, b)| (a - b).abs()).sum::<f32>();
                assert!(apart / picture.data.len() as f32 > 0.15);
            }
        }
        assert_eq!(Pattern::Waves.picture(0).data.len(), 0);
        assert_eq!(Pattern::Waves.picture(1).data.len(), 1);
    }
}
