//! A wire off the screen: whether it can be bent from real wire at a size and gauge, and how.
//!
//! Lengths are millimetres, and every place along the wire is its distance from the wire's start. The gauge is the
//! same everywhere, whatever widths the wire has on the screen.

mod bends;
mod centreline;
mod check;
mod close;
mod list;
mod metal;
mod paper;
mod seen;
mod steps;
mod stock;

#[cfg(test)]
#[path = "../core/few_cases.rs"]
mod few_cases;

pub use bends::{Bend, BendList, Piece};
pub use centreline::{Centreline, MAX_GAUGE_MM, MAX_SIZE_MM, MIN_GAUGE_MM, MIN_SIZE_MM};
pub use check::{Bends, Check, Clearance, MOST_LISTED, Meeting, Passing, Refit, Spot, TightBend};
pub use metal::Metal;
pub use paper::{Job, Paper};
pub use seen::Side;
pub use steps::{Step, steps};
pub use stock::{MIN_STOCK_MM, Pieces, Stock};
