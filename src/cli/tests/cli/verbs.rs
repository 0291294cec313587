//! The command line on real pictures and on bad input, as a person would use it.
use crate::notice::not_tested;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn drawing(set: &str, view: &str) -> PathBuf {
    crate::repository().join("tests/drawings").join(set).join(format!("{view}.png"))
}

fn wire4d(arguments: &[&str]) -> Output {
    program(arguments).output().unwrap()
}

pub fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_wire4d"));
    command.args(arguments);
    command
}

pub fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// A quick run on a pair; the flags keep it under a few seconds.
pub fn quick_run(out: &Path, more: &[&str]) -> Output {
    quick(out, more).output().unwrap()
}

pub fn quick(out: &Path, more: &[&str]) -> Command {
    let (front, side) = (drawing("p05-tools", "front"), drawing("p05-tools", "side"));
    let mut arguments = vec!["multiview", text(&front), text(&side), "--out", text(out)];
    arguments.extend(["--preset", "fast", "--size", "96", "--iterations", "60", "--grid", "32"]);
    arguments.extend(more);
    program(&arguments)
}

pub fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

#[track_caller]
pub fn succeeds(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap().trim().to_owned()
}

/// Status 2 and one line that names the input.
#[track_caller]
pub fn refused(output: &Output, names: &str) {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert_eq!(stderr.trim().lines().count(), 1, "{stderr}");
    assert!(stderr.contains(names), "{stderr:?} does not name {names:?}");
    assert!(stderr.contains(';'), "{stderr:?} does not say what to do");
    assert!(output.stdout.is_empty());
}

#[test]
fn a_run_writes_everything_and_every_verb_reads_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    assert_eq!(succeeds(&quick_run(&out, &["--bend", "little"])), out.join("report.json").display().to_string());
    for name in ["wire.json", "wire.glb", "loss.csv", "front.png", "side-target.png", "front-bent.png"] {
        assert!(out.join(name).is_file(), "{name} is missing");
    }

    let report = json(&out.join("report.json"));
    assert_eq!(
        (&report["task"], &report["stopped"], &report["time"]["iterations"]),
        (&"multiview".into(), &false.into(), &60.into())
    );
    let views = report["result"]["views"].as_array().unwrap();
    assert_eq!(views.len(), 2);
    for view in views {
        assert!(view["bent"]["soft_iou"].as_f64().unwrap() > 0.5, "{view}");
        assert!(view["target_coverable"].as_f64().unwrap() > 0.9, "{view}");
    }
    assert_eq!(report["result"]["components"], 1);
    let loss = fs::read_to_string(out.join("loss.csv")).unwrap();
    let totals: Vec<f64> = loss.lines().skip(1).map(|line| line.split(',').nth(1).unwrap().parse().unwrap()).collect();
    assert_eq!(totals.len(), 60);
    assert!(totals[59] < totals[48], "the loss of the last stage falls");

    let wire = out.join("wire.json");
    let rendered = folder.path().join("front.png");
    succeeds(&wire4d(&["render", text(&wire), "--view", "front", "--size", "96", "--out", text(&rendered)]));
    assert_eq!(fs::read(&rendered).unwrap(), fs::read(out.join("front.png")).unwrap());

    let target = out.join("front-target.png");
    let metrics = succeeds(&wire4d(&["metrics", text(&wire), "--targets", text(&target)]));
    let metrics: Value = serde_json::from_str(&metrics).unwrap();
    let elegance = ["turning_per_unit", "kinks", "tight_share", "touching_share", "penetrating_share"];
    for figure in ["components", "length", "control_points", "min_width"].into_iter().chain(elegance) {
        assert!(metrics[figure].is_number(), "{figure}");
        assert_eq!(metrics[figure], report["result"][figure], "{figure}");
    }
    // One of the two views' lines are about half of all; both drawings moved a little.
    let [one, both] = [&metrics, &report["result"]].map(|result| result["length_over_lines"].as_f64().unwrap());
    assert!((1.2..4.0).contains(&(one / both)) && both > 0.5, "{one} {both}");
    let again = metrics["views"][0]["soft_iou"].as_f64().unwrap();
    assert!((again - views[0]["soft_iou"].as_f64().unwrap()).abs() < 0.02, "{again}");

    for ending in ["glb", "stl", "obj", "svg", "bend.csv", "wire.json"] {
        let file = folder.path().join(format!("wire.{ending}"));
        succeeds(&wire4d(&["export", text(&wire), "--to", text(&file)]));
        assert!(fs::metadata(&file).unwrap().len() > 100, "{ending}");
    }
    let code = succeeds(&wire4d(&["share", text(&wire)]));
    let opened = folder.path().join("opened.json");
    succeeds(&wire4d(&["open", &code, "--out", text(&opened)]));
    let length = |path: &Path| {
        let metrics: Value = serde_json::from_str(&succeeds(&wire4d(&["metrics", text(path)]))).unwrap();
        metrics["length"].as_f64().unwrap()
    };
    assert!((length(&wire) - length(&opened)).abs() < 0.02 * length(&wire));
    // Any file that carries the wire opens, with what it was made of, and stands for it.
    let drawings = |path: &Path| json(path)["drawings"].as_array().unwrap().clone();
    assert_eq!(
        drawings(&wire).iter().map(|drawing| drawing["view"].as_str().unwrap()).collect::<Vec<_>>(),
        ["front", "side"]
    );
    for ending in ["glb", "svg"] {
        let file = folder.path().join(format!("wire.{ending}"));
        succeeds(&wire4d(&["open", text(&file), "--out", text(&opened)]));
        assert_eq!(drawings(&opened), drawings(&wire), "{ending}");
        assert_eq!(json(&opened)["made_with"], json(&wire)["made_with"], "{ending}");
        assert_eq!(succeeds(&wire4d(&["share", text(&file)])), code, "{ending}");
    }
    refused(&wire4d(&["open", text(&folder.path().join("wire.stl")), "--out", text(&opened)]), "wire.stl");
    refused(&wire4d(&["open", "missing.png", "--out", text(&opened)]), "missing.png");
    succeeds(&wire4d(&["device"]));
}

