//! The engine on a device against the processor's: one iteration, whole fits, the same bits every time.
use crate::gpu_common;
use crate::optimize_common;

use gpu_common::{device, distance, enclosed, neighbours, points, scene, step, views, wiry, with_strands};
use optimize_common::{mean_iou, perturbed, random_wire, targets_of};
use std::f64::consts::PI;
use wire4d::Error;
use wire4d::gpu::{Absence, Device, FaultKind, GpuEngine, Kind, SELF_CHECK_BARS, parities, self_check};
use wire4d::objective::{Clearance, Elastic, Neighbours, Pyramid};
use wire4d::optimize::{
    Adam, CpuEngine, Engine, Picture, Place, Problem, RasterKind, Recipe, Scene, SceneView, Session, Smooth, State,
    Step, Tally, Work, term_count, wait,
};
use wire4d::view::{Image, Occluder, View};
use wire4d::wire::Wire;

const LOSS: f64 = 1e-4;
const GRADIENT: f64 = 1e-3;

fn evaluate(engine: &mut dyn Engine, wire: &Wire, views: &[View], step: &Step) -> (Vec<f32>, Vec<[f32; 4]>) {
    wait(engine.load(scene(wire, views, 2, Pyramid::AveragePool, 3)).done());
    evaluate_loaded(engine, wire, views.len(), step)
}

fn evaluate_loaded(engine: &mut dyn Engine, wire: &Wire, views: usize, step: &Step) -> (Vec<f32>, Vec<[f32; 4]>) {
    let (mut terms, mut d_points) = (vec![0.0; term_count(views)], Vec::new());
    wait(engine.evaluate(&points(wire), step, &mut terms, &mut d_points).done());
    (terms, d_points)
}

/// How far two evaluations are apart: terms, gradients.
fn apart(a: &(Vec<f32>, Vec<[f32; 4]>), b: &(Vec<f32>, Vec<[f32; 4]>)) -> (f64, f64) {
    (distance(&a.0, &b.0), distance(a.1.as_flattened(), b.1.as_flattened()))
}

fn moved(wire: &Wire, change: impl Fn(usize, [f64; 4]) -> [f64; 4]) -> Wire {
    let points = wire.control_points().iter().enumerate().map(|(i, &point)| change(i, point)).collect();
    Wire::open_uniform(points).unwrap()
}

