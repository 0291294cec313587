//! Networks that guide a run, from the command line: the tiny one of `tests/data/guidance`, whose weights are random.
use crate::verbs::{json, quick, quick_run, refused, succeeds, text};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

/// The tiny network as `NAME.onnx` in `folder`, with words in its sidecar.
fn network(folder: &Path, name: &str) -> PathBuf {
    let data = crate::repository().join("tests/data/guidance");
    let file = folder.join(format!("{name}.onnx"));
    fs::copy(data.join("vit-tiny.onnx"), &file).unwrap();
    let mut sidecar = json(&data.join("vit-tiny.json"));
    let vector = |sign: f64| (0..16).map(|i| sign * f64::from(7 * i % 5 - 2)).collect::<Vec<_>>();
    sidecar["embeddings"] = json!([
        { "prompt": "a cat", "vector": vector(1.0) },
        { "prompt": "a wire", "vector": vector(-1.0) },
    ]);
    fs::write(file.with_extension("json"), sidecar.to_string()).unwrap();
    file
}

/// A word table of `bird` and `fish` as `words.json` in `folder`.
fn table(folder: &Path) {
    let row = |i: i32| ((7 * i + 3) % 100 + 1) as u8;
    let other = |i: i32| (((11 * i + 5) % 100 + 1) * (1 - i % 2 * 2)) as u8;
    let rows: Vec<u8> = (0..16).map(row).chain((0..16).map(other)).collect();
    fs::write(folder.join("words.bin"), rows).unwrap();
    let facts = json!({ "kind": "word-table-v1", "embed": 16, "words": ["bird", "fish"], "licence": "none",
        "sha256": "c2291d17467becdbcd4b0ef7528c1f37718748a3d6c9bd50ed08921d75f4c42f" });
    fs::write(folder.join("words.json"), facts.to_string()).unwrap();
}

fn guided(folder: &Path, out: &str, more: &[&str]) -> Value {
    let out = folder.join(out);
    succeeds(&quick_run(&out, &[&["--backend", "cpu"], more].concat()));
    json(&out.join("report.json"))
}

#[test]
fn views_come_nearer_to_their_words() {
    let folder = tempfile::tempdir().unwrap();
    let (first, second) = (network(folder.path(), "first"), network(folder.path(), "second"));
    let with = |out: &str, weight: &str| {
        let guides = ["--guide", text(&first), "--guide", text(&second), "--words", "A cat", "--words", "side=a wire"];
        guided(folder.path(), out, &[&guides[..], &["--guide-weight", weight, "--guide-look", "whole"]].concat())
    };
    let (plain, pulled) = (with("plain", "0"), with("pulled", "30"));
    let mean = |report: &Value| report["guidance"]["mean_cos"].as_f64().unwrap();
    assert!(mean(&pulled) > mean(&plain) + 0.02, "{} and {}", mean(&pulled), mean(&plain));
    let guidance = &pulled["guidance"];
    let named =
        |list: &Value, key: &str| list.as_array().unwrap().iter().map(|entry| entry[key].clone()).collect::<Vec<_>>();
    assert_eq!(named(&guidance["networks"], "name"), ["vit-tiny", "vit-tiny"]);
    assert_eq!(named(&guidance["views"], "view"), ["front", "side"]);
    assert_eq!(named(&guidance["views"], "words"), ["A cat", "a wire"]);
    assert!(guidance["trouble"].is_null() && guidance["weight"] == 30.0);
    // The same again is the same wire.
    with("again", "30");
    let wire = |out: &str| fs::read(folder.path().join(out).join("wire.json")).unwrap();
    assert!(wire("pulled") == wire("again") && wire("pulled") != wire("plain"));
}

#[test]
fn words_of_a_table_and_neutral_ones_guide_patch_by_patch() {
    let folder = tempfile::tempdir().unwrap();
    let file = network(folder.path(), "net");
    table(folder.path());
    let guides = ["--guide", text(&file), "--words", "front=bird", "--neutral", "fish", "--guide-look", "patches"];
    let report = guided(folder.path(), "out", &guides);
    let views = report["guidance"]["views"].as_array().unwrap();
    assert!(views.len() == 1 && views[0]["words"] == "bird", "{views:?}");
    assert!(guided(folder.path(), "unguided", &[]).get("guidance").is_none());
}

#[test]
fn bad_files_and_words_are_refused_and_leave_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let file = network(folder.path(), "net");
    let spoilt = network(folder.path(), "spoilt");
    let mut bytes = fs::read(&spoilt).unwrap();
    bytes[5000] ^= 1;
    fs::write(&spoilt, bytes).unwrap();
    let alone = folder.path().join("alone.onnx");
    fs::copy(&file, &alone).unwrap();
    let out = folder.path().join("out");
    let cases: [(&str, &[&str]); 8] = [
        ("a cat", &["--guide", text(&file), "--words", "a dog"]),
        ("\"back\"", &["--guide", text(&file), "--words", "back=a cat"]),
        ("--guide-weight", &["--guide", text(&file), "--words", "a cat", "--guide-weight", "-1"]),
        ("spoilt.onnx", &["--guide", text(&spoilt), "--words", "a cat"]),
        ("alone.json", &["--guide", text(&alone), "--words", "a cat"]),
        ("none.json", &["--guide", text(&file), "--words", "a cat", "--word-table", "none.json"]),
        ("guidance-v1", &["--guide", text(&file), "--words", "a cat", "--text", text(&file)]),
        ("--guide", &["--words", "a cat"]),
    ];
    for (said, arguments) in cases {
        refused(&quick(&out, arguments).output().unwrap(), said);
        assert!(!out.exists(), "{said}");
    }
}
