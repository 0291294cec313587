//! What computes an iteration. The session decides *what* happens when; an engine does the arithmetic.
//!
//! An engine keeps everything big (samples, pictures, adjoints) to itself. The session hands it a [`Scene`] whenever
//! stage or topology changes, and between those asks it to [`Engine::advance`]: one iteration at a time on a processor,
//! or many at once where a round trip is dear.

use super::{Adam, AdamOptions, RasterKind};
use crate::Error;
use crate::objective::Pyramid;
use crate::view::{Camera, Image};
use crate::wire::{Jerk, LinearMap, Stroke};

/// One view of a scene.
#[derive(Debug, Clone)]
pub struct SceneView {
    /// World to pixels of the target's size.
    pub camera: Camera<f32>,
    /// What it should show.
    pub target: Image,
    /// Weight of its image loss.
    pub weight: f32,
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
}

/// The numbers of one iteration, in world units.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// Smallest and largest width.
    pub width_bounds: [f32; 2],
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

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |points: &[[f32; 4]]| points.iter().flatten().all(|value| value.is_finite());
        finite(&self.points) && finite(&self.adam.first) && finite(&self.adam.second)
    }
}

/// Where an engine computes.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Place {
    /// `cpu` or `gpu`.
    pub backend: &'static str,
    /// The device's own name.
    pub device: String,
    /// Why there, a sentence for people.
    pub why: String,
}

/// Number of loss terms a row: total, one a view, jerk, length.
pub fn term_count(views: usize) -> usize {
    views + 3
}

/// Computes iterations. Same scene, state and steps give the same numbers, bit for bit, on any number of threads.
pub trait Engine: Send {
    /// Takes over a new scene.
    fn load(&mut self, scene: Scene);

    /// Replaces the target of view `view`, of unchanged size.
    fn set_target(&mut self, view: usize, ink: &[f32]);

    /// Loss terms at `points` (total, one a view, jerk, length; weighted) into `terms`, and the gradient of the total
    /// into `d_points`. Results need not be finite; the session looks after that.
    fn evaluate(&mut self, points: &[[f32; 4]], step: &Step, terms: &mut [f32], d_points: &mut Vec<[f32; 4]>);

    /// Coverage of view `view` at the points last evaluated.
    fn coverage(&self, view: usize) -> &[f32];

    /// Gradient of the loss to the coverage of view `view` at the points last evaluated.
    fn d_coverage(&self, view: usize) -> &[f32];

    /// The image terms' share of the gradient last evaluated.
    fn d_points_image(&self) -> &[[f32; 4]];

    /// The most iterations that pay in one call of [`Engine::advance`].
    fn batch(&self) -> usize {
        1
    }

    /// Where it computes now.
    fn place(&self) -> Place {
        Place { backend: "cpu", device: "processor".into(), why: "The processor does the work.".into() }
    }

    /// Why it no longer computes where it was asked to, if so.
    fn trouble(&self) -> Option<&Error> {
        None
    }

    /// One iteration for each of `steps`: evaluate, step, clamp widths. `terms` has a row of [`term_count`] entries for
    /// each, taken before its step. `d_points` is scratch.
    fn advance(&mut self, state: &mut State, steps: &[Step], terms: &mut [f32], d_points: &mut Vec<[f32; 4]>) {
        let row = terms.len() / steps.len().max(1);
        for (step, terms) in steps.iter().zip(terms.chunks_exact_mut(row.max(1))) {
            self.evaluate(&state.points, step, terms, d_points);
            state.adam.step(&step.adam, &step.rates, &mut state.points, d_points);
            let [min, max] = step.width_bounds;
            for point in &mut state.points {
                // Not `clamp`: a NaN must stay one, so that the session sees it.
                if point[3] < min {
                    point[3] = min;
                } else if point[3] > max {
                    point[3] = max;
                }
            }
        }
    }
}
