//! What a device is asked before it is trusted: one iteration of small wires, compared with the processor's, and whether
//! it is worth its while.

use super::clock::now_ms;
use super::{Absence, Device, GpuEngine};
use crate::objective::{Clearance, Elastic, Neighbours};
use crate::optimize::{
    Adam, AdamOptions, CpuEngine, Engine, Picture, Scene, SceneView, State, Step, Tally, term_count,
};
use crate::view::{Image, View};
use crate::wire::Wire;

/// Largest differences that pass, all but the coverage's relative.
pub const SELF_CHECK_BARS: Parity =
    Parity { wire: "any", coverage: 1e-3, loss: 1e-4, d_coverage: 1e-3, gradient: 1e-3 };

/// How far an engine is from the processor on one wire. Distances of lists are relative l2.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Parity {
    /// What kind of wire.
    pub wire: &'static str,
    /// Largest difference of a pixel's coverage.
    pub coverage: f32,
    /// Distance of the loss terms.
    pub loss: f32,
    /// Distance of the gradient to the coverage.
    pub d_coverage: f32,
    /// Distance of the gradient to the control points.
    pub gradient: f32,
}

impl Parity {
    /// Whether every difference is a number within its bar.
    pub fn is_within(&self, bars: &Parity) -> bool {
        let pairs = [
            (self.coverage, bars.coverage),
            (self.loss, bars.loss),
            (self.d_coverage, bars.d_coverage),
            (self.gradient, bars.gradient),
        ];
        pairs.iter().all(|(difference, bar)| difference <= bar)
    }
}

/// Compares one iteration of a tapered spiral.
///
/// # Errors
/// [`Absence::Unfit`] if a difference is above [`SELF_CHECK_BARS`], or if the device fails.
pub async fn self_check(engine: &mut dyn Engine) -> Result<Parity, Absence> {
    let parity = compare(engine, "spiral", &spiral(12), 1.0).await;
    let unfit = |problem: String| Absence::Unfit { name: engine.place().device, problem };
    if let Some(error) = engine.trouble() {
        return Err(unfit(error.to_string()));
    }
    if parity.is_within(&SELF_CHECK_BARS) {
        return Ok(parity);
    }
    Err(unfit(format!("it computes something else than the processor ({parity:?})")))
}

/// Compares one iteration of the spiral and of hostile wires: off screen, of no and of huge width, of one span, with
/// coincident points. The processor's loss is that of level weights times `skew`; with any but 1 a comparison must fail.
pub async fn parities(engine: &mut dyn Engine, skew: f32) -> Vec<Parity> {
    let points = spiral(12);
    let moved = |change: &dyn Fn(usize, [f64; 4]) -> [f64; 4]| -> Vec<[f64; 4]> {
        points.iter().enumerate().map(|(i, &point)| change(i, point)).collect()
    };
    let wires = [
        ("spiral", points.clone()),
        ("off screen", moved(&|_, [x, y, z, width]| [x + 9.0, y, z, width])),
        ("half off screen", moved(&|_, [x, y, z, width]| [x + 0.9, y - 0.6, z, width])),
        ("no width", moved(&|_, [x, y, z, _]| [x, y, z, 0.0])),
        ("huge width", moved(&|_, [x, y, z, _]| [x, y, z, 1.2])),
        ("one span", points[..4].to_vec()),
        ("coincident points", moved(&|i, _| points[i / 3 * 3])),
    ];
    let mut parities = Vec::new();
    for (wire, points) in wires {
        parities.push(compare(engine, wire, &points, skew).await);
    }
    parities
}

/// How many times faster than the processor a device takes a middling wire along, less than 1 if it is slower.
pub async fn speed_up(device: &Device) -> f64 {
    const ITERATIONS: usize = 16;
    let (scene, points, step) = example(&spiral(220), 128);
    let steps = [step; ITERATIONS];
    let mut taken_ms = Vec::new();
    for engine in [&mut CpuEngine::new() as &mut dyn Engine, &mut GpuEngine::new(device, "")] {
        engine.load(scene.clone()).done().await;
        let mut state = State { points: points.clone(), adam: Adam::new(points.len()) };
        let (mut tally, mut terms) = (Tally::new(points.len()), vec![0.0; ITERATIONS * term_count(scene.views.len())]);
        // The first ones pay for what is done once.
        for _ in 0..3 {
            let begin_ms = now_ms();
            engine.advance(&mut state, &mut tally, &steps, &mut terms).done().await;
            taken_ms.push(now_ms() - begin_ms);
        }
    }
    taken_ms[2] / taken_ms[5].max(1e-3)
}