#[test]
fn the_same_seed_gives_the_same_wire_and_another_run_touches_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (folder.path().join("a"), folder.path().join("b"));
    succeeds(&quick_run(&a, &[]));
    succeeds(&quick_run(&b, &[]));
    assert_eq!(fs::read(a.join("wire.json")).unwrap(), fs::read(b.join("wire.json")).unwrap());

    let before = fs::read(a.join("report.json")).unwrap();
    refused(&quick_run(&a, &[]), text(&a));
    assert_eq!(fs::read(a.join("report.json")).unwrap(), before);
    succeeds(&quick_run(&a, &["--overwrite", "--iterations", "61"]));
    assert_ne!(fs::read(a.join("wire.json")).unwrap(), fs::read(b.join("wire.json")).unwrap());
}

#[test]
fn views_from_other_directions_are_shown_too() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let placed = format!("{}@45,10", text(&drawing("t07-outlines", "front")));
    succeeds(&quick_run(&out, &["--view", &placed, "--bend", "none"]));
    let report = json(&out.join("report.json"));
    let names: Vec<_> = report["result"]["views"].as_array().unwrap().iter().map(|view| &view["name"]).collect();
    assert_eq!(names, ["front", "side", "45,10"]);
    assert!(out.join("45,10.png").is_file());
}

#[test]
fn any_number_of_threads_gives_the_same_wire() {
    let folder = tempfile::tempdir().unwrap();
    let made = |threads: &str, more: &[&str]| {
        let out = folder.path().join(format!("{threads}-{}", more.len()));
        let run = [&["--size", "64", "--iterations", "40", "--bend", "little"], more].concat();
        succeeds(&quick(&out, &run).env("RAYON_NUM_THREADS", threads).output().unwrap());
        fs::read(out.join("wire.json")).unwrap()
    };
    let one = made("1", &[]);
    assert!(one == made("2", &[]) && one == made("5", &[]));
    assert!(one != made("2", &["--smoothness", "1.001"]), "the check would not see a difference");
}

