//! A glTF is read as a viewer shows it before anything moves.

use crate::mesh_common;

use mesh_common::{base64, glb};
use serde_json::{Value, json};
use std::f64::consts::FRAC_1_SQRT_2;
use wire4d::model::{Mended, read_mesh};

/// A glTF with a box of 1 x 2 x 3 as its mesh, to which more is added.
struct Made {
    json: Value,
    data: Vec<u8>,
}

impl Made {
    fn new() -> Made {
        let mut made = Made {
            json: json!({ "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
                "accessors": [], "bufferViews": [] }),
            data: Vec::new(),
        };
        let corners: Vec<f32> =
            (0..8).flat_map(|i| [i & 1, (i >> 1 & 1) * 2, (i >> 2) * 3]).map(|c| c as f32 - 0.5).collect();
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let indices = faces.iter().flat_map(|f| [f[0], f[1], f[2], f[0], f[2], f[3]]).collect::<Vec<u8>>();
        let positions = made.floats("VEC3", &corners);
        let indices = made.accessor(5121, "SCALAR", 36, &indices);
        made.json["meshes"] =
            json!([{ "primitives": [{ "attributes": { "POSITION": positions }, "indices": indices }] }]);
        made
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        self.data.resize(self.data.len().next_multiple_of(4), 0);
        let (views, start) = (self.json["bufferViews"].as_array_mut().unwrap(), self.data.len());
        views.push(json!({ "buffer": 0, "byteOffset": start, "byteLength": bytes.len() }));
        self.data.extend(bytes);
        views.len() - 1
    }

    fn accessor(&mut self, component: u32, kind: &str, count: usize, bytes: &[u8]) -> usize {
        let view = self.view(bytes);
        self.add(json!({ "bufferView": view, "componentType": component, "count": count, "type": kind }))
    }

    fn add(&mut self, accessor: Value) -> usize {
        let accessors = self.json["accessors"].as_array_mut().unwrap();
        accessors.push(accessor);
        accessors.len() - 1
    }

    fn floats(&mut self, kind: &str, numbers: &[f32]) -> usize {
        let width = match kind {
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 16,
        };
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        self.accessor(5126, kind, numbers.len() / width, &bytes)
    }

    fn bytes(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"] = json!([{ "byteLength": self.data.len() }]);
        glb(&json.to_string(), &self.data)
    }

    fn primitive(&mut self) -> &mut Value {
        &mut self.json["meshes"][0]["primitives"][0]
    }

    /// Parts and shape: width, height and depth, the longest 1.
    fn shape(&self) -> (usize, [f64; 3]) {
        shape(&read_mesh("a.glb", &self.bytes(), None).unwrap())
    }

    fn refused(&self) -> String {
        read_mesh("a.glb", &self.bytes(), None).expect_err("it is wrong").to_string()
    }
}

