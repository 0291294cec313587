//! What an iteration costs on a graphics card: scenes from a classroom's to a large one, timed whole and by stage.

// Each bench uses its share.
#![allow(dead_code)]

mod cost;

use crate::common;
use cost::Counts;
use std::ops::RangeInclusive;
use std::time::Instant;
use wire4d::gpu::{Device, Kind, Pipeline, STAGES, Slot, Stage};
use wire4d::optimize::{Adam, AdamOptions, CpuEngine, Engine, Scene, SceneView, State, Step, Tally, term_count, wait};
use wire4d::view::View;
use wire4d::wire::Wire;

/// A wire, the pictures it is fitted to, and the milliseconds an iteration may take on a data-centre card.
pub struct Case {
    pub controls: usize,
    pub samples_per_span: usize,
    pub views: usize,
    pub size_px: usize,
    pub aim_ms: Option<f64>,
}

const fn case(controls: usize, samples_per_span: usize, views: usize, size_px: usize, aim_ms: Option<f64>) -> Case {
    Case { controls, samples_per_span, views, size_px, aim_ms }
}

const CASES: [Case; 6] = [
    case(220, 8, 3, 128, None),
    case(220, 8, 3, 256, Some(0.15)),
    case(1000, 3, 6, 256, None),
    case(2000, 3, 16, 512, Some(1.5)),
    case(5000, 3, 16, 512, None),
    case(5000, 8, 16, 512, None),
];

impl std::fmt::Display for Case {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Case { controls, samples_per_span, views, size_px, .. } = self;
        write!(f, "{controls} x {samples_per_span}, {views} views of {size_px} px")
    }
}

/// A device and what to time on it: all cases, or with `--quick` on the command line the first; with `--any` a program
/// that stands in for a card, too. A line says why not.
pub fn wanted() -> Option<(Device, &'static [Case])> {
    let asked = |flag: &str| std::env::args().any(|argument| argument == flag);
    match Device::acquire(if asked("--any") { Kind::Any } else { Kind::Card }) {
        Ok(device) => {
            let quick = asked("--quick");
            println!("\n## {}", device.info());
            Some((device, if quick { &CASES[..1] } else { &CASES }))
        }
        Err(error) => {
            println!("\nNo times of a graphics card: {error}");
            None
        }
    }
}

impl Case {
    /// A start near a wire whose pictures it is compared with. The more control points, the longer the wire, too.
    fn scene(&self) -> (Scene, Vec<[f32; 4]>) {
        let curve = common::random_wire((self.controls / 4).max(220), 3);
        let spans = (curve.control_points().len() - 3) as f64;
        let more = self.controls - curve.control_points().len();
        let knots: Vec<f64> = (0..more).map(|i| (i as f64 + 0.37) * spans / more as f64).collect();
        let (truth, _) = curve.insert_knots(&knots).expect("knots inside");
        let start: Wire = common::perturbed(&truth, 0.01, 8);
        // Views all round, no two opposite.
        let view = |v: usize| {
            let (turn, lift) = (v as f64 * std::f64::consts::PI / self.views as f64, 0.6 * (v as f64).sin());
            let view = View::orthographic("any", turn, lift, 2.2, self.size_px);
            SceneView::new(view.camera(), common::draw(&truth, &view), 1.0)
        };
        let views = (0..self.views).map(view).collect();
        let points = start.control_points().iter().map(|point| point.map(|c| c as f32)).collect();
        (Scene::new(&start, self.samples_per_span, views), points)
    }
}

/// An iteration that does everything and moves nothing, so that all are alike.
fn step() -> Step {
    Step {
        rates: [0.0; 4],
        adam: AdamOptions::default(),
        level_ratio: 0.5,
        jerk_position: 1e-4,
        jerk_width: 1e-4,
        length: 1e-3,
        width_bounds: [0.0, 1.0],
        ..Step::default()
    }
}

