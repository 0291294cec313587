//! A fit of any task under way: what was asked for, and the session that pulls it along.

use super::engine::engine;
use super::fit::event_reports;
use super::saved::SavedRun;
use crate::Result;
use crate::metrics::{ArrangementReport, Report, ResultReport, TimeReport};
use crate::objective::Displacement;
use crate::optimize::{Event, Place, Problem, Seen, Session, wait};
use crate::sculpture::{MadeWith, Sculpture, render};
use crate::settings::{Settings, Task};
use crate::view::{Image, Target, View};
use crate::wire::Wire;

/// How a picture was laid into a view.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Placed {
    /// The view that shows it.
    pub view: View,
    /// Which of the pictures given it is, from 0; `None` for a side that nobody gave a picture of.
    pub source: Option<usize>,
    /// Whether it is mirrored left to right.
    pub mirrored: bool,
    /// By how many quarters it is turned counter-clockwise after mirroring.
    pub quarter_turns: u8,
    /// Share of its ink that any object at all could show, 0 to 1.
    pub coverable: f32,
}

/// All that a task decided before a fit, with the settings it was made with.
pub trait Plan {
    /// The settings.
    fn settings(&self) -> &Settings;

    /// What the report compares the wire's views with.
    fn targets(&self) -> &[Target];

    /// The fit of a wire from an iteration on, or of the first wire. `progress` is told how far that is (0 to 1) and cuts it
    /// short by returning false.
    ///
    /// # Errors
    /// Where there is no first wire.
    fn prepare(
        self,
        from: Option<(Wire, usize)>,
        progress: &mut dyn FnMut(f32) -> bool,
    ) -> Result<(Box<dyn Job>, Problem)>;
}

/// What a task brings to a fit under way, and what it adds to the report.
pub trait Job {
    /// The task.
    fn task(&self) -> Task;

    /// What the report compares the wire's views with.
    fn targets(&self) -> &[Target];

    /// Names of the pictures given, as the person knows them.
    fn sources(&self) -> &[String] {
        &[]
    }

    /// How view `view` of the targets came to its picture: the first ones to those given, in their order.
    fn placed(&self, view: usize) -> Placed {
        Placed {
            view: self.targets()[view].view.clone(),
            source: (view < self.sources().len()).then_some(view),
            mirrored: false,
            quarter_turns: 0,
            coverable: 1.0,
        }
    }

    /// Whether its views show less of a wire than all of it.
    fn hides(&self) -> bool {
        false
    }

    /// What view `view` of the targets shows of a wire, at `width` x `height` px.
    fn draw(&self, wire: &Wire, view: usize, [width, height]: [usize; 2], _settings: &Settings) -> Image {
        render(wire, &self.targets()[view].view.with_size(width, height))
    }

    /// Each view's target as it is bent now and how far its ink moved at most; `None` where nothing bends.
    fn bent(&self, _run: &Run) -> Option<Vec<(Image, Displacement)>> {
        None
    }

    /// Adds what only this task knows to what was measured of `made`.
    fn complete(&self, _result: &mut ResultReport, _made: &Sculpture, _run: &Run) {}

    /// After how many iterations other views are fitted; 0 keeps the first ones.
    fn change_views_every(&self, _settings: &Settings) -> usize {
        0
    }

    /// What is fitted from iteration `iteration` on, where views change.
    fn views_from(&self, _iteration: usize, _settings: &Settings) -> Seen {
        Seen { targets: self.targets().to_vec(), ..Seen::default() }
    }
}

/// A fit under way.
pub struct Run {
    job: Box<dyn Job>,
    settings: Settings,
    session: Session,
}

impl Run {
    /// Makes the first wire and readies the fit. `progress` is told how far the start is (0 to 1) and cuts it short by
    /// returning false.
    ///
    /// # Errors
    /// As [`Plan::prepare`] and [`Problem::check`]; [`Error::Device`](crate::Error::Device) if a graphics card is asked for
    /// and there is none that computes rightly.
    pub fn start(plan: impl Plan, progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        wait(Run::start_async(plan, progress))
    }

    /// [`Run::start`] where the thread has other things to do while a device gets ready.
    ///
    /// # Errors
    /// As [`Run::start`].
    pub async fn start_async(plan: impl Plan, progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        let settings = plan.settings().clone();
        // First of all: who asks for a device that is not there should not have to wait for it.
        let engine = engine(settings.backend).await?;
        let (job, problem) = plan.prepare(None, progress)?;
        Ok(Run { job, settings, session: Session::with_engine(problem, engine)? })
    }

