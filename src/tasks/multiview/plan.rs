//! What is decided before a fit: where each drawing goes, and what the wire grows from.

use super::given::{Drawing, named};
use crate::metrics::{BentReport, ResultReport, length_over_lines, match_pictures};
use crate::objective::Displacement;
use crate::optimize::{Problem, Session};
use crate::picture::Ink;
use crate::sculpture::{Sculpture, render};
use crate::settings::{Bend, OnOff, Settings, Start, Task, Turn};
use crate::start::{
    self, ArrangeOptions, Arrangement, BendOptions, CircuitOptions, Coverable, HullOptions, Orientation, Path,
    Placement, Sharing, TrailOptions, TreeOptions,
};
use crate::tasks::recipe::{WIDE, recipe};
use crate::tasks::widths::width_bounds;
use crate::tasks::{self, Placed};
use crate::view::{Image, Target, View, ViewSpec};
use crate::wire::{Form, Wire};
use crate::{Error, Result};

/// Drawings in their views, before anything is fitted.
#[derive(Debug, Clone)]
pub struct Plan {
    settings: Settings,
    /// Which drawing went where, the object's box, and what each view should show (never bent).
    pub arrangement: Arrangement,
    /// What any object could show of each view's drawing.
    pub coverable: Vec<Coverable>,
    /// What each view should show, blank for those that nobody gave a drawing of.
    targets: Vec<Target>,
    /// Names of the drawings as given.
    sources: Vec<String>,
    /// How far each view's ink was moved before the fit.
    moved_before: Vec<Displacement>,
    /// Whether the drawings were placed where they say instead of arranged.
    placed: bool,
}

/// When less than this share of a drawing can be shown, the person is told.
const LOW_SHARE: f32 = 0.75;

/// Arranges the drawings: which goes where, mirrored or turned how, and the object's box.
///
/// # Errors
/// [`Error::Picture`] for a drawing without ink, [`Error::Pictures`] when they are too few or share no ink at all.
pub fn plan(drawings: &[Drawing], settings: &Settings) -> Result<Plan> {
    plan_with(drawings, &[], settings)
}

/// [`plan`] with views that nobody gave a drawing of, such as words guide ([`Run::guide_by`](crate::tasks::Run::guide_by)): they
/// are drawn and compared with nothing. Those that a drawing takes anyway are left out. A single drawing is placed as it says;
/// where there is none at all, the wire starts as a ring, or as the settings' ball.
///
/// # Errors
/// As [`plan`], which needs no drawing where there are such views; [`Error::Input`] for a side that nobody knows or that is named
/// twice.
pub fn plan_with(drawings: &[Drawing], others: &[ViewSpec], settings: &Settings) -> Result<Plan> {
    Task::Multiview.check(settings)?;
    if drawings.len() < 2 && others.is_empty() {
        return Err(Error::Pictures {
            problem: format!(
                "{} picture given, and a wire needs at least two to look different from each side",
                drawings.len()
            ),
            remedy: "add a picture for another side".into(),
        });
    }
    let options = ArrangeOptions {
        permute: settings.may_swap,
        mirror: settings.may_mirror,
        turn_top: settings.may_turn != Turn::None,
        max_stretch: settings.max_stretch,
        size_px: settings.size,
    };
    let options = if settings.arrange == OnOff::On { options } else { options.pinned() };
    let named = named(drawings);
    let placed = drawings.iter().any(|drawing| drawing.seen_from.is_some());
    let mut arrangement = if placed || drawings.len() < 2 {
        let views = drawings.iter().map(|drawing| drawing.seen_from.clone()).collect::<Vec<_>>();
        start::place(&named, &views, settings.size)?
    } else {
        start::arrange(&named, &options)?
    };
    thicken(&mut arrangement.targets, settings);
    let coverable = match &arrangement.targets[..] {
        [] => Vec::new(),
        [Target { ink, .. }] => vec![Coverable { share: 1.0, missing: Image::new(ink.width, ink.height) }],
        _ => start::coverable(&arrangement.targets, arrangement.half_extents_world, start::REPORT_ACROSS)?,
    };
    let blank = |view: View| Target { ink: Image::new(view.width_px, view.height_px), view };
    let blanks = start::others(&arrangement, others, settings.size)?.into_iter().map(blank);
    let targets: Vec<Target> = arrangement.targets.iter().cloned().chain(blanks).collect();
    let sources = drawings.iter().map(|drawing| drawing.name.clone()).collect();
    let moved_before = vec![Displacement::default(); targets.len()];
    Ok(Plan { settings: settings.clone(), arrangement, coverable, targets, sources, moved_before, placed })
}

