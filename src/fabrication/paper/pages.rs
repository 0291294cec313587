//! The pages in words and small pictures.

use super::Job;
use super::document::Document;
use super::sheet::{Ink, Pen, Sheet, wrapped};
use super::views::MARGIN;
use crate::list::HEADINGS;
use crate::seen::{Side, runs, thinned};
use crate::steps::{Step, range};
use glam::DVec2;

const TEXT: f64 = 4.0;
const LINE: f64 = 6.0;
/// Of the bend list.
const ROW: f64 = 5.0;
/// Pictures of steps on a page, across and down.
const PICTURES: [usize; 2] = [2, 3];
/// A small picture has no more steps of the line than these.
const MOST_STEPS: usize = 20_000;
/// How far lines of small pictures may be off, mm.
const TOLERANCE: f64 = 0.03;

/// What it is, whether it can be bent, and the ruler. `too_many` sheets are left out.
pub fn cover(document: &mut Document, job: &Job, too_many: Option<usize>) {
    let mut sheet = Sheet::new();
    let size = document.paper.size();
    let mut at = DVec2::new(MARGIN, size.y - MARGIN - 10.0);
    sheet.heading(at, 8.0, job.name);
    at.y -= 14.0;
    let mut say = |sheet: &mut Sheet, words: &str| {
        for line in wrapped(words, TEXT, size.x - 2.0 * MARGIN) {
            sheet.text(at, TEXT, &line);
            at.y -= LINE;
        }
        at.y -= 2.0;
    };
    for sentence in job.check.sentences(job.stock) {
        say(&mut sheet, &sentence);
    }
    let pieces = &job.check.pieces;
    if !pieces.joints_mm.is_empty() {
        const MOST: usize = 24;
        let joints: Vec<String> = pieces.joints_mm.iter().take(MOST).map(|mm| format!("{mm:.0}")).collect();
        let more = if pieces.joints_mm.len() > MOST { " and so on" } else { "" };
        say(&mut sheet, &format!("Join ends at {} mm from the start{more}.", joints.join(", ")));
    }
    say(&mut sheet, &match too_many {
        Some(sheets) => format!("The drawings at true size are left out: they would take {sheets} sheets. A smaller sculpture has them."),
        None => "Next come front, side and top at true size, on sheets that are glued together: crosses lie on crosses. Hold the bent wire against them.".into(),
    });
    say(
        &mut sheet,
        "Then comes the bend list. For each row: go straight, turn the wire about itself (+ is anticlockwise as you look along it), and bend it \
         round a rod of that radius to the last angle; it springs back to the one before.",
    );
    say(
        &mut sheet,
        &format!(
            "Last come {} steps, each seen from its best side: what is new in copper, what is there in grey.",
            job.steps.len()
        ),
    );
    // All of it, below the words.
    let sides = [("Front", Side::FRONT), ("Side", Side::SIDE), ("Top", Side::TOP)];
    let low = DVec2::new(MARGIN, MARGIN + 16.0);
    let room = DVec2::new((size.x - 2.0 * MARGIN) / 3.0 - 4.0, (at.y - low.y - 8.0).min(90.0));
    if room.y > 20.0 {
        let scale = fitting(job, sides.iter().map(|(_, side)| *side), room);
        for (i, (name, side)) in sides.into_iter().enumerate() {
            let corner = low + DVec2::new(i as f64 * (room.x + 6.0), 0.0);
            sheet.text(corner, 3.4, name);
            let all = [0, job.line.steps()];
            let mut drawing = Small::new(&mut sheet, job, side, corner + 0.5 * room + DVec2::Y * 6.0, scale);
            let pen = Pen::new(drawing.width, Ink::Grey(0.25));
            drawing.draw(all, all, [pen, pen]);
        }
    }
    sheet.ruler(DVec2::new(MARGIN, MARGIN + 2.0));
    document.page(sheet);
}

/// The bend list.
pub fn bends(document: &mut Document, job: &Job) {
    let size = document.paper.size();
    let top = size.y - MARGIN - 18.0;
    let rows_a_page = ((top - MARGIN - 10.0) / ROW) as usize;
    let rows: Vec<_> = job.bends.rows(job.stock).collect();
    let width = (size.x - 2.0 * MARGIN) / HEADINGS.len() as f64;
    let pages = rows.len().div_ceil(rows_a_page).max(1);
    for page in 0..pages {
        let mut sheet = Sheet::new();
        sheet.heading(
            DVec2::new(MARGIN, size.y - MARGIN - 5.0),
            5.0,
            &format!("Bend list, page {} of {pages}", page + 1),
        );
        for (column, words) in HEADINGS.iter().enumerate() {
            for (k, line) in wrapped(words, 2.8, 0.8 * width).iter().enumerate() {
                let x = MARGIN + width * (column as f64 + 0.25);
                sheet.text(DVec2::new(x, size.y - MARGIN - 11.0 - 3.0 * k as f64), 2.8, line);
            }
        }
        let mut y = top;
        for (i, row) in rows.iter().skip(page * rows_a_page).take(rows_a_page).enumerate() {
            if i % 5 == 0 {
                let across = [DVec2::new(MARGIN, y + 3.8), DVec2::new(size.x - MARGIN, y + 3.8)];
                sheet.line(&across, Pen::new(0.1, Ink::Grey(0.6)));
            }
            for (column, words) in row.iter().enumerate() {
                sheet.number(DVec2::new(MARGIN + width * (column as f64 + 0.75), y), 3.4, words);
            }
            y -= ROW;
        }
        if page + 1 == pages {
            let end = format!("At the end, go straight for {:.1} mm.", job.bends.last_feed_mm);
            sheet.text(DVec2::new(MARGIN, y - 2.0), 3.4, &end);
        }
        document.page(sheet);
    }
}

