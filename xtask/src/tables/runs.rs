//! Runs of the release binary and the figures of their reports. A run that two tables need is done once.

use crate::{Result, shell};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use wire4d_core::wire::Wire;

/// Where a network lies, for whoever has one, whose likeness is measured too; tools/guidance makes it.
const YARDSTICK: &str = "out/efficientnet-lite0.onnx";

/// How much to run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Size {
    Full,
    Quick,
}

/// What every multi-view run of every table has, so that all are compared with one target: arranged, thickened to 4 px of
/// 256, never bent.
pub const COMMON: &[&str] = &["--bend", "none", "--arrange", "on", "--min-stroke", "4", "--backend", "cpu"];

/// One run: a verb's input, a seed and options.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Case {
    /// A folder of tests/drawings, or a picture of tests/strokes.
    pub input: String,
    pub seed: u64,
    pub options: Vec<String>,
}

/// Figures of a report by name; those of pictures are means over the views.
pub type Figures = BTreeMap<String, f64>;

pub struct Runs {
    pub size: Size,
    done: BTreeMap<Case, (Figures, Wire)>,
}

impl Runs {
    pub fn new(size: Size) -> Runs {
        Runs { size, done: BTreeMap::new() }
    }

    /// Folders of tests/drawings: a triple of outlines, one of icons, a pair.
    pub fn drawings(&self) -> &'static [&'static str] {
        match self.size {
            Size::Full => &["t01-animals", "t06-icons", "p02-garden"],
            Size::Quick => &["t06-icons"],
        }
    }

    /// Folders of tests/drawings for how a wire runs: two pairs and two triples of lines.
    pub fn lines(&self) -> &'static [&'static str] {
        match self.size {
            Size::Full => &["p02-garden", "p03-faces", "t01-animals", "t03-vehicles"],
            Size::Quick => &["p03-faces"],
        }
    }

    /// Pictures of tests/strokes.
    pub fn pictures(&self) -> &'static [&'static str] {
        match self.size {
            Size::Full => &["fish", "vase"],
            Size::Quick => &["cat"],
        }
    }

    /// Seeds of runs that begin at random.
    pub fn seeds(&self) -> &'static [u64] {
        match self.size {
            Size::Full => &[0, 1, 2],
            Size::Quick => &[0],
        }
    }

    /// What was run, for a page.
    pub fn said(&self, inputs: &[&str]) -> String {
        format!("Inputs: {}. Seeds where a run begins at random: {:?}.", inputs.join(", "), self.seeds())
    }

    /// The figures of one run.
    pub fn figures(&mut self, case: &Case) -> Result<Figures> {
        Ok(self.made(case)?.0.clone())
    }

    /// The wire of one run.
    pub fn wire(&mut self, case: &Case) -> Result<&Wire> {
        Ok(&self.made(case)?.1)
    }

    fn made(&mut self, case: &Case) -> Result<&(Figures, Wire)> {
        if !self.done.contains_key(case) {
            let made = self.run(case)?;
            self.done.insert(case.clone(), made);
        }
        Ok(&self.done[case])
    }

    fn run(&self, case: &Case) -> Result<(Figures, Wire)> {
        let root = shell::root();
        // Two of these may run side by side.
        let out = root.join(format!("out/tables/made-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&out);
        std::fs::create_dir_all(root.join("out/tables"))?;
        let (verb, pictures) = pictures(&root, &case.input);
        let mut command = shell::command("target/release/wire4d");
        command.arg(verb).args(&pictures).args(["--quiet", "--seed", &case.seed.to_string(), "--out"]).arg(&out);
        let yardstick = root.join(YARDSTICK);
        if yardstick.is_file() {
            command.arg("--perceptual").arg(yardstick);
        }
        let output = command.args(&case.options).output()?;
        if !output.status.success() {
            return Err(format!("{case:?}: {}", String::from_utf8_lossy(&output.stderr).trim()).into());
        }
        let read = |name: &str| -> Result<Value> { Ok(serde_json::from_slice(&std::fs::read(out.join(name))?)?) };
        let wire = read("wire.json")?;
        let figures = figures(&read("report.json")?, &wire);
        shell::say(format!(
            "{} {} seed {}: soft IoU {:.3}, {} components, {:.1} s",
            case.input,
            case.options.join(" "),
            case.seed,
            figures["soft_iou"],
            figures["components"],
            figures["seconds"],
        ));
        let _ = std::fs::remove_dir_all(&out);
        Ok((figures, serde_json::from_value(wire)?))
    }
}

fn pictures(root: &Path, input: &str) -> (&'static str, Vec<PathBuf>) {
    let single = root.join("tests/strokes").join(format!("{input}.png"));
    if single.is_file() {
        return ("stroke", vec![single]);
    }
    let folder = root.join("tests/drawings").join(input);
    let views = ["front", "side", "top"].map(|view| folder.join(format!("{view}.png")));
    ("multiview", views.into_iter().filter(|path| path.is_file()).collect())
}

/// Figures of pictures that are means over the views: every view of several drawings, the front of a single picture.
const OF_VIEWS: &[&str] =
    &["soft_iou", "precision_2px", "recall_2px", "ms_ssim", "edge_distance_px", "tone_match", "feature_distance"];
const OF_WIRE: &[&str] = &[
    "components",
    "connectivity_cost",
    "length",
    "jerk",
    "control_points",
    "min_width",
    "kinks",
    "tight_share",
    "touching_share",
    "penetrating_share",
    "turning_per_unit",
    "length_over_lines",
];

fn figures(report: &Value, wire: &Value) -> Figures {
    let mut figures = Figures::new();
    let mut add = |name: &str, value: Option<f64>| {
        figures.extend(value.map(|value| (name.to_owned(), value)));
    };
    let views = report["result"]["views"].as_array().map_or(&[][..], Vec::as_slice);
    let shown = if report["task"] == "stroke" { &views[..views.len().min(1)] } else { views };
    for name in OF_VIEWS {
        let values: Vec<f64> = shown.iter().filter_map(|view| view[name].as_f64()).collect();
        add(name, super::stats::mean(&values));
    }
    if report["task"] == "stroke" {
        for name in ["precision_2px", "recall_2px"] {
            let values: Vec<f64> = views.iter().skip(1).filter_map(|view| view[name].as_f64()).collect();
            add(&format!("side_{name}"), super::stats::mean(&values));
        }
    }
    for name in OF_WIRE {
        add(name, report["result"][name].as_f64());
    }
    add("seconds", report["time"]["total_s"].as_f64());
    for kind in ["reinit", "refine"] {
        let events = report["events"].as_array().map_or(&[][..], Vec::as_slice);
        let counts = events.iter().filter(|event| event["kind"] == kind).filter_map(|event| event["count"].as_f64());
        // The empty sum is -0.
        add(kind, Some(counts.sum::<f64>() + 0.0));
    }
    add("corners", Some(corners(wire) as f64));
    figures
}

/// Where the wire's direction turns by more than this at once, a person sees a corner.
const CORNER_COSINE: f64 = 0.866;

/// Joints of Bézier segments at which the direction turns by more than 30 degrees. A spline has none; a bag's segments are
/// not joined.
fn corners(wire: &Value) -> usize {
    let numbers = |value: &Value| value.as_array().into_iter().flatten().filter_map(Value::as_f64).collect::<Vec<_>>();
    let (knots, closed) = (numbers(&wire["knots"]), wire["closed"] == true);
    let points: Vec<Vec<f64>> = wire["control_points"].as_array().into_iter().flatten().map(numbers).collect();
    // In a chain interior knots come three at a time, and control points of joints lie under them.
    let joints = (3..points.len().saturating_sub(1)).filter(|&i| {
        i + 4 < knots.len()
            && !closed
            && knots[i] < knots[i + 1]
            && knots[i + 1] == knots[i + 3]
            && knots[i + 3] < knots[i + 4]
    });
    let turns = |i: usize| {
        let side = |a: usize, b: usize| [0, 1, 2].map(|c| points[b][c] - points[a][c]);
        let (before, after) = (side(i - 1, i), side(i, i + 1));
        let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|c| a[c] * b[c]).sum::<f64>();
        dot(before, after) < CORNER_COSINE * (dot(before, before) * dot(after, after)).sqrt()
    };
    joints.filter(|&i| turns(i)).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn figures_are_means_over_views_and_of_the_front_alone_for_one_picture() {
        let mut report = json!({
            "task": "multiview", "time": { "total_s": 2.0 },
            "result": { "views": [{ "soft_iou": 0.5 }, { "soft_iou": 0.7 }], "components": 3 },
            "events": [{ "kind": "refine", "count": 7 }, { "kind": "refine", "count": 2 }, { "kind": "done", "count": 1 }],
        });
        let found = figures(&report, &Value::Null);
        assert!((found["soft_iou"] - 0.6).abs() < 1e-12);
        assert_eq!((found["components"], found["refine"], found["reinit"], found["seconds"]), (3.0, 9.0, 0.0, 2.0));
        report["task"] = "stroke".into();
        report["result"]["views"][1]["recall_2px"] = 0.9.into();
        let found = figures(&report, &Value::Null);
        assert_eq!((found["soft_iou"], found["side_recall_2px"]), (0.5, 0.9));
    }

    #[test]
    fn corners_are_sharp_joints_of_a_chain() {
        // Two segments along x, then along y or on along x.
        let chain = |end: [[f64; 4]; 3]| {
            let mut points = vec![[0.0; 4], [1.0, 0.0, 0.0, 0.0], [2.0, 0.0, 0.0, 0.0], [3.0, 0.0, 0.0, 0.0]];
            points.extend(end);
            json!({ "closed": false, "knots": [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2], "control_points": points })
        };
        let up = chain([[3.0, 1.0, 0.0, 0.0], [3.0, 2.0, 0.0, 0.0], [3.0, 3.0, 0.0, 0.0]]);
        let on = chain([[4.0, 0.1, 0.0, 0.0], [5.0, 0.0, 0.0, 0.0], [6.0, 0.0, 0.0, 0.0]]);
        assert_eq!((corners(&up), corners(&on)), (1, 0));
        let mut spline = up.clone();
        spline["knots"] = json!([0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]);
        assert_eq!(corners(&spline), 0);
        let mut bag = up;
        bag["knots"] = json!([0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2]);
        assert_eq!(corners(&bag), 0);
    }
}
