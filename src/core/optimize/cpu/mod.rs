//! The processor's engine: samples, then each view on its own (in parallel with the `threads` feature, or elsewhere: see
//! [`crew`]), then the sum in view order, so that the number of threads and workers changes no bit.

mod crew;
mod curve;
mod mate;
mod message;
mod view;

pub use crew::{Answer, Courier};
pub use mate::Mate;

use super::engine::{Engine, FindNeighbours, Picture, Place, Scene, SceneView, State, Step, Tally};
use super::term::{Term, term_count};
use super::{RasterKind, Work, wait};
use crate::objective::{Guides, Neighbours, Pyramid, Rendered, TextureGuidance};
use crate::parallel;
use crew::{Asked, Crew, Given};
use curve::{Curve, Losses, Strand};
use message::Order;
use std::collections::VecDeque;
use view::ViewEngine;

/// Computes on the processor.
#[derive(Default)]
pub struct CpuEngine {
    scene: Option<Curve>,
    views: Vec<ViewEngine>,
    samples: Vec<[f32; 4]>,
    d_samples: Vec<[f32; 4]>,
    d_points_image: Vec<[f32; 4]>,
    d_points: Vec<[f32; 4]>,
    why: Option<String>,
    texture: Option<TextureGuidance>,
    guides: Guides,
    /// What guidance is shown: room for all that views have seen.
    shown: Vec<Rendered>,
    /// The views of the coming iterations, where they are others than now.
    ahead: VecDeque<Vec<SceneView>>,
    kinds: (RasterKind, Pyramid),
    crew: Crew,
    level_ratio: f32,
}

/// The weighted losses of what guides.
#[derive(Default)]
struct Guided {
    texture: f32,
    others: f32,
}

impl CpuEngine {
    /// One without a scene.
    pub fn new() -> Self {
        Self::default()
    }

    /// One that was chosen for a reason: a sentence for people.
    pub fn because(why: impl Into<String>) -> Self {
        CpuEngine { why: Some(why.into()), ..Self::default() }
    }

    /// [`Engine::evaluate`], done when it returns: waits for whatever guides.
    pub fn evaluate_now(&mut self, points: &[[f32; 4]], step: &Step, terms: &mut [f32], d_points: &mut Vec<[f32; 4]>) {
        wait(self.evaluate_async(points, step, terms, d_points));
    }

    async fn evaluate_async(
        &mut self,
        points: &[[f32; 4]],
        step: &Step,
        terms: &mut [f32],
        d_points: &mut Vec<[f32; 4]>,
    ) {
        let Some(Curve { sampling, .. }) = &self.scene else { return };
        sampling.apply(points, &mut self.samples);
        self.level_ratio = step.level_ratio;
        let guided = (self.texture.is_some() && step.texture > 0.0) || !self.guides.is_empty();
        self.turn_to_crew(guided);
        let asked = if self.crew.is_at_work() { Some(self.draw_together(points).await) } else { None };
        if asked.is_none() {
            self.draw(guided);
        }
        let guided = if guided { self.guide(step).await } else { Guided::default() };
        // Looked at while others are still at their views.
        let curve = self.scene.as_mut().map_or(Losses::default(), |scene| scene.look(points, &self.samples, step));
        if let Some(asked) = asked {
            self.gather(asked).await;
        }
        self.add_up(points, step, &guided, curve, terms, d_points);
    }

    /// Draws all views here, and goes all the way back where nothing else is to look at them.
    fn draw(&mut self, guided: bool) {
        let Some(Curve { strokes, .. }) = &self.scene else { return };
        let (samples, level_ratio) = (&self.samples, self.level_ratio);
        parallel::each_mut(&mut self.views, 2, |_, view| {
            view.draw(samples, strokes, level_ratio);
            if !guided {
                view.pull_back(samples);
            }
        });
    }