#[test]
fn every_start_form_and_preset_runs() {
    let folder = tempfile::tempdir().unwrap();
    for (setting, more) in [
        ("preset", ["--preset", "paper"]),
        ("start", ["--start", "hull"]),
        ("start", ["--start", "ball"]),
        ("form", ["--form", "chain"]),
        ("form", ["--form", "bag"]),
    ] {
        let out = folder.path().join(more[1]);
        succeeds(&quick_run(&out, &[&more[..], &["--iterations", "20", "--size", "64"]].concat()));
        let report = json(&out.join("report.json"));
        assert_eq!((&report["settings"][setting], &report["time"]["iterations"]), (&more[1].into(), &20.into()));
        let views = report["result"]["views"].as_array().unwrap();
        assert!(views.iter().all(|view| view["soft_iou"].as_f64().unwrap() > 0.0), "{more:?}");
        // Loose Béziers may fall apart; everything else is one wire.
        let components = report["result"]["components"].as_u64().unwrap();
        assert!(components == 1 || more[1] == "bag" && components > 1, "{more:?}: {components} parts");
        succeeds(&wire4d(&["metrics", text(&out.join("wire.json"))]));
    }
}

#[test]
fn a_wire_is_shown_from_anywhere_and_compared_with_no_more_pictures_than_views() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    succeeds(&quick_run(&out, &["--size", "64", "--iterations", "10"]));
    let wire = out.join("wire.json");
    let shown = |view: &str| {
        let file = folder.path().join(format!("{view}.png"));
        let size = ["--size", "50", "--out", text(&file)];
        succeeds(&wire4d(&[&["render", text(&wire), "--view", view], &size[..]].concat()));
        let image::DynamicImage::ImageLuma16(picture) = image::open(&file).unwrap() else { panic!("16-bit grey") };
        assert_eq!(picture.dimensions(), (50, 50));
        assert!(picture.pixels().any(|level| level[0] > 30_000), "{view}: there is ink");
        picture
    };
    let oblique = shown("30,20");
    assert!(oblique != shown("front") && oblique != shown("-30,20"));
    assert!(shown("0,0") == shown("front"));
    for view in ["30", "30,20,10", "30,95", "behind"] {
        let file = folder.path().join("none.png");
        refused(&wire4d(&["render", text(&wire), "--view", view, "--out", text(&file)]), view);
        assert!(!file.exists());
    }

    let target = out.join("front-target.png");
    let metrics = |count: usize| {
        let targets = vec![text(&target); count];
        wire4d(&[&["metrics", text(&wire), "--targets"], &targets[..]].concat())
    };
    succeeds(&metrics(2));
    refused(&metrics(3), "--targets");
}

#[test]
fn a_folder_of_other_things_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("mine.txt");
    fs::write(&mine, "mine").unwrap();
    for more in [&[][..], &["--overwrite"]] {
        refused(&quick_run(folder.path(), more), text(folder.path()));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    }
}

#[test]
fn drawings_that_share_nothing_are_refused() {
    // Two blocks on a diagonal in front and side leave two cubes; of the two diagonals a top may show, one misses both.
    let folder = tempfile::tempdir().unwrap();
    let picture = |name: &str, mirrored: bool| {
        let file = folder.path().join(name);
        grey(&file, 64, |x, y| if ((x < 32) == (y < 32)) != mirrored { 0 } else { 255 });
        file
    };
    let (falling, rising) = (picture("falling.png", false), picture("rising.png", true));
    let run = |top: &Path, arrange: &str| {
        let out = folder.path().join("out");
        let _ = fs::remove_dir_all(&out);
        let pictures = ["multiview", text(&falling), text(&falling), text(top), "--out", text(&out)];
        let quick = ["--preset", "fast", "--size", "64", "--iterations", "2", "--grid", "16", "--arrange", arrange];
        wire4d(&[&pictures[..], &quick].concat())
    };
    refused(&run(&falling, "off"), "no ink at a common height");
    succeeds(&run(&rising, "off"));
    succeeds(&run(&falling, "on"));
}

