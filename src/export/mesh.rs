//! A plain triangle mesh.

use glam::DVec3;

/// Vertices with normals, and triangles wound counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TriangleMesh {
    /// World units.
    pub positions: Vec<[f32; 3]>,
    /// Unit length, outward; one a position.
    pub normals: Vec<[f32; 3]>,
    /// Indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}

impl TriangleMesh {
    /// Appends a vertex and returns its index.
    pub fn add(&mut self, position: DVec3, normal: DVec3) -> u32 {
        self.positions.push(position.as_vec3().to_array());
        self.normals.push(normal.as_vec3().to_array());
        self.positions.len() as u32 - 1
    }

    /// Least and greatest coordinates; zeros for an empty mesh.
    pub fn bounds(&self) -> [[f32; 3]; 2] {
        let mut positions = self.positions.iter();
        let first = positions.next().copied().unwrap_or_default();
        positions.fold([first; 2], |[low, high], p| {
            [std::array::from_fn(|c| low[c].min(p[c])), std::array::from_fn(|c| high[c].max(p[c]))]
        })
    }

    /// The same mesh, `factor` times as large.
    pub fn scaled(mut self, factor: f64) -> TriangleMesh {
        for p in &mut self.positions {
            *p = p.map(|c| (f64::from(c) * factor) as f32);
        }
        self
    }
}
