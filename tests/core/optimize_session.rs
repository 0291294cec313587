//! Sessions: interruptions, threads and batches change no bit; nothing that is not finite gets through; bad problems
//! and checkpoints are refused.

use crate::optimize_common as common;

use common::{perturbed, random_wire, targets_of};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use wire4d::Error;
use wire4d::objective::Neighbours;
use wire4d::optimize::{
    Bending, Checkpoint, CpuEngine, Engine, Event, EventKind, Moment, NewPoint, Picture, Place, Problem, RasterKind,
    Recipe, Refine, Reinit, Scene, SceneView, Seen, Session, Stage, State, Step, Tally, TopologyEdit, TopologyEvent,
    Work,
};
use wire4d::view::{Image, Target};

/// Two stages, a restart, bending, two re-initialisations and a refinement in 60 iterations.
pub fn eventful() -> Problem {
    let truth = random_wire(14, 3);
    let stage = |iterations, size_px, restarts| Stage {
        iterations,
        size_px,
        raster: RasterKind::Exact,
        samples_per_span: 3,
        restarts,
    };
    let reinit = |new_point| TopologyEdit::Reinit(Reinit { below_px: 4.0, new_point });
    let event = |iteration, edit| TopologyEvent { at: Moment::Iteration(iteration), edit };
    let recipe = Recipe {
        stages: vec![stage(36, 40, vec![0.5]), stage(24, 64, vec![])],
        bending: Some(Bending { from: 0.1, ..Bending::default() }),
        topology: vec![
            event(12, reinit(NewPoint::LackingInk)),
            event(20, reinit(NewPoint::RandomInVolume)),
            TopologyEvent { at: Moment::Progress(2.0 / 3.0), edit: TopologyEdit::Refine(Refine::default()) },
        ],
        ..Recipe::best()
    };
    let mut problem = Problem::for_drawings(perturbed(&truth, 0.1, 8), targets_of(&truth, 64), recipe);
    problem.width.min_world = 0.0;
    problem.view_weights = vec![1.0, 0.5, 2.0];
    problem
}

fn finished(problem: Problem) -> Session {
    let mut session = Session::new(problem).unwrap();
    session.step(usize::MAX);
    session
}

pub fn assert_same(a: &Session, b: &Session) {
    assert_eq!(a.wire(), b.wire());
    assert_eq!(a.best(), b.best());
    assert_eq!(a.events(), b.events());
    assert_eq!(a.history(), b.history());
    assert_eq!(a.bent_targets(), b.bent_targets());
}

#[test]
fn everything_that_should_happen_happens() {
    let problem = eventful();
    let mut session = finished(problem.clone());
    let kinds: Vec<(usize, EventKind)> = session.events().iter().map(|event| (event.iteration, event.kind)).collect();
    use EventKind::*;
    assert_eq!(kinds, [(0, Stage), (12, Reinit), (18, Restart), (20, Reinit), (36, Stage), (40, Refine), (60, Done)]);
    let count =
        |kind| session.events().iter().filter(|event| event.kind == kind).map(|event| event.count).sum::<usize>();
    assert!(count(Reinit) > 0, "some control point was thin enough");
    assert_eq!(session.wire().control_points().len(), 14 + count(Refine));
    assert_eq!(count(Refine), 5, "a third of 14");
    let moved = session.bent_targets();
    assert!(moved.iter().all(|(_, moved)| moved.mean_px > 0.0 && moved.max_px < 10.0));
    assert_eq!((moved[0].0.width, session.coverage(0).width), (64, 64));
    let other = finished(Problem { seed: 1, ..problem });
    assert_ne!(other.wire(), session.wire(), "another seed, other new points");
}