    /// Shares views out where that is due. What guides has to see them all here.
    fn turn_to_crew(&mut self, guided: bool) {
        if guided {
            self.crew.rest();
        } else if self.crew.is_due
            && let Some(Curve { sampling, strokes, .. }) = &self.scene
        {
            let (raster, pyramid) = self.kinds;
            self.crew.share_out(&Given { sampling, strokes, raster, pyramid }, &self.views);
        }
    }

    /// Draws its own share of the views while others draw theirs; what they have still to answer, and whether the view that all
    /// draw a part of came together.
    async fn draw_together(&mut self, points: &[[f32; 4]]) -> (Asked, bool) {
        let CpuEngine { scene, views, samples, crew, level_ratio, .. } = self;
        let (samples, level_ratio) = (&*samples, *level_ratio);
        let strokes = scene.as_ref().map_or(&[][..], |scene| &scene.strokes);
        let mut asked = crew.begin(points, level_ratio);
        let split = crew.split();
        if let Some((number, part)) = split {
            views[number].draw_part(samples, strokes, part);
        }
        let own: Vec<usize> = (0..views.len()).filter(|&number| crew.is_own(number)).collect();
        own.iter().for_each(|&number| views[number].draw(samples, strokes, level_ratio));
        let mut is_divided = false;
        if let Some((number, _)) = split {
            let view = &mut views[number];
            is_divided = crew.gather_parts(&mut asked, view).await;
            if is_divided {
                view.finish(level_ratio);
                crew.pull_back(&mut asked, number, &view.seen.d_coverage);
                view.pull_back_part();
            } else {
                view.take_part(|_| {});
                view.draw(samples, strokes, level_ratio);
                view.pull_back(samples);
            }
        }
        own.iter().for_each(|&number| views[number].pull_back(samples));
        (asked, is_divided)
    }

    /// Takes over what others drew, and computes here what somebody failed to answer.
    async fn gather(&mut self, (asked, is_divided): (Asked, bool)) {
        let CpuEngine { scene, views, samples, crew, level_ratio, .. } = self;
        let strokes = scene.as_ref().map_or(&[][..], |scene| &scene.strokes);
        let divided = crew.split().filter(|_| is_divided);
        let parts = crew.gather(asked, views, samples.len(), is_divided).await;
        let mut missing = crew.drop_lost();
        if let Some((number, _)) = divided {
            match parts {
                Some(parts) => views[number].pull_back_together(samples, &parts),
                None => missing.push(number),
            }
        }
        for number in missing {
            views[number].draw(samples, strokes, *level_ratio);
            views[number].pull_back(samples);
        }
    }

    /// Asks everything that looks at the views beside the comparison, and goes all the way back.
    async fn guide(&mut self, step: &Step) -> Guided {
        let CpuEngine { views, shown, texture, guides, samples, .. } = self;
        shown.extend(views.iter_mut().map(|view| std::mem::take(&mut view.seen)));
        let mut guided = Guided::default();
        if let Some(texture) = texture.as_mut().filter(|_| step.texture > 0.0) {
            shown.iter_mut().for_each(Rendered::clear_gradient);
            guided.texture = step.texture * texture.guide_now(shown);
            shown.iter_mut().for_each(|view| view.pull(step.texture));
        }
        guided.others = guides.guide(shown, step.progress).await;
        views.iter_mut().zip(shown.drain(..)).for_each(|(view, seen)| view.seen = seen);
        parallel::each_mut(views, 2, |_, view| view.pull_back(samples));
        guided
    }

