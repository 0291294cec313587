//! What computes a fit, as the settings say.

use crate::Result;
use crate::optimize::{CpuEngine, Engine, Place};
use crate::settings::Backend;

/// `gpu`: the best graphics card, if it passes its check. `cpu` and `auto`: the processor; no card has been measured to be
/// faster yet.
///
/// # Errors
/// [`crate::Error::Device`] if a card is asked for and there is none, or none that computes rightly.
#[cfg(feature = "gpu")]
pub(super) fn engine(backend: Backend) -> Result<Box<dyn Engine>> {
    use crate::gpu::{Device, GpuEngine, Kind};
    match backend {
        Backend::Cpu | Backend::Auto => Ok(Box::new(CpuEngine::new())),
        Backend::Gpu => Ok(Box::new(GpuEngine::new(&Device::acquire(Kind::wanted())?)?)),
    }
}

/// The processor, all that this build knows.
///
/// # Errors
/// [`crate::Error::Setting`] if a graphics card is asked for.
#[cfg(not(feature = "gpu"))]
pub(super) fn engine(backend: Backend) -> Result<Box<dyn Engine>> {
    if backend == Backend::Gpu {
        return Err(crate::Error::setting("backend", "this build computes on the processor alone", "use auto or cpu"));
    }
    Ok(Box::new(CpuEngine::new()))
}

/// Where a fit with this backend will be computed, and why.
///
/// # Errors
/// [`crate::Error::Device`] if a card is asked for and there is none, or none that computes rightly.
pub fn place(backend: Backend) -> Result<Place> {
    Ok(engine(backend)?.place())
}
