//! What a reader of PDFs finds on the pages, in millimetres from their lower left corners.

use super::*;
use crate::Metal;
use hayro_syntax::Pdf;
use hayro_syntax::content::TypedIter;
use hayro_syntax::content::ops::{LineTo, MoveTo, Transform, TypedInstruction as Op};
use hayro_syntax::object::{Array, Number};
use hayro_syntax::page::Page;
use wire4d_core::wire::Wire;

/// A curl that takes several sheets and crosses itself.
fn with_curl<T>(size_mm: f64, look: impl FnOnce(&Job) -> T) -> T {
    let points = (0..96).map(|i| f64::from(i) * std::f64::consts::TAU / 96.0);
    let points = points.map(|t| [t.cos(), 0.7 * (2.0 * t).sin(), 0.2 * t.sin(), 0.02]).collect();
    let wire = Wire::closed_uniform(points).unwrap();
    let stock = Stock { metal: Metal::Copper, gauge_mm: 1.6, length_mm: 500.0 };
    let line = Centreline::new(&wire, size_mm, stock.gauge_mm).unwrap();
    let check = Check::new(&wire, &line, &stock).unwrap();
    let bends = BendList::new(&line, stock.metal);
    let steps = crate::steps(&line, &bends);
    look(&Job { name: "curl", line: &line, stock: &stock, check: &check, bends: &bends, steps: &steps })
}

struct Stroke {
    places: Vec<DVec2>,
    width: f64,
    dashed: bool,
    /// By how much the drawing that it is part of is moved; none for what is on the page itself.
    moved: Option<DVec2>,
}

#[derive(Default)]
struct Found {
    strokes: Vec<Stroke>,
    words: Vec<String>,
}

const MM: f64 = 25.4 / 72.0;

fn place(x: Number, y: Number) -> DVec2 {
    DVec2::new(x.as_f64(), y.as_f64()) * MM
}

impl Found {
    fn on(page: &Page) -> Found {
        let mut found = Found::default();
        found.read(page, page.typed_operations(), None);
        found
    }

    fn read(&mut self, page: &Page, mut ops: TypedIter, moved: Option<DVec2>) {
        let (mut by, mut width, mut dashed, mut path) = (DVec2::ZERO, 0.0, false, Vec::new());
        while let Some(op) = ops.next() {
            match op {
                Op::Transform(Transform(a, _, _, d, x, y)) => {
                    assert_eq!((a.as_f64(), d.as_f64()), (1.0, 1.0), "nothing is scaled");
                    by = place(x, y);
                }
                Op::RestoreState(_) => by = DVec2::ZERO,
                Op::LineWidth(mm) => width = mm.0.as_f64() * MM,
                Op::DashPattern(dash) => dashed = Array::iter::<Number>(dash.0).next().is_some(),
                Op::MoveTo(MoveTo(x, y)) => path = vec![place(x, y)],
                Op::LineTo(LineTo(x, y)) => path.push(place(x, y)),
                Op::StrokePath(_) => {
                    let places = path.iter().map(|at| *at + moved.unwrap_or_default()).collect();
                    self.strokes.push(Stroke { places, width, dashed, moved });
                }
                Op::ShowText(text) => self.words.push(String::from_utf8_lossy(text.0.as_bytes()).into_owned()),
                Op::XObject(name) => {
                    let drawing = page.resources().get_x_object(name.0).expect("a drawing of that name");
                    let bytes = drawing.decoded().unwrap();
                    self.read(page, TypedIter::new(&bytes), Some(by));
                }
                _ => {}
            }
        }
    }

    fn says(&self, words: &str) -> bool {
        self.words.iter().any(|found| found.contains(words))
    }
}

fn pages(pdf: Vec<u8>) -> Vec<Found> {
    Pdf::new(pdf).unwrap().pages().iter().map(Found::on).collect()
}

