//! What computes a fit, as the settings say.

use crate::optimize::{CpuEngine, Engine};
use crate::settings::Backend;
use crate::{Error, Result};

/// `cpu`: the processor. `gpu`: the best device there is, also a program that stands in for a card. `auto`: a graphics
/// card that passes its check, else the processor.
///
/// # Errors
/// [`Error::Device`] if a device is asked for and there is none, or none that computes rightly.
#[cfg(feature = "gpu")]
pub(super) fn engine(backend: Backend) -> Result<Box<dyn Engine>> {
    use crate::gpu::{Device, GpuEngine, Kind};
    let on = |kind| -> Result<Box<dyn Engine>> { Ok(Box::new(GpuEngine::new(&Device::acquire(kind)?)?)) };
    match backend {
        Backend::Cpu => Ok(Box::new(CpuEngine::new())),
        Backend::Gpu => on(Kind::Any),
        Backend::Auto => Ok(on(Kind::Card).unwrap_or_else(|_: Error| Box::new(CpuEngine::new()))),
    }
}

/// The processor, all that this build knows.
///
/// # Errors
/// [`Error::Setting`] if a graphics card is asked for.
#[cfg(not(feature = "gpu"))]
pub(super) fn engine(backend: Backend) -> Result<Box<dyn Engine>> {
    if backend == Backend::Gpu {
        return Err(Error::setting("backend", "this build computes on the processor alone", "use auto or cpu"));
    }
    Ok(Box::new(CpuEngine::new()))
}
