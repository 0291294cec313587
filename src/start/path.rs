//! From a path to a wire: control points at an even distance along it.

use super::Path;
use crate::error::{Error, Result};
use crate::wire::Wire;

/// `count` points at even arc-length steps along the path, width interpolated; both ends are kept on an open path.
pub fn resampled(path: &Path, count: usize) -> Vec<[f64; 4]> {
    let mut points = path.points.clone();
    if path.closed && !points.is_empty() {
        points.push(points[0]);
    }
    let mut along = Vec::with_capacity(points.len());
    let mut length = 0.0;
    for (i, point) in points.iter().enumerate() {
        if i > 0 {
            length += distance(point, &points[i - 1]);
        }
        along.push(length);
    }
    let steps = if path.closed { count } else { count.saturating_sub(1) };
    let mut piece = 0;
    (0..count)
        .map(|i| {
            let at = length * i as f64 / steps.max(1) as f64;
            while piece + 2 < points.len() && along[piece + 1] < at {
                piece += 1;
            }
            let next = (piece + 1).min(points.len() - 1);
            let span = along[next] - along[piece];
            let t = if span > 0.0 { ((at - along[piece]) / span).clamp(0.0, 1.0) } else { 0.0 };
            std::array::from_fn(|c| points[piece][c] + t * (points[next][c] - points[piece][c]))
        })
        .collect()
}

/// Length of the path, world units.
pub fn length(path: &Path) -> f64 {
    let open: f64 = path.points.windows(2).map(|w| distance(&w[0], &w[1])).sum();
    match (&path.points[..], path.closed) {
        ([first, .., last], true) => open + distance(first, last),
        _ => open,
    }
}

fn distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt()
}

/// A wire along the path with control points about every `spacing_world` (at least four, at most 20 000).
///
/// # Errors
/// If the path holds no two points or values that are not finite.
pub fn wire_along(path: &Path, spacing_world: f64) -> Result<Wire> {
    let count = (length(path) / spacing_world).round();
    let count = if count.is_finite() { count.clamp(4.0, 20_000.0) as usize } else { 4 };
    wire_with(path, count)
}

/// A wire along the path with `count` control points.
///
/// # Errors
/// As [`wire_along`], and if `count` is out of a wire's range.
pub fn wire_with(path: &Path, count: usize) -> Result<Wire> {
    if path.points.len() < 2 || path.points.iter().flatten().any(|x| !x.is_finite()) {
        return Err(Error::wire("wire", "there is no path to lay it along", "use drawings with longer lines"));
    }
    let control_points = resampled(path, count);
    if path.closed { Wire::closed_uniform(control_points) } else { Wire::open_uniform(control_points) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn half_circle(closed: bool) -> Path {
        let turn = if closed { 2.0 } else { 1.0 } * std::f64::consts::PI;
        let points = (0..200).map(|i| turn * f64::from(i) / 200.0).map(|a| [a.cos(), a.sin(), 0.3, 0.01]).collect();
        Path { points, closed }
    }

    #[test]
    fn control_points_are_evenly_spaced_and_the_wire_follows() {
        for closed in [false, true] {
            let path = half_circle(closed);
            let wire = wire_along(&path, 0.05).unwrap();
            let points = wire.control_points();
            let mean = length(&path) / (points.len() - usize::from(!closed)) as f64;
            assert!((mean - 0.05).abs() < 0.003);
            for pair in points.windows(2) {
                assert!((distance(&pair[0], &pair[1]) - mean).abs() < 0.01 * mean);
            }
            assert!((wire.length(1e-3) - length(&path)).abs() < 0.01 * length(&path));
        }
    }

    #[test]
    fn no_path_no_wire() {
        assert!(wire_along(&Path::default(), 0.1).is_err());
        let mut path = half_circle(false);
        path.points[7][1] = f64::NAN;
        assert!(wire_along(&path, 0.1).is_err());
    }
}
