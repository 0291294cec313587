//! A fit of any task under way: what was asked for, and the session that pulls it along.

use super::engine::engine;
use super::plan::{Placed, Plan};
use super::saved::SavedRun;
use super::trail::{Trail, due_after};
use crate::Result;
use crate::export::replay;
use crate::metrics::{ArrangementReport, EventReport, Report, ResultReport, TimeReport};
use crate::objective::{Displacement, Guidance};
use crate::optimize::{Courier, Event, Place, Session, wait};
use crate::sculpture::{Carried, MadeWith, Sculpture};
use crate::settings::Settings;
use crate::view::{Image, Target};
use crate::wire::Wire;

/// A fit under way.
///
/// ```
/// use wire4d::mesh::Shape;
/// use wire4d::settings::Task;
/// use wire4d::tasks::{Run, fill};
///
/// # fn main() -> wire4d::Result<()> {
/// let pairs = [("preset", "fast"), ("iterations", "2"), ("curve_spacing", "0.2"), ("backend", "cpu")];
/// let settings = Task::Fill.settings(pairs)?;
/// let plan = fill::plan(&fill::Given::shape(Shape::Sphere), &settings, &mut |_| true)?.expect("nobody gave it up");
/// let mut run = Run::start(plan, &mut |_| true)?;
/// while !run.session().is_done() {
///     run.step(1)?;
/// }
/// assert!(run.sculpture().wire.closed());
/// assert!(run.result().surface.is_some(), "how it covers the sphere");
/// # Ok(())
/// # }
/// ```
pub struct Run {
    plan: Box<dyn Plan>,
    session: Session,
    /// The iteration before which other views are due, where they change.
    seen_until: usize,
    trail: Trail,
}

/// For how many changes of views these are made at once: views of one iteration leave cores without work, and a graphics
/// card without its batch.
const CHANGES_AHEAD: usize = 8;

impl Run {
    /// Makes the first wire and readies the fit. `progress` is told how far the start is (0 to 1) and cuts it short by
    /// returning false.
    ///
    /// # Errors
    /// As [`Plan::begin`] and [`Problem::check`]; [`Error::Device`](crate::Error::Device) if a graphics card is asked for
    /// and there is none that computes rightly.
    pub fn start(plan: impl Plan + 'static, progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        wait(Run::start_async(plan, progress))
    }

    /// [`Run::start`] where the thread has other things to do while a device gets ready.
    ///
    /// # Errors
    /// As [`Run::start`].
    pub async fn start_async(mut plan: impl Plan + 'static, progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        // First of all: who asks for a device that is not there should not have to wait for it.
        let engine = engine(plan.settings().backend).await?;
        let problem = plan.begin(None, progress)?;
        let seen_until = plan.change_views_every();
        Ok(Run {
            plan: Box::new(plan),
            session: Session::with_engine(problem, engine)?,
            seen_until,
            trail: Trail::default(),
        })
    }

    /// Goes on from a checkpoint of a run of the same things: with the same settings bit for bit as if it had never been
    /// interrupted, with others from here on as these say. `progress` as in [`Run::start`].
    ///
    /// # Errors
    /// [`Error::Input`](crate::Error::Input) for bytes that are no checkpoint, damaged or of other things;
    /// [`Error::Setting`](crate::Error::Setting) for a setting that would have made it another run.
    pub fn resume(plan: impl Plan + 'static, checkpoint: &[u8], progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        wait(Run::resume_async(plan, checkpoint, progress))
    }

    /// [`Run::resume`] where the thread has other things to do while a device gets ready.
    ///
    /// # Errors
    /// As [`Run::resume`].
    pub async fn resume_async(
        mut plan: impl Plan + 'static,
        checkpoint: &[u8],
        progress: &mut dyn FnMut(f32) -> bool,
    ) -> Result<Run> {
        let saved = SavedRun::from_bytes(checkpoint)?.for_run(plan.targets(), plan.settings())?;
        let problem = plan.begin(Some((saved.wire().clone(), saved.iteration())), progress)?;
        let session = Session::resume_with_engine(problem, saved, engine(plan.settings().backend).await?)?;
        let seen_until = session.iteration().next_multiple_of(plan.change_views_every().max(1));
        Ok(Run { plan: Box::new(plan), session, seen_until, trail: Trail::default() })
    }

    /// The whole state, to go on from later with the task's `resume`.
    pub fn checkpoint(&self) -> Vec<u8> {
        SavedRun::new(self.plan.targets(), self.settings(), self.session.checkpoint()).to_bytes()
    }

    /// Does up to `count` more iterations and says what happened. To pause, stop calling; to cancel, drop the run.
    ///
    /// # Errors
    /// Where the task's next views cannot be fitted; the wire so far is still there.
    pub fn step(&mut self, count: usize) -> Result<Vec<Event>> {
        wait(self.step_async(count))
    }

    /// [`Run::step`] where the thread has other things to do while a device computes.
    ///
    /// # Errors
    /// Likewise.
    pub async fn step_async(&mut self, count: usize) -> Result<Vec<Event>> {
        let mut events = Vec::new();
        let mut left = count.min(self.session.total() - self.session.iteration());
        while left > 0 {
            let (iteration, total) = (self.session.iteration(), self.session.total());
            self.trail.note(iteration, total, || self.session.wire());
            let batch = left.min(self.look()?).min(due_after(iteration, total) - iteration);
            events.extend(self.session.step_async(batch).await);
            left -= batch;
        }
        Ok(events)
    }

