//! `cargo xtask gallery`: runs the command line over every set of drawings under tests/drawings and writes one contact
//! sheet and one table a bend choice into docs/gallery.

use crate::shell::{command, root, run as run_command, say};
use crate::{Result, elegance, picture, tube};
use image::{GrayImage, Luma, imageops};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use wire4d_core::view::{View, ViewSpec};
use wire4d_core::wire::Wire;

/// Side of one picture on the sheet, the gap between pictures, and the wider one between parts.
const CELL: u32 = 200;
const GAP: u32 = 2;
const WIDE_GAP: u32 = 10;
const GROUND: Luma<u8> = Luma([200]);
/// Views of a set: the drawings, as many of the wire, and the turned ones.
const MOST_VIEWS: u32 = 3;
/// Where the wire is also seen from: azimuth and elevation in degrees.
const TURNED: [&str; 3] = ["35,15", "60,15", "90,15"];
/// Height of a turned view, that of the drawings' own.
const HEIGHT_WORLD: f64 = 2.2;
/// What is around the object on each side, as a share of the picture.
const MARGIN: f64 = 0.05;

/// What sets are made of, by the beginnings of their names. The one left over, t07, is sparse outlines.
const KINDS: [(&str, &[&str]); 3] = [
    ("pairs of lines", &["p02", "p03", "p05"]),
    ("triples of lines", &["t01", "t03", "t05", "t06", "t09", "t10"]),
    ("solids", &["p01", "p04", "t02", "t04", "t08"]),
];
/// Sets that `--before` shows: two pairs and four triples.
const COMPARED: [&str; 6] = ["p02", "p03", "t01", "t03", "t06", "t10"];

/// One set's run.
struct Row {
    name: String,
    out: PathBuf,
    report: Value,
    elegance: elegance::Figures,
}

/// What to run.
struct Options {
    preset: String,
    bends: Vec<String>,
    only: Vec<String>,
    before: bool,
    extra: Vec<String>,
}

/// For the list of verbs.
pub const HELP: &str = "run every set of test drawings; contact sheets and tables go into docs/gallery";

/// Options: `--preset P`, `--bend none|little|free` (repeatable; all three by default), `--only NAME` (repeatable),
/// `--before` (instead of the rest, some sets with `--smooth off` above the same with `--smooth on`), and after `--`
/// anything for `wire4d multiview`. With `--only` or anything after `--` sheets go into out/gallery.
pub fn run(arguments: &[String]) -> Result {
    let options = Options::read(arguments)?;
    run_command(command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    for folder in ["docs/gallery", "out/gallery"] {
        std::fs::create_dir_all(root().join(folder)).map_err(|error| format!("{folder}: {error}"))?;
    }
    if options.before {
        before_and_after(&options)
    } else {
        options.bends.iter().try_for_each(|b| gallery(&options, b))
    }
}

impl Options {
    fn read(arguments: &[String]) -> Result<Options> {
        let mut options = Options { preset: "best".into(), bends: vec![], only: vec![], before: false, extra: vec![] };
        let mut rest = arguments.iter();
        while let Some(argument) = rest.next() {
            let mut value = || rest.next().cloned().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "--preset" => options.preset = value()?,
                "--bend" => options.bends.push(value()?),
                "--only" => options.only.push(value()?),
                "--before" => options.before = true,
                "--" => options.extra.extend(rest.by_ref().cloned()),
                other => return Err(format!("unknown option {other}").into()),
            }
        }
        if options.bends.is_empty() {
            let default: &[&str] = if options.before { &["little"] } else { &["none", "little", "free"] };
            options.bends = default.iter().map(|&bend| bend.to_owned()).collect();
        }
        Ok(options)
    }

    /// Where a sheet or table goes: into docs/gallery only if it is of what it says.
    fn path(&self, name: &str) -> PathBuf {
        let whole = self.only.is_empty() && self.extra.is_empty();
        root().join(if whole { "docs/gallery" } else { "out/gallery" }).join(name)
    }
}

fn gallery(options: &Options, bend: &str) -> Result {
    let rows = sets(&options.only)?
        .into_iter()
        .map(|set| Row::run(&set, &options.preset, bend, &options.extra))
        .collect::<Result<Vec<_>>>()?;
    let table = table(&rows, bend);
    println!("{table}");
    let stem = format!("{}-{bend}", options.preset);
    let path = options.path(&format!("{stem}.md"));
    std::fs::write(&path, &table).map_err(|error| format!("{}: {error}", path.display()))?;
    let groups = rows.iter().map(|row| Ok(vec![row.line(bend)?])).collect::<Result<Vec<_>>>()?;
    save(&groups, &options.path(&format!("{stem}.png")))
}

