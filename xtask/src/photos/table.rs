//! The figures of photographs and their wires as a Markdown table.

use super::sheet::read;
use crate::Result;
use serde_json::Value;
use std::path::PathBuf;

/// A column: where the figure is, its heading, what it is multiplied by, digits after the point.
type Column = (&'static str, &'static str, f64, usize);

/// `lines` are those of the cut, `true lines` those of the true mask.
const COLUMNS: [Column; 25] = [
    ("/sure", "sure", 1.0, 2),
    ("/truth/cut_iou", "cut IoU", 1.0, 3),
    ("/truth/lines_of_truth/0", "true lines P", 1.0, 2),
    ("/truth/lines_of_truth/1", "R", 1.0, 2),
    ("/truth/lines_of_truth/2", "outline", 1.0, 2),
    ("/truth/lines_of_cut/0", "lines P", 1.0, 2),
    ("/truth/lines_of_cut/1", "R", 1.0, 2),
    ("/truth/lines_of_cut/2", "outline", 1.0, 2),
    ("/wire_precision", "wire P", 1.0, 3),
    ("/wire_recall", "R", 1.0, 3),
    ("/components", "pieces", 1.0, 0),
    ("/kinks", "kinks", 1.0, 0),
    ("/tight_share", "tight, %", 100.0, 1),
    ("/touching_share", "touching, %", 100.0, 1),
    ("/length_over_lines", "length / lines", 1.0, 2),
    ("/turned_precision", "turned P", 1.0, 3),
    ("/turned_rim_recall", "rim R", 1.0, 3),
    ("/seconds/cut", "cut s", 1.0, 2),
    ("/seconds/lines", "lines", 1.0, 2),
    ("/seconds/start", "start", 1.0, 2),
    ("/seconds/fit", "fit", 1.0, 2),
    ("/seconds/total", "total", 1.0, 2),
    ("/seconds_fast/start", "fast: start", 1.0, 2),
    ("/seconds_fast/fit", "fit", 1.0, 2),
    ("/seconds_fast/total", "total", 1.0, 2),
];

/// A line a photograph, and their means.
pub fn markdown(made: &[PathBuf]) -> Result<String> {
    let found = made.iter().map(|folder| read(&folder.join("figures.json"))).collect::<Result<Vec<Value>>>()?;
    let mut text = String::from(
        "P is precision and R recall, within 2 px at 256. Lines: against contours, creases and painted borders. Wire: \
         against the lines. Turned: the wire's ink in the solid's silhouette and that one's rim near the ink, from 35 \
         degrees. Seconds: the solid and the first wire are the start.\n\n| |",
    );
    text += &COLUMNS.map(|(_, heading, ..)| format!(" {heading} |")).concat();
    text += &format!("\n|---|{}\n", "---|".repeat(COLUMNS.len()));
    for figures in &found {
        text += &line(figures["name"].as_str().unwrap_or("?"), &[figures]);
    }
    text += &line("**mean**", &found.iter().collect::<Vec<_>>());
    for note in found.iter().filter_map(|figures| figures["notes"].as_array()).flatten().filter_map(Value::as_str) {
        text += &format!("\n- {note}");
    }
    Ok(text + "\n")
}

/// Means over some photographs; a dash where there is nothing to tell.
fn line(name: &str, some: &[&Value]) -> String {
    let cell = |(place, _, factor, digits): Column| {
        let values: Vec<f64> = some.iter().filter_map(|figures| figures.pointer(place)?.as_f64()).collect();
        let digits = if some.len() > 1 { digits.max(1) } else { digits };
        match values.len() {
            0 => " – |".to_owned(),
            count => format!(" {:.digits$} |", factor * values.iter().sum::<f64>() / count as f64),
        }
    };
    format!("| {name} |{}\n", COLUMNS.map(cell).concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn every_heading_has_a_cell_and_what_is_unknown_is_a_dash() {
        let one = json!({ "truth": null, "kinks": 3, "tight_share": 0.25, "seconds": { "fit": 1.5 } });
        let two = json!({ "truth": { "lines_of_cut": [0.5, 0.25, 1.0] }, "kinks": 2 });
        assert!(line("one", &[&one]).contains(" – | 3 | 25.0 | – |"));
        let mean = line("mean", &[&one, &two]);
        assert!(
            mean.contains(" 0.50 | 0.25 | 1.00 |") && mean.contains(" 2.5 |") && mean.contains(" 1.50 |"),
            "{mean}"
        );
        assert_eq!(mean.matches('|').count(), COLUMNS.len() + 2);
    }
}
