//! Binary STL: a header of 80 bytes, a count, 50 bytes a triangle, all little-endian.

use crate::mesh::Mesh;
use glam::Vec3;

/// The file's bytes.
pub fn stl(mesh: &Mesh) -> Vec<u8> {
    let mut file = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    file.extend(format!("{:80}", "wire4d, millimetres").bytes());
    file.extend((mesh.triangles.len() as u32).to_le_bytes());
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| Vec3::from(mesh.positions[i as usize]));
        let normal = (b - a).cross(c - a).normalize_or_zero();
        file.extend([normal, a, b, c].iter().flat_map(|v| v.to_array()).flat_map(f32::to_le_bytes));
        file.extend([0; 2]);
    }
    file
}