#[test]
fn a_mesh_is_covered_with_everything_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let corners = (0..8).map(|i| format!("v {} {} {}\n", i & 1, i >> 1 & 1, i >> 2)).collect::<String>();
    let faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"].map(|face| format!("f {face}\n"));
    fs::write(at("box.obj"), corners + &faces.concat()).unwrap();
    grey(&at("dots.png"), 64, |x, y| if (x % 16).pow(2) + (y % 16).pow(2) < 100 { 0 } else { 255 });
    let fill = |mesh: &str, out: &str, more: &[&str]| {
        let out = at(out);
        let quick = ["--curve-spacing", "0.2", "--size", "96", "--iterations", "4", "--seed", "3"];
        wire4d(&[&["fill", mesh, "--out", text(&out)], &quick[..], more].concat())
    };
    let printed = succeeds(&fill(text(&at("box.obj")), "box", &[]));
    assert_eq!(printed, text(&at("box").join("report.json")));
    let report = json(&at("box").join("report.json"));
    assert_eq!((&report["task"], &report["seed"], &report["stopped"]), (&"fill".into(), &3.into(), &false.into()));
    assert_eq!(report["result"]["views"].as_array().unwrap().len(), 5);
    let surface = &report["result"]["surface"];
    assert!(surface["mean"].as_f64().is_some_and(|mean| (0.2..0.4).contains(&mean)), "{surface}");
    assert_eq!(report["result"]["components"], 1);
    for name in ["wire.json", "wire.glb", "loss.csv", "front.png", "front-target.png"] {
        assert!(at("box").join(name).exists(), "{name}");
    }
    succeeds(&fill(text(&at("box.obj")), "again", &[]));
    let wire = |out: &str| json(&at(out).join("wire.json"))["control_points"].clone();
    assert_eq!(wire("box"), wire("again"));
    let dots = at("dots.png");
    for (name, more) in
        [("dots", ["--style", text(&dots)]), ("waves", ["--style", "waves"]), ("along", ["--flow", "along"])]
    {
        succeeds(&fill(text(&at("box.obj")), name, &more));
        assert_ne!(wire("box"), wire(name), "{name}");
    }
    succeeds(&fill("torus", "torus", &["--visibility-bias", "0.1"]));
    // What the torus hides is left out of pictures of its wire.
    let torus = at("torus").join("wire.json");
    let drawn = |name: &str, more: &[&str]| {
        succeeds(&wire4d(&[&["export", text(&torus), "--to", text(&at(name))], more].concat()));
        fs::metadata(at(name)).unwrap().len()
    };
    let all = drawn("all.svg", &[]);
    assert!(drawn("seen.svg", &["--covers", "torus"]) < all * 9 / 10);
    let ink = |name: &str, more: &[&str]| {
        succeeds(&wire4d(&[&["render", text(&torus), "--out", text(&at(name))], more].concat()));
        let picture = image::open(at(name)).unwrap().to_luma16();
        picture.pixels().map(|pixel| u64::from(pixel.0[0])).sum::<u64>()
    };
    assert!(ink("seen.png", &["--covers", "torus", "--size", "96"]) < ink("all.png", &["--size", "96"]) * 9 / 10);
    // As the run itself showed it.
    assert_eq!(fs::read(at("seen.png")).unwrap(), fs::read(at("torus").join("front.png")).unwrap());
    refused(&wire4d(&["export", text(&torus), "--to", text(&at("bad.glb")), "--covers", "torus"]), "write an .svg");
    let strange = wire4d(&["export", text(&torus), "--to", text(&at("bad.svg")), "--covers", "teapot"]);
    refused(&strange, "give a mesh or sphere");
    // A flag that takes one word only is no choice, and not offered.
    let help = succeeds(&wire4d(&["fill", "--help"]));
    assert!(help.contains("--flow <smooth|along") && !help.contains("--bend <"), "{help}");
    refused(&fill("teapot", "bad", &[]), "give a mesh or sphere, torus, knot, vase, creature");
    refused(&fill("torus", "bad", &["--style", "plaid"]), "petals");
    refused(&fill("torus", "bad", &["--up", "z"]), "--up");
    refused(&fill(text(&at("box.obj")), "bad", &["--up", "x"]), "--up");
    refused(&fill("torus", "bad", &["--style", text(&at("nowhere.png"))]), "nowhere.png");
    refused(&fill("torus", "bad", &["--curve-spacing", "0.001"]), "curve_spacing");
    refused(&fill(text(&at("dots.png")), "bad", &[]), "dots.png");
    assert!(!at("bad").exists());
}

