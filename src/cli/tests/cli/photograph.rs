//! `wire4d photograph`.

use crate::verbs::{program, refused, succeeds, text};
use std::path::Path;
use std::process::Output;

fn photograph(out: &Path, flags: &[&str]) -> Output {
    let wire = crate::repository().join("tests/wires/coil.json");
    let small = ["photograph", text(&wire), "--out", text(out), "--size", "96x64", "--passes", "4", "--quiet"];
    program(&small).args(flags).output().unwrap()
}

fn taken(folder: &Path, flags: &[&str]) -> image::RgbImage {
    let out = folder.join("photo.png");
    assert_eq!(succeeds(&photograph(&out, flags)), text(&out));
    image::open(&out).unwrap().to_rgb8()
}

#[test]
fn the_same_seed_gives_the_same_picture_with_copper_and_shadows_in_it() {
    let folder = tempfile::tempdir().unwrap();
    let [first, again, other] = ["1", "1", "2"].map(|seed| taken(folder.path(), &["--seed", seed]));
    assert_eq!(first.dimensions(), (96, 64));
    assert_eq!(first, again);
    assert_ne!(first, other);
    let copper = first.pixels().filter(|pixel| pixel[0] > pixel[2].saturating_add(40)).count();
    assert!(copper > 8, "{copper} pixels of copper");
    let dark = taken(folder.path(), &["--exposure", "-20"]);
    assert!(dark.pixels().all(|pixel| pixel.0 == [0; 3]));
}

#[test]
fn finishes_and_places_look_different() {
    let folder = tempfile::tempdir().unwrap();
    let usual = taken(folder.path(), &[]);
    for flags in [["--finish", "matte"], ["--place", "screens"], ["--aperture", "0.4"], ["--azimuth", "10"]] {
        assert_ne!(taken(folder.path(), &flags), usual, "{flags:?}");
    }
}

#[test]
fn what_cannot_be_is_said_in_a_line() {
    let folder = tempfile::tempdir().unwrap();
    for (flags, said) in [
        (["--size", "0x10"], "size"),
        (["--size", "large"], "1920x1080"),
        (["--lamp-distance", "1"], "lamp-distance"),
        (["--view-angle", "400"], "view-angle"),
        (["--exposure", "NaN"], "exposure"),
    ] {
        refused(&photograph(&folder.path().join("photo.png"), &flags), said);
    }
}
