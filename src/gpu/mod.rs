//! The fit on a graphics card: every stage of an iteration as a compute shader, named like its twin on the processor.
//!
//! Plain WebGPU: at most 8 storage buffers a stage, 256 invocations and 16 KiB a workgroup, integer atomics only.
//! Forward sums are integers and backward sums are gathered in fixed order, so a device gives the same bits each time.

mod absence;
mod banded;
#[cfg(target_arch = "wasm32")]
mod browser;
mod buffers;
mod calls;
mod check;
mod clock;
mod compile;
mod device;
mod engine;
mod fault;
mod layout;
mod pipeline;
mod raster;
mod stage;
mod strand;
mod texture;
mod upload;

pub use absence::Absence;
pub use check::{Parity, SELF_CHECK_BARS, parities, self_check, speed_up};
pub use device::{Device, DeviceInfo, Kind};
pub use engine::{Another, GpuEngine};
pub use fault::{Fault, FaultKind};
pub use layout::SHADER_LAYOUTS;
pub use pipeline::Pipeline;
pub use raster::GpuRaster;
pub use stage::{STAGES, Slot, Stage};
