//! `cargo xtask speed`: the same fast run natively on one thread and in wasm, one after the other.

use crate::{Result, page, shell, wasm};
use serde_json::Value;

/// For the list of verbs.
pub const HELP: &str = "compare the fast run natively on one thread and in wasm";

const SETS: &[&str] = &["t01-animals", "t06-icons", "p02-garden"];
const ROUNDS: usize = 3;

/// Prints a row a set with the least seconds of three rounds.
pub fn run(_: &[String]) -> Result {
    let root = shell::root();
    page::install_packages()?;
    wasm::build()?;
    shell::run(shell::command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    let scratch = root.join("out/speed");
    std::fs::create_dir_all(&scratch)?;
    println!(
        "| set | native, one thread: start + fit, s | wasm: start + fit, s | ratio of the fits |\n|---|---|---|---|"
    );
    for set in SETS {
        let folder = root.join("tests/drawings").join(set);
        let pictures = ["front", "side", "top"].map(|view| folder.join(format!("{view}.png")));
        let pictures: Vec<_> = pictures.iter().filter(|path| path.is_file()).collect();
        let mut node = vec![root.join("www/src/engine/wasm").display().to_string()];
        for (i, path) in pictures.iter().enumerate() {
            let rgba = image::open(path)?.to_rgba8();
            let raw = scratch.join(format!("{i}.rgba"));
            std::fs::write(&raw, rgba.as_raw())?;
            let (width, height) = rgba.dimensions();
            node.extend([format!("{i}"), width.to_string(), height.to_string(), raw.display().to_string()]);
        }
        let (mut native, mut web) = ([f64::INFINITY; 2], [f64::INFINITY; 2]);
        for _ in 0..ROUNDS {
            let out = scratch.join("made");
            let _ = std::fs::remove_dir_all(&out);
            let mut command = shell::command("target/release/wire4d");
            command.arg("multiview").args(&pictures).args(["--preset", "fast", "--bend", "none", "--quiet", "--out"]);
            shell::output(command.arg(&out).env("RAYON_NUM_THREADS", "1")).ok_or("wire4d failed")?;
            let report: Value = serde_json::from_slice(&std::fs::read(out.join("report.json"))?)?;
            least(&mut native, &report["time"]);
            let mut command = shell::command("node");
            let text = shell::output(command.arg("xtask/src/speed.mjs").args(&node)).ok_or("node failed")?;
            least(&mut web, &serde_json::from_str(text.trim())?);
        }
        let ratio = web[1] / native[1];
        println!("| {set} | {:.2} + {:.2} | {:.2} + {:.2} | {ratio:.2} |", native[0], native[1], web[0], web[1]);
    }
    Ok(())
}

fn least(kept: &mut [f64; 2], time: &Value) {
    for (kept, part) in kept.iter_mut().zip(["start_s", "optimize_s"]) {
        *kept = kept.min(time[part].as_f64().unwrap_or(f64::INFINITY));
    }
}