fn shape(read: &Mended) -> (usize, [f64; 3]) {
    assert_eq!(read.open_edges, 0, "{:?}", read.notes);
    assert!(!read.notes.iter().any(|note| note.contains("outward")), "{:?}", read.notes);
    let size = [0, 1, 2].map(|c| {
        let all = || read.mesh.positions().iter().map(|p| p[c]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    });
    let longest = size.into_iter().fold(0.0, f64::max);
    (read.parts, size.map(|side| (100.0 * side / longest).round() / 100.0))
}

const PLAIN: (usize, [f64; 3]) = (1, [0.33, 0.67, 1.0]);
/// Turns z to y and y to -z.
const UPRIGHT: [f64; 4] = [-FRAC_1_SQRT_2, 0.0, 0.0, FRAC_1_SQRT_2];

#[test]
fn joints_hold_what_they_are_bound_to() {
    let mut made = Made::new();
    assert_eq!(made.shape(), PLAIN);
    // The node's own place does not count, that of the joint does, and the joint is in no scene.
    made.json["nodes"] =
        json!([{ "mesh": 0, "skin": 0, "scale": [50, 1, 1] }, { "rotation": UPRIGHT, "children": [2] }, {}]);
    let joints = made.accessor(5121, "VEC4", 8, &[0; 32]);
    let weights = made.accessor(5121, "VEC4", 8, &[255, 0, 0, 0].repeat(8));
    made.json["accessors"][weights]["normalized"] = json!(true);
    made.primitive()["attributes"]["JOINTS_0"] = json!(joints);
    made.primitive()["attributes"]["WEIGHTS_0"] = json!(weights);
    made.json["skins"] = json!([{ "joints": [2] }]);
    assert_eq!(made.shape(), (1, [0.33, 1.0, 0.67]));
    // Bound while it was three times as wide, and mirrored.
    let mut bind = [0.0; 16];
    (bind[0], bind[5], bind[10], bind[15]) = (-9.0, 1.0, 1.0, 1.0);
    let bind = made.floats("MAT4", &bind);
    made.json["skins"][0]["inverseBindMatrices"] = json!(bind);
    assert_eq!(made.shape(), (1, [1.0, 0.33, 0.22]));
    // Between two joints, by weights that are rounded: the corners of the far side go 3 of 4 times 4 along z.
    made.json["skins"] = json!([{ "joints": [1, 2] }]);
    made.json["nodes"] = json!([{ "mesh": 0, "skin": 0 }, {}, { "translation": [0, 0, 4] }]);
    let mix: Vec<u8> = (0..8).flat_map(|i| if i < 4 { [240, 0, 0, 0] } else { [60, 180, 0, 0] }).collect();
    let at = made.json["accessors"][weights]["bufferView"].as_u64().unwrap() as usize;
    let start = made.json["bufferViews"][at]["byteOffset"].as_u64().unwrap() as usize;
    made.data[start..start + 32].copy_from_slice(&mix);
    let names = made.accessor(5123, "VEC4", 8, &[0, 0, 1, 0, 0, 0, 0, 0].repeat(8));
    made.primitive()["attributes"]["JOINTS_0"] = json!(names);
    assert_eq!(made.shape(), (1, [0.17, 0.33, 1.0]));
    made.json["skins"] = json!([{ "joints": [1, 77] }]);
    assert!(made.refused().contains("joints that are not there"));
    made.json["skins"] = json!([{ "joints": [1, 2], "inverseBindMatrices": bind }]);
    assert!(made.refused().contains("fewer matrices than joints"));
}

#[test]
fn morph_targets_push() {
    let mut made = Made::new();
    // Twice as high; and, sparse and without data of its own, the corners of one side out along x.
    let high: Vec<f32> = (0..8).flat_map(|i| [0.0, if i >> 1 & 1 == 1 { 2.0 } else { 0.0 }, 0.0]).collect();
    let high = made.floats("VEC3", &high);
    let (places, pushes) = ([1u8, 3, 5, 7], [[5.0f32, 0.0, 0.0]; 4].concat());
    let places = made.view(&places);
    let pushes: Vec<u8> = pushes.iter().flat_map(|c| c.to_le_bytes()).collect();
    let pushes = made.view(&pushes);
    let wide = made.add(json!({ "componentType": 5126, "count": 8, "type": "VEC3", "sparse": { "count": 4,
        "indices": { "bufferView": places, "componentType": 5121 }, "values": { "bufferView": pushes } } }));
    made.primitive()["targets"] = json!([{ "POSITION": high }, { "NORMAL": 0 }, { "POSITION": wide }]);
    assert_eq!(made.shape(), PLAIN, "without weights nothing is pushed");
    made.json["meshes"][0]["weights"] = json!([1, 1, 0]);
    assert_eq!(made.shape(), (1, [0.25, 1.0, 0.75]));
    made.json["nodes"][0]["weights"] = json!([0.5, 0, 1]);
    assert_eq!(made.shape(), (1, [1.0, 0.5, 0.5]), "the node's weights come before the mesh's");
}

#[test]
fn instances_are_put_where_they_say() {
    let mut made = Made::new();
    let translation = made.floats("VEC3", &[0.0, 0.0, 0.0, 0.0, 0.0, 9.0]);
    // A quarter turn about z and none, as shares of 32,767; and one mirrored.
    let turns: Vec<u8> = [0i16, 0, 23170, 23170, 0, 0, 0, 32767].iter().flat_map(|c| c.to_le_bytes()).collect();
    let rotation = made.accessor(5122, "VEC4", 2, &turns);
    made.json["accessors"][rotation]["normalized"] = json!(true);
    let scale = made.floats("VEC3", &[1.0, 1.0, 1.0, -3.0, 1.0, 1.0]);
    made.json["nodes"][0] = json!({ "mesh": 0, "scale": [1, 1, 2], "extensions": { "EXT_mesh_gpu_instancing": { "attributes":
        { "TRANSLATION": translation, "ROTATION": rotation, "SCALE": scale, "_ID": 0 } } } });
    made.json["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    // x from -1.5 (turned: -y) or 1.5 (mirrored) to .5 or 1.5: 3; y from -.5 to 1.5; z 24.
    assert_eq!(made.shape(), (2, [0.13, 0.08, 1.0]));
}

#[test]
fn what_is_hidden_is_not_there() {
    let mut made = Made::new();
    made.json["scenes"][0]["nodes"] = json!([0, 1]);
    made.json["nodes"] = json!([{ "mesh": 0 }, { "children": [2], "translation": [9, 0, 0] }, { "mesh": 0 }]);
    assert_eq!(made.shape().0, 2);
    made.json["nodes"][1]["extensions"] = json!({ "KHR_node_visibility": { "visible": false } });
    made.json["extensionsRequired"] = json!(["KHR_node_visibility"]);
    assert_eq!(made.shape(), PLAIN);
}

#[test]
fn whole_numbers_may_stand_for_places() {
    for (normalized, stretched) in [(false, 10.0), (true, 0.1)] {
        let mut made = Made::new();
        let corners: Vec<u8> = (0..8).flat_map(|i| [(i & 1) * 40, (i >> 1 & 1) * 80, (i >> 2) * 120, 0]).collect();
        let positions = made.accessor(5120, "VEC3", 8, &corners);
        made.json["accessors"][positions]["normalized"] = json!(normalized);
        let view = made.json["accessors"][positions]["bufferView"].as_u64().unwrap() as usize;
        made.json["bufferViews"][view]["byteStride"] = json!(4);
        made.primitive()["attributes"]["POSITION"] = json!(positions);
        made.json["nodes"][0]["scale"] = json!([stretched, stretched, stretched]);
        assert_eq!(made.shape(), PLAIN, "{normalized}");
    }
}

#[test]
fn what_a_file_needs_and_is_not_read_is_named() {
    for (extension, says) in [
        ("KHR_draco_mesh_compression", "Draco compression is not supported; save it as a GLB without compression"),
        ("EXT_meshopt_compression", "meshopt compression is not supported"),
        ("KHR_meshopt_compression", "meshopt compression is not supported"),
        ("ACME_shape", "needs the glTF extension ACME_shape, which is not read here; export it without ACME_shape"),
    ] {
        let mut made = Made::new();
        made.json["extensionsUsed"] = json!([extension]);
        assert_eq!(made.shape(), PLAIN, "{extension} has something else in its place");
        made.json["extensionsRequired"] = json!(["KHR_materials_unlit", "KHR_texture_transform", extension]);
        assert!(made.refused().contains(says), "{}", made.refused());
    }
    // Offered, but with nothing in its place.
    let mut made = Made::new();
    made.primitive()["extensions"] = json!({ "KHR_draco_mesh_compression": { "bufferView": 0 } });
    made.json["accessors"][0] = json!({ "componentType": 5126, "count": 8, "type": "VEC3" });
    assert!(made.refused().contains("Draco compression"), "{}", made.refused());
    let mut made = Made::new();
    made.json["bufferViews"][0]["extensions"] = json!({ "EXT_meshopt_compression": { "buffer": 0 } });
    made.json["bufferViews"][0]["buffer"] = json!(1);
    assert!(made.refused().contains("meshopt compression"), "{}", made.refused());
}

#[test]
fn a_gltf_in_words_is_the_same() {
    let made = Made::new();
    let mut json = made.json.clone();
    json["buffers"] = json!([{ "byteLength": made.data.len(),
        "uri": format!("data:application/octet-stream;base64,{}", base64(&made.data)) }]);
    assert_eq!(shape(&read_mesh("a.gltf", json.to_string().as_bytes(), None).unwrap()), PLAIN);
}
