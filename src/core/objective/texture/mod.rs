//! Style without a model: statistics of a reference picture as a loss on what a view shows.
//!
//! At some levels of a pyramid, a steerable filter bank ([`jet`]) tells how strongly lines run in each of six directions
//! ([`features`]); the loss compares each direction's share, and how directions and ink go together at a place and some
//! pixels apart ([`statistics`]), with the reference's. That is the summary statistics of Portilla and Simoncelli (2000)
//! cut down to what a drawn line can follow. All statistics are normalised: a wire's lines are thinner and further
//! apart than a picture's, so the loss must ask for a pattern, not for more ink, which is the comparison with the
//! silhouette's business.

mod crops;
mod features;
mod jet;
mod loss;
#[cfg(feature = "gpu")]
pub mod packed;
mod statistics;

pub use crops::crop_weights;
pub use loss::{TextureGuidance, TextureLoss};

use crate::view::Image;
use crate::{Error, Result};
use statistics::Statistics;

/// What of a reference picture is taken.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct TextureOptions {
    /// Pixels of a view that a pixel of the picture covers: more makes the motif larger. 0.05 to 20.
    pub scale: f64,
    /// Halvings of the view before the first level that counts: 0 or 1 where lines are 2 to 4 px or 4 to 8 px apart.
    pub finest: usize,
    /// Levels that count, at most; fewer where the picture or the view is too small for the coarse ones.
    pub levels: usize,
}

impl Default for TextureOptions {
    fn default() -> Self {
        TextureOptions { scale: 1.0, finest: 1, levels: 3 }
    }
}

impl TextureOptions {
    /// For views of that height: levels from the first of at most 128 px on.
    pub fn for_view(height_px: usize) -> Self {
        let finest = (0..8).find(|&level| height_px >> level <= 128).unwrap_or(8);
        TextureOptions { finest, ..TextureOptions::default() }
    }
}

/// The statistics of a reference picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    finest: usize,
    levels: Vec<Level>,
}

/// One level's part in a texture.
#[derive(Debug, Clone, PartialEq)]
struct Level {
    statistics: Statistics<f64>,
    /// Mean amplitude, from which its share in the loss comes: the statistics of a level at which all is grey are noise.
    amplitude: f64,
}

impl Texture {
    /// The statistics of `picture`, ink 1 on ground 0; `name` is what the person calls it.
    ///
    /// # Errors
    /// [`Error::Picture`] if there are no lines in it or if it is too small at that scale, [`Error::Setting`] if the
    /// options are out of range.
    pub fn of(name: &str, picture: &Image, options: &TextureOptions) -> Result<Texture> {
        let &TextureOptions { scale, finest, levels } = options;
        if !(0.05..=20.0).contains(&scale) {
            return Err(Error::setting("style scale", format!("{scale}"), "choose 0.05 to 20"));
        }
        if levels == 0 || levels > 8 || finest > 8 {
            let problem = format!("{levels} levels from level {finest} on");
            return Err(Error::setting("style levels", problem, "choose 1 to 8 levels from one of 0 to 8 on"));
        }
        let sides = [picture.width, picture.height].map(|side| (side as f64 * scale).round() as usize);
        let least = loss::LEAST_PX << finest;
        if sides[0].min(sides[1]) < least || picture.data.len() != picture.width * picture.height {
            let problem = format!("{} x {} px of a view are too few for a style", sides[0], sides[1]);
            return Err(Error::picture(name, problem, format!("give a picture, or a scale, for {least} px or more")));
        }
        if sides[0].max(sides[1]) > MOST_PX {
            let problem = format!("{} x {} px of a view are too many for a style", sides[0], sides[1]);
            return Err(Error::picture(name, problem, format!("give a picture, or a scale, for up to {MOST_PX} px")));
        }
        let whole = [0.0, 0.0, picture.width as f64, picture.height as f64];
        let scaled = picture.window(whole, sides[0], sides[1]);
        let ink: Vec<f64> = scaled.data.iter().map(|&ink| if ink.is_finite() { f64::from(ink) } else { 0.0 }).collect();
        let levels = loss::survey(&ink, sides[0], sides[1], finest, levels);
        match levels {
            Some(levels) => Ok(Texture { finest, levels }),
            None => Err(Error::picture(name, "holds no lines to take a style from", "give a picture of a pattern")),
        }
    }

    /// How many levels it has statistics of.
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// The loss, at weight 1, of a picture that has the statistics of `other`.
    pub fn distance(&self, other: &Texture) -> f64 {
        let count = self.levels().min(other.levels());
        let levels = self.levels.iter().zip(&other.levels).zip(self.shares(count));
        levels.map(|((wanted, found), share)| share * found.statistics.distance(&wanted.statistics).0).sum()
    }

    /// The finest `count` levels' shares in the loss: those of their energy, the mean amplitude's square.
    fn shares(&self, count: usize) -> impl Iterator<Item = f64> {
        let levels = &self.levels[..count.min(self.levels.len())];
        let energy = |level: &Level| level.amplitude.powi(2);
        let whole: f64 = levels.iter().map(energy).sum();
        levels.iter().map(move |level| energy(level) / whole)
    }
}

/// The longest side of a reference picture, scaled.
const MOST_PX: usize = 4096;