/// Milliseconds an iteration.
#[derive(Clone, Copy)]
pub struct Times {
    pub median: f64,
    pub least: f64,
}

impl Times {
    fn of(mut times: Vec<f64>) -> Times {
        times.sort_by(f64::total_cmp);
        Times { median: times[times.len() / 2], least: times[0] }
    }

    fn map(self, change: impl Fn(f64) -> f64) -> Times {
        Times { median: change(self.median), least: change(self.least) }
    }
}

impl std::fmt::Display for Times {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{:.3} ({:.3})", self.median, self.least)
    }
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

/// Iterations a submission, at most, and how long one should take, so that waiting for it counts little.
const MOST_ITERATIONS: usize = 128;
const SUBMISSION_MS: f64 = 60.0;
const REPEATS: usize = 7;

/// A case on a device.
pub struct Loaded {
    pipeline: Pipeline,
    scene: Scene,
    points: Vec<[f32; 4]>,
}

impl Loaded {
    /// # Panics
    /// If the device does not take the case.
    pub fn new(device: &Device, case: &Case) -> Loaded {
        let (scene, points) = case.scene();
        let mut pipeline = Pipeline::new(device, MOST_ITERATIONS);
        // Submissions as long as this bench makes them.
        pipeline.keep_pace(0.0);
        pipeline.load(&scene).expect("a scene that fits");
        let mut loaded = Loaded { pipeline, scene, points };
        loaded.write_state();
        loaded.submit(0..=Stage::index("fill_cells"), 1);
        let entries = loaded.entries();
        if entries > loaded.pipeline.room() {
            wait(loaded.pipeline.make_room(entries)).expect("room");
            loaded.write_state();
        }
        loaded.submit(ALL, 1);
        loaded
    }

    fn write_state(&self) {
        let moments = vec![[0.0f32; 4]; 2 * self.points.len()];
        self.pipeline.write(Slot::State, &[&*self.points, &*moments].concat()).expect("a scene");
    }

    fn entries(&mut self) -> usize {
        self.pipeline.read::<u32>(Slot::Cells, 1).expect("a device")[0] as usize
    }

    /// Milliseconds until so many iterations of some stages are recorded, and until they are done.
    fn submit(&mut self, stages: RangeInclusive<usize>, iterations: usize) -> (f64, f64) {
        let [first, last] = [stages.start(), stages.end()].map(|&stage| STAGES[stage].name);
        let start = Instant::now();
        self.pipeline.run(first, last, &vec![step(); iterations], 0).expect("a scene");
        let recorded = milliseconds(start);
        self.pipeline.read::<f32>(Slot::Terms, 1).expect("a device");
        (recorded, milliseconds(start))
    }

    /// An iteration of some stages: on the device, and until it was recorded, which can go on meanwhile.
    fn time(&mut self, stages: RangeInclusive<usize>) -> (Times, Times) {
        let waiting = (0..REPEATS).map(|_| self.submit(stages.clone(), 0).1).fold(f64::MAX, f64::min);
        let (recorded, all) = self.submit(stages.clone(), 1);
        let most = SUBMISSION_MS / (all - recorded - waiting).max(1e-3);
        let iterations = (most as usize).clamp(1, MOST_ITERATIONS);
        let (recorded, all): (Vec<f64>, Vec<f64>) =
            (0..REPEATS).map(|_| self.submit(stages.clone(), iterations)).unzip();
        let an_iteration = |ms: f64| ms.max(0.0) / iterations as f64;
        let recording = Times::of(recorded).map(an_iteration);
        // A thread that loses its core looks as if it recorded on: the least it took is the truth.
        let idle = waiting + recording.least * iterations as f64;
        (Times::of(all).map(|ms| an_iteration(ms - idle)), recording)
    }

    /// A whole iteration.
    pub fn time_all(&mut self) -> (Times, Times) {
        self.time(ALL)
    }

