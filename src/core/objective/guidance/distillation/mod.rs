//! Score distillation: a diffusion model says what it would take from a noisy view for it to show what was asked for, and
//! the view follows.

mod distilled;
mod pose;
mod schedule;

pub use distilled::{Denoiser, Distilled, Encoder, Latent, Prompt, Prompts};
pub use pose::relative_pose;
pub use schedule::{Annealing, Diffusion};
