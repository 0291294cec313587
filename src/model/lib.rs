//! 3D models as people bring them: mesh files, read by what their bytes say and mended until a wire can cover them.
//!
//! It is a crate of its own so that the page can fetch it when somebody brings a file, and not before: `src/web/meshes`
//! makes a module of it.

mod mend;
mod read;
mod sides;
mod weld;

pub use mend::Mended;
pub use read::{MAX_MESH_BYTES, MAX_TRIANGLES, Up};

// Rooms below, by the names they have everywhere.
#[cfg(test)]
use wire4d_core::rng;
use wire4d_core::{Error, Result, mesh};

/// Reads and mends a mesh: OBJ, STL (binary or text), PLY (binary or text), 3MF, glTF or GLB with all data inside.
/// `name` is the file's name as the person knows it; `up` the axis that points up, by default z for STL and 3MF and y for
/// the others. Polygons are cut into triangles; a glTF is read as a viewer shows it before anything moves; colours and the
/// like are ignored.
///
/// # Errors
/// [`Error::Input`] for what is none of these or is damaged, for more than [`MAX_TRIANGLES`] or [`MAX_MESH_BYTES`], for
/// numbers that are not finite, for what a file says it needs and is not read here, and as mending does for meshes
/// without an area.
///
/// # Examples
/// ```
/// # fn main() -> wire4d_core::Result<()> {
/// let file = b"v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
/// let read = wire4d_model::read_mesh("tetrahedron.obj", file, None)?;
/// assert_eq!((read.mesh.triangles().len(), read.open_edges), (4, 0));
/// # Ok(())
/// # }
/// ```
pub fn read_mesh(name: &str, bytes: &[u8], up: Option<Up>) -> Result<Mended> {
    let (soup, up) = read::read(name, bytes, up)?;
    mend::mend(name, soup, up)
}
