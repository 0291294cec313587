//! One curve over a mesh, bent and thickened by a style.
//!
//! [`plan`] covers the mesh with one closed curve; [`Run::start`](super::Run::start) fits a wire of even width to it; the fit then looks at it
//! from other views every step. Each view asks for as much ink on the mesh's silhouette as the density says (the paper's
//! `α · mask`), more of it where the style's picture, laid on the surface, is dark, and for the texture of that picture.
//! Strands behind the surface are not seen, and all are held to it, so that what is seen and what is not stays clear.

mod asked;
mod first;
mod given;
mod looks;
mod motif;
mod plan;
pub(super) mod settings;
mod texture;

pub use given::{Given, Style};
pub use plan::{Plan, cover, plan, plan_over};
