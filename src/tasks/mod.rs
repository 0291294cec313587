//! What a person can ask for, a folder a task: what is given, what is decided before a fit ([`Plan`]), its settings. The
//! rest is the same for all: a [`Run`] starts or resumes a plan, steps, saves, measures and reports.

mod engine;
pub mod fill;
pub mod multiview;
mod photo;
mod plan;
mod recipe;
mod run;
mod saved;
mod settings;
pub mod stroke;
mod trail;
mod widths;

#[cfg(all(feature = "gpu", target_arch = "wasm32"))]
pub use engine::browser_device;
pub use engine::place;
pub use plan::{Placed, Plan};
pub use run::Run;
