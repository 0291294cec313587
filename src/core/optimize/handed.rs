//! What the engine is handed: the present stage's wire, its views at the size that is fitted, and the planes it is kept on.

use super::bending::Bender;
use super::engine::{Scene, SceneView};
use super::{Seen, Session, Stage};
use crate::objective::Neighbours;
use crate::view::{Image, Target};
use crate::wire::Nodes;
use crate::{Error, Result};

impl Session {
    /// Looks at something else from here on: as many targets as before, on the same scale. Losses so far are no measure for
    /// it, so the best wire is looked for anew. Where sizes stay and no target bends that is cheap enough to be done before
    /// every iteration.
    ///
    /// # Errors
    /// As [`Problem::check`], and [`Error::Pictures`] for another number of targets; then nothing has changed.
    pub fn set_views(&mut self, seen: Seen) -> Result<()> {
        if seen.targets.len() != self.problem.targets.len() {
            let problem = format!("{} targets for a fit of {}", seen.targets.len(), self.problem.targets.len());
            return Err(Error::Pictures { problem, remedy: "give one for each view".into() });
        }
        let before = self.problem.look_at(seen);
        if let Err(error) = self.problem.check() {
            self.problem.look_at(before);
            return Err(error);
        }
        let stage = self.stage();
        let mut sizes = before.targets.iter().zip(&self.problem.targets);
        let same_sizes = sizes.all(|(before, after)| fitted_size(before, stage) == fitted_size(after, stage));
        self.unseen = true;
        self.loaded &= same_sizes && self.problem.recipe.bending.is_none();
        self.forget_best();
        Ok(())
    }

    /// Hands the present stage, wire and targets to the engine.
    pub(super) async fn load(&mut self) {
        let stage = self.stage().clone();
        if let Some(bender) = self.bender.take() {
            self.fields = bender.into_fields();
        }
        let mut inks = self.fitted_inks();
        if let Some(bending) = &self.problem.recipe.bending {
            let bender = Bender::new(bending.clone(), &inks, std::mem::take(&mut self.fields));
            for (v, ink) in inks.iter_mut().enumerate() {
                ink.data.copy_from_slice(bender.bent(v));
            }
            self.bender = Some(bender);
        }
        let scene = Scene {
            raster: stage.raster,
            pyramid: self.problem.recipe.pyramid,
            planes: self.planes(),
            texture: self.problem.texture.clone(),
            nodes: self.nodes(),
            neighbours: self.neighbours(),
            ..Scene::new(&self.wire, stage.samples_per_span, self.views(inks))
        };
        self.engine.load(scene).done().await;
        (self.loaded, self.unseen) = (true, false);
    }

    /// Every target at the size that is fitted, not bent.
    pub(super) fn fitted_inks(&self) -> Vec<Image> {
        let fitted = |target: &Target| {
            let (width, height) = fitted_size(target, self.stage());
            if (width, height) == (target.ink.width, target.ink.height) {
                target.ink.clone()
            } else {
                target.ink.resized(width, height)
            }
        };
        self.problem.targets.iter().map(fitted).collect()
    }

    /// The views with `inks` to show.
    pub(super) fn views(&self, inks: Vec<Image>) -> Vec<SceneView> {
        let view = |(v, (target, ink)): (usize, (&Target, Image))| {
            let (width, height) = (ink.width, ink.height);
            let occluder = self.problem.occluders.get(v).map(|occluder| {
                if (width, height) == (occluder.depth.width, occluder.depth.height) {
                    occluder.clone()
                } else {
                    occluder.resized(width, height)
                }
            });
            let camera = target.view.with_size(width, height).camera();
            let texture_mask = self.problem.texture_masks.get(v).map(|mask| mask.resized(width, height));
            SceneView { occluder, texture_mask, ..SceneView::new(camera, ink, self.problem.view_weight(v) as f32) }
        };
        self.problem.targets.iter().zip(inks).enumerate().map(view).collect()
    }

    /// Planes that touch the surface, if there is one to be kept on, next to the samples at `plane_points`.
    pub(super) fn planes(&self) -> Vec<[f32; 4]> {
        let Some(surface) = &self.problem.surface else { return Vec::new() };
        let (sampling, _) = self.wire.sampling_map::<f32>(self.stage().samples_per_span, true);
        let mut samples = Vec::new();
        sampling.apply(&self.plane_points, &mut samples);
        surface.planes(&samples)
    }

    /// Where the wire's bending and clearance are measured, if they are.
    pub(super) fn nodes(&self) -> Option<Nodes<f32>> {
        self.problem.recipe.smooth.as_ref().map(|smooth| self.wire.nodes(smooth.nodes_per_span))
    }

    /// Who may come too near whom, as seen at `strand_points`.
    pub(super) fn neighbours(&self) -> Neighbours {
        let Some((smooth, nodes)) = self.problem.recipe.smooth.as_ref().zip(self.nodes()) else {
            return Neighbours::default();
        };
        let (mut places, mut first) = (Vec::new(), Vec::new());
        nodes.place.apply(&self.strand_points, &mut places);
        nodes.first.apply(&self.strand_points, &mut first);
        let (one_strand, slack) = smooth.watch(self.px_256);
        let clearance = smooth.clearance(0.0, self.px_256, 0.0);
        Neighbours::find(&places, &nodes.lengths(&first), nodes.closed, &clearance, one_strand, slack)
    }

    /// Mean speed along the wire at `strand_points`, world units a knot unit.
    pub(super) fn measured_speed(&self) -> f32 {
        let Some(nodes) = self.nodes() else { return 0.0 };
        let mut first = Vec::new();
        nodes.first.apply(&self.strand_points, &mut first);
        let (start, end) = self.wire.domain();
        let length: f32 = nodes.lengths(&first).iter().sum();
        // A wire that has shrunk to a point still has a scale.
        (length / (end - start) as f32).max(1e-3 * self.px_256 as f32)
    }

    /// The target of view `view` as the engine sees it.
    pub(super) fn fitted_ink(&self, view: usize) -> Image {
        let target = &self.problem.targets[view];
        let (width, height) = fitted_size(target, self.stage());
        match &self.bender {
            Some(bender) => Image { width, height, data: bender.bent(view).to_vec() },
            None => target.ink.resized(width, height),
        }
    }
}

/// A target's size scaled so that its larger side has `size_px` pixels.
pub(super) fn size_within(target: &Target, size_px: usize) -> (usize, usize) {
    let (width, height) = (target.ink.width, target.ink.height);
    let scale = size_px as f64 / width.max(height) as f64;
    let scaled = |side: usize| ((side as f64 * scale).round() as usize).max(1);
    (scaled(width), scaled(height))
}

pub(super) fn fitted_size(target: &Target, stage: &Stage) -> (usize, usize) {
    size_within(target, stage.size_px)
}
