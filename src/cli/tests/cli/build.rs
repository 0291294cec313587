//! `wire4d build`.

use crate::verbs::{json, program, refused, succeeds, text};
use glam::{DQuat, DVec3};
use serde_json::{Value, json as value};
use std::fs;
use std::path::Path;
use std::process::Output;
use wire4d::sculpture::Sculpture;
use wire4d_fabrication::Centreline;

fn build(wire: &Path, out: &Path, flags: &[&str]) -> Output {
    program(&["build", text(wire), "--out", text(out)]).args(flags).output().unwrap()
}

fn wire(name: &str) -> std::path::PathBuf {
    crate::repository().join("tests/wires").join(format!("{name}.json"))
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// A wire.json of these points.
fn written(folder: &Path, points: &[[f64; 4]]) -> std::path::PathBuf {
    let knots: Vec<f64> = (0..points.len() + 7).map(|i| i as f64).collect();
    let made = value!({
        "format": "wire4d", "version": 1, "closed": true, "knots": knots, "control_points": points,
        "views": [], "made_with": { "task": "", "seed": 0, "settings": {}, "wire4d": "0.1.0" },
    });
    let file = folder.join("written.json");
    fs::write(&file, made.to_string()).unwrap();
    file
}

#[test]
fn a_wire_is_checked_at_a_size_and_gauge() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let output = build(&wire("coil"), &out, &["--size-mm", "150", "--wire-mm", "1", "--metal", "steel"]);
    assert_eq!(succeeds(&output), text(&out.join("build.json")));
    assert!(said(&output).contains("1 mm steel wire"), "{}", said(&output));
    let report = json(&out.join("build.json"));
    assert_eq!(report["size_mm"], 150.0);
    assert_eq!(report["stock"]["metal"], "steel");
    let box_mm = report["check"]["box_mm"].as_array().unwrap();
    let longest = box_mm.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    assert!((longest - 151.0).abs() < 0.5, "{box_mm:?}");
    let pdf = fs::read(out.join("paper.pdf")).unwrap();
    assert!(pdf.starts_with(b"%PDF-") && pdf.windows(9).any(|part| part == b"(Step 15)"));
    let steps = report["steps"].as_array().unwrap();
    assert!((15..=40).contains(&steps.len()));
    assert!(steps.iter().all(|step| step["side"]["azimuth_deg"].is_number()));
    // Nothing is written over unless that is asked for.
    refused(&build(&wire("coil"), &out, &[]), "made");
    succeeds(&build(&wire("coil"), &out, &["--overwrite", "--quiet"]));
}

#[test]
fn a_gauge_thicker_than_the_air_between_strands_is_said_with_what_helps() {
    let folder = tempfile::tempdir().unwrap();
    let output = build(&wire("knot"), &folder.path().join("made"), &["--size-mm", "40", "--wire-mm", "9"]);
    let report = json(Path::new(&succeeds(&output)));
    assert_eq!(report["check"]["passes"], false);
    assert!(!report["check"]["clearance"]["meetings"].as_array().unwrap().is_empty());
    let size = &report["check"]["passing"]["size_mm"];
    assert!(said(&output).contains(&format!("--size-mm {}", size.as_f64().unwrap())), "{}", said(&output));
    // What was said holds.
    let larger = folder.path().join("larger");
    let output = build(&wire("knot"), &larger, &["--size-mm", &size.to_string(), "--wire-mm", "9"]);
    assert_eq!(json(Path::new(&succeeds(&output)))["check"]["passes"], true, "{}", said(&output));
}

#[test]
fn a_wire_through_itself_says_where() {
    let folder = tempfile::tempdir().unwrap();
    let points: Vec<[f64; 4]> = (0..64)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 64.0)
        .map(|t| [t.cos(), 0.6 * (2.0 * t).sin(), 0.0, 0.02])
        .collect();
    let output = build(&written(folder.path(), &points), &folder.path().join("made"), &[]);
    let report = json(Path::new(&succeeds(&output)));
    assert_eq!(report["check"]["clearance"]["meetings"][0]["through"], true);
    assert_eq!(report["check"]["passing"]["size_mm"], Value::Null);
    assert!(said(&output).contains("pass through the other"), "{}", said(&output));
}

#[test]
fn twenty_thousand_points_are_no_trouble() {
    let folder = tempfile::tempdir().unwrap();
    // Hops at random: it touches itself everywhere, at every size.
    let mut state = 1u32;
    let mut number = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 23) - 1.0
    };
    let points: Vec<[f64; 4]> = (0..20_000)
        .map(|_| [number(), number(), number(), 0.02].map(|x: f64| x.clamp(-1.0, 1.0)))
        .map(|[x, y, z, _]| [x, y, z, 0.02])
        .collect();
    let output = build(&written(folder.path(), &points), &folder.path().join("made"), &[]);
    let report = json(Path::new(&succeeds(&output)));
    assert_eq!(report["check"]["passes"], false);
}

