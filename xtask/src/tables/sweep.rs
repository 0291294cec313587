//! How much more control points buy, in every form.

use super::chart::{Across, Panel, Series, svg};
use super::forms::{FORMS, SCHEDULES, options};
use super::runs::{Runs, Size};
use super::text::{CELLS, COLUMNS, Measured, Row, csv, markdown};
use super::{Figure, Page, Result};

pub fn make(runs: &mut Runs) -> Result<Page> {
    // A triple and a pair: this table has the most rows.
    let drawings = runs.drawings();
    let mut inputs = vec![drawings[0], drawings[drawings.len() - 1]];
    inputs.dedup();
    let inputs = &inputs[..];
    let points: &[usize] = match runs.size {
        Size::Full => &[40, 60, 100, 160, 220, 400],
        Size::Quick => &[40, 100, 220],
    };
    let mut rows = Vec::new();
    for form in FORMS {
        for &points in points {
            let mut options = options(SCHEDULES[1].1, form, points);
            options.extend(["--no-reinit", "--no-refine"].map(str::to_owned));
            let row = Row { name: format!("{}, {points} points", form.0), options, seeds: vec![0] };
            rows.push(Measured::new(&row, inputs, runs)?);
        }
    }
    let freedom = |measured: &Measured| measured.constant("control_points").map_or(0.0, |count| 4.0 * count);
    let counted: Vec<String> = rows.iter().map(|row| format!("{} has {}", row.name, freedom(row))).collect();
    let text = format!(
        "# Degrees of freedom\n\n\
         Preset `best` with `--smooth off` from a tree, at least a pixel wide, with a given number of control points of x, \
         y, z and width; no re-initialisation or refinement; the start and the fit are the same for every seed. Degrees of freedom, from the \
         reports: {}. (60 points make 19 whole segments of a chain, 58 points.) {}\n\n{CELLS}\n\n{}\n\
         ![The same over the number of control points, with the deviation over inputs](sweep.svg)\n",
        counted.join("; "),
        runs.said(inputs),
        markdown(&rows, COLUMNS),
    );
    let panel = |title: &str, figure: &str| Panel {
        title: title.to_owned(),
        across: Across::Numbers(points.iter().map(|&count| count as f64).collect(), "control points"),
        series: FORMS
            .iter()
            .zip(rows.chunks(points.len()))
            .map(|(form, rows)| Series {
                name: form.0.to_owned(),
                values: rows
                    .iter()
                    .map(|row| row.spread(figure).map(|found| (found.mean, found.inputs.unwrap_or(0.0))))
                    .collect(),
            })
            .collect(),
        logarithmic: false,
    };
    let figure = svg(&[
        panel("soft IoU, of 1", "soft_iou"),
        panel("MS-SSIM, of 1", "ms_ssim"),
        panel("edge distance, px of 256", "edge_distance_px"),
        panel("components, count", "components"),
    ]);
    Ok(Page { markdown: text, csv: csv(&rows), figure: Some(Figure::Svg(figure)) })
}
