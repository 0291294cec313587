//! Networks that guide a run, from the command line: the tiny one of `tests/data/guidance`, whose weights are random.
use crate::verbs::{json, program, quick, quick_run, refused, succeeds, text};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

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
    let picture = crate::repository().join("tests/drawings/p05-tools/side.png");
    let cases: [(&str, &[&str]); 11] = [
        ("a cat", &["--guide", text(&file), "--words", "a dog"]),
        ("\"back\"", &["--guide", text(&file), "--words", "back=a cat"]),
        ("--guide-weight", &["--guide", text(&file), "--words", "a cat", "--guide-weight", "-1"]),
        ("spoilt.onnx", &["--guide", text(&spoilt), "--words", "a cat"]),
        ("alone.json", &["--guide", text(&alone), "--words", "a cat"]),
        ("none.json", &["--guide", text(&file), "--words", "a cat", "--word-table", "none.json"]),
        ("guidance-v1", &["--guide", text(&file), "--words", "a cat", "--text", text(&file)]),
        ("--guide", &["--words", "a cat"]),
        ("side.png: is a picture", &["--guide", text(&picture), "--words", "a cat"]),
        ("--denoise", &["--words", "a cat", "--contexts", "none.json"]),
        ("words", &["--guide", text(&file)]),
    ];
    for (said, arguments) in cases {
        refused(&quick(&out, arguments).output().unwrap(), said);
        assert!(!out.exists(), "{said}");
    }
}

/// A quick run of words alone.
fn words_alone(out: &Path, more: &[&str]) -> Command {
    let quick =
        ["--preset", "fast", "--size", "64", "--iterations", "60", "--backend", "cpu", "--quiet", "--out", text(out)];
    program(&[&["multiview"][..], &quick, more].concat())
}

#[test]
fn words_need_no_picture() {
    let folder = tempfile::tempdir().unwrap();
    let file = network(folder.path(), "net");
    let made = |out: &str, more: &[&str]| {
        let out = folder.path().join(out);
        let guide = ["--guide", text(&file), "--guide-weight", "30"];
        succeeds(&words_alone(&out, &[&guide, more].concat()).output().unwrap());
        assert!(out.join("front.png").is_file() && !out.join("front-target.png").exists());
        json(&out.join("report.json"))
    };
    let report = made("two", &["--words", "front=a cat", "--words", "45,20=a wire"]);
    let views = report["result"]["views"].as_array().unwrap();
    assert!(views.len() == 2 && views.iter().all(|view| view["soft_iou"].is_null()), "{views:?}");
    let cos = |report: &Value| report["guidance"]["mean_cos"].as_f64().unwrap();
    assert_eq!(report["guidance"]["views"][1]["view"], "45,20");
    let one = made("one", &["--words", "a cat"]);
    assert!(one["result"]["views"][0]["name"] == "front" && one["result"]["components"] == 1);
    let unpulled = made("unpulled", &["--words", "a cat", "--guide-weight", "0"]);
    assert!(cos(&one) > cos(&unpulled) + 0.004, "{} and {}", cos(&one), cos(&unpulled));

    // A third view beside two drawn ones.
    let beside = guided(folder.path(), "beside", &["--guide", text(&file), "--words", "top=a cat"]);
    let views = beside["result"]["views"].as_array().unwrap();
    assert!(views.len() == 3 && views[2]["soft_iou"].is_null() && views[0]["soft_iou"].as_f64().unwrap() > 0.3);
    assert_eq!(beside["arrangement"].as_array().unwrap().len(), 2);
}

