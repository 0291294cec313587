//! Small geometry that several rooms need.

mod sets;
mod triangle;

pub use sets::DisjointSets;
pub use triangle::nearest_on_triangle;