#[test]
fn what_cannot_be_built_is_said_in_a_line() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    for (flags, names) in [
        (["--size-mm", "0"], "--size-mm"),
        (["--size-mm", "10000"], "5000 mm"),
        (["--size-mm", "-3"], "--size-mm"),
        (["--wire-mm", "0"], "--wire-mm"),
        (["--wire-mm", "1e9"], "--wire-mm"),
        (["--stock-mm", "0"], "--stock-mm"),
        (["--metal", "gold"], "copper"),
        (["--paper", "a0"], "letter"),
    ] {
        refused(&build(&wire("coil"), &out, &flags), names);
        assert!(!out.exists(), "{flags:?} leaves nothing behind");
    }
    refused(&build(&wire("bag"), &out, &[]), "loose curves");
    refused(&build(Path::new("nowhere.json"), &out, &[]), "nowhere.json");
}

/// Goes by the machine's rows alone, a little at a time.
fn rebuilt(rows: &str, [start, direction, axis]: [DVec3; 3]) -> Vec<DVec3> {
    let (mut place, mut direction, mut axis) = (start, direction, axis);
    let mut places = vec![start];
    for row in rows.lines().skip(1) {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let [feed, rotate, bend, radius, _] = cells[..] else { panic!("{row}") };
        for _ in 0..100 {
            place += direction * feed / 100.0;
            places.push(place);
        }
        axis = (DQuat::from_axis_angle(direction, rotate.to_radians()) * axis).normalize();
        let centre = place + radius * axis.cross(direction);
        let part = DQuat::from_axis_angle(axis, bend.to_radians() / 64.0);
        for _ in 0..64 {
            place = centre + part * (place - centre);
            direction = (part * direction).normalize();
            places.push(place);
        }
    }
    places
}

#[test]
fn wires_rebuilt_from_their_lists_are_within_a_hundredth_of_their_size() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["smooth", "coil", "knot", "fitted", "chain", "kinked"] {
        let out = folder.path().join(name);
        let report = json(Path::new(&succeeds(&build(&wire(name), &out, &["--size-mm", "200"]))));
        let bends = &report["bends"];
        let frame = ["start", "direction", "axis"]
            .map(|key| DVec3::from_array([0, 1, 2].map(|c| bends[key][c].as_f64().unwrap())));
        let places = rebuilt(&fs::read_to_string(out.join("bends.csv")).unwrap(), frame);
        let made = Sculpture::from_json(name, &fs::read(wire(name)).unwrap()).unwrap();
        let line = Centreline::new(&made.wire, 200.0, 1.6).unwrap();
        let off = |p: &DVec3, from: &[DVec3]| from.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min);
        let there = places.iter().step_by(7).map(|p| off(p, line.points())).fold(0.0, f64::max);
        let back = line.points().iter().step_by(7).map(|p| off(p, &places)).fold(0.0, f64::max);
        assert!(there < 2.0 && back < 2.0, "{name}: {there} and {back} mm of 200");
        let text = fs::read_to_string(out.join("bends.md")).unwrap();
        let rows = text.lines().filter(|line| line.starts_with("| ")).count() - 1;
        let bends = bends["bends"].as_array().unwrap();
        assert_eq!(rows, bends.len());
        let dxf = fs::read_to_string(out.join("bends.dxf")).unwrap();
        assert_eq!(dxf.matches("AcDbArc").count(), bends.iter().filter(|bend| bend["radius_mm"] != 0.0).count());
    }
}

#[test]
fn print_and_jig_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let flags = ["--size-mm", "90", "--wire-mm", "2", "--name", "Coil 1", "--bed-mm", "80x80x200"];
    let output = build(&wire("coil"), &out, &flags);
    succeeds(&output);
    assert!(said(&output).contains("one solid, 2 mm at its thinnest"), "{}", said(&output));
    for name in ["print.stl", "jig-1.stl", "jig-2.stl"] {
        let file = fs::read(out.join(name)).unwrap();
        let count = u32::from_le_bytes(file[80..84].try_into().unwrap()) as usize;
        assert!(count > 100 && file.len() == 84 + 50 * count, "{name}");
    }
    for name in ["print.3mf", "jig.3mf"] {
        assert!(fs::read(out.join(name)).unwrap().starts_with(b"PK"), "{name}");
    }
    // Thin wire is bent, and not printed.
    let thin = build(&wire("coil"), &folder.path().join("thin"), &["--wire-mm", "0.3"]);
    succeeds(&thin);
    assert!(said(&thin).contains("No print and no jig") && said(&thin).contains("nozzle"), "{}", said(&thin));
    for (flags, names) in [
        (["--name", "Ł"], "A to Z"),
        (["--bed-mm", "220"], "220x220x250"),
        (["--bed-mm", "0x220x250"], "60 to 2000 mm"),
    ] {
        let nowhere = folder.path().join("nowhere");
        refused(&build(&wire("coil"), &nowhere, &flags), names);
        assert!(!nowhere.exists(), "{flags:?} leaves nothing behind");
    }
}
