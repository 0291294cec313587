//! Meshes by formula, so that there is something to cover without a file.

mod creature;
mod revolved;
mod sphere;
mod tube;

use super::Mesh;
use super::ball::fit_unit_ball;
use glam::DVec3;

/// Length that edges are made for, world units before scaling.
const EDGE: f64 = 0.04;

/// A mesh by formula: closed, every edge in two triangles, outward, in the unit ball, edges about 0.04.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Shape {
    /// The unit sphere.
    Sphere,
    /// A ring with a hole of four tenths, lying a little tilted.
    Torus,
    /// A trefoil knot of round tube.
    Knot,
    /// A vase with a thick wall, hollow and open at the top.
    Vase,
    /// A small animal on four legs, looking to +x.
    Creature,
}

impl Shape {
    /// All of them, in the order people are shown.
    pub const ALL: [Shape; 5] = [Shape::Sphere, Shape::Torus, Shape::Knot, Shape::Vase, Shape::Creature];

    /// A lower-case word.
    pub fn name(self) -> &'static str {
        match self {
            Shape::Sphere => "sphere",
            Shape::Torus => "torus",
            Shape::Knot => "knot",
            Shape::Vase => "vase",
            Shape::Creature => "creature",
        }
    }

    /// The shape with that [`Shape::name`].
    pub fn named(word: &str) -> Option<Shape> {
        Shape::ALL.into_iter().find(|shape| shape.name() == word)
    }

    /// Its triangles, 10,000 to 25,000 of them, always the same.
    pub fn mesh(self) -> Mesh {
        let Triangles { points, triangles } = match self {
            Shape::Sphere => sphere::sphere(),
            Shape::Torus => revolved::torus(),
            Shape::Knot => tube::knot(),
            Shape::Vase => revolved::vase(),
            Shape::Creature => creature::creature(),
        };
        let mut positions: Vec<[f64; 3]> = points.iter().map(|p| p.to_array()).collect();
        fit_unit_ball(&mut positions);
        Mesh { positions, triangles }
    }
}

/// A surface in the making.
#[derive(Debug, Default)]
struct Triangles {
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
}

impl Triangles {
    fn push(&mut self, point: DVec3) -> u32 {
        self.points.push(point);
        self.points.len() as u32 - 1
    }

    /// Joins two rings of points by a strip of triangles, a ring of one point by a fan. Both rings go round once, begin
    /// at the same angle and run counter-clockwise seen from where `to` is nearer, inside to the left.
    fn join(&mut self, from: &[u32], to: &[u32]) {
        let steps = |ring: &[u32]| if ring.len() == 1 { 0 } else { ring.len() };
        let (most_i, most_j) = (steps(from), steps(to));
        let (mut i, mut j) = (0, 0);
        while i < most_i || j < most_j {
            let (a, b) = (from[i % from.len()], to[j % to.len()]);
            // The next corner is on the ring that lags behind.
            if j == most_j || i < most_i && (i + 1) * most_j.max(1) <= (j + 1) * most_i {
                self.triangles.push([a, from[(i + 1) % from.len()], b]);
                i += 1;
            } else {
                self.triangles.push([a, to[(j + 1) % to.len()], b]);
                j += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn shapes_are_closed_manifold_outward_and_even() {
        for (shape, handles) in Shape::ALL.into_iter().zip([0, 1, 1, 0, 0]) {
            let mesh = shape.mesh();
            let name = shape.name();
            assert_eq!(Shape::named(name), Some(shape));
            assert_eq!(mesh, Mesh::new(name, mesh.positions().to_vec(), mesh.triangles().to_vec()).unwrap());
            let most = mesh.positions().iter().map(|p| DVec3::from(*p).length()).fold(0.0, f64::max);
            assert!(most <= 1.0 && most > 0.999, "{name}: {most}");
            // Every edge once in each direction: closed, manifold along edges, consistent.
            let mut edges: HashMap<(u32, u32), usize> = HashMap::new();
            for triangle in mesh.triangles() {
                for k in 0..3 {
                    *edges.entry((triangle[k], triangle[(k + 1) % 3])).or_default() += 1;
                }
            }
            assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.contains_key(&(b, a))), "{name}");
            let euler = mesh.positions().len() as i64 - edges.len() as i64 / 2 + mesh.triangles().len() as i64;
            assert_eq!(euler, 2 - 2 * handles, "{name}");
            let volume: f64 =
                (0..mesh.triangles().len()).map(|i| mesh.corners(i)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum();
            assert!(volume > 0.1, "{name}: {volume}");
            let mut lengths: Vec<f64> = edges
                .keys()
                .map(|&(a, b)| [a, b].map(|i| DVec3::from(mesh.positions()[i as usize])))
                .map(|[a, b]| a.distance(b))
                .collect();
            lengths.sort_unstable_by(f64::total_cmp);
            let at = |share: f64| lengths[(share * (lengths.len() - 1) as f64) as usize];
            assert!((0.028..0.05).contains(&at(0.5)), "{name}: {}", at(0.5));
            assert!(at(0.02) > 0.012 && at(1.0) < 0.085, "{name}: {} {}", at(0.02), at(1.0));
            let normals = mesh.vertex_normals();
            for (triangle, i) in mesh.triangles().iter().zip(0..) {
                let normal = DVec3::from(mesh.triangle_normal(i));
                assert!(triangle.iter().all(|&c| normal.dot(DVec3::from(normals[c as usize])) > 0.5), "{name} {i}");
            }
        }
        assert_eq!(Shape::named("teapot"), None);
    }
}
