//! 3D models as people bring them: mesh files, read by what their bytes say and mended until a wire can cover them.

mod mend;
mod read;
mod sides;
mod weld;

pub use mend::Mended;
#[cfg(feature = "cli")]
pub use read::open_mesh;
pub use read::{MAX_MESH_BYTES, MAX_TRIANGLES, read_mesh};
