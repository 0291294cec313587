//! The first wire: along the object's lines, or as the paper begins.

use super::plan::Plan;
use crate::Result;
use crate::settings::{OnOff, Start, Task};
use crate::start;
use crate::tasks::recipe::HAIRPIN_PX;
use crate::wire::{Form, Wire, with_open_hairpins};

/// Most control points of the first wire where the start chooses.
const MOST_FIRST_POINTS: f64 = 1800.0;
/// Width of the first wire on the solid's back and between lines, px at 256.
const THIN_PX: f64 = 1.4;
/// The paper's least number of control points.
const FEWEST_TOUR_POINTS: usize = 100;
/// Width of a tour's first wire, px at 256.
const TOUR_WIDTH_PX: f64 = 3.0;
/// How far strands that lie on one another are moved apart before the fit, px of a 256 px picture.
const JITTER_PX: f64 = 1.0;

impl Plan {
    /// The wire that the fit starts from.
    pub(super) fn first_wire(&self) -> Result<Wire> {
        let settings = &self.settings;
        let px = self.world_per_px_256();
        let count = if settings.control_points == 0 { FEWEST_TOUR_POINTS } else { settings.control_points };
        let tour_width = TOUR_WIDTH_PX * px;
        let wire = match settings.start {
            Start::Contour => {
                let mut path = self.lines.walk(&self.solid, settings.min_width.max(THIN_PX) * px);
                if settings.smooth == OnOff::On {
                    start::jittered(&mut path, JITTER_PX * px, settings.seed);
                    path.points = with_open_hairpins(&path.points, path.closed, HAIRPIN_PX * px);
                }
                let finest = start::length(&path) / MOST_FIRST_POINTS;
                match settings.control_points {
                    0 => start::wire_along(&path, (settings.spacing * px).max(finest))?,
                    count => start::wire_with(&path, count)?,
                }
            }
            // The points of the tour are the control points (the paper's choice).
            Start::Hull => Wire::open_uniform(self.solid.tour(count, tour_width, settings.seed).points)?,
            Start::Ball => Wire::open_uniform(start::ball_path(count, 0.8, tour_width, false, settings.seed).points)?,
            Start::Circuit | Start::Tree | Start::Stripes | Start::Tour => {
                return Err(Task::Stroke.refused("start", settings));
            }
        };
        if settings.form == Form::Spline { Ok(wire) } else { wire.to_form(settings.form) }
    }
}