    /// Changes the views if that is due, and says for how many iterations they stay.
    fn look(&mut self) -> Result<usize> {
        let every = self.plan.change_views_every();
        if every == 0 {
            return Ok(usize::MAX);
        }
        let iteration = self.session.iteration();
        if iteration >= self.seen_until {
            // What stays for long need not be known before its time.
            let changes = if every == 1 { CHANGES_AHEAD.min(self.session.total() - iteration) } else { 1 };
            let iterations: Vec<usize> = (0..changes).map(|change| iteration + change * every).collect();
            self.session.set_views(self.plan.views_from(&iterations))?;
            self.seen_until = iteration + changes * every;
        }
        Ok(self.seen_until - iteration)
    }

    /// What else is to guide it from here on: see [`Session::guide_by`].
    pub fn guide_by(&mut self, name: &str, weight: f32, guidance: Box<dyn Guidance>) {
        self.session.guide_by(name, weight, guidance);
    }

    /// See [`Session::stop_guiding`].
    pub fn stop_guiding(&mut self, name: &str) {
        self.session.stop_guiding(name);
    }

    /// Who else is to compute views of it: see [`Session::hire`].
    pub fn hire(&mut self, courier: Box<dyn Courier>) {
        self.session.hire(courier);
    }

    /// What the report compares the wire's views with; blank for those that are only guided.
    pub fn targets(&self) -> &[Target] {
        self.plan.targets()
    }

    /// Whether view `view` of the targets has anything to be compared with; else it is there to be guided.
    pub fn is_compared(&self, view: usize) -> bool {
        self.plan.is_compared(view)
    }

    /// How view `view` of the targets came to its picture.
    pub fn placed(&self, view: usize) -> Placed {
        self.plan.placed(view)
    }

    /// Each view's target as it is bent now and how far its ink moved at most (what bending before and during the fit
    /// moved it, added up); `None` where nothing bends.
    pub fn bent(&self) -> Option<Vec<(Image, Displacement)>> {
        self.plan.bent(&self.session)
    }

    /// Whether its views show less of a wire than all of it: see [`Run::draw`].
    pub fn hides(&self) -> bool {
        self.plan.hides()
    }

    /// The session, for its progress, history and pictures.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The settings it runs with.
    pub fn settings(&self) -> &Settings {
        self.plan.settings()
    }

    /// The best wire so far with the views of [`Run::targets`].
    pub fn sculpture(&self) -> Sculpture {
        Sculpture {
            wire: self.session.best(),
            views: self.targets().iter().map(|target| target.view.clone()).collect(),
            made_with: MadeWith {
                task: self.plan.task().name().into(),
                seed: self.settings().seed,
                settings: self.settings().to_map(),
                ..MadeWith::default()
            },
            carried: Carried::default(),
        }
    }

    /// How its best wire so far was found, as [`replay::decode`](crate::export::replay::decode) reads it; since it was
    /// resumed, if it was. Empty before the first iteration.
    pub fn replay(&self) -> Vec<u8> {
        replay::encode(&self.trail.to(self.session.iteration(), self.session.best()))
    }

    /// What view `view` of the targets shows of a wire.
    pub fn draw(&self, wire: &Wire, view: usize) -> Image {
        let Image { width, height, .. } = self.targets()[view].ink;
        self.plan.draw(wire, view, [width, height])
    }

    /// The `result` part of a report: the best wire so far against [`Run::targets`], and what the task adds.
    pub fn result(&self) -> ResultReport {
        let made = self.sculpture();
        let compared = |(view, target): (usize, &Target)| self.plan.is_compared(view).then(|| target.ink.clone());
        let pictures: Vec<_> = self.targets().iter().enumerate().map(compared).collect();
        let mut result =
            ResultReport::measure_with(&made, &pictures, |view, size| self.plan.draw(&made.wire, view, size));
        self.plan.complete(&mut result, &made, &self.session);
        result
    }

    fn arrangement(&self) -> Vec<ArrangementReport> {
        let reported = |view| {
            let Placed { view, source, mirrored, quarter_turns, .. } = self.plan.placed(view);
            let source = self.plan.sources()[source?].clone();
            Some(ArrangementReport { view: view.name, source, mirrored, quarter_turns })
        };
        (0..self.targets().len()).filter_map(reported).collect()
    }

    /// A whole report. `time` comes from the caller, who has a clock.
    pub fn report(&self, time: TimeReport, stopped: bool) -> Report {
        let Place { backend, device, .. } = self.session.place();
        Report {
            task: self.plan.task().name().into(),
            seed: self.settings().seed,
            backend: backend.into(),
            device,
            settings: self.settings().to_map(),
            stopped,
            time,
            result: self.result(),
            arrangement: self.arrangement(),
            reading: Vec::new(),
            guidance: None,
            distillation: None,
            events: event_reports(&self.session),
        }
    }

    /// The loss of every iteration, term by term, as `loss.csv`.
    pub fn loss_csv(&self) -> String {
        self.session.history().to_csv()
    }
}

/// What happened so far.
fn event_reports(session: &Session) -> Vec<EventReport> {
    let word = |kind| serde_json::to_value(kind).ok().and_then(|kind| kind.as_str().map(str::to_owned));
    let report = |event: &Event| EventReport {
        iteration: event.iteration,
        kind: word(event.kind).unwrap_or_default(),
        count: event.count,
    };
    session.events().iter().map(report).collect()
}
