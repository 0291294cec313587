//! The paper's error figure, from the bench that draws it.

use super::runs::Runs;
use super::{Figure, Page, Result};
use crate::shell;

pub fn make(_: &mut Runs) -> Result<Page> {
    let figure = shell::root().join("out/tables/projection.svg");
    std::fs::create_dir_all(figure.parent().ok_or("no folder for the figure")?)?;
    let mut command = shell::command("cargo");
    command.args(["bench", "--bench", "projection_error", "--"]).arg(&figure);
    let printed = shell::output(&mut command).ok_or("the bench projection_error failed")?;
    let rows = numbers(&printed);
    if rows.is_empty() {
        return Err("the bench projection_error printed no table".into());
    }
    let headings = ["pieces a span", "bound, px", "largest, px", "mean, px", "as drawn, px", "by arc length"];
    let mut table = format!("| {} |\n|{}\n", headings.join(" | "), "---|".repeat(headings.len()));
    rows.iter().for_each(|row| table += &format!("| {} |\n", row.join(" | ")));
    let text = format!(
        "# Projecting control points\n\n\
         How far a plane cubic through projected Bézier control points is from the perspective image of the curve, 512 px, \
         20° at 3.8 radii: three wires of 100 points of a short tour through a ball, four cameras each. `bound` is \
         ¼ diam(p) Δz / z_min; `as drawn` is the distance square to the curve; `by arc length` is the paper's measure, both \
         curves resampled by length, mean distance over the diagonal of the picture's box. Drawn by \
         `cargo bench --bench projection_error`.\n\n{table}\n![Error over pieces a span, both logarithmic](projection.svg)\n"
    );
    let lines = rows.iter().map(|row| row.join(",") + "\n");
    let csv = format!("pieces,bound_px,largest_px,mean_px,drawn_px,by_arc_length\n{}", lines.collect::<String>());
    Ok(Page { markdown: text, csv, figure: Some(Figure::Svg(std::fs::read_to_string(&figure)?)) })
}

/// The lines of six numbers.
fn numbers(printed: &str) -> Vec<Vec<String>> {
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    let is_row = |row: &Vec<String>| row.len() == 6 && row.iter().all(|word| word.parse::<f64>().is_ok());
    printed.lines().map(words).filter(is_row).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn only_lines_of_numbers_are_rows() {
        let printed = "pieces  bound px  largest\n     1  2.0  1.0 0.5 0.25 1.00e-4\n  warning: 1 2 3 4 5\n";
        assert_eq!(super::numbers(printed), [["1", "2.0", "1.0", "0.5", "0.25", "1.00e-4"]]);
    }
}
