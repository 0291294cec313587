//! Bodies to compose objects of.

use glam::{DMat3, DQuat, DVec2, DVec3};
use std::f64::consts::TAU;
use wire4d_core::mesh::{Mesh, Shape};

/// Points a full turn is made of.
const AROUND: usize = 72;

fn mesh(points: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh::new("solid", points.iter().map(|p| p.to_array()).collect(), triangles).unwrap()
}

/// A grid of points, `across` a row, sewn into triangles; rows join their own ends.
fn sewn(points: Vec<DVec3>, across: usize, closed: bool) -> Mesh {
    let rows = points.len() / across;
    let mut triangles = Vec::new();
    for row in 0..rows - usize::from(!closed) {
        for i in 0..across {
            let at = |row: usize, i: usize| ((row % rows) * across + i % across) as u32;
            let [a, b, c, d] = [at(row, i), at(row, i + 1), at(row + 1, i + 1), at(row + 1, i)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh(points, triangles)
}

/// Turned round the y axis: (radius, y) from the bottom's middle along the outside; radius 0 closes it.
pub fn turned(profile: &[(f64, f64)]) -> Mesh {
    let ring = |&(radius, y): &(f64, f64)| {
        (0..AROUND).map(move |i| {
            let angle = TAU * i as f64 / AROUND as f64;
            DVec3::new(radius.max(1e-4) * angle.sin(), y, radius.max(1e-4) * angle.cos())
        })
    };
    sewn(profile.iter().flat_map(ring).collect(), AROUND, false)
}

/// An upright cylinder on y = 0.
pub fn cylinder(radius: f64, height: f64) -> Mesh {
    turned(&[(0.0, 0.0), (radius, 0.0), (radius, height), (0.0, height)])
}

/// From its least to its greatest corner.
pub fn block(low: [f64; 3], high: [f64; 3]) -> Mesh {
    let [low, high] = [DVec3::from(low), DVec3::from(high)];
    let points = (0..8u8)
        .map(|i| {
            let pick = |axis: usize| if i >> axis & 1 == 1 { high[axis] } else { low[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
        .collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    mesh(points, faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// A round tube along a smooth open line through some points, radius from the first to the last end.
pub fn tube(through: &[[f64; 3]], from: f64, to: f64) -> Mesh {
    const STEPS: usize = 10;
    let p = |i: i64| DVec3::from(through[i.clamp(0, through.len() as i64 - 1) as usize]);
    // Catmull and Rom 1974.
    let at = |t: f64| {
        let i = (t as i64).min(through.len() as i64 - 2);
        let u = t - i as f64;
        let [a, b, c, d] = [p(i - 1), p(i), p(i + 1), p(i + 2)];
        0.5 * (2.0 * b + u * (c - a) + u * u * (2.0 * a - 5.0 * b + 4.0 * c - d) + u * u * u * (3.0 * (b - c) + d - a))
    };
    let count = (through.len() - 1) * STEPS;
    let line: Vec<DVec3> = (0..=count).map(|i| at(i as f64 / STEPS as f64)).collect();
    let around = 28;
    let tangent = |i: usize| (line[(i + 1).min(count)] - line[i.saturating_sub(1)]).normalize_or(DVec3::Y);
    let mut side = tangent(0).any_orthonormal_vector();
    let mut points = Vec::new();
    for i in 0..=count {
        if i > 0 {
            side = DQuat::from_rotation_arc(tangent(i - 1), tangent(i)) * side;
        }
        let radius = from + (to - from) * i as f64 / count as f64;
        let mut ring = |radius: f64| {
            points.extend((0..around).map(|j| {
                line[i] + radius * (DQuat::from_axis_angle(tangent(i), TAU * j as f64 / around as f64) * side)
            }));
        };
        // Flat ends.
        if i == 0 {
            ring(1e-4);
        }
        ring(radius);
        if i == count {
            ring(1e-4);
        }
    }
    sewn(points, around, false)
}

/// A ball.
pub fn ball(middle: [f64; 3], radius: f64) -> Mesh {
    moved(&Shape::Sphere.mesh(), DMat3::from_diagonal(DVec3::splat(radius)), middle)
}

/// Turned and scaled by a matrix, then moved.
pub fn moved(mesh_in: &Mesh, by: DMat3, to: [f64; 3]) -> Mesh {
    let points = mesh_in.positions().iter().map(|&p| by * DVec3::from(p) + DVec3::from(to)).collect();
    mesh(points, mesh_in.triangles().to_vec())
}

/// A mesh set down on y = 0.
pub fn standing(mesh_in: &Mesh) -> Mesh {
    let low = mesh_in.positions().iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    moved(mesh_in, DMat3::IDENTITY, [0.0, -low, 0.0])
}

/// A smooth closed line through points of (radius, y), for profiles: corners cut twice (Chaikin 1974), ends kept.
pub fn rounded(profile: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut line: Vec<DVec2> = profile.iter().map(|&(r, y)| DVec2::new(r, y)).collect();
    for _ in 0..3 {
        let mut cut = vec![line[0]];
        cut.extend(line.windows(2).flat_map(|w| [w[0].lerp(w[1], 0.25), w[0].lerp(w[1], 0.75)]));
        cut.push(line[line.len() - 1]);
        line = cut;
    }
    line.iter().map(|p| (p.x, p.y)).collect()
}
