//! What taking projected control points for a plane cubic costs and saves against the exact, rational image.
//! `cargo bench --bench rational -- FILE.csv` writes the table; without a file it is printed.

// The wires are those of the projection error's figure.
#[path = "../projection_error/figure.rs"]
#[allow(dead_code)]
mod figure;
mod reference;

use reference::{Rational, coverage, linearised, pieces, point, rational, vertices};
use std::fmt::Write;
use std::time::Instant;
use wire4d::raster::{ExactRaster, Raster, sampled_union};
use wire4d::view::{Flattening, Projection, View};
use wire4d::wire::{Stroke, Wire};

/// Chords of the reference and of every curve compared with it are within this.
const TOLERANCE_PX: f64 = 0.002;
/// Vertices a span where time is taken: as many by every route.
const SAMPLES: usize = 16;
const REPEATS: usize = 40;
/// Samples along each side of a pixel in the count that the rasteriser is held against.
const LATTICE: usize = 16;
/// Name, vertical field of view and distance: the single picture's camera, the surface-filling one, and one close by.
const CAMERAS: [(&str, f64, f64); 3] =
    [("20° at 3.8", 20.0, 3.8), ("49° at 3.0", 49.0, 3.0), ("60° at 2.0", 60.0, 2.0)];

fn main() -> std::process::ExitCode {
    let mut csv = String::from(
        "camera,control_points,route,vertices,largest_px,mean_px,edge_rms,largest_coverage,vertices_us,adjoint_us,raster_ms\n",
    );
    // One thread: shares of the work, not of the machine.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    pool.install(|| {
        for (name, fov, distance) in CAMERAS {
            for count in [100, 210] {
                rows(name, &camera(fov, distance), &figure::tour(count, 1), &mut csv);
            }
        }
    });
    // Cargo adds --bench.
    let Some(path) = std::env::args().skip(1).find(|argument| !argument.starts_with('-')) else {
        print!("{csv}");
        return std::process::ExitCode::SUCCESS;
    };
    match wire4d::files::write_whole(std::path::Path::new(&path), csv.as_bytes()) {
        Ok(()) => std::process::ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            std::process::ExitCode::FAILURE
        }
    }
}

fn camera(fov_deg: f64, distance: f64) -> View {
    let mut view = View::orthographic("bench", 0.7, 0.3, 2.0, 512);
    let length = view.eye.iter().map(|c| c * c).sum::<f64>().sqrt();
    view.eye = view.eye.map(|c| c * distance / length);
    view.projection = Projection::Perspective { fov_y_rad: fov_deg.to_radians() };
    view
}

fn rows(name: &str, view: &View, wire: &Wire, csv: &mut String) {
    let camera = view.camera::<f64>();
    let exact = pieces(wire, 1, |bezier| rational(&camera, bezier));
    let mut row = |route: &str, count: usize, errors: [f64; 4], times: [f64; 3]| {
        let [largest, mean, rms, most] = errors;
        let [vertices, adjoint, raster] = times;
        let _ = writeln!(
            csv,
            "{name},{},\"{route}\",{count},{largest:.5},{mean:.6},{rms:.6},{most:.5},{:.1},{:.1},{:.3}",
            wire.control_points().len(),
            1e6 * vertices,
            1e6 * adjoint,
            1e3 * raster
        );
    };
    // The reference, against a lattice of samples counted over the same vertices: what its rasteriser is off.
    let start = Instant::now();
    let true_vertices = vertices(&exact, TOLERANCE_PX);
    let vertices_s = start.elapsed().as_secs_f64();
    let raster_s = raster_time(view, &true_vertices);
    let truth = coverage(view, &true_vertices);
    let stroke = Stroke { start: 0, count: true_vertices.len(), closed: false };
    let counted = sampled_union(view.width_px, view.height_px, &true_vertices, &[stroke], LATTICE);
    let [rms, most] = coverage_error(&truth, &counted);
    row("rational, bounded", true_vertices.len(), [0.0, 0.0, rms, most], [vertices_s, f64::NAN, raster_s]);

    // Exact points of the curve: what fits use. One division a vertex makes them rational.
    let route = Flattening::<f32>::exact(wire, SAMPLES);
    let (times, sampled) = route_times(view, wire, &route);
    let [rms, most] = coverage_error(&coverage(view, &sampled), &counted);
    row("rational, 16 points", sampled.len(), [0.0, 0.0, rms, most], times);

    for count in [1, 2, 4, 8, 16] {
        let flat = pieces(wire, count, |bezier| linearised(&camera, bezier));
        let cut = pieces(wire, count, |bezier| rational(&camera, bezier));
        let [largest, mean] = distance(&flat, &cut);
        let [rms, most] = coverage_error(&coverage(view, &vertices(&flat, TOLERANCE_PX)), &truth);
        let route = Flattening::<f32>::beziers(wire, &vec![count; wire.spans().count()], SAMPLES / count);
        let (times, drawn) = route_times(view, wire, &route);
        row(&format!("linearised x{count}"), drawn.len(), [largest, mean, rms, most], times);
    }
}

