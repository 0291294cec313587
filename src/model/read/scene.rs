//! The part of a glTF's JSON that says what shape there is and where.

use glam::{DMat4, DQuat, DVec3};
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::BTreeMap;

/// What all versions of the format begin with.
#[derive(Deserialize)]
pub(super) struct Head {
    pub(super) asset: Asset,
}

#[derive(Deserialize)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Scene {
    pub(super) extensions_required: Vec<String>,
    scene: Option<usize>,
    scenes: Vec<Roots>,
    pub(super) nodes: Vec<Node>,
    pub(super) meshes: Vec<Part>,
    pub(super) skins: Vec<Skin>,
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
pub(super) struct Node {
    children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) skin: Option<usize>,
    /// Of the mesh's morph targets; the mesh's own if there are none.
    pub(super) weights: Vec<f64>,
    /// By columns; it excludes the other three.
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
    extensions: NodeExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct NodeExtensions {
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    instancing: Option<Instancing>,
    #[serde(rename = "KHR_node_visibility")]
    visibility: Option<Visibility>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Instancing {
    attributes: Attributes,
}

#[derive(Debug, Deserialize)]
struct Visibility {
    #[serde(default = "yes")]
    visible: bool,
}

fn yes() -> bool {
    true
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Part {
    pub(super) primitives: Vec<Primitive>,
    pub(super) weights: Vec<f64>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    #[serde(default)]
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    #[serde(default = "triangles")]
    pub(super) mode: u32,
    #[serde(default)]
    pub(super) targets: Vec<Attributes>,
    #[serde(default)]
    pub(super) extensions: Extensions,
}

fn triangles() -> u32 {
    4
}

/// Accessors by what they hold.
pub(super) type Attributes = BTreeMap<String, usize>;

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Skin {
    pub(super) joints: Vec<usize>,
    pub(super) inverse_bind_matrices: Option<usize>,
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
    pub(super) sparse: Option<Sparse>,
}

/// Elements that are other than the accessor's data, or than 0.
#[derive(Debug, Deserialize)]
pub(super) struct Sparse {
    pub(super) count: usize,
    pub(super) indices: SparseIndices,
    pub(super) values: SparseValues,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseIndices {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseValues {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
    #[serde(default)]
    pub(super) extensions: Extensions,
}

#[derive(Debug, Deserialize)]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
}

/// Ways to compress that may be offered without being required.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Extensions {
    #[serde(rename = "KHR_draco_mesh_compression")]
    draco: Option<IgnoredAny>,
    #[serde(rename = "EXT_meshopt_compression", alias = "KHR_meshopt_compression")]
    meshopt: Option<IgnoredAny>,
}

impl Extensions {
    pub(super) fn is_draco(&self) -> bool {
        self.draco.is_some()
    }

    pub(super) fn is_meshopt(&self) -> bool {
        self.meshopt.is_some()
    }
}

impl Node {
    /// Where its mesh is put again and again, if it is.
    pub(super) fn instances(&self) -> Option<&Attributes> {
        self.extensions.instancing.as_ref().map(|instancing| &instancing.attributes)
    }

    fn is_visible(&self) -> bool {
        self.extensions.visibility.as_ref().is_none_or(|visibility| visibility.visible)
    }

    fn local(&self) -> DMat4 {
        match self.matrix {
            Some(columns) => DMat4::from_cols_array(&columns),
            None => placement(
                self.translation.unwrap_or([0.0; 3]),
                self.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]),
                self.scale.unwrap_or([1.0; 3]),
            ),
        }
    }
}

/// First scaled, then turned, then moved.
pub(super) fn placement(translation: [f64; 3], rotation: [f64; 4], scale: [f64; 3]) -> DMat4 {
    let turn = DQuat::from_array(rotation);
    let turn = if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY };
    DMat4::from_scale_rotation_translation(DVec3::from(scale), turn, DVec3::from(translation))
}

/// Where nodes are.
pub(super) struct World {
    /// A matrix a node.
    pub(super) matrices: Vec<DMat4>,
    /// The nodes that the scene shows, in its order.
    pub(super) shown: Vec<usize>,
}

impl Scene {
    /// Where each node is: those that the scene shows, and others, which may be joints. Every node is visited once, so
    /// circles end.
    pub(super) fn world(&self) -> World {
        let mut child = vec![false; self.nodes.len()];
        for &i in self.nodes.iter().flat_map(|node| &node.children) {
            if i < child.len() {
                child[i] = true;
            }
        }
        let orphans = || (0..self.nodes.len()).filter(|&i| !child[i]);
        let roots: Vec<usize> = match self.scenes.get(self.scene.unwrap_or(0)) {
            Some(scene) => scene.nodes.clone(),
            None => orphans().collect(),
        };
        let mut world = World { matrices: vec![DMat4::IDENTITY; self.nodes.len()], shown: Vec::new() };
        let mut seen = vec![false; self.nodes.len()];
        let roots = roots.into_iter().map(|i| (i, true)).chain(orphans().map(|i| (i, false)));
        for (root, shows) in roots {
            let mut waiting = vec![(root, DMat4::IDENTITY, shows)];
            while let Some((i, above, shows)) = waiting.pop() {
                let Some(node) = self.nodes.get(i) else { continue };
                if std::mem::replace(&mut seen[i], true) {
                    continue;
                }
                let shows = shows && node.is_visible();
                world.matrices[i] = above * node.local();
                if shows {
                    world.shown.push(i);
                }
                waiting.extend(node.children.iter().rev().map(|&child| (child, world.matrices[i], shows)));
            }
        }
        world
    }
}
