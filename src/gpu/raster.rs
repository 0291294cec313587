//! The rasteriser's stages alone, with strokes and adjoints that come from the processor.

use super::fault::Answer;
use super::pipeline::Pipeline;
use super::stage::Slot;
use super::{Device, Fault};
use crate::optimize::{Scene, SceneView, Step, wait};
use crate::raster::{FARTHEST_PX, Raster};
use crate::view::{Image, View};
use crate::wire::{LinearMap, Row, Stroke, Wire};

/// Draws on a device and waits for it.
pub struct GpuRaster {
    pipeline: Pipeline,
    /// Size and strokes of the scene that is loaded.
    loaded: Option<(usize, usize, usize, Vec<Stroke>)>,
    vertices: Vec<[f32; 4]>,
    coverage: Vec<f32>,
    trouble: Option<Fault>,
}

impl GpuRaster {
    /// One without a scene.
    pub fn new(device: &Device) -> GpuRaster {
        let pipeline = Pipeline::new(device, 1);
        GpuRaster { pipeline, loaded: None, vertices: Vec::new(), coverage: Vec::new(), trouble: None }
    }

    /// What went wrong first, if anything: what was drawn since is blank.
    pub fn trouble(&self) -> Option<&Fault> {
        self.trouble.as_ref()
    }

    fn try_forward(&mut self, width: usize, height: usize, strokes: &[Stroke]) -> Answer<Vec<f32>> {
        let count = self.vertices.len();
        let wanted = (width, height, count, strokes.to_vec());
        if self.loaded.as_ref() != Some(&wanted) {
            self.pipeline.load(&scene(width, height, count, strokes))?;
            self.loaded = Some(wanted);
        }
        loop {
            self.pipeline.write(Slot::Vertices, &self.vertices)?;
            self.pipeline.run("join_pieces", "finish_rows", &[Step::default()], 0)?;
            // Its first value says how many cell entries were wanted.
            let entries = self.pipeline.read::<u32>(Slot::Cells, 1)?[0] as usize;
            if entries <= self.pipeline.room() {
                return self.pipeline.read(Slot::Coverage, width * height);
            }
            wait(self.pipeline.make_room(entries + entries / 4))?;
        }
    }

    fn try_backward(&mut self, d_coverage: &[f32]) -> Answer<Vec<[f32; 4]>> {
        self.pipeline.write(Slot::Pyramid, d_coverage)?;
        self.pipeline.run("pull_back", "gather_pulls", &[Step::default()], 0)?;
        self.pipeline.read(Slot::DVertices, self.vertices.len())
    }

    fn blank_after<T: Clone>(&mut self, answer: Answer<Vec<T>>, blank: T, count: usize) -> Vec<T> {
        answer.unwrap_or_else(|fault| {
            self.trouble.get_or_insert(fault);
            vec![blank; count]
        })
    }
}

impl Raster for GpuRaster {
    fn forward(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke]) -> &[f32] {
        let mut drawn = vec![false; vertices.len()];
        strokes.iter().for_each(|stroke| drawn[stroke.start..stroke.start + stroke.count].fill(true));
        self.vertices.clear();
        self.vertices.extend(vertices.iter().zip(drawn).map(|(&[x, y, radius], drawn)| {
            // NaN compares false.
            let usable = [x, y, radius].iter().all(|c| c.abs() <= FARTHEST_PX);
            [x, y, radius.max(0.0), f32::from(drawn && usable)]
        }));
        let drawn = self.try_forward(width, height, strokes);
        self.coverage = self.blank_after(drawn, 0.0, width * height);
        &self.coverage
    }

    fn backward(&mut self, d_coverage: &[f32], d_vertices: &mut Vec<[f32; 3]>) {
        let pulled = self.try_backward(d_coverage);
        let pulled = self.blank_after(pulled, [0.0; 4], self.vertices.len());
        d_vertices.clear();
        d_vertices.extend(pulled.iter().map(|&[x, y, radius, _]| [x, y, radius]));
    }
}

/// A scene of one view whose curve does not matter.
fn scene(width: usize, height: usize, count: usize, strokes: &[Stroke]) -> Scene {
    let rows = (0..count).map(|_| Row { first: 0, weights: [0.25; 4] }).collect();
    let wire = Wire::open_uniform(vec![[0.0, 0.0, 0.0, 0.1]; 4]).expect("four points make a wire");
    let camera = View::orthographic("any", 0.0, 0.0, 2.0, height).camera();
    let views = vec![SceneView::new(camera, Image::new(width, height), 1.0)];
    Scene { sampling: LinearMap::new(4, rows), strokes: strokes.to_vec(), ..Scene::new(&wire, 1, views) }
}
