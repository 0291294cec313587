//! The settings' part that says how to fit, as a [`Recipe`]: all tasks begin with it.

use crate::objective::Pyramid;
use crate::optimize::{
    AdamOptions, Bending, Moment, NewPoint, RasterKind, Recipe, Refine, Reinit, Respace, Schedule, SecondMoment,
    Smooth, Thin, TopologyEdit, TopologyEvent,
};
use crate::settings::{self, Bend, OnOff, Preset, Settings, Width};

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
    if settings.smooth == OnOff::On {
        keep_smooth(&mut recipe, settings);
    }
    recipe
}

/// Shares of the run after which control points are laid anew. Steps are wide at first, while the wire finds its place.
const RESPACED: [f64; 6] = [0.12, 0.25, 0.4, 0.5, 0.62, 0.75];
/// How much wider, up to this share of the run.
pub(super) const WIDE: f64 = 1.6;
const WIDE_UNTIL: f64 = 0.45;
/// Radius of the bends at which a wire turns back, where it does in a cusp, px of a 256 px picture.
pub(super) const HAIRPIN_PX: f64 = 4.2;
/// Weights of the length at the run's start and end, and of the width's jerk, relative to image losses summed over the
/// pixels of a 256 px picture, lengths in pixels of one.
const LENGTH: [f64; 2] = [0.1, 0.02];
const JERK_WIDTH: f64 = 20.0;
/// How much harder strands of constant width push each other: they cannot get out of each other by thinning.
const CONSTANT_CLEARANCE: f64 = 3.0;
/// From which share of the run on drawings bend, and how far an update moves them at first, px of a 256 px picture.
const BENDING_FROM: f64 = 0.4;
const BENDING_PX: f64 = 0.07;

/// Whether the first wire is only near its place. Others lie where they belong, as wide as they should be.
fn is_laid_roughly(settings: &Settings) -> bool {
    use settings::Start;
    matches!(settings.start, Start::Circuit | Start::Tree | Start::Hull | Start::Ball)
}

/// Whatever makes a wire a wire.
fn keep_smooth(recipe: &mut Recipe, settings: &Settings) {
    let pixels = 256.0 * 256.0;
    let smooth = Smooth::default();
    let of_constant_width = if settings.width == Width::Constant { CONSTANT_CLEARANCE } else { 1.0 };
    recipe.smooth = Some(Smooth {
        bending: smooth.bending.scaled(settings.smoothness),
        tightness: smooth.tightness.scaled(settings.tightness),
        clearance: smooth.clearance.scaled(settings.clearance * of_constant_width),
        least_radius_diameters: settings.bend_radius,
        ..smooth
    });
    // A step goes where the gradient points, not along the axes; pictures change under it, so it forgets fast.
    recipe.adam = AdamOptions { beta1: 0.9, beta2: 0.98, epsilon: 3e-6, second_moment: SecondMoment::PerPoint };
    recipe.position_rate_px = Schedule::Cosine { from: settings.position_rate, to: 0.025 * settings.position_rate };
    recipe.width_rate_px = Schedule::Cosine { from: settings.width_rate, to: 0.07 * settings.width_rate };
    recipe.jerk_position = Schedule::Constant(0.0);
    if is_laid_roughly(settings) {
        recipe.jerk_width = Schedule::Constant(JERK_WIDTH * 128.0 * 128.0 / pixels);
        recipe.length =
            Schedule::Piecewise([0.0, 1.0].into_iter().zip(LENGTH).map(|(t, w)| [t, w * 128.0 / pixels]).collect());
    }
    for stage in &mut recipe.stages {
        (stage.raster, stage.restarts) = (RasterKind::Exact, Vec::new());
        stage.samples_per_span = settings.samples;
    }
    if settings.control_points == 0 && is_laid_roughly(settings) {
        recipe.topology.extend(RESPACED.map(|share| {
            let wider = if share < WIDE_UNTIL { WIDE } else { 1.0 };
            let edit = TopologyEdit::Respace(Respace { spacing_px: wider * settings.spacing, hairpin_px: HAIRPIN_PX });
            TopologyEvent { at: Moment::Progress(share), edit }
        }));
    }
    if let Some(bending) = &mut recipe.bending {
        // First the wire finds its place. It may not meet every corner, and drawings should not chase it.
        bending.from = BENDING_FROM;
        bending.rate_px = Schedule::Piecewise(vec![[0.0, BENDING_PX], [1.0, 0.0]]);
    }
}

/// The same course, beginning with `value`.
fn starting_at(schedule: &Schedule, value: f64) -> Schedule {
    schedule.scaled(value / schedule.at(0.0))
}

/// A schedule's last value from the start: for wires that begin where they belong.
pub(super) fn at_once(schedule: &Schedule) -> Schedule {
    Schedule::Constant(schedule.at(1.0))
}

/// How the targets bend during the fit.
fn bending(bend: Bend) -> Option<Bending> {
    match bend {
        Bend::None => None,
        Bend::Little | Bend::Free => Some(Bending::default()),
    }
}

/// Share of the run after which spare control points go: the rest of it makes up for what that moves.
const THINNED: f64 = 0.9;

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
    if settings.thin > 0.0 {
        events.push(at(THINNED, TopologyEdit::Thin(Thin { tolerance_px: settings.thin })));
    }
    if settings.refine {
        events.push(at(2.0 / 3.0, TopologyEdit::Refine(Refine::default())));
    }
    events
}
