//! A run that the worker pulls: `step` a little, look, `step` again.

use crate::crew::{Ask, Asked};
use crate::guidance::{
    Asks, Contexts, DenoiserObject, DiffusionOptions, EncoderObject, GuidanceFunction, Networks, Vectors, WordsOptions,
    by_diffusion, by_words,
};
use crate::insight::Insight;
use crate::made::{Made, WireData};
use crate::pictures::{DrawingSet, Ink, ViewTarget};
use crate::subject::Subject;
use crate::surface::Surface;
use crate::{json, parse_settings};
use wasm_bindgen::prelude::*;
use wire4d::Result;
use wire4d::optimize::Session;
use wire4d::settings::{Settings, Task};
use wire4d::tasks::{self, fill, multiview, stroke};
use wire4d::view::{Image, Target};

/// Iterations after which the page is asked whether to go on at all.
const MOST_AT_ONCE: usize = 64;

/// A fit under way.
#[wasm_bindgen]
pub struct Run(tasks::Run);

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

    fn note(&self, words: &str) {
        let _ = self.note.call1(&JsValue::NULL, &words.into());
    }

    fn drawings(&self, drawings: &DrawingSet, settings: &Settings) -> Result<multiview::Plan> {
        self.tell("Finding where the drawings agree…", 0.0);
        let plan = multiview::plan_with(drawings.drawings(), drawings.guided(), settings)?;
        plan.notes().iter().for_each(|words| self.note(words));
        Ok(plan)
    }

    fn picture(&self, subject: &mut Subject, settings: &Settings) -> Result<stroke::Plan> {
        self.tell("Guessing the solid behind the picture…", 0.0);
        let plan = subject.plan(settings)?;
        plan.notes().iter().for_each(|words| self.note(words));
        self.tell("Drawing its lines…", 0.5);
        Ok(plan)
    }

    fn surface(&self, surface: &mut Surface, settings: &Settings) -> Result<fill::Plan> {
        let words = "Laying one line over the shape…";
        self.tell(words, 0.0);
        let plan = surface.plan(settings, &mut |share| {
            self.tell(words, share);
            true
        })?;
        plan.notes().iter().for_each(|words| self.note(words));
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
        let (ears, settings) = (Ears { tell, note }, parse_settings(Task::Multiview, settings)?);
        let plan = ears.drawings(drawings, &settings)?;
        let words = match drawings.drawings() {
            [] => "Laying a first ring…".to_owned(),
            _ => {
                let share = 100.0 * plan.mean_coverable();
                format!("Finding a way for the wire… {share:.0}% of the ink can be shown")
            }
        };
        ears.tell(&words, 0.0);
        let run = tasks::Run::start_async(plan, &mut |share| {
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
        let (ears, settings) = (Ears { tell, note }, parse_settings(Task::Multiview, settings)?);
        let plan = ears.drawings(drawings, &settings)?;
        let run = tasks::Run::resume_async(plan, checkpoint, &mut |share| {
            ears.tell("Going on from there…", share);
            true
        })
        .await?;
        Ok(Run(run))
    }

    /// Finds the solid behind one picture and lays the first wire on it.
    pub async fn start_stroke(
        subject: &mut Subject,
        settings: &str,
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let settings = parse_settings(Task::Stroke, settings)?;
        let plan = Ears { tell, note }.picture(subject, &settings)?;
        Ok(Run(tasks::Run::start_async(plan, &mut |_| true).await?))
    }

    /// Goes on from a checkpoint of a run of the same picture.
    pub async fn resume_stroke(
        subject: &mut Subject,
        settings: &str,
        checkpoint: &[u8],
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let settings = parse_settings(Task::Stroke, settings)?;
        let plan = Ears { tell, note }.picture(subject, &settings)?;
        Ok(Run(tasks::Run::resume_async(plan, checkpoint, &mut |_| true).await?))
    }

    /// Lays the first wire over a shape.
    pub async fn start_fill(
        surface: &mut Surface,
        settings: &str,
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let settings = parse_settings(Task::Fill, settings)?;
        let plan = Ears { tell, note }.surface(surface, &settings)?;
        Ok(Run(tasks::Run::start_async(plan, &mut |_| true).await?))
    }

    /// Goes on from a checkpoint of a run of the same shape.
    pub async fn resume_fill(
        surface: &mut Surface,
        settings: &str,
        checkpoint: &[u8],
        tell: &js_sys::Function,
        note: &js_sys::Function,
    ) -> Result<Run, JsError> {
        let settings = parse_settings(Task::Fill, settings)?;
        let plan = Ears { tell, note }.surface(surface, &settings)?;
        Ok(Run(tasks::Run::resume_async(plan, checkpoint, &mut |_| true).await?))
    }

    fn session(&self) -> &Session {
        self.0.session()
    }

    fn targets(&self) -> &[Target] {
        self.0.targets()
    }

    /// Up to `count` more iterations; what happened, as JSON. Returns early when the fit moves elsewhere: so many may take
    /// long there.
    pub async fn step(&mut self, count: usize) -> Result<String, JsError> {
        let (end, backend) = (self.iteration() + count, self.session().place().backend);
        let mut events = Vec::new();
        while self.iteration() < end.min(self.iterations()) && self.session().place().backend == backend {
            let at_once = MOST_AT_ONCE.min(end - self.iteration());
            events.extend(self.0.step_async(at_once).await?);
        }
        Ok(json(&events))
    }

    /// Has a [`Mate`](crate::crew::Mate) of another worker compute some of the views from the next step on: `ask` brings it a message
    /// and promises its answer. Once that fails the run goes on without; neither changes a bit of the wire.
    pub fn hire(&mut self, ask: Ask) {
        self.0.hire(Box::new(Asked::new(ask)));
    }

    /// `weight` (from 0) times the loss of `guidance` joins the loss from the next iteration on, in place of what has that
    /// name. Neither settings nor checkpoints keep it: who resumes a run sets it again.
    ///
    /// ```js
    /// // As much ink in every picture as there is in a tenth of it.
    /// run.setGuidance("a tenth", 10, async (images, { iteration, iterations }) => {
    ///   let loss = 0;
    ///   const grad = images.map(({ ink }) => {
    ///     const off = ink.reduce((sum, value) => sum + value, 0) / ink.length - 0.1;
    ///     loss += off * off;
    ///     return new Float32Array(ink.length).fill((2 * off) / ink.length);
    ///   });
    ///   return { loss, grad };
    /// });
    /// ```
    #[wasm_bindgen(js_name = setGuidance)]
    pub fn set_guidance(&mut self, name: &str, weight: f32, guidance: GuidanceFunction) {
        self.0.guide_by(name, weight, Box::new(Asks::new(guidance)));
    }

    /// [`Run::set_guidance`] by networks that know words: each view becomes like the words of its vector.
    #[wasm_bindgen(js_name = guideByWords)]
    pub fn guide_by_words(
        &mut self,
        name: &str,
        weight: f32,
        networks: Networks,
        vectors: Vectors,
        options: Option<WordsOptions>,
    ) -> Result<(), JsError> {
        let options = options.map_or(JsValue::UNDEFINED, JsValue::from);
        let learned = by_words(networks, vectors, &options, &self.0)?;
        self.0.guide_by(name, weight, Box::new(learned));
        Ok(())
    }

    /// [`Run::set_guidance`] by a diffusion model, whose latents `encoder` makes: each view becomes what the model thinks that
    /// its context is of.
    #[wasm_bindgen(js_name = guideByDiffusion)]
    pub fn guide_by_diffusion(
        &mut self,
        name: &str,
        weight: f32,
        denoiser: DenoiserObject,
        encoder: EncoderObject,
        contexts: Contexts,
        options: DiffusionOptions,
    ) -> Result<(), JsError> {
        let distilled = by_diffusion(denoiser, encoder, contexts, options, self.0.settings().seed)?;
        self.0.guide_by(name, weight, Box::new(distilled));
        Ok(())
    }

    /// Goes on without the guidance of that name.
    #[wasm_bindgen(js_name = stopGuidance)]
    pub fn stop_guidance(&mut self, name: &str) {
        self.0.stop_guiding(name);
    }

    /// Why what was to guide no longer does: a sentence each.
    #[wasm_bindgen(js_name = guidanceTroubles)]
    pub fn guidance_troubles(&self) -> Vec<String> {
        self.session().guidance_troubles().into_iter().map(|(_, error)| error.to_string()).collect()
    }

    /// Where the fit is computed now, and why, as JSON: see [`crate::place`].
    pub fn place(&self) -> String {
        json(&self.session().place())
    }

    /// How many workers compute it now: 1, and mates that are at work.
    #[wasm_bindgen(getter)]
    pub fn workers(&self) -> usize {
        self.session().workers()
    }

    /// Iterations done.
    #[wasm_bindgen(getter)]
    pub fn iteration(&self) -> usize {
        self.session().iteration()
    }

    /// Iterations in all.
    #[wasm_bindgen(getter)]
    pub fn iterations(&self) -> usize {
        self.session().total()
    }

    /// Mean over the views of how far each is from its target, as last seen; not a number before the first iteration. Of views
    /// that nothing is drawn of, the whole loss.
    #[wasm_bindgen(getter)]
    pub fn loss(&self) -> f32 {
        // What a task adds while it runs is compared, too.
        let is_compared = |&view: &usize| view >= self.target_count() || self.0.is_compared(view);
        let views: Vec<usize> = (0..self.session().problem().targets.len()).filter(is_compared).collect();
        let last = self.session().history().rows().next_back();
        // Columns: total, each view's, the wire's own.
        let mean = |row: &[f32]| views.iter().map(|view| row[1 + view]).sum::<f32>() / views.len() as f32;
        last.map_or(f32::NAN, |row| if views.is_empty() { row[0] } else { mean(row) })
    }

    /// The wire as it is now.
    pub fn wire(&self) -> WireData {
        WireData(self.session().wire())
    }

    /// What pulls at the wire as it is now, and how its views compare at every scale. It changes no bit of the run.
    pub fn insight(&self) -> Insight {
        Insight(self.session().insight())
    }

    /// The whole state, for [`Run::resume`], [`Run::resume_stroke`] or [`Run::resume_fill`].
    pub fn checkpoint(&self) -> Vec<u8> {
        self.0.checkpoint()
    }

    /// Number of views.
    #[wasm_bindgen(getter)]
    pub fn target_count(&self) -> usize {
        self.targets().len()
    }

    /// A view's target, not bent.
    pub fn target(&self, index: usize) -> ViewTarget {
        self.target_as(index, &self.targets()[index].ink)
    }

    /// View `index` with `ink` for what it should show.
    fn target_as(&self, index: usize, ink: &Image) -> ViewTarget {
        ViewTarget::new(self.0.placed(index), ink)
    }

    /// The best wire so far, measured. Its targets are the drawings as they were bent.
    pub fn finish(&self) -> Made {
        let bent = self.0.bent();
        let targets = match bent {
            None => (0..self.target_count()).map(|index| self.target(index)).collect(),
            Some(bent) => bent.iter().enumerate().map(|(index, (image, _))| self.target_as(index, image)).collect(),
        };
        let mut sculpture = self.0.sculpture();
        sculpture.carried.replay = self.0.replay();
        let made = Made::new(sculpture, targets, self.0.result());
        if !self.0.hides() {
            return made;
        }
        let wire = self.session().best();
        let shown = |view| Ink::new(&self.0.draw(&wire, view));
        made.with_shown((0..self.target_count()).map(shown).collect())
    }
}
