//! `cargo xtask fills`: covers built-in shapes in built-in styles, draws contact sheets and prints a table of figures.

use crate::picture::save_lines;
use crate::shell::{command, root, run as run_command, say};
use crate::{Result, elegance};
use image::{GrayImage, Luma, imageops};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// For the list of verbs.
pub const HELP: &str =
    "covers shapes in styles and draws docs/gallery/fill-*.png; `shapes`, `styles` or `density` only one";

/// Side of one picture on a sheet, and the gap round it, px.
const CELL: u32 = 300;
const GAP: u32 = 10;
const SHAPES: [&str; 5] = ["sphere", "torus", "knot", "vase", "creature"];

/// One run: its folder's name, and what `wire4d fill` is told.
struct Cell {
    name: String,
    arguments: Vec<String>,
    view: &'static str,
}

impl Cell {
    fn new(shape: &str, style: Option<&str>, settings: &[(&str, f64)]) -> Cell {
        let mut name = format!("{shape}-{}", style.unwrap_or("plain"));
        let mut arguments = vec![shape.to_owned()];
        if let Some(style) = style {
            arguments.extend(["--style".into(), style.into()]);
        }
        for (setting, value) in settings {
            name += &format!("-{value}");
            arguments.push(format!("--{setting}={value}"));
        }
        Cell { name, arguments, view: "front" }
    }
}

/// Options: which sheet, then anything for `wire4d fill`.
pub fn run(arguments: &[String]) -> Result {
    run_command(command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    let (only, extra) = match arguments.split_first() {
        Some((word, rest)) if ["shapes", "styles", "density"].contains(&word.as_str()) => (Some(word.as_str()), rest),
        _ => (None, arguments),
    };
    println!(
        "| run | length | area / length / spacing | mean | 99% | worst | near | drift | pieces | covering s | fit s |{}",
        elegance::headings()
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|{}", elegance::rule());
    for (sheet, columns, cells) in sheets() {
        if only.is_none_or(|word| word == sheet) {
            draw(sheet, columns, &cells, extra)?;
        }
    }
    Ok(())
}

/// Name, columns and runs of each sheet.
fn sheets() -> [(&'static str, u32, Vec<Cell>); 3] {
    let shapes = SHAPES.map(|shape| Cell::new(shape, None, &[])).into();
    let mut styles = Vec::new();
    for shape in ["sphere", "vase", "creature"] {
        for style in ["petals", "waves", "calligraphy"] {
            styles
                .extend([0.2, 0.6, 1.0].map(|strength| Cell::new(shape, Some(style), &[("style-strength", strength)])));
        }
    }
    let mut density = Vec::new();
    for ink in [0.3, 0.5, 0.7] {
        density.extend(
            [0.0, 0.5, 1.0].map(|strength| {
                Cell::new("creature", Some("petals"), &[("density", ink), ("style-strength", strength)])
            }),
        );
    }
    [("shapes", 5, shapes), ("styles", 9, styles), ("density", 3, density)]
}

fn draw(sheet: &str, columns: u32, cells: &[Cell], extra: &[String]) -> Result {
    let rows = (cells.len() as u32).div_ceil(columns);
    let mut picture = GrayImage::from_pixel(columns * (CELL + GAP) + GAP, rows * (CELL + GAP) + GAP, Luma([255]));
    for (k, cell) in cells.iter().enumerate() {
        let out = covered(cell, extra)?;
        println!("{}", table_line(&cell.name, &out)?);
        let path = out.join(format!("{}.png", cell.view));
        let mut ink = image::open(&path).map_err(|error| format!("{}: {error}", path.display()))?.to_luma8();
        imageops::invert(&mut ink);
        let small = imageops::resize(&ink, CELL, CELL, imageops::FilterType::Triangle);
        let (column, row) = (k as u32 % columns, k as u32 / columns);
        let place = |index: u32| i64::from(GAP + index * (CELL + GAP));
        imageops::replace(&mut picture, &small, place(column), place(row));
    }
    let name = format!("fill-{sheet}.png");
    let path =
        if extra.is_empty() { root().join("docs/gallery").join(&name) } else { root().join("out/fills").join(&name) };
    save_lines(picture, &path)?;
    say(format!("the sheet is {}", path.display()));
    Ok(())
}

/// Runs a cell, and says where its files lie.
fn covered(cell: &Cell, extra: &[String]) -> Result<PathBuf> {
    let out = root().join("out/fills").join(&cell.name);
    std::fs::create_dir_all(out.parent().unwrap_or(&out))?;
    run_command(
        command(&root().join("target/release/wire4d").to_string_lossy())
            .arg("fill")
            .args(&cell.arguments)
            .arg("--out")
            .arg(&out)
            .args(["--overwrite", "--quiet"])
            .args(extra)
            .stdout(std::process::Stdio::null()),
    )?;
    Ok(out)
}

fn table_line(name: &str, out: &Path) -> Result<String> {
    let report: Value = serde_json::from_str(&std::fs::read_to_string(out.join("report.json"))?)?;
    let (result, time) = (&report["result"], &report["time"]);
    let surface = &result["surface"];
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    Ok(format!(
        "| {name} | {:.1} | {:.3} | {:.3} | {:.3} | {:.2} | {:.2}% | {:.3} | {} | {:.1} | {:.1} |{}",
        number(&result["length"]),
        number(&surface["spacing_ratio"]),
        number(&surface["mean"]),
        number(&surface["p99"]),
        number(&surface["worst"]),
        100.0 * number(&surface["crowded"]),
        number(&surface["drift_max"]),
        result["components"],
        number(&time["start_s"]),
        number(&time["optimize_s"]),
        elegance::cells(&[&elegance::Figures::of(&report, out)]),
    ))
}
