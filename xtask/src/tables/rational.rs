//! The exact, rational image of a wire against projected control points, from the bench that draws both.

use super::chart::{Across, Panel, Series, svg};
use super::runs::Runs;
use super::{Figure, Page, Result};
use crate::shell;

/// Pieces a span of the bench's linearised rows.
const PIECES: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 16.0];

pub fn make(_: &mut Runs) -> Result<Page> {
    let file = shell::root().join("out/tables/rational.csv");
    std::fs::create_dir_all(file.parent().ok_or("no folder for the table")?)?;
    shell::run(shell::command("cargo").args(["bench", "--bench", "rational", "--"]).arg(&file))?;
    let csv = std::fs::read_to_string(&file)?;
    let rows = Rows::parse(&csv)?;
    let text = format!(
        "# Rational or linearised\n\n\
         The perspective image of a cubic Bézier is a rational curve. `rational, bounded` draws it with chords that are \
         within 0.002 px by a bound on its curvature, each a tapered stroke with exact coverage; its coverage error here is \
         the difference from counting 16 x 16 samples a pixel over the same chords: what the rasteriser itself is off. `rational, 16 points` projects 16 exact points a span, as our fits do \
         (with fewer points), against the same count. `linearised xN` is the paper's way: N Bézier pieces a span, control points projected and \
         taken for a plane cubic. Errors in px are of centres at equal parameters, 512 px; coverage errors are against \
         `rational, bounded` over pixels that are covered in part, for linearised curves drawn as finely as the reference, \
         so that nothing but the projection differs. Times are the least of 40 on one thread (the reference's vertices: one time, meant to be slow): from control points to 16 points a \
         span, the adjoint of that, and drawing forward and backward; the last column divides their sum by that of \
         `rational, 16 points`. Wires are short tours of points in a ball. `cargo bench --bench rational` makes the table.\n\n{}\n\
         ![Largest distance and coverage error over pieces a span](rational.svg)\n",
        rows.markdown(),
    );
    let panel = |title: &str, column: &str| Panel {
        title: title.to_owned(),
        across: Across::Numbers(PIECES.to_vec(), "Bézier pieces a span"),
        series: rows
            .scenes()
            .into_iter()
            .filter(|(_, points)| points == "210")
            .map(|(camera, points)| Series {
                name: camera.clone(),
                values: PIECES
                    .iter()
                    .map(|pieces| rows.value(&camera, &points, &format!("linearised x{pieces}"), column))
                    .map(|value| value.map(|value| (value, 0.0)))
                    .collect(),
            })
            .collect(),
        logarithmic: true,
    };
    let figure = svg(&[
        panel("210 points: largest error, px of 512", "largest_px"),
        panel("210 points: coverage, edge rms, of 1", "edge_rms"),
    ]);
    Ok(Page { markdown: text, csv, figure: Some(Figure::Svg(figure)) })
}

/// The bench's table.
struct Rows {
    headings: Vec<String>,
    cells: Vec<Vec<String>>,
}

impl Rows {
    fn parse(csv: &str) -> Result<Rows> {
        let mut lines = csv.lines().map(split);
        let headings = lines.next().ok_or("the bench rational wrote nothing")?;
        let cells: Vec<Vec<String>> = lines.collect();
        if cells.is_empty() || cells.iter().any(|row| row.len() != headings.len()) {
            return Err("the bench rational wrote no table".into());
        }
        Ok(Rows { headings, cells })
    }

    fn cell<'a>(&self, row: &'a [String], column: &str) -> &'a str {
        self.headings.iter().position(|heading| heading == column).map_or("", |at| &row[at])
    }

    /// Camera and number of control points, in order.
    fn scenes(&self) -> Vec<(String, String)> {
        let mut scenes: Vec<(String, String)> = Vec::new();
        for row in &self.cells {
            let scene = (self.cell(row, "camera").to_owned(), self.cell(row, "control_points").to_owned());
            if !scenes.contains(&scene) {
                scenes.push(scene);
            }
        }
        scenes
    }

    fn value(&self, camera: &str, points: &str, route: &str, column: &str) -> Option<f64> {
        let is_it = |row: &&Vec<String>| {
            [("camera", camera), ("control_points", points), ("route", route)]
                .iter()
                .all(|&(c, v)| self.cell(row, c) == v)
        };
        self.cell(self.cells.iter().find(is_it)?, column).parse().ok().filter(|value: &f64| value.is_finite())
    }

    fn markdown(&self) -> String {
        let mut text = String::from(
            "| camera | points | route | vertices | largest, px | mean, px | coverage, edge rms | largest | vertices, µs | adjoint, µs | drawing, ms | times `16 points` |\n\
             |---|---|---|---|---|---|---|---|---|---|---|---|\n",
        );
        for row in &self.cells {
            let [camera, points, route] = ["camera", "control_points", "route"].map(|c| self.cell(row, c));
            let total = |route: &str| {
                let [vertices, adjoint, raster] = ["vertices_us", "adjoint_us", "raster_ms"]
                    .map(|column| self.value(camera, points, route, column).unwrap_or(0.0));
                (vertices + adjoint) / 1e3 + raster
            };
            let ratio = total(route) / total("rational, 16 points");
            let cells: Vec<&str> = row.iter().map(|cell| if cell == "NaN" { "–" } else { cell }).collect();
            text += &format!("| {} | {ratio:.2} |\n", cells.join(" | "));
        }
        text
    }
}

/// Cells of a line; quoted ones may hold commas.
fn split(line: &str) -> Vec<String> {
    let (mut cells, mut quoted) = (vec![String::new()], false);
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            _ => cells.last_mut().expect("one from the start").push(c),
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_to_exact_points_of_the_same_scene() {
        let csv = "camera,control_points,route,vertices_us,adjoint_us,raster_ms\n\
                   near,10,\"rational, 16 points\",500,500,1\nnear,10,linearised x1,1000,1000,1\n";
        let rows = Rows::parse(csv).unwrap();
        assert_eq!(rows.scenes(), [("near".to_owned(), "10".to_owned())]);
        assert_eq!(rows.value("near", "10", "linearised x1", "adjoint_us"), Some(1000.0));
        assert!(rows.markdown().lines().last().unwrap().ends_with("| 1.50 |"));
        assert!(Rows::parse("a,b\n1\n").is_err());
    }
}
