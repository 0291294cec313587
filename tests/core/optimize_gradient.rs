//! The gradient of a whole iteration, from the loss back to the control points, against differences of the loss.

use crate::optimize_common as common;

use common::{perturbed, random_wire, targets_of};
use wire4d::objective::Pyramid;
use wire4d::optimize::{AdamOptions, CpuEngine, Engine, RasterKind, Scene, SceneView, Step, term_count};
use wire4d::rng::Rng;
use wire4d::view::{Image, Occluder, Projection, Target};
use wire4d::wire::{Form, Wire};

fn step() -> Step {
    Step {
        rates: [0.0; 4],
        adam: AdamOptions::default(),
        level_ratio: 1.3,
        jerk_position: 1e-3,
        jerk_width: 2e-3,
        length: 1e-2,
        surface: 0.2,
        width_bounds: [0.0, 1.0],
        ..Step::default()
    }
}

fn scene(wire: &Wire, targets: &[Target], raster: RasterKind, pyramid: Pyramid) -> Scene {
    let views = targets.iter().zip([1.0, 0.5, 2.0]);
    let views = views.map(|(target, weight)| SceneView::new(target.view.camera(), target.ink.clone(), weight));
    Scene { raster, pyramid, ..Scene::new(wire, 8, views.collect()) }
}

/// How far the gradient is from central differences of the loss along random directions: the largest difference over
/// the root mean square of the slopes.
fn disagreement(scene: Scene, wire: &Wire, spoil: impl Fn(&mut [[f32; 4]])) -> f64 {
    let mut engine = CpuEngine::new();
    let mut terms = vec![0.0; term_count(scene.views.len())];
    engine.load(scene);
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
    let mut gradient = Vec::new();
    engine.evaluate(&points, &step(), &mut terms, &mut gradient);
    spoil(&mut gradient);
    let mut loss = |direction: &[[f64; 4]], h: f64| {
        let moved: Vec<[f32; 4]> = points
            .iter()
            .zip(direction)
            .map(|(p, d)| std::array::from_fn(|c| (f64::from(p[c]) + h * d[c]) as f32))
            .collect();
        engine.evaluate(&moved, &step(), &mut terms, &mut Vec::new());
        terms[1..].iter().map(|&term| f64::from(term)).sum::<f64>()
    };
    let mut rng = Rng::new(6, 0);
    let (mut worst, mut squares) = (0.0f64, 0.0);
    let directions = 24;
    for _ in 0..directions {
        let direction: Vec<[f64; 4]> = points
            .iter()
            .map(|_| std::array::from_fn(|c| rng.range(-1.0, 1.0) * if c == 3 { 0.5 } else { 1.0 }))
            .collect();
        // A twentieth of a pixel.
        let h = 0.05 * 2.2 / 96.0;
        let measured = (loss(&direction, h) - loss(&direction, -h)) / (2.0 * h);
        let expected: f64 =
            gradient.iter().zip(&direction).map(|(g, d)| (0..4).map(|c| f64::from(g[c]) * d[c]).sum::<f64>()).sum();
        worst = worst.max((measured - expected).abs());
        squares += measured * measured / f64::from(directions);
    }
    worst / squares.sqrt()
}

#[test]
fn the_gradient_of_an_iteration_agrees_with_differences_of_its_loss() {
    let truth = random_wire(12, 4);
    let mut perspective = targets_of(&truth, 96);
    perspective[1].view.projection = Projection::Perspective { fov_y_rad: 0.7 };
    let start = perturbed(&truth, 0.15, 8);
    // Where two ends lie on each other the loss has a kink, and no difference tells its slope.
    let bag = perturbed(&start.to_form(Form::Bag).unwrap(), 0.1, 9);
    for (wire, pyramid) in [
        (start.clone(), Pyramid::Gaussian),
        (bag, Pyramid::AveragePool),
        (Wire::closed_uniform(start.control_points().to_vec()).unwrap(), Pyramid::Gaussian),
    ] {
        let scene = || scene(&wire, &perspective, RasterKind::Exact, pyramid);
        let off = disagreement(scene(), &wire, |_| {});
        assert!(off < 0.05, "{:?} {pyramid:?}: {off}", wire.form());
        // Siblings: gradients that are wrong in one place or one component are noticed.
        assert!(disagreement(scene(), &wire, |g| g[5] = [0.0; 4]) > 0.1);
        assert!(disagreement(scene(), &wire, |g| g.iter_mut().for_each(|g| g[2] *= 0.8)) > 0.1);
        assert!(disagreement(scene(), &wire, |g| g.iter_mut().for_each(|g| g[3] *= 0.5)) > 0.1);
    }
}

#[test]
fn the_gradient_knows_what_is_hidden_and_where_the_surface_is() {
    let truth = random_wire(12, 4);
    let (targets, wire) = (targets_of(&truth, 96), perturbed(&truth, 0.15, 8));
    let mut scene = scene(&wire, &targets, RasterKind::Exact, Pyramid::AveragePool);
    let mut rng = Rng::new(7, 0);
    for view in &mut scene.views {
        // Walls through the middle: no pixel's depth differs from its neighbours', so the loss has no steps.
        let depth = Image { data: vec![2.95; view.target.data.len()], ..view.target.clone() };
        view.occluder = Some(Occluder { steepness: 10.0, ..Occluder::new(depth) });
    }
    let count = scene.sampling.rows().len();
    scene.planes = (0..count).map(|_| [0.6, 0.0, 0.8, rng.range(-0.5, 0.5) as f32]).collect();
    let off = disagreement(scene.clone(), &wire, |_| {});
    assert!(off < 0.05, "{off}");
    assert!(disagreement(scene.clone(), &wire, |g| g.iter_mut().for_each(|g| g[2] *= 0.8)) > 0.1);
    let without = |scene: Scene| {
        let (mut engine, mut gradient) = (CpuEngine::new(), Vec::new());
        let mut terms = vec![0.0; term_count(3)];
        engine.load(scene);
        let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
        engine.evaluate(&points, &step(), &mut terms, &mut gradient);
        gradient
    };
    // Siblings: gradients that forget one or the other.
    let mut open = scene.clone();
    open.views.iter_mut().for_each(|view| view.occluder = None);
    for other in [open, Scene { planes: Vec::new(), ..scene.clone() }] {
        let other = without(other);
        assert!(disagreement(scene.clone(), &wire, |g| g.copy_from_slice(&other)) > 0.1);
    }
}

#[test]
fn the_band_points_the_same_way_but_is_no_exact_gradient() {
    let truth = random_wire(12, 4);
    let (targets, start) = (targets_of(&truth, 96), perturbed(&truth, 0.15, 8));
    let off = disagreement(scene(&start, &targets, RasterKind::Band, Pyramid::Gaussian), &start, |_| {});
    assert!(off > 0.02, "{off}: that is why it only serves in a first stage");
}
