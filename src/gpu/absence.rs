//! Why there is no device to compute on, in words for people.

use super::fault::REMEDY;
use crate::Error;

/// What a device is called as long as its own name is not known.
pub(super) const NAME: &str = "graphics card";

/// What stands in the way.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Absence {
    /// The browser does not know WebGPU, or the machine has no Vulkan.
    #[error("{}", if cfg!(target_arch = "wasm32") { "this browser has no WebGPU" } else { "there is no Vulkan driver" })]
    NoInterface,
    /// Browsers offer WebGPU to pages over https and from the own machine only.
    #[error("this page was not opened over https, and browsers keep WebGPU from such pages")]
    Insecure,
    /// The interface is there and nothing behind it.
    #[error("{}", match cfg!(target_arch = "wasm32") {
        true => "this browser has WebGPU but no graphics card that it would use",
        false => "there is no graphics card with a Vulkan driver",
    })]
    NoAdapter,
    /// All there is is a program on the processor.
    #[error("the only graphics device here is a program on the processor ({0})")]
    Software(String),
    /// There is a card, and it is not handed out.
    #[error("the graphics card is blocked here ({0})")]
    Blocked(String),
    /// There is a card, and it computes something else than the processor, or not at all.
    #[error("the graphics card {name} did not pass its check: {problem}")]
    Unfit {
        /// The card as its driver calls it.
        name: String,
        /// What is wrong with it.
        problem: String,
    },
}

impl From<Absence> for Error {
    fn from(absence: Absence) -> Error {
        Error::device(NAME, absence.to_string(), REMEDY)
    }
}
