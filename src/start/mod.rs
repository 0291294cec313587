//! Where a wire starts: from `drawings`, one `picture`, or a mesh (`filling`); and what they share: paths and wires along
//! them, tours, a ball.

mod ball;
mod banded;
mod drawings;
pub(crate) mod filling;
mod jitter;
mod least_squares;
mod path;
mod picture;
mod ring;
#[cfg(test)]
mod testing;
mod tour;

pub use ball::{ball_path, ball_points};
pub use drawings::*;
pub use filling::{FillOptions, Filling, Guide, Method, SPACINGS_WORLD, Wish, fill};
pub use jitter::jittered;
pub use least_squares::{fit_error, fitted};
pub use path::{length, resampled, wire_along, wire_with};
pub use picture::{Hatching, Layers, LineOptions, Lines, Solid, SolidOptions, Stroke};
pub use ring::ring_path;
pub use tour::{greedy_tour, short_tour, tour_length};

/// A polyline in the world to fit a wire to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// `[x, y, z, width]`, world units.
    pub points: Vec<[f64; 4]>,
    /// Whether the last point joins the first.
    pub closed: bool,
}