#[test]
fn one_picture_becomes_a_stroke_with_everything_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let disc = |x: u32, y: u32| (f64::from(x) - 31.5).hypot(f64::from(y) - 31.5) < 20.0;
    grey(&at("ball.png"), 64, |x, y| if disc(x, y) { (60 + 2 * y) as u8 } else { 255 });
    grey(&at("mask.png"), 64, |x, y| if disc(x, y) && y < 40 { 255 } else { 0 });
    grey(&at("near.png"), 64, |x, _| (4 * x) as u8);
    let stroke = |out: &str, more: &[&str]| {
        let (ball, out) = (at("ball.png"), at(out));
        let quick = [
            "stroke",
            text(&ball),
            "--out",
            text(&out),
            "--preset",
            "fast",
            "--size",
            "64",
            "--iterations",
            "2",
            "--seed",
            "3",
        ];
        wire4d(&[&quick[..], more].concat())
    };
    let printed = succeeds(&stroke("plain", &[]));
    assert_eq!(printed, text(&at("plain").join("report.json")));
    let report = json(&at("plain").join("report.json"));
    assert_eq!((&report["task"], &report["seed"], &report["stopped"]), (&"stroke".into(), &3.into(), &false.into()));
    assert_eq!(report["settings"]["iterations"], 2);
    assert_eq!(report["result"]["views"][0]["name"], "front");
    for name in ["wire.json", "wire.glb", "loss.csv", "front.png", "front-target.png"] {
        assert!(at("plain").join(name).exists(), "{name}");
    }
    succeeds(&stroke("again", &[]));
    let wire = |out: &str| json(&at(out).join("wire.json"))["control_points"].clone();
    assert_eq!(wire("plain"), wire("again"));
    // What else is given about the object changes the wire.
    let (mask, near) = (at("mask.png"), at("near.png"));
    let side = format!("{}@90,0", text(&at("mask.png")));
    for (name, more) in
        [("mask", ["--mask", text(&mask)]), ("depth", ["--depth", text(&near)]), ("view", ["--view", &side])]
    {
        succeeds(&stroke(name, &more));
        assert_ne!(wire("plain"), wire(name), "{name}");
    }
    refused(&stroke("bad", &["--may-swap"]), "--may-swap");
    refused(&stroke("bad", &["--depth", text(&at("nowhere.png"))]), "nowhere.png");
    refused(&stroke("bad", &["--set", "grid"]), "grid");
    grey(&at("inverse.png"), 64, |x, y| if disc(x, y) { 0 } else { 255 });
    refused(&stroke("bad", &["--mask", text(&at("inverse.png"))]), "a mask that is white on the object");
    assert!(!at("bad").exists());
}

