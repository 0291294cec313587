//! The contact sheet: each picture, and its wire from the front and turned; and a table of figures.

use crate::shell::{command, root, run as run_command, say};
use crate::{Result, elegance};
use image::{DynamicImage, Rgba, RgbaImage, imageops};
use serde_json::Value;
use std::path::Path;

/// Azimuths and elevations shown, degrees.
const VIEWS: [&str; 5] = ["0,0", "35,15", "90,10", "180,0", "300,30"];
/// Side of one picture on the sheet, and the gap round it, px.
const CELL: u32 = 144;
const GAP: u32 = 4;
/// Pictures beside each other.
const COLUMNS: u32 = 2;

/// Runs every picture and writes the sheet into docs/gallery, or beside the runs if there are `extra` options.
pub fn run(names: &[&str], extra: &[String]) -> Result {
    let root = root();
    run_command(command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    let across = VIEWS.len() as u32 + 1;
    let rows = (names.len() as u32).div_ceil(COLUMNS);
    let mut sheet = RgbaImage::from_pixel(
        COLUMNS * across * (CELL + GAP) + GAP,
        rows * (CELL + GAP) + GAP,
        Rgba([150, 150, 150, 255]),
    );
    println!(
        "| picture | front soft IoU | sides' precision | sides' recall | pieces | length | seconds |{}",
        elegance::headings()
    );
    println!("|---|---|---|---|---|---|---|{}", elegance::rule());
    for (k, name) in names.iter().enumerate() {
        let (column, row) = (k as u32 % COLUMNS, k as u32 / COLUMNS);
        let source = root.join("tests/strokes").join(format!("{name}.png"));
        let out = root.join("out/strokes").join(name);
        std::fs::create_dir_all(out.parent().unwrap_or(&root))?;
        let wire4d = || command(&root.join("target/release/wire4d").to_string_lossy());
        run_command(
            wire4d()
                .arg("stroke")
                .arg(&source)
                .arg("--out")
                .arg(&out)
                .args(["--overwrite", "--quiet"])
                .args(extra)
                .stdout(std::process::Stdio::null()),
        )?;
        println!("{}", table_line(name, &out)?);
        let mut shown = vec![opened(&source)?];
        for view in VIEWS {
            let picture = out.join(format!("turned-{view}.png"));
            run_command(
                wire4d()
                    .arg("render")
                    .arg(out.join("wire.json"))
                    .arg("--out")
                    .arg(&picture)
                    .args([&format!("--view={view}"), "--size=288"])
                    .stdout(std::process::Stdio::null()),
            )?;
            let mut ink = opened(&picture)?.to_luma8();
            imageops::invert(&mut ink);
            shown.push(DynamicImage::ImageLuma8(ink));
        }
        for (v, picture) in shown.iter().enumerate() {
            let (x, y) = (GAP + (column * across + v as u32) * (CELL + GAP), GAP + row * (CELL + GAP));
            let small = imageops::resize(&picture.to_rgba8(), CELL, CELL, imageops::FilterType::Triangle);
            let paper = RgbaImage::from_pixel(CELL, CELL, Rgba([255; 4]));
            imageops::replace(&mut sheet, &paper, i64::from(x), i64::from(y));
            imageops::overlay(&mut sheet, &small, i64::from(x), i64::from(y));
        }
    }
    let path = root.join(if extra.is_empty() { "docs/gallery/strokes.png" } else { "out/strokes/sheet.png" });
    DynamicImage::ImageRgba8(sheet).to_rgb8().save(&path)?;
    say(format!("the sheet is {}", path.display()));
    Ok(())
}

fn opened(path: &Path) -> Result<DynamicImage, String> {
    image::open(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// The report's figures: the front's, and the means of the sides'.
fn table_line(name: &str, out: &Path) -> Result<String> {
    let report: Value = serde_json::from_str(&std::fs::read_to_string(out.join("report.json"))?)?;
    let result = &report["result"];
    let views = result["views"].as_array().map_or(&[][..], Vec::as_slice);
    let sides = |figure: &str| {
        let values: Vec<f64> = views.iter().skip(1).filter_map(|view| view[figure].as_f64()).collect();
        values.iter().sum::<f64>() / values.len().max(1) as f64
    };
    Ok(format!(
        "| {name} | {:.3} | {:.3} | {:.3} | {} | {:.0} | {:.1} |{}",
        views.first().and_then(|view| view["soft_iou"].as_f64()).unwrap_or(0.0),
        sides("precision_2px"),
        sides("recall_2px"),
        result["components"],
        result["length"].as_f64().unwrap_or(0.0),
        report["time"]["total_s"].as_f64().unwrap_or(0.0),
        elegance::cells(&[&elegance::Figures::of(&report, out)]),
    ))
}
