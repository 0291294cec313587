//! Coverage of tapered round strokes and its adjoint: polylines of discs in pixels to a picture, and back.
//!
//! Space: pixels, y down, pixel centres at +0.5; a vertex is `[x_px, y_px, radius_px]`, radius the half width. A
//! stroke is the union of the convex hulls of each two consecutive discs. Coverage is 1 inside, 0 outside.

mod band;
mod cells;
mod check;
mod exact;
mod extremes;
pub mod flatten;
mod hidden;
mod joints;
mod outline;
mod pieces;
mod rows;
mod sampled;
mod shapes;
mod walk;

pub use band::BandRaster;
pub use check::{SELF_CHECK_TOLERANCE, self_check};
pub use exact::{ExactRaster, Part};
pub use sampled::sampled_union;

use crate::wire::Stroke;

/// A differentiable stroke rasteriser: one object a view, with buffers that live across iterations.
pub trait Raster: Send {
    /// Coverage (0 to 1, row by row) of the union of `strokes` over `vertices` = `[x_px, y_px, radius_px]`,
    /// in a picture of `width` x `height` pixels. Valid until the next call.
    fn forward(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke]) -> &[f32];

    /// Adjoint of the last [`Raster::forward`]: from d(coverage) to d(vertices), one entry a vertex; overwrites.
    fn backward(&mut self, d_coverage: &[f32], d_vertices: &mut Vec<[f32; 3]>);
}

/// Vertices beyond this (in pixels) are not drawn: nothing sensible lies there, and f32 has no digits left.
pub const FARTHEST_PX: f32 = 1e6;

/// What shaders share with the stages here, by the same name.
#[cfg(feature = "gpu")]
pub fn constants() -> [(&'static str, f32); 15] {
    [
        ("FARTHEST_PX", FARTHEST_PX),
        ("LEAST_OUTCROP_PX", pieces::LEAST_OUTCROP_PX),
        ("SHORTEST_PX", pieces::SHORTEST_PX),
        ("SHARPEST_MITRE", joints::SHARPEST_MITRE),
        ("TRIM_SHARE", joints::TRIM_SHARE),
        ("ORDER_MARGIN_PX", shapes::ORDER_MARGIN_PX),
        ("BOX_MARGIN_PX", shapes::BOX_MARGIN_PX),
        ("ARC_TOLERANCE_PX", shapes::ARC_TOLERANCE_PX),
        ("SMALLEST_RADIUS_PX", shapes::SMALLEST_RADIUS_PX),
        ("CELL_PX", CELL_PX),
        ("PART_PX", cells::PART_PX),
        ("SHORTEST_HIDDEN", hidden::SHORTEST_HIDDEN),
        ("SHORTEST_VISIBLE", hidden::SHORTEST_VISIBLE),
        ("STRETCH_PX", outline::STRETCH_PX),
        ("SHORTEST_EDGE_PX", outline::SHORTEST_EDGE_PX),
    ]
}
#[cfg(feature = "gpu")]
pub use cells::CELL_PX;
#[cfg(feature = "gpu")]
pub use shapes::rings;

/// Whether a vertex is finite and within reach of any picture.
fn usable(vertex: [f32; 3]) -> bool {
    // NaN compares false.
    vertex.iter().all(|c| c.abs() <= FARTHEST_PX)
}

/// The vertex pairs of all strokes, in order; a single vertex pairs with itself. Ranges beyond `count` are cut.
fn piece_indices(strokes: &[Stroke], count: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
    strokes.iter().flat_map(move |stroke| {
        let end = stroke.start.saturating_add(stroke.count).min(count);
        let start = stroke.start.min(end);
        let pieces = match end - start {
            n if n <= 1 => n,
            n if stroke.closed => n,
            n => n - 1,
        };
        (start..start + pieces).map(move |a| (a, if a + 1 < end { a + 1 } else { start }))
    })
}
