//! A round tube along a knot.

use super::{EDGE, Triangles};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// The tube's radius before scaling, where the knot is 1.8 across.
const RADIUS: f64 = 0.17;

/// A trefoil (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t) that is drawn out in depth so that its strands stay apart.
pub(super) fn knot() -> Triangles {
    let centre = |t: f64| {
        0.3 * DVec3::new(t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -1.1 * (3.0 * t).sin())
    };
    tube(&evenly(&centre), RADIUS)
}

/// Points about [`EDGE`] apart round a closed curve of period 2π.
fn evenly(curve: &dyn Fn(f64) -> DVec3) -> Vec<DVec3> {
    const FINE: usize = 20_000;
    let at = |i: usize| curve(TAU * i as f64 / FINE as f64);
    let length: f64 = (0..FINE).map(|i| at(i).distance(at(i + 1))).sum();
    let count = (length / EDGE).round() as usize;
    let mut points = Vec::with_capacity(count);
    let mut behind = 0.0;
    for i in 0..FINE {
        if points.len() < count && behind >= points.len() as f64 * length / count as f64 {
            points.push(at(i));
        }
        behind += at(i).distance(at(i + 1));
    }
    points
}

/// Rings round a closed line of points. Frames are carried along without turning, and what they are turned by after
/// once round is spread over all of them.
fn tube(line: &[DVec3], radius: f64) -> Triangles {
    let count = line.len();
    let tangent = |i: usize| (line[(i + 1) % count] - line[(i + count - 1) % count]).normalize_or(DVec3::X);
    let start = tangent(0).any_orthonormal_vector();
    let mut sides = vec![start];
    for i in 0..count {
        sides.push(DQuat::from_rotation_arc(tangent(i), tangent((i + 1) % count)) * sides[i]);
    }
    let last = sides[count];
    let turn = start.cross(last).dot(tangent(0)).atan2(start.dot(last));
    let around = (TAU * radius / EDGE).round() as usize;
    let mut surface = Triangles::default();
    let rings: Vec<Vec<u32>> = (0..count)
        .map(|i| {
            let straighten = -turn * i as f64 / count as f64;
            (0..around)
                .map(|j| {
                    let angle = straighten + TAU * j as f64 / around as f64;
                    let side = DQuat::from_axis_angle(tangent(i), angle) * sides[i];
                    surface.push(line[i] + radius * side)
                })
                .collect()
        })
        .collect();
    for i in 0..count {
        surface.join(&rings[i], &rings[(i + 1) % count]);
    }
    surface
}
