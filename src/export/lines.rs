//! One view as centre lines, for pen plotters and benders: a path for each stretch that nothing hides, in real size.
//!
//! Coordinates are px of the view's picture, y down; the `viewBox` is the box of what is drawn, stroke included, and `width`
//! and `height` say how large that is in millimetres.

use crate::sculpture::{Strand, strands};
use crate::view::{Camera, Occluder, View};
use crate::wire::Wire;
use glam::DVec2;
use std::fmt::Write;

/// Samples a knot span before thinning.
const SAMPLES_PER_SPAN: usize = 32;
/// How far lines may be off, px; with coordinates to a hundredth.
const TOLERANCE_PX: f64 = 0.02;
/// No place is left out for longer than this, which bounds the work of thinning.
const MAX_SKIP: usize = 64;
/// What is less visible is hidden.
const SEEN: f64 = 0.5;
/// Widths that differ by less are one.
const SAME_WIDTH: f64 = 0.02;

/// The text of the file. The longest side of what is drawn is `size_mm` long. Strokes are as wide as the wire if that is the
/// same everywhere in the picture, else as its thinnest place. What `occluder` hides is left out. One blank point where
/// nothing can be seen.
pub fn lines(wire: &Wire, view: &View, occluder: Option<&Occluder>, size_mm: f64) -> String {
    let camera = view.camera::<f64>();
    let seen = Seen { camera, occluder, size: DVec2::new(view.width_px as f64, view.height_px as f64) };
    let strands = strands(wire, SAMPLES_PER_SPAN);
    let runs: Vec<Run> = strands.iter().flat_map(|strand| seen.runs(strand)).collect();
    let places = || runs.iter().flat_map(|run| &run.places);
    let widths = || places().map(|place| 2.0 * place.radius);
    let (thinnest, widest) = widths().fold((f64::INFINITY, 0.0f64), |(low, high), w| (low.min(w), high.max(w)));
    let one_width = thinnest >= (1.0 - SAME_WIDTH) * widest;
    let stroke = if one_width { 0.5 * (thinnest + widest) } else { thinnest };
    let stroke = if stroke.is_finite() { stroke } else { 0.0 };
    let margin = DVec2::splat(0.5 * stroke);
    let low = places().map(|place| place.at - margin).reduce(DVec2::min).unwrap_or_default();
    let size = places().map(|place| place.at + margin).reduce(DVec2::max).unwrap_or_default() - low;
    let mm_per_px = size_mm / size.max_element().max(1e-9);
    let [width_mm, height_mm] = (size * mm_per_px).to_array().map(|mm| Short(mm, 3));
    let view_box = [low.x, low.y, size.x, size.y].map(|x| Short(x, 3));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width_mm}mm\" height=\"{height_mm}mm\" viewBox=\"{} {} {} {}\" \
         fill=\"none\" stroke=\"#000\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
        view_box[0],
        view_box[1],
        view_box[2],
        view_box[3],
        Short(stroke, 3),
    );
    for run in &runs {
        run.write(&mut text);
    }
    text + "</svg>\n"
}

/// A number with so many decimals at most, and no zeros at its end.
struct Short(f64, usize);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let text = format!("{:.*}", self.1, self.0);
        let text = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if text == "-0" { "0" } else { text })
    }
}

#[derive(Clone, Copy)]
struct Place {
    at: DVec2,
    radius: f64,
    visibility: f64,
}

impl Place {
    /// Between this and another place, where what can be seen ends.
    fn edge(&self, other: &Place) -> Place {
        let share = ((SEEN - self.visibility) / (other.visibility - self.visibility)).clamp(0.0, 1.0);
        let between = |a: f64, b: f64| a + share * (b - a);
        Place { at: self.at.lerp(other.at, share), radius: between(self.radius, other.radius), visibility: SEEN }
    }
}

/// A stretch that can be seen.
struct Run {
    places: Vec<Place>,
    closed: bool,
}

impl Run {
    fn write(&self, text: &mut String) {
        // Writing to a String cannot fail.
        for (i, place) in self.places.iter().enumerate() {
            let command = ["<path d=\"M", "L", " "][i.min(2)];
            let _ = write!(text, "{command}{} {}", Short(place.at.x, 2), Short(place.at.y, 2));
        }
        text.push_str(if self.closed { "Z\"/>\n" } else { "\"/>\n" });
    }

    /// Leaves out places that the line between their neighbours stands for.
    fn thinned(self) -> Run {
        let places = &self.places;
        let mut kept = vec![places[0]];
        let mut from = 0;
        for to in 2..=places.len() {
            let fits = to < places.len() && to - from <= MAX_SKIP && {
                let (a, b) = (places[from].at, places[to].at);
                let squared = (b - a).length_squared().max(1e-12);
                places[from + 1..to].iter().all(|place| {
                    let share = ((place.at - a).dot(b - a) / squared).clamp(0.0, 1.0);
                    a.lerp(b, share).distance(place.at) <= TOLERANCE_PX
                })
            };
            if !fits {
                kept.push(places[to - 1]);
                from = to - 1;
            }
        }
        Run { places: kept, closed: self.closed }
    }
}

/// What can be seen, and where in the picture.
struct Seen<'a> {
    camera: Camera<f64>,
    occluder: Option<&'a Occluder>,
    size: DVec2,
}

impl Seen<'_> {
    fn place(&self, point: &[f64; 4]) -> Place {
        let [x, y, radius] = self.camera.project(point);
        let visibility = self.occluder.map_or(1.0, |occluder| {
            let finer = DVec2::new(occluder.depth.width as f64, occluder.depth.height as f64) / self.size;
            occluder.visibility((DVec2::new(x, y) * finer).to_array(), self.camera.depth(point))
        });
        Place { at: DVec2::new(x, y), radius, visibility }
    }

    fn runs(&self, strand: &Strand) -> Vec<Run> {
        let mut places: Vec<Place> = strand.points.iter().map(|point| self.place(point)).collect();
        let seen = |place: &Place| place.visibility >= SEEN && place.at.is_finite();
        let mut closed = strand.closed;
        if closed {
            if let Some(hidden) = places.iter().position(|place| !seen(place)) {
                // Begun where it is hidden, no stretch goes over the end.
                places.rotate_left(hidden);
                closed = false;
            }
            places.extend(places.first().copied().filter(|_| !closed));
        }
        let mut runs: Vec<Run> = Vec::new();
        let mut run: Vec<Place> = Vec::new();
        for (i, place) in places.iter().enumerate() {
            let before = i.checked_sub(1).map(|i| &places[i]);
            match (before.filter(|before| seen(before) != seen(place)), seen(place)) {
                (Some(before), true) => run.extend([before.edge(place), *place]),
                (Some(before), false) => {
                    run.push(before.edge(place));
                    runs.push(Run { places: std::mem::take(&mut run), closed: false });
                }
                (None, true) => run.push(*place),
                (None, false) => {}
            }
        }
        runs.push(Run { places: run, closed });
        runs.into_iter().filter(|run| run.places.len() > 1).map(Run::thinned).collect()
    }
}
