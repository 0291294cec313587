//! A known wire, seen from three sides, is found again from a poor start, in every form.

use crate::optimize_common as common;

use common::{mean_iou, perturbed, random_wire, targets_of};
use wire4d::optimize::{EventKind, Problem, RasterKind, Recipe, Schedule, Session, Stage};
use wire4d::wire::{Form, Wire};

fn recipe(iterations: usize) -> Recipe {
    let stage = Stage { iterations, size_px: 128, raster: RasterKind::Exact, samples_per_span: 8, restarts: vec![] };
    Recipe {
        stages: vec![stage],
        jerk_position: Schedule::Constant(1e-5),
        jerk_width: Schedule::Constant(1e-5),
        ..Recipe::best()
    }
}

#[test]
fn a_perturbed_wire_finds_its_pictures_again() {
    let truth = random_wire(24, 3);
    let targets = targets_of(&truth, 128);
    let start = perturbed(&truth, 0.1, 8);
    let mut session = Session::new(Problem::for_drawings(start.clone(), targets.clone(), recipe(300))).unwrap();
    let before = mean_iou(&start, &targets);
    let events = session.step(1000);
    assert!(session.is_done() && events.last().unwrap().kind == EventKind::Done);
    let after = mean_iou(&session.wire(), &targets);
    assert!(before < 0.4 && after > 0.9, "IoU {before} -> {after}");
    assert!((mean_iou(&session.best(), &targets) - after).abs() < 0.02);
    let rows: Vec<_> = session.history().rows().collect();
    assert_eq!(rows.len(), 300);
    assert!(rows[299][0] < 0.1 * rows[0][0]);
    let columns = &session.history().columns;
    assert_eq!(columns[..8], ["total", "front", "side", "top", "jerk", "length", "surface", "texture"]);
    assert_eq!(columns[8..], ["bending", "tightness", "evenness", "clearance", "guidance"]);
}

#[test]
fn baseline_forms_and_closed_wires_fit_too() {
    let truth = random_wire(24, 3);
    let targets = targets_of(&truth, 128);
    let closed = Wire::closed_uniform(truth.control_points().to_vec()).unwrap();
    for (start, least) in [
        (truth.to_form(Form::Chain).unwrap(), 0.85),
        (truth.to_form(Form::Bag).unwrap(), 0.85),
        // It has one link more than the truth.
        (closed, 0.75),
    ] {
        let start = perturbed(&start, 0.05, 8);
        let mut session = Session::new(Problem::for_drawings(start.clone(), targets.clone(), recipe(300))).unwrap();
        session.step(usize::MAX);
        let (before, after) = (mean_iou(&start, &targets), mean_iou(&session.wire(), &targets));
        assert!(before < 0.6 && after > least, "{:?}: IoU {before} -> {after}", start.form());
        assert_eq!((session.wire().form(), session.wire().closed()), (start.form(), start.closed()));
    }
}

#[test]
fn equal_bounds_keep_the_width_constant() {
    let truth = random_wire(12, 5);
    let start = perturbed(&truth, 0.1, 8);
    let mut problem = Problem::for_drawings(start, targets_of(&truth, 64), recipe(20));
    problem.width.min_world = 0.05;
    problem.width.max_world = 0.05;
    let mut session = Session::new(problem.clone()).unwrap();
    session.step(20);
    assert!(session.wire().control_points().iter().all(|point| point[3] == f64::from(0.05f32)));
    problem.width.min_world = 0.01;
    let mut session = Session::new(problem).unwrap();
    session.step(20);
    let widths: Vec<f64> = session.wire().control_points().iter().map(|point| point[3]).collect();
    assert!(widths.iter().all(|&width| (0.0099..0.0501).contains(&width)) && widths.iter().any(|&w| w < 0.049));
}

#[test]
fn a_longer_weight_on_length_makes_a_shorter_wire() {
    let truth = random_wire(16, 7);
    let length = |weight: f64| {
        let recipe = Recipe { length: Schedule::Constant(weight), ..recipe(60) };
        let problem = Problem::for_drawings(perturbed(&truth, 0.1, 8), targets_of(&truth, 64), recipe);
        let mut session = Session::new(problem).unwrap();
        session.step(60);
        session.wire().length(1e-6)
    };
    assert!(length(0.1) < 0.9 * length(0.0));
}
