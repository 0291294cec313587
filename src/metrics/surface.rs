//! How a wire covers a mesh: how evenly, and how far it is off it.

use super::Evenness;
use crate::Result;
use crate::mesh::{Mesh, Nearest};
use crate::wire::Wire;
use serde::{Deserialize, Serialize};

/// Samples a knot span: spans are about as long as lines are apart.
const SAMPLES_PER_SPAN: usize = 8;

/// Figures of a wire on a surface.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct SurfaceReport {
    /// Distance between neighbouring lines that was asked for, world units.
    pub spacing: f64,
    /// Area of the surface, square world units.
    pub area: f64,
    /// How many triangles it has.
    pub triangles: usize,
    /// How evenly the lines lie, distances in spacings.
    #[serde(flatten)]
    pub evenness: Evenness,
    /// Mean distance of the wire's centre line from the surface, world units.
    pub drift_mean: f64,
    /// The largest.
    pub drift_max: f64,
}

impl SurfaceReport {
    /// Measures `wire` on `mesh`; `nearest` is the mesh's.
    ///
    /// # Errors
    /// As [`Evenness::measure`].
    pub fn measure(mesh: &Mesh, nearest: &Nearest, wire: &Wire, spacing_world: f64) -> Result<SurfaceReport> {
        let (map, _) = wire.sampling_map::<f64>(SAMPLES_PER_SPAN, false);
        let mut samples = Vec::new();
        map.apply(wire.control_points(), &mut samples);
        let points: Vec<[f64; 3]> = samples.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
        let drifts = || points.iter().map(|point| nearest.nearest(point).distance);
        Ok(SurfaceReport {
            spacing: spacing_world,
            area: mesh.area(),
            triangles: mesh.triangles().len(),
            evenness: Evenness::measure(mesh, &points, spacing_world)?,
            drift_mean: drifts().sum::<f64>() / points.len().max(1) as f64,
            drift_max: drifts().fold(0.0, f64::max),
        })
    }
}
