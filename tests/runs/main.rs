//! Whole fits of every task.

mod fill_runs;
#[cfg(feature = "cli")]
mod preview;
#[cfg(feature = "cli")]
mod quality;
mod resume;
#[cfg(feature = "cli")]
mod stroke_pictures;
mod stroke_runs;
