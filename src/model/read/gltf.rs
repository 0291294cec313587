//! glTF 2.0 and its binary form GLB: the parts of a scene, read from buffers that lie in the file.
//!
//! Read here rather than by a crate: of the format's many things only shape is wanted, and every offset is checked.

use super::scene::{Accessor, Primitive, Scene};
use super::{Soup, check_count, damaged};
use crate::{Error, Result};
use glam::{DMat4, DVec3};

/// A GLB: a header, a chunk of JSON, and a chunk of bytes.
pub(super) fn read_binary(name: &str, bytes: &[u8]) -> Result<Soup> {
    let word = |at: usize| bytes.get(at..at + 4).map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]) as usize);
    let short = || damaged(name, "ends early");
    match word(4) {
        Some(2) => {}
        Some(version) => return Err(unsupported(name, &format!("glTF version {version}"))),
        None => return Err(short()),
    }
    let (mut json, mut blob) = (None, None);
    let mut at = 12;
    while let (Some(length), Some(kind)) = (word(at), word(at + 4)) {
        let chunk = bytes.get(at + 8..).and_then(|rest| rest.get(..length)).ok_or_else(short)?;
        match kind {
            0x4e4f_534a if json.is_none() => json = Some(chunk),
            0x004e_4942 if blob.is_none() => blob = Some(chunk),
            _ => {}
        }
        at += 8 + length.div_ceil(4) * 4;
    }
    read(name, json.ok_or_else(short)?, blob)
}

/// A glTF: JSON alone.
pub(super) fn read_text(name: &str, text: &[u8]) -> Result<Soup> {
    read(name, text, None)
}

fn unsupported(name: &str, what: &str) -> Error {
    Error::input(name, format!("{what} is not supported"), "save it as a GLB without compression, all data inside")
}

fn read(name: &str, json: &[u8], blob: Option<&[u8]>) -> Result<Soup> {
    let scene: Scene =
        serde_json::from_slice(json).map_err(|problem| damaged(name, format!("is no glTF ({problem})")))?;
    let required = scene.extensions_required.iter().map(String::as_str);
    // A primitive may also offer compressed data as an alternative; only what is required has nothing else.
    for extension in required {
        match extension {
            "KHR_draco_mesh_compression" => return Err(unsupported(name, "Draco compression")),
            "EXT_meshopt_compression" | "KHR_meshopt_compression" => {
                return Err(unsupported(name, "meshopt compression"));
            }
            _ => {}
        }
    }
    let mut buffers = Vec::new();
    for (i, buffer) in scene.buffers.iter().enumerate() {
        buffers.push(match &buffer.uri {
            Some(uri) => match uri.strip_prefix("data:").and_then(|rest| rest.split_once(";base64,")) {
                Some((_, data)) => {
                    base64(data).ok_or_else(|| damaged(name, format!("buffer {i} is no base64")))?.into()
                }
                None => {
                    let file: String = uri.chars().take(60).collect();
                    return Err(unsupported(name, &format!("data in another file ({file})")));
                }
            },
            None => std::borrow::Cow::Borrowed(if i == 0 { blob.unwrap_or_default() } else { &[] }),
        });
    }
    let reader = Reader { name, scene: &scene, buffers: buffers.iter().map(|b| &b[..]).collect() };
    let placed = scene.placed();
    let parts =
        || placed.iter().flat_map(|&(mesh, matrix)| scene.meshes[mesh].primitives.iter().map(move |p| (p, matrix)));
    // Before anything is stored: a mesh may be placed many times.
    let count = parts().map(|(primitive, _)| reader.triangles(primitive)).fold(0, usize::saturating_add);
    check_count(name, count)?;
    let mut soup = Soup::default();
    for (primitive, matrix) in parts() {
        reader.add(primitive, matrix, &mut soup)?;
    }
    Ok(soup)
}

struct Reader<'a> {
    name: &'a str,
    scene: &'a Scene,
    buffers: Vec<&'a [u8]>,
}

/// What glTF calls the way corners are joined.
const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

