//! What the engine is handed: the present stage's wire, its views at the size that is fitted, and the planes it is kept on.

use super::bending::Bender;
use super::engine::{FindNeighbours, Scene, SceneView};
use super::{Problem, Seen, Session, Stage};
use crate::objective::Neighbours;
use crate::view::{Image, Occluder, Target};
use crate::wire::Nodes;
use crate::{Error, Result};

impl Session {
    /// Looks at something else from here on: as many targets as before, on the same scale. The first of `seen` counts at
    /// once, each other one after one iteration more, and the last stays. Losses so far are no measure for them, so the best
    /// wire is looked for anew. Where sizes stay and no target bends that is cheap enough to be done before every iteration.
    ///
    /// # Errors
    /// As [`Problem::check`], and [`Error::Pictures`] for another number of targets; then nothing has changed.
    pub fn set_views(&mut self, seen: Vec<Seen>) -> Result<()> {
        for seen in &seen {
            if seen.targets.len() != self.problem.targets.len() {
                let problem = format!("{} targets for a fit of {}", seen.targets.len(), self.problem.targets.len());
                return Err(Error::Pictures { problem, remedy: "give one for each view".into() });
            }
            seen.check()?;
        }
        self.ahead = seen.into();
        self.look();
        self.unseen = true;
        Ok(())
    }

    /// Turns to what is to be seen next, if there is anything.
    pub(super) fn look(&mut self) {
        let Some(seen) = self.ahead.pop_front() else { return };
        let before = self.problem.look_at(seen);
        let stage = self.stage();
        let mut sizes = before.targets.iter().zip(&self.problem.targets);
        let same_sizes = sizes.all(|(before, after)| fitted_size(before, stage) == fitted_size(after, stage));
        self.loaded &= same_sizes && self.problem.recipe.bending.is_none();
        self.forget_best();
    }

    /// Whether the engine can be told of all that is to be seen: as many pixels as now, and none that bend.
    pub(super) fn is_foreseen(&self) -> bool {
        if self.ahead.is_empty() {
            return true;
        }
        let stage = self.stage();
        let sizes = |targets: &[Target]| targets.iter().map(|target| fitted_size(target, stage)).collect::<Vec<_>>();
        let now = sizes(&self.problem.targets);
        self.problem.recipe.bending.is_none() && self.ahead.iter().all(|seen| sizes(&seen.targets) == now)
    }

    /// Hands the present stage, wire and targets to the engine.
    pub(super) async fn load(&mut self) {
        if let Some(bender) = self.bender.take() {
            self.fields = bender.into_fields();
        }
        let mut inks = self.fitted_inks(&self.problem.targets);
        self.bender = self.bend_inks(&mut inks);
        let scene = Scene { guides: self.guides.clone(), ..self.scene(inks, &self.plane_points, &self.strand_points) };
        self.engine.load(scene).done().await;
        self.loaded = true;
        self.unseen = !self.ahead.is_empty();
    }

    /// Bends targets of the size that is fitted as far as they are bent now; what goes on bending them, if anything does.
    pub(super) fn bend_inks(&self, inks: &mut [Image]) -> Option<Bender> {
        let bending = self.problem.recipe.bending.clone()?;
        let fields = match &self.bender {
            Some(bender) => bender.fields().cloned().collect(),
            None => self.fields.clone(),
        };
        let bender = Bender::new(bending, inks, fields);
        for (v, ink) in inks.iter_mut().enumerate() {
            ink.data.copy_from_slice(bender.bent(v));
        }
        Some(bender)
    }

    /// The present stage and wire with `inks` to show, guided by nothing else; planes and neighbours as found at those control points.
    pub(super) fn scene(&self, inks: Vec<Image>, plane_points: &[[f32; 4]], strand_points: &[[f32; 4]]) -> Scene {
        let stage = self.stage();
        let Problem { targets, occluders, texture_masks, .. } = &self.problem;
        let views = self.views(targets, occluders, texture_masks, inks);
        Scene {
            raster: stage.raster,
            pyramid: self.problem.recipe.pyramid,
            planes: self.planes(plane_points),
            texture: self.problem.texture.clone(),
            nodes: self.nodes(),
            neighbours: self.find_neighbours(strand_points)(),
            ..Scene::new(&self.wire, stage.samples_per_span, views)
        }
    }

