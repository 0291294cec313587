//! Flowers, and leaves on stems.

use super::canvas::{Canvas, along};
use crate::rng::Rng;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Large flowers as far apart as they go, smaller ones and dots where there is room.
pub(super) fn petals(canvas: &mut Canvas) {
    let mut rng = Rng::new(11, 40);
    let mut placed: Vec<(DVec2, f64)> = Vec::new();
    // Far apart on the tile that repeats.
    let apart = |a: DVec2, b: DVec2| (a - b - (a - b).round()).length();
    for (radius, tries) in [(0.205, 400), (0.135, 600), (0.078, 800), (0.022, 700)] {
        for _ in 0..tries {
            let at = DVec2::new(rng.unit(), rng.unit());
            if placed.iter().all(|&(other, r)| apart(at, other) > radius + r + 0.004) {
                placed.push((at, radius));
            }
        }
    }
    for &(at, radius) in &placed {
        let turn = rng.range(0.0, TAU);
        if radius < 0.03 {
            canvas.dot(at, 0.55 * radius, 1.0);
        } else {
            flower(canvas, at, 1.04 * radius, turn, if radius > 0.1 { 7 } else { 5 });
        }
    }
}

fn flower(canvas: &mut Canvas, at: DVec2, radius: f64, turn: f64, petals: usize) {
    let line = 0.004 + 0.034 * radius;
    // Every second petal lies on top of its neighbours.
    let order = (0..petals).step_by(2).chain((1..petals).step_by(2));
    for i in order {
        let axis = DVec2::from_angle(turn + TAU * i as f64 / petals as f64);
        let side = axis.perp();
        let half = radius * 1.12 * (PI / petals as f64).sin();
        let point = |along: f64, across: f64| at + radius * along * axis + half * across * side;
        // Round outside with a small notch at the tip, narrow at the heart.
        let outline = along(48, |s| {
            let angle = TAU * s;
            let reach = 0.6 - 0.4 * angle.cos() - 0.07 * (-((s - 0.5) / 0.045).powi(2)).exp();
            point(reach, angle.sin() * (0.5 + 0.62 * reach).min(1.0))
        });
        canvas.fill(&outline, 0.0);
        let edge = along(48, |s| (outline[(s * 48.0).round() as usize], line * (0.75 + 0.75 * (PI * s).sin())));
        canvas.stroke(&edge, 1.0);
        for vein in [-0.42, -0.14, 0.14, 0.42] {
            let length = 0.74 - 0.5 * f64::abs(vein);
            let strand =
                along(10, |s| (point(0.2 + (length - 0.2) * s, vein * (0.4 + 0.9 * s)), line * 0.8 * (1.0 - 0.8 * s)));
            canvas.stroke(&strand, 1.0);
        }
    }
    canvas.dot(at, 0.27 * radius, 0.0);
    canvas.dot(at, 0.23 * radius, 1.0);
    for i in 0..petals {
        let place = at + 0.135 * radius * DVec2::from_angle(turn + TAU * (i as f64 + 0.5) / petals as f64);
        canvas.dot(place, 0.034 * radius, 0.0);
    }
}

/// Two stems that wind upward, leaves on both sides in turn, tendrils between.
pub(super) fn leaves(canvas: &mut Canvas) {
    const LEAVES: usize = 6;
    for (x, phase) in [(0.25, 0.0), (0.75, PI)] {
        let stem = |s: f64| DVec2::new(x + 0.07 * (TAU * s + phase).sin(), 1.0 - s);
        for i in 0..LEAVES {
            let s = (i as f64 + 0.5 * phase / PI) / LEAVES as f64;
            let side = if i % 2 == 0 { 1.0 } else { -1.0 };
            let up = (stem(s + 0.01) - stem(s - 0.01)).normalize();
            let out = DVec2::from_angle(side * 0.95).rotate(up);
            leaf(canvas, stem(s), out, 0.26, side);
            // A tendril on the other side, a little higher.
            tendril(canvas, stem(s + 0.035), DVec2::from_angle(-side * 0.7).rotate(up), -side);
        }
        let line = along(120, |s| (stem(s), 0.016 + 0.004 * (TAU * 6.0 * s).cos()));
        canvas.stroke(&line, 1.0);
    }
}

/// A leaf from its stalk: bent, one half dark with pale veins, the other pale with dark ones.
fn leaf(canvas: &mut Canvas, from: DVec2, axis: DVec2, length: f64, bend: f64) {
    let side = axis.perp();
    let rib = |s: f64| from + length * (s * axis - 0.22 * bend * s * s * side);
    // Widest before the middle, pointed at the tip.
    let half = |s: f64| 0.42 * length * (PI * s.powf(0.8)).sin().max(0.0).powf(0.85) * (1.0 - 0.25 * s);
    let edge = |s: f64, which: f64| rib(s) + which * half(s) * side;
    let leaf = |which: f64| [along(30, rib), along(30, |s| edge(1.0 - s, which))].concat();
    canvas.fill(&leaf(1.0), 0.0);
    canvas.fill(&leaf(-1.0), 0.0);
    canvas.fill(&leaf(bend), 1.0);
    for which in [1.0, -1.0] {
        let outline = along(30, |s| (edge(s, which), 0.008));
        canvas.stroke(&outline, 1.0);
        for i in 1..6 {
            let s = 0.08 + 0.13 * f64::from(i);
            let (start, end) = (rib(s), rib(s + 0.16).lerp(edge(s + 0.16, which), 0.82));
            let vein = along(6, |t| (start.lerp(end, t), 0.0065 * (1.0 - 0.55 * t)));
            canvas.stroke(&vein, if which == bend { 0.0 } else { 1.0 });
        }
    }
    let middle = along(20, |s| (rib(s), 0.012 * (1.0 - 0.7 * s)));
    canvas.stroke(&middle, 1.0);
}

/// A spiral that winds up at its end.
fn tendril(canvas: &mut Canvas, from: DVec2, axis: DVec2, bend: f64) {
    let mut at = from;
    let mut angle: f64 = 0.0;
    const STEPS: usize = 70;
    let mut line = vec![(at, 0.011)];
    for i in 0..STEPS {
        let s = i as f64 / STEPS as f64;
        angle += bend * (0.02 + 0.3 * s * s);
        at += 0.0042 * (1.0 - 0.35 * s) * DVec2::from_angle(angle).rotate(axis);
        line.push((at, 0.011 - 0.005 * s));
    }
    canvas.stroke(&line, 1.0);
    canvas.dot(at, 0.009, 1.0);
}