#[test]
fn a_resumed_session_ends_where_an_uninterrupted_one_does() {
    let problem = eventful();
    let straight = finished(problem.clone());
    // Before anything, amid, right before and after every kind of event, and at the end.
    for cut in [0, 1, 7, 11, 12, 13, 18, 20, 35, 36, 37, 40, 41, 59, 60] {
        let mut first = Session::new(problem.clone()).unwrap();
        first.step(cut);
        let text = serde_json::to_string(&first.checkpoint()).unwrap();
        let saved: Checkpoint = serde_json::from_str(&text).unwrap();
        assert_eq!(saved.iteration(), cut);
        let mut second = Session::resume(problem.clone(), saved).unwrap();
        assert_eq!(second.wire(), first.wire());
        second.step(usize::MAX);
        assert_same(&second, &straight);
    }
    // Sibling: a run that lost its moments at the cut ends elsewhere.
    let mut first = Session::new(problem.clone()).unwrap();
    first.step(25);
    let mut lossy = serde_json::to_value(first.checkpoint()).unwrap();
    lossy["state"]["count"] = 3.into();
    let mut second = Session::resume(problem, serde_json::from_value(lossy).unwrap()).unwrap();
    second.step(usize::MAX);
    assert_ne!(second.wire(), straight.wire());
}

#[test]
fn small_steps_and_large_ones_are_the_same() {
    let problem = eventful();
    let straight = finished(problem.clone());
    let mut session = Session::new(problem).unwrap();
    let mut events = Vec::new();
    while !session.is_done() {
        events.extend(session.step(7));
    }
    assert_same(&session, &straight);
    assert_eq!(events, straight.events());
    assert!(session.step(5).is_empty(), "a finished session does nothing more");
    assert_same(&session, &straight);
}

#[cfg(feature = "threads")]
#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let problem = eventful();
    let runs = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| finished(problem.clone()))
    });
    assert_same(&runs[0], &runs[1]);
    assert_same(&runs[0], &runs[2]);
}

/// What a [`Wrapped`] engine does to an evaluation.
type Meddle = fn(evaluation: usize, terms: &mut [f32], d_points: &mut [[f32; 4]]);

/// The processor's engine, with many iterations a call or with a fault.
struct Wrapped {
    inner: CpuEngine,
    batch: usize,
    evaluations: usize,
    meddle: Meddle,
}

impl Wrapped {
    fn boxed(batch: usize, meddle: Meddle) -> Box<dyn Engine> {
        Box::new(Wrapped { inner: CpuEngine::new(), batch, evaluations: 0, meddle })
    }
}

impl Wrapped {
    fn evaluate_now(&mut self, points: &[[f32; 4]], step: &Step, terms: &mut [f32], d_points: &mut Vec<[f32; 4]>) {
        let finite = points.iter().flatten().all(|c| c.is_finite());
        assert!(finite || self.batch > 1, "between batches every point is finite");
        self.inner.evaluate_now(points, step, terms, d_points);
        (self.meddle)(self.evaluations, terms, d_points);
        self.evaluations += 1;
    }
}

impl Engine for Wrapped {
    fn load(&mut self, scene: Scene) -> Work<'_> {
        self.inner.load(scene)
    }
    fn set_target(&mut self, view: usize, ink: &[f32]) {
        self.inner.set_target(view, ink);
    }
    fn set_views(&mut self, views: Vec<Vec<SceneView>>) -> Work<'_> {
        self.inner.set_views(views)
    }
    fn set_planes(&mut self, planes: Vec<[f32; 4]>) {
        self.inner.set_planes(planes);
    }
    fn set_neighbours(&mut self, neighbours: Neighbours) {
        self.inner.set_neighbours(neighbours);
    }
    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a> {
        self.evaluate_now(points, step, terms, d_points);
        Work::Done(())
    }
    fn advance<'a>(
        &'a mut self,
        state: &'a mut State,
        tally: &'a mut Tally,
        steps: &'a [Step],
        terms: &'a mut [f32],
    ) -> Work<'a> {
        let row = terms.len() / steps.len();
        // Not done when the call returns, to see that the session waits.
        Work::later(async move {
            let mut d_points = Vec::new();
            for (step, terms) in steps.iter().zip(terms.chunks_exact_mut(row)) {
                self.evaluate_now(&state.points, step, terms, &mut d_points);
                tally.note(step, &state.points, terms, self.inner.d_points_image());
                state.step(step, &d_points);
            }
        })
    }
    fn fetch(&mut self, picture: Picture) -> Work<'_> {
        self.inner.fetch(picture)
    }
    fn picture(&self, picture: Picture, view: usize) -> &[f32] {
        self.inner.picture(picture, view)
    }
    fn batch(&self) -> usize {
        self.batch
    }
    fn place(&self) -> Place {
        self.inner.place()
    }
}

