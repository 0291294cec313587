//! `cargo xtask gallery`: runs the command line over every set of drawings under tests/drawings and writes one contact
//! sheet and one table a bend choice into docs/gallery.

use crate::Result;
use image::{GrayImage, imageops};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Side of one picture on the sheet.
const CELL: u32 = 144;
const GAP: u32 = 8;
const SETS_A_ROW: u32 = 3;

/// One set's run.
struct Row {
    name: String,
    pair: bool,
    out: PathBuf,
    report: Value,
}

/// For the list of verbs.
pub const HELP: &str = "run every set of test drawings; contact sheets and tables go into docs/gallery";

/// Options: `--preset P`, `--bend none|little|free` (repeatable; all three by default), `--only NAME` (repeatable), and
/// after `--` anything for `wire4d multiview`.
pub fn run(arguments: &[String]) -> Result {
    let root = &crate::shell::root();
    let mut preset = "best".to_owned();
    let (mut bends, mut only, mut extra) = (Vec::new(), Vec::new(), Vec::new());
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        let mut value = || rest.next().cloned().ok_or(format!("{argument} needs a value"));
        match argument.as_str() {
            "--preset" => preset = value()?,
            "--bend" => bends.push(value()?),
            "--only" => only.push(value()?),
            "--" => extra.extend(rest.by_ref().cloned()),
            other => return Err(format!("unknown option {other}").into()),
        }
    }
    if bends.is_empty() {
        bends = ["none", "little", "free"].map(str::to_owned).to_vec();
    }
    let status = Command::new("cargo")
        .args(["build", "--release", "--bin", "wire4d"])
        .current_dir(root)
        .status()
        .map_err(|error| format!("cargo cannot be started: {error}"))?;
    if !status.success() {
        return Err("wire4d does not build".into());
    }
    let docs = root.join("docs/gallery");
    std::fs::create_dir_all(&docs).map_err(|error| format!("{}: {error}", docs.display()))?;
    for bend in &bends {
        let rows = sets(root)?
            .into_iter()
            .filter(|set| only.is_empty() || only.iter().any(|name| set.contains(name.as_str())))
            .map(|set| run_set(root, &set, &preset, bend, &extra))
            .collect::<Result<Vec<_>, String>>()?;
        let table = table(&rows, bend);
        println!("{table}");
        if only.is_empty() && extra.is_empty() {
            let stem = format!("{preset}-{bend}");
            let path = docs.join(format!("{stem}.md"));
            std::fs::write(&path, &table).map_err(|error| format!("{}: {error}", path.display()))?;
            sheet(&rows, bend)?.save(docs.join(format!("{stem}.png"))).map_err(|error| error.to_string())?;
        } else {
            let path = root.join("out/gallery/sheet.png");
            sheet(&rows, bend)?.save(&path).map_err(|error| error.to_string())?;
            println!("sheet: {}", path.display());
        }
    }
    Ok(())
}

