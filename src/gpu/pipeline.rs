//! The stages as compiled pipelines over the buffers of a scene, run in order, some or all, for many iterations at once.

use super::buffers::{Buffers, UNIFORM_STRIDE};
use super::device::Device;
use super::fault::{Answer, FaultKind};
use super::stage::{Access, Over, SLOTS, STAGES, Slot, Stage, outline_groups};
use super::upload::{LOSS_GROUP, Upload, pack};
use crate::objective::Neighbours;
use crate::optimize::{Scene, SceneView, Step, wait};
use bytemuck::Pod;
use std::ops::Range;

/// Threads a workgroup of most stages.
const GROUP: usize = 64;

/// All stages, ready to run on a device, and the scene they run on.
pub struct Pipeline {
    device: Device,
    loaded: Option<Loaded>,
    batch: usize,
    pace: Pace,
}

struct Loaded {
    upload: Upload,
    buffers: Buffers,
    bind_groups: Vec<wgpu::BindGroup>,
}

/// How much goes into a submission: a device that draws the screen too must not be kept for long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pace {
    /// So many iterations.
    Iterations(usize),
    /// One stage: where an iteration takes too long.
    Stage,
}

/// The longest a submission should take.
const SUBMISSION_MS: f64 = 50.0;

impl Pipeline {
    /// For up to `batch` iterations a call of [`Pipeline::run`].
    pub fn new(device: &Device, batch: usize) -> Pipeline {
        // Nothing is known of the device's speed yet.
        Pipeline { device: device.clone(), loaded: None, batch: batch.max(1), pace: Pace::Stage }
    }

    /// Iterations of one call of [`Pipeline::run`], at most.
    pub fn batch(&self) -> usize {
        self.batch
    }

    /// The device it runs on.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// [`Pipeline::load_async`], waiting for it.
    ///
    /// # Errors
    /// As there.
    pub fn load(&mut self, scene: &Scene) -> Answer<()> {
        wait(self.load_async(scene))
    }

    /// Makes the buffers of a scene.
    ///
    /// # Errors
    /// A fault of limits or memory if the scene is too large for the device.
    pub async fn load_async(&mut self, scene: &Scene) -> Answer<()> {
        self.loaded = None;
        let upload = Upload::new(scene, &self.device)?;
        self.fill(upload).await
    }

    /// How many cell entries there is room for.
    pub fn room(&self) -> usize {
        self.loaded.as_ref().map_or(0, |loaded| loaded.upload.scene.entries as usize)
    }

    /// Bytes of each buffer; none without a scene.
    pub fn memory(&self) -> Vec<(Slot, u64)> {
        let sizes = |loaded: &Loaded| SLOTS.iter().map(|&slot| (slot, loaded.buffers.get(slot).size())).collect();
        self.loaded.as_ref().map(sizes).unwrap_or_default()
    }

    /// Makes new buffers for the scene, with room for `entries` cell entries. What was computed is lost.
    ///
    /// # Errors
    /// A fault without a scene, or if the device has not the room.
    pub async fn make_room(&mut self, entries: usize) -> Answer<()> {
        let Some(Loaded { mut upload, .. }) = self.loaded.take() else {
            return Err(self.no_scene());
        };
        upload.scene.entries = entries as u32;
        self.fill(upload).await
    }