fn random_and_hostile() -> [(&'static str, Wire); 8] {
    let random = random_wire(30, 1);
    [
        ("random", random.clone()),
        ("another", random_wire(60, 2)),
        ("off screen", moved(&random, |_, [x, y, z, w]| [x + 9.0, y, z, w])),
        ("half off screen", moved(&random, |_, [x, y, z, w]| [x + 1.0, y - 0.7, z, w])),
        ("zero width", moved(&random, |_, [x, y, z, _]| [x, y, z, 0.0])),
        ("one span", Wire::open_uniform(random.control_points()[..4].to_vec()).unwrap()),
        (
            "coincident points",
            moved(&random, |i, point| if i % 3 == 0 { point } else { random.control_points()[i / 3 * 3] }),
        ),
        ("huge width", moved(&random, |_, [x, y, z, _]| [x, y, z, 1.5])),
    ]
}

#[test]
fn an_iteration_agrees_on_random_and_hostile_wires() {
    let Some(device) = device() else { return };
    let mut engine = GpuEngine::new(&device, "");
    for (name, wire) in random_and_hostile() {
        let (terms, d_points) = evaluate(&mut CpuEngine::new(), &wire, &views(64), &step());
        let (device_terms, device_d_points) = evaluate(&mut engine, &wire, &views(64), &step());
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        let loss = distance(&device_terms, &terms);
        let gradient = distance(device_d_points.as_flattened(), d_points.as_flattened());
        eprintln!("{name}: loss {loss:.1e}, gradient {gradient:.1e}");
        assert!(loss <= LOSS && gradient <= GRADIENT, "{name}: loss {loss:.1e}, gradient {gradient:.1e}");
        // Siblings: other numbers, and a wire a little off, are seen.
        let (terms, _) = evaluate(&mut engine, &wire, &views(64), &Step { level_ratio: 0.71, ..step() });
        assert!(distance(&device_terms, &terms) > LOSS, "{name}: another level weight passes");
        let (_, d_points) = evaluate(&mut engine, &wire, &views(64), &Step { length: 0.03, ..step() });
        let off = distance(device_d_points.as_flattened(), d_points.as_flattened());
        assert!(off > GRADIENT, "{name}: another length weight passes ({off:.1e})");
    }
}

#[test]
fn wires_round_solids_agree_before_and_after_views_and_planes_change() {
    let Some(device) = device() else { return };
    let wire = random_wire(60, 2);
    let scenes = [(3, 2), (4, 5)]
        .map(|(ink, planes)| enclosed(scene(&wire, &views(64), 4, Pyramid::AveragePool, ink), planes))
        .map(|scene| (scene.views.clone(), scene));
    let [(_, first), (mut views, second)] = scenes;
    // Other cameras, and what was open is shut and the other way round.
    views.iter_mut().zip(&first.views).for_each(|(view, other)| {
        view.occluder = other
            .occluder
            .is_none()
            .then(|| Occluder::new(Image { data: vec![2.9; view.target.data.len()], ..view.target.clone() }));
        view.camera = other.camera;
        view.weight *= 0.8;
    });
    views[0].camera = View::orthographic("front", 0.7, -0.3, 2.2, 64).camera();
    let engines: [&mut dyn Engine; 2] = [&mut CpuEngine::new(), &mut GpuEngine::new(&device, "")];
    let results = engines.map(|engine| {
        wait(engine.load(first.clone()).done());
        let mut found = vec![evaluate_loaded(engine, &wire, 3, &step())];
        wait(engine.set_views(vec![views.clone()]).done());
        found.push(evaluate_loaded(engine, &wire, 3, &step()));
        engine.set_planes(second.planes.clone());
        found.push(evaluate_loaded(engine, &wire, 3, &step()));
        wait(engine.load(Scene { views: views.clone(), ..second.clone() }).done());
        found.push(evaluate_loaded(engine, &wire, 3, &step()));
        wait(engine.load(scene(&wire, &gpu_common::views(64), 4, Pyramid::AveragePool, 3)).done());
        found.push(evaluate_loaded(engine, &wire, 3, &step()));
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        found
    });
    let [cpu, gpu] = &results;
    for (gpu, cpu) in gpu.iter().zip(cpu) {
        let (loss, gradient) = apart(gpu, cpu);
        eprintln!("round solids: loss {loss:.1e}, gradient {gradient:.1e}");
        assert!(loss <= LOSS && gradient <= GRADIENT, "loss {loss:.1e}, gradient {gradient:.1e}");
    }
    for results in &results {
        assert!(results[2] == results[3], "what is exchanged is what is loaded");
    }
    // Siblings: views, planes and occluders are seen.
    for (i, j) in [(0, 1), (1, 2), (0, 4)] {
        let (loss, gradient) = apart(&gpu[i], &cpu[j]);
        // Planes at random are a small part of the loss.
        assert!(
            (loss > LOSS || i == 1) && gradient > GRADIENT,
            "{i} passes for {j}: loss {loss:.1e}, gradient {gradient:.1e}"
        );
    }
}

#[test]
fn a_wire_as_long_as_a_filling_agrees() {
    let Some(device) = device() else { return };
    // A spiral over a ball, 60 times round, that swells and thins.
    let points = (0..4000).map(|i| {
        let t = (f64::from(i) + 0.5) / 4000.0;
        let (ring, height) = ((PI * t).sin(), (PI * t).cos());
        let (sin, cos) = (120.0 * PI * t).sin_cos();
        [0.9 * ring * cos, 0.9 * height, 0.9 * ring * sin, 0.012 + 0.006 * (300.0 * t).sin()]
    });
    let wire = Wire::open_uniform(points.collect()).unwrap();
    let scene = enclosed(scene(&wire, &views(128), 4, Pyramid::AveragePool, 3), 2);
    let engines: [&mut dyn Engine; 2] = [&mut CpuEngine::new(), &mut GpuEngine::new(&device, "")];
    let [cpu, gpu] = engines.map(|engine| {
        wait(engine.load(scene.clone()).done());
        let found = [step(), Step { level_ratio: 0.71, ..step() }].map(|step| evaluate_loaded(engine, &wire, 3, &step));
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        found
    });
    let (loss, gradient) = apart(&gpu[0], &cpu[0]);
    eprintln!("a long wire: loss {loss:.1e}, gradient {gradient:.1e}");
    assert!(loss <= LOSS && gradient <= GRADIENT, "loss {loss:.1e}, gradient {gradient:.1e}");
    let (loss, gradient) = apart(&gpu[1], &cpu[0]);
    assert!(loss > LOSS && gradient > GRADIENT, "another level weight passes");
}

/// Bending, tightness, evenness and clearance among the terms of three views.
const STRAND: std::ops::Range<usize> = 8..12;

#[test]
fn what_keeps_a_wire_a_wire_agrees_on_random_and_hostile_wires() {
    let Some(device) = device() else { return };
    let mut engine = GpuEngine::new(&device, "");
    let wiry = wiry(1.0);
    let (elastic, clearance) = (wiry.elastic, wiry.clearance);
    let off = Elastic { bending: 0.0, tightness: 0.0, evenness: 0.0, ..elastic };
    // Each alone, then all together.
    let steps = [
        Step { elastic: Elastic { bending: elastic.bending, ..off }, ..step() },
        Step { elastic: Elastic { tightness: elastic.tightness, ..off }, ..step() },
        Step { elastic: Elastic { evenness: elastic.evenness, ..off }, ..step() },
        Step { clearance, ..step() },
        wiry,
    ];
    let closed = Wire::closed_uniform(random_wire(40, 3).control_points().to_vec()).unwrap();
    let there_and_back = moved(&random_wire(30, 1), |i, _| random_wire(30, 1).control_points()[i.abs_diff(15)]);
    // Bent so little that 1 + ρ²κ² keeps few digits of it.
    let gentle = moved(&random_wire(30, 1), |i, [_, _, _, w]| {
        let (sin, cos) = (0.05 * i as f64).sin_cos();
        [20.0 * cos - 19.5, 20.0 * sin - 1.0, 0.1, w]
    });
    let others = [("closed", closed), ("there and back", there_and_back), ("gentle", gentle)];
    let mut seen = [0.0f32; 4];
    for (name, wire) in random_and_hostile().into_iter().chain(others) {
        let scene = with_strands(scene(&wire, &views(32), 2, Pyramid::AveragePool, 3), &wire);
        // Pictures would hide much.
        let unseen = scene.views.iter().map(|view| SceneView { weight: 0.0, ..view.clone() }).collect();
        let bare = Step { jerk_position: 0.0, jerk_width: 0.0, length: 0.0, ..wiry };
        for scene in [scene.clone(), Scene { views: unseen, ..scene }] {
            let mut cpu = CpuEngine::new();
            wait(cpu.load(scene.clone()).done());
            wait(engine.load(scene.clone()).done());
            let blind = scene.views[0].weight == 0.0;
            for (i, &step) in steps.iter().enumerate() {
                let step = if blind { Step { elastic: step.elastic, clearance: step.clearance, ..bare } } else { step };
                let [cpu, gpu] =
                    [&mut cpu as &mut dyn Engine, &mut engine].map(|e| evaluate_loaded(e, &wire, 3, &step));
                assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
                let (loss, gradient) = apart(&gpu, &cpu);
                let strand = distance(&gpu.0[STRAND], &cpu.0[STRAND]);
                eprintln!("{name}, {i}: loss {loss:.1e}, strand {strand:.1e}, gradient {gradient:.1e}");
                assert!(
                    loss <= LOSS && strand <= LOSS && gradient <= GRADIENT,
                    "{name}, {i}: loss {loss:.1e}, strand {strand:.1e}, gradient {gradient:.1e}"
                );
                assert!(gpu.1.as_flattened().iter().all(|d| d.is_finite()));
                (0..4).for_each(|t| seen[t] += f32::from(gpu.0[STRAND][t] > 0.0));
                // Sibling: a weight that is a little off is seen.
                let with = |weight: f32| {
                    let Step { elastic: e, clearance: c, .. } = step;
                    let elastic = Elastic {
                        bending: weight * e.bending,
                        tightness: weight * e.tightness,
                        evenness: weight * e.evenness,
                        ..e
                    };
                    Step { elastic, clearance: Clearance { weight: weight * c.weight, ..c }, ..step }
                };
                let (other, wrong) = (evaluate_loaded(&mut engine, &wire, 3, &with(1.01)), cpu.0[STRAND].to_vec());
                if wrong.iter().sum::<f32>() > 0.0 {
                    assert!(distance(&other.0[STRAND], &wrong) > LOSS, "{name}, {i}: another weight passes");
                    assert!(!blind || apart(&other, &cpu).1 > GRADIENT, "{name}, {i}: another weight pulls as much");
                }
            }
        }
    }
    eprintln!("above 0: {seen:?}");
    assert!(seen.iter().all(|&count| count > 20.0), "too little is bent, tight, uneven or near: {seen:?}");
}

#[test]
fn neighbours_are_exchanged_between_iterations() {
    let Some(device) = device() else { return };
    let wire = random_wire(60, 2);
    let scene = with_strands(scene(&wire, &views(32), 2, Pyramid::AveragePool, 3), &wire);
    // As they are elsewhere: another number of others.
    let elsewhere = neighbours(&wire, &points(&perturbed(&wire, 0.2, 5)));
    let none = Neighbours::none(scene.neighbours.starts.len() - 1);
    let lists = [none, elsewhere, scene.neighbours.clone()];
    let engines: [&mut dyn Engine; 2] = [&mut CpuEngine::new(), &mut GpuEngine::new(&device, "")];
    let [cpu, gpu] = engines.map(|engine| {
        wait(engine.load(scene.clone()).done());
        let mut found = vec![evaluate_loaded(engine, &wire, 3, &wiry(1.0))];
        for neighbours in &lists {
            engine.set_neighbours(neighbours.clone());
            found.push(evaluate_loaded(engine, &wire, 3, &wiry(1.0)));
        }
        wait(engine.load(Scene { neighbours: lists[1].clone(), ..scene.clone() }).done());
        found.push(evaluate_loaded(engine, &wire, 3, &wiry(1.0)));
        // None at all, as a scene starts.
        wait(engine.load(Scene { neighbours: Neighbours::default(), ..scene.clone() }).done());
        found.push(evaluate_loaded(engine, &wire, 3, &wiry(1.0)));
        // A scene without nodes has nothing to exchange.
        wait(engine.load(Scene { nodes: None, ..scene.clone() }).done());
        engine.set_neighbours(lists[1].clone());
        found.push(evaluate_loaded(engine, &wire, 3, &wiry(1.0)));
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        found
    });
    for (i, (gpu, cpu)) in gpu.iter().zip(&cpu).enumerate() {
        let (loss, gradient) = apart(gpu, cpu);
        eprintln!("neighbours {i}: loss {loss:.1e}, gradient {gradient:.1e}, clearance {}", gpu.0[11]);
        assert!(loss <= LOSS && gradient <= GRADIENT, "{i}: loss {loss:.1e}, gradient {gradient:.1e}");
    }
    for found in [&cpu, &gpu] {
        assert!(found[0] == found[3] && found[2] == found[4], "what is exchanged is what is loaded");
        assert!(found[1] == found[5] && found[1].0[11] == 0.0, "no neighbours, no push");
        assert!(found[6].0[STRAND].iter().all(|&term| term == 0.0), "no nodes, nothing to bend");
    }
    // Siblings: each list is seen.
    for (i, j) in [(1, 2), (2, 3), (1, 3), (1, 6)] {
        let (loss, gradient) = apart(&gpu[i], &cpu[j]);
        assert!(loss > LOSS && gradient > GRADIENT, "{i} passes for {j}: loss {loss:.1e}, gradient {gradient:.1e}");
    }
}

fn problem() -> Problem {
    let wire = random_wire(14, 4);
    let mut recipe = Recipe::best();
    for (stage, (iterations, size_px)) in recipe.stages.iter_mut().zip([(60, 32), (60, 64)]) {
        // The device draws every stage exactly, so let the processor do that too.
        (stage.iterations, stage.size_px, stage.raster) = (iterations, size_px, RasterKind::Exact);
    }
    Problem::for_drawings(perturbed(&wire, 0.12, 4), targets_of(&wire, 64), recipe)
}

#[test]
fn a_fit_is_as_good_as_the_processors() {
    let Some(device) = device() else { return };
    let fitted = |engine: Box<dyn Engine>| {
        let mut session = Session::with_engine(problem(), engine).unwrap();
        let started = std::time::Instant::now();
        session.step(usize::MAX);
        assert!(session.engine_trouble().is_none() && session.is_done());
        eprintln!("{:.1} ms an iteration", started.elapsed().as_secs_f64() * 1e3 / session.total() as f64);
        mean_iou(&session.best(), &session.problem().targets)
    };
    let before = mean_iou(&problem().wire, &problem().targets);
    let cpu = fitted(Box::new(CpuEngine::new()));
    let gpu = fitted(Box::new(GpuEngine::new(&device, "")));
    eprintln!("soft IoU: {before} before, {cpu} on the processor, {gpu} on the device");
    assert!((gpu - cpu).abs() < 0.02, "{gpu} instead of {cpu}");
    assert!((before - cpu).abs() > 0.04, "a fit that does nothing would pass");
}

#[test]
fn a_smooth_fit_is_alike_on_both() {
    let Some(device) = device() else { return };
    let fitted = |engine: Box<dyn Engine>, smooth: Option<Smooth>| {
        let mut problem = problem();
        problem.recipe.smooth = smooth;
        let mut session = Session::with_engine(problem, engine).unwrap();
        session.step(usize::MAX);
        assert!(session.engine_trouble().is_none() && session.is_done());
        session
    };
    let cpu = fitted(Box::new(CpuEngine::new()), Some(Smooth::default()));
    let gpu = fitted(Box::new(GpuEngine::new(&device, "")), Some(Smooth::default()));
    let rough = fitted(Box::new(GpuEngine::new(&device, "")), None);
    let rows = |session: &Session, i: usize| session.history().rows().nth(i).unwrap().to_vec();
    // Rounding grows from iteration to iteration, here as in any fit.
    for i in [0, 20] {
        let off = distance(&rows(&gpu, i), &rows(&cpu, i));
        eprintln!("row {i}: {off:.1e}");
        assert!(off < if i == 0 { LOSS } else { 0.05 }, "row {i}: {off:.1e}");
    }
    let points = |session: &Session| gpu_common::points(&session.best());
    let far = |a: &Session, b: &Session| {
        let (a, b) = (points(a), points(b));
        let squares = a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).powi(2));
        (squares.sum::<f32>() / a.len() as f32).sqrt()
    };
    let iou = |session: &Session| mean_iou(&session.best(), &session.problem().targets);
    let (off, rough_off) = (far(&gpu, &cpu), far(&rough, &cpu));
    eprintln!("points {off:.1e} apart, {rough_off:.1e} without; soft IoU {} and {}", iou(&gpu), iou(&cpu));
    assert!(off < 0.2 * rough_off && (iou(&gpu) - iou(&cpu)).abs() < 0.02);
    let strand = |session: &Session| rows(session, 119)[STRAND].to_vec();
    eprintln!("{:?} and {:?}", strand(&gpu), strand(&cpu));
    assert!(distance(&strand(&gpu), &strand(&cpu)) < 0.05);
}

