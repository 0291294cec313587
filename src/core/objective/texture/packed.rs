//! A texture as lists of numbers, for an engine that computes the loss elsewhere.

use super::features::{self, steering};
use super::jet::kernels;
use super::loss::{average, level_count};
use super::statistics::{self, SHIFTS, Weights};
use super::{Statistics, Texture};

pub use super::features::{DIRECTIONS, FEATURES};
/// Pairs of features that are looked at in one go: of each shift and each first feature.
pub const BUNDLES: usize = SHIFTS.len() * FEATURES;
/// Numbers of a level's statistics: of directions, then of features together.
pub const STATISTICS: usize = DIRECTIONS + BUNDLES * FEATURES;

/// What does not depend on the texture, in the order of `shaders/texture.wgsl`: kernels, steering, thresholds, shifts.
pub fn constants() -> Vec<f32> {
    let kernels = kernels();
    let steering = steering();
    let thresholds = [features::FAINT, statistics::FAINT];
    let shifts = SHIFTS.iter().flat_map(|&(dx, dy)| [dx as f64, dy as f64]);
    let filters = kernels.as_flattened().iter().chain(steering.as_flattened()).chain(&thresholds).copied();
    filters.chain(shifts).map(|value| value as f32).collect()
}

/// The statistics of all levels.
pub fn wanted(texture: &Texture) -> Vec<f32> {
    let numbers = |statistics: &Statistics<f64>| -> Vec<f64> {
        [&statistics.directions[..], statistics.together.as_flattened().as_flattened()].concat()
    };
    texture.levels.iter().flat_map(|level| numbers(&level.statistics)).map(|value| value as f32).collect()
}

/// Halvings before each level that counts in a view, and its share in the loss.
pub fn levels(texture: &Texture, width: usize, height: usize) -> impl Iterator<Item = (usize, f32)> {
    let count = level_count(width, height, texture.finest, texture.levels());
    texture.shares(count).enumerate().map(|(level, share)| (texture.finest + level, share as f32))
}

/// The weights of the features' maps after so many halvings of `mask`.
pub fn weights(mask: &[f32], width: usize, height: usize, halvings: usize) -> Weights<f32> {
    let (mut values, mut size) = (mask.to_vec(), (width, height));
    for _ in 0..=halvings {
        let (below, from) = (values, size);
        size = (size.0 / 2, size.1 / 2);
        values = vec![0.0; size.0 * size.1];
        average(&below, from.0, &mut values, size.0);
    }
    let mut weights = Weights::new(size.0, size.1);
    weights.set(&values);
    weights
}
