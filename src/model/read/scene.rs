//! The part of a glTF's JSON that says what shape there is and where.

use glam::{DMat4, DQuat, DVec3};
use serde::Deserialize;

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Scene {
    pub(super) extensions_required: Vec<String>,
    scene: Option<usize>,
    scenes: Vec<Roots>,
    nodes: Vec<Node>,
    pub(super) meshes: Vec<Part>,
    pub(super) accessors: Vec<Accessor>,
    pub(super) buffer_views: Vec<BufferView>,
    pub(super) buffers: Vec<Buffer>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Roots {
    nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Node {
    children: Vec<usize>,
    mesh: Option<usize>,
    /// By columns; it excludes the other three.
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Part {
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    #[serde(default)]
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    #[serde(default = "triangles")]
    pub(super) mode: u32,
}

fn triangles() -> u32 {
    4
}

#[derive(Debug, Default, Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: usize,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<serde::de::IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
}

impl Node {
    fn local(&self) -> DMat4 {
        match self.matrix {
            Some(columns) => DMat4::from_cols_array(&columns),
            None => DMat4::from_scale_rotation_translation(
                self.scale.map_or(DVec3::ONE, DVec3::from),
                self.rotation.map_or(DQuat::IDENTITY, |q| {
                    let q = DQuat::from_array(q);
                    if q.length_squared() > 0.0 { q.normalize() } else { DQuat::IDENTITY }
                }),
                self.translation.map_or(DVec3::ZERO, DVec3::from),
            ),
        }
    }
}

impl Scene {
    /// The meshes that the scene shows, each with its place in the world. Every node is visited once, so circles end.
    pub(super) fn placed(&self) -> Vec<(usize, DMat4)> {
        let mut child = vec![false; self.nodes.len()];
        for &i in self.nodes.iter().flat_map(|node| &node.children) {
            if i < child.len() {
                child[i] = true;
            }
        }
        let roots: Vec<usize> = match self.scenes.get(self.scene.unwrap_or(0)) {
            Some(scene) => scene.nodes.clone(),
            None => (0..self.nodes.len()).filter(|&i| !child[i]).collect(),
        };
        let mut seen = vec![false; self.nodes.len()];
        let mut waiting: Vec<(usize, DMat4)> = roots.into_iter().rev().map(|i| (i, DMat4::IDENTITY)).collect();
        let mut placed = Vec::new();
        while let Some((i, above)) = waiting.pop() {
            let Some(node) = self.nodes.get(i) else { continue };
            if std::mem::replace(&mut seen[i], true) {
                continue;
            }
            let matrix = above * node.local();
            placed.extend(node.mesh.filter(|&mesh| mesh < self.meshes.len()).map(|mesh| (mesh, matrix)));
            waiting.extend(node.children.iter().rev().map(|&i| (i, matrix)));
        }
        if self.nodes.is_empty() {
            // A library of meshes without a scene: all of them where they are.
            placed.extend((0..self.meshes.len()).map(|mesh| (mesh, DMat4::IDENTITY)));
        }
        placed
    }
}
