//! The uniform cubic B-spline net that displacement fields live on.

use crate::wire::Real;

/// Uniform cubic B-spline weights and the first of the four control values they belong to.
#[derive(Debug, Clone, Copy)]
pub(super) struct Basis<R> {
    pub first: usize,
    pub weights: [R; 4],
}

/// The cell and the offset within it of `share` (0 to 1) of the way along a net of `grid` control values.
pub(super) fn cell(share: f64, grid: usize) -> (usize, f64) {
    let t = share * (grid - 3) as f64;
    let first = (t.max(0.0) as usize).min(grid - 4);
    (first, t - first as f64)
}

/// The basis at the middles of `count` pixels along a net of `grid` control values.
pub(super) fn bases<R: Real>(count: usize, grid: usize) -> Vec<Basis<R>> {
    (0..count)
        .map(|i| {
            let (first, u) = cell((i as f64 + 0.5) / count as f64, grid);
            let v = 1.0 - u;
            let weights = [
                v * v * v / 6.0,
                (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
                u * u * u / 6.0,
            ];
            Basis { first, weights: weights.map(R::from_f64) }
        })
        .collect()
}