#[test]
fn marks_say_which_thing_is_meant_and_bad_ones_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let disc = |x: u32, y: u32, cx: f64, r: f64| (f64::from(x) - cx).hypot(f64::from(y) - 31.5) < r;
    grey(&at("two.png"), 64, |x, y| if disc(x, y, 20.0, 14.0) || disc(x, y, 50.0, 8.0) { 40 } else { 230 });
    let stroke = |out: &str, more: &[&str]| {
        let (two, out) = (at("two.png"), at(out));
        let quick =
            ["stroke", text(&two), "--out", text(&out), "--preset", "fast", "--size", "64", "--iterations", "1"];
        wire4d(&[&quick[..], more].concat())
    };
    let is_object =
        |out: &str, x: u32| image::open(at(out).join("mask.png")).unwrap().to_luma8().get_pixel(x, 32)[0] > 127;
    succeeds(&stroke(
        "marked",
        &["--mark-object", "49,30,51,34", "--mark-object", "50,32", "--mark-ground", "20,20,20,44"],
    ));
    assert!(is_object("marked", 50) && !is_object("marked", 20));
    succeeds(&stroke("boxed", &["--box", "1,10,62,44", "--mark-ground", "47,32,53,32"]));
    assert!(is_object("boxed", 20) && !is_object("boxed", 50));
    for (more, name, word) in [
        (&["--mark-object", "1,2,3"][..], "mark-object", "3 numbers"),
        (&["--mark-ground", "1,two"], "mark-ground", "give X,Y,X,Y"),
        (&["--mark-ground", ""], "mark-ground", "give X,Y,X,Y"),
        (&["--mark-object", "70,10"], "mark-object", "stay within 64 x 64"),
        (&["--mark-object", "-1,10"], "mark-object", "outside the picture"),
        (&["--mark-object", "20,32", "--mark-ground", "20,32"], "mark-object", "undo one"),
        (&["--mark-object", "50,32", "--box", "2,10,30,40"], "mark-object", "outside the box"),
    ] {
        let output = stroke("bad", more);
        refused(&output, name);
        refused(&output, word);
    }
    assert!(!at("bad").exists());
}

#[test]
fn a_raster_scene_is_drawn_compared_and_timed() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let scene = |name: &str, y: f64| {
        let points = [[4.0, 20.0 + y], [4.0, 4.0 + y], [28.0, 4.0 + y], [28.0, 20.0 + y]];
        let scene = serde_json::json!({
            "bezier_points": points, "bezier_radius": [1.0, 2.0, 2.0, 0.5], "closed": false, "size": 32,
        });
        fs::write(at(name), scene.to_string()).unwrap();
    };
    scene("here.json", 0.0);
    scene("lower.json", 1.0);
    let draw = |name: &str, more: &[&str]| succeeds(&wire4d(&[&["raster", text(&at(name))], more].concat()));
    let (lower, grad) = (at("lower.npy"), at("grad.json"));
    assert_eq!(draw("lower.json", &["--out", text(&lower)]), "", "nothing to print without --repeat");
    let bytes = fs::read(&lower).unwrap();
    assert!(bytes.starts_with(b"\x93NUMPY") && bytes.len() > 4 * 32 * 32);

    let compare = ["--target", text(&lower), "--grad", text(&grad)];
    let line = draw("here.json", &[&compare[..], &["--repeat", "3", "--backend", "cpu"]].concat());
    let timing: Value = serde_json::from_str(&line).unwrap();
    assert_eq!(keys(&timing), ["backend", "backward_ms", "forward_ms", "scene"]);
    assert_eq!((&timing["scene"], &timing["backend"]), (&"here".into(), &"cpu".into()));
    assert!(timing["forward_ms"].as_f64().unwrap() > 0.0 && timing["backward_ms"].as_f64().unwrap() > 0.0);
    let found = json(&grad);
    assert_eq!(keys(&found), ["d_points", "d_radius", "loss"]);
    assert!(found["loss"].as_f64().unwrap() > 1e-3);
    let d_points = found["d_points"].as_array().unwrap();
    let down: f64 = d_points.iter().map(|d| d.as_array().unwrap()[1].as_f64().unwrap()).sum();
    assert!(d_points.len() == 4 && down < 0.0, "the loss falls on the way down to the target: {down}");
    assert_eq!(found["d_radius"].as_array().unwrap().len(), 4);

    // The same on a device, if there is one.
    let on_device =
        wire4d(&[&["raster", text(&at("here.json"))], &compare[..], &["--repeat", "1", "--backend", "gpu"]].concat());
    if on_device.status.success() {
        assert!(succeeds(&on_device).contains(r#""backend":"gpu""#));
        let device = json(&grad);
        let apart = |key: &str| (device[key].as_f64().unwrap() / found[key].as_f64().unwrap() - 1.0).abs();
        assert!(apart("loss") < 1e-2, "{device} {found}");
        let moved = device["d_points"][1][1].as_f64().unwrap() / found["d_points"][1][1].as_f64().unwrap();
        assert!((moved - 1.0).abs() < 0.05, "{device} {found}");
    } else {
        let message = String::from_utf8_lossy(&on_device.stderr);
        assert!(std::env::var_os("WIRE4D_REQUIRE_GPU").is_none() && message.contains("Vulkan"), "{message}");
        not_tested("`wire4d raster` on a graphics device: there is none");
    }

    draw("lower.json", &compare);
    assert!(json(&grad)["loss"].as_f64().unwrap() < 1e-12, "sibling: nothing to mend");
    refused(&wire4d(&["raster", text(&at("here.json")), "--grad", text(&grad)]), "--grad");
}

fn keys(object: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = object.as_object().unwrap().keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_the_run_and_keeps_what_there_is() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("made");
    let (front, side) = (drawing("p05-tools", "front"), drawing("p05-tools", "side"));
    let run = Command::new(env!("CARGO_BIN_EXE_wire4d"))
        .args(["multiview", text(&front), text(&side), "--out", text(&out), "--iterations", "100000", "--quiet"])
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_secs(4));
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    succeeds(&run.wait_with_output().unwrap());
    let report = json(&out.join("report.json"));
    assert_eq!(report["stopped"], true);
    assert!(report["time"]["iterations"].as_u64().unwrap() < 100_000);
    assert!(out.join("wire.json").is_file());
}