impl Reader<'_> {
    /// How many triangles a primitive says it has.
    fn triangles(&self, primitive: &Primitive) -> usize {
        let accessor = primitive.indices.or(primitive.attributes.position);
        let count = accessor.and_then(|i| self.scene.accessors.get(i)).map_or(0, |accessor| accessor.count);
        match primitive.mode {
            TRIANGLES => count / 3,
            STRIP | FAN => count.saturating_sub(2),
            _ => 0,
        }
    }

    fn add(&self, primitive: &Primitive, matrix: DMat4, soup: &mut Soup) -> Result<()> {
        let count = self.triangles(primitive);
        let Some(positions) = primitive.attributes.position else { return Ok(()) };
        if count == 0 {
            return Ok(());
        }
        let base = soup.positions.len();
        let numbers = self.numbers(positions, 3)?;
        soup.positions
            .extend(numbers.chunks_exact(3).map(|p| matrix.transform_point3(DVec3::new(p[0], p[1], p[2])).to_array()));
        let corners = soup.positions.len() - base;
        let indices = match primitive.indices {
            Some(indices) => self.numbers(indices, 1)?,
            None => (0..corners).map(|i| i as f64).collect(),
        };
        // A reflection turns triangles inside out.
        let mirrored = matrix.determinant() < 0.0;
        for i in 0..count {
            let (a, b, c) = match primitive.mode {
                TRIANGLES => (3 * i, 3 * i + 1, 3 * i + 2),
                STRIP => (i, i + 1 + i % 2, i + 2 - i % 2),
                _ => (0, i + 1, i + 2),
            };
            let triangle = [a, if mirrored { c } else { b }, if mirrored { b } else { c }].map(|at| indices[at]);
            if triangle.iter().any(|&index| index >= corners as f64) {
                return Err(damaged(self.name, "a triangle names a corner that is not there"));
            }
            soup.triangles.push(triangle.map(|index| (base + index as usize) as u32));
        }
        Ok(())
    }

    /// The numbers of an accessor, `width` of them an element.
    fn numbers(&self, accessor: usize, width: usize) -> Result<Vec<f64>> {
        let missing = || damaged(self.name, format!("accessor {accessor} is not there whole"));
        let accessor: &Accessor = self.scene.accessors.get(accessor).ok_or_else(missing)?;
        if accessor.sparse.is_some() {
            return Err(unsupported(self.name, "a sparse accessor"));
        }
        let bytes: usize = match accessor.component_type {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            5125 | 5126 => 4,
            _ => return Err(missing()),
        };
        if accessor.kind != if width == 1 { "SCALAR" } else { "VEC3" } {
            return Err(missing());
        }
        let view = accessor.buffer_view.and_then(|view| self.scene.buffer_views.get(view)).ok_or_else(missing)?;
        let buffer = self.buffers.get(view.buffer).ok_or_else(missing)?;
        let data = buffer
            .get(view.byte_offset..)
            .and_then(|rest| rest.get(..view.byte_length))
            .and_then(|view| view.get(accessor.byte_offset..))
            .ok_or_else(missing)?;
        let stride = view.byte_stride.unwrap_or(bytes * width);
        let end = stride.checked_mul(accessor.count.saturating_sub(1)).and_then(|last| last.checked_add(bytes * width));
        if stride == 0 || accessor.count > data.len() || end.is_none_or(|end| end > data.len()) {
            return Err(missing());
        }
        let mut numbers = Vec::with_capacity(width * accessor.count);
        for i in 0..accessor.count {
            for k in 0..width {
                numbers.push(component(accessor, &data[i * stride + k * bytes..][..bytes]));
            }
        }
        Ok(numbers)
    }
}

fn component(accessor: &Accessor, bytes: &[u8]) -> f64 {
    let (value, most) = match (accessor.component_type, bytes) {
        (5120, &[a]) => (f64::from(a as i8), 127.0),
        (5121, &[a]) => (f64::from(a), 255.0),
        (5122, &[a, b]) => (f64::from(i16::from_le_bytes([a, b])), 32_767.0),
        (5123, &[a, b]) => (f64::from(u16::from_le_bytes([a, b])), 65_535.0),
        (5125, &[a, b, c, d]) => return f64::from(u32::from_le_bytes([a, b, c, d])),
        (_, &[a, b, c, d]) => return f64::from(f32::from_le_bytes([a, b, c, d])),
        _ => return f64::NAN,
    };
    if accessor.normalized { (value / most).max(-1.0) } else { value }
}

/// RFC 4648; white space is skipped.
fn base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut held, mut bits) = (0u32, 0);
    for letter in text.trim_end_matches('=').bytes().filter(|letter| !letter.is_ascii_whitespace()) {
        let value = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'a'..=b'z' => letter - b'a' + 26,
            b'0'..=b'9' => letter - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        };
        held = held << 6 | u32::from(value);
        bits += 6;
        if bits >= 8 {
            bits -= 8;
            bytes.push((held >> bits) as u8);
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_of_the_standard() {
        for (text, bytes) in [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9v\nYmFy", "foobar")] {
            assert_eq!(base64(text).unwrap(), bytes.as_bytes());
        }
        assert_eq!(base64("Zm9*"), None);
    }
}
