//! What a network is asked and answers, whoever runs it: a file on the processor, a browser's onnxruntime, a test's few lines.

use super::Patch;
use crate::Result;
use crate::view::Image;
use crate::work::Work;

/// A network that embeds pictures where words lie too, together with its gradient: the contract guidance-v1 of
/// `tools/guidance`. E is [`Network::embed`], S is [`Network::size`].
pub trait Network: Send {
    /// Side of a picture, px.
    fn size(&self) -> usize;

    /// Numbers of an embedding.
    fn embed(&self) -> usize;

    /// Loss, gradient, cosines and embeddings of a batch of any size from 1.
    ///
    /// # Errors
    /// [`crate::Error::Guidance`] for whatever keeps it from answering.
    fn run<'a>(&'a mut self, batch: Batch<'a>) -> Work<'a, Result<Answer>>;
}

/// What goes into a network: n rows.
#[derive(Debug, Clone, Copy)]
pub struct Batch<'a> {
    /// `[n, 3, S, S]`, sRGB 0 to 1, rows from the top.
    pub images: &'a [f32],
    /// `[n, E]`: what each embedding is measured from; zeros for the embedding itself.
    pub source: &'a [f32],
    /// `[n, E]`: unit vectors, where each should lie from there.
    pub target: &'a [f32],
    /// `[n]`: what each row counts.
    pub weight: &'a [f32],
}

/// What comes out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// Sum over rows of weight (1 - cos).
    pub loss: f32,
    /// `[n, 3, S, S]`: d loss / d images.
    pub gradient: Vec<f32>,
    /// `[n]`: cosine between target and `d / sqrt(|d|^2 + 1e-6)`, `d` = embedding - source.
    pub cos: Vec<f32>,
    /// `[n, E]`: unit vectors.
    pub embedding: Vec<f32>,
}

/// The cosine between what `network` sees in all of `ink` (0 to 1, drawn dark on white) and the unit vector `target`: CLIP's
/// score, where the network is CLIP.
///
/// # Errors
/// As [`Network::run`].
pub async fn similarity(network: &mut dyn Network, ink: &Image, target: &[f32]) -> Result<f32> {
    Ok(looked_at(network, ink, target).await?.cos[0])
}

/// What `network` sees in all of `ink`: a unit vector.
///
/// # Errors
/// As [`Network::run`].
pub async fn embedding(network: &mut dyn Network, ink: &Image) -> Result<Vec<f32>> {
    // Any unit vector: nothing comes back of it.
    let target: Vec<f32> = (0..network.embed()).map(|i| f32::from(i == 0)).collect();
    Ok(looked_at(network, ink, &target).await?.embedding)
}

/// The cosine between what `network` sees in all of two pictures of ink.
///
/// # Errors
/// As [`Network::run`].
pub async fn likeness(network: &mut dyn Network, ink: &Image, other: &Image) -> Result<f32> {
    let seen = embedding(network, other).await?;
    similarity(network, ink, &seen).await
}

async fn looked_at(network: &mut dyn Network, ink: &Image, target: &[f32]) -> Result<Answer> {
    let size = network.size();
    let mut image = vec![0.0; 3 * size * size];
    Patch::whole(ink.width, ink.height).draw(&ink.data, ink.width, size, &mut image);
    let source = vec![0.0; target.len()];
    network.run(Batch { images: &image, source: &source, target, weight: &[0.0] }).done().await
}
