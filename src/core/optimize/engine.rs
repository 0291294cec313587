//! What computes an iteration. The session decides *what* happens when; an engine does the arithmetic.
//!
//! An engine keeps everything big (samples, pictures, adjoints) to itself. The session hands it a [`Scene`] whenever
//! stage or topology changes, and between those asks it to [`Engine::advance`]: one iteration at a time on a processor,
//! or many at once where a round trip is dear.

use super::term::{Term, views_of};
use super::{Adam, AdamOptions, Courier, RasterKind, Work};
use crate::Error;
use crate::objective::{Clearance, Elastic, Guides, Neighbours, Progress, Pyramid, Texture};
use crate::view::{Camera, Image, Occluder};
use crate::wire::{Jerk, LinearMap, Nodes, Stroke, Wire};
use std::sync::Arc;

/// One view of a scene.
#[derive(Debug, Clone)]
pub struct SceneView {
    /// World to pixels of the target's size.
    pub camera: Camera<f32>,
    /// What it should show.
    pub target: Image,
    /// Weight of its image loss.
    pub weight: f32,
    /// What hides strands from it, of the target's size; nothing does without.
    pub occluder: Option<Occluder>,
    /// How much each pixel counts for the texture, 0 to 1, of the target's size; all count without.
    pub texture_mask: Option<Image>,
}

impl SceneView {
    /// A view that nothing is hidden from.
    pub fn new(camera: Camera<f32>, target: Image, weight: f32) -> SceneView {
        SceneView { camera, target, weight, occluder: None, texture_mask: None }
    }
}

/// Everything that stays the same between two edits of stage or topology.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Control points to samples.
    pub sampling: LinearMap<f32>,
    /// How samples are joined.
    pub strokes: Vec<Stroke>,
    /// The jerk energy over the present knots.
    pub jerk: Jerk<f32>,
    /// The views.
    pub views: Vec<SceneView>,
    /// What draws.
    pub raster: RasterKind,
    /// How pictures are compared.
    pub pyramid: Pyramid,
    /// One a sample, `[n, d]`: unit normal and offset of the plane that it is pulled to; none at all without a pull.
    pub planes: Vec<[f32; 4]>,
    /// What all views' textures should be like, if anything.
    pub texture: Option<Arc<Texture>>,
    /// What else looks at the views.
    pub guides: Guides,
    /// Where bending and clearance are measured; nowhere without.
    pub nodes: Option<Nodes<f32>>,
    /// Who of those may come too near whom.
    pub neighbours: Neighbours,
}

impl Scene {
    /// A wire with so many samples a span, drawn exactly and compared over averaged pictures, pulled to no surface.
    pub fn new(wire: &Wire, samples_per_span: usize, views: Vec<SceneView>) -> Scene {
        let (sampling, strokes) = wire.sampling_map(samples_per_span, true);
        let (raster, pyramid) = (RasterKind::Exact, Pyramid::AveragePool);
        Scene {
            sampling,
            strokes,
            jerk: Jerk::new(wire),
            views,
            raster,
            pyramid,
            planes: Vec::new(),
            texture: None,
            guides: Guides::default(),
            nodes: None,
            neighbours: Neighbours::default(),
        }
    }
}

/// The numbers of one iteration, in world units.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Step {
    /// Adam's rate of x, y, z and width.
    pub rates: [f32; 4],
    /// Adam's constants.
    pub adam: AdamOptions,
    /// Weight of each coarser level of the loss relative to the finer one.
    pub level_ratio: f32,
    /// Weight of the jerk of positions.
    pub jerk_position: f32,
    /// Weight of the jerk of the width.
    pub jerk_width: f32,
    /// Weight of the length.
    pub length: f32,
    /// Weight of the samples' mean squared distance from their planes.
    pub surface: f32,
    /// Weight of the texture's loss, times each view's.
    pub texture: f32,
    /// Smallest and largest width.
    pub width_bounds: [f32; 2],
    /// Factor that makes image losses comparable over the run: one over the sum of the level weights.
    pub loss_scale: f32,
    /// Share of this iteration in the running means of [`Tally::gradient_norms`], 0 to 1.
    pub gradient_share: f32,
    /// What bending costs.
    pub elastic: Elastic<f32>,
    /// What strands too near each other cost.
    pub clearance: Clearance<f32>,
    /// Whether its views are others than those of the iteration before: losses so far are no measure for it.
    pub new_views: bool,
    /// Whether something guides that the comparison with targets knows nothing of.
    pub guided: bool,
    /// How far the fit is.
    pub progress: Progress,
}