    async fn fill(&mut self, upload: Upload) -> Answer<()> {
        let buffers = Buffers::new(&self.device, &upload, self.batch).await?;
        let bind = |(stage, pipeline): (&Stage, &wgpu::ComputePipeline)| {
            let entry = |&slot: &Slot| {
                let buffer = buffers.get(slot);
                // One of several uniforms is seen at a time.
                let size = (slot.access() == Access::UniformOfMany).then_some(wgpu::BufferSize::new(ONE_UNIFORM));
                let resource = wgpu::BufferBinding { buffer, offset: 0, size: size.flatten() };
                wgpu::BindGroupEntry { binding: slot as u32, resource: wgpu::BindingResource::Buffer(resource) }
            };
            self.device.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some(stage.name),
                layout: &pipeline.get_bind_group_layout(0),
                entries: &stage.slots.iter().map(entry).collect::<Vec<_>>(),
            })
        };
        let bind_all = || STAGES.iter().zip(&*self.device.stages).map(bind).collect();
        let bind_groups = self.device.watched(bind_all).await?;
        self.loaded = Some(Loaded { upload, buffers, bind_groups });
        Ok(())
    }

    fn loaded(&self) -> Answer<&Loaded> {
        self.loaded.as_ref().ok_or_else(|| self.no_scene())
    }

    pub(super) fn no_scene(&self) -> super::Fault {
        self.device.fault(FaultKind::Lost, "no scene was loaded")
    }

    /// Overwrites a buffer from its start.
    ///
    /// # Errors
    /// A fault without a scene.
    pub fn write<T: Pod>(&self, slot: Slot, values: &[T]) -> Answer<()> {
        self.loaded()?.buffers.write(&self.device, slot, 0, values);
        Ok(())
    }

    /// Overwrites the target of view `view`.
    ///
    /// # Errors
    /// A fault without a scene.
    pub(super) fn set_target(&mut self, view: usize, ink: &[f32]) -> Answer<()> {
        let fault = self.no_scene();
        let Loaded { upload, buffers, .. } = self.loaded.as_mut().ok_or(fault)?;
        let first = upload.scene.view[view].first_pixel as usize;
        upload.target_ink[first..first + ink.len()].copy_from_slice(ink);
        buffers.write(&self.device, Slot::TargetInk, first * size_of::<f32>(), ink);
        Ok(())
    }

    /// Overwrites cameras, weights, targets and occluders with those of as many views of the same sizes.
    ///
    /// # Errors
    /// A fault without a scene.
    pub(super) fn set_views(&mut self, views: &[SceneView]) -> Answer<()> {
        let fault = self.no_scene();
        self.loaded.as_mut().ok_or(fault)?.set_views(&self.device, views);
        Ok(())
    }

    /// Overwrites the planes with as many others.
    ///
    /// # Errors
    /// A fault without a scene.
    pub(super) fn set_planes(&mut self, planes: &[[f32; 4]]) -> Answer<()> {
        let fault = self.no_scene();
        let Loaded { upload, buffers, .. } = self.loaded.as_mut().ok_or(fault)?;
        upload.planes.iter_mut().zip(planes).for_each(|(plane, &other)| *plane = other);
        buffers.write(&self.device, Slot::Planes, 0, &upload.planes);
        Ok(())
    }

    /// Overwrites who may come too near whom.
    ///
    /// # Errors
    /// A fault without a scene.
    pub(super) fn set_neighbours(&mut self, neighbours: &Neighbours) -> Answer<()> {
        let fault = self.no_scene();
        let Loaded { upload, buffers, .. } = self.loaded.as_mut().ok_or(fault)?;
        upload.strand.set_neighbours(neighbours);
        buffers.write(&self.device, Slot::Neighbours, 0, &upload.strand.neighbours);
        Ok(())
    }

    /// The first `count` values of a buffer, waiting for them.
    ///
    /// # Errors
    /// A fault without a scene, or if the device is lost.
    pub fn read<T: Pod>(&mut self, slot: Slot, count: usize) -> Answer<Vec<T>> {
        let bytes = wait(self.read_bytes(&[(slot, 0..count * size_of::<T>())]))?;
        Ok(bytemuck::pod_collect_to_vec(&bytes[0]))
    }

    /// Byte ranges of several buffers, in one go.
    pub(super) async fn read_bytes(&mut self, wanted: &[(Slot, Range<usize>)]) -> Answer<Vec<Vec<u8>>> {
        match &mut self.loaded {
            Some(loaded) => loaded.buffers.read(&self.device, wanted).await,
            None => Err(self.no_scene()),
        }
    }

    /// Fits submissions to a device that takes so long for an iteration.
    pub fn keep_pace(&mut self, iteration_ms: f64) {
        self.pace = if iteration_ms > SUBMISSION_MS {
            Pace::Stage
        } else {
            Pace::Iterations((SUBMISSION_MS / iteration_ms.max(1e-3)) as usize)
        };
    }

    /// Submits the stages from `first` to `last` once for each of `steps` (at most [`Pipeline::batch`]); `count` is how
    /// many steps Adam's moments have seen before. Iteration i writes row i of the terms.
    ///
    /// # Errors
    /// A fault without a scene.
    ///
    /// # Panics
    /// If a stage's name is unknown.
    pub fn run(&mut self, first: &str, last: &str, steps: &[Step], count: u32) -> Answer<()> {
        self.run_looking(first, last, steps, count, &[])
    }

    /// [`Pipeline::run`]; after iteration i the views are those of `ahead[i]`, as long as there are any.
    pub(super) fn run_looking(
        &mut self,
        first: &str,
        last: &str,
        steps: &[Step],
        count: u32,
        ahead: &[Vec<SceneView>],
    ) -> Answer<()> {
        let fault = self.no_scene();
        let Pipeline { device, loaded, batch, pace } = self;
        let loaded = loaded.as_mut().ok_or(fault)?;
        let steps = &steps[..steps.len().min(*batch)];
        let mut packed = vec![0u8; steps.len() * UNIFORM_STRIDE];
        for (i, (step, bytes)) in steps.iter().zip(packed.chunks_exact_mut(UNIFORM_STRIDE)).enumerate() {
            let step = pack(step, count + i as u32 + 1, i);
            bytes[..size_of_val(&step)].copy_from_slice(bytemuck::bytes_of(&step));
        }
        loaded.buffers.write(device, Slot::Step, 0, &packed);
        let stages = Stage::index(first)..Stage::index(last) + 1;
        let most = match pace {
            // Writes to the views' buffers wait for submissions, not for iterations within one.
            _ if !ahead.is_empty() => 1,
            Pace::Stage => 1,
            Pace::Iterations(most) => *most,
        };
        for from in (0..steps.len()).step_by(most) {
            let iterations = from..steps.len().min(from + most);
            match pace {
                Pace::Stage => {
                    stages.clone().for_each(|stage| loaded.submit(device, stage..stage + 1, iterations.clone()));
                }
                Pace::Iterations(_) => loaded.submit(device, stages.clone(), iterations),
            }
            if let Some(views) = ahead.get(from) {
                loaded.set_views(device, views);
            }
        }
        Ok(())
    }
}

