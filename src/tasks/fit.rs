//! What all tasks share: the settings' part that says how to fit, as a [`Recipe`], and what happened, for the report.

use crate::metrics::EventReport;
use crate::objective::Pyramid;
use crate::optimize::{
    Bending, Event, Moment, NewPoint, RasterKind, Recipe, Refine, Reinit, Schedule, Session, TopologyEdit,
    TopologyEvent,
};
use crate::settings::{self, Bend, Preset, Settings};

/// How to fit with these settings.
pub(super) fn recipe(settings: &Settings) -> Recipe {
    let mut recipe = match settings.preset {
        Preset::Paper => Recipe::paper(),
        Preset::Best | Preset::Fast => Recipe::best(),
    };
    for stage in &mut recipe.stages {
        // At half size half the samples are as close together.
        (stage.size_px, stage.samples_per_span) = match stage.raster {
            RasterKind::Exact => (settings.size, settings.samples),
            RasterKind::Band => ((settings.size / 2).max(16), settings.samples.div_ceil(2)),
        };
    }
    recipe.set_iterations(settings.iterations, settings.coarse_share);
    recipe.pyramid = match settings.pyramid {
        settings::Pyramid::Gaussian => Pyramid::Gaussian,
        settings::Pyramid::Average => Pyramid::AveragePool,
    };
    recipe.level_ratio = Schedule::Constant(settings.level_weight);
    recipe.position_rate_px = starting_at(&recipe.position_rate_px, settings.position_rate);
    recipe.width_rate_px = starting_at(&recipe.width_rate_px, settings.width_rate);
    recipe.jerk_position = recipe.jerk_position.scaled(settings.smoothness);
    recipe.jerk_width = recipe.jerk_width.scaled(settings.smoothness);
    recipe.bending = bending(settings.bend);
    recipe.topology = topology(settings);
    recipe
}

/// The same course, beginning with `value`.
fn starting_at(schedule: &Schedule, value: f64) -> Schedule {
    schedule.scaled(value / schedule.at(0.0))
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

/// What happened so far.
pub(super) fn event_reports(session: &Session) -> Vec<EventReport> {
    let word = |kind| serde_json::to_value(kind).ok().and_then(|kind| kind.as_str().map(str::to_owned));
    let report = |event: &Event| EventReport {
        iteration: event.iteration,
        kind: word(event.kind).unwrap_or_default(),
        count: event.count,
    };
    session.events().iter().map(report).collect()
}
