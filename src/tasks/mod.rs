//! What a person can ask for, each a short recipe that composes the rooms below.

mod engine;
pub mod fill;
mod fit;
pub mod multiview;
pub mod preview;
mod remedies;
mod run;
mod saved;
pub mod stroke;
mod widths;

pub use engine::place;
pub use run::{Job, Placed, Plan, Run};
