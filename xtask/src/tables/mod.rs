//! `cargo xtask tables`: runs the release binary over the committed inputs and writes the comparisons into docs/tables:
//! a page, every run's figures and a figure a table.

mod ablation;
mod chart;
mod forms;
mod projection;
mod rational;
mod runs;
mod stats;
mod stroke;
mod sweep;
mod text;
mod wire;

use crate::{Result, picture, shell};
use image::GrayImage;
use runs::{Runs, Size};
use std::path::{Path, PathBuf};

/// For the list of verbs.
pub const HELP: &str = "measure the comparisons with the paper into docs/tables (--quick: a taste, into out/tables)";

struct Table {
    name: &'static str,
    make: fn(&mut Runs) -> Result<Page>,
}

const TABLES: &[Table] = &[
    Table { name: "forms", make: forms::make },
    Table { name: "ablation", make: ablation::make },
    Table { name: "sweep", make: sweep::make },
    Table { name: "projection", make: projection::make },
    Table { name: "rational", make: rational::make },
    Table { name: "stroke", make: stroke::make },
    Table { name: "wire", make: wire::make },
];

/// What one table leaves behind.
struct Page {
    markdown: String,
    csv: String,
    figure: Option<Figure>,
}

/// A figure that lies beside the page: bars and curves, or wires as they look.
enum Figure {
    Svg(String),
    Png(GrayImage),
}

/// Options: `--quick` (fewer inputs, one seed, into out/tables), `--only NAME` (repeatable).
pub fn run(arguments: &[String]) -> Result {
    let mut size = Size::Full;
    let mut only = Vec::new();
    let mut rest = arguments.iter();
    while let Some(argument) = rest.next() {
        match argument.as_str() {
            "--quick" => size = Size::Quick,
            "--only" => only.push(rest.next().ok_or("--only needs a name")?.clone()),
            other => return Err(format!("unknown option {other}").into()),
        }
    }
    if let Some(unknown) = only.iter().find(|name| TABLES.iter().all(|table| table.name != **name)) {
        let names: Vec<&str> = TABLES.iter().map(|table| table.name).collect();
        return Err(format!("there is no table {unknown}; there are {}", names.join(", ")).into());
    }
    shell::run(shell::command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    // A taste must not take the place of what was measured in full.
    let folder = shell::root().join(if size == Size::Full { "docs/tables" } else { "out/tables" });
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut runs = Runs::new(size);
    for table in TABLES.iter().filter(|table| only.is_empty() || only.iter().any(|name| name == table.name)) {
        let page = (table.make)(&mut runs)?;
        write(&folder, table.name, "md", &page.markdown)?;
        write(&folder, table.name, "csv", &page.csv)?;
        match page.figure {
            Some(Figure::Svg(svg)) => write(&folder, table.name, "svg", &svg)?,
            Some(Figure::Png(png)) => picture::save_lines(png, &folder.join(format!("{}.png", table.name)))?,
            None => {}
        }
    }
    Ok(())
}

fn write(folder: &Path, name: &str, ending: &str, text: &str) -> Result {
    let path: PathBuf = folder.join(format!("{name}.{ending}"));
    std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    shell::say(path.display());
    Ok(())
}
