//! The rasteriser's speed: stored Bézier scenes with DiffVG's figures, and wires as a fit meets them.
//!
//! `cargo bench --bench raster` prints medians; `-- doubled` only the cases with that word in their name; `-- sweep`
//! instead draws thousands of adversarial wires and compares them with a sampled union. `-- card` instead takes an
//! iteration on a graphics card to pieces, stage by stage; with `--quick` as well only that of the smallest scene.

use std::time::Instant;
use wire4d::raster::flatten::{FlatStroke, Subdivision};
use wire4d::raster::{BandRaster, ExactRaster, Raster, sampled_union};
use wire4d::rng::Rng;
use wire4d::wire::Stroke;

#[cfg(feature = "gpu")]
mod card;
#[cfg(feature = "gpu")]
#[path = "../tests/support/optimize_common/mod.rs"]
mod common;
#[path = "../tests/support/raster_wires/mod.rs"]
mod raster_wires;

/// Scene and DiffVG's milliseconds forward and backward (2 x 2 samples, two cores of the reference machine).
const SCENES: [(&str, f64, f64); 3] =
    [("n100_s128_x1", 13.0, 55.0), ("n220_s256_x1", 67.0, 275.0), ("n100_s512_x1", 201.0, 875.0)];

fn main() {
    let asked = |word: &str| std::env::args().any(|argument| argument == word);
    if asked("sweep") {
        return sweep();
    }
    #[cfg(feature = "gpu")]
    if asked("card") {
        return by_stage();
    }
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            println!("\n{threads} thread{}: ms, median (least)", if threads > 1 { "s" } else { "" });
            bezier_scenes();
            fits();
        });
    }
}

#[cfg(feature = "gpu")]
fn by_stage() {
    let Some((device, cases)) = card::wanted() else { return };
    for case in cases {
        card::Loaded::new(&device, case).print_stages(case);
    }
}

/// Whether the words on the command line ask for this case.
fn wanted(name: &str) -> bool {
    std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).all(|word| name.contains(&word))
}

fn median_and_least(mut times: Vec<f64>) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    (times[times.len() / 2], times[0])
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

fn bezier_scenes() {
    println!(
        "| scene | flatten + forward | backward | both | DiffVG / both | stages (median) |\n|---|---|---|---|---|---|"
    );
    for (name, diffvg_forward, diffvg_backward) in SCENES {
        if !wanted(name) {
            continue;
        }
        let path = format!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/raster/{}.json"), name);
        let text = std::fs::read(path).expect("scene");
        let json: serde_json::Value = serde_json::from_slice(&text).expect("scene");
        let number = |value: &serde_json::Value| value.as_f64().unwrap_or(0.0) as f32;
        let size = json["size"].as_u64().unwrap_or(0) as usize;
        let control: Vec<[f32; 3]> = (0..json["bezier_radius"].as_array().map_or(0, Vec::len))
            .map(|i| {
                let point = &json["bezier_points"][i];
                [number(&point[0]), number(&point[1]), number(&json["bezier_radius"][i])]
            })
            .collect();
        let mut rng = Rng::new(1, 0);
        let adjoint: Vec<f32> = (0..size * size).map(|_| rng.range(-1.0, 1.0) as f32).collect();
        let (mut raster, mut flat) = (ExactRaster::new(), FlatStroke::new());
        let (mut d_vertices, mut d_control) = (Vec::new(), Vec::new());
        let (mut forward, mut backward, mut moments) = (Vec::new(), Vec::new(), Vec::new());
        let mut stages = Vec::<(&str, Vec<f64>)>::new();
        for run in 0..201 {
            let start = Instant::now();
            flat.flatten(&control, true, Subdivision::Tolerance(0.02));
            let mut last = Instant::now();
            let mut stage = 0;
            raster.forward_watched(size, size, flat.vertices(), &flat.strokes(), |name| {
                if run == 0 {
                    stages.push((name, Vec::new()));
                }
                stages[stage].1.push(milliseconds(last));
                (stage, last) = (stage + 1, Instant::now());
            });
            forward.push(milliseconds(start));
            let start = Instant::now();
            raster.backward(&adjoint, &mut d_vertices);
            flat.pull_back(&d_vertices, &mut d_control);
            backward.push(milliseconds(start));
            let start = Instant::now();
            flat.pull_back_moments(&raster, &adjoint, &mut d_control);
            moments.push(milliseconds(start));
        }
        let both = forward.iter().zip(&backward).map(|(f, b)| f + b).collect();
        let ((f, f0), (b, b0), (all, all0)) =
            (median_and_least(forward), median_and_least(backward), median_and_least(both));
        let ratio = (diffvg_forward + diffvg_backward) / all;
        let stages: Vec<_> = stages.into_iter().map(|(n, t)| format!("{n} {:.3}", median_and_least(t).0)).collect();
        println!(
            "| {name} | {f:.3} ({f0:.3}) | {b:.3} ({b0:.3}) | {all:.3} ({all0:.3}) | {ratio:.0} | {:.3} | {} |",
            median_and_least(moments).0,
            stages.join(", ")
        );
    }
}

