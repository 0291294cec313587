//! The settings' part that says how to fit, as a [`Recipe`].

use crate::objective::Pyramid;
use crate::optimize::{
    Bending, Moment, NewPoint, RasterKind, Recipe, Refine, Reinit, Schedule, TopologyEdit, TopologyEvent,
};
use crate::settings::{self, Bend, Preset, Settings};

/// How to fit with these settings.
pub(super) fn recipe(settings: &Settings) -> Recipe {
    let mut recipe = match settings.preset {
        Preset::Paper => Recipe::paper(),
        Preset::Best | Preset::Fast => Recipe::best(),
    };
    for stage in &mut recipe.stages {
        stage.samples_per_span = settings.samples;
        stage.size_px = match stage.raster {
            RasterKind::Exact => settings.size,
            RasterKind::Band => (settings.size / 2).max(16),
        };
    }
    recipe.set_iterations(settings.iterations, settings.coarse_share);
    recipe.pyramid = match settings.pyramid {
        settings::Pyramid::Gaussian => Pyramid::Gaussian,
        settings::Pyramid::Average => Pyramid::AveragePool,
    };
    recipe.level_ratio = Schedule::Constant(settings.level_weight);
    recipe.position_rate_px = recipe.position_rate_px.scaled(settings.position_rate / 0.8);
    recipe.width_rate_px = recipe.width_rate_px.scaled(settings.width_rate / 0.24);
    recipe.jerk_position = recipe.jerk_position.scaled(settings.smoothness);
    recipe.jerk_width = recipe.jerk_width.scaled(settings.smoothness);
    recipe.bending = bending(settings.bend);
    recipe.topology = topology(settings);
    recipe
}

/// How the targets bend during the fit.
fn bending(bend: Bend) -> Option<Bending> {
    match bend {
        Bend::None => None,
        Bend::Little | Bend::Free => Some(Bending::default()),
    }
}

/// Re-initialisation after a sixth and a third of the run, refinement after two thirds (the paper's shares).
fn topology(settings: &Settings) -> Vec<TopologyEvent> {
    let new_point = match settings.new_point {
        settings::NewPoint::Lacking => NewPoint::LackingInk,
        settings::NewPoint::Random => NewPoint::RandomInVolume,
        settings::NewPoint::Midpoint => NewPoint::Midpoint,
    };
    let at = |share: f64, edit: TopologyEdit| TopologyEvent { at: Moment::Progress(share), edit };
    let mut events = Vec::new();
    if settings.reinit {
        for share in [1.0 / 6.0, 1.0 / 3.0] {
            events.push(at(share, TopologyEdit::Reinit(Reinit { new_point, ..Reinit::default() })));
        }
    }
    if settings.refine {
        events.push(at(2.0 / 3.0, TopologyEdit::Refine(Refine::default())));
    }
    events
}