    /// What the engine is told of what is to be seen from here on.
    pub(super) fn view_sets(&self) -> Vec<Vec<SceneView>> {
        let set = |targets, occluders, masks| self.views(targets, occluders, masks, self.fitted_inks(targets));
        let Problem { targets, occluders, texture_masks, .. } = &self.problem;
        let now = set(targets, occluders, texture_masks);
        let foreseen = if self.is_foreseen() { self.ahead.len() } else { 0 };
        let ahead = self.ahead.iter().take(foreseen);
        let ahead = ahead.map(|seen| set(&seen.targets, &seen.occluders, &seen.texture_masks));
        std::iter::once(now).chain(ahead).collect()
    }

    /// Every target at the size that is fitted, not bent.
    pub(super) fn fitted_inks(&self, targets: &[Target]) -> Vec<Image> {
        let fitted = |target: &Target| {
            let (width, height) = fitted_size(target, self.stage());
            if (width, height) == (target.ink.width, target.ink.height) {
                target.ink.clone()
            } else {
                target.ink.resized(width, height)
            }
        };
        targets.iter().map(fitted).collect()
    }

    /// Views that see this, with `inks` to show.
    fn views(
        &self,
        targets: &[Target],
        occluders: &[Occluder],
        texture_masks: &[Image],
        inks: Vec<Image>,
    ) -> Vec<SceneView> {
        let view = |(v, (target, ink)): (usize, (&Target, Image))| {
            let (width, height) = (ink.width, ink.height);
            let occluder = occluders.get(v).map(|occluder| {
                if (width, height) == (occluder.depth.width, occluder.depth.height) {
                    occluder.clone()
                } else {
                    occluder.resized(width, height)
                }
            });
            let camera = target.view.with_size(width, height).camera();
            let texture_mask = texture_masks.get(v).map(|mask| mask.resized(width, height));
            SceneView { occluder, texture_mask, ..SceneView::new(camera, ink, self.problem.view_weight(v) as f32) }
        };
        targets.iter().zip(inks).enumerate().map(view).collect()
    }

    /// Planes that touch the surface, if there is one to be kept on, next to the samples at these control points.
    pub(super) fn planes(&self, points: &[[f32; 4]]) -> Vec<[f32; 4]> {
        let Some(surface) = &self.problem.surface else { return Vec::new() };
        let (sampling, _) = self.wire.sampling_map::<f32>(self.stage().samples_per_span, true);
        let mut samples = Vec::new();
        sampling.apply(points, &mut samples);
        surface.planes(&samples)
    }

    /// Where the wire's bending and clearance are measured, if they are.
    pub(super) fn nodes(&self) -> Option<Nodes<f32>> {
        self.problem.recipe.smooth.as_ref().map(|smooth| self.wire.nodes(smooth.nodes_per_span))
    }

    /// Who may come too near whom, as seen at these control points.
    pub(super) fn find_neighbours(&self, points: &[[f32; 4]]) -> FindNeighbours {
        let Some(smooth) = &self.problem.recipe.smooth else { return Box::new(Neighbours::default) };
        let (wire, points, nodes_per_span) = (self.wire.clone(), points.to_vec(), smooth.nodes_per_span);
        let (one_strand, slack) = smooth.watch(self.px_256);
        let clearance = smooth.clearance(0.0, self.px_256, 0.0);
        Box::new(move || {
            let nodes = wire.nodes::<f32>(nodes_per_span);
            let (mut places, mut first) = (Vec::new(), Vec::new());
            nodes.place.apply(&points, &mut places);
            nodes.first.apply(&points, &mut first);
            Neighbours::find(&places, &nodes.lengths(&first), nodes.closed, &clearance, one_strand, slack)
        })
    }

    /// Mean speed along the wire with these control points, world units a knot unit.
    pub(super) fn measured_speed(&self, points: &[[f32; 4]]) -> f32 {
        let Some(nodes) = self.nodes() else { return 0.0 };
        let mut first = Vec::new();
        nodes.first.apply(points, &mut first);
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
