//! Views that are computed elsewhere: however many compute, and whoever fails on the way, no bit changes.

use crate::optimize_common::{perturbed, random_wire, targets_of};
use crate::optimize_occlusion as occlusion;
use crate::optimize_session::{assert_same, eventful};
use crate::optimize_smooth::smooth_recipe;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use wire4d::Error;
use wire4d::objective::{Guidance, Progress, Rendered};
use wire4d::optimize::{
    Answer, Courier, Mate, Moment, Problem, Recipe, Respace, Session, Stage, TopologyEdit, TopologyEvent, Work,
};
use wire4d::raster::{ExactRaster, Part, Raster};
use wire4d::rng::Rng;
use wire4d::view::View;
use wire4d::wire::Stroke;

/// A mate whose messages pass through bytes, answered once somebody waits for them; it fails from the message of a number on.
struct Beside {
    mate: Arc<Mutex<Mate>>,
    asked: Arc<AtomicUsize>,
    fails_at: usize,
    how: Failure,
}

#[derive(Clone, Copy, PartialEq)]
enum Failure {
    Silent,
    TooShort,
    TooLong,
}

impl Courier for Beside {
    fn ask(&mut self, message: &[u8]) -> Answer {
        let answer = self.mate.lock().unwrap().answer(message);
        let fails = self.asked.fetch_add(1, Ordering::Relaxed) >= self.fails_at;
        let how = self.how;
        let mut waited = false;
        Work::later(async move {
            std::future::poll_fn(|_| {
                if std::mem::replace(&mut waited, true) { std::task::Poll::Ready(()) } else { std::task::Poll::Pending }
            })
            .await;
            let mut bytes = answer?;
            match how {
                _ if !fails => {}
                Failure::Silent => return Err(Error::device("mate", "it is gone", "nothing")),
                Failure::TooShort => drop(bytes.pop()),
                Failure::TooLong => bytes.push(0),
            }
            Ok(bytes)
        })
    }
}

/// Hires one that fails from a message on, or never; how many messages it gets.
fn hire(session: &mut Session, fails_at: usize, how: Failure) -> Arc<AtomicUsize> {
    let asked = Arc::new(AtomicUsize::new(0));
    session.hire(Box::new(Beside { mate: Arc::default(), asked: asked.clone(), fails_at, how }));
    asked
}

fn hire_many(session: &mut Session, mates: usize) -> Vec<Arc<AtomicUsize>> {
    (0..mates).map(|_| hire(session, usize::MAX, Failure::Silent)).collect()
}

fn finished(problem: &Problem, crew: impl FnOnce(&mut Session)) -> Session {
    let mut session = Session::new(problem.clone()).unwrap();
    crew(&mut session);
    session.step(usize::MAX);
    session
}

/// Long enough for a view to be drawn in parts, kept smooth and laid anew on the way.
fn long() -> Problem {
    let truth = random_wire(240, 3);
    let mut recipe = smooth_recipe(10);
    let respace = TopologyEdit::Respace(Respace { spacing_px: 12.0, hairpin_px: 4.0 });
    recipe.topology.push(TopologyEvent { at: Moment::Iteration(5), edit: respace });
    recipe.stages = vec![
        Stage { iterations: 4, size_px: 48, samples_per_span: 3, ..recipe.stages[0].clone() },
        Stage { iterations: 6, size_px: 96, samples_per_span: 3, ..recipe.stages[0].clone() },
    ];
    Problem::for_drawings(perturbed(&truth, 0.05, 8), targets_of(&truth, 96), recipe)
}

#[test]
fn however_many_compute_the_wire_is_the_same() {
    for problem in [eventful(), long()] {
        let alone = finished(&problem, |_| ());
        for mates in 1..=4 {
            let mut asked = Vec::new();
            let mut session = finished(&problem, |session| asked = hire_many(session, mates));
            assert_same(&session, &alone);
            let busy = asked.iter().filter(|asked| asked.load(Ordering::Relaxed) >= 10).count();
            assert_eq!(busy, mates.min(2), "of three views everybody computes one, or two all of them");
            assert_eq!((session.workers(), alone.workers()), (busy + 1, 1));
            for view in 0..3 {
                let mut alone = finished(&problem, |_| ());
                assert_eq!(session.coverage(view), alone.coverage(view));
            }
        }
    }
}

