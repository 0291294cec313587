//! Pictures as people have them, on the command line: the key is ink, whatever it is drawn with and photographed on.
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn field(name: &str) -> PathBuf {
    crate::repository().join("tests/field").join(name)
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wire4d")).args(arguments).output().unwrap()
}

/// A picture and the house beside it, one iteration: what stands in the report, and the front's target.
fn read(front: &Path) -> (Value, image::GrayImage) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let side = field("colour-ink/side.png");
    let quick = ["--iterations", "1", "--grid", "24", "--arrange", "off", "--quiet"];
    let output = run(&[&["multiview", text(front), text(&side), "--out", text(&out)], &quick[..]].concat());
    assert!(output.status.success(), "{}: {}", front.display(), String::from_utf8_lossy(&output.stderr));
    let report: Value = serde_json::from_slice(&fs::read(out.join("report.json")).unwrap()).unwrap();
    (report["reading"][0].clone(), image::open(out.join("front-target.png")).unwrap().into_luma8())
}

fn share(target: &image::GrayImage) -> f64 {
    target.pixels().map(|pixel| f64::from(pixel[0]) / 255.0).sum::<f64>() / target.len() as f64
}

fn apart(a: &image::GrayImage, b: &image::GrayImage) -> f64 {
    let each = a.pixels().zip(b.pixels()).map(|(a, b)| f64::from(a[0].abs_diff(b[0])) / 255.0);
    each.sum::<f64>() / a.len() as f64
}

/// Each of the pictures is read as the first is.
#[track_caller]
fn all_are_read_as(first: &str, others: &[&str], wanted: f64, most_apart: f64) {
    let (_, key) = read(&field(first));
    assert!((share(&key) - wanted).abs() < 0.002, "{first}: {}", share(&key));
    for other in others {
        let (reading, target) = read(&field(other));
        assert!((share(&target) - wanted).abs() < 0.004, "{other}: {} of it is ink, {reading}", share(&target));
        assert!(apart(&target, &key) < most_apart, "{other}: {}", apart(&target, &key));
    }
}

#[test]
fn ink_is_told_by_colour() {
    let others = ["yellow-on-white", "blue-on-black", "orange-marker-on-kraft", "pink-on-white", "green-neon-on-black"]
        .map(|name| format!("colour-ink/{name}.png"));
    all_are_read_as("colour-ink/front.png", &others.each_ref().map(String::as_str), 0.101, 0.003);
    let (reading, _) = read(&field("colour-ink/orange-marker-on-kraft.png"));
    assert_eq!((&reading["colours"][1], &reading["ink"]), (&"#b48c64".into(), &"dark".into()));
}

#[test]
fn a_sheet_on_a_desk_is_paper_and_the_report_says_so() {
    let others = ["framed", "thin-frame", "dark-strips"].map(|name| format!("photo-on-dark-desk/front-{name}.png"));
    let (_, first) = read(&field(&others[0]));
    for other in &others {
        let (reading, target) = read(&field(other));
        assert_eq!(reading["ink"], "dark", "{other}: {reading}");
        assert!(reading["because"].as_str().unwrap().contains("light sheet is ground"), "{reading}");
        assert!((0.06..0.067).contains(&reading["share"].as_f64().unwrap()), "{other}: {reading}");
        assert!(apart(&target, &first) < 0.01, "{other}: {}", apart(&target, &first));
    }
    let (reading, _) = read(&field("photo-on-dark-desk/front.png"));
    assert!(reading["because"].as_str().unwrap().contains("border"), "{reading}");
}

#[test]
fn alpha_is_the_drawing_whatever_colour_is_under_it() {
    let others =
        ["white-straight", "white-premultiplied", "white-replaced", "white-la", "white-palette-trns", "one-bit"]
            .map(|name| format!("white-icon-dark-fringe/{name}.png"));
    all_are_read_as("white-icon-dark-fringe/front.png", &others.each_ref().map(String::as_str), 0.101, 0.012);
}

#[test]
fn thin_lines_survive_scaling_down() {
    let scans = ["fineliner-scan/scan-2px-of-2400.png", "fineliner-scan/scan-3px-of-2400.png"];
    all_are_read_as("fineliner-scan/same-2px-of-600.png", &scans, 0.046, 0.02);
    let (reading, _) = read(&field(scans[0]));
    assert!(reading["notes"][0].as_str().unwrap().contains("2400 x 2400 px"), "{reading}");
}

#[test]
fn what_is_behind_a_jpeg_does_not_matter() {
    let others = ["motion", "two-jpegs", "no-end-marker"].map(|name| format!("jpeg-motion-photo/front-{name}.jpg"));
    all_are_read_as("jpeg-motion-photo/front-plain.jpg", &others.each_ref().map(String::as_str), 0.101, 1e-6);
}

/// The object's mask and the first wire's depths, of a stroke after one iteration.
fn stroke(picture: &str, more: &[&str]) -> (image::GrayImage, Vec<f64>, String) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let picture = field(picture);
    let quick = ["--iterations", "1", "--size", "96"];
    let output = run(&[&["stroke", text(&picture), "--out", text(&out)], &quick[..], more].concat());
    let words = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{}: {words}", picture.display());
    let wire: Value = serde_json::from_slice(&fs::read(out.join("wire.json")).unwrap()).unwrap();
    let points = wire["control_points"].as_array().unwrap();
    let depths = points.iter().map(|point| point[2].as_f64().unwrap()).collect();
    (image::open(out.join("mask.png")).unwrap().into_luma8(), depths, words)
}

#[test]
fn a_stroke_is_of_the_key_in_all_of_them() {
    let (key, ..) = stroke("stray-alpha/front.png", &[]);
    assert!((0.08..0.09).contains(&share(&key)), "stray alpha: {}", share(&key));
    for picture in ["colour-ink/orange-marker-on-kraft.png", "white-icon-dark-fringe/white-replaced.png"] {
        let (mask, ..) = stroke(picture, &[]);
        assert!(apart(&mask, &key) < 0.006, "{picture}: {}", apart(&mask, &key));
    }
    let (framed, _, words) = stroke("photo-on-dark-desk/front-thin-frame.png", &[]);
    assert!((0.058..0.067).contains(&share(&framed)), "framed: {}", share(&framed));
    assert!(words.contains("sheet"), "{words}");
}

#[test]
fn depths_of_sixteen_bits_are_as_fine_as_those_of_eight() {
    let depth = |name: &str| {
        let depth = field(&format!("depth-16bit-mm/{name}.png"));
        stroke("depth-16bit-mm/ball.png", &["--depth", text(&depth), "--seed", "3"])
    };
    let (_, wanted, _) = depth("near-is-bright-8bit");
    let range = |depths: &[f64]| depths.iter().fold([f64::MAX, f64::MIN], |[a, b], &z| [a.min(z), b.max(z)]);
    let [back, front] = range(&wanted);
    for name in ["near-is-bright-full-range", "near-is-bright-300-to-800", "distance-in-mm"] {
        let (_, depths, words) = depth(name);
        let [low, high] = range(&depths);
        assert!(
            (low - back).abs() < 0.06 && (high - front).abs() < 0.06,
            "{name}: {low} to {high}, not {back} to {front}"
        );
        let mean = |depths: &[f64]| depths.iter().sum::<f64>() / depths.len() as f64;
        assert!((mean(&depths) - mean(&wanted)).abs() < 0.04, "{name}: {} {}", mean(&depths), mean(&wanted));
        assert_eq!(words.contains("taken for distances"), name == "distance-in-mm", "{words}");
    }
}
