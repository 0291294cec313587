//! Coverage of tapered round strokes and its adjoint: polylines of discs in pixels to a picture, and back.

use crate::wire::Stroke;

/// A differentiable stroke rasteriser: one object a view, with buffers that live across iterations.
pub trait Raster: Send {
    /// Coverage (0 to 1, row by row) of the union of `strokes` over `vertices` = `[x_px, y_px, radius_px]`,
    /// in a picture of `width` x `height` pixels. Valid until the next call.
    fn forward(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke]) -> &[f32];

    /// Adjoint of the last [`Raster::forward`]: from d(coverage) to d(vertices), one entry a vertex; overwrites.
    fn backward(&mut self, d_coverage: &[f32], d_vertices: &mut Vec<[f32; 3]>);
}