/// An engine that never finds another device.
fn engine_of(device: &Device, batch: usize) -> GpuEngine {
    GpuEngine::with_another(device, batch, String::new(), Box::new(|| Work::Done(Err(Absence::NoAdapter))))
}

#[test]
fn the_same_bits_every_time_whatever_the_batch() {
    let Some(device) = device() else { return };
    let wire = random_wire(40, 6);
    let advanced = |engine: &mut dyn Engine, step: Step| {
        let scene = scene(&wire, &views(48), 2, Pyramid::Gaussian, 5);
        wait(engine.load(with_strands(scene, &wire)).done());
        let mut state = State { points: points(&wire), adam: Adam::new(40) };
        let mut tally = Tally::new(40);
        let mut terms = vec![0.0; 6 * term_count(3)];
        wait(engine.advance(&mut state, &mut tally, &[step; 6], &mut terms).done());
        wait(engine.fetch(Picture::Coverage).done());
        (state, tally, terms, engine.picture(Picture::Coverage, 1).to_vec())
    };
    let first = advanced(&mut engine_of(&device, 6), step());
    assert!(first.0.is_finite() && first.0.adam.count == 6);
    assert!(first == advanced(&mut engine_of(&device, 6), step()), "twice the same");
    assert!(first == advanced(&mut engine_of(&device, 2), step()), "in batches of two");
    assert!(
        first != advanced(&mut engine_of(&device, 6), Step { level_ratio: 0.70001, ..step() }),
        "other numbers are seen"
    );
    // What is left behind is what the processor leaves behind.
    let cpu = advanced(&mut CpuEngine::new(), step());
    let apart = |a: &Tally, b: &Tally| {
        let norms = distance(&a.gradient_norms, &b.gradient_norms);
        norms
            + distance(a.best_points.as_flattened(), b.best_points.as_flattened())
            + distance(&[a.best_loss], &[b.best_loss])
    };
    let off = apart(&first.1, &cpu.1);
    assert!(off < GRADIENT, "{off:.1e}");
    let other = advanced(&mut CpuEngine::new(), Step { gradient_share: 0.4, ..step() });
    assert!(apart(&first.1, &other.1) > GRADIENT, "another share is seen");
    // A wire that is more than its pictures is best at the end, though its loss grows.
    let wiry = wiry(30.0);
    let last = advanced(&mut engine_of(&device, 6), wiry);
    assert!(last == advanced(&mut engine_of(&device, 6), wiry) && last == advanced(&mut engine_of(&device, 1), wiry));
    let cpu = advanced(&mut CpuEngine::new(), wiry);
    let off = apart(&last.1, &cpu.1);
    assert!(off < GRADIENT, "{off:.1e}");
    let image = |row: usize| last.2[row * term_count(3)..][1..4].iter().sum::<f32>();
    assert!((0..5).any(|row| image(row) < image(5)), "the last one has the lowest loss: this tests nothing");
    assert!((last.1.best_loss - image(5)).abs() < 1e-6 * image(5), "{} {}", last.1.best_loss, image(5));
}

