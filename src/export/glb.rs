//! glTF 2.0 in one binary file (GLB): one mesh, one copper material, and what made it under `extras`.

use super::TriangleMesh;
use serde_json::{Value, json};

// Numbers of the glTF 2.0 specification.
const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;
const CHUNK_JSON: &[u8; 4] = b"JSON";
const CHUNK_BINARY: &[u8; 4] = b"BIN\0";
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The file's bytes; y is up and a world unit a metre, as glTF has it. `extras` describes the making.
pub fn glb(mesh: &TriangleMesh, extras: &Value) -> Vec<u8> {
    let positions: &[u8] = bytemuck::cast_slice(&mesh.positions);
    let normals: &[u8] = bytemuck::cast_slice(&mesh.normals);
    let indices: &[u8] = bytemuck::cast_slice(&mesh.triangles);
    let [low, high] = mesh.bounds();
    let vertices = mesh.positions.len();
    let scene = json!({
        "asset": { "version": "2.0", "generator": concat!("wire4d ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "name": "wire" }],
        "meshes": [{ "name": "wire", "primitives": [{
            "attributes": { "POSITION": 0, "NORMAL": 1 }, "indices": 2, "material": 0, "mode": 4 }] }],
        // Linear base colour of copper, a little rough, as drawn wire is.
        "materials": [{ "name": "copper", "pbrMetallicRoughness": {
            "baseColorFactor": [0.955, 0.447, 0.253, 1.0], "metallicFactor": 1.0, "roughnessFactor": 0.35 } }],
        "accessors": [
            { "bufferView": 0, "componentType": FLOAT, "count": vertices, "type": "VEC3", "min": low, "max": high },
            { "bufferView": 1, "componentType": FLOAT, "count": vertices, "type": "VEC3" },
            { "bufferView": 2, "componentType": UNSIGNED_INT, "count": indices.len() / 4, "type": "SCALAR" }],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": positions.len(), "target": ARRAY_BUFFER },
            { "buffer": 0, "byteOffset": positions.len(), "byteLength": normals.len(), "target": ARRAY_BUFFER },
            { "buffer": 0, "byteOffset": positions.len() + normals.len(), "byteLength": indices.len(),
              "target": ELEMENT_ARRAY_BUFFER }],
        "buffers": [{ "byteLength": positions.len() + normals.len() + indices.len() }],
        "extras": extras,
    });
    let mut text = scene.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let binary_length = positions.len() + normals.len() + indices.len();
    let total = 12 + 8 + text.len() + 8 + binary_length;

    let mut file = Vec::with_capacity(total);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&VERSION.to_le_bytes());
    file.extend_from_slice(&(total as u32).to_le_bytes());
    file.extend_from_slice(&(text.len() as u32).to_le_bytes());
    file.extend_from_slice(CHUNK_JSON);
    file.extend_from_slice(&text);
    file.extend_from_slice(&(binary_length as u32).to_le_bytes());
    file.extend_from_slice(CHUNK_BINARY);
    for part in [positions, normals, indices] {
        file.extend_from_slice(part);
    }
    file
}
