//! Meshes from files: by what the bytes say first, by the name second.

mod accessor;
mod decimals;
mod foreign;
mod gltf;
mod obj;
mod ply;
mod polygon;
mod pose;
mod scene;
mod soup;
mod stl;
mod three_mf;
mod up;
mod zip;

pub(super) use soup::Soup;
pub use up::Up;

use crate::{Error, Result};

/// Most triangles a mesh may have.
pub const MAX_TRIANGLES: usize = 500_000;

/// Most bytes a mesh file may have: 200 MB, half a million triangles in words.
pub const MAX_MESH_BYTES: usize = 200_000_000;

/// The triangles of a file, upright, and the axis that pointed up in it.
///
/// # Errors
/// As [`read_mesh`](crate::read_mesh), but for what mending refuses.
pub(super) fn read(name: &str, bytes: &[u8], up: Option<Up>) -> Result<(Soup, Up)> {
    if bytes.is_empty() {
        return Err(Error::input(name, "is empty", foreign::SAVE_AS));
    }
    if bytes.len() > MAX_MESH_BYTES {
        let problem = format!("has {} MB, more than 200", bytes.len() / 1_000_000);
        return Err(Error::input(name, problem, "save it with fewer triangles"));
    }
    let extension = name.rsplit_once('.').map_or(String::new(), |(_, end)| end.to_ascii_lowercase());
    let whole = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = whole.trim_ascii_start();
    let (mut soup, usual) = if bytes.starts_with(b"glTF") {
        (gltf::read_binary(name, bytes)?, Up::Y)
    } else if bytes.starts_with(b"PK") {
        (three_mf::read(name, bytes)?, Up::Z)
    } else if let Some((what, remedy)) = foreign::by_beginning(text) {
        return Err(Error::input(name, what, remedy));
    } else if stl::is_binary(bytes) {
        (stl::read_binary(name, bytes)?, Up::Z)
    } else if text.starts_with(b"{") {
        (gltf::read_text(name, text)?, Up::Y)
    } else if three_mf::is_model(text) {
        (three_mf::read_model(name, text)?, Up::Z)
    } else if let Some((what, remedy)) = foreign::by_markup(text) {
        return Err(Error::input(name, what, remedy));
    } else if ply::is_ply(text) {
        (ply::read(name, text)?, Up::Y)
    } else if stl::is_text(text) {
        (stl::read_text(name, text)?, Up::Z)
    } else if extension == "stl" {
        (stl::read_binary(name, bytes)?, Up::Z)
    } else if obj::is_obj(text) {
        // With the blank lines before it: its errors count lines.
        (obj::read(name, whole)?, Up::Y)
    } else {
        let (what, remedy) = foreign::by_ending(&extension);
        return Err(Error::input(name, what, remedy));
    };
    let up = up.unwrap_or(usual);
    up.stand(&mut soup.positions);
    Ok((soup, up))
}

/// Refuses a count of triangles before they are stored.
fn check_count(name: &str, count: usize) -> Result<()> {
    if count > MAX_TRIANGLES {
        let problem = format!("has {count} triangles, more than {MAX_TRIANGLES}");
        return Err(Error::input(name, problem, "reduce it in a modelling program (decimate, simplify)"));
    }
    Ok(())
}

/// A file that ends early or says what cannot be.
fn damaged(name: &str, problem: impl Into<String>) -> Error {
    Error::input(name, problem, "the file is damaged: save or download it again")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read_mesh;

    #[test]
    fn what_is_up_depends_on_the_kind_and_can_be_said() {
        let tall = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                   element face 4\nproperty list uchar int vertex_index\nend_header\n\
                   0 0 0\n1 0 0\n0 2 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
        let facet = |a: &str, b: &str, c: &str| {
            format!("facet\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n")
        };
        let (o, x, y, z) = ("0 0 0", "1 0 0", "0 2 0", "0 0 9");
        let stl = format!("solid\n{}{}{}{}endsolid\n", facet(o, y, x), facet(o, x, z), facet(x, y, z), facet(y, o, z));
        let longest = |bytes: &str, up: Option<Up>| {
            let read = read_mesh("a", bytes.as_bytes(), up).unwrap();
            let size = |c: usize| {
                let all = || read.mesh.positions().iter().map(|p| p[c]);
                all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
            };
            let front = read.mesh.positions().iter().map(|p| p[2]).fold(f64::MIN, f64::max);
            (read.up, if size(1) > size(2) { "stands" } else { "lies" }, size(0) < size(1).min(size(2)), front > 0.0)
        };
        for (bytes, usual) in [(tall, Up::Y), (ply, Up::Y), (&stl[..], Up::Z)] {
            for up in [None, Some(Up::Y), Some(Up::Z)] {
                let taken = up.unwrap_or(usual);
                let stands = if taken == Up::Z { "stands" } else { "lies" };
                assert_eq!(longest(bytes, up), (taken, stands, true, true), "{up:?}: {bytes}");
            }
        }
    }
}