    /// Goes on from a checkpoint of a run of the same things: with the same settings bit for bit as if it had never been
    /// interrupted, with others from here on as these say. `progress` as in [`Run::start`].
    ///
    /// # Errors
    /// [`Error::Input`](crate::Error::Input) for bytes that are no checkpoint, damaged or of other things;
    /// [`Error::Setting`](crate::Error::Setting) for a setting that would have made it another run.
    pub fn resume(plan: impl Plan, checkpoint: &[u8], progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        wait(Run::resume_async(plan, checkpoint, progress))
    }

    /// [`Run::resume`] where the thread has other things to do while a device gets ready.
    ///
    /// # Errors
    /// As [`Run::resume`].
    pub async fn resume_async(
        plan: impl Plan,
        checkpoint: &[u8],
        progress: &mut dyn FnMut(f32) -> bool,
    ) -> Result<Run> {
        let settings = plan.settings().clone();
        let saved = SavedRun::from_bytes(checkpoint)?.for_run(plan.targets(), &settings)?;
        let (job, problem) = plan.prepare(Some((saved.wire().clone(), saved.iteration())), progress)?;
        let session = Session::resume_with_engine(problem, saved, engine(settings.backend).await?)?;
        Ok(Run { job, settings, session })
    }

    /// The whole state, to go on from later with the task's `resume`.
    pub fn checkpoint(&self) -> Vec<u8> {
        SavedRun::new(self.job.targets(), &self.settings, self.session.checkpoint()).to_bytes()
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
            let batch = left.min(self.look()?);
            events.extend(self.session.step_async(batch).await);
            left -= batch;
        }
        Ok(events)
    }

    /// Changes the views if that is due, and says for how many iterations they stay.
    fn look(&mut self) -> Result<usize> {
        let every = self.job.change_views_every(&self.settings);
        if every == 0 {
            return Ok(usize::MAX);
        }
        let iteration = self.session.iteration();
        if iteration > 0 && iteration.is_multiple_of(every) {
            self.session.set_views(self.job.views_from(iteration, &self.settings))?;
        }
        Ok(every - iteration % every)
    }

    /// What the report compares the wire's views with.
    pub fn targets(&self) -> &[Target] {
        self.job.targets()
    }

    /// How view `view` of the targets came to its picture.
    pub fn placed(&self, view: usize) -> Placed {
        self.job.placed(view)
    }

    /// Each view's target as it is bent now and how far its ink moved at most (what bending before and during the fit
    /// moved it, added up); `None` where nothing bends.
    pub fn bent(&self) -> Option<Vec<(Image, Displacement)>> {
        self.job.bent(self)
    }

    /// Whether its views show less of a wire than all of it: see [`Run::draw`].
    pub fn hides(&self) -> bool {
        self.job.hides()
    }

    /// The session, for its progress, history and pictures.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The settings it runs with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The best wire so far with the views of [`Run::targets`].
    pub fn sculpture(&self) -> Sculpture {
        Sculpture {
            wire: self.session.best(),
            views: self.targets().iter().map(|target| target.view.clone()).collect(),
            made_with: MadeWith {
                task: self.job.task().name().into(),
                seed: self.settings.seed,
                settings: self.settings.to_map(),
                ..MadeWith::default()
            },
        }
    }

    /// What view `view` of the targets shows of a wire.
    pub fn draw(&self, wire: &Wire, view: usize) -> Image {
        let Image { width, height, .. } = self.targets()[view].ink;
        self.job.draw(wire, view, [width, height], &self.settings)
    }

    /// The `result` part of a report: the best wire so far against [`Run::targets`], and what the task adds.
    pub fn result(&self) -> ResultReport {
        let made = self.sculpture();
        let pictures: Vec<_> = self.targets().iter().map(|target| Some(target.ink.clone())).collect();
        let mut result = ResultReport::measure_with(&made, &pictures, |view, size| {
            self.job.draw(&made.wire, view, size, &self.settings)
        });
        self.job.complete(&mut result, &made, self);
        result
    }

    fn arrangement(&self) -> Vec<ArrangementReport> {
        let reported = |view| {
            let Placed { view, source, mirrored, quarter_turns, .. } = self.job.placed(view);
            let source = self.job.sources()[source?].clone();
            Some(ArrangementReport { view: view.name, source, mirrored, quarter_turns })
        };
        (0..self.targets().len()).filter_map(reported).collect()
    }

    /// A whole report. `time` comes from the caller, who has a clock.
    pub fn report(&self, time: TimeReport, stopped: bool) -> Report {
        let Place { backend, device, .. } = self.session.place();
        Report {
            task: self.job.task().name().into(),
            seed: self.settings.seed,
            backend: backend.into(),
            device,
            settings: self.settings.to_map(),
            stopped,
            time,
            result: self.result(),
            arrangement: self.arrangement(),
            reading: Vec::new(),
            events: event_reports(&self.session),
        }
    }

    /// The loss of every iteration, term by term, as `loss.csv`.
    pub fn loss_csv(&self) -> String {
        self.session.history().to_csv()
    }
}