/// Largest and mean distance of the centres at equal parameters, px.
fn distance(flat: &[Rational], exact: &[Rational]) -> [f64; 2] {
    let (mut largest, mut sum, mut count) = (0.0f64, 0.0, 0.0);
    for (flat, exact) in flat.iter().zip(exact) {
        for j in 0..=SAMPLES {
            let s = j as f64 / SAMPLES as f64;
            let (p, q) = (point(flat, s), point(exact, s));
            let error = (p[0] - q[0]).hypot(p[1] - q[1]);
            largest = largest.max(error);
            sum += error;
            count += 1.0;
        }
    }
    [largest, sum / count]
}

/// Root mean square and largest difference over the pixels that either picture covers in part.
fn coverage_error(found: &[f32], truth: &[f32]) -> [f64; 2] {
    let partly = |c: f32| c > 0.0 && c < 1.0;
    let edge = found.iter().zip(truth).filter(|&(&a, &b)| partly(a) || partly(b) || a != b);
    let errors: Vec<f64> = edge.map(|(a, b)| f64::from(a - b)).collect();
    let square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len().max(1) as f64;
    [square.sqrt(), errors.iter().fold(0.0, |most, e| most.max(e.abs()))]
}

/// Seconds from control points to vertices, of the adjoint back, and of drawing forward and backward.
fn route_times(view: &View, wire: &Wire, route: &Flattening<f32>) -> ([f64; 3], Vec<[f32; 3]>) {
    let camera = view.camera::<f32>();
    let points: Vec<[f32; 4]> = wire.control_points().iter().map(|point| point.map(|c| c as f32)).collect();
    let (mut world, mut flat) = (Vec::new(), Vec::new());
    let forward = least(|| {
        route.to_world(&points, &mut world);
        route.project(&camera, &world, &mut flat);
    });
    let d_vertices = vec![[1.0f32; 3]; flat.len()];
    let (mut d_world, mut d_points) = (vec![[0.0f32; 4]; world.len()], vec![[0.0f32; 4]; points.len()]);
    let adjoint = least(|| {
        d_world.fill([0.0; 4]);
        d_points.fill([0.0; 4]);
        route.project_vjp(&camera, &world, &d_vertices, &mut d_world);
        route.to_world_vjp(&d_world, &mut d_points);
    });
    ([forward, adjoint, raster_time(view, &flat)], flat)
}

fn raster_time(view: &View, vertices: &[[f32; 3]]) -> f64 {
    let stroke = Stroke { start: 0, count: vertices.len(), closed: false };
    let mut raster = ExactRaster::new();
    let (d_coverage, mut d_vertices) = (vec![1.0; view.width_px * view.height_px], Vec::new());
    least(|| {
        raster.forward(view.width_px, view.height_px, vertices, &[stroke]);
        raster.backward(&d_coverage, &mut d_vertices);
    })
}

/// The least of many times: other programs only add to one.
fn least(mut work: impl FnMut()) -> f64 {
    work();
    let time = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..REPEATS).map(time).fold(f64::INFINITY, f64::min)
}
