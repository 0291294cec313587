//! Figures of how wires run, against those that another program found by the same definitions.

use wire4d::metrics::elegance;
use wire4d::sculpture::Sculpture;
use wire4d::wire::Wire;

fn wire(name: &str) -> Wire {
    let path = format!("{}/tests/wires/{name}.json", env!("CARGO_MANIFEST_DIR"));
    Sculpture::from_json(name, &std::fs::read(path).unwrap()).unwrap().wire
}

#[test]
fn figures_are_those_of_another_program() {
    #[rustfmt::skip]
    let expected = [
        ("smooth", 1.696559,  0,   0.0,      0.0,      0.0),
        ("kinked", 1.032846,  6,   0.010540, 0.0,      0.0),
        ("coil",   1.643733,  0,   0.0,      0.962487, 0.0),
        ("knot",   1.616703,  0,   0.0,      0.0,      0.122177),
        ("chain",  5.736340,  8,   0.024279, 0.0,      0.0),
        ("bag",    2.545239,  12,  0.014960, 0.052913, 0.196117),
        ("fitted", 16.536654, 142, 0.106184, 0.083155, 0.421548),
    ];
    for (name, turning_per_unit, kinks, tight_share, touching_share, penetrating_share) in expected {
        let (found, _) = elegance(&wire(name));
        assert!((found.turning_per_unit / turning_per_unit - 1.0).abs() < 5e-3, "{name}: {found:?}");
        assert_eq!(found.kinks, kinks, "{name}: {found:?}");
        for (found_share, share) in [
            (found.tight_share, tight_share),
            (found.touching_share, touching_share),
            (found.penetrating_share, penetrating_share),
        ] {
            assert!((found_share - share).abs() < 2e-3, "{name}: {share} {found:?}");
        }
    }
}

#[test]
fn size_and_place_change_nothing() {
    let knot = wire("knot");
    let moved = knot.control_points().iter().map(|&[x, y, z, w]| [3.0 * x + 1.0, 3.0 * y - 2.0, 3.0 * z, 3.0 * w]);
    let mut larger = knot.clone();
    larger.set_control_points(&moved.collect::<Vec<_>>()).unwrap();
    let ((a, here), (b, there)) = (elegance(&knot), elegance(&larger));
    assert!((a.turning_per_unit - b.turning_per_unit).abs() < 1e-6 && a.penetrating_share == b.penetrating_share);
    for (a, b) in here.penetrating.iter().zip(&there.penetrating) {
        assert!((3.0 * a[0] + 1.0 - b[0]).abs() < 1e-6 && (3.0 * a[2] - b[2]).abs() < 1e-6, "{a:?} {b:?}");
    }
}

#[test]
fn faults_are_where_they_were_made() {
    let near = |place: &[f64; 3], x: f64, y: f64| (place[0] - x).hypot(place[1] - y) < 0.02;
    let at = |turns: f64, radius: f64| {
        let (sin, cos) = (std::f64::consts::TAU * turns).sin_cos();
        (radius * cos, radius * sin)
    };
    let (_, kinked) = elegance(&wire("kinked"));
    assert_eq!((kinked.kinks.len(), kinked.tight.len(), kinked.penetrating.len()), (6, 6, 0), "{kinked:?}");
    for i in 1..7 {
        let (x, y) = at(2.0 * f64::from(i) / 7.0, 0.7);
        for places in [&kinked.kinks, &kinked.tight] {
            assert_eq!(places.iter().filter(|place| near(place, x, y)).count(), 1, "{kinked:?}");
        }
    }
    // A trefoil crosses itself three times; both strands are in each other there, and that is one place.
    let (_, knot) = elegance(&wire("knot"));
    assert_eq!((knot.kinks.len(), knot.tight.len(), knot.penetrating.len()), (0, 0, 3), "{knot:?}");
    let turns: Vec<f64> = knot.penetrating.iter().map(|&[x, y, _]| x.hypot(y)).collect();
    assert!(turns.iter().all(|radius| (radius - turns[0]).abs() < 0.03), "{knot:?}");
    let (_, coil) = elegance(&wire("coil"));
    assert!(coil.tight.is_empty() && coil.penetrating.is_empty(), "to touch is no fault: {coil:?}");
}
