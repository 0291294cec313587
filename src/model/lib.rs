//! 3D models as people bring them: mesh files, read by what their bytes say and mended until a wire can cover them.
//!
//! It is a crate of its own so that the page can fetch it when somebody brings a file, and not before.

mod mend;
mod read;
mod sides;
mod weld;

#[cfg(target_arch = "wasm32")]
mod web;

pub use mend::Mended;
pub use read::{MAX_MESH_BYTES, MAX_TRIANGLES, Up, read_mesh};

// Rooms below, by the names they have everywhere.
#[cfg(test)]
use wire4d_core::rng;
use wire4d_core::{Error, Result, mesh};
