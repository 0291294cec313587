//! What is printed is one closed solid, of the volume that the wire's round cones have together.

use crate::support::{checked, in_capsules, random_wire};
use wire4d_core::rng::Rng;
use wire4d_core::wire::Wire;
use wire4d_printing::{Gauge, Plate, Strands, print};

#[test]
fn a_wire_is_one_manifold_of_the_capsules_volume() {
    for seed in 0..6 {
        let wire = random_wire(seed, seed % 2 == 0, 14);
        let strands = Strands::new(&wire, 60.0, Gauge::Constant(2.4)).unwrap();
        let made = print(&strands, None).unwrap();
        let shape = checked(&made.mesh);
        assert_eq!(shape.pieces, 1, "one wire is one piece");
        assert_eq!(made.least_thickness_mm, 2.4);
        let monte_carlo = in_capsules(&wire, 60.0, 1.2, 1_000_000, &mut Rng::new(seed, 9));
        let off = made.mesh.volume_mm3() / monte_carlo - 1.0;
        assert!(off.abs() < 0.01, "seed {seed}: volume off by {:.2}%", 100.0 * off);
    }
}

#[test]
fn strands_that_cross_are_joined_and_those_apart_are_not() {
    let eight = |lift: f64| {
        let points = (0..48).map(|i| f64::from(i) * std::f64::consts::TAU / 48.0);
        Wire::closed_uniform(points.map(|t| [t.cos(), 0.5 * (2.0 * t).sin(), lift * t.sin(), 0.02]).collect()).unwrap()
    };
    let shape =
        |lift| checked(&print(&Strands::new(&eight(lift), 80.0, Gauge::Constant(2.0)).unwrap(), None).unwrap().mesh);
    // A ring has Euler characteristic 0; joined where it crosses it is an eight, with two holes.
    assert_eq!(shape(0.0).euler, -2);
    assert_eq!(shape(0.5).euler, 0);
}

#[test]
fn own_widths_are_kept_and_the_least_is_told() {
    let points: Vec<[f64; 4]> =
        (0..12).map(|i| [0.15 * f64::from(i) - 0.8, 0.0, 0.0, 0.01 + 0.01 * f64::from(i)]).collect();
    let strands = Strands::new(&Wire::open_uniform(points).unwrap(), 100.0, Gauge::Own { least_mm: 1.0 }).unwrap();
    let made = print(&strands, None).unwrap();
    assert_eq!(checked(&made.mesh).euler, 2);
    assert_eq!(made.least_thickness_mm, 1.0);
    let [low, high] = made.mesh.bounds();
    assert!(high[2] - low[2] > 6.0 && low[2].abs() < 0.1, "{low:?} {high:?}");
}

#[test]
fn what_cannot_be_printed_is_said() {
    let wire = random_wire(1, true, 14);
    let said = |size, gauge| Strands::new(&wire, size, Gauge::Constant(gauge)).unwrap_err().to_string();
    assert!(said(0.0, 1.0).starts_with("--size-mm: 0 mm"));
    assert!(said(10_000.0, 1.0).contains("10 to 5000 mm"));
    assert!(said(f64::NAN, 1.0).starts_with("--size-mm"));
    assert!(said(100.0, 0.3).contains("nozzle"));
    let endless = random_wire(1, true, 20_000);
    let strands = Strands::new(&endless, 5000.0, Gauge::Constant(0.4)).unwrap();
    let said = print(&strands, None).unwrap_err().to_string();
    assert!(said.starts_with("--wire-mm") && said.contains("slicer"), "{said}");
}

#[test]
fn twenty_thousand_points_are_no_trouble() {
    let points = (0..20_000).map(|i| f64::from(i) * std::f64::consts::TAU / 20_000.0).map(|t| {
        let across = 0.6 + 0.3 * (40.0 * t).cos();
        [across * (3.0 * t).cos(), across * (3.0 * t).sin(), 0.3 * (40.0 * t).sin(), 0.02]
    });
    let wire = Wire::closed_uniform(points.collect()).unwrap();
    let made = print(&Strands::new(&wire, 200.0, Gauge::Constant(1.6)).unwrap(), None).unwrap();
    checked(&made.mesh);
}

#[test]
fn a_wire_on_a_plate_with_its_name_is_one_piece() {
    let strands = Strands::new(&random_wire(3, true, 14), 80.0, Gauge::Constant(2.0)).unwrap();

    let bare = print(&strands, Some(&Plate::default())).unwrap().mesh;
    let named = print(&strands, Some(&Plate::with_name("Owl & cat 2").unwrap())).unwrap().mesh;
    for mesh in [&bare, &named] {
        assert_eq!(checked(mesh).pieces, 1);
        assert_eq!(mesh.bounds()[0][2], 0.0, "it stands on the bed");
    }
    assert!(named.volume_mm3() > bare.volume_mm3() + 100.0, "letters are raised");
    let said = |name: &str| Plate::with_name(name).unwrap_err().to_string();
    assert!(said("Ł").contains("A to Z") && said("Ł").starts_with("--name"), "{}", said("Ł"));
    assert!(said("  ").contains("1 to 40 letters"));
}