impl Step {
    /// Whether strands bend and take room.
    pub fn is_of_strand(&self) -> bool {
        self.elastic.is_on() || self.clearance.weight > 0.0
    }

    /// The same with no weight on what is about the curve but on `term`.
    pub(super) fn of_curve_only(&self, term: Term) -> Step {
        let only = |of: Term, weight: f32| if of == term { weight } else { 0.0 };
        Step {
            jerk_position: only(Term::Jerk, self.jerk_position),
            jerk_width: only(Term::Jerk, self.jerk_width),
            length: only(Term::Length, self.length),
            surface: only(Term::Surface, self.surface),
            elastic: Elastic {
                bending: only(Term::Bending, self.elastic.bending),
                tightness: only(Term::Tightness, self.elastic.tightness),
                evenness: only(Term::Evenness, self.elastic.evenness),
                ..self.elastic
            },
            clearance: Clearance { weight: only(Term::Clearance, self.clearance.weight), ..self.clearance },
            ..*self
        }
    }

    /// Whether the last wire is the best one: losses of pictures alone say little of a wire that is to be more than that,
    /// or of one that is looked at from other sides every time, or with other eyes.
    pub fn keeps_last(&self) -> bool {
        self.is_of_strand() || self.new_views || self.guided
    }
}

/// What the optimiser changes: control points and their moments.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// `[x, y, z, width]` in world units.
    pub points: Vec<[f32; 4]>,
    /// Their moments.
    pub adam: Adam<4>,
}

impl State {
    /// Copies without allocating where lengths agree.
    pub fn copy_from(&mut self, other: &State) {
        self.points.clone_from(&other.points);
        self.adam.copy_from(&other.adam);
    }

    /// One step of Adam along `gradient`, then the widths' bounds.
    pub fn step(&mut self, step: &Step, gradient: &[[f32; 4]]) {
        self.adam.step(&step.adam, &step.rates, &mut self.points, gradient);
        let [min, max] = step.width_bounds;
        for point in &mut self.points {
            // Not `clamp`: a NaN must stay one, so that the session sees it.
            if point[3] < min {
                point[3] = min;
            } else if point[3] > max {
                point[3] = max;
            }
        }
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |points: &[[f32; 4]]| points.iter().flatten().all(|value| value.is_finite());
        finite(&self.points) && finite(&self.adam.first) && finite(&self.adam.second)
    }
}

/// What iterations leave behind besides the state.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tally {
    /// The points with the lowest image loss so far, or the last ones where [`Step::keeps_last`].
    pub best_points: Vec<[f32; 4]>,
    /// That loss, times [`Step::loss_scale`]; infinite before the first.
    pub best_loss: f32,
    /// Running means of the length of the image gradient to each control point's position.
    pub gradient_norms: Vec<f32>,
}

impl Tally {
    /// For `count` points, before the first iteration.
    pub fn new(count: usize) -> Tally {
        Tally { best_points: Vec::new(), best_loss: f32::INFINITY, gradient_norms: vec![0.0; count] }
    }

    /// Copies without allocating where lengths agree.
    pub fn copy_from(&mut self, other: &Tally) {
        self.best_points.clone_from(&other.best_points);
        self.best_loss = other.best_loss;
        self.gradient_norms.clone_from(&other.gradient_norms);
    }

