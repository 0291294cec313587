//! How a wire runs, as columns of a table: figures of its report and the length of its share code.

use crate::shell::{output, root};
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// A column: the figure's name in a report's result, its heading, what a value is multiplied by, digits after the point.
type Column = (&'static str, &'static str, f64, usize);

const COLUMNS: [Column; 8] = [
    ("kinks", "kinks", 1.0, 1),
    ("tight_share", "tight, %", 100.0, 1),
    ("touching_share", "touching, %", 100.0, 1),
    ("penetrating_share", "penetrating, %", 100.0, 1),
    ("turning_per_unit", "turning", 1.0, 1),
    ("length_over_lines", "length / lines", 1.0, 2),
    ("control_points", "points", 1.0, 0),
    (CODE, "code, characters", 1.0, 0),
];
/// The one that is not in the report.
const CODE: &str = "code";

/// A wire's figures in the order of the columns; `None` where the report lacks one.
#[derive(Debug, Clone, PartialEq)]
pub struct Figures([Option<f64>; COLUMNS.len()]);

impl Figures {
    /// Of the run whose files lie in `out`, with its report.
    pub fn of(report: &Value, out: &Path) -> Figures {
        let code =
            || output(Command::new(root().join("target/release/wire4d")).arg("share").arg(out.join("wire.json")));
        Figures(COLUMNS.map(|(name, ..)| match name {
            CODE => code().map(|code| code.len() as f64),
            _ => report["result"][name].as_f64(),
        }))
    }
}

/// The headings as cells of a Markdown line, each with a bar after it.
pub fn headings() -> String {
    COLUMNS.map(|(_, heading, ..)| format!(" {heading} |")).concat()
}

/// The line under the headings.
pub fn rule() -> String {
    "---|".repeat(COLUMNS.len())
}

/// Means over some wires as cells; a dash where no report has the figure.
pub fn cells(wires: &[&Figures]) -> String {
    let cell = |k: usize| {
        let (_, _, factor, digits) = COLUMNS[k];
        let values: Vec<f64> = wires.iter().filter_map(|figures| figures.0[k]).collect();
        let digits = if values.len() == 1 && factor == 1.0 && values[0].fract() == 0.0 { 0 } else { digits };
        match values.len() {
            0 => " – |".to_owned(),
            count => format!(" {:.digits$} |", factor * values.iter().sum::<f64>() / count as f64),
        }
    };
    (0..COLUMNS.len()).map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn cells_are_means_of_what_is_there() {
        let of = |result: Value| Figures::of(&json!({ "result": result }), Path::new("nowhere"));
        let one = of(json!({ "kinks": 3, "tight_share": 0.25, "control_points": 200 }));
        let two = of(json!({ "kinks": 2, "length_over_lines": null, "control_points": 300 }));
        assert_eq!(cells(&[&one]), " 3 | 25.0 | – | – | – | – | 200 | – |");
        assert_eq!(cells(&[&one, &two]), " 2.5 | 25.0 | – | – | – | – | 250 | – |");
        assert_eq!(headings().matches('|').count(), rule().matches('|').count());
        assert!(cells(&[]).matches('–').count() == COLUMNS.len());
    }
}