/// The steps as pictures.
pub fn steps(document: &mut Document, job: &Job) {
    let size = document.paper.size();
    let [across, down] = PICTURES.map(|count| count as f64);
    let cell = DVec2::new((size.x - 2.0 * MARGIN) / across, (size.y - 2.0 * MARGIN) / down);
    let room = cell - DVec2::new(6.0, 22.0);
    let scale = fitting(job, job.steps.iter().map(|step| step.side), room);
    let numbered: Vec<(usize, &Step)> = job.steps.iter().enumerate().collect();
    for page in numbered.chunks(PICTURES[0] * PICTURES[1]) {
        let mut sheet = Sheet::new();
        for (place, (number, step)) in page.iter().enumerate() {
            let at = DVec2::new((place % PICTURES[0]) as f64, (place / PICTURES[0]) as f64 + 1.0) * cell;
            let corner = DVec2::new(MARGIN + at.x, size.y - MARGIN - at.y);
            sheet.heading(corner + DVec2::new(0.0, cell.y - 5.0), 4.2, &format!("Step {}", number + 1));
            sheet.text(corner + DVec2::new(0.0, cell.y - 9.5), 3.0, &step.sentence());
            sheet.text(corner + DVec2::new(0.0, cell.y - 13.5), 3.0, &from_where(step));
            picture(&mut sheet, job, step, corner, room, scale);
        }
        document.page(sheet);
    }
}

fn from_where(step: &Step) -> String {
    let level = match step.side.elevation_deg {
        up if up > 0.0 => format!(", {up:.0} degrees from above"),
        down if down < 0.0 => format!(", {:.0} degrees from below", -down),
        _ => String::new(),
    };
    let azimuth = step.side.azimuth_deg.rem_euclid(360.0);
    let named = [(0.0, "from the front"), (90.0, "from the side"), (180.0, "from behind")];
    let round = match named.into_iter().find(|(at, _)| *at == azimuth) {
        Some((_, name)) => name.to_owned(),
        None if azimuth < 180.0 => format!("turned {azimuth:.0} degrees towards the side"),
        None => format!("turned {:.0} degrees the other way", 360.0 - azimuth),
    };
    format!("Seen {round}{level}")
}

/// What is there in grey, what is new in copper, in the middle of a box from `corner`.
fn picture(sheet: &mut Sheet, job: &Job, step: &Step, corner: DVec2, room: DVec2, scale: f64) {
    let [from, to] = range(job.line, [step.from_mm, step.to_mm]);
    let mut drawing = Small::new(sheet, job, step.side, corner + 0.5 * room, scale);
    let (grey, copper) = (Pen::new(drawing.width, Ink::Grey(0.68)), Pen::new(1.6 * drawing.width, Ink::Copper));
    drawing.draw([0, from], [0, to], [grey, grey]);
    drawing.draw([from, to], [0, to], [copper, copper.dashed(2.0 * drawing.width)]);
    let begins = drawing.middle + step.side.project(job.line.point(0)).0 * scale;
    sheet.dot(begins, 0.8);
}

/// The largest scale at which the wire fits into `room` from each of these sides, turned about its middle.
fn fitting(job: &Job, sides: impl Iterator<Item = Side>, room: DVec2) -> f64 {
    let reach = sides.flat_map(|side| job.line.points().iter().map(move |&point| side.project(point).0.abs()));
    (0.5 * room / reach.fold(DVec2::splat(1e-9), DVec2::max)).min_element()
}

/// A small drawing of the wire from a side.
struct Small<'a> {
    sheet: &'a mut Sheet,
    job: &'a Job<'a>,
    side: Side,
    middle: DVec2,
    scale: f64,
    /// Of its lines, mm.
    width: f64,
    /// Steps of the line that are one here.
    every: usize,
}

impl<'a> Small<'a> {
    fn new(sheet: &'a mut Sheet, job: &'a Job, side: Side, middle: DVec2, scale: f64) -> Small<'a> {
        let every = job.line.steps().div_ceil(MOST_STEPS);
        Small { sheet, job, side, middle, scale, every, width: (job.line.gauge_mm() * scale).clamp(0.35, 1.2) }
    }

    /// A stretch where nothing is there but the steps of `around`, with pens for what is seen and what is hidden.
    fn draw(&mut self, stretch: [usize; 2], around: [usize; 2], pens: [Pen; 2]) {
        let runs = runs(self.job.line, self.side, stretch, around, self.every);
        for hidden in [true, false] {
            for run in runs.iter().filter(|run| run.hidden == hidden) {
                let places: Vec<DVec2> = run.places.iter().map(|&at| self.middle + at * self.scale).collect();
                self.sheet.line(&thinned(&places, TOLERANCE), pens[usize::from(hidden)]);
            }
        }
    }
}
