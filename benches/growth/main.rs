//! How an iteration grows with the pictures' size, their number and the wire's points, on one thread. `cargo xtask growth`
//! runs it natively and as wasm: a crate of its own, since what the tests depend on knows no wasm.

use std::time::Instant;
use wire4d::optimize::{Problem, RasterKind, Recipe, Session, Smooth, Stage};
use wire4d::view::{Target, View};
use wire4d::wire::Wire;

#[path = "../../tests/support/optimize_common/mod.rs"]
mod common;

/// Pixels a side, views, control points.
type Case = [usize; 3];

const USUAL: Case = [256, 3, 800];
const SIZES_PX: [usize; 4] = [128, 256, 512, 1024];
const VIEWS: [usize; 5] = [1, 2, 4, 8, 16];
const POINTS: [usize; 6] = [200, 400, 800, 2000, 5000, 10_000];
const ROUNDS: usize = 5;
const ITERATIONS: usize = 4;

/// A line a case: what grows, to how much, and the least milliseconds, with tabs in between.
fn main() {
    let rows = [("size, px", &SIZES_PX[..]), ("views", &VIEWS), ("control points", &POINTS)];
    for (at, (name, values)) in rows.into_iter().enumerate() {
        for &value in values {
            let mut case = USUAL;
            case[at] = value;
            println!("{name}\t{value}\t{}", least_ms(case));
        }
    }
}

/// Whole iterations of a fit that is kept smooth.
fn least_ms([size_px, views, points]: Case) -> f64 {
    // The same curve with more and more points: its length stays.
    let curve = rings();
    let spans = (curve.control_points().len() - 3) as f64;
    let more = points - curve.control_points().len();
    let knots: Vec<f64> = (0..more).map(|i| (i as f64 + 0.37) * spans / more as f64).collect();
    let (truth, _) = curve.insert_knots(&knots).expect("knots inside");
    let looks = (0..views).map(|i| {
        View::orthographic(&format!("view {i}"), std::f64::consts::PI * i as f64 / views as f64, 0.3, 2.2, size_px)
    });
    let targets = looks.map(|view| Target { ink: common::draw(&curve, &view), view }).collect();
    let iterations = (ROUNDS + 1) * ITERATIONS;
    let stage = Stage { iterations, size_px, raster: RasterKind::Exact, samples_per_span: 3, restarts: vec![] };
    let recipe = Recipe { stages: vec![stage], smooth: Some(Smooth::default()), ..Recipe::best() };
    let problem = Problem::for_drawings(common::perturbed(&truth, 0.01, 8), targets, recipe);
    let mut session = Session::new(problem).expect("a valid problem");
    session.step(ITERATIONS);
    let mut least = f64::INFINITY;
    while !session.is_done() {
        let start = Instant::now();
        session.step(ITERATIONS);
        least = least.min(start.elapsed().as_secs_f64() * 1e3 / ITERATIONS as f64);
    }
    least
}

/// A wire of 200 control points that winds round a ball.
fn rings() -> Wire {
    let points = (0..200).map(|i| {
        let (t, turn) = (f64::from(i) / 199.0, 0.9 * f64::from(i));
        let height = 1.6 * t - 0.8;
        let radius = 0.8 * (1.0 - height * height).sqrt();
        [radius * turn.cos(), height, radius * turn.sin(), 0.03]
    });
    Wire::open_uniform(points.collect()).expect("a wire")
}