#[test]
fn an_engine_that_takes_many_iterations_at_once_sees_the_same_run() {
    let problem = eventful();
    let straight = finished(problem.clone());
    let mut session = Session::with_engine(problem, Wrapped::boxed(16, |_, _, _| {})).unwrap();
    session.step(usize::MAX);
    assert_eq!(session.wire(), straight.wire());
    assert_eq!(session.best(), straight.best());
    assert_eq!(session.history(), straight.history());
    assert_eq!(session.events(), straight.events());
}

fn undone(events: &[Event]) -> Vec<(usize, usize)> {
    events.iter().filter(|e| e.kind == EventKind::Undone).map(|e| (e.iteration, e.count)).collect()
}

#[test]
fn steps_that_are_not_finite_are_undone_and_the_rate_halved() {
    let poisons: [Meddle; 4] = [
        |i, terms, _| terms[1] = if i == 10 { f32::NAN } else { terms[1] },
        |i, _, d_points| d_points[3][0] = if i == 10 { f32::NAN } else { d_points[3][0] },
        |i, _, d_points| d_points[5][3] = if i == 10 { f32::NAN } else { d_points[5][3] },
        |i, _, d_points| d_points[3][2] = if i == 10 { f32::INFINITY } else { d_points[3][2] },
    ];
    let mut problem = eventful();
    problem.recipe.topology.clear();
    for poison in poisons {
        let mut session = Session::with_engine(problem.clone(), Wrapped::boxed(1, poison)).unwrap();
        session.step(10);
        let before = session.wire();
        let events = session.step(1);
        assert_eq!(undone(&events), [(11, 1)]);
        let moved = |a: &wire4d::wire::Wire, b: &wire4d::wire::Wire| {
            let pairs = a.control_points().iter().flatten().zip(b.control_points().iter().flatten());
            pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
        };
        let restored = session.wire();
        session.step(1);
        let (whole, half) = (moved(&before, &restored), moved(&session.wire(), &restored));
        assert!(half > 0.3 * whole && half < 0.7 * whole, "half the step that was undone: {whole} {half}");
        session.step(usize::MAX);
        assert!(session.is_done() && undone(session.events()).len() == 1);
    }
    // Sibling: without poison nothing is undone.
    let mut session = Session::with_engine(problem, Wrapped::boxed(1, |_, _, _| {})).unwrap();
    session.step(usize::MAX);
    assert!(undone(session.events()).is_empty());
}

#[test]
fn a_hopeless_engine_ends_too_and_the_wire_stays_finite() {
    let hopeless: [Meddle; 3] = [
        |_, terms, _| terms.fill(f32::NAN),
        |_, _, d_points| d_points.fill([f32::NAN; 4]),
        |i, _, d_points| d_points[0] = if i % 3 == 0 { [f32::INFINITY; 4] } else { d_points[0] },
    ];
    for (meddle, batch) in hopeless.into_iter().zip([1, 1, 16]) {
        let mut session = Session::with_engine(eventful(), Wrapped::boxed(batch, meddle)).unwrap();
        session.step(usize::MAX);
        assert!(session.is_done());
        for wire in [session.wire(), session.best()] {
            assert!(wire.control_points().iter().flatten().all(|c| c.is_finite()));
        }
        assert!(session.history().rows().flatten().all(|term| term.is_finite()));
        let saved = serde_json::to_string(&session.checkpoint()).unwrap();
        assert!(serde_json::from_str::<Checkpoint>(&saved).is_ok());
    }
}

#[test]
fn an_absurd_rate_neither_breaks_nor_hangs() {
    let mut problem = eventful();
    problem.recipe.position_rate_px = wire4d::optimize::Schedule::Constant(1e7);
    let session = finished(problem);
    assert!(!undone(session.events()).is_empty(), "points that leave the world are undone");
    assert!(session.wire().control_points().iter().flatten().all(|c| c.is_finite()));
}

