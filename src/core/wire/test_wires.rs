//! Random wires of every form for the tests of this room.

use super::{Form, Wire};
use crate::rng::Rng;

/// About `count` control points in the unit ball, uniform knots and a few more at random.
pub fn random_wire(form: Form, closed: bool, count: usize, seed: u64) -> Wire {
    let mut rng = Rng::new(seed, 77);
    let count = form.fitting_count(closed, count);
    let points = (0..count)
        .map(|_| {
            let [x, y, z] = rng.in_ball(1.0);
            [x, y, z, rng.range(0.001, 0.05)]
        })
        .collect();
    let wire = Wire::uniform(form, closed, points).unwrap();
    let knots = new_knots(&wire, 3, &mut rng);
    let (mut wire, _) = wire.insert_knots(&knots).unwrap();
    // Off the smoother curve that insertion keeps.
    let moved: Vec<_> = wire.control_points().iter().map(|p| [p[0] + rng.range(-0.1, 0.1), p[1], p[2], p[3]]).collect();
    wire.set_control_points(&moved).unwrap();
    wire
}

/// Every form, open and closed, and the least number of points.
pub fn all_wires(seed: u64) -> Vec<Wire> {
    let mut wires = vec![
        random_wire(Form::Chain, false, 17, seed),
        random_wire(Form::Chain, true, 17, seed),
        random_wire(Form::Bag, false, 17, seed),
    ];
    wires.extend(splines(seed));
    wires
}

/// Splines, open and closed, many points and few.
pub fn splines(seed: u64) -> Vec<Wire> {
    let counts = [17, 4];
    counts.iter().flat_map(|&n| [false, true].map(|closed| random_wire(Form::Spline, closed, n, seed))).collect()
}

/// `count` knots at random places where `wire` has none yet.
pub fn new_knots(wire: &Wire, count: usize, rng: &mut Rng) -> Vec<f64> {
    let spans: Vec<_> = wire.spans().collect();
    let mut knots: Vec<f64> = Vec::new();
    while knots.len() < count {
        let t = spans[rng.below(spans.len())].at(rng.range(0.01, 0.99));
        if knots.iter().all(|other| (other - t).abs() > 1e-3) {
            knots.push(t);
        }
    }
    knots
}

/// Largest difference of coordinates.
pub fn distance(a: &[f64; 4], b: &[f64; 4]) -> f64 {
    (0..4).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}