/// The names of the folders under tests/drawings that hold a front picture.
fn sets(root: &Path) -> Result<Vec<String>, String> {
    let folder = root.join("tests/drawings");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .map_err(|error| format!("{}: {error}", folder.display()))?
        .flatten()
        .filter(|entry| entry.path().join("front.png").is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    // Triples first, then pairs.
    names.sort_by_key(|name| (name.starts_with('p'), name.clone()));
    Ok(names)
}

fn run_set(root: &Path, name: &str, preset: &str, bend: &str, extra: &[String]) -> Result<Row, String> {
    let folder = root.join("tests/drawings").join(name);
    let out = root.join("out/gallery").join(format!("{name}-{preset}-{bend}"));
    let _ = std::fs::remove_dir_all(&out);
    std::fs::create_dir_all(out.parent().unwrap_or(root)).map_err(|error| error.to_string())?;
    let pictures: Vec<PathBuf> = ["front", "side", "top"]
        .iter()
        .map(|view| folder.join(format!("{view}.png")))
        .filter(|path| path.is_file())
        .collect();
    let output = Command::new(root.join("target/release/wire4d"))
        .arg("multiview")
        .args(&pictures)
        .args(["--preset", preset, "--bend", bend, "--quiet", "--out"])
        .arg(&out)
        .args(extra)
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    let text = std::fs::read_to_string(out.join("report.json")).map_err(|error| format!("{name}: {error}"))?;
    let report = serde_json::from_str(&text).map_err(|error| format!("{name}: report.json: {error}"))?;
    Ok(Row { name: name.to_owned(), pair: pictures.len() == 2, out, report })
}

impl Row {
    fn views(&self) -> &[Value] {
        self.report["result"]["views"].as_array().map_or(&[], Vec::as_slice)
    }

    /// A figure of every view: of the bent comparison where there is one and it is asked for.
    fn figures(&self, name: &str, bent: bool) -> Vec<f64> {
        self.views()
            .iter()
            .filter_map(|view| {
                let view = if bent && view["bent"].is_object() { &view["bent"] } else { view };
                view[name].as_f64()
            })
            .collect()
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value) / values.len().max(1) as f64
}

fn table(rows: &[Row], bend: &str) -> String {
    let bent = bend != "none";
    let mut text = String::from(
        "| set | soft IoU | by view | against the unbent | precision | recall | moved (mean / max px) | coverable | pieces | length | points | seconds |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let mut line = |name: &str, rows: &[&Row]| {
        let all =
            |figure: &str, bent: bool| rows.iter().map(|row| mean(&row.figures(figure, bent))).collect::<Vec<_>>();
        let numbers = |part: &str, figure: &str| -> Vec<f64> {
            rows.iter().filter_map(|row| row.report[part][figure].as_f64()).collect()
        };
        let by_view = match rows {
            [row] => row.figures("soft_iou", bent).iter().map(|x| format!("{x:.2}")).collect::<Vec<_>>().join(" "),
            _ => {
                let worst = rows.iter().flat_map(|row| row.figures("soft_iou", bent)).fold(1.0, f64::min);
                format!("worst {worst:.2}")
            }
        };
        let moved = all("mean_px", true);
        let max_px = rows.iter().flat_map(|row| row.figures("max_px", true)).fold(0.0, f64::max);
        let _ = writeln!(
            text,
            "| {name} | {:.3} | {by_view} | {:.3} | {:.3} | {:.3} | {:.1} / {:.1} | {:.2} | {:.0} | {:.1} | {:.0} | {:.1} |",
            mean(&all("soft_iou", bent)),
            mean(&all("soft_iou", false)),
            mean(&all("precision_2px", bent)),
            mean(&all("recall_2px", bent)),
            mean(&moved),
            max_px,
            mean(&all("target_coverable", false)),
            numbers("result", "components").into_iter().fold(0.0, f64::max),
            mean(&numbers("result", "length")),
            mean(&numbers("result", "control_points")),
            mean(&numbers("time", "total_s")),
        );
    };
    for row in rows {
        line(&row.name, &[row]);
    }
    for (name, pair) in [("**triples, mean**", false), ("**pairs, mean**", true)] {
        let some: Vec<&Row> = rows.iter().filter(|row| row.pair == pair).collect();
        if !some.is_empty() {
            line(name, &some);
        }
    }
    text
}

/// For each set a block: the pictures to show (bent where they were) above what the wire shows.
fn sheet(rows: &[Row], bend: &str) -> Result<GrayImage, String> {
    let (block_w, block_h) = (3 * (CELL + 2) + GAP, 2 * (CELL + 2) + GAP);
    let lines = (rows.len() as u32).div_ceil(SETS_A_ROW);
    let mut sheet = GrayImage::from_pixel(SETS_A_ROW * block_w + GAP, lines * block_h + GAP, image::Luma([110]));
    for (i, row) in rows.iter().enumerate() {
        let (x0, y0) = (GAP + (i as u32 % SETS_A_ROW) * block_w, GAP + (i as u32 / SETS_A_ROW) * block_h);
        for (v, view) in row.views().iter().enumerate().take(3) {
            let name = view["name"].as_str().unwrap_or_default();
            let bent = row.out.join(format!("{name}-bent.png"));
            let wanted =
                if bend != "none" && bent.is_file() { bent } else { row.out.join(format!("{name}-target.png")) };
            for (line, path) in [wanted, row.out.join(format!("{name}.png"))].iter().enumerate() {
                let picture = image::open(path).map_err(|error| format!("{}: {error}", path.display()))?.to_luma8();
                let small = imageops::resize(&picture, CELL, CELL, imageops::FilterType::Triangle);
                let (x, y) = (x0 + v as u32 * (CELL + 2), y0 + line as u32 * (CELL + 2));
                imageops::replace(&mut sheet, &small, i64::from(x), i64::from(y));
            }
        }
    }
    Ok(sheet)
}
