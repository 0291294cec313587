//! One picture to a wire that shows it from the front and still makes sense as it turns.
//!
//! [`plan`] finds the object, guesses the solid behind it and says what the wire should show from the front and from sides
//! drawn from the seed; [`Run::start`](super::Run::start) lays the first wire; the rest is as in [`super::multiview`].
//!
//! A wire is ink or blank, so a grey picture cannot be met: half the pixels of an even grey are wrong however it is
//! hatched, and the fit settles on strands that are nowhere. So the front's target is a picture of lines as wide as the
//! picture is dark ([`Lines`]). Nor can a wire fill a silhouette without spoiling the front, so each side's target is what
//! it shows of the same lines on the solid's surface, cut off at its silhouette. (A faint silhouette instead bends the
//! wire to and fro in depth: every strand then wants to hide behind another.) A start that knows no lines gets the faint
//! silhouette: inside it a blank pixel costs about as much as an inked one, while ink beside the solid costs the most.

mod depth;
mod drawn;
mod first;
mod given;
mod plan;
pub(super) mod settings;
mod sides;

pub use drawn::{Found, Kept, Sighted, find, look};
pub use given::Given;
pub use plan::{Plan, plan, plan_with};
