//! A sphere of nearly equal triangles.

use super::Triangles;
use glam::DVec3;
use std::collections::HashMap;

/// The unit sphere: an icosahedron whose triangles are cut into four five times, 20,480 in all.
pub(super) fn sphere() -> Triangles {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    // Three golden rectangles, one in each coordinate plane.
    let mut points = Vec::new();
    for axis in 0..3 {
        for (short, long) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
            let mut corner = [0.0; 3];
            corner[(axis + 1) % 3] = short;
            corner[(axis + 2) % 3] = long;
            points.push(DVec3::from(corner));
        }
    }
    let mut triangles = faces(&points);
    for point in &mut points {
        *point = point.normalize();
    }
    for _ in 0..5 {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                points.push((points[a as usize] + points[b as usize]).normalize());
                points.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    Triangles { points, triangles }
}

/// The triples of corners that are all 2 apart, outward.
fn faces(points: &[DVec3]) -> Vec<[u32; 3]> {
    let near = |a: usize, b: usize| points[a].distance(points[b]) < 2.1;
    let mut faces = Vec::new();
    for a in 0..points.len() {
        for b in a + 1..points.len() {
            for c in b + 1..points.len() {
                if near(a, b) && near(b, c) && near(c, a) {
                    let outward = points[a].dot(points[b].cross(points[c])) > 0.0;
                    let (b, c) = if outward { (b, c) } else { (c, b) };
                    faces.push([a as u32, b as u32, c as u32]);
                }
            }
        }
    }
    faces
}
