//! Where a wire starts: arranging and bending drawings, the voxel tree, its trail and its circuit, hull and ball tours.

mod arrange;
mod back;
mod ball;
mod banded;
mod bend;
mod boxfit;
mod envelope;
mod field;
pub(crate) mod filling;
mod fit;
mod fitted;
mod grid;
mod hull;
mod lines;
mod pairing;
mod place;
mod placing;
mod plane;
mod routing;
mod shared;
mod shortcuts;
mod shortest;
mod solid;
#[cfg(test)]
mod testing;
mod tour;
mod trail;
mod tree;

pub use arrange::{ArrangeOptions, Arrangement, Cutouts, Drawing, Placement, arrange};
pub use ball::{ball_path, ball_points};
pub use bend::{BendOptions, Bent, bend};
pub use boxfit::{BoxFit, fit_box};
pub use filling::{FillOptions, Filling, Guide, Method, SPACINGS_WORLD, Wish, fill};
pub use fit::{length, resampled, wire_along, wire_with};
pub use fitted::{fit_error, fitted};
pub use grid::Grid;
pub use hull::{Coverable, HullOptions, REPORT_ACROSS, coverable, hull_path, mean_share};
pub use lines::{Hatching, LineOptions, Lines, Subject};
pub use place::place;
pub use placing::Orientation;
pub use routing::{Circuit, CircuitOptions};
pub use solid::{Solid, SolidOptions};
pub use tour::{greedy_tour, short_tour, tour_length};
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

use crate::error::Result;
use crate::view::Target;

/// The start for drawings: grows a tree through the box of `half_extents_world` and walks it.
/// `progress` is told how much is done (0 to 1) and stops the growth by returning false; what has grown is used.
///
/// # Errors
/// As [`Grid::new`] and [`grow_tree`].
pub fn tree_path(
    targets: &[Target],
    half_extents_world: [f64; 3],
    tree: &TreeOptions,
    trail: &TrailOptions,
    progress: &mut dyn FnMut(f32) -> bool,
) -> Result<Path> {
    let grid = Grid::new(targets, half_extents_world, tree.across)?;
    let tree = grow_tree(&grid, targets, tree, progress)?;
    Ok(path_along(&grid, &tree, trail))
}

/// The start for drawings as a closed wire that goes no way twice but where it must: grows a tree through the box of
/// `half_extents_world` and takes a circuit round it. `progress` as in [`tree_path`].
///
/// # Errors
/// As [`Grid::new`] and [`grow_tree`].
pub fn circuit_path(
    targets: &[Target],
    half_extents_world: [f64; 3],
    tree: &TreeOptions,
    circuit: &CircuitOptions,
    progress: &mut dyn FnMut(f32) -> bool,
) -> Result<Path> {
    let grid = Grid::new(targets, half_extents_world, tree.across)?;
    let tree = grow_tree(&grid, targets, tree, progress)?;
    Ok(Circuit::new(&grid, &tree, circuit).path(&grid, circuit))
}