/// Makes lines as wide as the settings ask.
pub(super) fn thicken(targets: &mut [Target], settings: &Settings) {
    let min_stroke_px = settings.min_stroke * settings.size as f64 / 256.0;
    if min_stroke_px > 0.0 {
        for target in targets {
            target.ink = target.ink.with_min_stroke(min_stroke_px as f32);
        }
    }
}

impl Plan {
    /// How the drawing of view `view` was laid into it.
    pub fn placed(&self, view: usize) -> Placed {
        let placement = self.arrangement.placements.get(view);
        let Orientation { mirrored, quarter_turns } = placement.map(|placed| placed.orientation).unwrap_or_default();
        Placed {
            view: self.targets[view].view.clone(),
            source: placement.map(|placed| placed.source),
            mirrored,
            quarter_turns,
            coverable: self.coverable.get(view).map_or(1.0, |coverable| coverable.share),
        }
    }

    /// Mean over the views of the share of ink that any object could show.
    pub fn mean_coverable(&self) -> f64 {
        start::mean_share(&self.coverable)
    }

    /// What a person should know before the run, in plain words.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.placed {
            notes.push("Some pictures are seen from sides of their own: all are placed as given, not arranged".into());
        }
        notes.extend(self.notes_on_sizes());
        for ((target, placement), coverable) in
            self.arrangement.targets.iter().zip(&self.arrangement.placements).zip(&self.coverable)
        {
            if coverable.share < LOW_SHARE {
                notes.push(format!(
                    "{}: only {:.0}% of {}'s lines can be shown together with the other pictures; expect visible links, \
                     let the pictures bend, or try other ones",
                    target.view.name,
                    100.0 * coverable.share,
                    self.sources[placement.source],
                ));
            }
        }
        notes
    }

    /// What is smaller than it would be without the others, and what was moved so that nothing is.
    fn notes_on_sizes(&self) -> Vec<String> {
        let Arrangement { targets, placements, sharing, .. } = &self.arrangement;
        let name = |placement: &Placement| &self.sources[placement.source];
        if *sharing == Sharing::Width {
            let [front, top] = [0, 1].map(|view| name(&placements[view]));
            return vec![format!(
                "{top} is seen from the top and as wide as {front}: beside each other, equally high, one of them would \
                 come out small",
            )];
        }
        let shrunk = targets.iter().zip(placements).filter(|(_, placement)| placement.kept() < start::KEPT);
        let note = |(target, placement): (&Target, &Placement)| {
            format!(
                "{}: {} is drawn at {:.0}% of the size that it would have alone, since views of one object are equally \
                 high or wide; pictures of like proportions keep theirs",
                target.view.name,
                name(placement),
                100.0 * placement.kept(),
            )
        };
        shrunk.map(note).collect()
    }

    /// Whether the drawings are bent before the fit.
    fn bends_before(&self) -> bool {
        self.settings.bend == Bend::Free && !self.agrees()
    }

    /// Whether the drawings agree so well as they are that bending them before the fit would only move their ink.
    pub(super) fn agrees(&self) -> bool {
        self.coverable.iter().all(|view| view.share >= ENOUGH_SHARE)
    }

    /// What the drawings' views should show once drawings that may bend freely have bent; notes how far that moved their ink.
    fn targets_to_fit(&mut self, progress: &mut dyn FnMut(f32) -> bool) -> Result<Vec<Target>> {
        let targets = &self.arrangement.targets;
        if !self.bends_before() {
            return Ok(targets.clone());
        }
        let bent = start::bend(targets, &BendOptions::default(), progress)?;
        self.moved_before.iter_mut().zip(bent.moved).for_each(|(before, moved)| *before = moved);
        Ok(bent.targets)
    }

    /// The fit of `wire` to the drawings' `targets`, and in the other views.
    fn problem(&self, wire: Wire, mut targets: Vec<Target>) -> Problem {
        let settings = &self.settings;
        let width = width_bounds(&targets, self.world_per_px_256(), settings);
        targets.extend_from_slice(&self.targets[targets.len()..]);
        let weight = |view| if self.is_drawn(view) { 1.0 } else { 0.0 };
        Problem {
            view_weights: (0..targets.len()).map(weight).collect(),
            width,
            seed: settings.seed,
            ..Problem::for_drawings(wire, targets, recipe(settings))
        }
    }

    /// Whether somebody gave a drawing of view `view`.
    fn is_drawn(&self, view: usize) -> bool {
        view < self.arrangement.placements.len()
    }

    /// World units in one pixel of a 256 px picture.
    fn world_per_px_256(&self) -> f64 {
        self.arrangement.height_world / 256.0
    }

    /// The wire the fit starts from. `progress` (0 to 1) stops the search by returning false; what there is is used.
    fn first_wire(&self, targets: &[Target], progress: &mut dyn FnMut(f32) -> bool) -> Result<Wire> {
        let settings = &self.settings;
        let px = self.world_per_px_256();
        let mut path = self.first_path(targets, progress)?;
        if settings.smooth == OnOff::On {
            start::jittered(&mut path, JITTER_PX * px, settings.seed);
        }
        let wire = match settings.control_points {
            // The points of the tour are the control points (the paper's choice).
            _ if settings.start == Start::Ball => Wire::open_uniform(path.points)?,
            0 if settings.smooth == OnOff::On => start::wire_along(&path, WIDE * settings.spacing * px)?,
            0 => {
                let finest = start::length(&path) / MOST_FIRST_POINTS;
                start::wire_along(&path, (settings.spacing * px).max(finest))?
            }
            count => start::wire_with(&path, count)?,
        };
        if settings.form == Form::Spline { Ok(wire) } else { wire.to_form(settings.form) }
    }

    fn first_path(&self, targets: &[Target], progress: &mut dyn FnMut(f32) -> bool) -> Result<Path> {
        let settings = &self.settings;
        let both;
        let targets = match targets {
            [alone] => {
                both = [alone.clone(), start::edge_on(alone)];
                &both[..]
            }
            _ => targets,
        };
        let Arrangement { half_extents_world, height_world, .. } = &self.arrangement;
        match settings.start {
            Start::Circuit | Start::Tree | Start::Hull if targets.is_empty() => {
                let views: Vec<View> = self.targets.iter().map(|target| target.view.clone()).collect();
                Ok(start::ring_path(&views, RING * height_world, RING_PX * self.world_per_px_256()))
            }
            Start::Circuit => {
                let tree = TreeOptions { across: settings.grid / 2 * 2, ..TreeOptions::for_circuit() };
                start::circuit_path(targets, *half_extents_world, &tree, &CircuitOptions::default(), progress)
            }
            Start::Tree => {
                let tree = TreeOptions { across: settings.grid / 2 * 2, ..TreeOptions::default() };
                let trail = TrailOptions { shorter: settings.shorter, ..TrailOptions::default() };
                start::tree_path(targets, *half_extents_world, &tree, &trail, progress)
            }
            Start::Hull => {
                let hull = HullOptions { across: settings.grid / 2 * 2, ..HullOptions::default() };
                start::hull_path(targets, *half_extents_world, &hull)
            }
            Start::Ball => {
                let count = if settings.control_points == 0 { BALL_POINTS } else { settings.control_points };
                // A ball well inside the pictures, and a width of 1.5 px of 256 that all views can see.
                let width_world = 3.0 * height_world / 512.0;
                Ok(start::ball_path(count, 0.4 * height_world, width_world, false, settings.seed))
            }
            Start::Contour | Start::Stripes | Start::Tour => Err(Task::Multiview.refused("start", settings)),
        }
    }
}