fn before_and_after(options: &Options) -> Result {
    let compared: Vec<String> = COMPARED.map(str::to_owned).to_vec();
    let (bend, mut rows, mut groups) = (&options.bends[0], [Vec::new(), Vec::new()], Vec::new());
    for set in sets(if options.only.is_empty() { &compared } else { &options.only })? {
        let mut lines = Vec::new();
        for (smooth, rows) in ["off", "on"].into_iter().zip(&mut rows) {
            let extra = [&["--smooth".to_owned(), smooth.to_owned()], &options.extra[..]].concat();
            let row = Row::run(&set, &options.preset, bend, &extra)?;
            lines.push(row.line(bend)?);
            rows.push(row);
        }
        groups.push(lines);
    }
    let [before, after] = rows.map(|rows| table(&rows, bend));
    let text = format!("`--smooth off`:\n\n{before}\n`--smooth on`:\n\n{after}");
    println!("{text}");
    let path = options.path("smooth-before-after.md");
    std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    save(&groups, &path.with_extension("png"))
}

/// The names of the folders under tests/drawings that hold a front picture, or those in which one of some words occurs.
fn sets(words: &[String]) -> Result<Vec<String>> {
    let folder = root().join("tests/drawings");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .map_err(|error| format!("{}: {error}", folder.display()))?
        .flatten()
        .filter(|entry| entry.path().join("front.png").is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .filter(|name| words.is_empty() || words.iter().any(|word| name.contains(word.as_str())))
        .collect();
    if names.is_empty() {
        return Err(format!("no set under tests/drawings is called {}", words.join(" or ")).into());
    }
    // Triples first, then pairs.
    names.sort_by_key(|name| (name.starts_with('p'), name.clone()));
    Ok(names)
}

impl Row {
    fn run(name: &str, preset: &str, bend: &str, extra: &[String]) -> Result<Row> {
        let folder = root().join("tests/drawings").join(name);
        let out = root().join("out/gallery").join(format!("{name}-{preset}-{bend}"));
        // Nothing that an earlier run left may be taken for this one's.
        let _ = std::fs::remove_dir_all(&out);
        let pictures = ["front", "side", "top"].map(|view| folder.join(format!("{view}.png")));
        let output = command("target/release/wire4d")
            .arg("multiview")
            .args(pictures.iter().filter(|path| path.is_file()))
            .args(["--preset", preset, "--bend", bend, "--quiet", "--out"])
            .arg(&out)
            .args(extra)
            .output()?;
        if !output.status.success() {
            return Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr).trim()).into());
        }
        let report = read(&out.join("report.json"))?;
        say(format!("{name} {}: {:.1} s", extra.join(" "), report["time"]["total_s"].as_f64().unwrap_or(0.0)));
        Ok(Row { name: name.to_owned(), elegance: elegance::Figures::of(&report, &out), out, report })
    }

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

    /// A line of the sheet: the pictures to show (bent where they were), the wire from where it shows them, and turned.
    fn line(&self, bend: &str) -> Result<GrayImage> {
        let made = read(&self.out.join("wire.json"))?;
        let views: Vec<View> = serde_json::from_value(made["views"].clone())?;
        let wire: Wire = serde_json::from_value(made)?;
        let turned = TURNED.iter().map(|view| view.parse::<ViewSpec>()?.resolve(&[], HEIGHT_WORLD, CELL as usize));
        let turned = turned.collect::<Result<Vec<View>, _>>()?;
        let share = views.iter().chain(&turned).map(|view| share_needed(&wire, view)).fold(0.1, f64::max).min(1.0);
        let part = MOST_VIEWS * (CELL + GAP) - GAP;
        let mut line = GrayImage::from_pixel(3 * part + 2 * WIDE_GAP, CELL, GROUND);
        let mut put = |block: usize, k: usize, picture: &GrayImage| {
            let x = block as u32 * (part + WIDE_GAP) + k as u32 * (CELL + GAP);
            imageops::replace(&mut line, picture, i64::from(x), 0);
        };
        for (k, view) in views.iter().enumerate().take(MOST_VIEWS as usize) {
            put(0, k, &middle(&self.drawing(&view.name, bend)?, share));
            put(1, k, &shown(&wire, view, share));
        }
        turned.iter().enumerate().for_each(|(k, view)| put(2, k, &shown(&wire, view, share)));
        Ok(line)
    }

    /// What a view is to show, as ink on paper.
    fn drawing(&self, view: &str, bend: &str) -> Result<GrayImage> {
        let bent = self.out.join(format!("{view}-bent.png"));
        let path = if bend != "none" && bent.is_file() { bent } else { self.out.join(format!("{view}-target.png")) };
        let mut picture = image::open(&path).map_err(|error| format!("{}: {error}", path.display()))?.to_luma8();
        imageops::invert(&mut picture);
        Ok(picture)
    }
}