/// Bytes of the largest uniform of several.
const ONE_UNIFORM: u64 = 144;
const _: () = assert!(size_of::<super::layout::Step>() == ONE_UNIFORM as usize);

impl Loaded {
    fn set_views(&mut self, device: &Device, views: &[SceneView]) {
        self.upload.set_views(views);
        self.buffers.write_views(device, &self.upload);
    }

    fn submit(&self, device: &Device, stages: Range<usize>, iterations: Range<usize>) {
        let mut encoder = device.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for i in iterations {
            for index in stages.clone() {
                self.dispatch(&mut pass, index, &device.stages[index], i);
            }
        }
        drop(pass);
        device.queue.submit([encoder.finish()]);
    }

    /// Adds stage `index` of iteration `i`.
    fn dispatch(&self, pass: &mut wgpu::ComputePass, index: usize, pipeline: &wgpu::ComputePipeline, i: usize) {
        let stage = &STAGES[index];
        let Upload { scene, texture, .. } = &self.upload;
        let [points, samples, views] = [scene.points, scene.samples, scene.views].map(|count| count as usize);
        let mut dispatch = |groups: usize, views: usize, level: usize| {
            if groups == 0 || views == 0 {
                return;
            }
            // Offsets in the order of bindings: the step, then the pass.
            let offset = |slot: Slot, i: usize| stage.slots.contains(&slot).then_some((i * UNIFORM_STRIDE) as u32);
            let offsets: Vec<u32> = [offset(Slot::Step, i), offset(Slot::Pass, level)].into_iter().flatten().collect();
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &self.bind_groups[index], &offsets);
            pass.dispatch_workgroups(groups as u32, views as u32, 1);
        };
        match stage.over {
            Over::Points => dispatch(points.div_ceil(GROUP), 1, 0),
            Over::Samples => dispatch(samples.div_ceil(GROUP), 1, 0),
            Over::SamplesAndViews(threads) => dispatch((samples * threads as usize).div_ceil(GROUP), views, 0),
            Over::Nodes => dispatch((scene.nodes as usize).div_ceil(LOSS_GROUP), 1, 0),
            Over::PointsOfNodes => dispatch(points.div_ceil(GROUP), usize::from(scene.nodes > 0), 0),
            Over::EachPoint => dispatch(points, 1, 0),
            Over::Outline { border } => {
                let rows = if border { self.most_rows() } else { 0 };
                dispatch(outline_groups(samples, rows), views, 0);
            }
            Over::Views => dispatch(1, views, 0),
            Over::Rows => dispatch(self.most_rows(), views, 0),
            Over::Once => dispatch(1, 1, 0),
            Over::Planes => dispatch(usize::from(scene.planes > 0), 1, 0),
            Over::TexturePixels => dispatch(texture.most_pixels().div_ceil(GROUP), texture.levels.len(), 0),
            Over::TextureFeatures => dispatch((texture.most_pixels() / 4).div_ceil(GROUP), texture.levels.len(), 0),
            Over::TextureGroups(groups) => dispatch(groups, texture.levels.len(), 0),
            Over::TextureViews => {
                let pixels = if texture.a_view > 0 { self.most_values(0) } else { 0 };
                dispatch(pixels.div_ceil(GROUP), views, 0);
            }
            Over::Levels { finest_first } => {
                for pass in 0..self.upload.depth {
                    let level = if finest_first { pass } else { self.upload.depth - 1 - pass };
                    dispatch(self.most_values(level).div_ceil(LOSS_GROUP), views, level);
                }
            }
        }
    }

    /// The most rows of pixels a view has.
    fn most_rows(&self) -> usize {
        let scene = &self.upload.scene;
        scene.view[..scene.views as usize].iter().map(|view| view.height as usize).max().unwrap_or(0)
    }

    /// The most values a view has at a level.
    fn most_values(&self, level: usize) -> usize {
        let views = self.upload.levels.chunks_exact(super::layout::MOST_LEVELS);
        views.map(|levels| (levels[level].width * levels[level].height) as usize).max().unwrap_or(0)
    }
}