#[test]
fn views_told_ahead_are_seen_in_their_iteration_whatever_the_batch() {
    let Some(device) = device() else { return };
    let wire = random_wire(40, 6);
    let looked = |engine: &mut dyn Engine, told: usize| {
        let sets: Vec<_> =
            (0..5).map(|ink| enclosed(scene(&wire, &views(48), 2, Pyramid::AveragePool, ink), ink).views).collect();
        wait(engine.load(scene(&wire, &views(48), 2, Pyramid::AveragePool, 9)).done());
        wait(engine.set_views(sets[..told].to_vec()).done());
        let mut state = State { points: points(&wire), adam: Adam::new(40) };
        let mut tally = Tally::new(40);
        let mut terms = vec![0.0; 7 * term_count(3)];
        let steps = std::array::from_fn::<_, 7, _>(|i| Step { new_views: (1..told).contains(&i), ..step() });
        wait(engine.advance(&mut state, &mut tally, &steps, &mut terms).done());
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        (state, tally, terms)
    };
    let gpu = looked(&mut engine_of(&device, 7), 5);
    assert!(gpu == looked(&mut engine_of(&device, 3), 5) && gpu == looked(&mut engine_of(&device, 1), 5));
    let cpu = looked(&mut CpuEngine::new(), 5);
    let off = distance(&gpu.2, &cpu.2);
    assert!(off <= 3.0 * LOSS, "{off:.1e}");
    let fewer = looked(&mut CpuEngine::new(), 4);
    assert!(distance(&gpu.2, &fewer.2) > 3.0 * LOSS, "the last set is seen");
}