#[test]
fn a_diffusion_model_guides_alone_or_beside_networks() {
    let folder = tempfile::tempdir().unwrap();
    let data = crate::repository().join("tests/data/guidance");
    let [pixels, latents, encoder] =
        ["eps-pixels-tiny", "eps-tiny", "vjp-tiny"].map(|name| data.join(format!("{name}.onnx")));
    let table = crate::repository().join("tools/iconnet/weights/words.json");
    let contexts = folder.path().join("contexts.json");
    contexts_of(&contexts, [5, 16], &["", "a cat"]);
    let made = |out: &str, more: &[&str]| {
        let out = folder.path().join(out);
        succeeds(&words_alone(&out, more).output().unwrap());
        (json(&out.join("report.json")), fs::read(out.join("wire.json")).unwrap())
    };
    let by_pixels =
        ["--denoise", text(&pixels), "--word-table", text(&table), "--words", "front=fish", "--words", "top=bird"];
    let (report, wire) = made("pixels", &by_pixels);
    let told = &report["distillation"];
    assert_eq!((&told["denoiser"]["name"], &told["times"]), (&"eps-pixels-tiny".into(), &"falling".into()));
    assert!(told["scale"] == 50.0 && told["weight"] == 1.0 && told["encoder"].is_null() && told["trouble"].is_null());
    assert_eq!(told["views"], json!([{ "view": "front", "words": "fish" }, { "view": "top", "words": "bird" }]));
    assert!(report.get("guidance").is_none());
    assert!(made("again", &by_pixels).1 == wire, "the same seed is the same wire");
    assert!(made("other", &[&by_pixels[..], &["--seed", "1"]].concat()).1 != wire);
    assert!(made("times", &[&by_pixels[..], &["--denoise-times", "dreamtime"]].concat()).1 != wire);

    let file = network(folder.path(), "net");
    let latent =
        ["--denoise", text(&latents), "--encode", text(&encoder), "--contexts", text(&contexts), "--words", "a cat"];
    let (report, _) = made("both", &[&latent[..], &["--guide", text(&file)]].concat());
    assert!(report["distillation"]["scale"] == 100.0 && report["distillation"]["encoder"]["name"] == "vjp-tiny");
    assert!(report["distillation"]["trouble"].is_null() && report["guidance"]["mean_cos"].is_number());

    let out = folder.path().join("refused");
    let other = folder.path().join("other.json");
    contexts_of(&other, [4, 16], &["", "a cat"]);
    let nothing = folder.path().join("nothing.json");
    fs::write(
        &nothing,
        r#"{ "kind": "contexts-v1", "shape": [5, 16], "contexts": [{ "prompt": "a cat", "values": "AAAA" }] }"#,
    )
    .unwrap();
    let cases: [(&str, &[&str]); 7] = [
        ("--encode", &["--denoise", text(&latents), "--contexts", text(&contexts), "--words", "a cat"]),
        ("--contexts", &["--denoise", text(&latents), "--encode", text(&encoder), "--words", "a cat"]),
        (
            "vjp-tiny",
            &["--denoise", text(&pixels), "--encode", text(&encoder), "--word-table", text(&table), "--words", "fish"],
        ),
        (
            "5 x 16",
            &["--denoise", text(&latents), "--encode", text(&encoder), "--contexts", text(&other), "--words", "a cat"],
        ),
        (
            "\"a cat\"",
            &[
                "--denoise",
                text(&latents),
                "--encode",
                text(&encoder),
                "--contexts",
                text(&nothing),
                "--words",
                "a cat",
            ],
        ),
        ("--denoise-weight", &["--denoise", text(&pixels), "--words", "fish", "--denoise-weight", "-1"]),
        ("eps-v1", &["--denoise", text(&file), "--words", "fish"]),
    ];
    for (said, arguments) in cases {
        refused(&words_alone(&out, arguments).output().unwrap(), said);
        assert!(!out.exists(), "{said}");
    }
}

/// A contexts-v1 file of this shape, with ones for every prompt.
fn contexts_of(file: &Path, shape: [usize; 2], prompts: &[&str]) {
    // Three float32 of 1 are twelve bytes, and sixteen letters.
    let (count, rest) = (shape[0] * shape[1] / 3, ["", "AACAPw==", "AACAPwAAgD8="][shape[0] * shape[1] % 3]);
    let values = "AACAPwAAgD8AAIA/".repeat(count) + rest;
    let contexts: Vec<Value> = prompts.iter().map(|prompt| json!({ "prompt": prompt, "values": values })).collect();
    fs::write(file, json!({ "kind": "contexts-v1", "shape": shape, "contexts": contexts }).to_string()).unwrap();
}

#[test]
fn a_run_goes_on_without_a_network_that_fails_on_the_way() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    // It asks for less ink, and what little is left then is more than it can take.
    let file = crate::repository().join("tests/data/guidance/fails-later.onnx");
    let guide = ["--guide", text(&file), "--words", "a cat", "--guide-weight", "30", "--guide-look", "whole"];
    succeeds(&words_alone(&out, &guide).output().unwrap());
    let report = json(&out.join("report.json"));
    let trouble = report["guidance"]["trouble"].as_str().unwrap();
    assert!(trouble.contains("fails-later.onnx") && trouble.contains("not finite"), "{trouble}");
    let events = report["events"].as_array().unwrap();
    let at = events.iter().find(|event| event["kind"] == "unguided").unwrap()["iteration"].as_u64().unwrap();
    assert!((5..60).contains(&at), "in the middle of the run, not at {at}");
    assert!(report["time"]["iterations"] == 60 && report["stopped"] == false && report["result"]["components"] == 1);
    let widest = report["result"]["max_width"].as_f64().unwrap();
    assert!(widest.is_finite() && widest > 0.0 && out.join("front.png").is_file());
}

