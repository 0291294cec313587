//! The session: pulls a problem along, iteration by iteration, and decides what happens when.

use super::bending::{Bender, Field};
use super::engine::{Engine, Picture, Place, State, Step, Tally};
use super::handed::{fitted_size, size_within};
use super::history::{Event, EventKind, History};
use super::reinit::{NewPoint, Reinit, Volume, reinit};
use super::term::term_count;
use super::topology::TopologyEdit;
use super::{Courier, CpuEngine, Problem, Seen, Stage};
use crate::objective::{Displacement, Guidance, Guides, Progress, bend_ink};
use crate::rng::Rng;
use crate::view::Image;
use crate::wire::{Form, MAX_COORDINATE, Wire};
use crate::work::wait;
use crate::{Error, Result};
use std::collections::VecDeque;

/// Small pictures in which places that lack ink are looked for.
const LACK_SIZE_PX: usize = 64;

/// A fit under way. Pause by not calling [`Session::step`], cancel by dropping it, resume from [`Session::checkpoint`].
///
/// ```
/// use wire4d_core::optimize::{Problem, Recipe, Session};
/// use wire4d_core::view::{Image, Target, View};
/// use wire4d_core::wire::Wire;
///
/// # fn main() -> wire4d_core::Result<()> {
/// let mut ink = Image::new(32, 32);
/// ink.data[32 * 10..32 * 12].fill(1.0);
/// let [view, ..] = View::canonical(2.2, 32);
/// let wire = Wire::open_uniform((0..6).map(|i| [0.3 * f64::from(i) - 0.7, 0.0, 0.0, 0.05]).collect())?;
/// let mut recipe = Recipe::best();
/// recipe.set_iterations(20, 0.5);
/// let problem = Problem::for_drawings(wire, vec![Target { view, ink }], recipe);
///
/// let mut session = Session::new(problem.clone())?;
/// session.step(10);
/// let checkpoint = session.checkpoint();
/// session.step(10);
/// assert!(session.is_done());
/// // The same wire, bit for bit, from the checkpoint.
/// let mut resumed = Session::resume(problem, checkpoint)?;
/// resumed.step(10);
/// assert_eq!(resumed.best(), session.best());
/// # Ok(())
/// # }
/// ```
pub struct Session {
    pub(super) problem: Problem,
    /// World units in a pixel of a 256 px picture.
    pub(super) px_256: f64,
    pub(super) engine: Box<dyn Engine>,
    /// Form and knots of the present wire; its control points lie in `state`.
    pub(super) wire: Wire,
    pub(super) state: State,
    /// The state of the last iteration whose loss and step were finite, before that step.
    pub(super) good: State,
    /// The lowest loss of the present stage, and gradients since the last edit.
    pub(super) tally: Tally,
    /// Form and knots of the best wire; its control points lie in `tally`.
    pub(super) best_wire: Wire,
    pub(super) fields: Vec<Field>,
    pub(super) bender: Option<Bender>,
    pub(super) iteration: usize,
    pub(super) halvings: u32,
    /// Over how many iterations the tally's running means reach.
    pub(super) gradient_count: u32,
    pub(super) rng: Rng,
    pub(super) history: History,
    pub(super) events: Vec<Event>,
    /// The control points at which the planes of the pull to a surface were last laid; none without such a pull.
    pub(super) plane_points: Vec<[f32; 4]>,
    /// The control points at which neighbours were last looked for and the wire's speed measured; none where nobody asks.
    pub(super) strand_points: Vec<[f32; 4]>,
    pub(super) speed: f32,
    before: (State, Tally),
    steps: Vec<Step>,
    terms: Vec<f32>,
    pub(super) loaded: bool,
    /// Whether the engine still has to take over the problem's views.
    pub(super) unseen: bool,
    /// What is to be seen after each iteration to come, as far as it is something else.
    pub(super) ahead: VecDeque<Seen>,
    pub(super) guides: Guides,
    /// How many of those have been found to fail.
    failed: usize,
}