#[test]
fn lists_that_run_over_are_made_longer() {
    let Some(device) = device() else { return };
    // A few pieces right across a large picture: many cells each.
    let corner = |i: usize| [if i.is_multiple_of(2) { -1.0 } else { 1.0 }, (i as f64 * 0.7).sin(), 0.0, 0.05];
    let wire = Wire::open_uniform((0..40).map(corner).collect()).unwrap();
    let views = [View::orthographic("front", 0.0, 0.0, 2.2, 256)];
    let mut engine = engine_of(&device, 1);
    let mut pipeline = wire4d::gpu::Pipeline::new(&device, 1);
    pipeline.load(&scene(&wire, &views, 2, Pyramid::AveragePool, 3)).unwrap();
    let at_first = pipeline.room();
    pipeline.write(wire4d::gpu::Slot::State, &points(&wire)).unwrap();
    pipeline.run("sample", "fill_cells", &[step()], 0).unwrap();
    let wanted = pipeline.read::<u32>(wire4d::gpu::Slot::Cells, 1).unwrap()[0] as usize;
    assert!(wanted > at_first, "{wanted} entries of {at_first}: this wire tests nothing");
    let (terms, d_points) = evaluate(&mut CpuEngine::new(), &wire, &views, &step());
    let (device_terms, device_d_points) = evaluate(&mut engine, &wire, &views, &step());
    let gradient = distance(device_d_points.as_flattened(), d_points.as_flattened());
    assert!(distance(&device_terms, &terms) < LOSS && gradient < GRADIENT, "{device_terms:?} {terms:?} {gradient:.1e}");
}