#[test]
fn bad_input_is_refused_in_one_line_and_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let good = fs::read(drawing("p05-tools", "front")).unwrap();
    fs::write(at("notes.png"), "this is no picture").unwrap();
    fs::write(at("cut.png"), &good[..good.len() / 2]).unwrap();
    fs::write(at("empty.png"), "").unwrap();
    grey(&at("blank.png"), 64, |_, _| 255);
    grey(&at("full.png"), 64, |_, _| 0);
    grey(&at("dot.png"), 64, |x, y| if (x, y) == (30, 30) { 0 } else { 255 });
    let (front, side) = (drawing("p05-tools", "front"), drawing("p05-tools", "side"));
    let out = at("out");
    let run = |pictures: &[&Path], more: &[&str]| {
        let mut arguments = vec!["multiview"];
        arguments.extend(pictures.iter().map(|path| text(path)));
        arguments.extend(["--out", text(&out)]);
        arguments.extend(more);
        wire4d(&arguments)
    };
    for name in ["notes.png", "cut.png", "empty.png", "blank.png", "full.png", "dot.png", "missing.png"] {
        refused(&run(&[&front, &at(name)], &[]), name);
    }
    refused(&run(&[&front, folder.path()], &[]), text(folder.path()));
    refused(&run(&[&front], &[]), "1 picture");
    refused(&run(&[&front, &side], &["--control-points", "3"]), "control_points");
    refused(&run(&[&front, &side], &["--control-points", "20001"]), "control_points");
    refused(&run(&[&front, &side], &["--iterations", "many"]), "iterations");
    refused(&run(&[&front, &side], &["--set", "wobble=3"]), "wobble");
    refused(&run(&[&front, &side], &["--set", "wobble"]), "wobble");
    refused(&run(&[&front, &side], &["--min-width", "NaN"]), "min_width");
    refused(&run(&[&front, &side], &["--min-width", "8", "--max-width", "2"]), "min_width");
    refused(&run(&[&front, &side], &["--bend", "lots"]), "bend");
    refused(&run(&[&front, &side], &["--frobnicate"]), "--frobnicate");
    refused(&run(&[&front, &side], &["--view", "x.png"]), "x.png");
    refused(&run(&[&front, &side], &["--view", "x.png@1,2"]), "x.png");
    refused(&run(&[&front, &side], &["--backend", "quantum"]), "backend");
    refused(&wire4d(&["multiview", text(&front), text(&side), "--out", "/proc/nowhere/out"]), "/proc/nowhere/out");
    fs::write(at("file"), "mine").unwrap();
    refused(&wire4d(&["multiview", text(&front), text(&side), "--out", text(&at("file"))]), "file");
    assert_eq!(fs::read_to_string(at("file")).unwrap(), "mine");

    fs::write(at("foreign.json"), r#"{"format": "other"}"#).unwrap();
    fs::write(at("broken.json"), "{").unwrap();
    for name in ["foreign.json", "broken.json", "none.json", "blank.png"] {
        refused(&wire4d(&["metrics", text(&at(name))]), name);
        refused(&wire4d(&["render", text(&at(name)), "--out", text(&at("r.png"))]), name);
        refused(&wire4d(&["export", text(&at(name)), "--to", text(&at("r.glb"))]), name);
    }
    for code in ["", "x", "AAAA", "!!!!", &"A".repeat(5000)] {
        refused(&wire4d(&["open", code, "--out", text(&at("o.json"))]), "share code");
    }
    refused(&wire4d(&["raster", text(&at("foreign.json"))]), "foreign.json");

    let mut left: Vec<_> = fs::read_dir(folder.path()).unwrap().flatten().map(|entry| entry.file_name()).collect();
    left.sort();
    let made = [
        "blank.png",
        "broken.json",
        "cut.png",
        "dot.png",
        "empty.png",
        "file",
        "foreign.json",
        "full.png",
        "notes.png",
    ];
    assert_eq!(left, made, "nothing was left behind");
}