#[test]
fn a_view_for_which_nobody_is_left_is_drawn_by_all() {
    // Two on three views: one each, and the third by both, in two messages more.
    let problem = long();
    let mut asked = Vec::new();
    finished(&problem, |session| asked = hire_many(session, 1));
    assert_eq!(asked[0].load(Ordering::Relaxed), 3 * 10);
    finished(&problem, |session| asked = hire_many(session, 2));
    assert_eq!(asked[0].load(Ordering::Relaxed), 10);
}

#[test]
fn parts_add_up_to_the_whole_and_back() {
    let wire = random_wire(200, 9);
    let (map, mut strokes) = wire.sampling_map::<f32>(4, true);
    strokes.push(Stroke { start: 100, count: 150, closed: true });
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|p| p.map(|c| c as f32)).collect();
    let mut samples = Vec::new();
    map.apply(&points, &mut samples);
    let [view, ..] = View::canonical(2.2, 80);
    let vertices: Vec<_> = samples.iter().map(|sample| view.camera::<f32>().project(sample)).collect();
    let mut rng = Rng::new(3, 0);
    let adjoint: Vec<f32> = (0..80 * 80).map(|_| rng.range(-1.0, 1.0) as f32).collect();
    let (mut whole, mut d_whole) = (ExactRaster::new(), Vec::new());
    let coverage = whole.forward(80, 80, &vertices, &strokes).to_vec();
    whole.backward(&adjoint, &mut d_whole);
    for borders in [vec![0, 512, 1024], vec![0, 100, 700, 1024], vec![0, 0, 1024, 1024]] {
        let part = |pair: &[u32]| {
            let mut raster = ExactRaster::new();
            raster.trace_part(80, 80, &vertices, &strokes, Part { from: pair[0], to: pair[1] });
            raster
        };
        let mut parts: Vec<ExactRaster> = borders.windows(2).map(part).collect();
        let (first, others) = parts.split_first_mut().unwrap();
        others.iter().for_each(|other| first.add(other.sums()));
        assert_eq!(first.finish(), coverage, "{borders:?}");
        let mut sum = vec![[0.0; 3]; vertices.len()];
        for raster in &mut parts {
            let mut d_vertices = Vec::new();
            raster.backward(&adjoint, &mut d_vertices);
            for (sum, d) in sum.iter_mut().zip(d_vertices) {
                (0..3).for_each(|c| sum[c] += d[c]);
            }
        }
        assert_eq!(sum, d_whole, "{borders:?}");
    }
}

#[test]
fn views_that_change_and_hide_strands_are_the_same_elsewhere() {
    let problem = occlusion::problem(1.0);
    for every in [1, 3] {
        let fitted = |mates| {
            let mut session = Session::new(problem.clone()).unwrap();
            hire_many(&mut session, mates);
            occlusion::go_on(&mut session, every, 45);
            session
        };
        assert_same(&fitted(1), &fitted(0));
    }
}

#[test]
fn who_comes_late_or_fails_changes_nothing() {
    for problem in [eventful(), long()] {
        let alone = finished(&problem, |_| ());
        for how in [Failure::Silent, Failure::TooShort, Failure::TooLong] {
            for (fails_at, other_fails_at) in (0..30).map(|k| (k, [usize::MAX, 9, k][k % 3])) {
                let session = finished(&problem, |session| {
                    let asked = hire(session, fails_at, how);
                    session.step(3);
                    hire(session, other_fails_at, how);
                    session.step(5);
                    assert!(asked.load(Ordering::Relaxed) <= fails_at.saturating_add(3), "nobody asks again");
                });
                assert_same(&session, &alone);
            }
        }
    }
}

