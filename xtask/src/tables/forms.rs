//! Wire, chain and bag with equal degrees of freedom.

use super::chart::{Across, Panel, Series, svg};
use super::runs::{COMMON, Runs};
use super::text::{CELLS, COLUMNS, Measured, Row, csv, markdown};
use super::{Figure, Page, Result};

/// Divides into whole segments of every form.
pub const POINTS: usize = 220;

/// A form, its word, and samples a span with which every form is drawn through as many points: a chain's segment stands
/// for three spans of the wire, a bag's for four.
pub const FORMS: [(&str, usize); 3] = [("wire", 8), ("chain", 24), ("bag", 32)];

/// Two ways to fit: the paper's, and ours with as few control points. Neither keeps the wire smooth: a bag cannot be.
pub const SCHEDULES: [(&str, &[&str]); 2] =
    [("paper", &["--preset", "paper"]), ("ours", &["--preset", "best", "--smooth", "off"])];

/// Options of a fit of `points` control points in a form, neither re-initialised nor refined.
pub fn options(schedule: &[&str], (form, samples): (&str, usize), points: usize) -> Vec<String> {
    let numbers = ["--control-points".to_owned(), points.to_string(), "--set".into(), format!("samples={samples}")];
    let words = [schedule, COMMON, &["--form", form]].concat();
    words.into_iter().map(str::to_owned).chain(numbers).collect()
}

/// Without edits of the control points, so that the degrees of freedom stay equal to the end.
fn row(runs: &Runs, (schedule, words): (&str, &[&str]), form: (&str, usize)) -> Row {
    let mut options = options(words, form, POINTS);
    options.extend(["--no-reinit", "--no-refine"].map(str::to_owned));
    let seeds = if schedule == "paper" { runs.seeds().to_vec() } else { vec![0] };
    Row { name: format!("{schedule}, {}", form.0), options, seeds }
}

pub fn make(runs: &mut Runs) -> Result<Page> {
    let inputs = runs.drawings();
    let mut rows = Vec::new();
    for schedule in SCHEDULES {
        for form in FORMS {
            let row = row(runs, schedule, form);
            let measured = Measured::new(&row, inputs, runs)?;
            if measured.constant("control_points") != Some(POINTS as f64) {
                return Err(format!("{}: not {POINTS} control points in every run", measured.name).into());
            }
            rows.push(measured);
        }
    }
    let text = format!(
        "# Wire, chain and bag\n\n\
         One spline (`wire`), a chain of cubic Béziers joined end to end but free to bend sharply there, and a bag of \
         separate Béziers, each with {POINTS} control points of x, y, z and width: {} degrees of freedom, checked in every \
         run's report (73 segments make a chain, 55 a bag). All forms start as the same curve, are drawn through as many \
         points while fitting (8, 24 and 32 a span) and pay the same price for the same jerk. `paper`: its schedule and its \
         start, a ball of points; widths may vanish. `ours`: preset `best` with `--smooth off` and as few points, from a tree; \
         at least a pixel wide, and the same for every seed. No re-initialisation, no refinement. {}\n\n\
         {CELLS} Overlaps and distances are means over the views, against the same arranged drawings. Jerk is within \
         segments, over the same parameter range in every form; a chain's corners (joints that turn by more than 30°) \
         and a bag's gaps are not in it.\n\n{}\n![The same as bars, with the deviation over inputs](forms.svg)\n",
        4 * POINTS,
        runs.said(inputs),
        markdown(&rows, COLUMNS),
    );
    let panel = |title: &str, figure: &str| bars(title, figure, &rows, &["wire", "chain", "bag"], &["paper", "ours"]);
    let figure = svg(&[
        panel("soft IoU, of 1", "soft_iou"),
        panel("MS-SSIM, of 1", "ms_ssim"),
        panel("components, count", "components"),
        panel("connectivity cost, object's radii", "connectivity_cost"),
    ]);
    Ok(Page { markdown: text, csv: csv(&rows), figure: Some(Figure::Svg(figure)) })
}

/// `rows` in groups of one bar a series.
fn bars(title: &str, figure: &str, rows: &[Measured], series: &[&str], groups: &[&str]) -> Panel {
    let value = |i: usize| {
        let found = rows.get(i)?.spread(figure)?;
        Some((found.mean, found.inputs.unwrap_or(0.0)))
    };
    let of_series = |(s, name): (usize, &&str)| Series {
        name: (*name).to_owned(),
        values: (0..groups.len()).map(|g| value(g * series.len() + s)).collect(),
    };
    Panel {
        title: title.to_owned(),
        across: Across::Names(groups.iter().map(|&name| name.to_owned()).collect()),
        series: series.iter().enumerate().map(of_series).collect(),
        logarithmic: false,
    }
}
