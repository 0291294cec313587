//! What a device is asked before it is trusted: one iteration of a small wire, compared with the processor's.

use super::Absence;
use crate::objective::Pyramid;
use crate::optimize::{AdamOptions, CpuEngine, Engine, RasterKind, Scene, SceneView, Step, term_count};
use crate::view::{Image, View};
use crate::wire::{Jerk, Wire};

/// Largest difference of loss and gradient, relative, that passes.
pub const SELF_CHECK_TOLERANCE: f32 = 1e-2;

/// Evaluates a tapered spiral on `engine` and on the processor: the relative l2 distances of losses and of gradients,
/// added up.
///
/// # Errors
/// [`Absence::Unfit`] if it is above [`SELF_CHECK_TOLERANCE`], or if the device fails.
pub async fn self_check(engine: &mut dyn Engine) -> Result<f32, Absence> {
    let (scene, points, step) = example();
    let mut results = Vec::new();
    let mut cpu = CpuEngine::new();
    for engine in [&mut cpu as &mut dyn Engine, &mut *engine] {
        let (mut terms, mut d_points) = (vec![0.0; term_count(scene.views.len())], Vec::new());
        engine.load(scene.clone()).done().await;
        engine.evaluate(&points, &step, &mut terms, &mut d_points).done().await;
        results.push((terms, d_points));
    }
    let unfit = |problem: String| Absence::Unfit { name: engine.place().device, problem };
    if let Some(error) = engine.trouble() {
        return Err(unfit(error.to_string()));
    }
    let apart = |a: &[f32], b: &[f32]| {
        let squares = |values: &mut dyn Iterator<Item = f32>| values.map(|v| v * v).sum::<f32>();
        (squares(&mut a.iter().zip(b).map(|(a, b)| a - b)) / squares(&mut b.iter().copied())).sqrt()
    };
    let [(terms, d_points), (device_terms, device_d_points)] = [&results[0], &results[1]];
    let difference = apart(device_terms, terms) + apart(device_d_points.as_flattened(), d_points.as_flattened());
    if difference.is_nan() || difference > SELF_CHECK_TOLERANCE {
        let problem = format!("it computes something else than the processor (by {difference:.1e} of a small example)");
        return Err(unfit(problem));
    }
    Ok(difference)
}

/// A tapered spiral in three small views.
fn example() -> (Scene, Vec<[f32; 4]>, Step) {
    let points: Vec<[f64; 4]> = (0..12)
        .map(|i| {
            let t = f64::from(i) / 11.0;
            let (sin, cos) = (7.0 * t).sin_cos();
            [(0.2 + 0.5 * t) * cos, (0.7 - 0.3 * t) * sin, t - 0.5, 0.05 + 0.1 * t]
        })
        .collect();
    let wire = Wire::open_uniform(points.clone()).expect("a spiral is a wire");
    let (sampling, strokes) = wire.sampling_map(3, true);
    let view = |view: View| {
        let ink = (0..view.width_px * view.height_px).map(|i| (i % 7) as f32 / 7.0).collect();
        let target = Image { width: view.width_px, height: view.height_px, data: ink };
        SceneView { camera: view.camera(), target, weight: 1.0 }
    };
    let views = View::canonical(2.0, 32).map(view).to_vec();
    let jerk = Jerk::new(&wire);
    let scene = Scene { sampling, strokes, jerk, views, raster: RasterKind::Exact, pyramid: Pyramid::AveragePool };
    let step = Step {
        rates: [0.0; 4],
        adam: AdamOptions::default(),
        level_ratio: 0.5,
        jerk_position: 1e-4,
        jerk_width: 1e-4,
        length: 1e-3,
        width_bounds: [0.0, 1.0],
        loss_scale: 1.0,
        gradient_share: 0.0,
    };
    let points: Vec<[f32; 4]> = points.iter().map(|point| point.map(|c| c as f32)).collect();
    (scene, points, step)
}
