//! What goes wrong on a device that was there.

use crate::Error;

/// What helps where there is no device.
pub(super) const REMEDY: &str = if cfg!(target_arch = "wasm32") {
    "choose the processor in the settings"
} else {
    "fit on the processor instead (--backend cpu)"
};

/// A device's trouble.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The device as its driver calls it.
    pub device: String,
    /// What kind it is, hence what helps.
    pub kind: FaultKind,
    /// What went wrong.
    pub problem: String,
}

/// What helps against a [`Fault`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultKind {
    /// The device is gone or makes no sense: another one, or the same acquired again.
    Lost,
    /// Its memory is full: less of it at a time.
    Memory,
    /// The fit is beyond its limits: another kind of device.
    Limits,
}

impl From<Fault> for Error {
    fn from(Fault { device, problem, .. }: Fault) -> Error {
        Error::device(device, problem, REMEDY)
    }
}

/// Shorthand for what a device answers.
pub(super) type Answer<T> = std::result::Result<T, Fault>;
