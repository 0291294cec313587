//! One view as centre lines, for pen plotters and benders: a path for each stretch that nothing hides, in real size.
//!
//! Coordinates are px of the view's picture, y down; the `viewBox` is the box of what is drawn, stroke included, and `width`
//! and `height` say how large that is in millimetres.

use super::seen::{Place, Seen, thinned};
use crate::sculpture::{Strand, strands};
use crate::view::{Occluder, View};
use crate::wire::Wire;
use glam::DVec2;
use std::fmt::Write;

/// Samples a knot span before thinning.
const SAMPLES_PER_SPAN: usize = 32;
/// How far lines may be off, px; with coordinates to a hundredth.
const TOLERANCE_PX: f64 = 0.02;
/// What is less visible is hidden.
const SEEN: f64 = 0.5;
/// Widths that differ by less are one.
const SAME_WIDTH: f64 = 0.02;

/// The text of the file. The longest side of what is drawn is `size_mm` long. Strokes are as wide as the wire if that is the
/// same everywhere in the picture, else as its thinnest place. What `occluder` hides is left out. One blank point where
/// nothing can be seen.
pub fn lines(wire: &Wire, view: &View, occluder: Option<&Occluder>, size_mm: f64) -> String {
    let seen = Seen::new(view, occluder);
    let strands = strands(wire, SAMPLES_PER_SPAN);
    let runs: Vec<Run> = strands.iter().flat_map(|strand| runs(&seen, strand)).collect();
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

/// Between two places, where what can be seen ends.
fn edge(a: &Place, b: &Place) -> Place {
    let share = ((SEEN - a.visibility) / (b.visibility - a.visibility)).clamp(0.0, 1.0);
    Place { at: a.at.lerp(b.at, share), radius: a.radius + share * (b.radius - a.radius), visibility: SEEN }
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
}

/// The stretches of a strand that can be seen.
fn runs(view: &Seen, strand: &Strand) -> Vec<Run> {
    let mut places: Vec<Place> = strand.points.iter().map(|point| view.place(point)).collect();
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
            (Some(before), true) => run.extend([edge(before, place), *place]),
            (Some(before), false) => {
                run.push(edge(before, place));
                runs.push(Run { places: std::mem::take(&mut run), closed: false });
            }
            (None, true) => run.push(*place),
            (None, false) => {}
        }
    }
    runs.push(Run { places: run, closed });
    let lines = runs.into_iter().filter(|run| run.places.len() > 1);
    lines.map(|run| Run { places: thinned(&run.places, TOLERANCE_PX, |_, _, _, _| 0.0), ..run }).collect()
}
