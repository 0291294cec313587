//! glTF 2.0 and its binary form GLB: the parts of a scene, as a viewer shows them before anything moves.
//!
//! Read here rather than by a crate: of the format's many things only shape is wanted, and every offset is checked.

use super::accessor::{Numbers, Shape, Store, unsupported};
use super::pose::{Instances, Pose};
use super::scene::{Head, Node, Primitive, Scene, World};
use super::soup::Kept;
use super::{Soup, check_count, damaged};
use crate::{Error, Result};
use base64::Engine as _;
use base64::alphabet;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use glam::DMat4;

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

/// Extensions that are read, and, by their beginnings, those that change how a shape looks but not the shape.
const UNDERSTOOD: [&str; 15] = [
    "KHR_mesh_quantization",
    "EXT_mesh_gpu_instancing",
    "KHR_node_visibility",
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_animation_",
    "KHR_xmp",
    "KHR_techniques_webgl",
    "EXT_texture_",
    "EXT_lights_",
    "EXT_mesh_features",
    "EXT_structural_metadata",
    "MSFT_texture_",
    // Where on Earth it is.
    "CESIUM_RTC",
];

/// Refuses by name what a file cannot be shown without. What it merely uses has something else in its place.
fn check_required(name: &str, required: &[String]) -> Result<()> {
    let foreign = |extension: &&String| !UNDERSTOOD.iter().any(|understood| extension.starts_with(understood));
    match required.iter().find(foreign).map(String::as_str) {
        None => Ok(()),
        Some("KHR_draco_mesh_compression") => Err(unsupported(name, "Draco compression")),
        Some("EXT_meshopt_compression" | "KHR_meshopt_compression") => Err(unsupported(name, "meshopt compression")),
        Some(extension) => {
            let extension: String = extension.chars().take(60).collect();
            let problem = format!("needs the glTF extension {extension}, which is not read here");
            Err(Error::input(name, problem, format!("export it without {extension}")))
        }
    }
}

fn read(name: &str, json: &[u8], blob: Option<&[u8]>) -> Result<Soup> {
    let scene: Scene = serde_json::from_slice(json).map_err(|problem| match serde_json::from_slice::<Head>(json) {
        // The first version keeps all things by name.
        Ok(Head { asset }) if asset.version.starts_with('1') => unsupported(name, "glTF version 1"),
        _ => damaged(name, format!("is no glTF ({problem})")),
    })?;
    check_required(name, &scene.extensions_required)?;
    if scene.skins.iter().flat_map(|skin| &skin.joints).any(|&joint| joint >= scene.nodes.len()) {
        return Err(damaged(name, "has a skin with joints that are not there"));
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
    let store = Store { name, scene: &scene, buffers: buffers.iter().map(|b| &b[..]).collect() };
    let world = scene.world();
    let meshes: Vec<Vec<Counted>> = scene.meshes.iter().map(|mesh| counted(&scene, &mesh.primitives)).collect();
    let mut soup = Soup::default();
    let mut kept = Kept::default();
    for Placed { mesh, node, instances } in placed(&store, &world, &meshes)? {
        let place = node.map_or(DMat4::IDENTITY, |node| world.matrices[node]);
        let node = node.map(|node| &scene.nodes[node]);
        for &(primitive, count) in &meshes[mesh] {
            let Some(pose) = Pose::new(&store, &world, node, primitive, &scene.meshes[mesh].weights)? else { continue };
            let indices = primitive.indices.map(|indices| store.names(indices, Shape::Scalar)).transpose()?;
            let mut add = |matrix| {
                let triangles = (0..count).map(|i| triangle(primitive.mode, i, indices.as_ref()));
                pose.add(triangles, matrix, &mut soup, &mut kept)
            };
            let whole = match &instances {
                None => add(place),
                Some(instances) => (0..instances.count).all(|i| add(place * instances.matrix(i))),
            };
            if !whole {
                return Err(damaged(name, "a triangle names a corner that is not there"));
            }
        }
    }
    Ok(soup)
}

/// A primitive with the number of its triangles, which is not 0.
type Counted<'a> = (&'a Primitive, usize);