fn refusal(change: impl FnOnce(&mut Problem)) -> Error {
    let mut problem = eventful();
    change(&mut problem);
    Session::new(problem).err().expect("a refusal")
}

#[test]
fn problems_that_make_no_sense_are_refused_by_name() {
    let pictures = refusal(|p| p.targets.clear());
    assert!(matches!(pictures, Error::Pictures { .. }), "{pictures}");
    let picture = |change: fn(&mut Problem)| match refusal(change) {
        Error::Picture { name, .. } => assert_eq!(name, "side"),
        other => panic!("{other}"),
    };
    picture(|p| p.targets[1].ink = Image::new(63, 64));
    picture(|p| p.targets[1].ink.data.truncate(10));
    picture(|p| p.targets[1].ink.data[5] = f32::NAN);
    picture(|p| p.targets[1].ink.data[5] = 1.5);
    picture(|p| p.targets[1].view.eye = p.targets[1].view.target);
    picture(|p| {
        p.targets[1].ink = Image::new(0, 0);
        (p.targets[1].view.width_px, p.targets[1].view.height_px) = (0, 0);
    });
    let setting = |change: fn(&mut Problem)| assert!(matches!(refusal(change), Error::Setting { .. }));
    setting(|p| p.view_weights = vec![1.0]);
    setting(|p| p.view_weights[0] = -1.0);
    setting(|p| p.width.min_world = f64::NAN);
    setting(|p| p.width.max_world = -1.0);
    setting(|p| p.recipe.stages.clear());
    setting(|p| p.recipe.stages[0].size_px = 1_000_000);
    setting(|p| p.recipe.stages[0].samples_per_span = 0);
    setting(|p| p.recipe.stages[0].restarts = vec![f64::NAN]);
    setting(|p| p.recipe.adam.beta1 = 1.0);
    setting(|p| p.recipe.level_ratio = wire4d::optimize::Schedule::Constant(f64::INFINITY));
    setting(|p| p.recipe.bending.as_mut().unwrap().grid = 0);
    setting(|p| p.recipe.bending.as_mut().unwrap().every = 0);
    setting(|p| p.recipe.topology[2].at = Moment::Progress(7.0));
    setting(|p| p.recipe.topology[0].edit = TopologyEdit::Reinit(Reinit { below_px: -1.0, ..Reinit::default() }));
    assert!(Session::new(eventful()).is_ok());
}

#[test]
fn any_sizes_weights_and_wires_that_make_sense_are_taken() {
    let mut problem = eventful();
    // Oblong views of different sizes, one blank, one without weight, and a closed wire.
    for (target, (width, height)) in problem.targets.iter_mut().zip([(97, 31), (12, 64), (1, 1)]) {
        (target.view.width_px, target.view.height_px) = (width, height);
        target.ink = target.ink.resized(width, height);
    }
    problem.targets[0].ink.data.fill(0.0);
    problem.view_weights[1] = 0.0;
    problem.wire = wire4d::wire::Wire::closed_uniform(problem.wire.control_points().to_vec()).unwrap();
    let session = finished(problem);
    assert!(session.is_done() && session.history().len() == 60);
    assert!(session.history().rows().all(|row| row[2] == 0.0), "no weight, no loss");
}

