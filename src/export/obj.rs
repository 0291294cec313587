//! Wavefront OBJ with normals: text that every modeller reads.

use super::TriangleMesh;
use std::fmt::Write;

/// The file's text; y is up, in the mesh's own units.
pub fn obj(mesh: &TriangleMesh) -> String {
    let mut text = String::with_capacity(70 * mesh.positions.len() + 40 * mesh.triangles.len());
    text.push_str(concat!("# wire4d ", env!("CARGO_PKG_VERSION"), "\no wire\n"));
    // Writing to a String cannot fail.
    for [x, y, z] in &mesh.positions {
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [x, y, z] in &mesh.normals {
        let _ = writeln!(text, "vn {x:.4} {y:.4} {z:.4}");
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| i + 1);
        let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
    }
    text
}
