//! The first wire: of even width along the curve, with as few control points as stay close to it.

use super::{Plan, width_bounds};
use crate::optimize::WidthBounds;
use crate::settings::Settings;
use crate::start;
use crate::wire::{Form, Wire};
use crate::{Error, Result};

/// Path between two control points of the first wire, as shares of the lines' distance: the first that is fine enough.
const PATHS_PER_POINT: [f64; 5] = [1.7, 1.3, 1.0, 0.75, 0.55];
/// The first of them that lets strands bend as a style asks.
const STYLED: usize = 4;
/// The wire may be off the curve by this share of the lines' distance.
const FIT_TOLERANCE: f64 = 0.1;
/// Weight of the smoothing in that fit.
const FIT_SMOOTHING: f64 = 1e-6;
/// Most control points of the first wire: more are no better seen.
const MOST_POINTS: usize = 16_000;

impl Plan {
    /// A wire of even width along the curve.
    pub(super) fn first_wire(&self, settings: &Settings) -> Result<Wire> {
        let WidthBounds { min_world, max_world } = width_bounds(settings);
        let width = (settings.density * settings.curve_spacing).clamp(min_world, max_world);
        let mut path = self.filling.path.clone();
        path.points.iter_mut().for_each(|point| point[3] = width);
        let wire = match settings.control_points {
            0 => self.fitted(&path, settings.curve_spacing)?,
            count => start::fitted(&path, count, FIT_SMOOTHING)?,
        };
        if settings.form == Form::Spline { Ok(wire) } else { wire.to_form(settings.form) }
    }

    /// With as few control points as stay close to the curve.
    fn fitted(&self, path: &start::Path, spacing: f64) -> Result<Wire> {
        let length = start::length(path);
        let mut found = None;
        for share in &PATHS_PER_POINT[if self.motif.is_some() { STYLED } else { 0 }..] {
            let count = ((length / (share * spacing)).round() as usize).clamp(8, MOST_POINTS);
            let wire = start::fitted(path, count, FIT_SMOOTHING)?;
            let error = start::fit_error(path, &wire);
            found = Some(wire);
            if error <= FIT_TOLERANCE * spacing || count == MOST_POINTS {
                break;
            }
        }
        found.ok_or_else(|| Error::wire(&self.name, "there is no curve on it", "give a larger surface"))
    }
}
