//! What is printed.

use glam::DVec3;

/// A closed surface: triangles wound counter-clockwise seen from outside.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Millimetres; z is up.
    pub positions: Vec<[f32; 3]>,
    /// Indices into `positions`.
    pub triangles: Vec<[u32; 3]>,
}

/// A mesh with the name it is saved under.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Letters, digits and hyphens, without an ending.
    pub name: String,
    /// Its surface.
    pub mesh: Mesh,
}

impl Mesh {
    /// What the surface encloses, mm³: the tetrahedra from the origin to every triangle, summed with their signs.
    pub fn volume_mm3(&self) -> f64 {
        let corner = |i: u32| DVec3::from(self.positions[i as usize].map(f64::from));
        self.triangles.iter().map(|t| t.map(corner)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    /// Least and greatest coordinates; zeros for an empty mesh.
    pub fn bounds(&self) -> [[f32; 3]; 2] {
        let first = self.positions.first().copied().unwrap_or_default();
        self.positions.iter().fold([first; 2], |[low, high], p| {
            [std::array::from_fn(|c| low[c].min(p[c])), std::array::from_fn(|c| high[c].max(p[c]))]
        })
    }

    /// The same, with its lowest point at height 0.
    pub(crate) fn on_the_bed(mut self) -> Mesh {
        let [low, _] = self.bounds();
        self.positions.iter_mut().for_each(|p| p[2] -= low[2]);
        self
    }
}
