//! The reference that the linearised projection is measured against is right itself.

use crate::figure;
use crate::reference;

use reference::{chord_bound_px, coverage, halves, linearised, pieces, point, rational, vertices};
use wire4d::raster::sampled_union;
use wire4d::view::{Projection, View};
use wire4d::wire::Stroke;

/// A camera so close that depth matters.
fn close_view(size_px: usize) -> View {
    let mut view = View::orthographic("close", 0.7, 0.3, 2.0, size_px);
    let length = view.eye.iter().map(|c| c * c).sum::<f64>().sqrt();
    view.eye = view.eye.map(|c| c * 1.9 / length);
    view.projection = Projection::Perspective { fov_y_rad: 1.0 };
    view
}

#[test]
fn the_rational_curve_is_the_projected_wire() {
    let (view, wire) = (close_view(512), figure::tour(20, 4));
    let camera = view.camera::<f64>();
    let exact = pieces(&wire, 1, |bezier| rational(&camera, bezier));
    let flat = pieces(&wire, 1, |bezier| linearised(&camera, bezier));
    let (mut worst, mut linear) = (0.0f64, 0.0f64);
    for (i, span) in wire.spans().enumerate() {
        for j in 0..=8 {
            let s = f64::from(j) / 8.0;
            let truth = camera.project(&wire.evaluate(span.at(s)));
            let off = |found: [f64; 3]| (0..3).map(|c| (found[c] - truth[c]).abs()).fold(0.0, f64::max);
            worst = worst.max(off(point(&exact[i], s)));
            linear = linear.max(off(point(&flat[i], s)));
        }
    }
    assert!(worst < 1e-9, "{worst} px");
    assert!(linear > 1.0, "the camera is too far away to tell: {linear} px");
}

#[test]
fn chords_stay_within_their_bound_and_the_bound_is_no_idle_one() {
    let (view, wire) = (close_view(512), figure::tour(20, 4));
    let camera = view.camera::<f64>();
    let mut used = 0.0f64;
    for piece in pieces(&wire, 1, |bezier| rational(&camera, bezier)) {
        let mut curve = piece;
        for _ in 0..6 {
            let (a, b, bound) = (point(&curve, 0.0), point(&curve, 1.0), chord_bound_px(&curve));
            for j in 1..8 {
                let s = f64::from(j) / 8.0;
                let p = point(&curve, s);
                let off = |c: usize| a[c] + (b[c] - a[c]) * s - p[c];
                used = used.max((off(0).hypot(off(1)) + off(2).abs()) / bound);
            }
            curve = halves(&curve)[0];
        }
    }
    assert!(used <= 1.0, "{used}");
    assert!(used > 0.3, "a bound three times too wide makes the reference slow for nothing: {used}");
}

#[test]
fn its_coverage_is_that_of_a_lattice_of_samples() {
    let (view, wire) = (close_view(96), figure::tour(20, 4));
    let camera = view.camera::<f64>();
    let exact = pieces(&wire, 1, |bezier| rational(&camera, bezier));
    // Independent: points of the curve itself, 200 a span, and membership counted.
    let dense: Vec<[f32; 3]> =
        wire.sample_parameters(200).iter().map(|&t| camera.project(&wire.evaluate(t)).map(|c| c as f32)).collect();
    let stroke = Stroke { start: 0, count: dense.len(), closed: false };
    let counted = sampled_union(96, 96, &dense, &[stroke], 16);
    let rms = |found: &[f32]| {
        let edge: Vec<f64> = found
            .iter()
            .zip(&counted)
            .filter(|&(&a, &b)| (a > 0.0 && a < 1.0) || (b > 0.0 && b < 1.0))
            .map(|(a, b)| f64::from(a - b).powi(2))
            .collect();
        (edge.iter().sum::<f64>() / edge.len() as f64).sqrt()
    };
    let drawn = rms(&coverage(&view, &vertices(&exact, 0.002)));
    assert!(drawn < 0.01, "{drawn}");
    let flat = pieces(&wire, 1, |bezier| linearised(&camera, bezier));
    let linear = rms(&coverage(&view, &vertices(&flat, 0.002)));
    assert!(linear > 3.0 * drawn, "the linearised curve is another one: {linear} {drawn}");
}