/// A uniform cubic B-spline through random control points, `samples` a span, shifted against the sag.
fn spline(control: &[[f64; 3]], samples: usize) -> Vec<[f32; 3]> {
    let mut vertices = Vec::new();
    for window in control.windows(4) {
        for j in 0..samples {
            let t = j as f64 / samples as f64;
            let s = 1.0 - t;
            let sag = 1.0 / (12.0 * (samples * samples) as f64);
            let weights = [
                s * s * s / 6.0 - sag * s,
                (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0 - sag * (3.0 * t - 2.0),
                (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0 - sag * (3.0 * s - 2.0),
                t * t * t / 6.0 - sag * t,
            ];
            vertices
                .push(std::array::from_fn(|c| window.iter().zip(weights).map(|(p, w)| w * p[c]).sum::<f64>() as f32));
        }
    }
    vertices
}

/// A random walk that stays in the picture, with lines of a drawing's density.
fn control_walk(count: usize, size: f64, step: f64, rng: &mut Rng) -> Vec<[f64; 3]> {
    let (mut x, mut y, mut angle) = (size / 2.0, size / 2.0, 0.0f64);
    (0..count)
        .map(|_| {
            angle += rng.range(-0.9, 0.9);
            (x, y) = (x + step * angle.cos(), y + step * angle.sin());
            if !(0.08 * size..0.92 * size).contains(&x) || !(0.08 * size..0.92 * size).contains(&y) {
                angle = (size / 2.0 - y).atan2(size / 2.0 - x) + rng.range(-0.5, 0.5);
            }
            [x, y, rng.range(0.4, 0.9)]
        })
        .collect()
}

/// The same walk with every branch there and back, as wires grown from a tree are.
fn doubled_walk(count: usize, size: f64, step: f64, rng: &mut Rng) -> Vec<[f64; 3]> {
    let mut control: Vec<[f64; 3]> = Vec::new();
    while control.len() < count {
        let from = if control.is_empty() { [size / 2.0, size / 2.0, 0.6] } else { control[control.len() - 1] };
        let (mut angle, mut p, mut branch) = (rng.range(0.0, std::f64::consts::TAU), from, vec![from]);
        for _ in 0..8 + rng.below(30) {
            angle += rng.range(-0.5, 0.5);
            let next = [p[0] + step * angle.cos(), p[1] + step * angle.sin(), p[2]];
            if next[..2].iter().any(|c| !(0.05 * size..0.95 * size).contains(c)) {
                angle += 1.5;
                continue;
            }
            p = next;
            branch.push(p);
        }
        let keep = rng.below(branch.len());
        control.extend(branch.iter());
        control.extend(branch[keep..].iter().rev());
    }
    control.truncate(count);
    control
}

fn fits() {
    println!("\n| fit, three views, forward + backward | nodes a view | exact | band |\n|---|---|---|---|");
    let mut rng = Rng::new(5, 0);
    let case = |name: &str, size: usize, views: Vec<Vec<[f64; 3]>>, samples: usize| {
        if !wanted(name) {
            return;
        }
        let views: Vec<Vec<[f32; 3]>> = views.iter().map(|control| spline(control, samples)).collect();
        let exact = time_views::<ExactRaster>(size, &views);
        let band = time_views::<BandRaster>(size, &views);
        println!("| {name} | {} | {:.3} ({:.3}) | {:.3} ({:.3}) |", views[0].len(), exact.0, exact.1, band.0, band.1);
    };
    let plain = |count, size, step, rng: &mut Rng| (0..3).map(|_| control_walk(count, size, step, rng)).collect();
    let doubled = |count, size, step, rng: &mut Rng| (0..3).map(|_| doubled_walk(count, size, step, rng)).collect();
    case("220 controls x 8, 128 px", 128, plain(220, 128.0, 5.0, &mut rng), 8);
    case("220 controls x 4, 128 px", 128, plain(220, 128.0, 5.0, &mut rng), 4);
    case("220 controls x 8, 256 px", 256, plain(220, 256.0, 10.0, &mut rng), 8);
    case("1000 controls x 5, 128 px", 128, plain(1000, 128.0, 3.0, &mut rng), 5);
    case("1000 controls x 5, doubled, 128 px", 128, doubled(1000, 128.0, 2.0, &mut rng), 5);
    case("1000 controls x 5, doubled, 256 px", 256, doubled(1000, 256.0, 4.0, &mut rng), 5);
    case("1000 controls x 3, doubled, 128 px", 128, doubled(1000, 128.0, 2.0, &mut rng), 3);
}

/// Median and least milliseconds of forward and backward over all views, the views in parallel as in a fit.
fn time_views<R: Raster + Default>(size: usize, views: &[Vec<[f32; 3]>]) -> (f64, f64) {
    use rayon::prelude::*;
    let mut rng = Rng::new(2, 0);
    let adjoint: Vec<f32> = (0..size * size).map(|_| rng.range(-1.0, 1.0) as f32).collect();
    let mut rasters: Vec<(R, Vec<[f32; 3]>)> = views.iter().map(|_| (R::default(), Vec::new())).collect();
    let mut times = Vec::new();
    for _ in 0..101 {
        let start = Instant::now();
        rasters.par_iter_mut().zip(views).for_each(|((raster, d_vertices), vertices)| {
            let stroke = Stroke { start: 0, count: vertices.len(), closed: false };
            raster.forward(size, size, vertices, &[stroke]);
            raster.backward(&adjoint, d_vertices);
        });
        times.push(milliseconds(start));
    }
    median_and_least(times)
}

fn sweep() {
    use raster_wires::{FAMILIES, SIZE, Wires, wires};
    let mut raster = ExactRaster::new();
    println!("| family | wires | edge pixels | off by > 0.1 | rms | worst |\n|---|---|---|---|---|---|");
    for family in FAMILIES {
        let (mut wrong, mut pixels, mut worst, mut square) = (0, 0, 0.0f32, 0.0f64);
        const WIRES: u64 = 200;
        for seed in 0..WIRES {
            let Wires { vertices, strokes } = wires(family, 1000 + seed);
            let image = raster.forward(SIZE, SIZE, &vertices, &strokes);
            let sampled = sampled_union(SIZE, SIZE, &vertices, &strokes, 16);
            for (c, s) in image.iter().zip(&sampled) {
                let error = (c - s).abs();
                pixels += usize::from((0.001..0.999).contains(s));
                wrong += usize::from(error > 0.1);
                worst = worst.max(error);
                square += f64::from(error * error);
            }
        }
        let rms = (square / pixels.max(1) as f64).sqrt();
        println!("| {family} | {WIRES} | {pixels} | {wrong} | {rms:.4} | {worst:.3} |");
    }
}
