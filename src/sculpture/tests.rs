use super::*;
use crate::Error;
use crate::few_cases::few_cases;
use crate::rng::Rng;
use proptest::prelude::*;

fn sculpture(seed: u64, count: usize, closed: bool) -> Sculpture {
    let mut rng = Rng::new(seed, 1);
    let control_points: Vec<[f64; 4]> = (0..count)
        .map(|_| {
            let [x, y, z] = rng.in_ball(1.0);
            [x, y, z, rng.range(0.0, 0.05)]
        })
        .collect();
    let wire = if closed { Wire::closed_uniform(control_points) } else { Wire::open_uniform(control_points) };
    let mut views = View::canonical(2.2, 256).to_vec();
    views.push(View {
        name: "mine".into(),
        projection: crate::view::Projection::Perspective { fov_y_rad: 0.7 },
        eye: [1.0, 2.0, 3.0],
        ..View::orthographic("", 0.0, 0.0, 1.0, 64)
    });
    let made_with = MadeWith { task: "multiview".into(), seed, ..MadeWith::default() };
    Sculpture { wire: wire.unwrap(), views, made_with, carried: Carried::default() }
}

fn problem(text: &str) -> String {
    let error = Sculpture::from_json("it.json", text.as_bytes()).unwrap_err();
    assert!(matches!(error, Error::Wire { .. }), "{error:?}");
    let line = error.to_string();
    assert!(line.starts_with("it.json: ") && !line.contains('\n'), "{line}");
    line
}

#[test]
fn json_round_trip_is_exact() {
    for closed in [false, true] {
        let before = sculpture(3, 50, closed);
        let text = before.to_json();
        let after = Sculpture::from_json("wire.json", text.as_bytes()).unwrap();
        assert_eq!(before, after);
        assert_ne!(sculpture(4, 50, closed), after);
    }
}

#[test]
fn json_has_the_fields_of_the_contract() {
    let value: serde_json::Value = serde_json::from_str(&sculpture(1, 9, false).to_json()).unwrap();
    let keys = |value: &serde_json::Value| value.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    let mut expected = vec!["format", "version", "closed", "knots", "control_points", "views", "made_with"];
    expected.sort();
    assert_eq!(keys(&value), expected);
    assert_eq!(keys(&value["made_with"]), ["seed", "settings", "task", "wire4d"]);
    let mut view = vec!["name", "projection", "eye", "target", "up", "height_world", "width_px", "height_px"];
    view.sort();
    assert_eq!(keys(&value["views"][0]), view);
    assert!(value["views"][3]["fov_y_rad"].is_f64() && value["views"][3]["projection"] == "perspective");
    assert_eq!(value["knots"].as_array().unwrap().len(), 9 + 4);
}

#[test]
fn bad_files_get_a_plain_sentence() {
    let good = sculpture(1, 6, false).to_json();
    assert!(problem("").contains("JSON"));
    assert!(problem("{}").contains("format"));
    assert!(problem("[1, 2]").contains("format"));
    assert!(problem(&good.replace("\"wire4d\",\"version\":1", "\"gltf\",\"version\":1")).contains("format"));
    assert!(problem(&good.replace("\"version\":1", "\"version\":2")).contains("update Wire4D"));
    assert!(problem(&good.replace("\"version\":1", "\"version\":-1")).contains("version"));
    assert!(problem(&good.replace("\"knots\":[0.0", "\"knots\":[1e999")).contains("number out of range"));
    assert!(problem(&good.replace("\"knots\":[0.0", "\"knots\":[NaN")).contains("JSON"));
    assert!(problem(&good.replace("\"knots\":[0.0,", "\"knots\":[")).contains("knots"));
    assert!(problem(&good.replace("\"control_points\":[[", "\"control_points\":[[1e300,0,0,0],[")).contains("knots"));
    assert!(problem(&good.replace("\"up\":[-0.0,1.0", "\"up\":[-0.0,0.0")).contains("up along"));
    assert!(problem(&good.replace("\"width_px\":256", "\"width_px\":0")).contains("impossible size"));
    assert!(problem(&good.replace("\"width_px\":256", "\"width_px\":1e9")).contains("does not describe"));
    assert!(problem(&good[..good.len() / 2]).contains("JSON"));
    assert!(problem(&"[".repeat(100_000)).contains("JSON"));
    assert!(problem(&" ".repeat(MAX_FILE_BYTES + 1)).contains("more than any wire"));
    assert!(Sculpture::from_json("it.json", good.as_bytes()).is_ok(), "the sibling that must pass");
}

#[test]
fn strands_follow_the_curve() {
    let wire = sculpture(5, 12, false).wire;
    let [strand] = &strands(&wire, 4)[..] else { panic!("one strand") };
    for (point, t) in strand.points.iter().zip(wire.sample_parameters(4)) {
        let exact = wire.evaluate(t);
        assert!((0..4).all(|c| (point[c] - exact[c]).abs() < 1e-12));
    }
    assert!(!strand.closed && strands(&sculpture(5, 12, true).wire, 4)[0].closed);
}

#[test]
fn rendering_shows_the_wire_where_it_is() {
    let straight = |y: f64| Wire::open_uniform((0..4).map(|i| [-0.6 + 0.4 * i as f64, y, 0.0, 0.1]).collect()).unwrap();
    let view = View::orthographic("front", 0.0, 0.0, 2.0, 100);
    let image = render(&straight(0.5), &view);
    assert!(image.at(50, 25) > 0.99 && image.at(50, 75) < 0.01, "world y points up, picture y down");
    assert!(render(&straight(-0.5), &view).at(50, 75) > 0.99);
    let area: f32 = image.data.iter().sum();
    let exact = 60.0 * 5.0 + std::f32::consts::PI * 2.5 * 2.5;
    assert!((area / exact - 1.0).abs() < 1e-3, "{area} {exact}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..few_cases() })]
    #[test]
    fn any_bytes_are_survived(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(Sculpture::from_json("x", &bytes).is_err());
    }

    #[test]
    fn damaged_files_are_survived(at in 0usize..2000, byte in any::<u8>()) {
        let mut bytes = sculpture(1, 6, false).to_json().into_bytes();
        let at = at % bytes.len();
        bytes[at] = byte;
        if let Ok(sculpture) = Sculpture::from_json("x", &bytes) {
            prop_assert!(sculpture.wire.control_points().iter().flatten().all(|c| c.is_finite()));
        }
    }
}
