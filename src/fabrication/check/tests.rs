use super::*;
use crate::Metal;
use std::f64::consts::TAU;

fn ring(count: usize, place: impl Fn(f64) -> [f64; 3]) -> Wire {
    let points = (0..count).map(|i| {
        let [x, y, z] = place(TAU * i as f64 / count as f64);
        [x, y, z, 0.05]
    });
    Wire::closed_uniform(points.collect()).unwrap()
}

fn circle() -> Wire {
    ring(96, |t| [t.cos(), t.sin(), 0.0])
}

/// Crosses itself in its middle, its strands `apart` from each other (of a width of 2).
fn eight(apart: f64) -> Wire {
    ring(96, |t| [t.cos(), (2.0 * t).sin() * 0.7, 0.5 * apart * t.sin()])
}

fn checked(wire: &Wire, size_mm: f64, stock: &Stock) -> Check {
    Check::new(wire, &Centreline::new(wire, size_mm, stock.gauge_mm).unwrap(), stock).unwrap()
}

#[test]
fn a_circle_has_its_length_radius_and_mass() {
    let stock = Stock { gauge_mm: 2.0, length_mm: 200.0, ..Stock::default() };
    let check = checked(&circle(), 200.0, &stock);
    assert!(check.passes && check.passing.is_none());
    assert!((check.length_mm - 100.0 * TAU).abs() < 0.5, "{}", check.length_mm);
    assert!((check.bends.least_radius_mm - 100.0).abs() < 0.5, "{}", check.bends.least_radius_mm);
    assert!((check.mass_g - Metal::Copper.mass_g(check.length_mm, 2.0)).abs() < 1e-9);
    assert_eq!(check.box_mm.map(f64::round), [202.0, 202.0, 2.0]);
    assert_eq!(check.clearance.least_mm, None, "nothing comes near");
    // 628 mm of 200 mm pieces, and a ring has as many joints as pieces.
    assert_eq!((check.pieces.count, check.pieces.joints_mm.len()), (4, 4));
    let ends = check.pieces.joints_mm.iter().copied().skip(1).chain([check.length_mm]);
    assert!(check.pieces.joints_mm.iter().zip(ends).all(|(from, to)| to > *from && to - from <= 200.0 + 1e-9));
}

#[test]
fn a_small_circle_is_too_tight_and_passes_at_the_size_told() {
    let stock = Stock { metal: Metal::Aluminium, gauge_mm: 6.0, ..Stock::default() };
    let check = checked(&circle(), 24.0, &stock);
    assert!(!check.passes);
    assert_eq!(check.bends.tight.len(), 1, "all the way round: {:?}", check.bends.tight);
    let needed = Metal::Aluminium.least_radius_mm(6.0);
    let size = check.passing.unwrap().size_mm.unwrap();
    assert!((size - 2.0 * needed).abs() <= 1.0, "{size} for a radius of {needed}");
    assert!(checked(&circle(), size, &stock).passes && !checked(&circle(), size - 1.0, &stock).passes);
    let gauge = check.passing.unwrap().gauge_mm.unwrap();
    assert!(checked(&circle(), 24.0, &Stock { gauge_mm: gauge, ..stock }).passes);
}

#[test]
fn strands_that_meet_are_named_by_where_they_are() {
    let stock = Stock::default();
    // .03 of a width of 2 is 3 mm of 200.
    let check = checked(&eight(0.03), 200.0, &stock);
    assert!(check.passes, "{:?}", check.clearance);
    let air = check.clearance.least_mm.unwrap();
    assert!((air - (3.0 - 1.6)).abs() < 0.05, "{air}");

    let check = checked(&eight(0.005), 200.0, &stock);
    let [meeting] = check.clearance.meetings[..] else { panic!("{:?}", check.clearance.meetings) };
    assert!(!check.passes && meeting.through);
    assert!((meeting.distance_mm - 0.5).abs() < 0.05, "{}", meeting.distance_mm);
    // It begins at its right end: the crossing is a quarter and three quarters of the way.
    for (place, share) in [(meeting.nearest[0], 0.25), (meeting.nearest[1], 0.75)] {
        assert!((place.at_mm / check.length_mm - share).abs() < 0.02, "{place:?}");
        assert!(place.world.iter().all(|x| x.abs() < 0.02), "{place:?}");
    }
    assert!(meeting.stretch_mm[0] < meeting.nearest[0].at_mm && meeting.nearest[0].at_mm < meeting.stretch_mm[1]);
    let size = check.passing.unwrap().size_mm.unwrap();
    assert!((size / 200.0 - 1.6 / 0.5).abs() < 0.05, "{size}");
    assert!(checked(&eight(0.005), size, &stock).passes && !checked(&eight(0.005), size - 1.0, &stock).passes);
}

#[test]
fn a_wire_through_itself_passes_at_no_size() {
    let check = checked(&eight(0.0), 200.0, &Stock::default());
    assert_eq!(check.passing, Some(Passing { size_mm: None, gauge_mm: None }));
    let said = check.sentences(&Stock::default()).join(" ");
    assert!(
        said.contains("cannot be bent") && said.contains("pass through") && said.contains("--bend-radius"),
        "{said}"
    );
}

#[test]
fn what_cannot_be_built_is_said() {
    for (size, gauge, said) in [
        (0.0, 1.6, "--size-mm"),
        (10_000.0, 1.6, "10 to 5000 mm"),
        (f64::NAN, 1.6, "--size-mm"),
        (200.0, 0.0, "--wire-mm"),
        (200.0, f64::INFINITY, "--wire-mm"),
        (20.0, 9.0, "at most 5 mm"),
    ] {
        let error = Centreline::new(&circle(), size, gauge).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    }
    let line = Centreline::new(&circle(), 100.0, 1.0).unwrap();
    let short = Stock { length_mm: 1.0, ..Stock::default() };
    assert!(short.pieces(&line).unwrap_err().to_string().contains("--stock-mm"));
    let point = Wire::closed_uniform(vec![[0.1, 0.1, 0.1, 0.1]; 8]).unwrap();
    assert!(Centreline::new(&point, 100.0, 1.0).unwrap_err().to_string().contains("one place"));
}
