//! Triangle meshes: what a wire covers.

mod ball;
mod depth;
mod nearest;
mod shape;

pub use ball::fit_unit_ball;
pub use depth::{Depths, silhouette};
pub use nearest::{Hit, Nearest};
pub use shape::Shape;

use crate::{Error, Result};
use glam::DVec3;

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

    /// Corners and triangles, to make another mesh of.
    pub fn into_parts(self) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        (self.positions, self.triangles)
    }

    /// Area of all triangles, square world units.
    pub fn area(&self) -> f64 {
        (0..self.triangles.len()).map(|i| 0.5 * self.cross(i).length()).sum()
    }

    /// The outward unit normal of triangle `i`; +y if it has no area.
    ///
    /// # Panics
    /// If there is no such triangle.
    pub fn triangle_normal(&self, i: usize) -> [f64; 3] {
        self.cross(i).try_normalize().unwrap_or(DVec3::Y).to_array()
    }

    /// An outward unit normal a corner: the triangles' normals weighted by their angles there, which does not depend on
    /// how a flat face is cut into triangles (Thürmer and Wüthrich 1998).
    #[cfg(test)]
    pub(crate) fn vertex_normals(&self) -> Vec<[f64; 3]> {
        let mut sums = vec![DVec3::ZERO; self.positions.len()];
        for (i, triangle) in self.triangles.iter().enumerate() {
            let normal = DVec3::from(self.triangle_normal(i));
            let corners = self.corners(i);
            for k in 0..3 {
                let (next, last) = (corners[(k + 1) % 3] - corners[k], corners[(k + 2) % 3] - corners[k]);
                let angle = next.cross(last).length().atan2(next.dot(last));
                sums[triangle[k] as usize] += angle * normal;
            }
        }
        sums.iter().map(|sum| sum.try_normalize().unwrap_or(DVec3::Y).to_array()).collect()
    }

    /// The corners of triangle `i`, world units.
    ///
    /// # Panics
    /// If there is no such triangle.
    pub fn corners(&self, i: usize) -> [DVec3; 3] {
        self.triangles[i].map(|corner| DVec3::from(self.positions[corner as usize]))
    }

    /// Normal of triangle `i`, twice as long as its area.
    fn cross(&self, i: usize) -> DVec3 {
        let [a, b, c] = self.corners(i);
        (b - a).cross(c - a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_do_not_depend_on_how_a_face_is_cut() {
        // A cube's corner: three square faces, one of them cut the other way.
        let positions = (0..8).map(|i| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) - 0.5)).collect();
        let triangles = vec![[1, 7, 5], [1, 3, 7], [2, 7, 3], [2, 6, 7], [4, 7, 6], [4, 5, 7]];
        let mesh = Mesh::new("corner", positions, triangles).unwrap();
        assert!((mesh.area() - 3.0).abs() < 1e-12);
        let third = 1.0 / 3.0_f64.sqrt();
        assert!(mesh.vertex_normals()[7].iter().all(|c| (c - third).abs() < 1e-12), "{:?}", mesh.vertex_normals()[7]);
        assert_eq!(mesh.triangle_normal(0), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn bad_parts_are_refused() {
        let corners = || vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let mut bad = corners();
        bad[1][2] = f64::NAN;
        for (positions, triangles, problem) in [
            (corners(), vec![], "no triangles"),
            (bad, vec![[0, 1, 2]], "corner 1"),
            (corners(), vec![[0, 1, 2], [0, 1, 3]], "triangle 1"),
        ] {
            assert!(Mesh::new("x", positions, triangles).unwrap_err().to_string().contains(problem));
        }
    }
}
