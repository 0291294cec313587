//! Where a wire starts: arranging and bending drawings, the voxel tree and its trail, hull and ball tours.

mod fit;
mod grid;
mod plane;
mod shortest;
mod trail;
mod tree;

pub use fit::{length, resampled};
pub use grid::Grid;
pub use trail::{TrailOptions, path_along};
pub use tree::{Tree, TreeOptions, grow_tree};

/// A polyline in the world to fit a wire to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// `[x, y, z, width]`, world units.
    pub points: Vec<[f64; 4]>,
    /// Whether the last point joins the first.
    pub closed: bool,
}
