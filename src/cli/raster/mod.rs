//! `wire4d raster`: one 2D scene through the rasteriser, for accuracy and timing.

mod npy;
mod scene;

use crate::args;
use clap::ArgMatches;
use scene::{MOST_PIXELS_A_SIDE, Scene, SceneRaster, mean_squared_error};
use std::path::{Path, PathBuf};
use std::time::Instant;
use wire4d::files::{read_at_most, write_whole};
use wire4d::gpu::{Device, GpuRaster, Kind};
use wire4d::raster::Raster;
use wire4d::view::Image;
use wire4d::{Error, Result};

/// A target of the largest size in 8-byte numbers fits.
const MOST_FILE_BYTES: usize = (8 * MOST_PIXELS_A_SIDE * MOST_PIXELS_A_SIDE) + 4096;

/// What is asked for.
struct Asked {
    /// The scene's JSON.
    scene: PathBuf,
    /// Target coverage (.npy) for the loss.
    target: Option<PathBuf>,
    /// Where to write the coverage (.npy).
    out: Option<PathBuf>,
    /// Where to write loss and gradient (.json); needs a target.
    grad: Option<PathBuf>,
    /// How many runs to time.
    repeat: Option<u32>,
}

#[derive(serde::Serialize)]
struct Gradient {
    d_points: Vec<[f32; 2]>,
    d_radius: Vec<f32>,
    loss: f64,
}

#[derive(serde::Serialize)]
struct Timing {
    scene: String,
    forward_ms: f64,
    backward_ms: f64,
    backend: &'static str,
}

/// `wire4d raster`.
pub fn run(matches: &ArgMatches) -> Result<()> {
    let path = |name: &str| matches.get_one::<PathBuf>(name).cloned();
    let asked = Asked {
        scene: args::path(matches, "scene").to_owned(),
        target: path("target"),
        out: path("out"),
        grad: path("grad"),
        repeat: matches.get_one::<u32>("repeat").copied(),
    };
    let on_gpu = matches.get_one::<String>("backend").is_some_and(|backend| backend == "gpu");
    let line = if on_gpu { on_device(&asked)? } else { measure(&asked, None)? };
    line.iter().for_each(|line| println!("{line}"));
    Ok(())
}

fn on_device(asked: &Asked) -> Result<Option<String>> {
    let mut raster = GpuRaster::new(&Device::acquire(Kind::Any)?);
    let line = measure(asked, Some(("gpu", &mut raster)))?;
    raster.trouble().map_or(Ok(line), |fault| Err(fault.clone().into()))
}

/// Draws the scene, with a rasteriser named `backend` or the processor's, writes what is asked for and returns the line
/// of timings, if any.
fn measure(asked: &Asked, on: Option<(&'static str, &mut dyn Raster)>) -> Result<Option<String>> {
    let scene = Scene::from_json(&name_of(&asked.scene), &read(&asked.scene)?)?;
    let target = match &asked.target {
        Some(path) => Some(read_target(path, scene.size)?),
        None if asked.grad.is_some() => {
            return Err(Error::setting("--grad", "needs a target to compare with", "add --target T.npy"));
        }
        None => None,
    };
    // From here on a worker of the thread pool: passing work to it from outside costs a wake-up every time.
    rayon::scope(|_| draw(asked, &scene, target.as_ref(), on))
}

fn draw(
    asked: &Asked,
    scene: &Scene,
    target: Option<&Image>,
    on: Option<(&'static str, &mut dyn Raster)>,
) -> Result<Option<String>> {
    let (backend, mut raster) = match on {
        Some((name, raster)) => (name, SceneRaster::on(raster)),
        None => ("cpu", SceneRaster::new()),
    };
    let (mut d_coverage, mut d_control) = (Vec::new(), Vec::new());
    let coverage = raster.forward(scene);
    if let Some(path) = &asked.out {
        write_whole(path, &npy::encode(scene.size, scene.size, coverage))?;
    }
    match target {
        Some(target) => {
            let loss = mean_squared_error(coverage, target, &mut d_coverage);
            if let Some(path) = &asked.grad {
                raster.backward(&d_coverage, &mut d_control);
                let d_points = d_control.iter().map(|d| [d[0], d[1]]).collect();
                let gradient = Gradient { d_points, d_radius: d_control.iter().map(|d| d[2]).collect(), loss };
                write_whole(path, json(&asked.scene, &gradient)?.as_bytes())?;
            }
        }
        None => d_coverage.resize(coverage.len(), 1.0 / coverage.len() as f32),
    }
    let Some(repeat) = asked.repeat else { return Ok(None) };
    let (mut forward, mut backward) = (Vec::new(), Vec::new());
    // The first few runs warm up.
    for run in 0..repeat.max(1) + 3 {
        let start = Instant::now();
        raster.forward(scene);
        let middle = Instant::now();
        raster.backward(&d_coverage, &mut d_control);
        if run >= 3 {
            forward.push((middle - start).as_secs_f64() * 1e3);
            backward.push(middle.elapsed().as_secs_f64() * 1e3);
        }
    }
    let (forward_ms, backward_ms) = (median(forward), median(backward));
    let scene_name = asked.scene.file_stem().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    json(&asked.scene, &Timing { scene: scene_name, forward_ms, backward_ms, backend }).map(Some)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[values.len() / 2]
}

fn json(path: &Path, value: &impl serde::Serialize) -> Result<String> {
    serde_json::to_string(value)
        .map_err(|problem| Error::output(name_of(path), format!("cannot be reported ({problem})"), "report this"))
}

fn name_of(path: &Path) -> String {
    path.display().to_string()
}

fn read(path: &Path) -> Result<Vec<u8>> {
    let bytes = read_at_most(path, MOST_FILE_BYTES).map_err(|problem| {
        Error::input(name_of(path), format!("cannot be read ({problem})"), "check the name and that it may be read")
    })?;
    bytes.ok_or_else(|| Error::input(name_of(path), "is larger than any scene or target", "give another file"))
}

fn read_target(path: &Path, size: usize) -> Result<Image> {
    let target = npy::decode(&name_of(path), &read(path)?)?;
    if (target.width, target.height) != (size, size) {
        let problem = format!("is {} x {}, the scene {size} x {size}", target.width, target.height);
        return Err(Error::input(name_of(path), problem, "give a target of the scene's size"));
    }
    Ok(target)
}