#[test]
fn a_fit_on_a_device_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    // Without a driver there is no card: asked for that fails, left open the processor does it.
    let bare = |mut program: Command| program.env("VK_DRIVER_FILES", "/dev/null").output().unwrap();
    assert!(succeeds(&bare(program(&["device"]))).contains("backend: gpu, none"));
    let output = bare(quick(&at("none"), &["--backend", "gpu"]));
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(
        message.contains("no graphics card with a Vulkan driver") && message.contains("--backend cpu"),
        "{message}"
    );
    succeeds(&bare(quick(&at("left-open"), &["--backend", "auto"])));
    assert_eq!(json(&at("left-open").join("report.json"))["backend"], "cpu");

    let device = succeeds(&program(&["device"]).output().unwrap());
    if device.contains("software") {
        assert!(device.contains("auto: cpu, The only graphics device here is a program"), "{device}");
    }
    if device.contains("backend: gpu, none") {
        assert!(std::env::var_os("WIRE4D_REQUIRE_GPU").is_none(), "{device}");
        return not_tested("fits on a graphics device: `wire4d device` found none");
    }
    assert_eq!(device.matches("self-check: passed").count(), 2, "{device}");
    succeeds(&quick(&at("device"), &["--backend", "gpu"]).output().unwrap());
    let report = json(&at("device").join("report.json"));
    assert_eq!(report["backend"], "gpu");
    assert!(device.contains(report["device"].as_str().unwrap()), "{device}");
    let iou = |report: &Value| report["result"]["views"][0]["soft_iou"].as_f64().unwrap();
    let processor = iou(&json(&at("left-open").join("report.json")));
    assert!((iou(&report) - processor).abs() < 0.1, "{} on the device, {processor} on the processor", iou(&report));
}

fn grey(path: &Path, size: u32, value: impl Fn(u32, u32) -> u8) {
    image::GrayImage::from_fn(size, size, |x, y| image::Luma([value(x, y)])).save(path).unwrap();
}