/// Control points of the first wire where the start chooses: dense drawings get wider spacing, so that a run stays within
/// about ten seconds on two cores.
const MOST_FIRST_POINTS: f64 = 3200.0;
/// How far strands that lie on one another are moved apart before the fit, px of a 256 px picture.
const JITTER_PX: f64 = 0.7;
/// The paper's largest number of points.
const BALL_POINTS: usize = 220;

/// Radius of the ring that a wire without a drawing starts as, shares of a view's height, and its width, px of a 256 px picture.
const RING: f64 = 0.3;
const RING_PX: f64 = 5.0;

/// Drawings of which this share can be shown agree as they are: bending them before the fit would only move their ink.
const ENOUGH_SHARE: f32 = 0.98;
/// Share of the start's progress that bending the drawings takes.
const BENDING_SHARE: f32 = 0.4;

impl tasks::Plan for Plan {
    fn task(&self) -> Task {
        Task::Multiview
    }

    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn targets(&self) -> &[Target] {
        &self.targets
    }

    fn begin(&mut self, from: Option<(Wire, usize)>, progress: &mut dyn FnMut(f32) -> bool) -> Result<Problem> {
        // What a wire from before grew from does not count any more.
        let bending = match &from {
            Some(_) => 1.0,
            None if self.bends_before() => BENDING_SHARE,
            None => 0.0,
        };
        let targets = self.targets_to_fit(&mut |share| progress(bending * share))?;
        let wire = match from {
            Some((wire, _)) => wire,
            None => self.first_wire(&targets, &mut |share| progress(bending + (1.0 - bending) * share))?,
        };
        Ok(self.problem(wire, targets))
    }

