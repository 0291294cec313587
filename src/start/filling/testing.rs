//! Meshes that tests share.

use super::refined::RefinedMesh;
use super::strand::{Node, Strand};
use crate::mesh::Mesh;
use glam::DVec3;

/// A flat square in z = 0 from -1/2 to 1/2, `n` squares across.
pub fn sheet(n: usize) -> Mesh {
    let at = |i: usize| i as f64 / n as f64 - 0.5;
    let positions = (0..(n + 1) * (n + 1)).map(|i| [at(i % (n + 1)), at(i / (n + 1)), 0.0]).collect();
    let corner = |x: usize, y: usize| (y * (n + 1) + x) as u32;
    let square = |i: usize| {
        let (x, y) = (i % n, i / n);
        let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    Mesh::new("sheet", positions, (0..n * n).flat_map(square).collect()).unwrap()
}

/// A circle on a flat sheet.
pub fn circle(surface: &RefinedMesh, centre: [f64; 2], radius: f64) -> Strand {
    let point = |k: i32| {
        let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 200.0).sin_cos();
        DVec3::new(centre[0] + radius * cos, centre[1] + radius * sin, 0.0)
    };
    (0..200).map(|k| anywhere(surface, point(k))).collect()
}

/// The node nearest to a point, by asking every triangle.
pub fn anywhere(surface: &RefinedMesh, point: DVec3) -> Node {
    let triangles = 0..surface.triangles.len() as u32;
    let away = |&t: &u32| surface.distance_squared(point, t);
    Node::on(surface, point, triangles.min_by(|a, b| away(a).total_cmp(&away(b))).unwrap())
}