/// The processor's engine with a gradient that is a little too long.
struct Crooked(CpuEngine, f32);

impl Engine for Crooked {
    fn load(&mut self, scene: Scene) -> Work<'_> {
        self.0.load(scene)
    }
    fn set_target(&mut self, view: usize, ink: &[f32]) {
        self.0.set_target(view, ink);
    }
    fn set_views(&mut self, views: Vec<Vec<SceneView>>) -> Work<'_> {
        self.0.set_views(views)
    }
    fn set_planes(&mut self, planes: Vec<[f32; 4]>) {
        self.0.set_planes(planes);
    }
    fn set_neighbours(&mut self, neighbours: Neighbours) {
        self.0.set_neighbours(neighbours);
    }
    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a> {
        self.0.evaluate_now(points, step, terms, d_points);
        d_points.as_flattened_mut().iter_mut().for_each(|d| *d *= self.1);
        Work::Done(())
    }
    fn advance<'a>(&'a mut self, _: &'a mut State, _: &'a mut Tally, _: &'a [Step], _: &'a mut [f32]) -> Work<'a> {
        unreachable!("the self-check evaluates only")
    }
    fn fetch(&mut self, picture: Picture) -> Work<'_> {
        self.0.fetch(picture)
    }
    fn picture(&self, picture: Picture, view: usize) -> &[f32] {
        self.0.picture(picture, view)
    }
    fn batch(&self) -> usize {
        1
    }
    fn place(&self) -> Place {
        self.0.place()
    }
}