#[test]
fn a_run_with_a_crew_goes_on_alone_from_its_checkpoint() {
    let problem = eventful();
    let alone = finished(&problem, |_| ());
    let mut session = Session::new(problem.clone()).unwrap();
    hire_many(&mut session, 1);
    session.step(30);
    let mut resumed = Session::resume(problem, session.checkpoint()).unwrap();
    resumed.step(usize::MAX);
    assert_same(&resumed, &alone);
}

/// Pulls all ink down a little.
struct Less;

impl Guidance for Less {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, wire4d::Result<f32>> {
        views.iter_mut().for_each(|view| view.gradient.fill(1e-6));
        Work::Done(Ok(1e-6 * views.iter().flat_map(|view| &view.coverage).sum::<f32>()))
    }
}

#[test]
fn what_guides_sees_all_views_and_then_they_are_shared_again() {
    let fitted = |mates| {
        let mut session = Session::new(long()).unwrap();
        let asked = hire_many(&mut session, mates);
        session.step(3);
        session.guide_by("less", 1.0, Box::new(Less));
        let before = asked.iter().map(|asked| asked.load(Ordering::Relaxed)).sum::<usize>();
        session.step(4);
        assert_eq!(asked.iter().map(|asked| asked.load(Ordering::Relaxed)).sum::<usize>(), before);
        session.stop_guiding("less");
        session.step(3);
        assert!(asked.iter().all(|asked| asked.load(Ordering::Relaxed) > before / mates));
        session
    };
    assert_same(&fitted(2), &fitted(0));
}

/// Messages as an engine sends them.
fn messages() -> Vec<Vec<u8>> {
    struct Listens(Mate, Arc<Mutex<Vec<Vec<u8>>>>);
    impl Courier for Listens {
        fn ask(&mut self, message: &[u8]) -> Answer {
            self.1.lock().unwrap().push(message.to_vec());
            Work::Done(self.0.answer(message))
        }
    }
    let heard = Arc::new(Mutex::new(Vec::new()));
    let problem = Problem { recipe: Recipe { stages: long().recipe.stages, ..eventful().recipe }, ..long() };
    let mut session = Session::new(problem).unwrap();
    session.hire(Box::new(Listens(Mate::new(), heard.clone())));
    session.step(3);
    let heard = heard.lock().unwrap();
    assert_eq!(heard.len(), 9);
    heard.clone()
}

#[test]
fn messages_cut_short_or_out_of_turn_are_refused() {
    let messages = messages();
    for (k, message) in messages[..3].iter().enumerate() {
        let told = || {
            let mut mate = Mate::new();
            messages[..k].iter().for_each(|message| drop(mate.answer(message).unwrap()));
            mate
        };
        let mut cuts: Vec<usize> = (1..message.len().min(400)).chain([message.len() - 1]).collect();
        cuts.retain(|cut| cut % 4 != 0 || *cut == 4);
        for cut in cuts {
            assert!(matches!(told().answer(&message[..cut]), Err(Error::Device { .. })), "{k} cut at {cut}");
        }
    }
    // Without its scene.
    assert!(messages[1..3].iter().all(|message| Mate::new().answer(message).is_err()));
    // The gradient of what nobody has drawn.
    let mut mate = Mate::new();
    let points = 4 * (1 + 1 + 4 * long().wire.control_points().len());
    mate.answer(&messages[0][..messages[0].len() - points]).unwrap();
    assert!(mate.answer(&messages[2]).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, rng_seed: RngSeed::Fixed(4), ..ProptestConfig::default() })]
    #[test]
    fn damaged_messages_do_no_harm(damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u32>()), 1..4)) {
        static MESSAGES: std::sync::OnceLock<Vec<Vec<u8>>> = std::sync::OnceLock::new();
        let messages = MESSAGES.get_or_init(messages);
        let mut mate = Mate::new();
        for message in &messages[..3] {
            let mut message = message.clone();
            for (at, value) in &damage {
                // Mostly where the counts are.
                let word = at.index(message.len() / 4).min(at.index(64));
                message[4 * word..4 * word + 4].copy_from_slice(&(value >> (value % 31)).to_ne_bytes());
            }
            let _ = mate.answer(&message);
        }
    }
}
