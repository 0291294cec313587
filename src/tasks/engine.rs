//! What computes a fit, as the settings say, and why.

use crate::Result;
use crate::optimize::{CpuEngine, Engine, Place};
use crate::settings::Backend;

/// `gpu`: the best device there is, be it a program. `cpu`: the processor. `auto`: a graphics card if there is one and it
/// passes its check, else the processor; it is faster than any program that plays a graphics card.
///
/// # Errors
/// [`crate::Error::Device`] if a device is asked for and there is none, or none that computes rightly.
pub(super) async fn engine(backend: Backend) -> Result<Box<dyn Engine>> {
    match backend {
        Backend::Cpu => Ok(Box::new(CpuEngine::because("The processor does the work, as the settings ask."))),
        Backend::Gpu => device_engine().await,
        Backend::Auto => Ok(best_engine().await),
    }
}

/// Where a fit with this backend will be computed, and why.
///
/// # Errors
/// As [`engine`].
pub async fn place(backend: Backend) -> Result<Place> {
    Ok(engine(backend).await?.place())
}

#[cfg(feature = "gpu")]
mod device {
    use super::*;
    use crate::gpu::{Absence, Device, GpuEngine, Kind, self_check, speed_up};

    /// A device that has passed its check: on a page the last one, if it still works.
    async fn checked(kind: Kind) -> Result<Device, Absence> {
        #[cfg(target_arch = "wasm32")]
        if let Some(device) = page::kept(kind) {
            return Ok(device);
        }
        let device = Device::acquire_async(kind).await?;
        self_check(&mut GpuEngine::new(&device, "")).await?;
        #[cfg(target_arch = "wasm32")]
        page::keep(kind, &device);
        Ok(device)
    }

    /// The browser's device that fits are computed on, if there is one by now: see [`Device::browser_device`].
    #[cfg(target_arch = "wasm32")]
    pub fn browser_device() -> Option<wasm_bindgen::JsValue> {
        page::last().and_then(|device| device.browser_device())
    }

    /// A page asks where fits will be computed before it starts one: that should not cost a device twice. Natively a
    /// device must not outlive its thread, and nobody asks twice.
    #[cfg(target_arch = "wasm32")]
    mod page {
        use super::{Device, Kind};
        use std::cell::RefCell;

        thread_local! {
            static KEPT: RefCell<Option<(Kind, Device)>> = const { RefCell::new(None) };
        }

        pub fn kept(kind: Kind) -> Option<Device> {
            fine().filter(|(of, _)| *of == kind).map(|(_, device)| device)
        }

        pub fn last() -> Option<Device> {
            fine().map(|(_, device)| device)
        }

        fn fine() -> Option<(Kind, Device)> {
            KEPT.with_borrow(Clone::clone).filter(|(_, device)| device.faultless().is_ok())
        }

        pub fn keep(kind: Kind, device: &Device) {
            KEPT.set(Some((kind, device.clone())));
        }
    }

    pub async fn device_engine() -> Result<Box<dyn Engine>> {
        let device = checked(Kind::Any).await?;
        let why = match device.info().is_software() {
            true => "A program that stands in for a graphics card does the work, as the settings ask: right, but slow.",
            false => "The graphics card does the work, as the settings ask.",
        };
        Ok(Box::new(GpuEngine::new(&device, why)))
    }

    pub async fn best_engine() -> Box<dyn Engine> {
        let device = match checked(Kind::Card).await {
            Ok(device) => device,
            Err(absence) => return Box::new(CpuEngine::because(sentence(&absence.to_string()))),
        };
        // A small card beside a large processor: who leaves the choice open wants the wire soon.
        match speed_up(&device).await {
            slower if slower < 1.0 => {
                let device = &device.info().name;
                Box::new(CpuEngine::because(sentence(&format!("the graphics card {device} is slower here"))))
            }
            faster => {
                let why =
                    format!("The graphics card does the work: on a small trial it was {faster:.0} times as fast.");
                Box::new(GpuEngine::new(&device, why))
            }
        }
    }

    /// Why the processor does the work.
    fn sentence(absence: &str) -> String {
        let mut letters = absence.chars();
        let first = letters.next().map(|first| first.to_ascii_uppercase());
        format!("{}, so the processor does the work.", first.into_iter().chain(letters).collect::<String>())
    }
}
#[cfg(all(feature = "gpu", target_arch = "wasm32"))]
pub use device::browser_device;
#[cfg(feature = "gpu")]
use device::{best_engine, device_engine};

#[cfg(not(feature = "gpu"))]
async fn device_engine() -> Result<Box<dyn Engine>> {
    Err(crate::Error::setting("backend", "this build computes on the processor alone", "use auto or cpu"))
}

#[cfg(not(feature = "gpu"))]
async fn best_engine() -> Box<dyn Engine> {
    Box::new(CpuEngine::because("This build computes on the processor alone."))
}