#[test]
fn the_self_check_refuses_what_computes_something_else() {
    let passed = wait(self_check(&mut Crooked(CpuEngine::new(), 1.0))).unwrap();
    assert_eq!((passed.coverage, passed.loss, passed.d_coverage, passed.gradient), (0.0, 0.0, 0.0, 0.0));
    for factor in [1.05, f32::NAN] {
        let error = Error::from(wait(self_check(&mut Crooked(CpuEngine::new(), factor))).unwrap_err()).to_string();
        assert!(error.contains("processor") && error.contains("--backend cpu"), "{error}");
    }
    let Some(device) = device() else { return };
    wait(self_check(&mut engine_of(&device, 1))).unwrap();
    for parity in wait(parities(&mut engine_of(&device, 1), 1.0)) {
        eprintln!("{parity:?}");
        assert!(parity.is_within(&SELF_CHECK_BARS), "{parity:?}");
    }
    for parity in wait(parities(&mut engine_of(&device, 1), 1.02)) {
        assert!(!parity.is_within(&SELF_CHECK_BARS), "a skewed one passes: {parity:?}");
    }
}

#[test]
fn too_much_for_a_device_goes_on_on_the_processor_and_says_so() {
    let Some(device) = device() else { return };
    let wire = random_wire(8, 1);
    let many = vec![View::orthographic("front", 0.0, 0.0, 2.2, 8); 65];
    let mut engine = engine_of(&device, 4);
    let found = evaluate(&mut engine, &wire, &many, &step());
    let trouble = engine.trouble().map(ToString::to_string).unwrap_or_default();
    assert!(trouble.contains("65 views") && trouble.contains("64"), "{trouble}");
    assert!(found == evaluate(&mut CpuEngine::new(), &wire, &many, &step()));
    let mut fine = engine_of(&device, 4);
    evaluate(&mut fine, &wire, &many[..2], &step());
    assert!(fine.trouble().is_none());
}

