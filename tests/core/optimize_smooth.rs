//! A wire that is kept smooth: gradients through the whole engine, adversarial starts, interruptions, even points.

use crate::optimize_common as common;

use common::{perturbed, random_wire, targets_of};
use wire4d::metrics::elegance;
use wire4d::objective::{Clearance, Elastic, Neighbours};
use wire4d::optimize::{
    CpuEngine, EventKind, Moment, Problem, RasterKind, Recipe, Respace, Scene, SceneView, Session, Smooth, Stage, Step,
    Thin, TopologyEdit, TopologyEvent, term_count,
};
use wire4d::rng::Rng;
use wire4d::view::{Target, View};
use wire4d::wire::Wire;

pub fn smooth_recipe(iterations: usize) -> Recipe {
    let stage = |share: usize, size_px| Stage {
        iterations: iterations * share / 2,
        size_px,
        raster: RasterKind::Exact,
        samples_per_span: 3,
        restarts: vec![],
    };
    let respace = |share: f64, spacing_px| TopologyEvent {
        at: Moment::Progress(share),
        edit: TopologyEdit::Respace(Respace { spacing_px, hairpin_px: 4.2 }),
    };
    Recipe {
        stages: vec![stage(1, 40), stage(1, 64)],
        smooth: Some(Smooth::default()),
        topology: vec![respace(0.25, 12.0), respace(0.6, 8.0)],
        ..Recipe::best()
    }
}

fn problem(wire: Wire, iterations: usize) -> Problem {
    Problem::for_drawings(wire, targets_of(&random_wire(14, 3), 64), smooth_recipe(iterations))
}

fn finished(problem: Problem) -> Session {
    let mut session = Session::new(problem).unwrap();
    session.step(usize::MAX);
    session
}

#[test]
fn the_engines_gradient_of_bending_and_clearance_agrees_with_differences() {
    // No view has any ink or weight: what is left is the wire's own.
    let wire = random_wire(20, 5);
    let views: Vec<SceneView> = View::canonical(2.2, 16)
        .into_iter()
        .map(|view| {
            let Target { view, ink } = Target { ink: wire4d::view::Image::new(16, 16), view };
            SceneView::new(view.camera(), ink, 0.0)
        })
        .collect();
    let nodes = wire.nodes::<f32>(3);
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
    let clearance = Clearance { weight: 3.0, diameters: 3.0, least_world: 0.2, speed: 0.2 };
    let elastic = Elastic {
        bending: 0.01,
        cusp_radius: 0.05,
        tightness: 0.2,
        least_radius: 0.2,
        least_diameters: 1.5,
        evenness: 0.1,
        speed: 0.2,
    };
    let (mut places, mut first) = (Vec::new(), Vec::new());
    nodes.place.apply(&points, &mut places);
    nodes.first.apply(&points, &mut first);
    let neighbours = Neighbours::find(&places, &nodes.lengths(&first), false, &clearance, 1.0, 0.05);
    assert!(!neighbours.others.is_empty());
    for (elastic, clearance) in [
        (elastic, Clearance::default()),
        (Elastic { bending: 0.0, tightness: 0.0, evenness: 0.0, ..elastic }, clearance),
        (elastic, clearance),
    ] {
        let mut engine = CpuEngine::new();
        let scene =
            Scene { nodes: Some(nodes.clone()), neighbours: neighbours.clone(), ..Scene::new(&wire, 2, views.clone()) };
        wire4d::optimize::wait(wire4d::optimize::Engine::load(&mut engine, scene).done());
        let step = Step { elastic, clearance, level_ratio: 0.5, ..Step::default() };
        let mut at = |points: &[[f32; 4]]| {
            let (mut terms, mut gradient) = (vec![0.0; term_count(3)], Vec::new());
            engine.evaluate_now(points, &step, &mut terms, &mut gradient);
            (f64::from(terms[0]), gradient)
        };
        let (_, gradient) = at(&points);
        let (mut off, mut size) = (0.0, 0.0);
        for i in 0..points.len() {
            for c in 0..4 {
                let h = 2e-3f32;
                let mut moved = |sign: f32| {
                    let mut moved = points.clone();
                    moved[i][c] += sign * h;
                    at(&moved).0
                };
                let numeric = (moved(1.0) - moved(-1.0)) / (2.0 * f64::from(h));
                off += (numeric - f64::from(gradient[i][c])).powi(2);
                size += numeric.powi(2);
            }
        }
        assert!(size > 0.0 && off < 4e-4 * size, "{:.1e} of {:.1e}", off.sqrt(), size.sqrt());
    }
}

#[test]
fn points_are_laid_anew_and_the_last_wire_is_the_result() {
    let start = perturbed(&random_wire(14, 3), 0.1, 8);
    let session = finished(problem(start, 80));
    let respaced: Vec<_> = session.events().iter().filter(|event| event.kind == EventKind::Respace).collect();
    assert_eq!(respaced.iter().map(|event| event.iteration).collect::<Vec<_>>(), [20, 48]);
    assert_eq!(session.wire().control_points().len(), respaced[1].count);
    assert!(respaced[1].count > respaced[0].count, "closer together");
    let losses = |name: &str| {
        let column = session.history().columns.iter().position(|column| column == name).unwrap();
        session.history().rows().map(|row| row[column]).collect::<Vec<_>>()
    };
    assert!(losses("bending").iter().all(|&loss| loss > 0.0));
    assert_eq!(losses("tightness")[0], 0.0, "ramped in");
    // The best wire is the one before the last step.
    let (best, last) = (session.best(), session.wire());
    let gap = best
        .control_points()
        .iter()
        .zip(last.control_points())
        .map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max));
    assert!(gap.fold(0.0, f64::max) < 0.05);
}

