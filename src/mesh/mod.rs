//! Triangle meshes: what a wire covers.

use crate::{Error, Result};

/// Triangles in the world, fit to be covered: the mesh lies in the unit ball, indices are in range, every triangle has
/// three different corners and an area.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    positions: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// From corners in world units and triangles, counter-clockwise as seen from outside.
    ///
    /// # Errors
    /// [`Error::Input`] naming `name` without triangles, for corners that are not finite and for indices out of range.
    pub fn new(name: &str, positions: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Result<Mesh> {
        let refuse = |problem: String, remedy: &str| Err(Error::input(name, problem, remedy));
        if triangles.is_empty() {
            return refuse("has no triangles".into(), "give a mesh with a surface");
        }
        if let Some(i) = positions.iter().position(|p| p.iter().any(|c| !c.is_finite())) {
            return refuse(format!("corner {i} is not finite"), "repair the mesh and save it again");
        }
        if let Some(i) = triangles.iter().position(|t| t.iter().any(|&corner| corner as usize >= positions.len())) {
            return refuse(format!("triangle {i} names a corner that is not there"), "save the mesh again");
        }
        Ok(Mesh { positions, triangles })
    }

    /// Corners, world units.
    pub fn positions(&self) -> &[[f64; 3]] {
        &self.positions
    }

    /// Indices of corners, counter-clockwise as seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
}