#[test]
fn sides_become_like_the_picture() {
    let folder = tempfile::tempdir().unwrap();
    let file = network(folder.path(), "net");
    let picture = crate::repository().join("tests/strokes/star.png");
    let made = |out: &str, more: &[&str]| {
        let out = folder.path().join(out);
        let quick = [
            "--preset",
            "fast",
            "--size",
            "64",
            "--iterations",
            "60",
            "--new-sides",
            "2",
            "--backend",
            "cpu",
            "--quiet",
        ];
        succeeds(
            &program(&[&["stroke", text(&picture), "--out", text(&out)][..], &quick, more].concat()).output().unwrap(),
        );
        (json(&out.join("report.json")), json(&out.join("wire.json")))
    };
    let guide = ["--guide", text(&file), "--like-picture", "--guide-look", "whole", "--guide-weight"];
    let weighed = |out: &str, weight: &str, more: &[&str]| made(out, &[&guide[..], &[weight], more].concat());
    let (plain, unpulled) = (made("plain", &[]), weighed("unpulled", "0", &[]));
    assert_eq!(plain.1["control_points"], unpulled.1["control_points"], "a weight of 0 changes nothing");
    let like = |report: &Value| report["guidance"]["like_picture"].as_f64().unwrap();
    assert!(unpulled.0["guidance"]["mean_cos"].is_null() && unpulled.0["guidance"]["views"] == json!([]));
    // Sides that are compared with silhouettes too, and sides that are guided alone.
    for (name, more) in [("compared", &[][..]), ("guided", &["--side-weight", "0"][..])] {
        let before = weighed(&format!("{name} before"), "0", more);
        let after = weighed(&format!("{name} after"), "100", more);
        // A network of random weights sees little difference anywhere; what there is gets less, from sides that the fit never saw.
        let off = |report: &Value| 1.0 - like(report);
        assert!(off(&after.0) < 0.8 * off(&before.0), "{name}: {:e} and {:e}", off(&after.0), off(&before.0));
        let depths = |(_, wire): &(Value, Value)| {
            let points = wire["control_points"].as_array().unwrap().iter();
            points.map(|point| point[2].as_f64().unwrap()).collect::<Vec<_>>()
        };
        let (before, after) = (depths(&before), depths(&after));
        let moved = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(before.len() != after.len() || moved > 0.01, "{name}: only sides see depth, and it moved by {moved}");
    }
    // Words of its own keep a side from the picture; without sides there is nothing to guide.
    let both = weighed("both", "1", &["--words", "front=a cat"]).0;
    assert!(both["guidance"]["views"].as_array().unwrap().len() == 1 && both["guidance"]["like_picture"].is_number());
    let alone = ["stroke", text(&picture), "--out", text(&folder.path().join("none")), "--side-views", "0", "--quiet"]
        .map(str::to_owned);
    let alone: Vec<&str> = alone.iter().map(String::as_str).chain(["--guide", text(&file), "--like-picture"]).collect();
    refused(&program(&alone).output().unwrap(), "--like-picture");
    refused(
        &words_alone(&folder.path().join("none"), &["--guide", text(&file), "--like-picture"]).output().unwrap(),
        "--like-picture",
    );
}

#[test]
fn a_model_of_new_views_pulls_the_sides_of_a_picture() {
    let folder = tempfile::tempdir().unwrap();
    let data = crate::repository().join("tests/data/guidance");
    let picture = crate::repository().join("tests/strokes/star.png");
    let [views, poses, encoder, words] =
        ["eps-views-tiny", "pose-tiny", "vjp-tiny", "eps-tiny"].map(|name| data.join(format!("{name}.onnx")));
    let run = |out: &str, more: &[&str]| {
        let out = folder.path().join(out);
        let quick = ["--preset", "fast", "--size", "64", "--iterations", "12", "--backend", "cpu", "--quiet"];
        program(&[&["stroke", text(&picture), "--out", text(&out)][..], &quick, more].concat()).output().unwrap()
    };
    let made = |out: &str, more: &[&str]| {
        succeeds(&run(out, more));
        let out = folder.path().join(out);
        (json(&out.join("report.json")), json(&out.join("wire.json"))["control_points"].clone())
    };
    let model = ["--denoise", text(&views), "--encode", text(&encoder), "--pose", text(&poses), "--new-sides", "2"];
    let weighed = |out: &str, weight: &str| made(out, &[&model[..], &["--denoise-weight", weight]].concat());
    let (unpulled, pulled) = (weighed("unpulled", "0"), weighed("pulled", "30"));
    assert_eq!(made("plain", &["--new-sides", "2"]).1, unpulled.1, "a weight of 0 changes nothing");
    assert!(pulled.1 != unpulled.1 && pulled.1 == weighed("again", "30").1);
    let told = &pulled.0["distillation"];
    assert_eq!((&told["pose"]["name"], &told["scale"]), (&json!("pose-tiny"), &json!(3.0)));
    assert!(told["trouble"].is_null() && told["views"] == json!([]));

    refused(
        &run("other", &["--denoise", text(&words), "--encode", text(&encoder), "--pose", text(&poses)]),
        "eps-tiny",
    );
    refused(&run("pixels", &["--denoise", text(&views), "--pose", text(&poses)]), "--encode");
    refused(&run("words", &["--denoise", text(&views), "--encode", text(&encoder), "--words", "a cat"]), "--pose");
}