#[test]
fn spare_points_go_and_the_curve_stays() {
    let thinned = |tolerance_px: f64| {
        let mut problem = problem(perturbed(&random_wire(14, 3), 0.1, 8), 80);
        let edit = TopologyEdit::Thin(Thin { tolerance_px });
        problem.recipe.topology.push(TopologyEvent { at: Moment::Progress(0.9), edit });
        let mut session = Session::new(problem).unwrap();
        session.step(72);
        let before = session.wire();
        session.step(1);
        let event = *session.events().iter().find(|event| event.kind == EventKind::Thin).unwrap();
        (before, session.wire(), event.count)
    };
    let (before, after, gone) = thinned(1.0);
    assert!(gone > 0 && after.control_points().len() + gone == before.control_points().len());
    // A pixel of 256 and the step of an iteration.
    let far = |a: &Wire, b: &Wire| {
        let (start, end) = a.domain();
        (0..=500).map(|i| start + (end - start) * f64::from(i) / 500.0).fold(0.0f64, |most, t| {
            let (a, b) = (a.evaluate(t), b.evaluate(t));
            most.max((0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt())
        })
    };
    assert!(far(&before, &after) < 0.03, "{}", far(&before, &after));
    assert_eq!(thinned(0.0).2, 0);
}

#[test]
fn interruptions_and_pieces_change_no_bit() {
    let start = || perturbed(&random_wire(14, 3), 0.1, 8);
    let whole = finished(problem(start(), 80));
    for stops in [vec![1, 7], vec![20, 21, 22], vec![39, 47, 49, 66]] {
        let mut session = Session::new(problem(start(), 80)).unwrap();
        for stop in stops {
            session.step(stop - session.iteration());
            let bytes = serde_json::to_vec(&session.checkpoint()).unwrap();
            session = Session::resume(problem(start(), 80), serde_json::from_slice(&bytes).unwrap()).unwrap();
        }
        session.step(usize::MAX);
        assert_eq!((session.wire(), session.best()), (whole.wire(), whole.best()));
        assert_eq!(session.history(), whole.history());
    }
    let mut other = problem(start(), 80);
    other.recipe.smooth.as_mut().unwrap().least_radius_px = 12.0;
    assert_ne!(finished(other).wire(), whole.wire(), "what is asked of the wire counts");
}

/// Starts that no drawing would give.
fn adversarial() -> Vec<(&'static str, Wire)> {
    let closed = |points: Vec<[f64; 4]>| Wire::closed_uniform(points).unwrap();
    let mut rng = Rng::new(1, 9);
    let turn = |share: f64| share * std::f64::consts::TAU;
    vec![
        ("a knot", {
            let trefoil = |a: f64| [a.sin() + 2.0 * (2.0 * a).sin(), a.cos() - 2.0 * (2.0 * a).cos(), -(3.0 * a).sin()];
            closed(
                (0..40)
                    .map(|i| trefoil(turn(f64::from(i) / 40.0)))
                    .map(|[x, y, z]| [0.2 * x, 0.2 * y, 0.2 * z, 0.05])
                    .collect(),
            )
        }),
        ("a coil within its own diameter", {
            let coil = |i: i32| {
                [
                    0.02 * turn(f64::from(i) / 8.0).cos(),
                    0.02 * turn(f64::from(i) / 8.0).sin(),
                    0.004 * f64::from(i) - 0.2,
                    0.06,
                ]
            };
            Wire::open_uniform((0..100).map(coil).collect()).unwrap()
        }),
        ("coincident strands", {
            let there = |i: i32| f64::from(if i < 20 { i } else { 40 - i }) * 0.04 - 0.4;
            closed((0..40).map(|i| [there(i), 0.1 * rng.range(-1e-9, 1e-9), 0.0, 0.04]).collect())
        }),
        (
            "a straight line",
            Wire::open_uniform((0..12).map(|i| [0.08 * f64::from(i) - 0.4, 0.0, 0.0, 0.03]).collect()).unwrap(),
        ),
        ("one point", closed(vec![[0.1, 0.1, 0.1, 0.03]; 8])),
        (
            "as few points as there can be",
            Wire::open_uniform(vec![
                [-0.3, 0.0, 0.0, 0.03],
                [0.0, 0.3, 0.0, 0.03],
                [0.1, 0.0, 0.2, 0.03],
                [0.3, -0.2, 0.0, 0.03],
            ])
            .unwrap(),
        ),
    ]
}

#[test]
fn adversarial_starts_give_no_nan_and_no_more_penetration() {
    for (name, wire) in adversarial() {
        let before = elegance(&wire).0;
        let session = finished(problem(wire, 120));
        assert!(session.events().iter().all(|event| event.kind != EventKind::Undone), "{name}: a step was undone");
        let wire = session.best();
        assert!(wire.control_points().iter().flatten().all(|c| c.is_finite()), "{name}");
        let after = elegance(&wire).0;
        let [before, after] = [before, after].map(|found| found.penetrating_share);
        println!("{name}: penetrating {before:.3} to {after:.3}");
        assert!(after <= before + 1e-9, "{name}: {before} to {after}");
    }
}
