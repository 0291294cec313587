//! A learned yardstick in the report, by the tiny network of `tests/data/guidance`, whose weights are random.
use crate::verbs::{json, quick_run, refused, succeeds, text};

#[test]
fn the_report_says_how_alike_views_and_pictures_are_to_a_network() {
    let folder = tempfile::tempdir().unwrap();
    let network = crate::repository().join("tests/data/guidance/vit-tiny.onnx");
    let distances = |out: &str, more: &[&str]| {
        let out = folder.path().join(out);
        succeeds(&quick_run(&out, &[&["--backend", "cpu"], more].concat()));
        let report = json(&out.join("report.json"));
        let views = report["result"]["views"].as_array().unwrap().clone();
        views.iter().map(|view| view["feature_distance"].as_f64()).collect::<Vec<_>>()
    };
    let named = ["--perceptual", text(&network)];
    let found = distances("measured", &named);
    assert!(found.len() >= 2 && found.iter().all(|d| d.is_some_and(|d| (0.0..2.0).contains(&d))), "{found:?}");
    assert!(distances("unmeasured", &[]).iter().all(Option::is_none));

    let missing = folder.path().join("none.onnx");
    refused(&quick_run(&folder.path().join("refused"), &["--perceptual", text(&missing)]), "none.json");
}
