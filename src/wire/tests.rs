//! Properties of the whole wire, over random wires of every form.

use super::*;
use crate::rng::Rng;

/// A random wire: random knot spacing for splines, uniform for the baselines.
fn random_wire(form: Form, closed: bool, count: usize, seed: u64) -> Wire {
    let mut rng = Rng::new(seed, 77);
    let count = form.fitting_count(closed, count);
    let points = (0..count)
        .map(|_| {
            let [x, y, z] = rng.in_ball(1.0);
            [x, y, z, rng.range(0.001, 0.05)]
        })
        .collect();
    let wire = Wire::uniform(form, closed, points).unwrap();
    let (start, end) = wire.domain();
    let more: Vec<f64> = (0..3).map(|_| rng.range(start, end)).collect();
    wire.insert_knots(&more).unwrap().0
}

fn all_wires(seed: u64) -> Vec<Wire> {
    let cases =
        [(Form::Spline, false), (Form::Spline, true), (Form::Chain, false), (Form::Chain, true), (Form::Bag, false)];
    let mut wires: Vec<_> = cases.iter().map(|&(form, closed)| random_wire(form, closed, 17, seed)).collect();
    wires.push(random_wire(Form::Spline, false, 4, seed));
    wires.push(random_wire(Form::Spline, true, 4, seed));
    wires
}

fn distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    (0..4).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

#[test]
fn samples_are_points_of_the_curve() {
    for wire in all_wires(1) {
        let (map, strokes) = wire.sampling_map::<f64>(5, false);
        let mut samples = Vec::new();
        map.apply(wire.control_points(), &mut samples);
        let parameters = wire.sample_parameters(5);
        assert_eq!(samples.len(), parameters.len());
        assert_eq!(strokes.iter().map(|stroke| stroke.count).sum::<usize>(), samples.len());
        if wire.form() != Form::Bag {
            for (sample, &t) in samples.iter().zip(&parameters) {
                assert!(distance(sample, &wire.evaluate(t)) < 1e-13);
            }
        }
    }
}
