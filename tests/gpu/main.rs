//! The engine on a graphics card, or a program that plays one, against the processor.

#![cfg(feature = "gpu")]

mod engine;
mod fill;
#[path = "../support/gpu_common/mod.rs"]
mod gpu_common;
mod guidance;
#[path = "../support/guided/mod.rs"]
mod guided;
#[path = "../support/notice/mod.rs"]
mod notice;
#[path = "../support/optimize_common/mod.rs"]
mod optimize_common;
mod raster;
#[path = "../support/raster_wires/mod.rs"]
mod raster_wires;
mod shaders;
mod stages;
mod texture;
