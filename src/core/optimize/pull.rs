//! The pull to a mesh: which planes stand in for it, and how often they are laid anew.

use crate::mesh::{Hit, Nearest};
use crate::parallel;
use crate::{Error, Result};
use std::sync::Arc;

/// Keeps a wire on a mesh. Samples are pulled to the planes that touch the mesh at the points next to them, which are
/// looked up every few iterations only: in between samples glide along their planes.
#[derive(Debug, Clone)]
pub struct SurfacePull {
    /// Finds those points.
    pub nearest: Arc<Nearest>,
    /// Weight of the samples' mean squared distance from their planes, lengths in half picture sides.
    pub weight: f64,
    /// Iterations between two look-ups.
    pub every: usize,
}

/// Nearer to the mesh than this, world units, the way there says nothing about the mesh.
const ON_SURFACE: f64 = 1e-6;

impl SurfacePull {
    /// With planes laid anew every ten iterations.
    pub fn new(nearest: Arc<Nearest>, weight: f64) -> SurfacePull {
        SurfacePull { nearest, weight, every: 10 }
    }

    pub(super) fn check(&self) -> Result<()> {
        if self.weight.is_finite() && self.weight >= 0.0 && self.every > 0 {
            return Ok(());
        }
        Err(Error::setting(
            "surface",
            format!("weight {} every {} iterations", self.weight, self.every),
            "give a weight from 0 up and planes every 1 or more",
        ))
    }

    /// Whether planes are laid anew before iteration `iteration`.
    pub(super) fn is_due(&self, iteration: usize) -> bool {
        iteration.is_multiple_of(self.every)
    }

    /// A plane `[n, d]` for each sample.
    pub(super) fn planes(&self, samples: &[[f32; 4]]) -> Vec<[f32; 4]> {
        let plane = |sample: &[f32; 4]| self.plane([0, 1, 2].map(|c| f64::from(sample[c])));
        parallel::map(samples, 256, plane)
    }

    /// The plane through the nearest point across the way there. At edges and rims, where a triangle's own plane runs on
    /// past the mesh, that is the one whose distance is the mesh's; where there is no way to speak of, the triangle's.
    fn plane(&self, point: [f64; 3]) -> [f32; 4] {
        let Hit { point: foot, distance, normal, .. } = self.nearest.nearest(&point);
        let normal = if distance > ON_SURFACE { [0, 1, 2].map(|c| (point[c] - foot[c]) / distance) } else { normal };
        let offset: f64 = (0..3).map(|c| normal[c] * foot[c]).sum();
        [normal[0], normal[1], normal[2], offset].map(|c| c as f32)
    }
}

impl PartialEq for SurfacePull {
    /// The same mesh, not merely an equal one.
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.nearest, &other.nearest) && (self.weight, self.every) == (other.weight, other.every)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;

    /// The unit square in x and y, at z = 0.
    fn square() -> SurfacePull {
        let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let mesh = Mesh::new("square", corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        SurfacePull::new(Arc::new(Nearest::new(&mesh)), 1.0)
    }

    #[test]
    fn planes_touch_the_mesh_next_to_the_samples() {
        let samples = [[0.3, 0.4, 0.2, 0.1], [0.3, 0.4, -0.2, 0.1], [0.3, 0.4, 0.0, 0.1], [1.3, 0.5, 0.4, 0.1f32]];
        let planes = square().planes(&samples);
        let expected = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, -1.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.6, 0.0, 0.8, 0.6]];
        for (plane, expected) in planes.iter().zip(expected) {
            assert!(plane.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-6), "{plane:?}, not {expected:?}");
        }
        // The distance from the plane is that from the mesh, beside the rim too.
        let off = |[x, y, z, _]: [f32; 4], [a, b, c, d]: [f32; 4]| a * x + b * y + c * z - d;
        assert!((off(samples[3], planes[3]) - 0.5).abs() < 1e-6);
    }

    #[test]
    fn weights_and_counts_out_of_range_are_refused() {
        assert!(square().check().is_ok());
        for (weight, every) in [(-1.0, 10), (f64::NAN, 10), (1.0, 0)] {
            assert!(SurfacePull { weight, every, ..square() }.check().is_err(), "{weight} {every}");
        }
    }
}
