//! A jig carries the wire, lets it go, and fits the bed.

use crate::support::{checked, random_wire};
use wire4d_core::wire::Wire;
use wire4d_printing::{Gauge, Printer, Strands, jig};

/// The wire's middle in the jig's frame, at close steps.
fn middle(wire: &Wire, size_mm: f64, radius_mm: f64) -> Vec<[f64; 3]> {
    let (from, to) = wire.domain();
    let count = 30_000;
    let places: Vec<[f64; 3]> = (0..=count)
        .map(|i| wire.evaluate(from + (to - from) * f64::from(i) / f64::from(count)))
        .map(|p| [p[0], -p[2], p[1]])
        .collect();
    let end = |c: usize, pick: fn(f64, f64) -> f64| places.iter().map(|p| p[c]).reduce(pick).unwrap();
    let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max].map(|pick| [0, 1, 2].map(|c| end(c, pick)));
    let scale = size_mm / (0..3).map(|c| high[c] - low[c]).fold(0.0, f64::max);
    let zero = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), low[2]];
    let lift = [0.0, 0.0, radius_mm];
    places.iter().map(|p| [0, 1, 2].map(|c| (p[c] - zero[c]) * scale + lift[c])).collect()
}

#[test]
fn every_part_is_one_manifold_clear_of_the_wire_and_fits_the_bed() {
    for (seed, bed_mm) in [(1, [220.0; 3]), (2, [100.0, 80.0, 250.0])] {
        let wire = random_wire(seed, true, 9);
        let strands = Strands::new(&wire, 150.0, Gauge::Constant(2.0)).unwrap();
        let printer = Printer::with_bed(bed_mm).unwrap();
        let made = jig(&strands, &printer).unwrap();
        assert!(made.posts >= 6, "{} posts", made.posts);
        assert_eq!(made.parts.len() > 1, bed_mm[0] < 200.0);
        let places = middle(&wire, 150.0, 1.0);
        let mut touching = 0;
        for part in &made.parts {
            let shape = checked(&part.mesh);
            assert_eq!([shape.pieces as i64, shape.euler], [1, 2], "{}", part.name);
            let [low, high] = part.mesh.bounds();
            (0..3).for_each(|c| assert!(f64::from(high[c] - low[c]) <= bed_mm[c], "{} {low:?} {high:?}", part.name));
            for p in &part.mesh.positions {
                let square = |q: &[f64; 3]| (0..3).map(|c| (q[c] - f64::from(p[c])).powi(2)).sum::<f64>();
                let away = places.iter().map(square).fold(f64::INFINITY, f64::min).sqrt() - 1.0;
                assert!(away > 0.2 - 0.002, "{}: {away} mm from the wire", part.name);
                touching += usize::from(away < 0.35);
            }
        }
        assert!(touching > 4 * made.posts, "grooves hold the wire: {touching} corners near it");
    }
}

#[test]
fn a_bed_that_is_none_is_said() {
    let said = |bed_mm| Printer::with_bed(bed_mm).unwrap_err().to_string();
    assert!(said([0.0, 220.0, 250.0]).starts_with("--bed-mm: 0 mm"));
    assert!(said([220.0, f64::NAN, 250.0]).contains("60 to 2000 mm"));
}
