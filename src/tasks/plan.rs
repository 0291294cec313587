//! The contract of a task: what it decided before a fit, and what it adds to one under way.

use crate::Result;
use crate::metrics::ResultReport;
use crate::objective::Displacement;
use crate::optimize::{Problem, Seen, Session};
use crate::sculpture::{Sculpture, render};
use crate::settings::{Settings, Task};
use crate::view::{Image, Target, View};
use crate::wire::Wire;

/// How a picture was laid into a view.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
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
    /// The task.
    fn task(&self) -> Task;

    /// The settings.
    fn settings(&self) -> &Settings;

    /// What the report compares the wire's views with; blank for those that are only guided.
    fn targets(&self) -> &[Target];

    /// The fit of a wire from an iteration on, or of the first wire. `progress` is told how far that is (0 to 1) and cuts it
    /// short by returning false. Called once, before anything below.
    ///
    /// # Errors
    /// Where there is no first wire.
    fn begin(&mut self, from: Option<(Wire, usize)>, progress: &mut dyn FnMut(f32) -> bool) -> Result<Problem>;

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

    /// Whether view `view` of the targets has anything to be compared with; else it is there to be guided.
    fn is_compared(&self, _view: usize) -> bool {
        true
    }

    /// Whether its views show less of a wire than all of it.
    fn hides(&self) -> bool {
        false
    }

    /// What view `view` of the targets shows of a wire, at `width` x `height` px.
    fn draw(&self, wire: &Wire, view: usize, [width, height]: [usize; 2]) -> Image {
        render(wire, &self.targets()[view].view.with_size(width, height))
    }

    /// Each view's target as it is bent now and how far its ink moved at most; `None` where nothing bends.
    fn bent(&self, _session: &Session) -> Option<Vec<(Image, Displacement)>> {
        None
    }

    /// Adds what only this task knows to what was measured of `made`.
    fn complete(&self, _result: &mut ResultReport, _made: &Sculpture, _session: &Session) {}

    /// After how many iterations other views are fitted; 0 keeps the first ones.
    fn change_views_every(&self) -> usize {
        0
    }

    /// What is fitted from each of `iterations` on, where views change.
    fn views_from(&self, iterations: &[usize]) -> Vec<Seen> {
        let same = || Seen { targets: self.targets().to_vec(), ..Seen::default() };
        iterations.iter().map(|_| same()).collect()
    }
}