    /// All that does not look at views, and the sums.
    fn add_up(
        &mut self,
        points: &[[f32; 4]],
        step: &Step,
        guided: &Guided,
        mut curve: Losses,
        terms: &mut [f32],
        d_points: &mut Vec<[f32; 4]>,
    ) {
        let Some(scene) = &self.scene else { return };
        self.d_samples.clear();
        self.d_samples.resize(self.samples.len(), [0.0; 4]);
        for view in &self.views {
            for (sum, d_sample) in self.d_samples.iter_mut().zip(&view.d_samples) {
                for c in 0..4 {
                    sum[c] += d_sample[c];
                }
            }
        }
        self.d_points_image.clear();
        self.d_points_image.resize(points.len(), [0.0; 4]);
        scene.sampling.apply_transpose(&self.d_samples, &mut self.d_points_image);
        d_points.clone_from(&self.d_points_image);
        scene.add_to(points, step, &mut curve, d_points);
        let Losses { jerk, length, surface, strand: [bending, tightness, evenness, clearance] } = curve;

        let count = self.views.len();
        for (term, view) in terms[1..].iter_mut().zip(&self.views) {
            *term = view.loss;
        }
        let mut set = |term: Term, loss: f32| terms[term.at(count)] = loss;
        set(Term::Jerk, jerk);
        set(Term::Length, length);
        set(Term::Surface, surface);
        set(Term::Texture, guided.texture);
        set(Term::Guidance, guided.others);
        set(Term::Bending, bending);
        set(Term::Tightness, tightness);
        set(Term::Evenness, evenness);
        set(Term::Clearance, clearance);
        terms[0] = terms[1..].iter().sum();
    }

    async fn advance_async(&mut self, state: &mut State, tally: &mut Tally, steps: &[Step], terms: &mut [f32]) {
        let row = terms.len() / steps.len().max(1);
        let mut d_points = std::mem::take(&mut self.d_points);
        for (step, terms) in steps.iter().zip(terms.chunks_exact_mut(row.max(1))) {
            self.evaluate_async(&state.points, step, terms, &mut d_points).await;
            tally.note(step, &state.points, terms, &self.d_points_image);
            state.step(step, &d_points);
            self.look();
        }
        self.d_points = d_points;
    }

    /// Turns to the next views, if there are any.
    fn look(&mut self) {
        if let Some(views) = self.ahead.pop_front() {
            for (number, (engine, view)) in self.views.iter_mut().zip(views).enumerate() {
                engine.look(view);
                self.crew.look(number, engine);
            }
        }
    }

    /// Whether it need not wait for anybody.
    fn is_done_at_once(&self) -> bool {
        self.guides.is_empty() && self.crew.is_empty()
    }

    async fn fetch_async(&mut self, picture: Picture) {
        let CpuEngine { scene, views, samples, crew, level_ratio, .. } = self;
        let order = match picture {
            Picture::Coverage => Order::Coverage,
            Picture::DCoverage => Order::DCoverage,
        };
        let strokes = scene.as_ref().map_or(&[][..], |scene| &scene.strokes);
        crew.fetch(order, views).await;
        for number in crew.drop_lost() {
            views[number].draw(samples, strokes, *level_ratio);
        }
    }

    /// The loss terms at `points`, and the gradient of each on its own: in the order of a row of terms, without the total.
    /// Together they are the gradient that [`Engine::evaluate`] tells, but for rounding. Whatever [`Guides`] there are it is
    /// done without.
    pub(super) fn take_apart(&mut self, points: &[[f32; 4]], step: &Step) -> (Vec<f32>, Vec<Vec<[f32; 4]>>) {
        let zeros = || vec![[0.0; 4]; points.len()];
        let mut terms = vec![0.0; term_count(self.views.len())];
        let mut total = Vec::new();
        self.evaluate_now(points, &Step { texture: 0.0, ..*step }, &mut terms, &mut total);
        let Some(mut curve) = self.scene.take() else { return (terms, Vec::new()) };
        let of_view = |view: &ViewEngine| {
            let mut d_points = zeros();
            curve.sampling.apply_transpose(&view.d_samples, &mut d_points);
            d_points
        };
        let mut gradients: Vec<_> = self.views.iter().map(of_view).collect();
        let of_pictures = self.d_points_image.clone();
        for term in Term::ALL {
            let mut d_points = zeros();
            let step = step.of_curve_only(term);
            let mut losses = curve.look(points, &self.samples, &step);
            curve.add_to(points, &step, &mut losses, &mut d_points);
            gradients.push(d_points);
        }
        self.scene = Some(curve);
        if step.texture > 0.0 && self.texture.is_some() {
            // Joins the pictures' way back: what that brings more is the texture's.
            self.evaluate_now(points, step, &mut terms, &mut total);
            let of_texture = &mut gradients[Term::Texture.at(self.views.len()) - 1];
            for ((d, with), without) in of_texture.iter_mut().zip(&self.d_points_image).zip(&of_pictures) {
                *d = [0, 1, 2, 3].map(|c| with[c] - without[c]);
            }
        }
        (terms, gradients)
    }

