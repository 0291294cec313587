//! The finished thing: a wire, the views it was made for, and how it was made. Metrics, exports, command line and page
//! all start from a [`Sculpture`].

mod carried;
mod file;
pub(crate) mod png;
mod render;

pub(crate) use carried::MAX_CARRIED_BYTES;
pub use carried::{Carried, MAX_DRAWING_PX, MAX_DRAWINGS, Silhouette};
pub(crate) use file::{FORMAT, check_heading};
pub use file::{FORMAT_VERSION, MAX_FILE_BYTES};
pub use render::{SAMPLES_PER_SPAN, render, render_sampled, render_seen};

use crate::mesh::{Depths, Mesh};
use crate::view::{Occluder, View};
use crate::wire::Wire;
use serde::{Deserialize, Serialize};

/// A wire with its views and its origin; what `wire.json` holds.
///
/// ```
/// use wire4d::sculpture::{Carried, MadeWith, Sculpture};
/// use wire4d::view::View;
/// use wire4d::wire::Wire;
///
/// # fn main() -> wire4d::Result<()> {
/// let square = [[1.0, 0.0, 0.0, 0.1], [0.0, 1.0, 0.0, 0.1], [-1.0, 0.0, 0.5, 0.1], [0.0, -1.0, 0.0, 0.1]];
/// let wire = Wire::closed_uniform(square.to_vec())?;
/// let views = View::canonical(2.2, 256).to_vec();
/// let made = Sculpture { wire, views, made_with: MadeWith::default(), carried: Carried::default() };
/// let file = made.to_json();
/// assert_eq!(Sculpture::from_json("wire.json", file.as_bytes())?, made);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sculpture {
    /// The wire, in world units; the object fits the unit ball.
    pub wire: Wire,
    /// The views it was made for, in order.
    pub views: Vec<View>,
    /// How it was made.
    pub made_with: MadeWith,
    /// What it was made of and how it was found, for going on from it.
    pub carried: Carried,
}

impl Sculpture {
    /// What `solid`, which the wire covers, hides in `view`: as softly as the settings say that it was made with.
    pub fn hidden_by(&self, solid: &Mesh, view: &View) -> Occluder {
        let set = |name: &str| self.made_with.settings.get(name).and_then(|value| value.as_f64());
        let mut occluder = Occluder::new(Depths::render(solid, view).widened());
        // Within what the settings allow: the file may come from anywhere.
        if let Some(steepness) = set("visibility") {
            occluder.steepness = steepness.clamp(1.0, 1000.0) as f32;
        }
        if let Some(bias_world) = set("visibility_bias") {
            occluder.bias_world = bias_world.clamp(0.0, 0.5) as f32;
        }
        occluder
    }
}

/// How a wire was made: enough to make it again from the same input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MadeWith {
    /// `multiview`, `stroke`, `fill` or what another program calls it; may be empty.
    pub task: String,
    /// Seed of the run.
    pub seed: u64,
    /// Settings by name.
    pub settings: serde_json::Map<String, serde_json::Value>,
    /// Version of Wire4D.
    pub wire4d: String,
}

impl Default for MadeWith {
    fn default() -> Self {
        let wire4d = env!("CARGO_PKG_VERSION").to_owned();
        MadeWith { task: String::new(), seed: 0, settings: serde_json::Map::new(), wire4d }
    }
}

/// A run of joined points of a wire, `[x, y, z, width]` in world units.
#[derive(Debug, Clone, PartialEq)]
pub struct Strand {
    /// Points on the curve, in order.
    pub points: Vec<[f64; 4]>,
    /// Whether the last point joins the first (which is not repeated).
    pub closed: bool,
}

/// The wire as polylines with `samples_per_span` points on the curve a knot span: one strand, or one a Bézier of a bag.
pub fn strands(wire: &Wire, samples_per_span: usize) -> Vec<Strand> {
    let (map, strokes) = wire.sampling_map::<f64>(samples_per_span, false);
    let mut points = Vec::new();
    map.apply(wire.control_points(), &mut points);
    for point in &mut points {
        // Exact convex combinations are not negative; rounding may be.
        point[3] = point[3].max(0.0);
    }
    strokes
        .iter()
        .map(|stroke| Strand {
            points: points[stroke.start..stroke.start + stroke.count].to_vec(),
            closed: stroke.closed,
        })
        .collect()
}

#[cfg(test)]
mod tests;
