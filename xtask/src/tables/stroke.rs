//! One picture to a wire: the presets, and the same comparisons as for several drawings.

use super::chart::{Across, Panel, Series, svg};
use super::forms::{FORMS, POINTS};
use super::runs::{Runs, Size};
use super::text::{CELLS, Column, Measured, Row, csv, markdown};
use super::{Figure, Page, Result};

const COLUMNS: &[Column] = &[
    ("soft_iou", "soft IoU", 3),
    ("ms_ssim", "MS-SSIM", 3),
    ("edge_distance_px", "edge distance, px", 2),
    ("feature_distance", "feature distance", 3),
    ("tone_match", "tone match", 3),
    ("side_precision_2px", "sides' precision, 2 px", 3),
    ("side_recall_2px", "sides' recall, 2 px", 3),
    ("components", "components", 1),
    ("connectivity_cost", "connectivity cost", 2),
    ("length", "length", 1),
    ("jerk", "jerk", 1),
    ("seconds", "seconds", 1),
];

/// The picture's own greys: a target that depends on no other option.
const GREY: &[&str] = &["--shading", "grey"];
const PAPER: &[&str] = &["--preset", "paper"];
/// As free to bend sharply as the paper's, so that starts and forms alone differ.
const OURS: &[&str] = &["--preset", "best", "--smooth", "off"];
const NO_EDITS: &[&str] = &["--no-reinit", "--no-refine"];

/// A part of the page: a heading, what it compares, and its rows.
struct Part {
    heading: &'static str,
    words: &'static str,
    rows: Vec<Row>,
}

fn row(name: impl Into<String>, parts: &[&[&str]], more: &[String], seeds: &[u64]) -> Row {
    let words = parts.iter().copied().flatten().chain(&["--backend", "cpu"]);
    let options = words.map(|&word| word.to_owned()).chain(more.iter().cloned()).collect();
    Row { name: name.into(), options, seeds: seeds.to_vec() }
}

fn points(count: usize) -> [String; 2] {
    ["--control-points".into(), count.to_string()]
}

fn presets(seeds: &[u64]) -> Part {
    let preset = |name: &'static str| row(name, &[&["--preset", name]], &[], seeds);
    Part {
        heading: "Presets",
        words: "Each against its own target: lines as wide as the picture is dark for `best` and `fast`, greys for `paper` \
                (the paper's loss and schedule; its diffusion prior is not part of this). Rows do not compare.",
        rows: ["best", "fast", "paper"].map(preset).into(),
    }
}

fn forms(seeds: &[u64]) -> Part {
    let mut rows = Vec::new();
    for (schedule, words) in [("paper", [PAPER, GREY].concat()), ("ours", OURS.to_vec())] {
        for (form, samples) in FORMS {
            let [flag, count] = points(POINTS);
            let more = [flag, count, "--form".into(), form.into(), "--set".into(), format!("samples={samples}")];
            rows.push(row(format!("{schedule}, {form}"), &[&words, NO_EDITS], &more, seeds));
        }
    }
    Part {
        heading: "Wire, chain and bag",
        words: "220 control points each (880 degrees of freedom), drawn through as many points, the same price for the same \
                jerk. `paper`: greys, from points in the solid, widths may vanish. `ours`: lines as sparse as 220 points \
                allow, from a walk along them, at least a pixel wide.",
        rows,
    }
}

fn edits(seeds: &[u64]) -> Part {
    let variants: [(&str, &[&str]); 5] = [
        ("neither", NO_EDITS),
        ("reinit, random places", &["--reinit", "--no-refine", "--set", "new_point=random"]),
        ("reinit, where ink lacks", &["--reinit", "--no-refine", "--set", "new_point=lacking"]),
        ("refine", &["--no-reinit", "--refine"]),
        ("both, where ink lacks", &["--reinit", "--refine", "--set", "new_point=lacking"]),
    ];
    Part {
        heading: "Re-initialisation and refinement",
        words: "The paper's schedule and start against greys, 120 control points, which one refinement makes 220.",
        rows: variants.map(|(name, words)| row(name, &[PAPER, GREY, words], &[], seeds)).into(),
    }
}

fn starts(seeds: &[u64]) -> Part {
    let start = |(name, schedule, start): (&str, &[&str], &str)| {
        row(name, &[schedule, GREY, NO_EDITS, &["--start", start]], &points(POINTS), seeds)
    };
    let variants = [
        ("paper: points in the solid", PAPER, "hull"),
        ("paper: points in a ball", PAPER, "ball"),
        ("ours: along lines", OURS, "contour"),
        ("ours: points in the solid", OURS, "hull"),
        ("ours: points in a ball", OURS, "ball"),
    ];
    Part {
        heading: "Starts and schedules",
        words: "220 control points against the same greys in every row.",
        rows: variants.map(start).into(),
    }
}

fn sweep(size: Size) -> Part {
    let counts: &[usize] = match size {
        Size::Full => &[40, 60, 100, 160, 220, 400],
        Size::Quick => &[40, 220],
    };
    let each = |&count: &usize| row(format!("{count} points"), &[OURS, GREY], &points(count), &[0]);
    Part {
        heading: "Degrees of freedom",
        words: "Preset `best` with `--smooth off` and a given number of control points, against the same greys in every row; \
                seed 0, on which only the sides depend.",
        rows: counts.iter().map(each).collect(),
    }
}

pub fn make(runs: &mut Runs) -> Result<Page> {
    let inputs = runs.pictures();
    let seeds = runs.seeds();
    let parts = [presets(seeds), forms(seeds), edits(seeds), starts(seeds), sweep(runs.size)];
    let mut text = format!(
        "# One picture\n\n\
         `wire4d stroke` at the reference view, its front; the sides' figures are against the solid's silhouettes from six \
         sides that the fit does not see. Greys can only be hatched by a wire, so soft IoU against them stays low whatever \
         a wire does: tone match says how well the hatching reads from afar. Inputs: {}. Seeds: {seeds:?}.\n\n{CELLS}\n",
        inputs.join(", "),
    );
    let (mut all, mut panels) = (Vec::new(), Vec::new());
    for Part { heading, words, rows } in parts {
        let measured = rows.iter().map(|row| Measured::new(row, inputs, runs)).collect::<Result<Vec<_>>>()?;
        text += &format!("\n## {heading}\n\n{words}\n\n{}", markdown(&measured, COLUMNS));
        if heading.starts_with("Wire") {
            let figures = [("MS-SSIM, of 1", "ms_ssim"), ("components, count", "components")];
            panels.extend(figures.map(|(title, figure)| bars(title, figure, &measured)));
        }
        all.extend(measured);
    }
    text += "\n![The forms as bars, with the deviation over inputs](stroke.svg)\n";
    Ok(Page { markdown: text, csv: csv(&all), figure: Some(Figure::Svg(svg(&panels))) })
}

/// The forms in two groups, one a schedule.
fn bars(title: &str, figure: &str, rows: &[Measured]) -> Panel {
    let value = |i: usize| rows[i].spread(figure).map(|found| (found.mean, found.inputs.unwrap_or(0.0)));
    let of_form = |(f, (form, _)): (usize, &(&str, usize))| Series {
        name: (*form).to_owned(),
        values: (0..2).map(|schedule| value(schedule * FORMS.len() + f)).collect(),
    };
    Panel {
        title: title.to_owned(),
        across: Across::Names(vec!["paper".into(), "ours".into()]),
        series: FORMS.iter().enumerate().map(of_form).collect(),
        logarithmic: false,
    }
}
