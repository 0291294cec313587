//! Surfaces of revolution round the y axis.

use super::{EDGE, Triangles};
use glam::{DMat3, DVec2, DVec3};
use std::f64::consts::TAU;

/// Radii 0.7 and 0.3, tilted towards the front so that its hole shows.
pub(super) fn torus() -> Triangles {
    let count = (TAU * 0.3 / EDGE).round() as usize;
    let profile: Vec<DVec2> = (0..count)
        .map(|i| TAU * i as f64 / count as f64)
        .map(|angle| DVec2::new(0.7 + 0.3 * angle.cos(), 0.3 * angle.sin()))
        .collect();
    let mut surface = revolve(&profile, true);
    let tilt = DMat3::from_rotation_x(0.6);
    for point in &mut surface.points {
        *point = tilt * *point;
    }
    surface
}

/// A foot, a belly, a neck and a lip; then down the inside, a wall's thickness of about 0.13 away.
pub(super) fn vase() -> Triangles {
    const OUTLINE: [(f64, f64); 22] = [
        (0.0, -0.92),
        (0.12, -0.92),
        (0.30, -0.92),
        (0.40, -0.90),
        (0.38, -0.80),
        (0.36, -0.72),
        (0.56, -0.52),
        (0.72, -0.20),
        (0.62, 0.16),
        (0.38, 0.36),
        (0.30, 0.52),
        (0.36, 0.72),
        (0.54, 0.92),
        (0.46, 1.00),
        (0.32, 0.90),
        (0.20, 0.72),
        (0.15, 0.52),
        (0.24, 0.30),
        (0.48, 0.10),
        (0.52, -0.22),
        (0.36, -0.50),
        (0.0, -0.62),
    ];
    let corners: Vec<DVec2> = OUTLINE.iter().map(|&(r, y)| DVec2::new(r, y)).collect();
    revolve(&evenly(&smooth(&corners)), false)
}

/// Cuts corners off five times (Chaikin 1974): a quadratic B-spline but for its ends, which stay.
fn smooth(corners: &[DVec2]) -> Vec<DVec2> {
    let mut line = corners.to_vec();
    for _ in 0..5 {
        let mut cut = vec![line[0]];
        cut.extend(line.windows(2).flat_map(|w| [0.75 * w[0] + 0.25 * w[1], 0.25 * w[0] + 0.75 * w[1]]));
        cut.push(line[line.len() - 1]);
        line = cut;
    }
    line
}

/// Points about [`EDGE`] apart along the line, both ends kept.
fn evenly(line: &[DVec2]) -> Vec<DVec2> {
    let length: f64 = line.windows(2).map(|w| w[0].distance(w[1])).sum();
    let count = (length / EDGE).round().max(1.0);
    let mut points = vec![line[0]];
    let mut behind = 0.0;
    for w in line.windows(2) {
        let piece = w[0].distance(w[1]);
        while (points.len() as f64) < count && points.len() as f64 * length / count <= behind + piece {
            let share = (points.len() as f64 * length / count - behind) / piece;
            points.push(w[0].lerp(w[1], share));
        }
        behind += piece;
    }
    points.push(line[line.len() - 1]);
    points
}

/// Turns a profile of (radius, y), outside to its right, round the y axis: each point becomes a ring of as many corners
/// as fit it, a point on the axis one corner. A closed profile's last ring joins its first.
fn revolve(profile: &[DVec2], closed: bool) -> Triangles {
    let mut surface = Triangles::default();
    let rings: Vec<Vec<u32>> = profile
        .iter()
        .map(|&DVec2 { x: radius, y }| {
            let count = if radius > 0.0 { (TAU * radius / EDGE).round().max(6.0) as usize } else { 1 };
            (0..count)
                .map(|i| TAU * i as f64 / count as f64)
                .map(|angle| surface.push(DVec3::new(radius * angle.sin(), y, radius * angle.cos())))
                .collect()
        })
        .collect();
    for i in 1..rings.len() + usize::from(closed) {
        surface.join(&rings[i - 1], &rings[i % rings.len()]);
    }
    surface
}