/// Before which iteration the device in use is treated badly, and how.
type BadTurn = (usize, fn(&Device));

fn fit_with(device: &Device, faults: &[BadTurn]) -> Session {
    use std::sync::{Arc, Mutex};
    let held = Arc::new(Mutex::new(device.clone()));
    let holder = Arc::clone(&held);
    let another = move || {
        let found = Device::acquire(Kind::Any);
        if let Ok(device) = &found {
            *holder.lock().unwrap() = device.clone();
        }
        Work::Done(found)
    };
    let engine = GpuEngine::with_another(device, 16, "as asked".into(), Box::new(another));
    let mut session = Session::with_engine(problem(), Box::new(engine)).unwrap();
    for (iteration, fault) in faults {
        session.step(iteration - session.iteration());
        fault(&held.lock().unwrap());
    }
    session.step(usize::MAX);
    session
}

#[test]
fn a_lost_device_is_replaced_once_and_then_the_processor_takes_over() {
    let Some(device) = device() else { return };
    let straight = fit_with(&device, &[]);
    assert!(straight.engine_trouble().is_none() && straight.place().why == "as asked");
    let continued: [(&str, BadTurn); 3] = [
        ("lost for a moment", (37, Device::destroy)),
        ("lost for a moment", (37, |device| device.provoke(FaultKind::Lost))),
        ("in smaller pieces", (37, |device| device.provoke(FaultKind::Memory))),
    ];
    for (words, fault) in continued {
        let device = Device::acquire(Kind::Any).unwrap();
        let session = fit_with(&device, &[fault]);
        let place = session.place();
        assert!(place.backend == "gpu" && place.why.contains(words), "{place:?}");
        assert!(session.engine_trouble().is_some());
        assert_eq!(session.history(), straight.history(), "nothing is lost with it");
        assert_eq!(session.best(), straight.best());
    }
    let same = |a: &Session, b: &Session, rows: usize| a.history().rows().take(rows).eq(b.history().rows().take(rows));
    let ended: [(&str, &[BadTurn]); 2] = [
        ("the processor has taken over", &[(37, Device::destroy), (80, Device::destroy)]),
        ("more than the graphics card takes", &[(80, |device| device.provoke(FaultKind::Limits))]),
    ];
    for (words, faults) in ended {
        let device = Device::acquire(Kind::Any).unwrap();
        let session = fit_with(&device, faults);
        let place = session.place();
        assert!(place.backend == "cpu" && place.why.contains(words), "{place:?}");
        assert!(session.is_done() && session.history().len() == straight.history().len());
        assert!(same(&session, &straight, 80), "until then it is the same run");
        assert!(!same(&session, &straight, 120), "the processor rounds differently");
        let apart = mean_iou(&session.best(), &problem().targets) - mean_iou(&straight.best(), &problem().targets);
        assert!(apart.abs() < 0.02, "{apart}");
    }
}
