//! The processor's engine: samples, then each view on its own (in parallel with the `threads` feature), then the sum in
//! view order, so that the number of threads changes no bit.

use super::engine::{Engine, Picture, Place, Scene, SceneView, State, Step, Tally};
use super::term::Term;
use super::{RasterKind, Work, wait};
use crate::objective::{
    Guides, MultiscaleMse, Neighbours, Pyramid, Rendered, TextureGuidance, clearance_and_gradient,
    elastic_and_gradient, length_and_gradient, surface_and_gradient,
};
use crate::parallel;
use crate::raster::{BandRaster, ExactRaster, Raster};
use crate::view::{Image, Occluder, drop_hidden};
use crate::wire::{Jerk, LinearMap, Nodes, Stroke};
use std::collections::VecDeque;

/// One view's share of an iteration, with its buffers.
struct ViewEngine {
    target: Image,
    occluder: Option<Occluder>,
    raster: Box<dyn Raster>,
    mse: MultiscaleMse<f32>,
    seen: Rendered,
    /// Of each sample; empty where nothing hides any.
    visibilities: Vec<f32>,
    vertices: Vec<[f32; 3]>,
    d_vertices: Vec<[f32; 3]>,
    d_samples: Vec<[f32; 4]>,
    loss: f32,
}

impl ViewEngine {
    fn new(view: SceneView, raster: RasterKind, pyramid: Pyramid) -> Self {
        let SceneView { camera, target, weight, occluder, texture_mask } = view;
        let raster: Box<dyn Raster> = match raster {
            RasterKind::Band => Box::new(BandRaster::new()),
            RasterKind::Exact => Box::new(ExactRaster::new()),
        };
        let mut engine = ViewEngine {
            occluder,
            raster,
            mse: MultiscaleMse::new(pyramid, target.width, target.height),
            seen: Rendered::new(camera, target.width, target.height, weight),
            visibilities: Vec::new(),
            vertices: Vec::new(),
            d_vertices: Vec::new(),
            d_samples: Vec::new(),
            loss: 0.0,
            target,
        };
        engine.seen.count(texture_mask.as_ref());
        engine
    }

    /// Another view of the same size.
    fn look(&mut self, view: SceneView) {
        let SceneView { camera, target, weight, occluder, texture_mask } = view;
        (self.target, self.occluder) = (target, occluder);
        (self.seen.camera, self.seen.weight) = (camera, weight);
        self.seen.count(texture_mask.as_ref());
    }

    /// Samples to vertices, those thin that are hidden.
    fn project(&mut self, samples: &[[f32; 4]], strokes: &[Stroke]) {
        self.vertices.clear();
        self.vertices.extend(samples.iter().map(|sample| {
            let [x, y, radius] = self.seen.camera.project(sample);
            [x, y, radius.max(0.0)]
        }));
        self.visibilities.clear();
        let Some(occluder) = &self.occluder else { return };
        for (sample, [x, y, radius]) in samples.iter().zip(&mut self.vertices) {
            let visibility = occluder.visibility([*x, *y], self.seen.camera.depth(sample));
            self.visibilities.push(visibility);
            *radius *= visibility;
        }
        drop_hidden(&self.visibilities, strokes, &mut self.vertices);
    }

    /// The adjoint of [`ViewEngine::project`].
    fn project_vjp(&mut self, samples: &[[f32; 4]]) {
        self.d_samples.clear();
        let pairs = samples.iter().zip(&self.d_vertices);
        let camera = &self.seen.camera;
        let Some(occluder) = &self.occluder else {
            self.d_samples.extend(pairs.map(|(sample, d_vertex)| camera.project_vjp(sample, d_vertex)));
            return;
        };
        self.d_samples.extend(pairs.zip(&self.visibilities).map(|((sample, d_vertex), &visibility)| {
            let [x, y, z, width] = *sample;
            let d_thinned = camera.project_vjp(&[x, y, z, visibility * width], d_vertex);
            occluder.thinned_vjp(camera, sample, visibility, d_thinned)
        }));
    }

    /// Project, draw, compare.
    fn draw(&mut self, samples: &[[f32; 4]], strokes: &[Stroke], step: &Step) {
        self.project(samples, strokes);
        let coverage = self.raster.forward(self.target.width, self.target.height, &self.vertices, strokes);
        let Rendered { coverage: seen, d_coverage: d_seen, weight, .. } = &mut self.seen;
        seen.copy_from_slice(coverage);
        let (loss, d_coverage) = self.mse.evaluate(seen, &self.target.data, step.level_ratio, *weight);
        self.loss = loss;
        d_seen.copy_from_slice(d_coverage);
    }

    /// All the way back.
    fn pull_back(&mut self, samples: &[[f32; 4]]) {
        self.raster.backward(&self.seen.d_coverage, &mut self.d_vertices);
        self.project_vjp(samples);
    }
}

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
}

/// The part of a scene that is about the curve.
struct Curve {
    sampling: LinearMap<f32>,
    strokes: Vec<Stroke>,
    jerk: Jerk<f32>,
    planes: Vec<[f32; 4]>,
    strand: Option<Strand>,
}

/// The weighted losses of what guides.
#[derive(Default)]
struct Guided {
    texture: f32,
    others: f32,
}