impl Session {
    /// A session on the processor.
    ///
    /// # Errors
    /// As [`Problem::check`].
    pub fn new(problem: Problem) -> Result<Session> {
        Session::with_engine(problem, Box::new(CpuEngine::new()))
    }

    /// A session on an engine of one's choice.
    ///
    /// # Errors
    /// As [`Problem::check`].
    pub fn with_engine(problem: Problem, engine: Box<dyn Engine>) -> Result<Session> {
        problem.check()?;
        let (min, max) = (problem.width.min_world as f32, problem.width.max_world as f32);
        let points: Vec<[f32; 4]> = problem
            .wire
            .control_points()
            .iter()
            .map(|point| point.map(|c| c as f32))
            .map(|[x, y, z, width]| [x, y, z, width.clamp(min, max)])
            .collect();
        let count = points.len();
        let state = State { points: points.clone(), adam: super::Adam::new(count) };
        let tally = Tally { best_points: points.clone(), ..Tally::new(count) };
        let names = problem.targets.iter().map(|target| target.view.name.clone());
        let history = History::new(names, problem.recipe.iterations());
        let grid = problem.recipe.bending.as_ref().map(|bending| bending.grid);
        let fields = grid.map_or(Vec::new(), |grid| vec![Field::new(grid); problem.targets.len()]);
        Ok(Session {
            engine,
            wire: problem.wire.clone(),
            good: state.clone(),
            strand_points: if problem.recipe.smooth.is_some() { points.clone() } else { Vec::new() },
            speed: 0.0,
            plane_points: if problem.surface.is_some() { points } else { Vec::new() },
            before: (state.clone(), tally.clone()),
            state,
            tally,
            best_wire: problem.wire.clone(),
            fields,
            bender: None,
            iteration: 0,
            halvings: 0,
            gradient_count: 0,
            rng: Rng::new(problem.seed, 0x6f70_7469),
            history,
            events: Vec::new(),
            steps: Vec::new(),
            terms: Vec::new(),
            loaded: false,
            unseen: false,
            ahead: VecDeque::new(),
            guides: Guides::default(),
            failed: 0,
            px_256: problem.world_per_px(256.0),
            problem,
        })
    }

    /// What is being fitted.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Iterations done.
    pub fn iteration(&self) -> usize {
        self.iteration
    }

    /// Iterations in all.
    pub fn total(&self) -> usize {
        self.problem.recipe.iterations()
    }

    /// Whether all iterations are done.
    pub fn is_done(&self) -> bool {
        self.iteration >= self.total()
    }

    /// Loss terms of every iteration so far.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Events so far.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The wire as it is now.
    pub fn wire(&self) -> Wire {
        with_points(&self.wire, &self.state.points)
    }

    /// The wire with the lowest image loss of the present stage so far; of the last stage in the end.
    pub fn best(&self) -> Wire {
        with_points(&self.best_wire, &self.tally.best_points)
    }

    /// Where the fit is computed now.
    pub fn place(&self) -> Place {
        self.engine.place()
    }

    /// Has a [`Mate`](super::Mate) compute some of the views from the next iteration on, where that is of use. The wire stays the same,
    /// bit for bit, also where the mate fails on the way.
    pub fn hire(&mut self, courier: Box<dyn Courier>) {
        self.engine.hire(courier);
    }

    /// How many compute it now: 1, and those that were hired and have work.
    pub fn workers(&self) -> usize {
        self.engine.workers()
    }

    /// Why the engine no longer computes where it was asked to, if so.
    pub fn engine_trouble(&self) -> Option<&Error> {
        self.engine.trouble()
    }

    /// `weight` (from 0) times the loss of `guidance` joins the loss from the next iteration on, in place of what has that
    /// name. It is no part of the problem or of a checkpoint: who resumes a session says again what guides it.
    pub fn guide_by(&mut self, name: &str, weight: f32, guidance: Box<dyn Guidance>) {
        self.guides.set(name, weight, guidance);
        self.failed = self.guides.troubles().len();
    }

