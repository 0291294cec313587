//! Where a loss that looks at one view's picture alone joins the others.

/// A loss on what one view shows, beside the comparison with its target.
///
/// Texture statistics are one; a network that compares patches with words or pictures would be another. An engine calls
/// it after the picture is drawn and before the adjoint goes back through the rasteriser, for one view at a time.
pub trait Guidance: Send {
    /// `weight` times the loss of `coverage` (0 to 1, row by row). `weights`, 0 to 1, says how much each pixel counts.
    /// Adds the gradient to `d_coverage`. All three are of the size that the guidance was made for.
    fn guide(&mut self, coverage: &[f32], weights: &[f32], weight: f32, d_coverage: &mut [f32]) -> f32;
}
