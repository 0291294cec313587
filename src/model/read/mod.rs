//! Meshes from files: by what the bytes say first, by the name second.

mod gltf;
mod obj;
mod ply;
mod polygon;
mod scene;
mod stl;

use super::Mended;
use super::mend::{Soup, mend};
use crate::{Error, Result};

/// Most triangles a mesh may have.
pub const MAX_TRIANGLES: usize = 500_000;

/// Most bytes a mesh file may have: 200 MB, half a million triangles in words.
pub const MAX_MESH_BYTES: usize = 200_000_000;

/// Reads and mends a mesh: OBJ, STL (binary or text), PLY (binary or text), glTF or GLB with all data inside.
/// `name` is the file's name as the person knows it. Polygons are cut into triangles; colours and the like are ignored.
///
/// # Errors
/// [`Error::Input`] for what is none of these or is damaged, for more than [`MAX_TRIANGLES`] or [`MAX_MESH_BYTES`], for
/// numbers that are not finite, and as mending does for meshes without an area.
pub fn read_mesh(name: &str, bytes: &[u8]) -> Result<Mended> {
    let fail = |problem: &str, remedy: &str| Err(Error::input(name, problem, remedy));
    const SAVE_AS: &str = "give a mesh as OBJ, STL, PLY, GLB or glTF";
    if bytes.is_empty() {
        return fail("is empty", SAVE_AS);
    }
    if bytes.len() > MAX_MESH_BYTES {
        return fail(&format!("has {} MB, more than 200", bytes.len() / 1_000_000), "save it with fewer triangles");
    }
    let foreign: [(&[u8], &str, &str); 7] = [
        (b"PK", "is a zip archive, not a mesh", "unpack it and give the mesh inside"),
        (b"\x1f\x8b", "is packed with gzip", "unpack it and give the mesh inside"),
        (b"\x89PNG", "is a PNG picture, not a mesh", SAVE_AS),
        (b"\xff\xd8\xff", "is a JPEG picture, not a mesh", SAVE_AS),
        (b"%PDF", "is a PDF document, not a mesh", SAVE_AS),
        (b"Kaydara FBX", "is an FBX file, which is not supported", "save it as OBJ, STL, PLY or GLB"),
        (b"BLENDER", "is a Blender project, not a mesh", "export it as OBJ, STL, PLY or GLB"),
    ];
    if let Some((_, problem, remedy)) = foreign.iter().find(|(magic, _, _)| bytes.starts_with(magic)) {
        return fail(problem, remedy);
    }
    let extension = name.rsplit_once('.').map_or(String::new(), |(_, end)| end.to_ascii_lowercase());
    let whole = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let text = whole.trim_ascii_start();
    let soup = if bytes.starts_with(b"glTF") {
        gltf::read_binary(name, bytes)?
    } else if stl::is_binary(bytes) {
        stl::read_binary(name, bytes)?
    } else if text.starts_with(b"{") {
        gltf::read_text(name, text)?
    } else if text.starts_with(b"<") {
        return fail("is a web page or XML, not a mesh", SAVE_AS);
    } else if text.starts_with(b"ply") {
        ply::read(name, text)?
    } else if stl::is_text(text) {
        stl::read_text(name, text)?
    } else if extension == "stl" {
        stl::read_binary(name, bytes)?
    } else if obj::is_obj(text) {
        // With the blank lines before it: its errors count lines.
        obj::read(name, whole)?
    } else {
        return fail("is not a mesh that can be read", SAVE_AS);
    };
    mend(name, soup)
}

/// Reads and mends the mesh in a file.
///
/// # Errors
/// As [`read_mesh`], and [`Error::Input`] if the file cannot be read.
#[cfg(feature = "cli")]
pub fn open_mesh(path: &std::path::Path) -> Result<Mended> {
    let name = path.display().to_string();
    match crate::files::read_at_most(path, MAX_MESH_BYTES) {
        Ok(Some(bytes)) => read_mesh(&name, &bytes),
        Ok(None) => Err(Error::input(name, "has more than 200 MB", "save it with fewer triangles")),
        Err(problem) => Err(Error::input(name, format!("cannot be read ({problem})"), "check the file's name")),
    }
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
