//! What keeps a wire a wire, as data: bending, tight bends, clearance between strands, even spacing of control points.

use super::Schedule;
use crate::objective::{Clearance, Elastic};
use crate::{Error, Result};

/// Weights are relative to image losses summed over the pixels of a 256 px picture, and lengths are pixels of one.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Smooth {
    /// Weight of the bending energy.
    pub bending: Schedule,
    /// Bends tighter than this cost little more.
    pub cusp_radius_px: f64,
    /// Weight of the hinge on tight bends.
    pub tightness: Schedule,
    /// The least bend radius.
    pub least_radius_px: f64,
    /// The least bend radius in local diameters, where that is more.
    pub least_radius_diameters: f64,
    /// Weight of the push between strands.
    pub clearance: Schedule,
    /// Distance from which strands push each other, middle to middle, in their mean diameters.
    pub clearance_diameters: f64,
    /// The least of those distances.
    pub least_clearance_px: f64,
    /// Nearer along the wire than so many clearances, places are one strand.
    pub one_strand: f64,
    /// Weight of the even spacing.
    pub evenness: f64,
    /// Iterations between two looks at who is near whom.
    pub every: usize,
    /// Places at which each span is looked at.
    pub nodes_per_span: usize,
}

/// How much farther than their clearance strands are watched until the next look, px.
const SLACK_PX: f64 = 1.5;
/// Pixels of the picture that image losses are a mean over.
const PIXELS: f64 = 256.0 * 256.0;

impl Default for Smooth {
    fn default() -> Self {
        // While the wire finds its place it is stiff, and may pass through itself.
        let ramped = |value: f64| Schedule::Piecewise(vec![[0.1, 0.0], [0.6, value]]);
        Smooth {
            bending: Schedule::Geometric { from: 100.0, to: 8.0, until: 0.7 },
            cusp_radius_px: 2.0,
            tightness: ramped(6.0),
            least_radius_px: 4.2,
            least_radius_diameters: 1.5,
            clearance: ramped(40.0),
            clearance_diameters: 1.15,
            least_clearance_px: 3.2,
            one_strand: 2.0,
            evenness: 2.0,
            every: 4,
            nodes_per_span: 3,
        }
    }
}

impl Smooth {
    pub(super) fn check(&self) -> Result<()> {
        self.bending.check("bending")?;
        self.tightness.check("tightness")?;
        self.clearance.check("clearance")?;
        let from_0 = [
            self.least_radius_px,
            self.least_radius_diameters,
            self.clearance_diameters,
            self.least_clearance_px,
            self.one_strand,
            self.evenness,
        ];
        let fine = from_0.iter().all(|value| value.is_finite() && *value >= 0.0)
            && self.cusp_radius_px.is_finite()
            && self.cusp_radius_px > 0.0;
        if fine && self.every > 0 && (1..=16).contains(&self.nodes_per_span) {
            return Ok(());
        }
        let remedy = "give lengths and weights from 0 up, a cusp radius above 0, looks every 1 or more, 1 to 16 nodes";
        Err(Error::setting("smooth", "some of its numbers are out of range", remedy))
    }

    /// The numbers at a progress of the run, for a wire of a mean speed; `px` is a pixel in world units.
    pub(super) fn elastic(&self, progress: f64, px: f64, speed: f32) -> Elastic<f32> {
        Elastic {
            bending: (self.bending.at(progress) * px / PIXELS) as f32,
            cusp_radius: (self.cusp_radius_px * px) as f32,
            tightness: (self.tightness.at(progress) / (px * px * PIXELS)) as f32,
            least_radius: (self.least_radius_px * px) as f32,
            least_diameters: self.least_radius_diameters as f32,
            evenness: (self.evenness / (px * PIXELS)) as f32,
            speed,
        }
    }

    /// Likewise.
    pub(super) fn clearance(&self, progress: f64, px: f64, speed: f32) -> Clearance<f32> {
        Clearance {
            weight: (self.clearance.at(progress) / (px * PIXELS)) as f32,
            diameters: self.clearance_diameters as f32,
            least_world: (self.least_clearance_px * px) as f32,
            speed,
        }
    }

    /// How many clearances apart along the wire strands are, and how far beyond one they are watched, world units.
    pub(super) fn watch(&self, px: f64) -> (f32, f32) {
        (self.one_strand as f32, (SLACK_PX * px) as f32)
    }
}
