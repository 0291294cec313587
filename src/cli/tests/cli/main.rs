//! The command line: its verbs, and the files that people have.

mod build;
mod field_meshes;
mod field_pictures;
mod guiding;
mod likeness;
#[path = "../../../../tests/support/notice/mod.rs"]
mod notice;
mod photograph;
mod verbs;

/// Where `tests/drawings` and `tests/field` lie.
fn repository() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
