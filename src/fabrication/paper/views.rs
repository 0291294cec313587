//! Front, side and top at true size, in tiles that are glued together.

use super::Paper;
use super::document::Document;
use super::sheet::{Ink, Pen, Sheet};
use crate::Centreline;
use crate::seen::{Run, Side, runs, thinned};
use glam::DVec2;

/// Beyond so many sheets nobody glues.
pub const MOST_SHEETS: usize = 90;
/// What printers leave blank, mm.
pub const MARGIN: f64 = 12.0;
/// For the ruler and what the sheet is.
const FOOT: f64 = 18.0;
/// Neighbouring tiles show the same here, mm.
const OVERLAP: f64 = 10.0;
/// Round the wire, for the numbers, mm.
const ROOM: f64 = 8.0;
/// Numbered points, mm apart.
const POINTS_MM: f64 = 50.0;
/// Numbers nearer than this, across and up, lie over each other, mm.
const NUMBER: DVec2 = DVec2::new(3.6, 2.4);
/// How far lines may be off, mm.
const TOLERANCE: f64 = 0.02;

/// The wire from a side.
pub struct View<'a> {
    line: &'a Centreline,
    name: &'static str,
    side: Side,
    runs: Vec<Run>,
    low: DVec2,
    high: DVec2,
}

/// The three sides.
pub fn views(line: &Centreline) -> [View<'_>; 3] {
    [("Front", Side::FRONT), ("Side", Side::SIDE), ("Top", Side::TOP)].map(|(name, side)| {
        let all = [0, line.steps()];
        let runs = runs(line, side, all, all, 1);
        let places = || runs.iter().flat_map(|run| &run.places).copied();
        let low = places().reduce(DVec2::min).unwrap_or_default() - ROOM;
        let high = places().reduce(DVec2::max).unwrap_or_default() + ROOM;
        View { line, name, side, runs, low, high }
    })
}

/// A sheet's part of a view.
pub struct Tile {
    column: usize,
    row: usize,
    /// Where its lower left corner is in the view, mm.
    low: DVec2,
}

/// The window for drawings on a sheet: its corners.
fn window(paper: Paper) -> [DVec2; 2] {
    [DVec2::new(MARGIN, MARGIN + FOOT), paper.size() - MARGIN]
}

impl View<'_> {
    /// The sheets that something of the wire is on, row by row from above.
    pub fn tiles(&self, paper: Paper) -> Vec<Tile> {
        let [low, high] = window(paper);
        let step = high - low - OVERLAP;
        let count = ((self.high - self.low - OVERLAP) / step).ceil().max(DVec2::ONE);
        // In the middle of its sheets.
        let corner = 0.5 * (self.low + self.high - count * step - OVERLAP);
        let (columns, rows) = (count.x as usize, count.y as usize);
        let tiles = (0..rows * columns).map(|i| (i / columns, i % columns)).map(|(row, column)| Tile {
            column,
            row,
            low: corner + step * DVec2::new(column as f64, (rows - 1 - row) as f64),
        });
        let holds = |tile: &Tile| {
            let inside =
                |at: &DVec2| (*at - tile.low).cmpge(DVec2::ZERO).all() && (tile.low + step + OVERLAP).cmpge(*at).all();
            self.runs.iter().flat_map(|run| &run.places).any(inside)
        };
        tiles.filter(holds).collect()
    }

    /// Adds its sheets.
    pub fn draw(&self, document: &mut Document) {
        let drawing = document.drawing(self.drawing(), self.low, self.high);
        let paper = document.paper;
        let tiles = self.tiles(paper);
        for (i, tile) in tiles.iter().enumerate() {
            let mut sheet = Sheet::new();
            let [low, high] = window(paper);
            sheet.show(drawing, [low, high], low - tile.low);
            let name = format!("{}, true size: sheet {} ({} of {})", self.name, tile.label(), i + 1, tiles.len());
            sheet.heading(DVec2::new(MARGIN, MARGIN + 9.5), 4.2, &name);
            let about = "Dashed: behind another strand. Numbers: every 50 mm from the start.";
            sheet.text(DVec2::new(MARGIN + 84.0, MARGIN + 9.5), 2.8, about);
            sheet.ruler(DVec2::new(MARGIN, MARGIN + 2.0));
            if tiles.len() > 1 {
                marks(&mut sheet, [low, high]);
            }
            document.page(sheet);
        }
    }

    fn drawing(&self) -> Sheet {
        let mut sheet = Sheet::new();
        let gauge = self.line.gauge_mm();
        let edge = (0.25 * gauge).min(0.2);
        let lines = |hidden: bool| {
            let runs = self.runs.iter().filter(move |run| run.hidden == hidden);
            runs.map(|run| thinned(&run.places, TOLERANCE)).collect::<Vec<_>>()
        };
        let (seen, hidden) = (lines(false), lines(true));
        let band = [Pen::new(gauge, Ink::Grey(0.45)), Pen::new(gauge - 2.0 * edge, Ink::Grey(0.88))];
        let middle = Pen::new((0.3 * gauge).min(0.25), Ink::Grey(0.0));
        // What is hidden lies below, but its middle is to be seen.
        let layers = [(&hidden, band[0]), (&hidden, band[1]), (&seen, band[0]), (&seen, band[1]), (&seen, middle)];
        for (lines, pen) in layers.into_iter().chain([(&hidden, middle.dashed(0.7))]) {
            for line in lines {
                sheet.line(line, pen);
            }
        }
        let mut numbers: Vec<DVec2> = Vec::new();
        let count = (self.line.length_mm() / POINTS_MM) as usize;
        for number in 0..=count {
            let i = (number as f64 * POINTS_MM / self.line.step_mm()).round() as usize;
            let [at, next] = [i, i + 1].map(|i| self.side.project(self.line.point(i)).0);
            sheet.dot(at, 0.6);
            // Beside the wire.
            let aside = (next - at).perp().try_normalize().unwrap_or(DVec2::Y) * (0.5 * gauge + 1.6);
            let beside = at + aside - DVec2::new(1.2, 0.8);
            // A number over another would be no number.
            if numbers.iter().all(|other| ((*other - beside) / NUMBER).length() > 1.0) {
                sheet.text(beside, 2.4, &number.to_string());
                numbers.push(beside);
            }
        }
        sheet
    }
}

impl Tile {
    /// Columns are letters, rows numbers.
    fn label(&self) -> String {
        let letter = char::from(b'A' + (self.column % 26) as u8);
        format!("{letter}{}", self.row + 1)
    }
}

/// Lines where neighbouring sheets overlap, at the borders of the window, and crosses where they must lie on each other.
fn marks(sheet: &mut Sheet, [low, high]: [DVec2; 2]) {
    let pen = Pen::new(0.15, Ink::Grey(0.4));
    sheet.line(&[low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y), low], Pen::new(0.1, Ink::Grey(0.7)));
    let [inner_low, inner_high] = [low + 0.5 * OVERLAP, high - 0.5 * OVERLAP];
    for x in [inner_low.x, inner_high.x] {
        for y in [inner_low.y, inner_high.y] {
            let at = DVec2::new(x, y);
            sheet.line(&[at - DVec2::X * 4.0, at + DVec2::X * 4.0], pen);
            sheet.line(&[at - DVec2::Y * 4.0, at + DVec2::Y * 4.0], pen);
        }
    }
}