async fn compare(engine: &mut dyn Engine, wire: &'static str, points: &[[f64; 4]], skew: f32) -> Parity {
    let (scene, points, step) = example(points, 32);
    let mut results = Vec::new();
    let mut cpu = CpuEngine::new();
    let skewed = Step { level_ratio: skew * step.level_ratio, ..step };
    for (engine, step) in [(&mut cpu as &mut dyn Engine, &skewed), (&mut *engine, &step)] {
        let (mut terms, mut d_points) = (vec![0.0; term_count(scene.views.len())], Vec::new());
        engine.load(scene.clone()).done().await;
        engine.evaluate(&points, step, &mut terms, &mut d_points).done().await;
        let mut pictures = [Picture::Coverage, Picture::DCoverage].map(|picture| (picture, Vec::new()));
        for (picture, pixels) in &mut pictures {
            engine.fetch(*picture).done().await;
            (0..scene.views.len()).for_each(|view| pixels.extend_from_slice(engine.picture(*picture, view)));
        }
        let [(_, coverage), (_, d_coverage)] = pictures;
        results.push((coverage, terms, d_coverage, d_points));
    }
    let [(coverage, terms, d_coverage, d_points), device] = [&results[0], &results[1]];
    Parity {
        wire,
        coverage: device.0.iter().zip(coverage).map(|(a, b)| (a - b).abs()).fold(0.0, largest),
        loss: apart(&device.1, terms),
        d_coverage: apart(&device.2, d_coverage),
        gradient: apart(device.3.as_flattened(), d_points.as_flattened()),
    }
}

/// The larger one; not a number if one is not.
fn largest(a: f32, b: f32) -> f32 {
    if a >= b || a.is_nan() { a } else { b }
}

/// Relative l2 distance.
fn apart(a: &[f32], b: &[f32]) -> f32 {
    let squares = |values: &mut dyn Iterator<Item = f32>| values.map(|v| v * v).sum::<f32>();
    let size = squares(&mut b.iter().copied()).max(f32::MIN_POSITIVE);
    (squares(&mut a.iter().zip(b).map(|(a, b)| a - b)) / size).sqrt()
}

/// A tapered spiral.
fn spiral(count: usize) -> Vec<[f64; 4]> {
    let turns = 7.0 * (count as f64 / 12.0).sqrt();
    let point = |i: usize| {
        let t = i as f64 / (count - 1) as f64;
        let (sin, cos) = (turns * t).sin_cos();
        [(0.2 + 0.5 * t) * cos, (0.7 - 0.3 * t) * sin, t - 0.5, (0.05 + 0.1 * t) * (12.0 / count as f64).sqrt()]
    };
    (0..count).map(point).collect()
}

/// A wire through these points in three square views, and the numbers of an iteration.
fn example(points: &[[f64; 4]], size_px: usize) -> (Scene, Vec<[f32; 4]>, Step) {
    let wire = Wire::open_uniform(points.to_vec()).expect("the examples are wires");
    let view = |view: View| {
        let ink = (0..view.width_px * view.height_px).map(|i| (i % 7) as f32 / 7.0).collect();
        let target = Image { width: view.width_px, height: view.height_px, data: ink };
        SceneView::new(view.camera(), target, 1.0)
    };
    let views = View::canonical(2.0, size_px).map(view).to_vec();
    let points: Vec<[f32; 4]> = points.iter().map(|point| point.map(|c| c as f32)).collect();
    let elastic = Elastic {
        bending: 1e-3,
        cusp_radius: 0.1,
        tightness: 0.05,
        least_radius: 0.3,
        least_diameters: 4.0,
        evenness: 1e-2,
        speed: 0.4,
    };
    let clearance = Clearance { weight: 0.1, diameters: 3.0, least_world: 0.1, speed: 0.4 };
    let nodes = wire.nodes(3);
    let [places, first] = [&nodes.place, &nodes.first].map(|map| {
        let mut values = Vec::new();
        map.apply(&points, &mut values);
        values
    });
    let gap_world = 2.0 * points[points.len() / 2][3].max(0.05);
    let neighbours = Neighbours::find(&places, &nodes.lengths(&first), false, &clearance, gap_world, 0.0);
    let scene = Scene { nodes: Some(nodes), neighbours, ..Scene::new(&wire, 3, views) };
    let step = Step {
        rates: [1e-4; 4],
        adam: AdamOptions::default(),
        level_ratio: 0.5,
        jerk_position: 1e-4,
        jerk_width: 1e-4,
        length: 1e-3,
        width_bounds: [0.0, 2.0],
        loss_scale: 1.0,
        elastic,
        clearance,
        ..Step::default()
    };
    (scene, points, step)
}