    /// Goes on without the guidance of that name.
    pub fn stop_guiding(&mut self, name: &str) {
        self.guides.remove(name);
        self.failed = self.guides.troubles().len();
    }

    /// What was to guide and failed, by name, and why: from then on the session went on without it.
    pub fn guidance_troubles(&self) -> Vec<(String, Error)> {
        self.guides.troubles()
    }

    /// View `view` as last drawn, at the size that is fitted; blank before the first iteration. Waits as [`Session::step`].
    pub fn coverage(&mut self, view: usize) -> Image {
        wait(self.engine.fetch(Picture::Coverage).done());
        self.fetched_coverage(view)
    }

    fn fetched_coverage(&self, view: usize) -> Image {
        let (width, height) = fitted_size(&self.problem.targets[view], self.stage());
        let mut image = Image::new(width, height);
        if self.loaded {
            image.data.copy_from_slice(self.engine.picture(Picture::Coverage, view));
        }
        image
    }

    /// Every target as it is bent now, at its own size, and how far its ink moved. Clean targets if none bends.
    pub fn bent_targets(&self) -> Vec<(Image, Displacement)> {
        let targets = self.problem.targets.iter();
        match (&self.problem.recipe.bending, &self.bender) {
            (Some(bending), Some(bender)) => targets
                .zip(bender.fields())
                .map(|(target, field)| bend_ink(&target.ink, bending.grid, &field.values))
                .collect(),
            (Some(bending), None) => targets
                .zip(&self.fields)
                .map(|(target, field)| bend_ink(&target.ink, bending.grid, &field.values))
                .collect(),
            (None, _) => targets.map(|target| (target.ink.clone(), Displacement::default())).collect(),
        }
    }

    /// What was lost so far is no measure for what comes.
    pub(super) fn forget_best(&mut self) {
        self.best_wire = self.wire.clone();
        self.tally.best_points.clone_from(&self.state.points);
        self.tally.best_loss = f32::INFINITY;
    }

    /// Does up to `count` more iterations and says what happened. On a browser's device use [`Session::step_async`].
    pub fn step(&mut self, count: usize) -> Vec<Event> {
        wait(self.step_async(count))
    }

    /// [`Session::step`] where the thread has other things to do while a device computes.
    pub async fn step_async(&mut self, count: usize) -> Vec<Event> {
        let first_new = self.events.len();
        let end = self.iteration.saturating_add(count).min(self.total());
        while self.iteration < end {
            self.prepare().await;
            let batch = self.batch(end);
            self.advance(batch).await;
            if self.is_done() {
                self.record(EventKind::Done, self.iteration);
            }
        }
        self.events[first_new..].to_vec()
    }

    /// Whatever is due before the next iteration.
    async fn prepare(&mut self) {
        let (index, start) = self.stage_index();
        let i = self.iteration;
        let [planes_due, strands_due] = self.looks_round();
        if planes_due {
            self.plane_points.clone_from(&self.state.points);
        }
        if strands_due {
            self.strand_points.clone_from(&self.state.points);
        }
        if strands_due || self.speed == 0.0 {
            self.speed = self.measured_speed(&self.strand_points);
        }
        if i == start {
            self.load().await;
            // Losses at another size are no measure for this one.
            self.forget_best();
            self.record(EventKind::Stage, index + 1);
        } else if !self.loaded {
            self.load().await;
        } else {
            if planes_due {
                let planes = self.planes(&self.plane_points);
                self.engine.set_planes(planes);
            }
            if strands_due {
                let find = self.find_neighbours(&self.strand_points);
                self.engine.set_neighbours_found_by(find);
            }
        }
        if self.unseen {
            let sets = self.view_sets();
            self.engine.set_views(sets).done().await;
            self.unseen = false;
        }
        let stage = &self.problem.recipe.stages[index];
        let restart_at = |share: &f64| start + (share * stage.iterations as f64).round() as usize;
        if stage.restarts.iter().any(|share| restart_at(share) == i) {
            self.state.adam.restart();
            self.good.copy_from(&self.state);
            self.record(EventKind::Restart, self.state.points.len());
        }
        for e in 0..self.problem.recipe.topology.len() {
            let event = &self.problem.recipe.topology[e];
            if event.at.iteration(self.total()) == i {
                self.edit(&event.edit.clone()).await;
            }
        }
    }

