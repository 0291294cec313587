//! What each part of keeping a wire smooth does, by leaving it out.

use super::runs::{COMMON, Case, Runs};
use super::text::{CELLS, Column, Measured, Row, csv, markdown};
use super::{Figure, Page, Result};
use crate::tube;
use image::{GrayImage, Luma, imageops};
use wire4d_core::view::ViewSpec;

/// Name and options beside those that all have.
const VARIANTS: &[(&str, &[&str])] = &[
    ("all on", &[]),
    ("no routing (`--start tree`)", &["--start", "tree"]),
    ("no bending (`--smoothness 0`)", &["--smoothness", "0"]),
    ("tight bends stay (`--tightness 0`)", &["--tightness", "0"]),
    ("no clearance (`--clearance 0`)", &["--clearance", "0"]),
    ("few points (`--spacing 8`)", &["--spacing", "8"]),
    ("many points (`--spacing 3`)", &["--spacing", "3"]),
    ("constant width (`--width constant`)", &["--width", "constant"]),
    ("all off (`--smooth off`)", &["--smooth", "off"]),
];

const COLUMNS: &[Column] = &[
    ("kinks", "kinks", 1),
    ("tight_share", "tight, of 1", 3),
    ("touching_share", "touching, of 1", 3),
    ("penetrating_share", "penetrating, of 1", 3),
    ("turning_per_unit", "turning", 1),
    ("length_over_lines", "length / lines", 2),
    ("control_points", "points", 0),
    ("soft_iou", "soft IoU", 3),
    ("precision_2px", "precision, 2 px", 3),
    ("recall_2px", "recall, 2 px", 3),
    ("seconds", "seconds", 1),
];

/// Where wires are seen from in the figure, and the side of one and the gap between them, px.
const TURNED: &str = "35,15";
const CELL: u32 = 200;
const GAP: u32 = 2;

pub fn make(runs: &mut Runs) -> Result<Page> {
    let inputs = runs.lines();
    let (mut rows, mut cases) = (Vec::new(), Vec::new());
    for (name, more) in VARIANTS {
        let options: Vec<String> = [COMMON, more].concat().into_iter().map(str::to_owned).collect();
        let row = Row { name: (*name).to_owned(), options: options.clone(), seeds: vec![0] };
        rows.push(Measured::new(&row, inputs, runs)?);
        let case = |&input: &&str| Case { input: input.to_owned(), seed: 0, options: options.clone() };
        cases.push(inputs.iter().map(case).collect::<Vec<_>>());
    }
    let text = format!(
        "# A wire that is a wire\n\n\
         Preset `best`, the wire kept smooth, and the same with one part left out: the routing of the first wire, the price \
         of bending, the opening of bends that are too tight, the clearance between strands; with fewer and more control \
         points; with one width. Kinks turn by more than 60° within a gauge (1.5 mm of wire in a sculpture of 200 mm); \
         tight, touching and penetrating are shares of the length; turning is in radians a unit; length is over that of \
         the drawings' middle lines. Inputs: {}.\n\n{CELLS}\n\n{}\n\
         ![Each row of the table from left to right, turned by 35° and 15° from above; each input below the last](wire.png)\n",
        inputs.join(", "),
        markdown(&rows, COLUMNS),
    );
    let mut figure = GrayImage::from_pixel(
        VARIANTS.len() as u32 * (CELL + GAP) - GAP,
        inputs.len() as u32 * (CELL + GAP) - GAP,
        Luma([200]),
    );
    let view = TURNED.parse::<ViewSpec>()?.resolve(&[], 1.8, CELL as usize)?;
    for (column, cases) in cases.into_iter().enumerate() {
        for (line, case) in cases.iter().enumerate() {
            let place = |index: usize| i64::from(index as u32 * (CELL + GAP));
            imageops::replace(&mut figure, &tube::draw(runs.wire(case)?, &view), place(column), place(line));
        }
    }
    Ok(Page { markdown: text, csv: csv(&rows), figure: Some(Figure::Png(figure)) })
}
