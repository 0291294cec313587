//! The device: which adapter, what it is called, what it can do.

use crate::{Error, Result};
use std::sync::{Arc, Mutex};

/// Which devices will do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A graphics card, in the machine or virtual.
    Card,
    /// Any, also one that is a program on the processor: right, but slow. For tests.
    Any,
}

impl Kind {
    /// Cards, and with the variable `WIRE4D_SOFTWARE_GPU` set any: who has no card is better off with the processor.
    pub fn wanted() -> Kind {
        if std::env::var_os("WIRE4D_SOFTWARE_GPU").is_some() { Kind::Any } else { Kind::Card }
    }
}

/// What a device is called and how it is reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeviceInfo {
    /// As its driver calls it.
    pub name: String,
    /// `discrete card`, `integrated card`, `virtual card`, `software` or `unknown`.
    pub kind: &'static str,
    /// The interface it is reached by, such as `vulkan`.
    pub interface: String,
}

impl std::fmt::Display for DeviceInfo {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} ({}, {})", self.name, self.kind, self.interface)
    }
}

/// A device that is ready, with WebGPU's default limits and no features: what works here works in a browser.
#[derive(Debug, Clone)]
pub struct Device {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    info: DeviceInfo,
    /// The first thing the device objected to outside [`Device::watched`]; without a place for it the program would end.
    fault: Arc<Mutex<Option<String>>>,
}

impl Device {
    /// The best device of a kind: discrete before integrated before virtual before software.
    ///
    /// # Errors
    /// [`Error::Device`] where there is none, or where it refuses.
    pub fn acquire(kind: Kind) -> Result<Device> {
        pollster::block_on(Device::acquire_async(kind))
    }

    async fn acquire_async(kind: Kind) -> Result<Device> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
            backends: wgpu::Backends::VULKAN,
            ..wgpu::InstanceDescriptor::new_without_display_handle()
        });
        let mut adapters = instance.enumerate_adapters(wgpu::Backends::VULKAN).await;
        adapters.retain(|adapter| kind == Kind::Any || rank(adapter.get_info().device_type) < SOFTWARE);
        adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
        let Some(adapter) = adapters.into_iter().next() else {
            return Err(Error::device("no device", "there is no graphics card with a Vulkan driver", REMEDY));
        };
        let found = adapter.get_info();
        let info = DeviceInfo {
            name: found.name,
            kind: kind_name(found.device_type),
            interface: format!("{:?}", found.backend).to_lowercase(),
        };
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("wire4d"),
            required_features: wgpu::Features::empty(),
            required_limits: wgpu::Limits::default(),
            ..Default::default()
        };
        match adapter.request_device(&descriptor).await {
            Ok((device, queue)) => {
                let fault = Arc::new(Mutex::new(None));
                let noted = Arc::clone(&fault);
                device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| note(&noted, &error)));
                Ok(Device { device, queue, info, fault })
            }
            Err(error) => Err(Error::device(info.name, one_line(&error.to_string()), REMEDY)),
        }
    }

    /// What it is.
    pub fn info(&self) -> &DeviceInfo {
        &self.info
    }

    /// Its limits as names and values, those that bound what can be fitted.
    pub fn limits(&self) -> [(&'static str, u64); 4] {
        let limits = self.device.limits();
        [
            ("storage buffers a stage", u64::from(limits.max_storage_buffers_per_shader_stage)),
            ("bytes a storage buffer", limits.max_storage_buffer_binding_size),
            ("invocations a workgroup", u64::from(limits.max_compute_invocations_per_workgroup)),
            ("workgroups a dimension", u64::from(limits.max_compute_workgroups_per_dimension)),
        ]
    }

    /// An error of this device with its name.
    pub(super) fn error(&self, problem: impl Into<String>) -> Error {
        Error::device(&self.info.name, problem, REMEDY)
    }

    /// What the device has objected to so far, as an error.
    pub(super) fn faultless(&self) -> Result<()> {
        match self.fault.lock().map(|fault| fault.clone()) {
            Ok(None) => Ok(()),
            Ok(Some(fault)) => Err(self.error(fault)),
            Err(_) => Err(self.error("it failed while it reported a failure")),
        }
    }

    /// Runs `work` and turns what the device objects to into an error.
    pub(super) fn watched<T>(&self, work: impl FnOnce() -> T) -> Result<T> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let done = work();
        let validation = pollster::block_on(validation.pop());
        let memory = pollster::block_on(memory.pop());
        match validation.or(memory) {
            None => Ok(done),
            Some(error) => Err(self.error(one_line(&error.to_string()))),
        }
    }
}

pub(super) const REMEDY: &str = "fit on the processor instead (--backend cpu)";
const SOFTWARE: u32 = 3;

fn rank(kind: wgpu::DeviceType) -> u32 {
    match kind {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Cpu => SOFTWARE,
        wgpu::DeviceType::Other => SOFTWARE + 1,
    }
}

fn kind_name(kind: wgpu::DeviceType) -> &'static str {
    match kind {
        wgpu::DeviceType::DiscreteGpu => "discrete card",
        wgpu::DeviceType::IntegratedGpu => "integrated card",
        wgpu::DeviceType::VirtualGpu => "virtual card",
        wgpu::DeviceType::Cpu => "software",
        wgpu::DeviceType::Other => "unknown",
    }
}

/// Keeps the first of several faults: later ones follow from it.
fn note(fault: &Mutex<Option<String>>, error: &wgpu::Error) {
    if let Ok(mut fault) = fault.lock() {
        fault.get_or_insert_with(|| one_line(&error.to_string()));
    }
}

/// A driver's message on one line, as errors are printed.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}
