//! A fit of any task under way: what was asked for, and the session that pulls it along.

use super::fit::event_reports;
use super::saved::SavedRun;
use crate::Result;
use crate::metrics::{ArrangementReport, Report, ResultReport, TimeReport};
use crate::optimize::{Event, Place, Seen, Session, wait};
use crate::sculpture::{MadeWith, Sculpture, render};
use crate::settings::Settings;
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

/// What a task brings to a fit, and what it adds to the report.
pub trait Job: Sized {
    /// All that was decided before the fit.
    type Plan;
    /// The task's name in files and reports.
    const TASK: &'static str;

    /// All that was decided before the fit.
    fn plan(&self) -> &Self::Plan;

    /// What the report compares the wire's views with.
    fn targets(&self) -> &[Target];

    /// Names of the pictures given, as the person knows them.
    fn sources(&self) -> &[String];

    /// How view `view` of the targets came to its picture.
    fn placed(&self, view: usize) -> Placed;

    /// What view `view` of the targets shows of a wire, at `width` x `height` px.
    fn draw(&self, wire: &Wire, view: usize, [width, height]: [usize; 2], _settings: &Settings) -> Image {
        render(wire, &self.targets()[view].view.with_size(width, height))
    }

    /// Adds what only this task knows to what was measured of `made`.
    fn complete(&self, _result: &mut ResultReport, _made: &Sculpture, _run: &Run<Self>) {}

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
pub struct Run<J: Job> {
    job: J,
    settings: Settings,
    session: Session,
}

impl<J: Job> Run<J> {
    pub(super) fn new(job: J, settings: &Settings, session: Session) -> Run<J> {
        Run { job, settings: settings.clone(), session }
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

    pub(super) fn job(&self) -> &J {
        &self.job
    }

    /// All that was decided before the fit.
    pub fn plan(&self) -> &J::Plan {
        self.job.plan()
    }

    /// What the report compares the wire's views with.
    pub fn targets(&self) -> &[Target] {
        self.job.targets()
    }

    /// How view `view` of the targets came to its picture.
    pub fn placed(&self, view: usize) -> Placed {
        self.job.placed(view)
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
                task: J::TASK.into(),
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
            task: J::TASK.into(),
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
