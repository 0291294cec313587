//! The shape of the wire itself: parts, length, widths, bends.

use super::connectivity::connectivity;
use super::{Elegance, REPORT_SIZE_PX, elegance, picture::report_size};
use crate::view::{Camera, View};
use crate::wire::{Jerk, Wire};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Thinner than this in every view, in pixels at [`REPORT_SIZE_PX`], and nobody sees it.
const VISIBLE_WIDTH_PX: f64 = 0.25;
/// Samples a knot span, and the fewest in all.
const SAMPLES_PER_SPAN: usize = 16;
const MIN_SAMPLES: usize = 512;
/// Above this many spans samples are halved, which still leaves chords within a hundredth of a pixel.
const MANY_SPANS: usize = 5_000;
/// Arc length is exact to this, world units.
const LENGTH_ACCURACY: f64 = 1e-6;

/// Figures of the wire's shape. World units, in which the object fits the unit ball.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ShapeMetrics {
    /// Arc length of the visible parts. A part is visible where its width in the widest view is a quarter of a pixel at
    /// 256 px or more.
    pub length: f64,
    /// Visible parts, after joining those that touch (distance at most the sum of the radii).
    pub components: usize,
    /// Weight of the minimum spanning tree that joins the components by the nearest points of their centre lines.
    pub connectivity_cost: f64,
    /// Least width of the whole wire, visible or not.
    pub min_width: f64,
    /// Greatest width of the whole wire.
    pub max_width: f64,
    /// Least radius of curvature of the visible parts; `None` where nothing bends.
    pub min_bend_radius: Option<f64>,
    /// `∫ |C'''|² dt` over position and width, on the wire's own knots.
    pub jerk: f64,
    /// How the wire runs: bends, kinks, and where it meets itself.
    #[serde(flatten)]
    pub elegance: Elegance,
}

/// Measures `wire` as seen in `views`; without any, as in the three canonical ones 2.2 world units high.
pub fn shape(wire: &Wire, views: &[View]) -> ShapeMetrics {
    let samples = samples_per_span(wire);
    let (map, strokes) = wire.sampling_map::<f64>(samples, false);
    let mut points = Vec::new();
    map.apply(wire.control_points(), &mut points);
    let parameters = wire.sample_parameters(samples);
    let cameras = report_cameras(views);
    let visible: Vec<bool> = points.iter().map(|point| width_px(&cameras, point) >= VISIBLE_WIDTH_PX).collect();

    let mut parts = Vec::new();
    let mut length = 0.0;
    for stroke in &strokes {
        for part in visible_runs(&visible[stroke.start..stroke.start + stroke.count], stroke.closed) {
            let index = |k: usize| stroke.start + (part.first + k) % stroke.count;
            length += arc_length(wire, &parameters, index(0), index(part.count - 1), part.whole_loop);
            // A loop's first point comes again at its end.
            let total = part.count + usize::from(part.whole_loop);
            parts.push((0..total).map(|k| points[index(k % stroke.count)]).collect::<Vec<_>>());
        }
    }
    let (components, connectivity_cost) = connectivity(&parts);
    let bends = parameters.iter().zip(&visible).filter(|&(_, &visible)| visible);
    let min_bend_radius = bends.filter_map(|(&t, _)| bend_radius(wire, t)).reduce(f64::min);
    let widths = || points.iter().map(|point| point[3].max(0.0));
    ShapeMetrics {
        length,
        components,
        connectivity_cost,
        min_width: widths().fold(f64::INFINITY, f64::min),
        max_width: widths().fold(0.0, f64::max),
        min_bend_radius,
        jerk: Jerk::<f64>::new(wire).energy(wire.control_points(), 1.0, 1.0),
        elegance: elegance(wire).0,
    }
}

fn samples_per_span(wire: &Wire) -> usize {
    let spans = wire.spans().count().max(1);
    if spans > MANY_SPANS { SAMPLES_PER_SPAN / 2 } else { SAMPLES_PER_SPAN.max(MIN_SAMPLES / spans) }
}

fn report_cameras(views: &[View]) -> Vec<Camera<f64>> {
    let standard;
    let views = if views.is_empty() {
        standard = View::canonical(2.2, REPORT_SIZE_PX);
        &standard
    } else {
        views
    };
    views
        .iter()
        .map(|view| {
            let (width, height) = report_size(view.width_px, view.height_px);
            view.with_size(width, height).camera()
        })
        .collect()
}

fn width_px(cameras: &[Camera<f64>], point: &[f64; 4]) -> f64 {
    cameras.iter().map(|camera| 2.0 * camera.project(point)[2]).fold(0.0, f64::max)
}

/// Consecutive visible samples of a stroke.
#[derive(Debug, PartialEq)]
struct Run {
    first: usize,
    count: usize,
    /// All of a closed stroke.
    whole_loop: bool,
}

fn visible_runs(visible: &[bool], closed: bool) -> Vec<Run> {
    let count = visible.len();
    let Some(gap) = visible.iter().position(|&seen| !seen) else {
        return vec![Run { first: 0, count, whole_loop: closed }];
    };
    // A closed stroke is read from a gap on, so that no run is cut by the seam.
    let origin = if closed { gap } else { 0 };
    let mut runs: Vec<Run> = Vec::new();
    let mut open = false;
    for k in 0..count {
        let i = (origin + k) % count;
        if visible[i] && open {
            if let Some(run) = runs.last_mut() {
                run.count += 1;
            }
        } else if visible[i] {
            runs.push(Run { first: i, count: 1, whole_loop: false });
        }
        open = visible[i];
    }
    runs
}

fn arc_length(wire: &Wire, parameters: &[f64], first: usize, last: usize, whole_loop: bool) -> f64 {
    let (start, end) = wire.domain();
    let between = |from, to| wire.length_between(from, to, LENGTH_ACCURACY);
    match (whole_loop, first <= last) {
        (true, _) => between(start, end),
        (false, true) => between(parameters[first], parameters[last]),
        // Over the seam of a closed wire.
        (false, false) => between(parameters[first], end) + between(start, parameters[last]),
    }
}

/// Radius of curvature, |C'|³ / |C' x C''|; `None` where the wire is straight or stands still.
fn bend_radius(wire: &Wire, t: f64) -> Option<f64> {
    let [first, second] = [1, 2].map(|order| {
        let [x, y, z, _] = wire.derivative(t, order);
        DVec3::new(x, y, z)
    });
    let radius = first.length().powi(3) / first.cross(second).length();
    // Beyond this a bend is rounding.
    (radius < 1e6).then_some(radius)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_cut_by_gaps_and_not_by_the_seam() {
        let run = |first, count, whole_loop| Run { first, count, whole_loop };
        let seen = [true, true, false, false, true, true];
        assert_eq!(visible_runs(&seen, false), [run(0, 2, false), run(4, 2, false)]);
        assert_eq!(visible_runs(&seen, true), [run(4, 4, false)]);
        assert_eq!(visible_runs(&[true; 3], true), [run(0, 3, true)]);
        assert_eq!(visible_runs(&[false; 3], true), []);
    }
}
