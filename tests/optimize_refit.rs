//! A known wire, seen from three sides, is found again from a poor start.

use wire4d::optimize::{EventKind, Problem, RasterKind, Recipe, Schedule, Session, Stage};
use wire4d::raster::{BandRaster, Raster};
use wire4d::rng::Rng;
use wire4d::view::{Image, Target, View};
use wire4d::wire::Wire;

/// A smooth random wire of `count` control points in a ball of 0.8.
fn random_wire(count: usize, seed: u64) -> Wire {
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

fn draw(wire: &Wire, view: &View) -> Image {
    let (map, strokes) = wire.sampling_map::<f32>(16, true);
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
    let mut samples = Vec::new();
    map.apply(&points, &mut samples);
    let camera = view.camera::<f32>();
    let vertices: Vec<_> = samples.iter().map(|sample| camera.project(sample)).collect();
    let data = BandRaster::new().forward(view.width_px, view.height_px, &vertices, &strokes).to_vec();
    Image { width: view.width_px, height: view.height_px, data }
}

fn iou(a: &Image, b: &Image) -> f32 {
    let pairs = || a.data.iter().zip(&b.data);
    pairs().map(|(a, b)| a.min(*b)).sum::<f32>() / pairs().map(|(a, b)| a.max(*b)).sum::<f32>()
}

fn mean_iou(wire: &Wire, targets: &[Target]) -> f32 {
    targets.iter().map(|t| iou(&draw(wire, &t.view), &t.ink)).sum::<f32>() / targets.len() as f32
}

#[test]
fn a_perturbed_wire_finds_its_pictures_again() {
    let truth = random_wire(24, 3);
    let targets: Vec<Target> =
        View::canonical(2.2, 128).into_iter().map(|view| Target { ink: draw(&truth, &view), view }).collect();
    let mut start = truth.clone();
    let mut rng = Rng::new(8, 1);
    let moved: Vec<[f64; 4]> = truth
        .control_points()
        .iter()
        .map(|p| {
            let off = rng.in_ball(0.1);
            [p[0] + off[0], p[1] + off[1], p[2] + off[2], 0.03]
        })
        .collect();
    start.set_control_points(&moved).unwrap();
    let recipe = Recipe {
        stages: vec![Stage {
            iterations: 300,
            size_px: 128,
            raster: RasterKind::Exact,
            samples_per_span: 8,
            restarts: vec![],
        }],
        jerk_position: Schedule::Constant(1e-5),
        jerk_width: Schedule::Constant(1e-5),
        ..Recipe::best()
    };
    let mut session = Session::new(Problem::for_drawings(start.clone(), targets.clone(), recipe)).unwrap();
    let before = mean_iou(&start, &targets);
    let events = session.step(1000);
    assert!(session.is_done() && events.last().unwrap().kind == EventKind::Done);
    let after = mean_iou(&session.wire(), &targets);
    assert!(before < 0.4 && after > 0.9, "IoU {before} -> {after}");
    assert!((mean_iou(&session.best(), &targets) - after).abs() < 0.02);
    let rows: Vec<_> = session.history().rows().collect();
    assert_eq!(rows.len(), 300);
    assert!(rows[299][0] < 0.1 * rows[0][0]);
    assert_eq!(session.history().columns, ["total", "front", "side", "top", "jerk", "length"]);
}
