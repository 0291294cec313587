//! Files and links, in and out, and what the page is handed.

mod export_files;
mod export_mesh;
mod export_replay;
mod export_share;
#[path = "../support/export_support/mod.rs"]
mod export_support;
mod gltf;
mod gltf_pose;
#[path = "../support/mesh_common/mod.rs"]
mod mesh_common;
mod mesh_files;
mod mesh_hostile;
#[path = "../support/notice/mod.rs"]
mod notice;
mod page_types;
#[cfg(feature = "files")]
mod picture_files;
mod reopening;
mod three_mf;
