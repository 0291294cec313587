//! Binary STL: little-endian, an 80-byte header, a count, 50 bytes a triangle. The mesh must be in millimetres. It stands
//! on a printer's bed as the picture does: what is up in the world, y, is z in the file, as programs for printing have it.

use super::TriangleMesh;
use glam::DVec3;

/// The file's bytes; z is up.
pub fn stl(mesh_mm: &TriangleMesh) -> Vec<u8> {
    let mut file = Vec::with_capacity(84 + 50 * mesh_mm.triangles.len());
    // A header must not begin with "solid", which would announce a text file.
    let mut header = concat!("wire4d ", env!("CARGO_PKG_VERSION"), ", millimetres").as_bytes().to_vec();
    header.resize(80, b' ');
    file.extend_from_slice(&header);
    file.extend_from_slice(&(mesh_mm.triangles.len() as u32).to_le_bytes());
    for triangle in &mesh_mm.triangles {
        let corners = triangle.map(|i| mesh_mm.positions[i as usize]).map(|[x, y, z]| [x, -z, y]);
        let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
        let normal = (b - a).cross(c - a).normalize_or_zero().as_vec3().to_array();
        for vector in [normal, corners[0], corners[1], corners[2]] {
            file.extend_from_slice(bytemuck::cast_slice(&vector));
        }
        file.extend_from_slice(&[0, 0]);
    }
    file
}
