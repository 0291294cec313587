//! Re-initialisation, refinement and the start, each on and off.

use super::chart::{Across, Panel, Series, svg};
use super::forms::{FORMS, POINTS, SCHEDULES, options};
use super::runs::Runs;
use super::text::{CELLS, COLUMNS, Column, Measured, Row, csv, markdown};
use super::{Figure, Page, Result};

/// Name and options beside those of the schedule. The first is the run without either, as in the table of forms.
const PAPER: &[(&str, &[&str])] = &[
    ("neither", &["--no-reinit", "--no-refine"]),
    ("reinit, random places", &["--reinit", "--no-refine", "--set", "new_point=random"]),
    ("reinit, where ink lacks", &["--reinit", "--no-refine", "--set", "new_point=lacking"]),
    ("refine", &["--no-reinit", "--refine"]),
    ("both, random places", &["--reinit", "--refine", "--set", "new_point=random"]),
    ("both, where ink lacks", &["--reinit", "--refine", "--set", "new_point=lacking"]),
];
const OURS: &[(&str, &[&str])] = &[
    ("tree", &["--no-reinit", "--no-refine"]),
    ("tree, reinit", &["--reinit", "--no-refine"]),
    ("tree, refine", &["--no-reinit", "--refine"]),
    ("hull", &["--no-reinit", "--no-refine", "--start", "hull"]),
    ("ball", &["--no-reinit", "--no-refine", "--start", "ball"]),
];

pub fn make(runs: &mut Runs) -> Result<Page> {
    let inputs = runs.drawings();
    let mut rows = Vec::new();
    for ((schedule, words), variants) in SCHEDULES.into_iter().zip([PAPER, OURS]) {
        for (name, more) in variants {
            let mut options = options(words, FORMS[0], POINTS);
            options.extend(more.iter().map(|&word| word.to_owned()));
            let random = schedule == "paper" || *name == "ball";
            let seeds = if random { runs.seeds().to_vec() } else { vec![0] };
            rows.push(Measured::new(&Row { name: format!("{schedule}: {name}"), options, seeds }, inputs, runs)?);
        }
    }
    let mut columns: Vec<Column> = COLUMNS.iter().filter(|column| column.0 != "corners").copied().collect();
    columns.extend([("reinit", "points moved", 0), ("refine", "points added", 0)]);
    let text = format!(
        "# Re-initialisation, refinement and the start\n\n\
         A wire of {POINTS} control points. `paper`: its schedule and its start, a ball of points; widths may vanish. \
         Re-initialisation after a sixth and a third of the run moves control points thinner than 0.1 px of 256, to random \
         places (the paper's text) or to where every view has ink and some still lack it, next to the nearest part of the \
         wire (our default). Refinement after two thirds adds a third more where the pictures pull hardest; the curve stays \
         the same at that moment. `ours`: preset `best` with `--smooth off` and as few points, at least a pixel wide, from a tree, \
         from points of the visual hull or from the ball. {}\n\n{CELLS}\n\n{}\n\
         ![The paper's schedule as bars, with the deviation over inputs](ablation.svg)\n",
        runs.said(inputs),
        markdown(&rows, &columns),
    );
    let names: Vec<String> = ["neither", "reinit random", "reinit lacking", "refine", "both random", "both lacking"]
        .map(str::to_owned)
        .to_vec();
    let panel = |title: &str, figure: &str| Panel {
        title: title.to_owned(),
        across: Across::Names(names.clone()),
        series: vec![Series {
            name: "paper's schedule".into(),
            values: rows[..PAPER.len()]
                .iter()
                .map(|row| row.spread(figure).map(|found| (found.mean, found.inputs.unwrap_or(0.0))))
                .collect(),
        }],
        logarithmic: false,
    };
    let figure = svg(&[
        panel("soft IoU, of 1", "soft_iou"),
        panel("MS-SSIM, of 1", "ms_ssim"),
        panel("components, count", "components"),
        panel("connectivity cost, object's radii", "connectivity_cost"),
    ]);
    Ok(Page { markdown: text, csv: csv(&rows), figure: Some(Figure::Svg(figure)) })
}
