//! Photographs are told from everything else that is read.

use crate::scenes::{SIDE, Scene, photograph, twelve};
use std::path::Path;
use wire4d::picture::{Picture, is_photograph, read_picture};

#[test]
fn all_twelve_are_photographs() {
    let taken_for_drawings = |scene: &Scene| {
        let made = photograph(scene);
        let rgba = made.rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        !is_photograph(&Picture::new(made.name, SIDE, SIDE, rgba).unwrap())
    };
    let wrong: Vec<_> = twelve().iter().filter(|scene| taken_for_drawings(scene)).map(|scene| scene.name).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn drawings_renderings_and_real_world_files_of_drawings_are_none() {
    fn look(folder: &Path, seen: &mut usize) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                look(&path, seen);
            } else if let Ok(picture) = read_picture(&path) {
                assert!(!is_photograph(&picture), "{}", path.display());
                *seen += 1;
            }
        }
    }
    let mut seen = 0;
    for folder in ["drawings", "strokes", "field"] {
        look(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder), &mut seen);
    }
    assert!(seen > 60, "{seen} pictures");
}