    /// Takes note of an iteration before its step, from its row of terms and the image terms' gradient.
    pub fn note(&mut self, step: &Step, points: &[[f32; 4]], terms: &[f32], d_points_image: &[[f32; 4]]) {
        let views = views_of(terms);
        let texture = terms[Term::Texture.at(views.len())];
        let loss = (views.iter().sum::<f32>() + texture) * step.loss_scale;
        if loss < self.best_loss || step.keeps_last() {
            self.best_loss = loss;
            self.best_points.clear();
            self.best_points.extend_from_slice(points);
        }
        for (mean, [x, y, z, _]) in self.gradient_norms.iter_mut().zip(d_points_image) {
            *mean += step.gradient_share * ((x * x + y * y + z * z).sqrt() - *mean);
        }
    }
}

/// Where an engine computes.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Place {
    /// `cpu` or `gpu`.
    #[cfg_attr(feature = "typescript", ts(type = "\"cpu\" | \"gpu\""))]
    pub backend: &'static str,
    /// The device's own name.
    pub device: String,
    /// Why there, a sentence for people.
    pub why: String,
}

/// What an engine draws that has an entry a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Picture {
    /// Coverage, 0 to 1.
    Coverage,
    /// Gradient of the loss to it.
    DCoverage,
}

/// Finds who may come too near whom.
pub type FindNeighbours = Box<dyn FnOnce() -> Neighbours + Send>;

/// Computes iterations. Same scene, state and steps give the same numbers, bit for bit, on any number of threads and
/// however many iterations go into a call.
pub trait Engine: Send {
    /// Takes over a new scene.
    fn load(&mut self, scene: Scene) -> Work<'_>;

    /// Replaces the target of view `view`, of unchanged size.
    fn set_target(&mut self, view: usize, ink: &[f32]);

    /// Replaces all views by as many others of the same sizes; what hides what may come and go. The first of `sets` counts
    /// at once, each other one after one iteration more, and the last stays.
    fn set_views(&mut self, sets: Vec<Vec<SceneView>>) -> Work<'_>;

    /// Replaces the planes that samples are pulled to by as many others.
    fn set_planes(&mut self, planes: Vec<[f32; 4]>);

    /// Replaces who may come too near whom.
    fn set_neighbours(&mut self, neighbours: Neighbours);

    /// Likewise, as `find` finds them: now, or when they are first needed.
    fn set_neighbours_found_by(&mut self, find: FindNeighbours) {
        self.set_neighbours(find());
    }

    /// Loss terms at `points` (a row as in [`Term`]; weighted) into `terms`, and the gradient of the total into
    /// `d_points`. Results need not be finite; the session looks after that.
    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a>;

    /// One iteration for each of `steps`: evaluate, note, step. `terms` has a row as in [`Term`] for each,
    /// taken before its step.
    fn advance<'a>(
        &'a mut self,
        state: &'a mut State,
        tally: &'a mut Tally,
        steps: &'a [Step],
        terms: &'a mut [f32],
    ) -> Work<'a>;

    /// Has the pictures of the points last evaluated at hand for [`Engine::picture`].
    fn fetch(&mut self, picture: Picture) -> Work<'_>;

    /// A picture of view `view` as last fetched.
    fn picture(&self, picture: Picture, view: usize) -> &[f32];

    /// The most iterations that pay in one call of [`Engine::advance`].
    fn batch(&self) -> usize;

    /// Has a [`Mate`](super::Mate) compute some of the views from the next iteration on, or nobody where that is of no use. Once it
    /// fails the engine goes on without it; neither changes a bit.
    fn hire(&mut self, courier: Box<dyn Courier>) {
        drop(courier);
    }

    /// How many compute now: itself, and those it hired and has work for.
    fn workers(&self) -> usize {
        1
    }

    /// Where it computes now.
    fn place(&self) -> Place;

    /// Why it no longer computes where it was asked to, if so.
    fn trouble(&self) -> Option<&Error> {
        None
    }
}