    /// Whether planes and neighbours are looked for before the next iteration.
    pub(super) fn looks_round(&self) -> [bool; 2] {
        let (_, start) = self.stage_index();
        let i = self.iteration;
        let planes = self.problem.surface.as_ref().is_some_and(|surface| surface.is_due(i) || i == start);
        let strands =
            self.problem.recipe.smooth.as_ref().is_some_and(|smooth| i.is_multiple_of(smooth.every) || i == start);
        [planes, strands]
    }

    /// How many iterations can be done before anything else is due.
    fn batch(&self, end: usize) -> usize {
        let total = self.total();
        let most = if self.is_foreseen() { self.engine.batch().max(1) } else { 1 };
        let limit = (self.iteration + most).min(end);
        let recipe = &self.problem.recipe;
        let mut stage_start = 0;
        let is_due = |i: usize| {
            // Targets bend after an iteration, everything else happens before one.
            recipe.bending.as_ref().is_some_and(|bending| bending.is_due(i - 1, total))
                || self.problem.surface.as_ref().is_some_and(|surface| surface.is_due(i))
                || recipe.smooth.as_ref().is_some_and(|smooth| i.is_multiple_of(smooth.every))
                || recipe.topology.iter().any(|event| event.at.iteration(total) == i)
        };
        let mut stop = limit;
        for stage in &recipe.stages {
            let restart_at = |share: &f64| stage_start + (share * stage.iterations as f64).round() as usize;
            let borders = stage.restarts.iter().map(restart_at).chain([stage_start]);
            stop = borders.filter(|&border| border > self.iteration).fold(stop, usize::min);
            stage_start += stage.iterations;
        }
        let stop = (self.iteration + 1..stop).find(|&i| is_due(i)).unwrap_or(stop);
        stop - self.iteration
    }

    /// `batch` iterations on the engine, and what follows from them.
    async fn advance(&mut self, batch: usize) {
        let width = term_count(self.problem.targets.len());
        let window = self.gradient_window();
        let iterations = self.iteration..self.iteration + batch;
        self.steps.clear();
        for (k, i) in iterations.clone().enumerate() {
            let mut step = self.numbers(i);
            step.new_views = k > 0 && k <= self.ahead.len();
            if window > 0 {
                step.gradient_share = 1.0 / (self.gradient_count + k as u32 + 1).min(window) as f32;
            }
            self.steps.push(step);
        }
        self.terms.clear();
        self.terms.resize(width * batch, 0.0);
        self.before.0.copy_from(&self.state);
        self.before.1.copy_from(&self.tally);
        self.engine.advance(&mut self.state, &mut self.tally, &self.steps, &mut self.terms).done().await;
        for row in self.terms.chunks_exact(width) {
            self.history.push(row);
        }
        let usable = |state: &State| {
            state.is_finite() && state.points.iter().flatten().all(|c| f64::from(c.abs()) <= MAX_COORDINATE)
        };
        self.iteration = iterations.end;
        let failed = self.guides.troubles().len();
        if failed > self.failed {
            self.failed = failed;
            self.record(EventKind::Unguided, failed);
        }
        self.unseen |= !self.is_foreseen();
        (0..batch).for_each(|_| self.look());
        if !self.terms.iter().all(|term| term.is_finite()) || !usable(&self.state) {
            self.state.copy_from(&self.good);
            self.tally.copy_from(&self.before.1);
            self.halvings += 1;
            self.record(EventKind::Undone, self.halvings as usize);
            return;
        }
        std::mem::swap(&mut self.good, &mut self.before.0);
        let is_best = self.tally.best_loss < self.before.1.best_loss || self.steps.iter().any(Step::keeps_last);
        if is_best && self.best_wire.control_points().len() != self.state.points.len() {
            self.best_wire = self.wire.clone();
        }
        self.gradient_count = (self.gradient_count + batch as u32).min(window);
        self.bend(iterations.end - 1).await;
    }

