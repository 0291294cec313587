//! What guides a fit: its gradient, its repeatability, and that a fit survives it.
use crate::guided::{Compares, Noise};
use crate::optimize_common::{perturbed, random_wire, targets_of};

use wire4d::objective::Pyramid;
use wire4d::optimize::{
    CpuEngine, Engine, EventKind, Problem, Recipe, Scene, SceneView, Session, Step, Term, term_count, wait,
};
use wire4d::view::View;

fn problem() -> Problem {
    let wire = random_wire(24, 3);
    let mut recipe = Recipe::best();
    recipe.set_iterations(40, 0.25);
    Problem { seed: 3, ..Problem::for_drawings(perturbed(&wire, 0.05, 4), targets_of(&wire, 96), recipe) }
}

#[test]
fn its_gradient_goes_all_the_way_back() {
    let wire = random_wire(24, 5);
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|point| point.map(|c| c as f32)).collect();
    let wanted: Vec<_> = targets_of(&random_wire(24, 6), 64).into_iter().map(|target| target.ink).collect();
    let view = |(v, view): (usize, View)| SceneView::new(view.camera(), wanted[v].clone(), 0.5 + v as f32);
    let scene = Scene::new(&wire, 3, View::canonical(2.2, 64).into_iter().enumerate().map(view).collect());
    let step = Step { level_ratio: 0.7, ..Step::default() };
    let evaluate = |weight: f32| {
        // A clone would share its handle.
        let scene = Scene { guides: Default::default(), ..scene.clone() };
        if weight > 0.0 {
            let compares = Compares { wanted: wanted.clone(), pyramid: Pyramid::AveragePool, level_ratio: 0.7 };
            scene.guides.set("the same again", weight, Box::new(compares));
        }
        let (mut engine, mut terms, mut gradient) = (CpuEngine::new(), vec![0.0; term_count(3)], Vec::new());
        wait(engine.load(scene).done());
        wait(engine.evaluate(&points, &step, &mut terms, &mut gradient).done());
        (terms, gradient)
    };
    let (alone, pulled) = evaluate(0.0);
    let (both, guided) = evaluate(2.0);
    let image: f32 = alone[1..4].iter().sum();
    assert!((both[Term::Guidance.at(3)] - 2.0 * image).abs() < 1e-5 * image && alone[Term::Guidance.at(3)] == 0.0);
    assert!((both[0] - 3.0 * image).abs() < 1e-5 * image);
    let scale = pulled.as_flattened().iter().fold(0.0f32, |a, d| a.max(d.abs()));
    let off = |factor: f32| {
        let pairs = guided.as_flattened().iter().zip(pulled.as_flattened());
        pairs.fold(0.0f32, |a, (g, p)| a.max((g - factor * p).abs())) / scale
    };
    assert!(scale > 0.0 && off(3.0) < 1e-4, "{:e}", off(3.0));
    assert!(off(2.99) > 1e-4, "another weight is seen");
}

#[test]
fn a_guided_session_resumes_bit_for_bit_with_the_same_guidance() {
    let guided = || Box::new(Noise { fails_at: usize::MAX });
    let mut session = Session::new(problem()).unwrap();
    session.guide_by("noise", 30.0, guided());
    session.step(17);
    let checkpoint = session.checkpoint();
    session.step(usize::MAX);
    let mut resumed = Session::resume(problem(), checkpoint.clone()).unwrap();
    resumed.guide_by("noise", 30.0, guided());
    resumed.step(usize::MAX);
    assert!(resumed.best() == session.best() && resumed.history() == session.history());
    let mut without = Session::resume(problem(), checkpoint).unwrap();
    without.step(usize::MAX);
    assert!(without.best() != session.best(), "that it guides is seen");
}

#[test]
fn what_fails_in_mid_run_is_switched_off_and_nothing_is_lost() {
    let mut session = Session::new(problem()).unwrap();
    session.guide_by("cat.onnx", 30.0, Box::new(Noise { fails_at: 9 }));
    let events = session.step(usize::MAX);
    let unguided: Vec<_> = events.iter().filter(|event| event.kind == EventKind::Unguided).collect();
    assert!(matches!(&unguided[..], [event] if event.iteration == 10 && event.count == 1), "{unguided:?}");
    assert!(session.is_done() && session.best().control_points().iter().flatten().all(|c| c.is_finite()));
    let troubles = session.guidance_troubles();
    assert_eq!(troubles.len(), 1);
    assert_eq!(troubles[0].1.to_string(), "cat.onnx: it was switched off in the middle; the wire goes on without it");
    let column = session.history().columns.iter().position(|name| name == "guidance").unwrap();
    let losses: Vec<f32> = session.history().rows().map(|row| row[column]).collect();
    assert!(losses[..9].iter().all(|&loss| loss != 0.0) && losses[9..].iter().all(|&loss| loss == 0.0));

    // One that fails at once has never been there.
    let mut at_once = Session::new(problem()).unwrap();
    at_once.guide_by("cat.onnx", 30.0, Box::new(Noise { fails_at: 0 }));
    at_once.step(usize::MAX);
    let mut never = Session::new(problem()).unwrap();
    never.step(usize::MAX);
    assert!(at_once.wire() == never.wire());
}

#[test]
fn it_can_come_and_go() {
    let mut session = Session::new(problem()).unwrap();
    session.step(5);
    session.guide_by("noise", 1.0, Box::new(Noise { fails_at: usize::MAX }));
    session.step(5);
    session.stop_guiding("noise");
    session.step(5);
    let column = session.history().columns.iter().position(|name| name == "guidance").unwrap();
    let guided: Vec<bool> = session.history().rows().map(|row| row[column] != 0.0).collect();
    assert_eq!(guided, [[false; 5], [true; 5], [false; 5]].concat());
}

#[test]
fn checkpoints_from_before_there_was_guidance_still_resume() {
    let mut session = Session::new(problem()).unwrap();
    session.step(12);
    let mut old = serde_json::to_value(session.checkpoint()).unwrap();
    let history = &mut old["history"];
    let columns = history["columns"].as_array_mut().unwrap();
    assert_eq!(columns.pop().unwrap(), "guidance");
    let width = columns.len() + 1;
    let values =
        history["values"].as_array().unwrap().chunks(width).flat_map(|row| row[..width - 1].to_vec()).collect();
    history["values"] = serde_json::Value::Array(values);
    let mut resumed = Session::resume(problem(), serde_json::from_value(old).unwrap()).unwrap();
    session.step(usize::MAX);
    resumed.step(usize::MAX);
    assert!(resumed.best() == session.best() && resumed.history() == session.history());
}