    /// A stage again and again on what a whole iteration left. What `finish_rows` takes away must be made anew.
    fn time_stage(&mut self, stage: usize) -> f64 {
        self.submit(ALL, 1);
        if STAGES[stage].name != "finish_rows" {
            return self.time(stage..=stage).0.median;
        }
        let trace = Stage::index("trace");
        (self.time(trace..=stage).0.median - self.time(trace..=stage - 1).0.median).max(0.0)
    }

    fn counts(&mut self) -> Counts {
        let vertices = self.pipeline.read(Slot::Vertices, self.scene.sampling.rows().len() * self.scene.views.len());
        let entries = self.entries();
        Counts::new(&self.scene, &vertices.expect("a device"), entries)
    }

    /// Prints a row a stage.
    pub fn print_stages(&mut self, case: &Case) {
        println!("\n### {case}, by stage\n");
        println!("| stage | ms | MB | GB/s | MFLOP | GFLOP/s |\n|---|---|---|---|---|---|");
        let counts = self.counts();
        let mut all = 0.0;
        for (stage, Stage { name, .. }) in STAGES.iter().enumerate() {
            let ms = self.time_stage(stage);
            all += ms;
            let (bytes, flop) = counts.cost(name);
            // Below a tenth of a microsecond it is noise.
            let rate = |amount: f64| if ms < 1e-4 { "–".into() } else { format!("{:.1}", amount / ms / 1e6) };
            println!(
                "| {name} | {ms:.4} | {:.3} | {} | {:.3} | {} |",
                bytes / 1e6,
                rate(bytes),
                flop / 1e6,
                rate(flop)
            );
        }
        println!("| all | {all:.4} | | | | |");
    }

    /// Bytes of all buffers, and of the largest with its name.
    pub fn memory(&self) -> (u64, (Slot, u64)) {
        let sizes = self.pipeline.memory();
        let largest = sizes.iter().copied().max_by_key(|(_, bytes)| *bytes);
        (sizes.iter().map(|(_, bytes)| bytes).sum(), largest.expect("buffers"))
    }

    /// Relative distances of losses and of gradients from the processor's.
    pub fn differences(&mut self) -> (f64, f64) {
        self.submit(ALL, 1);
        let views = self.scene.views.len();
        let found: Vec<f32> = self.pipeline.read(Slot::Terms, term_count(views)).expect("a device");
        let d_found: Vec<[f32; 4]> = self.pipeline.read(Slot::DPoints, self.points.len()).expect("a device");
        let (mut engine, mut terms, mut d_points) = (CpuEngine::new(), vec![0.0; term_count(views)], Vec::new());
        wait(engine.load(self.scene.clone()).done());
        engine.evaluate_now(&self.points, &step(), &mut terms, &mut d_points);
        (distance(&found, &terms), distance(d_found.as_flattened(), d_points.as_flattened()))
    }

    /// An iteration of the processor's own engine on all its threads.
    pub fn time_on_processor(&self) -> Times {
        let mut engine = CpuEngine::new();
        wait(engine.load(self.scene.clone()).done());
        let mut state = State { points: self.points.clone(), adam: Adam::new(self.points.len()) };
        let (mut terms, mut tally) = (vec![0.0; term_count(self.scene.views.len())], Tally::new(self.points.len()));
        let mut iteration = || {
            let start = Instant::now();
            wait(engine.advance(&mut state, &mut tally, &[step()], &mut terms).done());
            milliseconds(start)
        };
        iteration();
        Times::of((0..3 * REPEATS).map(|_| iteration()).collect())
    }
}

/// Relative l2 distance.
fn distance(a: &[f32], b: &[f32]) -> f64 {
    let squares = |values: &mut dyn Iterator<Item = f32>| values.map(|v| f64::from(v).powi(2)).sum::<f64>();
    (squares(&mut a.iter().zip(b).map(|(a, b)| a - b)) / squares(&mut b.iter().copied())).sqrt()
}

const ALL: RangeInclusive<usize> = 0..=STAGES.len() - 1;
