//! Two, three or more drawings to one wire that shows each from its own side.
//!
//! [`plan`] arranges the drawings and says what any object could show of them; [`Run::start`](super::Run::start) grows the first wire;
//! [`Run::step`](super::Run::step) fits it; its `sculpture` and `report` give what came of it.

mod given;
mod plan;
pub mod preview;
mod remedies;
pub(super) mod settings;

pub use given::Drawing;
pub use plan::{Plan, plan, plan_with};
