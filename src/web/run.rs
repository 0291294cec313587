//! A run that the worker pulls: `step` a little, look, `step` again.

use super::made::{Made, WireData};
use super::pictures::{DrawingSet, ViewTarget};
use super::{json, parse_settings};
use crate::Result;
use crate::settings::Settings;
use crate::tasks::multiview::{self, Plan};
use wasm_bindgen::prelude::*;

/// Iterations after which the page is asked whether to go on at all.
const MOST_AT_ONCE: usize = 64;

/// A fit under way.
#[wasm_bindgen]
pub struct Run(multiview::Run);

/// The worker's ears: `tell(words, share)` hears how far the start is, `note(words)` what a person should know about
/// the drawings. A page that cannot listen does not stop the run.
struct Ears<'a> {
    tell: &'a js_sys::Function,
    note: &'a js_sys::Function,
}

impl Ears<'_> {
    fn tell(&self, words: &str, share: f32) {
        let _ = self.tell.call2(&JsValue::NULL, &words.into(), &share.into());
    }

    fn plan(&self, drawings: &DrawingSet, settings: &Settings) -> Result<Plan> {
        self.tell("Finding where the drawings agree…", 0.0);
        let plan = multiview::plan(drawings.drawings(), settings)?;
        for words in plan.notes() {
            let _ = self.note.call1(&JsValue::NULL, &words.into());
        }
        Ok(plan)
    }
}

#[wasm_bindgen]
impl Run {
    /// Arranges the drawings and grows the first wire.
    pub async fn start(
        drawings: &DrawingSet,
        settings: &str,
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let (ears, settings) = (Ears { tell, note }, parse_settings(settings)?);
        let plan = ears.plan(drawings, &settings)?;
        let share = 100.0 * plan.mean_coverable();
        let words = format!("Finding a way for the wire… {share:.0}% of the ink can be shown");
        ears.tell(&words, 0.0);
        let run = multiview::Run::start_async(plan, &settings, &mut |share| {
            ears.tell(&words, share);
            true
        })
        .await?;
        Ok(Run(run))
    }

    /// Goes on from a checkpoint of a run of the same drawings.
    pub async fn resume(
        drawings: &DrawingSet,
        settings: &str,
        checkpoint: &[u8],
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let (ears, settings) = (Ears { tell, note }, parse_settings(settings)?);
        let plan = ears.plan(drawings, &settings)?;
        let run = multiview::Run::resume_async(plan, &settings, checkpoint, &mut |share| {
            ears.tell("Going on from there…", share);
            true
        })
        .await?;
        Ok(Run(run))
    }

    /// Up to `count` more iterations; what happened, as JSON. Returns early when the fit moves elsewhere: so many may take
    /// long there.
    pub async fn step(&mut self, count: usize) -> String {
        let (end, backend) = (self.iteration() + count, self.0.session().place().backend);
        let mut events = Vec::new();
        while self.iteration() < end.min(self.iterations()) && self.0.session().place().backend == backend {
            events.extend(self.0.step_async(MOST_AT_ONCE.min(end - self.iteration())).await);
        }
        json(&events)
    }

    /// Where the fit is computed now, and why, as JSON: see [`super::place`].
    pub fn place(&self) -> String {
        json(&self.0.session().place())
    }

    /// Iterations done.
    #[wasm_bindgen(getter)]
    pub fn iteration(&self) -> usize {
        self.0.session().iteration()
    }

    /// Iterations in all.
    #[wasm_bindgen(getter)]
    pub fn iterations(&self) -> usize {
        self.0.session().total()
    }

    /// Mean over the views of how far each is from its drawing, as last seen; not a number before the first iteration.
    #[wasm_bindgen(getter)]
    pub fn loss(&self) -> f32 {
        let views = self.0.plan().arrangement.targets.len();
        let last = self.0.session().history().rows().next_back();
        // Columns: total, each view's, the wire's own.
        last.map_or(f32::NAN, |row| row[1..=views].iter().sum::<f32>() / views as f32)
    }

    /// The wire as it is now.
    pub fn wire(&self) -> WireData {
        WireData(self.0.session().wire())
    }

    /// The whole state, for [`Run::resume`].
    pub fn checkpoint(&self) -> Vec<u8> {
        self.0.checkpoint()
    }

    /// Number of views.
    #[wasm_bindgen(getter)]
    pub fn target_count(&self) -> usize {
        self.0.plan().arrangement.targets.len()
    }

    /// A view's target as arranged, not bent.
    pub fn target(&self, index: usize) -> ViewTarget {
        let plan = self.0.plan();
        ViewTarget::new(plan, index, &plan.arrangement.targets[index].ink)
    }

    /// The best wire so far, measured. Its targets are the drawings as they were bent.
    pub fn finish(&self) -> Made {
        let targets = match self.0.bent() {
            None => (0..self.target_count()).map(|index| self.target(index)).collect(),
            Some(bent) => {
                let bent = bent.iter().enumerate();
                bent.map(|(index, (image, _))| ViewTarget::new(self.0.plan(), index, image)).collect()
            }
        };
        Made::new(self.0.sculpture(), targets, self.0.result())
    }
}