#[test]
fn every_drawing_has_a_ruler_of_100_millimetres() {
    for paper in Paper::ALL {
        let pdf = with_curl(300.0, |job| job.pdf(paper));
        let opened = Pdf::new(pdf.clone()).unwrap();
        for page in opened.pages().iter() {
            let size = [page.media_box().width(), page.media_box().height()].map(|pt| pt * MM);
            assert!(size.iter().zip(paper.size_mm()).all(|(found, mm)| (found - mm).abs() < 0.01), "{size:?}");
        }
        let mut measured = 0;
        for page in pages(pdf).iter().filter(|page| page.says("100 mm: measure it")) {
            let level = |stroke: &&Stroke| stroke.moved.is_none() && stroke.places[0].y == stroke.places[1].y;
            let rulers: Vec<&Stroke> = page
                .strokes
                .iter()
                .filter(level)
                .filter(|stroke| (stroke.places[0].distance(stroke.places[1]) - 100.0).abs() < 0.01)
                .collect();
            let [ruler] = rulers[..] else { panic!("{} rulers", rulers.len()) };
            let from = ruler.places[0];
            let stands = |stroke: &&Stroke| {
                stroke.places.len() == 2 && stroke.places[0].y == from.y && stroke.places[1].x == stroke.places[0].x
            };
            let mut marks: Vec<f64> =
                page.strokes.iter().filter(stands).map(|mark| mark.places[0].x - from.x).collect();
            marks.dedup();
            assert_eq!(marks.len(), 11);
            assert!(marks.iter().enumerate().all(|(i, x)| (x - 10.0 * i as f64).abs() < 0.01), "{marks:?}");
            measured += 1;
        }
        assert!(measured > 4, "{measured}");
    }
}

#[test]
fn sheets_show_the_wire_at_true_size_and_fit_together() {
    with_curl(300.0, |job| {
        let pages = pages(job.pdf(Paper::A4));
        let fronts: Vec<&Found> = pages.iter().filter(|page| page.says("Front, true size")).collect();
        assert_eq!(fronts.len(), 2, "300 mm are two sheets wide");
        // In the drawing's own places both sheets show all of it, the front as wide as the wire.
        let mut corners = Vec::new();
        for page in &fronts {
            let drawn: Vec<&Stroke> = page.strokes.iter().filter(|stroke| stroke.moved.is_some()).collect();
            let middles =
                || drawn.iter().filter(|stroke| stroke.width < 0.5 && !stroke.dashed).flat_map(|stroke| &stroke.places);
            let low = middles().copied().reduce(DVec2::min).unwrap();
            let size = middles().copied().reduce(DVec2::max).unwrap() - low;
            let wire = 2.0 * job.line.half_box_mm();
            assert!((size.x - 300.0).abs() < 0.3 && (size.y - wire.y).abs() < 0.3, "{size} of {wire}");
            assert!(drawn.iter().any(|stroke| (stroke.width - 1.6).abs() < 0.01), "its true thickness");
            // One crossing: one strand goes below the other.
            let dashed: Vec<&&Stroke> = drawn.iter().filter(|stroke| stroke.dashed).collect();
            assert_eq!(dashed.len(), 1);
            corners.push(low);
        }
        // What is next to it on paper once it is glued: a window's width less the overlap.
        let apart = corners[0] - corners[1];
        assert!((apart - DVec2::new(210.0 - 2.0 * 12.0 - 10.0, 0.0)).length() < 0.01, "{apart}");
        for number in [0, 1, 2] {
            assert!(fronts[0].words.contains(&number.to_string()), "point {number}");
        }
    });
}

#[test]
fn all_bends_and_steps_are_there() {
    with_curl(200.0, |job| {
        for paper in Paper::ALL {
            let pages = pages(job.pdf(paper));
            let said = |words: &str| pages.iter().filter(|page| page.says(words)).count();
            assert_eq!(said("It can be bent from 1.6 mm copper wire"), 1);
            for row in job.bends.rows(job.stock) {
                let all = |page: &&Found| page.says("Bend list") && row.iter().all(|cell| page.words.contains(cell));
                assert!(pages.iter().any(|page| all(&page)), "{row:?}");
            }
            for step in 1..=job.steps.len() {
                assert_eq!(pages.iter().filter(|page| page.words.contains(&format!("Step {step}"))).count(), 1);
            }
        }
    });
}

#[test]
fn what_nobody_could_glue_is_left_out_and_said() {
    with_curl(5000.0, |job| {
        let pages = pages(job.pdf(Paper::A4));
        assert!(pages[0].says("true size are left out"));
        assert!(pages.iter().all(|page| !page.says("true size: sheet")));
    });
}
