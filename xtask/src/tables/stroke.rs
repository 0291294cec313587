//! One picture to a wire: starts and the paper's settings.

use super::chart::{Across, Panel, Series, svg};
use super::runs::Runs;
use super::text::{CELLS, Column, Measured, Row, csv, markdown};
use super::{Page, Result};

const VARIANTS: &[(&str, &[&str])] =
    &[("best", &["--preset", "best"]), ("fast", &["--preset", "fast"]), ("paper", &["--preset", "paper"])];

const COLUMNS: &[Column] = &[
    ("soft_iou", "soft IoU", 3),
    ("ms_ssim", "MS-SSIM", 3),
    ("edge_distance_px", "edge distance, px", 2),
    ("tone_match", "tone match", 3),
    ("components", "components", 1),
    ("connectivity_cost", "connectivity cost", 2),
    ("length", "length", 1),
    ("control_points", "points", 0),
    ("seconds", "seconds", 1),
];

pub fn make(runs: &mut Runs) -> Result<Page> {
    let inputs = runs.pictures();
    let mut rows = Vec::new();
    for (name, words) in VARIANTS {
        let options = words.iter().chain(&["--backend", "cpu"]).map(|&word| word.to_owned()).collect();
        rows.push(Measured::new(&Row { name: (*name).to_owned(), options, seeds: vec![0] }, inputs, runs)?);
    }
    let text = format!(
        "# One picture\n\n\
         `wire4d stroke` at the reference view, its front, against that preset's own target there: lines as wide as the \
         picture is dark for `best` and `fast`, the picture's greys for `paper` (the paper's loss and schedule; its \
         diffusion prior is not part of this). Rows with different targets do not compare column by column. Seed 0. Inputs: {}.\n\n\
         {CELLS}\n\n{}\n![The same as bars, with the deviation over inputs](stroke.svg)\n",
        inputs.join(", "),
        markdown(&rows, COLUMNS),
    );
    let panel = |title: &str, figure: &str| Panel {
        title: title.to_owned(),
        across: Across::Names(VARIANTS.iter().map(|variant| variant.0.to_owned()).collect()),
        series: vec![Series {
            name: "front view".into(),
            values: rows
                .iter()
                .map(|row| row.spread(figure).map(|found| (found.mean, found.inputs.unwrap_or(0.0))))
                .collect(),
        }],
        logarithmic: false,
    };
    let figure = svg(&[panel("MS-SSIM, of 1", "ms_ssim"), panel("tone match, of 1", "tone_match")]);
    Ok(Page { markdown: text, csv: csv(&rows), svg: Some(figure) })
}