#[test]
fn checkpoints_of_other_problems_and_damaged_ones_are_refused() {
    let problem = eventful();
    let mut session = Session::new(problem.clone()).unwrap();
    session.step(30);
    let good = serde_json::to_value(session.checkpoint()).unwrap();
    let resumed = |value: serde_json::Value, problem: &Problem| {
        let saved: Checkpoint = serde_json::from_value(value).ok()?;
        Some(Session::resume(problem.clone(), saved).map(|_| ()))
    };
    assert_eq!(resumed(good.clone(), &problem), Some(Ok(())));
    let damages: [fn(&mut serde_json::Value); 9] = [
        |v| v["version"] = 1.into(),
        |v| v["iteration"] = 29.into(),
        |v| v["iteration"] = 1_000_000.into(),
        |v| v["state"]["points"] = serde_json::json!([]),
        |v| v["state"]["first"][0][0] = 1e300.into(),
        |v| v["good"]["second"] = serde_json::json!([[0, 0, 0, 0]]),
        |v| v["fields"][1]["values"] = serde_json::json!([]),
        |v| v["best_points"][0][3] = (-1.0).into(),
        |v| v["wire"]["closed"] = true.into(),
    ];
    for (i, damage) in damages.iter().enumerate() {
        let mut bad = good.clone();
        damage(&mut bad);
        match resumed(bad, &problem) {
            None => {}
            Some(Err(Error::Input { name, .. })) => assert_eq!(name, "checkpoint"),
            other => panic!("damage {i}: {other:?}"),
        }
    }
    let mut other = problem.clone();
    other.targets.pop();
    other.view_weights.pop();
    assert!(matches!(resumed(good.clone(), &other), Some(Err(Error::Input { .. }))));
    let mut unbent = problem;
    unbent.recipe.bending = None;
    assert!(matches!(resumed(good, &unbent), Some(Err(Error::Input { .. }))));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, rng_seed: RngSeed::Fixed(4), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_the_numbers_the_wire_stays_finite_and_within_its_bounds(
        rate in 1e-3f64..50.0, width_rate in 0.0f64..50.0, jerk in 0.0f64..1e3, length in 0.0f64..10.0,
        ratio in 0.0f64..4.0, min in 0.0f64..0.05, more in 0.0f64..0.2, seed in 0u64..100,
    ) {
        use wire4d::optimize::Schedule::Constant;
        let mut problem = eventful();
        problem.wire = random_wire(10, seed);
        problem.recipe.position_rate_px = Constant(rate);
        problem.recipe.width_rate_px = Constant(width_rate);
        problem.recipe.jerk_position = Constant(jerk);
        problem.recipe.length = Constant(length);
        problem.recipe.level_ratio = Constant(ratio);
        problem.width = wire4d::optimize::WidthBounds { min_world: min, max_world: min + more };
        let session = finished(problem);
        for point in session.wire().control_points() {
            prop_assert!(point.iter().all(|c| c.is_finite()));
            prop_assert!(point[3] >= min - 1e-7 && point[3] <= min + more + 1e-7);
        }
    }
}

/// `State` is part of the engine's contract: copying must not lose anything.
#[test]
fn states_copy_completely() {
    let mut state = State { points: vec![[1.0; 4]; 3], adam: wire4d::optimize::Adam::new(3) };
    state.adam.count = 4;
    state.adam.first[1] = [2.0; 4];
    state.adam.second[2] = [3.0; 4];
    let mut copy = State::default();
    copy.copy_from(&state);
    assert_eq!(copy, state);
    assert!(copy.is_finite());
    copy.adam.second[0][1] = f32::NAN;
    assert!(!copy.is_finite());
}

#[test]
fn targets_can_be_exchanged_on_the_way() {
    let problem = eventful();
    let mut others = problem.targets.clone();
    others.iter_mut().for_each(|target| target.ink.data.reverse());
    let seen = |targets: &[Target]| Seen { targets: targets.to_vec(), ..Seen::default() };
    let mut session = Session::new(problem.clone()).unwrap();
    session.step(10);
    assert!(matches!(session.set_views(vec![seen(&others[..2])]), Err(Error::Pictures { .. })), "fewer of them");
    let mut bright = others.clone();
    bright[1].ink.data[0] = 2.0;
    assert!(session.set_views(vec![seen(&bright)]).is_err(), "ink that is none");
    assert_eq!(session.problem().targets, problem.targets, "what is refused changes nothing");
    session.set_views(vec![seen(&others)]).unwrap();
    assert_eq!(session.best(), session.wire(), "losses so far are no measure any more");
    session.step(1);
    // The same as a session of those targets from there.
    let mut before = Session::new(problem.clone()).unwrap();
    before.step(10);
    let changed = Problem { targets: others, ..problem.clone() };
    let mut resumed = Session::resume(changed, before.checkpoint().without_best()).unwrap();
    resumed.step(1);
    assert_same(&session, &resumed);
    before.step(1);
    assert_ne!(before.wire(), session.wire());
}
