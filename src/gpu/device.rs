//! The device: which adapter, what it is called, what it can do, and what it objects to.

use super::absence::{Absence, NAME};
use super::compile::compile;
use super::fault::{Answer, Fault, FaultKind};
use super::stage::STAGES;
use crate::optimize::wait;
use std::result::Result;
use std::sync::{Arc, Mutex};

/// Which devices will do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A graphics card, in the machine or virtual.
    Card,
    /// Any, also one that is a program on the processor: right, but slow.
    Any,
}

/// What a device is called and how it is reached.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeviceInfo {
    /// As its driver calls it.
    pub name: String,
    /// `discrete card`, `integrated card`, `virtual card`, `card` or `software`.
    pub kind: &'static str,
    /// The interface it is reached by: `vulkan` or `webgpu`.
    pub interface: &'static str,
}

impl DeviceInfo {
    /// Whether it is a program on the processor.
    pub fn is_software(&self) -> bool {
        self.kind == "software"
    }
}

impl std::fmt::Display for DeviceInfo {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} ({}, {})", self.name, self.kind, self.interface)
    }
}

/// A device that is ready, every stage compiled, with no features: what works here works in a browser. Clones are the
/// same device.
#[derive(Debug, Clone)]
pub struct Device {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    /// The compiled [`STAGES`].
    pub(super) stages: Arc<[wgpu::ComputePipeline]>,
    info: DeviceInfo,
    kind: Kind,
    /// The first thing the device objected to outside [`Device::watched`], or why it was lost; without a place for it the
    /// program would end.
    fault: Arc<Mutex<Option<(FaultKind, String)>>>,
}

impl Device {
    /// [`Device::acquire_async`], waiting for it.
    ///
    /// # Errors
    /// As there.
    pub fn acquire(kind: Kind) -> Result<Device, Absence> {
        wait(Device::acquire_async(kind))
    }

    /// The best device of a kind: discrete before integrated before virtual before software.
    ///
    /// # Errors
    /// [`Absence`] where there is none, or where it refuses.
    pub async fn acquire_async(kind: Kind) -> Result<Device, Absence> {
        let (adapter, info) = adapter(kind).await?;
        // As plain WebGPU has them, but buffers as large as there may be.
        let offered = adapter.limits();
        let limits = wgpu::Limits {
            max_storage_buffer_binding_size: offered.max_storage_buffer_binding_size,
            max_buffer_size: offered.max_buffer_size,
            ..wgpu::Limits::default()
        };
        let descriptor = wgpu::DeviceDescriptor {
            label: Some("wire4d"),
            required_features: wgpu::Features::empty(),
            required_limits: limits,
            ..Default::default()
        };
        let requested = adapter.request_device(&descriptor).await;
        let (device, queue) = requested.map_err(|error| Absence::Blocked(one_line(&error.to_string())))?;
        let fault = Arc::new(Mutex::new(None));
        let noted = Arc::clone(&fault);
        device
            .on_uncaptured_error(Arc::new(move |error: wgpu::Error| note(&noted, kind_of(&error), &error.to_string())));
        let noted = Arc::clone(&fault);
        device.set_device_lost_callback(move |_, message| {
            note(&noted, FaultKind::Lost, &format!("it was lost: {message}"))
        });
        let unready = Device { device, queue, stages: Arc::new([]), info, kind, fault };
        let compiled = unready.watched(|| STAGES.iter().map(|stage| compile(&unready.device, stage)).collect()).await;
        let stages = compiled.map_err(|fault| Absence::Unfit { name: fault.device, problem: fault.problem })?;
        Ok(Device { stages, ..unready })
    }

    /// The browser's own device behind it, for others who compute on the same card. It is lent: nobody else may destroy it.
    #[cfg(target_arch = "wasm32")]
    pub fn browser_device(&self) -> Option<wasm_bindgen::JsValue> {
        self.device.as_webgpu().map(|device| device.clone().into())
    }

    /// What it is.
    pub fn info(&self) -> &DeviceInfo {
        &self.info
    }

