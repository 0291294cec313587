//! Where a wire of several drawings starts: arranging and bending them, what they show together, the voxel tree, its trail
//! and its circuit, the hull.

mod arrange;
mod back;
mod bend;
mod boxfit;
mod grid;
mod hull;
mod orientation;
mod pairing;
mod place;
mod plane;
mod routing;
mod shared;
mod shortcuts;
mod shortest;
pub(super) mod trail;
mod tree;

pub use arrange::{ArrangeOptions, Arrangement, Cutouts, Drawing, KEPT, Placement, Sharing, arrange};
pub use bend::{BendOptions, Bent, bend};
pub use boxfit::{BoxFit, fit_box};
pub use grid::Grid;
pub use hull::{Coverable, HullOptions, REPORT_ACROSS, coverable, hull_path, mean_share};
pub use orientation::Orientation;
pub use place::{edge_on, others, place};
pub use routing::{Circuit, CircuitOptions};
pub use trail::{TrailOptions, path_along};
pub use tree::{Tree, TreeOptions, grow_tree};

use super::Path;
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
