//! Whole fits of every task.

mod fill_runs;
#[cfg(feature = "files")]
mod preview;
#[cfg(feature = "files")]
mod quality;
mod resume;
#[cfg(feature = "files")]
mod stroke_pictures;
mod stroke_runs;
mod undrawn;