    fn sources(&self) -> &[String] {
        &self.sources
    }

    fn placed(&self, view: usize) -> Placed {
        self.placed(view)
    }

    fn is_compared(&self, view: usize) -> bool {
        self.is_drawn(view)
    }

    fn bent(&self, session: &Session) -> Option<Vec<(Image, Displacement)>> {
        let added = |((picture, during), before): ((Image, Displacement), &Displacement)| {
            let Displacement { mean_px, max_px } = during;
            (picture, Displacement { mean_px: mean_px + before.mean_px, max_px: max_px + before.max_px })
        };
        (self.settings.bend != Bend::None)
            .then(|| session.bent_targets().into_iter().zip(&self.moved_before).map(added).collect())
    }

    /// How much of each drawing could be shown, and, where drawings bend, what only the bent ones can be held against.
    fn complete(&self, result: &mut ResultReport, made: &Sculpture, session: &Session) {
        let Arrangement { targets, placements, .. } = &self.arrangement;
        for (view, (placement, coverable)) in result.views.iter_mut().zip(placements.iter().zip(&self.coverable)) {
            view.stretch = placement.stretch;
            view.target_coverable = Some(f64::from(coverable.share));
        }
        let Some(bent) = tasks::Plan::bent(self, session) else { return };
        for ((view, target), (picture, moved)) in result.views.iter_mut().zip(targets).zip(&bent) {
            let found =
                match_pictures(picture, |width, height| render(&made.wire, &target.view.with_size(width, height)));
            view.bent = Some(BentReport::new(found, moved.mean_px, moved.max_px));
        }
        let drawn = bent.iter().zip(targets).map(|((picture, _), target)| (picture, &target.view));
        result.length_over_lines = length_over_lines(result.shape.length, drawn);
    }
}
