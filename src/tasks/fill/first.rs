//! The first wire: of even width along the curve, with as few control points as stay close to it.

use super::plan::{Plan, world_per_px};
use crate::optimize::WidthBounds;
use crate::settings::{Settings, Task, Width};
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

/// The width at which lines so far apart are as dense as asked for, world units.
fn width_wanted(settings: &Settings) -> f64 {
    settings.density * settings.curve_spacing
}

/// World units in the pixel that widths are given in.
pub(super) fn width_unit(settings: &Settings) -> f64 {
    world_per_px(settings) * settings.size as f64 / 256.0
}

/// Bounds of the wire's width. Those of the preset are for lines at its own distance: others may grow until they touch,
/// and become as thin as the density asks. Those that a person has set hold.
pub(super) fn width_bounds(settings: &Settings) -> WidthBounds {
    let (usual, px) = (Task::Fill.preset_with(settings.preset, settings.smooth), width_unit(settings));
    let mut bounds = WidthBounds { min_world: settings.min_width * px, max_world: settings.max_width * px };
    if settings.min_width == usual.min_width {
        bounds.min_world = bounds.min_world.min(width_wanted(settings));
    }
    if settings.max_width == usual.max_width {
        bounds.max_world = bounds.max_world.max(settings.curve_spacing);
    }
    if settings.width == Width::Constant {
        let width = width_wanted(settings).clamp(bounds.min_world, bounds.max_world);
        bounds = WidthBounds { min_world: width, max_world: width };
    }
    bounds
}

/// What a person should know whose bounds keep the wire from being as dense as asked for.
pub(super) fn width_note(settings: &Settings) -> Option<String> {
    let (WidthBounds { min_world, max_world }, wanted) = (width_bounds(settings), width_wanted(settings));
    let remedy = match wanted {
        _ if wanted > max_world => "raise max_width or lower curve_spacing",
        _ if wanted < min_world => "lower min_width or raise curve_spacing",
        _ => return None,
    };
    let px = wanted / width_unit(settings);
    Some(format!("for this density the wire would have to be {px:.1} px wide: {remedy}"))
}

impl Plan {
    /// A wire of even width along the curve.
    pub(super) fn first_wire(&self) -> Result<Wire> {
        let settings = &self.settings;
        let WidthBounds { min_world, max_world } = width_bounds(settings);
        let width = width_wanted(settings).clamp(min_world, max_world);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Preset;

    #[test]
    fn every_density_is_reached_at_every_spacing_unless_a_person_bounds_the_width() {
        for &preset in Preset::ALL {
            for curve_spacing in [0.02, 0.06, 0.2] {
                for density in [0.1, 0.5, 1.0] {
                    let settings = Settings { curve_spacing, density, ..Task::Fill.preset(preset) };
                    let WidthBounds { min_world, max_world } = width_bounds(&settings);
                    assert!((min_world..=max_world).contains(&(density * curve_spacing)), "{preset:?} {settings:?}");
                    assert!(max_world >= curve_spacing && width_note(&settings).is_none());
                }
            }
            let usual = Task::Fill.preset(preset);
            let WidthBounds { min_world, max_world } = width_bounds(&usual);
            let px = width_unit(&usual);
            assert_eq!([min_world, max_world], [usual.min_width * px, usual.max_width * px], "the preset as it says");
        }
        let wide = Settings { curve_spacing: 0.2, density: 1.0, ..Task::Fill.preset(Preset::Best) };
        let note = |settings: Settings| width_note(&settings).unwrap();
        assert!(
            note(Settings { max_width: 8.0, ..wide.clone() })
                .ends_with("20.6 px wide: raise max_width or lower curve_spacing")
        );
        assert!(
            note(Settings { min_width: 2.0, density: 0.1, curve_spacing: 0.06, ..wide }).contains("lower min_width")
        );
    }
}
