//! What makes a wire good: image losses over a pyramid, textures, what keeps the curve a wire (bending, clearance, length, a
//! surface), and targets that bend a little.

mod clearance;
mod elastic;
mod guidance;
mod multiscale_mse;
mod net;
mod regularisers;
mod straight;
mod surface;
mod texture;
mod warp;

pub use clearance::{Clearance, MOST_NEIGHBOURS, Neighbours, clearance_and_gradient};
pub use elastic::{Elastic, ElasticTerms, STANDSTILL, elastic_and_gradient};
pub use guidance::{
    Aim, Annealing, Answer, Batch, Denoiser, Diffusion, Distilled, Encoder, Guidance, Guides, Latent, Learned, Look,
    Member, Network, PICTURE_WEIGHT, Patch, Progress, Prompt, Prompts, Rendered, WORDS_WEIGHT, embedding, likeness,
    relative_pose, similarity,
};
pub use multiscale_mse::{MultiscaleMse, Pyramid, level_sizes};
pub use regularisers::length_and_gradient;
pub use surface::surface_and_gradient;
#[cfg(feature = "gpu")]
pub use texture::packed as packed_texture;
pub use texture::{Texture, TextureGuidance, TextureLoss, TextureOptions, crop_weights};
pub use warp::{Displacement, Warp, WarpWeights, bend_ink};
