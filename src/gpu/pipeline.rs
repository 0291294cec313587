//! The stages as compiled pipelines over the buffers of a scene, run in order, some or all, for many iterations at once.

use super::buffers::{Buffers, UNIFORM_STRIDE};
use super::device::Device;
use super::stage::{Access, Over, SLOTS, STAGES, Slot, Stage, outline_groups};
use super::upload::{LOSS_GROUP, Upload, pack};
use crate::Result;
use crate::optimize::{Scene, Step};
use bytemuck::Pod;
use std::ops::Range;

/// Threads a workgroup of most stages.
const GROUP: usize = 64;

/// All stages, ready to run on a device, and the scene they run on.
pub struct Pipeline {
    device: Device,
    stages: Vec<wgpu::ComputePipeline>,
    loaded: Option<Loaded>,
    batch: usize,
}

struct Loaded {
    upload: Upload,
    buffers: Buffers,
    bind_groups: Vec<wgpu::BindGroup>,
}

impl Pipeline {
    /// Compiles every stage, for up to `batch` iterations a submission.
    ///
    /// # Errors
    /// [`crate::Error::Device`] if the device takes a shader badly.
    pub fn new(device: &Device, batch: usize) -> Result<Pipeline> {
        let stages = device.watched(|| STAGES.iter().map(|stage| compile(&device.device, stage)).collect())?;
        Ok(Pipeline { device: device.clone(), stages, loaded: None, batch: batch.max(1) })
    }

    /// Iterations of one submission, at most.
    pub fn batch(&self) -> usize {
        self.batch
    }

    /// The device it runs on.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// Makes the buffers of a scene.
    ///
    /// # Errors
    /// [`crate::Error::Device`] if the scene is too large for the device.
    pub fn load(&mut self, scene: &Scene) -> Result<()> {
        self.loaded = None;
        let upload = Upload::new(scene, &self.device)?;
        self.fill(upload)
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
    /// [`crate::Error::Device`] without a scene, or if the device has not the room.
    pub fn make_room(&mut self, entries: usize) -> Result<()> {
        let Some(Loaded { mut upload, .. }) = self.loaded.take() else {
            return Err(self.device.error("no scene was loaded"));
        };
        upload.scene.entries = entries as u32;
        self.fill(upload)
    }

    fn fill(&mut self, upload: Upload) -> Result<()> {
        let buffers = Buffers::new(&self.device, &upload, self.batch)?;
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
        let bind_groups = self.device.watched(|| STAGES.iter().zip(&self.stages).map(bind).collect())?;
        self.loaded = Some(Loaded { upload, buffers, bind_groups });
        Ok(())
    }

    fn loaded(&self) -> Result<&Loaded> {
        self.loaded.as_ref().ok_or_else(|| self.device.error("no scene was loaded"))
    }

    /// Overwrites a buffer from its start.
    ///
    /// # Errors
    /// [`crate::Error::Device`] without a scene.
    pub fn write<T: Pod>(&self, slot: Slot, values: &[T]) -> Result<()> {
        self.write_at(slot, 0, values)
    }

    /// Overwrites a buffer from its value `first` on.
    pub(super) fn write_at<T: Pod>(&self, slot: Slot, first: usize, values: &[T]) -> Result<()> {
        self.loaded()?.buffers.write(&self.device, slot, first * size_of::<T>(), values);
        Ok(())
    }

    /// The first `count` values of a buffer.
    ///
    /// # Errors
    /// [`crate::Error::Device`] without a scene, or if the device is lost.
    pub fn read<T: Pod>(&self, slot: Slot, count: usize) -> Result<Vec<T>> {
        let bytes = self.read_bytes(&[(slot, 0..count * size_of::<T>())])?;
        Ok(bytemuck::pod_collect_to_vec(&bytes[0]))
    }

    /// Byte ranges of several buffers, in one go.
    pub(super) fn read_bytes(&self, wanted: &[(Slot, Range<usize>)]) -> Result<Vec<Vec<u8>>> {
        self.loaded()?.buffers.read(&self.device, wanted)
    }

    /// Submits the stages from `first` to `last` once for each of `steps` (at most [`Pipeline::batch`]); `count` is how
    /// many steps Adam's moments have seen before. Iteration i writes row i of the terms.
    ///
    /// # Errors
    /// [`crate::Error::Device`] without a scene.
    ///
    /// # Panics
    /// If a stage's name is unknown.
    pub fn run(&self, first: &str, last: &str, steps: &[Step], count: u32) -> Result<()> {
        let loaded = self.loaded()?;
        let steps = &steps[..steps.len().min(self.batch)];
        let mut packed = vec![0u8; steps.len() * UNIFORM_STRIDE];
        for (i, (step, bytes)) in steps.iter().zip(packed.chunks_exact_mut(UNIFORM_STRIDE)).enumerate() {
            let step = pack(step, count + i as u32 + 1, i);
            bytes[..size_of_val(&step)].copy_from_slice(bytemuck::bytes_of(&step));
        }
        loaded.buffers.write(&self.device, Slot::Step, 0, &packed);
        let (first, last) = (Stage::index(first), Stage::index(last));
        let mut encoder = self.device.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for i in 0..steps.len() {
            for index in first..=last {
                loaded.dispatch(&mut pass, index, &self.stages[index], i);
            }
        }
        drop(pass);
        self.device.queue.submit([encoder.finish()]);
        Ok(())
    }
}

/// Bytes of the largest uniform of several.
const ONE_UNIFORM: u64 = 80;
const _: () = assert!(size_of::<super::layout::Step>() == ONE_UNIFORM as usize);

impl Loaded {
    /// Adds stage `index` of iteration `i`.
    fn dispatch(&self, pass: &mut wgpu::ComputePass, index: usize, pipeline: &wgpu::ComputePipeline, i: usize) {
        let stage = &STAGES[index];
        let scene = &self.upload.scene;
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
            Over::EachPoint => dispatch(points, 1, 0),
            Over::Outline { border } => {
                let rows = if border { self.most_rows() } else { 0 };
                dispatch(outline_groups(samples, rows), views, 0);
            }
            Over::Views => dispatch(1, views, 0),
            Over::Rows => dispatch(self.most_rows(), views, 0),
            Over::Once => dispatch(1, 1, 0),
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

fn compile(device: &wgpu::Device, stage: &Stage) -> wgpu::ComputePipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(stage.name),
        source: wgpu::ShaderSource::Wgsl(stage.source().into()),
    });
    let entry = |&slot: &Slot| {
        let access = slot.access();
        let ty = match access {
            Access::UniformOfMany | Access::Uniform => wgpu::BufferBindingType::Uniform,
            Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
            Access::ReadWrite => wgpu::BufferBindingType::Storage { read_only: false },
        };
        wgpu::BindGroupLayoutEntry {
            binding: slot as u32,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty,
                has_dynamic_offset: access == Access::UniformOfMany,
                min_binding_size: None,
            },
            count: None,
        }
    };
    let bind_group = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(stage.name),
        entries: &stage.slots.iter().map(entry).collect::<Vec<_>>(),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(stage.name),
        bind_group_layouts: &[Some(&bind_group)],
        immediate_size: 0,
    });
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(stage.name),
        layout: Some(&layout),
        module: &module,
        entry_point: Some(stage.name),
        compilation_options: Default::default(),
        cache: None,
    })
}
