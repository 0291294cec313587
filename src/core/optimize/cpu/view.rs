//! One view's share of an iteration: samples to a picture, its loss, and all the way back.

use super::super::RasterKind;
use super::super::engine::SceneView;
use crate::objective::{MultiscaleMse, Pyramid, Rendered};
use crate::raster::{BandRaster, ExactRaster, Part, Raster};
use crate::view::{Image, Occluder, drop_hidden};
use crate::wire::Stroke;

/// One view's share of an iteration, with its buffers.
pub(super) struct ViewEngine {
    pub target: Image,
    pub occluder: Option<Occluder>,
    raster: Drawer,
    mse: MultiscaleMse<f32>,
    pub seen: Rendered,
    /// Of each sample; empty where nothing hides any.
    visibilities: Vec<f32>,
    vertices: Vec<[f32; 3]>,
    pub d_vertices: Vec<[f32; 3]>,
    pub d_samples: Vec<[f32; 4]>,
    pub loss: f32,
}

/// What draws; the exact one can do so in parts.
enum Drawer {
    Band(BandRaster),
    Exact(Box<ExactRaster>),
}

impl Drawer {
    fn new(kind: RasterKind) -> Drawer {
        match kind {
            RasterKind::Band => Drawer::Band(BandRaster::new()),
            RasterKind::Exact => Drawer::Exact(Box::new(ExactRaster::new())),
        }
    }

    fn whole(&mut self) -> &mut dyn Raster {
        match self {
            Drawer::Band(raster) => raster,
            Drawer::Exact(raster) => &mut **raster,
        }
    }

    fn exact(&mut self) -> Option<&mut ExactRaster> {
        match self {
            Drawer::Band(_) => None,
            Drawer::Exact(raster) => Some(raster),
        }
    }
}

impl ViewEngine {
    pub fn new(view: SceneView, raster: RasterKind, pyramid: Pyramid) -> Self {
        let SceneView { camera, target, weight, occluder, texture_mask } = view;
        let mut engine = ViewEngine {
            occluder,
            raster: Drawer::new(raster),
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
    pub fn look(&mut self, view: SceneView) {
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
    pub fn draw(&mut self, samples: &[[f32; 4]], strokes: &[Stroke], level_ratio: f32) {
        self.project(samples, strokes);
        let Image { width, height, .. } = self.target;
        let coverage = self.raster.whole().forward(width, height, &self.vertices, strokes);
        self.seen.coverage.copy_from_slice(coverage);
        self.compare(level_ratio);
    }

    fn compare(&mut self, level_ratio: f32) {
        let Rendered { coverage, d_coverage: d_seen, weight, .. } = &mut self.seen;
        let (loss, d_coverage) = self.mse.evaluate(coverage, &self.target.data, level_ratio, *weight);
        self.loss = loss;
        d_seen.copy_from_slice(d_coverage);
    }

    /// All the way back.
    pub fn pull_back(&mut self, samples: &[[f32; 4]]) {
        self.raster.whole().backward(&self.seen.d_coverage, &mut self.d_vertices);
        self.project_vjp(samples);
    }

    /// The beginning of [`ViewEngine::draw`] by a part of the strokes; the bands of a [`BandRaster`] have none.
    pub fn draw_part(&mut self, samples: &[[f32; 4]], strokes: &[Stroke], part: Part) {
        self.project(samples, strokes);
        let Image { width, height, .. } = self.target;
        if let Some(raster) = self.raster.exact() {
            raster.trace_part(width, height, &self.vertices, strokes, part);
        }
    }

    /// Hands over what was drawn in part: see [`ExactRaster::sums`].
    pub fn take_part(&mut self, take: impl FnOnce(&[i32])) {
        if let Some(raster) = self.raster.exact() {
            take(raster.sums());
            raster.clear_sums();
        }
    }

    /// Adds another part of the picture.
    pub fn add_part(&mut self, sums: &[i32]) {
        if let Some(raster) = self.raster.exact() {
            raster.add(sums);
        }
    }

    /// The end of [`ViewEngine::draw`] once all parts are there.
    pub fn finish(&mut self, level_ratio: f32) {
        if let Some(raster) = self.raster.exact() {
            self.seen.coverage.copy_from_slice(raster.finish());
        }
        self.compare(level_ratio);
    }

    /// The part's way back to the vertices.
    pub fn pull_back_part(&mut self) {
        self.raster.whole().backward(&self.seen.d_coverage, &mut self.d_vertices);
    }

    /// Adds the other parts' `d_vertices` and goes on to the samples.
    pub fn pull_back_together<'a>(
        &mut self,
        samples: &[[f32; 4]],
        others: impl IntoIterator<Item = &'a Vec<[f32; 3]>>,
    ) {
        for other in others {
            // No vertex belongs to more than two pieces, so the order of the parts changes no bit.
            for (sum, d_vertex) in self.d_vertices.iter_mut().zip(other) {
                (0..3).for_each(|c| sum[c] += d_vertex[c]);
            }
        }
        self.project_vjp(samples);
    }
}