    /// The image terms' share of the gradient last evaluated.
    pub fn d_points_image(&self) -> &[[f32; 4]] {
        &self.d_points_image
    }
}

impl Engine for CpuEngine {
    fn load(&mut self, scene: Scene) -> Work<'_> {
        let Scene { sampling, strokes, jerk, views, raster, pyramid, planes, texture, guides, nodes, neighbours } =
            scene;
        let engine = |view| ViewEngine::new(view, raster, pyramid);
        self.views = views.into_iter().map(engine).collect();
        let strand = nodes.map(|nodes| Strand::new(nodes, neighbours));
        self.scene = Some(Curve { sampling, strokes, jerk, planes, strand, d_samples: Vec::new() });
        self.kinds = (raster, pyramid);
        self.crew.rest();
        (self.texture, self.guides) = (texture.map(TextureGuidance::new), guides);
        self.shown.clear();
        self.ahead.clear();
        Work::Done(())
    }

    fn set_target(&mut self, view: usize, ink: &[f32]) {
        self.views[view].target.data.copy_from_slice(ink);
        self.crew.set_target(view, ink);
    }

    fn set_views(&mut self, sets: Vec<Vec<SceneView>>) -> Work<'_> {
        self.ahead = sets.into();
        self.look();
        Work::Done(())
    }

    fn set_planes(&mut self, planes: Vec<[f32; 4]>) {
        if let Some(curve) = &mut self.scene {
            curve.planes = planes;
        }
    }

    fn set_neighbours_found_by(&mut self, find: FindNeighbours) {
        if let Some(strand) = self.scene.as_mut().and_then(|curve| curve.strand.as_mut()) {
            strand.find = Some(find);
        }
    }

    fn set_neighbours(&mut self, neighbours: Neighbours) {
        if let Some(strand) = self.scene.as_mut().and_then(|curve| curve.strand.as_mut()) {
            (strand.neighbours, strand.find) = (neighbours, None);
        }
    }

    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a> {
        if self.is_done_at_once() {
            self.evaluate_now(points, step, terms, d_points);
            return Work::Done(());
        }
        Work::later(self.evaluate_async(points, step, terms, d_points))
    }

    fn advance<'a>(
        &'a mut self,
        state: &'a mut State,
        tally: &'a mut Tally,
        steps: &'a [Step],
        terms: &'a mut [f32],
    ) -> Work<'a> {
        if self.is_done_at_once() {
            wait(self.advance_async(state, tally, steps, terms));
            return Work::Done(());
        }
        Work::later(self.advance_async(state, tally, steps, terms))
    }

    fn fetch(&mut self, picture: Picture) -> Work<'_> {
        if !self.crew.is_at_work() {
            return Work::Done(());
        }
        Work::later(self.fetch_async(picture))
    }

    fn picture(&self, picture: Picture, view: usize) -> &[f32] {
        match picture {
            Picture::Coverage => &self.views[view].seen.coverage,
            Picture::DCoverage => &self.views[view].seen.d_coverage,
        }
    }

    fn batch(&self) -> usize {
        1
    }

    fn hire(&mut self, courier: Box<dyn Courier>) {
        self.crew.hire(courier);
    }

    fn workers(&self) -> usize {
        self.crew.at_work().max(1)
    }

    fn place(&self) -> Place {
        let why = self.why.clone().unwrap_or_else(|| "The processor does the work.".into());
        Place { backend: "cpu", device: "processor".into(), why }
    }
}
