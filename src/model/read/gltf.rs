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
    let mut json = json.ok_or_else(short)?;
    // Chunks are filled up to whole words: with spaces, says the format, and with zeros, do some programs.
    while let [rest @ .., b' ' | 0] = json {
        json = rest;
    }
    read(name, json, blob)
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
    let mut kept = Vec::new();
    for (primitive, matrix) in parts() {
        reader.add(primitive, matrix, &mut soup, &mut kept)?;
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

    /// Adds a primitive with those of its corners that triangles name: many may share one list of them. `kept` is for
    /// this alone: one more than the place in the soup of each corner in the list, as of its last use.
    fn add(&self, primitive: &Primitive, matrix: DMat4, soup: &mut Soup, kept: &mut Vec<u32>) -> Result<()> {
        let count = self.triangles(primitive);
        let Some(positions) = primitive.attributes.position else { return Ok(()) };
        if count == 0 {
            return Ok(());
        }
        let base = soup.positions.len();
        let positions = self.numbers(positions, 3)?;
        let indices = primitive.indices.map(|indices| self.numbers(indices, 1)).transpose()?;
        kept.resize(kept.len().max(positions.accessor.count), 0);
        // A reflection turns triangles inside out.
        let mirrored = matrix.determinant() < 0.0;
        for i in 0..count {
            let (a, b, c) = match primitive.mode {
                TRIANGLES => (3 * i, 3 * i + 1, 3 * i + 2),
                STRIP => (i, i + 1 + i % 2, i + 2 - i % 2),
                _ => (0, i + 1, i + 2),
            };
            let mut triangle = [0; 3];
            for (corner, at) in triangle.iter_mut().zip(if mirrored { [a, c, b] } else { [a, b, c] }) {
                let index = indices.as_ref().map_or(at, |indices| indices.get(at, 0) as usize);
                if index >= positions.accessor.count {
                    return Err(damaged(self.name, "a triangle names a corner that is not there"));
                }
                if kept[index] as usize <= base {
                    let [x, y, z] = [0, 1, 2].map(|axis| positions.get(index, axis));
                    soup.positions.push(matrix.transform_point3(DVec3::new(x, y, z)).to_array());
                    kept[index] = soup.positions.len() as u32;
                }
                *corner = kept[index] - 1;
            }
            soup.triangles.push(triangle);
        }
        Ok(())
    }

    /// The numbers of an accessor: three an element for places, one for the indices of corners.
    fn numbers(&self, at: usize, width: usize) -> Result<Numbers<'_>> {
        let missing = || damaged(self.name, format!("accessor {at} is not there whole"));
        let accessor: &Accessor = self.scene.accessors.get(at).ok_or_else(missing)?;
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
        if width == 1 && !matches!(accessor.component_type, 5121 | 5123 | 5125) {
            return Err(damaged(self.name, format!("accessor {at} names corners by other than whole numbers from 0")));
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
        if stride < bytes * width || accessor.count > data.len() || end.is_none_or(|end| end > data.len()) {
            return Err(missing());
        }
        Ok(Numbers { accessor, data, stride, bytes })
    }
}

/// An accessor whose elements all lie in its data, `stride` bytes apart; a number has so many `bytes`.
struct Numbers<'a> {
    accessor: &'a Accessor,
    data: &'a [u8],
    stride: usize,
    bytes: usize,
}

impl Numbers<'_> {
    fn get(&self, element: usize, axis: usize) -> f64 {
        component(self.accessor, &self.data[element * self.stride + axis * self.bytes..][..self.bytes])
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

    /// Corners on a line; one primitive a triangle; indices of the given kind.
    fn lined_up(corners: usize, kind: u32, triangles: &[[f32; 3]], end: &str) -> Result<Soup> {
        let mut blob: Vec<u8> = (0..corners).flat_map(|i| [i as f32, 0.0, 0.0]).flat_map(f32::to_le_bytes).collect();
        let start = blob.len();
        let (mut primitives, mut accessors) = (Vec::new(), Vec::new());
        for (i, triangle) in triangles.iter().enumerate() {
            let offset = blob.len() - start;
            for &index in triangle {
                match kind {
                    5122 | 5123 => blob.extend((index as i16).to_le_bytes()),
                    5126 => blob.extend(index.to_le_bytes()),
                    _ => blob.extend((index as u32).to_le_bytes()),
                }
            }
            primitives.push(format!(r#"{{"attributes":{{"POSITION":0}},"indices":{}}}"#, i + 1));
            accessors.push(format!(
                r#",{{"bufferView":1,"byteOffset":{offset},"componentType":{kind},"count":3,"type":"SCALAR"}}"#
            ));
        }
        let mut json = format!(
            r#"{{"meshes":[{{"primitives":[{}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":{corners},"type":"VEC3"}}{}],
            "bufferViews":[{{"buffer":0,"byteLength":{start}}},{{"buffer":0,"byteOffset":{start},"byteLength":{}}}],
            "buffers":[{{"byteLength":{}}}]}}{end}"#,
            primitives.join(","),
            accessors.concat(),
            blob.len() - start,
            blob.len()
        );
        while json.len() % 4 != 0 {
            json += &end[..1];
        }
        let mut glb = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
        for (kind, chunk) in [(b"JSON", json.as_bytes()), (b"BIN\0", &blob)] {
            glb.extend((chunk.len() as u32).to_le_bytes());
            glb.extend(kind);
            glb.extend(chunk);
        }
        read_binary("a.glb", &glb)
    }

    #[test]
    fn only_corners_that_triangles_name_are_kept() {
        let triangles: Vec<[f32; 3]> = (0..100).map(|i| [i as f32, 999.0 - i as f32, 7.0]).collect();
        let soup = lined_up(1000, 5125, &triangles, " ").unwrap();
        assert!(soup.positions.len() <= 300, "{}", soup.positions.len());
        let back: Vec<[f32; 3]> =
            soup.triangles.iter().map(|t| t.map(|corner| soup.positions[corner as usize][0] as f32)).collect();
        assert_eq!(back, triangles);
        let error = lined_up(1000, 5125, &[[0.0, 1.0, 1000.0]], " ").unwrap_err().to_string();
        assert!(error.contains("corner that is not there"), "{error}");
    }

    #[test]
    fn corners_are_named_by_whole_numbers() {
        assert_eq!(lined_up(9, 5123, &[[0.0, 1.0, 2.0]], " ").unwrap().triangles.len(), 1);
        for (kind, index) in [(5122, -3.0), (5122, 2.0), (5126, 2.7), (5126, f32::NAN)] {
            let error = lined_up(9, kind, &[[0.0, 1.0, index]], " ").unwrap_err().to_string();
            assert!(error.contains("whole numbers"), "{error}");
        }
    }

    #[test]
    fn text_may_be_filled_up_with_zeros() {
        for end in ["\0", "\0\0\0\0\0", "  \0 \0", "   "] {
            assert_eq!(lined_up(9, 5123, &[[0.0, 1.0, 2.0]], end).unwrap().triangles.len(), 1);
        }
    }
}