fn read(path: &Path) -> Result<Value> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The share of a view's width or height, whichever is more, that the wire needs around the middle, with a margin.
fn share_needed(wire: &Wire, view: &View) -> f64 {
    let camera = view.with_size(2, 2).camera::<f64>();
    // The curve lies within the hull of its control points.
    let reach = wire.control_points().iter().map(|point| {
        let [x, y, radius] = camera.project(point);
        radius + (x - 1.0).abs().max((y - 1.0).abs())
    });
    reach.fold(0.0, f64::max) * (1.0 + 2.0 * MARGIN)
}

/// The wire in the middle `share` of a view.
fn shown(wire: &Wire, view: &View, share: f64) -> GrayImage {
    let whole = (f64::from(CELL) / share).round() as usize;
    middle(&tube::draw(wire, &view.with_size(whole, whole)), share)
}

/// The middle `share` of a square picture, as large as a cell.
fn middle(picture: &GrayImage, share: f64) -> GrayImage {
    let (width, height) = picture.dimensions();
    let side = ((f64::from(width.min(height)) * share).round() as u32).max(1);
    let cut = imageops::crop_imm(picture, (width - side) / 2, (height - side) / 2, side, side).to_image();
    imageops::resize(&cut, CELL, CELL, imageops::FilterType::Triangle)
}

/// Stacks the lines of each group close, and the groups apart.
fn save(groups: &[Vec<GrayImage>], path: &Path) -> Result {
    let width = groups.iter().flatten().map(GrayImage::width).max().unwrap_or(1);
    let heights = groups.iter().map(|lines| lines.iter().map(|line| line.height() + GAP).sum::<u32>() + WIDE_GAP - GAP);
    let mut sheet = GrayImage::from_pixel(width + 2 * WIDE_GAP, heights.sum::<u32>() + WIDE_GAP, GROUND);
    let mut y = WIDE_GAP;
    for lines in groups {
        for line in lines {
            imageops::replace(&mut sheet, line, i64::from(WIDE_GAP), i64::from(y));
            y += line.height() + GAP;
        }
        y += WIDE_GAP - GAP;
    }
    picture::save_lines(sheet, path)?;
    say(format!("the sheet is {}", path.display()));
    Ok(())
}

fn mean(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |sum, value| sum + value) / values.len().max(1) as f64
}

fn table(rows: &[Row], bend: &str) -> String {
    let bent = bend != "none";
    let mut text = format!(
        "| set | soft IoU | by view | against the unbent | precision | recall | moved (mean / max px) | coverable | pieces | length | seconds |{}\n\
         |---|---|---|---|---|---|---|---|---|---|---|{}\n",
        elegance::headings(),
        elegance::rule(),
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
            "| {name} | {:.3} | {by_view} | {:.3} | {:.3} | {:.3} | {:.1} / {:.1} | {:.2} | {:.0} | {:.1} | {:.1} |{}",
            mean(&all("soft_iou", bent)),
            mean(&all("soft_iou", false)),
            mean(&all("precision_2px", bent)),
            mean(&all("recall_2px", bent)),
            mean(&moved),
            max_px,
            mean(&all("target_coverable", false)),
            numbers("result", "components").into_iter().fold(0.0, f64::max),
            mean(&numbers("result", "length")),
            mean(&numbers("time", "total_s")),
            elegance::cells(&rows.iter().map(|row| &row.elegance).collect::<Vec<_>>()),
        );
    };
    for row in rows {
        line(&row.name, &[row]);
    }
    let mut means = |name: &str, beginnings: &[&str]| {
        let belongs = |row: &&Row| beginnings.iter().any(|beginning| row.name.starts_with(beginning));
        let some: Vec<&Row> = rows.iter().filter(belongs).collect();
        if some.len() > 1 {
            line(&format!("**{name}, mean**"), &some);
        }
    };
    KINDS.iter().for_each(|(name, beginnings)| means(name, beginnings));
    means("triples", &["t"]);
    means("pairs", &["p"]);
    text
}
