//! Solids cut out of and joined to each other, by the library Manifold: exact, and two-manifold whatever meets.

use crate::mesh::Mesh;
use glam::{DVec2, DVec3};
use manifold_rust::linalg::{Vec2, Vec3};
use manifold_rust::manifold::Manifold;
use manifold_rust::types::{MeshGL, OpType};

/// Edges shorter than this are closed up before a mesh leaves, so that none is lost in a file's single precision; mm.
const LEAST_EDGE_MM: f64 = 2e-3;

/// A solid.
#[derive(Clone)]
pub struct Body(Manifold);

impl Body {
    /// What a closed surface encloses.
    pub fn of(mesh: &Mesh) -> Body {
        let given = MeshGL {
            num_prop: 3,
            vert_properties: mesh.positions.as_flattened().to_vec(),
            tri_verts: mesh.triangles.as_flattened().to_vec(),
            ..MeshGL::default()
        };
        Body(Manifold::from_mesh_gl(&given))
    }

    /// An outline (counter-clockwise) from one height to another.
    pub fn prism(outline: &[DVec2], [low, high]: [f64; 2]) -> Body {
        let outline = outline.iter().map(|p| Vec2::new(p.x, p.y)).collect();
        let upright = Manifold::extrude(&vec![outline], high - low, 0, 0.0, Vec2::new(1.0, 1.0));
        Body(upright.translate(Vec3::new(0.0, 0.0, low)))
    }

    /// What some points span.
    pub fn hull(points: &[DVec3]) -> Body {
        let points: Vec<Vec3> = points.iter().map(|p| Vec3::new(p.x, p.y, p.z)).collect();
        Body(Manifold::hull(&points))
    }

    /// All of them as one. Neighbours in the list are joined first, so near ones should be near in it.
    pub fn union(mut bodies: Vec<Body>) -> Body {
        while bodies.len() > 1 {
            let pairs = bodies.chunks(2);
            bodies = pairs
                .map(|pair| match pair {
                    [a, b] => Body(a.0.boolean(&b.0, OpType::Add)),
                    _ => pair[0].clone(),
                })
                .collect();
        }
        bodies.pop().unwrap_or_else(|| Body(Manifold::empty()))
    }

    /// What is left without another.
    pub fn without(&self, other: &Body) -> Body {
        Body(self.0.boolean(&other.0, OpType::Subtract))
    }

    /// Its surface.
    pub fn mesh(&self) -> Mesh {
        let made = self.0.simplify(LEAST_EDGE_MM).get_mesh_gl(-1);
        let stride = made.num_prop as usize;
        Mesh {
            positions: made.vert_properties.chunks(stride).map(|p| [p[0], p[1], p[2]]).collect(),
            triangles: made.tri_verts.chunks(3).map(|t| [t[0], t[1], t[2]]).collect(),
        }
    }
}

/// A circle's corners round a polygon of `count` sides that holds it all.
pub fn round(middle: DVec2, radius: f64, count: usize) -> Vec<DVec2> {
    let turn = std::f64::consts::TAU / count as f64;
    let radius = radius / (0.5 * turn).cos();
    (0..count).map(|i| middle + radius * DVec2::from_angle(turn * i as f64)).collect()
}

/// A rectangle with round corners.
pub fn rounded([low, high]: [DVec2; 2], radius: f64) -> Vec<DVec2> {
    let radius = radius.min(0.49 * (high - low).min_element());
    let corners = [high, DVec2::new(low.x, high.y), low, DVec2::new(high.x, low.y)];
    let middle = 0.5 * (low + high);
    let each = corners.iter().enumerate().flat_map(|(quarter, &corner)| {
        let centre = corner - radius * (corner - middle).signum();
        (0..=6).map(move |i| {
            centre + radius * DVec2::from_angle((quarter as f64 + i as f64 / 6.0) * 0.5 * std::f64::consts::PI)
        })
    });
    each.collect()
}
