//! Wires that are hard to mesh, draw and encode, made from formulas and one seed.
#![allow(dead_code)]

use std::f64::consts::TAU;
use wire4d::rng::Rng;
use wire4d::sculpture::{Carried, MadeWith, Sculpture};
use wire4d::view::{Projection, View};
use wire4d::wire::{Form, Wire};

fn open(points: impl IntoIterator<Item = [f64; 4]>) -> Wire {
    Wire::open_uniform(points.into_iter().collect()).unwrap()
}

/// `count` control points at random in the unit ball: the roughest wire there is.
pub fn random(seed: u64, count: usize) -> Wire {
    let mut rng = Rng::new(seed, 7);
    open((0..count).map(|_| {
        let [x, y, z] = rng.in_ball(1.0);
        [x, y, z, rng.range(0.0, 0.05)]
    }))
}

/// A random walk with momentum, much like an optimised wire: steps of a few pixels, widths that change slowly.
pub fn smooth(seed: u64, count: usize) -> Wire {
    let mut rng = Rng::new(seed, 8);
    let (mut p, mut v, mut width) = ([0.0; 3], [0.0; 3], 0.01);
    open((0..count).map(|_| {
        let kick = rng.in_ball(0.03);
        for c in 0..3 {
            v[c] = 0.8 * v[c] + kick[c] - 0.02 * p[c];
            p[c] = f64::clamp(p[c] + v[c], -0.57, 0.57);
        }
        width = f64::clamp(width + rng.range(-0.002, 0.002), 0.0, 0.03);
        [p[0], p[1], p[2], width]
    }))
}

pub fn helix() -> Wire {
    open((0..60).map(|i| {
        let a = TAU * i as f64 / 12.0;
        [0.6 * a.cos(), i as f64 / 40.0 - 0.75, 0.6 * a.sin(), 0.02 + 0.01 * (a / 3.0).sin()]
    }))
}

pub fn trefoil() -> Wire {
    let point = |i: usize| {
        let a = TAU * i as f64 / 40.0;
        let r = 0.3;
        [
            r * (a.sin() + 2.0 * (2.0 * a).sin()),
            r * (a.cos() - 2.0 * (2.0 * a).cos()),
            -r * (3.0 * a).sin(),
            0.03 + 0.02 * a.cos(),
        ]
    };
    Wire::closed_uniform((0..40).map(point).collect()).unwrap()
}

/// Out along a branch and back on the very same points, twice: cusps at the tips.
pub fn there_and_back() -> Wire {
    let out = |i: usize| [0.1 * i as f64 - 0.5, 0.02 * (i * i) as f64 - 0.5, 0.0, 0.03];
    open((0..8).map(out).chain((0..8).rev().map(out)).chain((0..8).map(out)))
}

/// Coincident control points (a corner, a stop) and a run of width 0.
pub fn degenerate() -> Wire {
    let mut points = vec![[-0.5, 0.0, 0.0, 0.04]; 4];
    points.extend((0..6).map(|i| [-0.5 + 0.2 * i as f64, 0.0, 0.1, 0.0]));
    points.extend([[0.5, 0.5, 0.0, 0.04]; 3]);
    points.extend((0..5).map(|i| [0.5, 0.5 - 0.2 * i as f64, 0.2 * (i % 2) as f64, 0.06]));
    open(points)
}

/// Every control point the same: a ball.
pub fn point() -> Wire {
    open([[0.1, 0.2, 0.3, 0.1]; 5])
}

/// Loops far tighter than the wire is thick.
pub fn curl() -> Wire {
    open((0..80).map(|i| {
        let a = TAU * i as f64 / 7.0;
        [0.02 * a.cos() + 0.005 * i as f64 - 0.2, 0.02 * a.sin(), 0.002 * i as f64, 0.08]
    }))
}

/// Closed, flat, and back on itself.
pub fn closed_flat() -> Wire {
    let points = (0..20).map(|i| [0.05 * i.min(20 - i) as f64 - 0.25, 0.0, 0.0, 0.05]).collect();
    Wire::closed_uniform(points).unwrap()
}

/// With knots inserted at random spans' middles, as refinement does.
pub fn refined(wire: &Wire, seed: u64, times: usize) -> Wire {
    let mut rng = Rng::new(seed, 9);
    let mut wire = wire.clone();
    for _ in 0..times {
        let spans: Vec<_> = wire.spans().collect();
        let mut knots: Vec<f64> = (0..10).map(|_| spans[rng.below(spans.len())].at(0.5)).collect();
        knots.sort_by(f64::total_cmp);
        knots.dedup();
        wire = wire.insert_knots(&knots).unwrap().0;
    }
    wire
}

pub fn all() -> Vec<(&'static str, Wire)> {
    vec![
        ("random", random(1, 40)),
        ("smooth", smooth(2, 120)),
        ("helix", helix()),
        ("trefoil", trefoil()),
        ("there and back", there_and_back()),
        ("degenerate", degenerate()),
        ("point", point()),
        ("curl", curl()),
        ("closed flat", closed_flat()),
        ("refined", refined(&smooth(3, 40), 1, 3)),
        ("chain", smooth(4, 40).to_form(Form::Chain).unwrap()),
        ("bag", smooth(5, 40).to_form(Form::Bag).unwrap()),
    ]
}

/// With the three canonical views.
pub fn sculpture(wire: Wire) -> Sculpture {
    let made_with = MadeWith { task: "multiview".into(), seed: 7, ..MadeWith::default() };
    Sculpture { wire, views: View::canonical(2.2, 256).to_vec(), made_with, carried: Carried::default() }
}

/// A view in perspective from an odd direction.
pub fn perspective() -> View {
    View {
        name: "over the shoulder".into(),
        projection: Projection::Perspective { fov_y_rad: 0.7 },
        eye: [1.5, 2.0, 2.5],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        width_px: 320,
        height_px: 256,
    }
}
