//! One photograph: what was cut out, drawn and fitted, how well, and how long it took.

use crate::photo_judge::{border, judged, mask, overlap, share_near};
use crate::scenes::{Photograph, SIDE};
use serde::Serialize;
use serde_json::json;
use std::error::Error;
use std::path::Path;
use std::time::Instant;
use wire4d::metrics::length_over_lines;
use wire4d::picture::drawing::{Budget, Line, draw, draw_in_box, ink};
use wire4d::picture::{GreyDepth, Photo, Picture, write_png};
use wire4d::sculpture::render;
use wire4d::settings::Settings;
use wire4d::start::Solid;
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{Found, Given, find, plan};
use wire4d::view::{Image, View};
use wire4d::wire::Wire;

/// How far a wire is turned to see whether it is in the round, degrees.
const TURNED: f64 = 35.0;
/// What is seen then: the unit ball with a margin, world units.
const HEIGHT_WORLD: f64 = 2.2;

/// A photograph, and what is known of it.
pub struct Subject {
    pub name: String,
    pub given: Given,
    pub truth: Option<Photograph>,
}

/// What came of it. Shares are within 2 px at 256 px.
#[derive(Serialize)]
pub struct Figures {
    name: String,
    /// Left, top, right and bottom, px of the picture.
    #[serde(rename = "box")]
    bounds: Option<[f64; 4]>,
    /// How sure the cut is, and whether no object was seen in the box, so that all lines in it are drawn.
    sure: f32,
    unseen: bool,
    truth: Option<Truth>,
    /// The wire's ink near the lines, and the lines' near the wire.
    wire_precision: Option<f64>,
    wire_recall: Option<f64>,
    components: usize,
    kinks: usize,
    tight_share: f64,
    touching_share: f64,
    length_over_lines: Option<f64>,
    /// Turned: the wire's ink in the solid's silhouette, and the silhouette's rim near the wire's ink.
    turned_precision: f64,
    turned_rim_recall: f64,
    /// With the settings asked for, and with the fast preset.
    seconds: Seconds,
    seconds_fast: Seconds,
    notes: Vec<String>,
}

/// What only a scene's geometry can say: intersection over union of the cut; precision, recall and the outline's recall of
/// the lines drawn within the true mask, and within the cut.
#[derive(Serialize)]
struct Truth {
    cut_iou: f64,
    lines_of_truth: [f64; 3],
    lines_of_cut: [f64; 3],
}

impl std::fmt::Display for Figures {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {:.1} s, fast {:.1} s", self.name, self.seconds.total, self.seconds_fast.total)
    }
}

/// Solid and first wire are the start.
#[derive(Serialize, Clone, Copy)]
struct Seconds {
    cut: f64,
    lines: f64,
    start: f64,
    fit: f64,
    total: f64,
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begin = Instant::now();
    let made = work();
    (made, begin.elapsed().as_secs_f64())
}