    /// The numbers of iteration `i` in world units.
    pub(super) fn numbers(&self, i: usize) -> Step {
        let recipe = &self.problem.recipe;
        let progress = i as f64 / self.total() as f64;
        let half = self.half_world();
        let smooth = recipe.smooth.as_ref();
        let factor = 0.5f64.powi(self.halvings as i32) * 2.0 * self.px_256;
        let position = (recipe.position_rate_px.at(progress) * factor) as f32;
        let width = (recipe.width_rate_px.at(progress) * factor) as f32;
        Step {
            new_views: false,
            guided: !self.guides.is_empty(),
            progress: Progress { iteration: i, iterations: self.total() },
            rates: [position, position, position, width],
            adam: recipe.adam,
            level_ratio: recipe.level_ratio.at(progress) as f32,
            jerk_position: (recipe.jerk_position.at(progress) / (half * half)) as f32,
            jerk_width: (recipe.jerk_width.at(progress) / (half * half)) as f32,
            length: (recipe.length.at(progress) / half) as f32,
            surface: self.problem.surface.as_ref().map_or(0.0, |s| (s.weight / (half * half)) as f32),
            texture: self.problem.texture_weight as f32,
            width_bounds: [self.problem.width.min_world as f32, self.problem.width.max_world as f32],
            loss_scale: 1.0 / level_sum(recipe.level_ratio.at(progress) as f32),
            gradient_share: 0.0,
            elastic: smooth.map(|smooth| smooth.elastic(progress, self.px_256, self.speed)).unwrap_or_default(),
            clearance: smooth.map(|smooth| smooth.clearance(progress, self.px_256, self.speed)).unwrap_or_default(),
        }
    }

    /// Half the side of the cube that pictures show.
    fn half_world(&self) -> f64 {
        128.0 * self.px_256
    }

    /// Over how many iterations gradients are averaged; none where nothing asks for it.
    fn gradient_window(&self) -> u32 {
        let windows = self.problem.recipe.topology.iter().filter_map(|event| match &event.edit {
            TopologyEdit::Refine(refine) => Some(refine.window as u32),
            TopologyEdit::Reinit(_) | TopologyEdit::Respace(_) | TopologyEdit::Thin(_) => None,
        });
        windows.max().unwrap_or(0)
    }

    async fn bend(&mut self, iteration: usize) {
        let total = self.total();
        let (Some(bending), Some(bender)) = (&self.problem.recipe.bending, &mut self.bender) else { return };
        if !bending.is_due(iteration, total) {
            return;
        }
        self.engine.fetch(Picture::DCoverage).done().await;
        let engine = &self.engine;
        bender.update(iteration as f64 / total as f64, |view| engine.picture(Picture::DCoverage, view));
        for view in 0..self.problem.targets.len() {
            self.engine.set_target(view, bender.bent(view));
        }
    }

    async fn edit(&mut self, edit: &TopologyEdit) {
        let (kind, count) = match edit {
            TopologyEdit::Reinit(options) => (EventKind::Reinit, self.reinit(options).await),
            TopologyEdit::Refine(options) => {
                let mut wire = self.wire();
                let norms = &self.tally.gradient_norms;
                let count = options.apply(options.shortest_px * self.px_256, norms, &mut wire, &mut self.state);
                self.wire = wire;
                (EventKind::Refine, count)
            }
            TopologyEdit::Respace(respace) => {
                let wire = self.wire().respaced(respace.spacing_px * self.px_256, respace.hairpin_px * self.px_256);
                (EventKind::Respace, self.continue_with(wire))
            }
            TopologyEdit::Thin(thin) => {
                let before = self.state.points.len();
                let wire = self.wire().without_spare_knots(thin.tolerance_px * self.px_256);
                let kept = self.continue_with(wire);
                (EventKind::Thin, if kept > 0 { before - kept } else { 0 })
            }
        };
        self.tally.gradient_norms.clear();
        self.tally.gradient_norms.resize(self.state.points.len(), 0.0);
        self.gradient_count = 0;
        self.good.copy_from(&self.state);
        let has_planes = self.problem.surface.is_some();
        if has_planes {
            self.plane_points.clone_from(&self.state.points);
        }
        if self.problem.recipe.smooth.is_some() {
            self.strand_points.clone_from(&self.state.points);
            self.speed = self.measured_speed(&self.strand_points);
        }
        if matches!(kind, EventKind::Refine | EventKind::Respace | EventKind::Thin) && count > 0 {
            self.load().await;
        } else if has_planes {
            let planes = self.planes(&self.plane_points);
            self.engine.set_planes(planes);
        }
        self.record(kind, count);
    }