    /// The kind that was asked for.
    pub(super) fn kind(&self) -> Kind {
        self.kind
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

    /// Gives the device back at once. Whatever computes on it finds it lost.
    pub fn destroy(&self) {
        note(&self.fault, FaultKind::Lost, "it was given back");
        self.device.destroy();
    }

    /// Forgets what the device objected to: for an objection that something was done about.
    pub(super) fn forgive(&self) {
        if let Ok(mut fault) = self.fault.lock() {
            fault.take();
        }
    }

    /// Makes the device object as it would to a mistake, to a full memory or to a fit too large. For tests.
    pub fn provoke(&self, kind: FaultKind) {
        match kind {
            FaultKind::Lost => {
                let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::STORAGE;
                let descriptor = wgpu::BufferDescriptor { label: None, size: 16, usage, mapped_at_creation: false };
                drop(self.device.create_buffer(&descriptor));
            }
            FaultKind::Memory | FaultKind::Limits => note(&self.fault, kind, "provoked"),
        }
    }

    /// A fault of this device.
    pub(super) fn fault(&self, kind: FaultKind, problem: impl Into<String>) -> Fault {
        Fault { device: self.info.name.clone(), kind, problem: problem.into() }
    }

    /// Whether the device has objected to nothing so far.
    pub(crate) fn faultless(&self) -> Answer<()> {
        match self.fault.lock().map(|fault| fault.clone()) {
            Ok(None) => Ok(()),
            Ok(Some((kind, problem))) => Err(self.fault(kind, problem)),
            Err(_) => Err(self.fault(FaultKind::Lost, "it failed while it reported a failure")),
        }
    }

    /// Runs `work` and turns what the device objects to into a fault.
    pub(super) async fn watched<T>(&self, work: impl FnOnce() -> T) -> Answer<T> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let done = work();
        let (validation, memory) = (validation.pop(), memory.pop());
        match validation.await.or(memory.await) {
            None => self.faultless().map(|()| done),
            Some(error) => Err(self.fault(kind_of(&error), one_line(&error.to_string()))),
        }
    }
}

/// The best adapter of a kind and what it is called.
#[cfg(not(target_arch = "wasm32"))]
async fn adapter(kind: Kind) -> Result<(wgpu::Adapter, DeviceInfo), Absence> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::VULKAN,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let mut adapters = instance.enumerate_adapters(wgpu::Backends::VULKAN).await;
    adapters.sort_by_key(|adapter| rank(adapter.get_info().device_type));
    let best = adapters.into_iter().next().ok_or(Absence::NoAdapter)?;
    let found = best.get_info();
    let info = info(found.name, found.device_type, "vulkan");
    allowed(kind, info).map(|info| (best, info))
}

/// The adapter that the browser offers and what it is called.
#[cfg(target_arch = "wasm32")]
async fn adapter(kind: Kind) -> Result<(wgpu::Adapter, DeviceInfo), Absence> {
    let found = super::browser::browser_adapter().await?;
    let device_type = if found.is_fallback { wgpu::DeviceType::Cpu } else { wgpu::DeviceType::Other };
    let info = allowed(kind, info(found.name, device_type, "webgpu"))?;
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor {
        backends: wgpu::Backends::BROWSER_WEBGPU,
        ..wgpu::InstanceDescriptor::new_without_display_handle()
    });
    let options = wgpu::RequestAdapterOptions {
        power_preference: wgpu::PowerPreference::HighPerformance,
        ..wgpu::RequestAdapterOptions::default()
    };
    let adapter = instance.request_adapter(&options).await.map_err(|_| Absence::NoAdapter)?;
    Ok((adapter, info))
}

/// The device if it is of the kind.
fn allowed(kind: Kind, info: DeviceInfo) -> Result<DeviceInfo, Absence> {
    if kind == Kind::Card && info.is_software() { Err(Absence::Software(info.name)) } else { Ok(info) }
}

/// Drivers that compute on the processor; not all of them say so.
const SOFTWARE: [&str; 4] = ["swiftshader", "llvmpipe", "lavapipe", "basic render"];

fn info(name: String, device_type: wgpu::DeviceType, interface: &'static str) -> DeviceInfo {
    let name = if name.trim().is_empty() { NAME.into() } else { name };
    let lower = name.to_ascii_lowercase();
    let software = SOFTWARE.iter().any(|software| lower.contains(software));
    DeviceInfo { name, kind: if software { "software" } else { kind_name(device_type) }, interface }
}

#[cfg(not(target_arch = "wasm32"))]
fn rank(kind: wgpu::DeviceType) -> u32 {
    match kind {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

fn kind_name(kind: wgpu::DeviceType) -> &'static str {
    match kind {
        wgpu::DeviceType::DiscreteGpu => "discrete card",
        wgpu::DeviceType::IntegratedGpu => "integrated card",
        wgpu::DeviceType::VirtualGpu => "virtual card",
        wgpu::DeviceType::Cpu => "software",
        // Browsers do not say which.
        wgpu::DeviceType::Other => "card",
    }
}

fn kind_of(error: &wgpu::Error) -> FaultKind {
    match error {
        wgpu::Error::OutOfMemory { .. } => FaultKind::Memory,
        wgpu::Error::Validation { .. } | wgpu::Error::Internal { .. } => FaultKind::Lost,
    }
}

/// Keeps the first of several faults: later ones follow from it.
fn note(fault: &Mutex<Option<(FaultKind, String)>>, kind: FaultKind, problem: &str) {
    if let Ok(mut fault) = fault.lock() {
        fault.get_or_insert_with(|| (kind, one_line(problem)));
    }
}

/// A driver's message on one line, as errors are printed.
fn one_line(message: &str) -> String {
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}