/// Makes the wire and writes it with its pictures into a folder; with settings `fast`, too, its time is taken.
pub fn run(subject: &Subject, settings: &Settings, fast: &Settings, out: &Path) -> Result<Figures, Box<dyn Error>> {
    let given = &subject.given;
    let photo = Photo::of(&given.picture);
    let (found, first_cut_s) = timed(|| find(given, settings));
    let found = found?;
    let (lines, lines_s) = timed(|| lines(&photo, &found, settings));
    // The first of all is slower.
    let cut_s = timed(|| find(given, settings)).1.min(first_cut_s);
    let truth = subject.truth.as_ref().map(|taken| Truth {
        cut_iou: overlap(&taken.mask, &found.object.mask.resized(SIDE, SIDE)),
        lines_of_truth: judged(&draw(&photo, &mask(taken.mask.clone()).to_image(), budget(settings)), taken),
        lines_of_cut: judged(&lines, taken),
    });
    let before = [cut_s, lines_s];
    let (seconds_fast, ..) = fitted(given, fast, before)?;
    let (seconds, run, solid) = fitted(given, settings, before)?;
    let result = run.result();
    let made = run.sculpture();
    let front = &run.targets()[0];
    let [turned_precision, turned_rim_recall] = turned(&made.wire, &solid);
    let figures = Figures {
        name: subject.name.clone(),
        bounds: given.bounds,
        sure: found.sure,
        unseen: found.unseen.is_some(),
        truth,
        wire_precision: result.views[0].precision_2px,
        wire_recall: result.views[0].recall_2px,
        components: result.shape.components,
        kinks: result.shape.elegance.kinks,
        tight_share: result.shape.elegance.tight_share,
        touching_share: result.shape.elegance.touching_share,
        length_over_lines: length_over_lines(result.shape.length, [(&front.ink, &front.view)]),
        turned_precision,
        turned_rim_recall,
        seconds,
        seconds_fast,
        notes: found.object.notes.clone(),
    };
    save_photo(&given.picture, out)?;
    write_png(&out.join("mask.png"), &found.object.mask, GreyDepth::Bits8)?;
    write_png(&out.join("lines.png"), &ink(&lines, photo.width, photo.height), GreyDepth::Bits8)?;
    std::fs::write(out.join("wire.json"), made.to_json())?;
    std::fs::write(out.join("figures.json"), serde_json::to_string_pretty(&figures)?)?;
    Ok(figures)
}

/// What is left where no wire could be made: the photograph, and why.
pub fn refused(subject: &Subject, why: &dyn Error, out: &Path) -> Result<(), Box<dyn Error>> {
    save_photo(&subject.given.picture, out)?;
    let figures = json!({ "name": subject.name, "box": subject.given.bounds, "notes": [format!("no wire: {why}")] });
    Ok(std::fs::write(out.join("figures.json"), serde_json::to_string_pretty(&figures)?)?)
}

fn save_photo(picture: &Picture, out: &Path) -> Result<(), Box<dyn Error>> {
    std::fs::create_dir_all(out)?;
    let (width, height) = (picture.width() as u32, picture.height() as u32);
    let pixels = image::RgbaImage::from_raw(width, height, picture.rgba().to_vec()).ok_or("no picture")?;
    Ok(image::DynamicImage::ImageRgba8(pixels).to_rgb8().save(out.join("photo.png"))?)
}

/// The lines as the task draws them.
fn lines(photo: &Photo, found: &Found, settings: &Settings) -> Vec<Line> {
    match found.unseen {
        Some(bounds) => draw_in_box(photo, bounds.map(|side| (side * photo.scale) as f32), budget(settings)),
        None => draw(photo, &found.object.mask.resized(photo.width, photo.height), budget(settings)),
    }
}

fn budget(settings: &Settings) -> Budget {
    if settings.lines == 0 { Budget::default() } else { Budget::Lines(settings.lines) }
}

/// A whole run, and where its time went; `before` is how long cutting and drawing take in it.
fn fitted(given: &Given, settings: &Settings, [cut, lines]: [f64; 2]) -> Result<(Seconds, Run, Solid), Box<dyn Error>> {
    let (plan, plan_s) = timed(|| plan(given, settings));
    let plan = plan?;
    let solid = plan.solid.clone();
    let (run, first_s) = timed(|| Run::start(plan, &mut |_| true));
    let mut run = run?;
    let (stepped, fit) = timed(|| run.step(usize::MAX));
    stepped?;
    let start = (plan_s + first_s - cut - lines).max(0.0);
    Ok((Seconds { cut, lines, start, fit, total: plan_s + first_s + fit }, run, solid))
}

/// Turned: the share of the wire's ink inside the solid's silhouette, and of the silhouette's rim near the wire's ink.
fn turned(wire: &Wire, solid: &Solid) -> [f64; 2] {
    let view = View::orthographic("turned", TURNED.to_radians(), 0.0, HEIGHT_WORLD, SIDE);
    let on = |image: &Image| image.data.iter().map(|&value| value > 0.5).collect::<Vec<_>>();
    let (shown, silhouette) = (on(&render(wire, &view)), on(&solid.silhouette(&view)));
    [share_near(&shown, &silhouette), share_near(&border(&silhouette), &shown)]
}
