//! From a path to control points at an even distance.

use super::Path;

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
