//! Networks that say what a wire should look like, as `tools/guidance` writes them: an ONNX graph that gives a loss and its
//! gradient, and a sidecar that says what it is. Here such files are read, none of them trusted, and run on the processor.
//!
//! It is a crate of its own so that nobody who uses the library compiles what runs networks: the command line does.

mod adapt;
mod denoiser;
mod encoder;
mod graph;
mod network;
mod noise;
mod protobuf;
mod selftest;
mod sidecar;
mod text;
mod views;
mod words;

#[cfg(test)]
#[path = "../core/few_cases.rs"]
mod few_cases;
#[cfg(test)]
mod testing;

pub use denoiser::{Contexts, OnnxDenoiser};
pub use encoder::OnnxEncoder;
pub use network::OnnxNetwork;
pub use sidecar::Facts;
pub use text::TextEncoder;
pub use views::{NewViews, OnnxPoses};
pub use words::{Dictionary, WordTable};
