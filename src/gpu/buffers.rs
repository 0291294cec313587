//! Buffers on the device, and reading them back.

use super::device::Device;
use super::fault::{Answer, FaultKind};
use super::layout::{JOINT_BYTES, MOST_LEVELS, SHAPE_BYTES};
use super::stage::{SLOTS, Slot};
use super::upload::Upload;
use crate::optimize::term_count;
use bytemuck::Pod;
use futures_channel::oneshot;
use wgpu::BufferUsages as Usage;

/// Where one of several uniforms may begin: WebGPU's default alignment.
pub(super) const UNIFORM_STRIDE: usize = 256;
/// Entries of a node in `d_pieces` and in `d_nodes`.
const PULLS: usize = 3;

/// All buffers of a scene, by [`Slot`].
pub(super) struct Buffers {
    buffers: Vec<wgpu::Buffer>,
    /// What is read goes through here; as large as the largest reading so far.
    staging: Option<wgpu::Buffer>,
}

impl Drop for Buffers {
    /// Browsers would keep the memory until they next tidy up.
    fn drop(&mut self) {
        self.buffers.iter().chain(&self.staging).for_each(wgpu::Buffer::destroy);
    }
}

impl Buffers {
    /// For iterations of up to `batch` a submission.
    ///
    /// # Errors
    /// A fault if a buffer is larger than the device takes, or there is no memory left.
    pub async fn new(device: &Device, upload: &Upload, batch: usize) -> Answer<Buffers> {
        let scene = &upload.scene;
        let [points, samples, views, pixels] =
            [scene.points, scene.samples, scene.views, scene.pixels].map(|count| count as usize);
        let nodes = samples * views;
        let vec4 = 4 * size_of::<f32>();
        let bytes = |slot: Slot| -> usize {
            match slot {
                Slot::Step => batch * UNIFORM_STRIDE,
                Slot::Scene => size_of_val(scene),
                Slot::Pass => MOST_LEVELS * UNIFORM_STRIDE,
                Slot::SamplingRows => size_of_val(&*upload.sampling.rows),
                Slot::SamplingStarts => size_of_val(&*upload.sampling.starts),
                Slot::SamplingTerms => size_of_val(&*upload.sampling.terms),
                Slot::Links => size_of_val(&*upload.links),
                Slot::JerkRows => size_of_val(&*upload.jerk.rows),
                Slot::JerkStarts => size_of_val(&*upload.jerk.starts),
                Slot::JerkTerms => size_of_val(&*upload.jerk.terms),
                Slot::Levels => size_of_val(&*upload.levels),
                Slot::Circles => size_of_val(&*upload.circles),
                Slot::TargetInk | Slot::OccluderDepth | Slot::Coverage => 4 * pixels,
                Slot::Planes => size_of_val(&*upload.planes),
                Slot::TextureLevels => size_of_val(&*upload.texture.levels),
                Slot::TextureGiven => size_of_val(&*upload.texture.given),
                Slot::Texture => 4 * upload.texture.room,
                Slot::Nodes => size_of_val(&*upload.strand.nodes),
                Slot::PointNodes => size_of_val(&*upload.strand.point_nodes),
                Slot::Neighbours => 4 * upload.strand.room(),
                Slot::DNodes => PULLS * upload.strand.nodes.len() * vec4,
                Slot::State => 3 * points * vec4,
                Slot::Best => (1 + points) * vec4,
                Slot::GradientNorms => 4 * points,
                Slot::Samples | Slot::DSamples => samples * vec4,
                Slot::Vertices | Slot::DVertices => nodes * vec4,
                Slot::Joints => nodes * JOINT_BYTES as usize,
                Slot::Shapes => nodes * SHAPE_BYTES as usize,
                Slot::Cells => 4 * (scene.cells_head() + 3 * nodes + 2 * scene.entries as usize),
                Slot::Sums => 4 * (pixels + upload.rows),
                Slot::Pyramid => 4 * upload.pyramid,
                Slot::Partials => 4 * upload.partials,
                Slot::DPieces => nodes * PULLS * vec4,
                Slot::DPointsImage | Slot::DPoints => points * vec4,
                Slot::Terms => 4 * batch * (term_count(views) + 1),
                Slot::Visible => 8 * 4 * nodes,
            }
        };
        let limits = device.device.limits();
        let most = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        let mut sizes = [0u64; SLOTS.len()];
        for &slot in SLOTS {
            let size = bytes(slot).max(vec4).next_multiple_of(vec4) as u64;
            if size > most {
                let problem = format!("the fit takes a buffer of {size} bytes and this device {most}");
                return Err(device.fault(FaultKind::Limits, problem));
            }
            sizes[slot as usize] = size;
        }
        let buffers = device.watched(|| {
            let create = |&slot: &Slot| {
                let kind = match slot {
                    Slot::Step | Slot::Scene | Slot::Pass => Usage::UNIFORM,
                    _ => Usage::STORAGE,
                };
                device.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(&format!("{slot:?}")),
                    size: sizes[slot as usize],
                    usage: kind | Usage::COPY_DST | Usage::COPY_SRC,
                    mapped_at_creation: false,
                })
            };
            SLOTS.iter().map(create).collect()
        });
        let made = Buffers { buffers: buffers.await?, staging: None };
        made.write(device, Slot::SamplingRows, 0, &upload.sampling.rows);
        made.write(device, Slot::SamplingStarts, 0, &upload.sampling.starts);
        made.write(device, Slot::SamplingTerms, 0, &upload.sampling.terms);
        made.write(device, Slot::Links, 0, &upload.links);
        made.write(device, Slot::JerkRows, 0, &upload.jerk.rows);
        made.write(device, Slot::JerkStarts, 0, &upload.jerk.starts);
        made.write(device, Slot::JerkTerms, 0, &upload.jerk.terms);
        made.write(device, Slot::Levels, 0, &upload.levels);
        made.write(device, Slot::Circles, 0, &upload.circles);
        made.write(device, Slot::Planes, 0, &upload.planes);
        made.write(device, Slot::Nodes, 0, &upload.strand.nodes);
        made.write(device, Slot::PointNodes, 0, &upload.strand.point_nodes);
        made.write(device, Slot::Neighbours, 0, &upload.strand.neighbours);
        made.write_views(device, upload);
        for level in 0..MOST_LEVELS {
            made.write(device, Slot::Pass, level * UNIFORM_STRIDE, &[level as u32]);
        }
        Ok(made)
    }

    /// Writes what views bring along.
    pub fn write_views(&self, device: &Device, upload: &Upload) {
        self.write(device, Slot::Scene, 0, std::slice::from_ref(&upload.scene));
        self.write(device, Slot::TargetInk, 0, &upload.target_ink);
        self.write(device, Slot::OccluderDepth, 0, &upload.occluder_depth);
        self.write(device, Slot::TextureLevels, 0, &upload.texture.levels);
        self.write(device, Slot::TextureGiven, 0, &upload.texture.given);
    }

    pub fn get(&self, slot: Slot) -> &wgpu::Buffer {
        &self.buffers[slot as usize]
    }

    /// Writes values from a byte offset on.
    pub fn write<T: Pod>(&self, device: &Device, slot: Slot, offset: usize, values: &[T]) {
        device.queue.write_buffer(self.get(slot), offset as u64, bytemuck::cast_slice(values));
    }

    /// Reads byte ranges of several buffers in one go, after all work before. A native device is waited for; a browser's
    /// answers when it is done.
    ///
    /// # Errors
    /// A fault if the device is lost.
    pub async fn read(&mut self, device: &Device, wanted: &[(Slot, std::ops::Range<usize>)]) -> Answer<Vec<Vec<u8>>> {
        let total = wanted.iter().map(|(_, bytes)| bytes.len() as u64).sum::<u64>().max(4);
        let staging = self.staging(device, total).clone();
        let mut encoder = device.device.create_command_encoder(&Default::default());
        let mut at = 0;
        for (slot, bytes) in wanted {
            let length = bytes.len() as u64;
            encoder.copy_buffer_to_buffer(self.get(*slot), bytes.start as u64, &staging, at, length);
            at += length;
        }
        device.queue.submit([encoder.finish()]);
        let (sender, receiver) = oneshot::channel();
        staging.map_async(wgpu::MapMode::Read, ..total, move |result| drop(sender.send(result)));
        let lost = |what: String| device.fault(FaultKind::Lost, format!("it does not answer ({what})"));
        device.device.poll(wgpu::PollType::wait_indefinitely()).map_err(|error| lost(error.to_string()))?;
        let mapped = receiver.await;
        device.faultless()?;
        match mapped {
            Ok(Ok(())) => {}
            Ok(Err(error)) => return Err(lost(error.to_string())),
            Err(error) => return Err(lost(error.to_string())),
        }
        let mut parts = Vec::with_capacity(wanted.len());
        {
            let mapped = staging.get_mapped_range(..total).map_err(|error| lost(error.to_string()))?;
            let mut at = 0;
            for (_, bytes) in wanted {
                parts.push(mapped[at..at + bytes.len()].to_vec());
                at += bytes.len();
            }
        }
        staging.unmap();
        Ok(parts)
    }

    /// The staging buffer, with room for `bytes`.
    fn staging(&mut self, device: &Device, bytes: u64) -> &wgpu::Buffer {
        if self.staging.as_ref().is_some_and(|staging| staging.size() < bytes) {
            self.staging.take().iter().for_each(wgpu::Buffer::destroy);
        }
        self.staging.get_or_insert_with(|| {
            device.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("read back"),
                size: bytes.next_multiple_of(4),
                usage: Usage::MAP_READ | Usage::COPY_DST,
                mapped_at_creation: false,
            })
        })
    }
}
