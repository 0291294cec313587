//! Milliseconds an iteration of a fit, everything included: three views at 128 px on the processor, then several sizes on
//! a graphics card as well, if there is one. `cargo bench --bench step`; `-- card` only the latter, `-- card --quick` only
//! its smallest size, for a program that stands in for a card (`--any`).

use std::time::Instant;
use wire4d::objective::{MultiscaleMse, Pyramid};
use wire4d::optimize::{Bending, Problem, RasterKind, Recipe, Session, Stage};

#[cfg(feature = "gpu")]
mod card;
#[path = "../tests/support/optimize_common/mod.rs"]
mod common;

/// Control points, samples a span and the bar on two cores in milliseconds.
const WIRES: [(usize, usize, f64); 2] = [(220, 8, 1.5), (1000, 3, 3.0)];
const ITERATIONS: usize = 150;

fn main() {
    if std::env::args().all(|argument| argument != "card") {
        on_processor();
    }
    #[cfg(feature = "gpu")]
    on_card();
}

/// Whole iterations: on the card, on the processor, and how long the processor takes to tell the card what to do.
#[cfg(feature = "gpu")]
fn on_card() {
    let Some((device, cases)) = card::wanted() else { return };
    let threads = rayon::current_num_threads();
    println!("\nMilliseconds an iteration, median (least).\n");
    println!(
        "| control points x samples | card | aim | recording | processor, {threads} threads | times faster | loss, gradient off | MB | largest buffer |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for case in cases {
        let mut loaded = card::Loaded::new(&device, case);
        let (on_card, recording) = loaded.time_all();
        let on_processor = loaded.time_on_processor();
        let (loss, gradient) = loaded.differences();
        let (bytes, (largest, most)) = loaded.memory();
        println!(
            "| {case} | {on_card} | {} | {:.3} | {on_processor} | {:.2} | {loss:.0e}, {gradient:.0e} | {:.1} | {largest:?} {:.1} |",
            case.aim_ms.map_or("–".into(), |aim| aim.to_string()),
            recording.median,
            on_processor.median / on_card.median,
            bytes as f64 / 1e6,
            most as f64 / 1e6,
        );
    }
}

fn on_processor() {
    println!("| control points x samples | raster | bending | threads | ms an iteration, median (least) | bar |");
    println!("|---|---|---|---|---|---|");
    for (controls, samples_per_span, bar) in WIRES {
        // One curve, about 40 long as wires for three drawings are, with as many control points as asked for.
        let curve = common::random_wire(220, 3);
        let spans = (curve.control_points().len() - 3) as f64;
        let more = controls - curve.control_points().len();
        let knots: Vec<f64> = (0..more).map(|i| (i as f64 + 0.37) * spans / more as f64).collect();
        let (truth, _) = curve.insert_knots(&knots).expect("knots inside");
        let targets = common::targets_of(&truth, 128);
        let start = common::perturbed(&truth, 0.01, 8);
        for (raster, bending, threads) in [
            (RasterKind::Exact, None, 2),
            (RasterKind::Exact, None, 1),
            (RasterKind::Exact, Some(Bending { from: 0.0, ..Bending::default() }), 2),
            (RasterKind::Band, None, 2),
        ] {
            let bends = if bending.is_some() { "yes" } else { "no" };
            let stage = Stage { iterations: ITERATIONS, size_px: 128, raster, samples_per_span, restarts: vec![] };
            let recipe = Recipe { stages: vec![stage], bending, ..Recipe::best() };
            let problem = Problem::for_drawings(start.clone(), targets.clone(), recipe);
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let (median, least) = pool.install(|| time(Session::new(problem).expect("a valid problem")));
            println!(
                "| {controls} x {samples_per_span} | {raster:?} | {bends} | {threads} | {median:.2} ({least:.2}) | {} |",
                if threads == 2 { format!("{bar:.1}") } else { "–".into() }
            );
        }
    }
    for pyramid in [Pyramid::Gaussian, Pyramid::AveragePool] {
        let mut mse = MultiscaleMse::<f32>::new(pyramid, 128, 128);
        let (image, target) = (vec![0.3f32; 128 * 128], vec![0.6f32; 128 * 128]);
        let repeats = 400;
        let start = Instant::now();
        let sum: f32 = (0..repeats).map(|_| mse.evaluate(&image, &target, 1.0, 1.0).0).sum();
        let each = start.elapsed().as_secs_f64() * 1e3 / f64::from(repeats);
        println!("\nloss and gradient of one 128 px view, {pyramid:?}: {each:.4} ms (checksum {sum:.1})");
    }
}

/// Median and least of batches of ten iterations.
fn time(mut session: Session) -> (f64, f64) {
    session.step(10);
    let mut times = Vec::new();
    while !session.is_done() {
        let start = Instant::now();
        session.step(10);
        times.push(start.elapsed().as_secs_f64() * 1e3 / 10.0);
    }
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0])
}
