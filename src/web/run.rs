//! A run that the worker pulls: `step` a little, look, `step` again.

use super::made::{Made, WireData};
use super::parse_settings;
use super::pictures::{PictureSet, ViewTarget};
use crate::tasks::multiview;
use wasm_bindgen::prelude::*;

/// A fit under way.
#[wasm_bindgen]
pub struct Run(multiview::Run);

#[wasm_bindgen]
impl Run {
    /// Arranges the drawings and grows the first wire. `tell(words, share)` hears how far it is, `note(words)` what a
    /// person should know about the drawings.
    pub fn start(
        pictures: PictureSet,
        settings: &str,
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let say = |words: &str, share: f64| {
            // A page that cannot listen does not stop the run.
            let _ = tell.call2(&JsValue::NULL, &words.into(), &share.into());
        };
        let settings = parse_settings(settings)?;
        say("Trying which drawing goes where", 0.0);
        let plan = multiview::plan(&pictures.drawings(&settings)?, &settings)?;
        for words in plan.notes() {
            let _ = note.call1(&JsValue::NULL, &words.into());
        }
        let words =
            format!("Finding a way for the wire; {:.0}% of the ink can be shown", 100.0 * plan.mean_coverable());
        say(&words, 0.0);
        let run = multiview::Run::start(plan, &settings, &mut |share| {
            say(&words, share.into());
            true
        })?;
        Ok(Run(run))
    }

    /// Up to `count` more iterations.
    pub fn step(&mut self, count: usize) {
        self.0.step(count);
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
