//! From a stage's text to a pipeline.

use super::stage::{Access, Slot, Stage};

/// A stage's pipeline, with a layout of its own: derived ones cannot have uniforms of many.
pub(super) fn compile(device: &wgpu::Device, stage: &Stage) -> wgpu::ComputePipeline {
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
