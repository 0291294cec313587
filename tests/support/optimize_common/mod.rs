//! Wires and pictures for the tests of objective and optimize.

// Each test file uses its share of them.
#![allow(dead_code)]

use wire4d::raster::{ExactRaster, Raster};
use wire4d::rng::Rng;
use wire4d::view::{Image, Target, View};
use wire4d::wire::Wire;

/// A smooth random wire of `count` control points in a ball of 0.8.
pub fn random_wire(count: usize, seed: u64) -> Wire {
    let mut rng = Rng::new(seed, 0);
    let mut at = [0.0; 3];
    let mut heading = [0.3, 0.0, 0.0];
    let points = (0..count).map(|_| {
        loop {
            let turn = rng.in_ball(0.25);
            let next: [f64; 3] = std::array::from_fn(|c| 0.7 * heading[c] + turn[c]);
            let moved: [f64; 3] = std::array::from_fn(|c| at[c] + next[c]);
            if moved.iter().map(|c| c * c).sum::<f64>() < 0.64 {
                (at, heading) = (moved, next);
                break;
            }
            heading = heading.map(|c| -0.5 * c);
        }
        [at[0], at[1], at[2], rng.range(0.03, 0.06)]
    });
    Wire::open_uniform(points.collect()).unwrap()
}

/// The wire with its control points moved by up to `distance`, of width 0.03.
pub fn perturbed(wire: &Wire, distance: f64, seed: u64) -> Wire {
    let mut rng = Rng::new(seed, 1);
    let mut moved = wire.clone();
    let points: Vec<[f64; 4]> = wire
        .control_points()
        .iter()
        .map(|p| {
            let off = rng.in_ball(distance);
            [p[0] + off[0], p[1] + off[1], p[2] + off[2], 0.03]
        })
        .collect();
    moved.set_control_points(&points).unwrap();
    moved
}

/// The wire as a view shows it.
pub fn draw(wire: &Wire, view: &View) -> Image {
    let (map, strokes) = wire.sampling_map::<f32>(16, true);
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
    let mut samples = Vec::new();
    map.apply(&points, &mut samples);
    let camera = view.camera::<f32>();
    let vertices: Vec<_> = samples.iter().map(|sample| camera.project(sample)).collect();
    let data = ExactRaster::new().forward(view.width_px, view.height_px, &vertices, &strokes).to_vec();
    Image { width: view.width_px, height: view.height_px, data }
}

/// What three canonical views show of a wire.
pub fn targets_of(wire: &Wire, size_px: usize) -> Vec<Target> {
    let views = View::canonical(2.2, size_px);
    views.into_iter().map(|view| Target { ink: draw(wire, &view), view }).collect()
}

/// Σ min / Σ max.
pub fn soft_iou(a: &Image, b: &Image) -> f32 {
    let pairs = || a.data.iter().zip(&b.data);
    pairs().map(|(a, b)| a.min(*b)).sum::<f32>() / pairs().map(|(a, b)| a.max(*b)).sum::<f32>()
}

/// Mean over the targets.
pub fn mean_iou(wire: &Wire, targets: &[Target]) -> f32 {
    targets.iter().map(|t| soft_iou(&draw(wire, &t.view), &t.ink)).sum::<f32>() / targets.len() as f32
}
