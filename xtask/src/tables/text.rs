//! Runs as Markdown (means and spreads) and as CSV (every run).

use super::runs::{Case, Figures, Runs};
use super::stats::{Spread, spread};
use crate::Result;
use std::fmt::Write;

/// One line of a table: a way to run, over some inputs and seeds.
pub struct Row {
    pub name: String,
    pub options: Vec<String>,
    pub seeds: Vec<u64>,
}

/// A column: the figure's name, its heading, digits after the point.
pub type Column = (&'static str, &'static str, usize);

/// What most tables show.
pub const COLUMNS: &[Column] = &[
    ("soft_iou", "soft IoU", 3),
    ("precision_2px", "precision, 2 px", 3),
    ("recall_2px", "recall, 2 px", 3),
    ("ms_ssim", "MS-SSIM", 3),
    ("edge_distance_px", "edge distance, px", 2),
    ("feature_distance", "feature distance", 3),
    ("components", "components", 1),
    ("connectivity_cost", "connectivity cost", 2),
    ("length", "length", 1),
    ("jerk", "jerk", 1),
    ("corners", "corners", 0),
    ("seconds", "seconds", 1),
];

/// A row with the figures of all its runs, `runs[input][seed]`.
pub struct Measured {
    pub name: String,
    inputs: Vec<String>,
    seeds: Vec<u64>,
    runs: Vec<Vec<Figures>>,
}

impl Measured {
    /// Runs a row.
    pub fn new(row: &Row, inputs: &[&str], runs: &mut Runs) -> Result<Measured> {
        let mut of_inputs = Vec::new();
        for input in inputs {
            let of_seed =
                |&seed: &u64| runs.figures(&Case { input: (*input).to_owned(), seed, options: row.options.clone() });
            of_inputs.push(row.seeds.iter().map(of_seed).collect::<Result<Vec<_>>>()?);
        }
        Ok(Measured {
            name: row.name.clone(),
            inputs: inputs.iter().map(|&input| input.to_owned()).collect(),
            seeds: row.seeds.clone(),
            runs: of_inputs,
        })
    }

    /// Mean and spreads of a figure; `None` where a report has none.
    pub fn spread(&self, figure: &str) -> Option<Spread> {
        let of_input = |seeds: &Vec<Figures>| seeds.iter().filter_map(|run| run.get(figure).copied()).collect();
        spread(&self.runs.iter().map(of_input).collect::<Vec<Vec<f64>>>())
    }

    /// The value of a figure that must be the same in every run.
    pub fn constant(&self, figure: &str) -> Option<f64> {
        let mut values = self.runs.iter().flatten().map(|run| run.get(figure).copied());
        let first = values.next()??;
        values.all(|value| value == Some(first)).then_some(first)
    }
}

/// A Markdown table of means, each with its deviation over seeds and over inputs. A column that no run has a figure for is
/// left out.
pub fn markdown(rows: &[Measured], columns: &[Column]) -> String {
    let known = |&&(figure, ..): &&Column| rows.iter().any(|row| row.spread(figure).is_some());
    let columns: Vec<&Column> = columns.iter().filter(known).collect();
    let mut text = String::from("| |");
    columns.iter().for_each(|(_, heading, _)| text += &format!(" {heading} |"));
    text += "\n|---|";
    columns.iter().for_each(|_| text += "---|");
    text.push('\n');
    for row in rows {
        let _ = write!(text, "| {} |", row.name);
        for &&(figure, _, digits) in &columns {
            let cell = row.spread(figure).map_or("–".to_owned(), |found| {
                let part = |deviation: Option<f64>| deviation.map_or("–".into(), |value| format!("{value:.digits$}"));
                match (found.seeds, found.inputs) {
                    (None, None) => format!("{:.digits$}", found.mean),
                    (seeds, inputs) => format!("{:.digits$} ± {} / {}", found.mean, part(seeds), part(inputs)),
                }
            });
            let _ = write!(text, " {cell} |");
        }
        text.push('\n');
    }
    text
}

/// What the cells of [`markdown`] mean.
pub const CELLS: &str = "Cells: mean ± standard deviation over seeds (pooled) / over inputs; – where there is one.";

/// Every run, a line each, with every figure.
pub fn csv(rows: &[Measured]) -> String {
    let mut names: Vec<&String> =
        rows.iter().flat_map(|row| row.runs.iter().flatten().flat_map(Figures::keys)).collect();
    names.sort();
    names.dedup();
    let mut text = format!("row,input,seed,{}\n", names.iter().map(|name| name.as_str()).collect::<Vec<_>>().join(","));
    for row in rows {
        for (input, seeds) in row.inputs.iter().zip(&row.runs) {
            for (seed, run) in row.seeds.iter().zip(seeds) {
                let _ = write!(text, "{},{input},{seed}", field(&row.name));
                for name in &names {
                    let _ = write!(text, ",{}", run.get(*name).map_or(String::new(), f64::to_string));
                }
                text.push('\n');
            }
        }
    }
    text
}

fn field(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured() -> Measured {
        let run = |value: f64| Figures::from([("soft_iou".to_owned(), value)]);
        Measured {
            name: "one, \"two\"".into(),
            inputs: vec!["a".into(), "b".into()],
            seeds: vec![0, 1],
            runs: vec![vec![run(0.1), run(0.3)], vec![run(0.5), run(0.7)]],
        }
    }

    #[test]
    fn cells_have_mean_and_both_spreads() {
        let mut with_jerk = measured();
        with_jerk.runs.iter_mut().flatten().for_each(|run| _ = run.insert("jerk".into(), 2.0));
        // Nobody has a figure for the last one.
        let columns = [("soft_iou", "soft IoU", 2), ("jerk", "jerk", 1), ("feature_distance", "feature distance", 3)];
        let text = markdown(&[measured(), with_jerk], &columns);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "| | soft IoU | jerk |");
        assert_eq!(lines[2], "| one, \"two\" | 0.40 ± 0.14 / 0.28 | – |");
        assert!(lines.iter().all(|line| line.matches('|').count() == 4));
    }

    #[test]
    fn every_run_is_a_line() {
        let text = csv(&[measured()]);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!((lines[0], lines.len()), ("row,input,seed,soft_iou", 5));
        assert_eq!(lines[4], "\"one, \"\"two\"\"\",b,1,0.7");
        assert_eq!(measured().constant("soft_iou"), None);
    }
}
