//! What guides a fit, asked between the stages of a device, against the processor's.
use crate::gpu_common;
use crate::guided::Noise;
use crate::optimize_common;

use gpu_common::{device, distance, enclosed, points, scene, step, views};
use optimize_common::random_wire;
use wire4d::gpu::{Absence, Device, GpuEngine};
use wire4d::objective::{Guides, Progress, Pyramid};
use wire4d::optimize::{Adam, CpuEngine, Engine, Scene, State, Step, Tally, Term, Work, term_count, wait};
use wire4d::wire::Wire;

const LOSS: f64 = 1e-4;
const GRADIENT: f64 = 1e-3;

fn engine_of(device: &Device, batch: usize) -> GpuEngine {
    GpuEngine::with_another(device, batch, String::new(), Box::new(|| Work::Done(Err(Absence::NoAdapter))))
}

fn by_noise(wire: &Wire, size_px: usize, fails_at: usize, weight: f32) -> Scene {
    let guides = Guides::default();
    guides.set("noise", weight, Box::new(Noise { fails_at }));
    Scene { guides, ..scene(wire, &views(size_px), 2, Pyramid::AveragePool, 3) }
}

#[test]
fn a_guided_iteration_agrees() {
    let Some(device) = device() else { return };
    // The zigzag has more cells than there is room for at first: it is drawn twice before anybody looks.
    let corner = |i: usize| [if i.is_multiple_of(2) { -1.0 } else { 1.0 }, (i as f64 * 0.7).sin(), 0.0, 0.05];
    let zigzag = Wire::open_uniform((0..40).map(corner).collect()).unwrap();
    for (wire, size_px, is_drawn) in
        [(random_wire(30, 1), 64, true), (zigzag, 256, true), (random_wire(30, 2), 64, false)]
    {
        let evaluate = |engine: &mut dyn Engine, weight: f32| {
            let mut scene = by_noise(&wire, size_px, usize::MAX, weight);
            if !is_drawn {
                // Views that nobody drew are guided all the same.
                for view in &mut scene.views[1..] {
                    view.weight = 0.0;
                    view.target.data.fill(0.0);
                }
            }
            wait(engine.load(scene).done());
            let (mut terms, mut d_points) = (vec![0.0; term_count(3)], Vec::new());
            wait(engine.evaluate(&points(&wire), &step(), &mut terms, &mut d_points).done());
            assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
            (terms, d_points)
        };
        let on_gpu = evaluate(&mut engine_of(&device, 4), 20.0);
        let off = |(terms, d_points): &(Vec<f32>, Vec<[f32; 4]>)| {
            (distance(&on_gpu.0, terms), distance(on_gpu.1.as_flattened(), d_points.as_flattened()))
        };
        let (loss, gradient) = off(&evaluate(&mut CpuEngine::new(), 20.0));
        assert!(loss < LOSS && gradient < GRADIENT, "{loss:e} and {gradient:e}");
        assert!(on_gpu.0[Term::Guidance.at(3)] != 0.0);
        let (_, gradient) = off(&evaluate(&mut CpuEngine::new(), 20.5));
        assert!(gradient > GRADIENT, "another weight is seen: {gradient:e}");
    }
}

#[test]
fn guided_iterations_agree_while_views_change_and_guidance_fails() {
    let Some(device) = device() else { return };
    let wire = random_wire(40, 6);
    let advanced = |engine: &mut dyn Engine, fails_at: usize| {
        let sets: Vec<_> =
            (0..4).map(|ink| enclosed(scene(&wire, &views(48), 2, Pyramid::AveragePool, ink), ink).views).collect();
        wait(engine.load(by_noise(&wire, 48, fails_at, 30.0)).done());
        wait(engine.set_views(sets).done());
        let mut state = State { points: points(&wire), adam: Adam::new(40) };
        let (mut tally, mut terms) = (Tally::new(40), vec![0.0; 6 * term_count(3)]);
        let steps = std::array::from_fn::<_, 6, _>(|iteration| Step {
            guided: iteration <= fails_at,
            progress: Progress { iteration, iterations: 6 },
            ..step()
        });
        wait(engine.advance(&mut state, &mut tally, &steps, &mut terms).done());
        assert!(engine.trouble().is_none(), "{:?}", engine.trouble());
        (state, tally, terms)
    };
    let gpu = advanced(&mut engine_of(&device, 8), 3);
    assert!(gpu == advanced(&mut engine_of(&device, 2), 3), "the same bits whatever the batch");
    let guidance = |row: usize| gpu.2[row * term_count(3)..][Term::Guidance.at(3)];
    assert!((0..3).all(|row| guidance(row) != 0.0) && (3..6).all(|row| guidance(row) == 0.0));
    let cpu = advanced(&mut CpuEngine::new(), 3);
    let off = distance(&gpu.2, &cpu.2);
    assert!(off <= 3.0 * LOSS, "{off:.1e}");
    let other = advanced(&mut CpuEngine::new(), 2);
    assert!(distance(&gpu.2, &other.2) > 3.0 * LOSS, "that it failed later is seen");
}
