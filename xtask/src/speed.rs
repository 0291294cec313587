//! `cargo xtask speed`: the same fast runs natively on one thread and in wasm, one after the other.

use crate::{Result, page, shell, wasm};
use serde_json::Value;
use std::path::Path;

/// For the list of verbs.
pub const HELP: &str = "compare the fast run natively on one thread and in wasm";

const SETS: &[&str] = &["t01-animals", "t06-icons", "p02-garden"];
const FILLS: &[[&str; 2]] = &[["sphere", "waves"], ["creature", "petals"]];
const ROUNDS: usize = 3;

/// One run, as both programs are told of it.
struct Job {
    name: String,
    native: Vec<String>,
    web: Vec<String>,
}

/// Prints a row a job with the least seconds of three rounds.
pub fn run(_: &[String]) -> Result {
    page::install_packages()?;
    wasm::build()?;
    shell::run(shell::command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    let scratch = shell::root().join("out/speed");
    std::fs::create_dir_all(&scratch)?;
    println!(
        "| run | native, one thread: start + fit, s | wasm: start + fit, s | ratio: start, fit |\n|---|---|---|---|"
    );
    let jobs: Vec<Job> = SETS.iter().map(|set| drawings(set, &scratch)).collect::<Result<_>>()?;
    for job in jobs.into_iter().chain(FILLS.iter().map(fill)) {
        let (mut native, mut web) = ([f64::INFINITY; 2], [f64::INFINITY; 2]);
        for _ in 0..ROUNDS {
            least(&mut native, &natively(&job, &scratch.join("made"))?);
            least(&mut web, &in_wasm(&job)?);
        }
        let [start, fit] = [0, 1].map(|part| web[part] / native[part]);
        println!(
            "| {} | {:.2} + {:.2} | {:.2} + {:.2} | {start:.2}, {fit:.2} |",
            job.name, native[0], native[1], web[0], web[1]
        );
    }
    Ok(())
}

fn drawings(set: &str, scratch: &Path) -> Result<Job> {
    let folder = shell::root().join("tests/drawings").join(set);
    let mut job = Job { name: set.into(), native: vec!["multiview".into()], web: vec!["multiview".into()] };
    for view in ["front", "side", "top"] {
        let path = folder.join(format!("{view}.png"));
        if !path.is_file() {
            continue;
        }
        let rgba = image::open(&path)?.to_rgba8();
        let raw = scratch.join(format!("{set}-{view}.rgba"));
        std::fs::write(&raw, rgba.as_raw())?;
        let (width, height) = rgba.dimensions();
        job.native.push(path.display().to_string());
        job.web.extend([view.to_owned(), width.to_string(), height.to_string(), raw.display().to_string()]);
    }
    job.native.extend(["--bend", "none"].map(str::to_owned));
    Ok(job)
}

fn fill(&[shape, pattern]: &[&str; 2]) -> Job {
    Job {
        name: format!("{shape}, {pattern}"),
        native: ["fill", shape, "--style", pattern].map(str::to_owned).into(),
        web: ["fill", shape, pattern].map(str::to_owned).into(),
    }
}

fn natively(job: &Job, out: &Path) -> Result<Value> {
    let _ = std::fs::remove_dir_all(out);
    let mut command = shell::command("target/release/wire4d");
    command.args(&job.native).args(["--preset", "fast", "--quiet", "--out"]).arg(out);
    shell::output(command.env("RAYON_NUM_THREADS", "1")).ok_or("wire4d failed")?;
    let report: Value = serde_json::from_slice(&std::fs::read(out.join("report.json"))?)?;
    Ok(report["time"].clone())
}

fn in_wasm(job: &Job) -> Result<Value> {
    let mut command = shell::command("node");
    command.arg("xtask/src/speed.mjs").arg(shell::root().join("www/src/engine/wasm")).args(&job.web);
    let text = shell::output(&mut command).ok_or("node failed")?;
    Ok(serde_json::from_str(text.trim())?)
}

fn least(kept: &mut [f64; 2], time: &Value) {
    for (kept, part) in kept.iter_mut().zip(["start_s", "optimize_s"]) {
        *kept = kept.min(time[part].as_f64().unwrap_or(f64::INFINITY));
    }
}
