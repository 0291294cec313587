//! Files and links, in and out, and the command line.

#[cfg(feature = "cli")]
mod cli;
mod export_files;
mod export_mesh;
mod export_share;
#[path = "../support/export_support/mod.rs"]
mod export_support;
mod field_meshes;
#[cfg(feature = "cli")]
mod field_pictures;
mod gltf;
mod gltf_pose;
#[path = "../support/mesh_common/mod.rs"]
mod mesh_common;
mod mesh_files;
mod mesh_hostile;
#[cfg(feature = "cli")]
mod picture_files;
mod three_mf;