/// What glTF calls the way corners are joined.
const TRIANGLES: u32 = 4;
const STRIP: u32 = 5;
const FAN: u32 = 6;

/// The primitives that have triangles.
fn counted<'a>(scene: &'a Scene, primitives: &'a [Primitive]) -> Vec<Counted<'a>> {
    let count = |primitive: &Primitive| {
        let accessor = primitive.indices.or(primitive.attributes.get("POSITION").copied());
        let count = accessor.and_then(|i| scene.accessors.get(i)).map_or(0, |accessor| accessor.count);
        match primitive.mode {
            TRIANGLES => count / 3,
            STRIP | FAN => count.saturating_sub(2),
            _ => 0,
        }
    };
    primitives.iter().map(|primitive| (primitive, count(primitive))).filter(|&(_, count)| count > 0).collect()
}

/// The corners of triangle `i` of a primitive.
fn triangle(mode: u32, i: usize, indices: Option<&Numbers>) -> [usize; 3] {
    let corners = match mode {
        TRIANGLES => [3 * i, 3 * i + 1, 3 * i + 2],
        STRIP => [i, i + 1 + i % 2, i + 2 - i % 2],
        _ => [0, i + 1, i + 2],
    };
    corners.map(|at| indices.map_or(at, |indices| indices.get(at, 0) as usize))
}

/// A mesh where it is shown: by a node, if there are nodes, once or more.
struct Placed<'a> {
    mesh: usize,
    node: Option<usize>,
    instances: Option<Instances<'a>>,
}

/// What the scene shows; no more than may be, which is found out before any of it is stored.
fn placed<'a>(store: &Store<'a>, world: &World, meshes: &[Vec<Counted>]) -> Result<Vec<Placed<'a>>> {
    let nodes = &store.scene.nodes;
    let mut shown: Vec<(usize, Option<usize>)> =
        world.shown.iter().filter_map(|&node| Some((nodes[node].mesh?, Some(node)))).collect();
    if nodes.is_empty() {
        // A library of meshes without a scene: all of them where they are.
        shown = (0..meshes.len()).map(|mesh| (mesh, None)).collect();
    }
    let mut placed = Vec::new();
    let mut count = 0usize;
    for (mesh, node) in shown {
        let triangles = meshes
            .get(mesh)
            .map_or(0, |primitives| primitives.iter().map(|&(_, count)| count).fold(0, usize::saturating_add));
        if triangles == 0 {
            continue;
        }
        // Joints move a mesh to one place, whatever the node says.
        let again = node.map(|node| &nodes[node]).filter(|node| node.skin.is_none()).and_then(Node::instances);
        let instances = again.map(|again| Instances::new(store, again)).transpose()?;
        let times = instances.as_ref().map_or(1, |instances| instances.count);
        count = count.saturating_add(triangles.saturating_mul(times));
        check_count(store.name, count)?;
        placed.push(Placed { mesh, node, instances });
    }
    Ok(placed)
}

/// Bytes of base64 in either alphabet; white space, padding and left-over bits do not matter.
fn base64(text: &str) -> Option<Vec<u8>> {
    const LENIENT: GeneralPurpose = GeneralPurpose::new(
        &alphabet::STANDARD,
        GeneralPurposeConfig::new()
            .with_decode_padding_mode(DecodePaddingMode::Indifferent)
            .with_decode_allow_trailing_bits(true),
    );
    let of_standard = |letter: u8| match letter {
        b'-' => b'+',
        b'_' => b'/',
        _ => letter,
    };
    let letters = text.bytes().filter(|letter| !letter.is_ascii_whitespace()).map(of_standard);
    LENIENT.decode(letters.collect::<Vec<u8>>()).ok()
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