    /// Goes on with another wire in this one's place, and says how many control points it has; 0 where there is none.
    fn continue_with(&mut self, wire: Result<Wire>) -> usize {
        let Ok(wire) = wire else { return 0 };
        let points: Vec<[f32; 4]> = wire.control_points().iter().map(|point| point.map(|c| c as f32)).collect();
        self.state = State { adam: super::Adam::new(points.len()), points };
        self.wire = wire;
        self.forget_best();
        self.state.points.len()
    }

    async fn reinit(&mut self, options: &Reinit) -> usize {
        let half_world = self.half_world();
        let mut views = Vec::new();
        if options.new_point == NewPoint::LackingInk {
            // Drawn afresh, so that a resumed session sees what an uninterrupted one does.
            let mut terms = vec![0.0; term_count(self.problem.targets.len())];
            let step = self.numbers(self.iteration);
            self.engine.evaluate(&self.state.points, &step, &mut terms, &mut Vec::new()).done().await;
            self.engine.fetch(Picture::Coverage).done().await;
            // A view that is compared with nothing lacks nothing.
            let compared = |&(v, _): &(usize, _)| self.problem.view_weight(v) > 0.0;
            for (v, target) in self.problem.targets.iter().enumerate().filter(compared) {
                let coverage = self.fetched_coverage(v);
                let mut lack = self.fitted_ink(v);
                let ink = lack.clone();
                for (lack, c) in lack.data.iter_mut().zip(&coverage.data) {
                    *lack = (*lack - c).max(0.0);
                }
                let (width, height) = size_within(target, LACK_SIZE_PX);
                let camera = target.view.with_size(width, height).camera();
                views.push((camera, ink.resized(width, height), lack.resized(width, height)));
            }
        }
        let below = (options.below_px * self.px_256) as f32;
        let volume = Volume { half_world, views: &views };
        let splice = self.wire.form() == Form::Spline;
        reinit(options, below, self.wire.closed(), splice, &volume, &mut self.state, &mut self.rng)
    }

    /// The stage of the next iteration and where it starts; the last one that has any when all is done.
    fn stage_index(&self) -> (usize, usize) {
        let stages = &self.problem.recipe.stages;
        let (mut found, mut start) = ((0, 0), 0);
        for (i, stage) in stages.iter().enumerate() {
            if stage.iterations > 0 && start <= self.iteration {
                found = (i, start);
            }
            start += stage.iterations;
        }
        found
    }

    pub(super) fn stage(&self) -> &Stage {
        &self.problem.recipe.stages[self.stage_index().0]
    }

    fn record(&mut self, kind: EventKind, count: usize) {
        self.events.push(Event { iteration: self.iteration, kind, count });
    }
}

/// Σ of the level weights, so that losses with different ones compare; six levels stand for any number.
fn level_sum(ratio: f32) -> f32 {
    (0..6).map(|l| ratio.powi(l)).sum()
}

/// `wire` with other control points. The session only holds points that a wire takes.
fn with_points(wire: &Wire, points: &[[f32; 4]]) -> Wire {
    let mut wire = wire.clone();
    let points: Vec<[f64; 4]> = points.iter().map(|point| point.map(f64::from)).collect();
    let set = wire.set_control_points(&points);
    debug_assert!(set.is_ok(), "{set:?}");
    wire
}