/// The wire as a thing that bends and takes room, with its buffers.
struct Strand {
    nodes: Nodes<f32>,
    neighbours: Neighbours,
    /// Place, first and second derivative at the nodes, and the gradients to them.
    values: [Vec<[f32; 4]>; 3],
    d_values: [Vec<[f32; 4]>; 3],
}

impl Strand {
    fn new(nodes: Nodes<f32>, neighbours: Neighbours) -> Strand {
        let neighbours = if neighbours.starts.is_empty() { Neighbours::none(nodes.len()) } else { neighbours };
        let zeros = || vec![[0.0; 4]; nodes.len()];
        Strand { values: [0; 3].map(|_| zeros()), d_values: [0; 3].map(|_| zeros()), nodes, neighbours }
    }

    /// Bending, tightness, evenness, clearance; adds their gradient to `d_points`.
    fn evaluate(&mut self, points: &[[f32; 4]], step: &Step, d_points: &mut [[f32; 4]]) -> [f32; 4] {
        if !step.is_of_strand() {
            return [0.0; 4];
        }
        let Strand { nodes, neighbours, values, d_values } = self;
        let maps = [&nodes.place, &nodes.first, &nodes.second];
        maps.iter().zip(&mut *values).for_each(|(map, values)| map.apply(points, values));
        d_values.iter_mut().for_each(|d| d.fill([0.0; 4]));
        let [place, first, second] = &*values;
        let [d_place, d_first, d_second] = &mut *d_values;
        let [bending, tightness, evenness] = match step.elastic.is_on() {
            true => elastic_and_gradient(nodes, [place, first, second], &step.elastic, d_place, d_first, d_second),
            false => [0.0; 3],
        };
        let clearance = match step.clearance.weight > 0.0 {
            true => clearance_and_gradient(place, &nodes.steps, neighbours, &step.clearance, d_place),
            false => 0.0,
        };
        maps.iter().zip(d_values).for_each(|(map, d)| map.apply_transpose(d, d_points));
        [bending, tightness, evenness, clearance]
    }
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
        let Some(Curve { sampling, strokes, .. }) = &self.scene else { return };
        let guided = (self.texture.is_some() && step.texture > 0.0) || !self.guides.is_empty();
        sampling.apply(points, &mut self.samples);
        let samples = &self.samples;
        parallel::each_mut(&mut self.views, 2, |_, view| {
            view.draw(samples, strokes, step);
            if !guided {
                view.pull_back(samples);
            }
        });
        let guided = if guided { self.guide(step).await } else { Guided::default() };
        self.add_up(points, step, &guided, terms, d_points);
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
        terms: &mut [f32],
        d_points: &mut Vec<[f32; 4]>,
    ) {
        let Some(Curve { sampling, strokes, jerk, planes, strand }) = &mut self.scene else { return };
        let (samples, strokes) = (&self.samples, &*strokes);
        self.d_samples.clear();
        self.d_samples.resize(samples.len(), [0.0; 4]);
        for view in &self.views {
            for (sum, d_sample) in self.d_samples.iter_mut().zip(&view.d_samples) {
                for c in 0..4 {
                    sum[c] += d_sample[c];
                }
            }
        }
        self.d_points_image.clear();
        self.d_points_image.resize(points.len(), [0.0; 4]);
        sampling.apply_transpose(&self.d_samples, &mut self.d_points_image);
        d_points.clone_from(&self.d_points_image);

        let (mut length, mut surface) = (0.0, 0.0);
        if step.length > 0.0 || step.surface > 0.0 {
            self.d_samples.fill([0.0; 4]);
            if step.length > 0.0 {
                length = length_and_gradient(samples, strokes, step.length, &mut self.d_samples);
            }
            surface = surface_and_gradient(samples, planes, step.surface, &mut self.d_samples);
            sampling.apply_transpose(&self.d_samples, d_points);
        }
        let jerk = jerk.energy_and_gradient(points, step.jerk_position, step.jerk_width, d_points);
        let strand = strand.as_mut().map_or([0.0; 4], |strand| strand.evaluate(points, step, d_points));
        let [bending, tightness, evenness, clearance] = strand;

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
            self.views.iter_mut().zip(views).for_each(|(engine, view)| engine.look(view));
        }
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
        self.scene = Some(Curve { sampling, strokes, jerk, planes, strand });
        (self.texture, self.guides) = (texture.map(TextureGuidance::new), guides);
        self.shown.clear();
        self.ahead.clear();
        Work::Done(())
    }

    fn set_target(&mut self, view: usize, ink: &[f32]) {
        self.views[view].target.data.copy_from_slice(ink);
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

    fn set_neighbours(&mut self, neighbours: Neighbours) {
        if let Some(strand) = self.scene.as_mut().and_then(|curve| curve.strand.as_mut()) {
            strand.neighbours = neighbours;
        }
    }

    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a> {
        if self.guides.is_empty() {
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
        if self.guides.is_empty() {
            wait(self.advance_async(state, tally, steps, terms));
            return Work::Done(());
        }
        Work::later(self.advance_async(state, tally, steps, terms))
    }

    fn fetch(&mut self, _: Picture) -> Work<'_> {
        Work::Done(())
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

    fn place(&self) -> Place {
        let why = self.why.clone().unwrap_or_else(|| "The processor does the work.".into());
        Place { backend: "cpu", device: "processor".into(), why }
    }
}
