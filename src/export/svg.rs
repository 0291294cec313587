//! One view as a drawing: filled outlines with the wire's true width at every point.
//!
//! A strand is cut where it turns more sharply than its own width allows an outline to follow. Each piece is outlined with
//! round ends, all outlines run the same way round, and filled by the non-zero rule they show the union. Coordinates are
//! whole numbers of a tenth of a pixel, each relative to the last, which keeps the file small. Strands that go behind the
//! solid which the wire covers taper off to nothing ([`Occluder`]).

use super::seen::{Place as Disc, Seen, thinned};
use crate::sculpture::strands;
use crate::view::{Occluder, View};
use crate::wire::Wire;
use glam::DVec2;
use std::f64::consts::PI;
use std::fmt::Write;

/// How [`svg`] draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SvgOptions {
    /// Whether the ground is drawn white; else it is transparent.
    pub ground: bool,
    /// How far outlines may be off; px.
    pub tolerance_px: f64,
}

impl Default for SvgOptions {
    fn default() -> Self {
        SvgOptions { ground: false, tolerance_px: 0.05 }
    }
}

/// Samples a knot span before thinning.
const SAMPLES_PER_SPAN: usize = 32;
/// Written units a pixel.
const UNITS_PER_PX: f64 = 10.0;
/// An outline follows a bend only while the curve's radius is this many times the wire's.
const BEND_RADII: f64 = 1.25;
/// Thinner than this shows nowhere.
const INVISIBLE_RADIUS_PX: f64 = 0.005;

/// The text of the file; its `viewBox` is the view's picture in px, y down, ink black. What `occluder` hides is left out; it
/// may be finer or coarser than the view's picture.
pub fn svg(wire: &Wire, view: &View, occluder: Option<&Occluder>, options: &SvgOptions) -> String {
    let seen = Seen::new(view, occluder);
    let (width, height) = (view.width_px, view.height_px);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n"
    );
    if options.ground {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    }
    let mut path = Path::default();
    for strand in strands(wire, SAMPLES_PER_SPAN) {
        let project = |point: &[f64; 4]| {
            let place = seen.place(point);
            Disc { radius: place.radius * place.visibility, ..place }
        };
        let mut discs: Vec<Disc> = strand.points.iter().map(project).collect();
        if strand.closed {
            discs.extend(discs.first().copied());
        }
        let reach = |disc: &Disc| {
            let beyond = (-disc.at).max(disc.at - DVec2::new(width as f64, height as f64)).max_element();
            beyond < disc.radius + FAR_PX && disc.radius > INVISIBLE_RADIUS_PX
        };
        // What is far outside or too thin to see parts the strand.
        for visible in discs.split(|disc| !reach(disc)) {
            for piece in pieces(visible) {
                path.outline(&thinned(piece, options.tolerance_px, off_the_cone), options.tolerance_px);
            }
        }
    }
    let _ = writeln!(text, "<path transform=\"scale({})\" d=\"{}\"/>\n</svg>", 1.0 / UNITS_PER_PX, path.text);
    text
}

/// Discs farther outside the picture than this are left out.
const FAR_PX: f64 = 64.0;

/// Runs that share their end discs, each of which bends gently enough to be outlined in one.
fn pieces(discs: &[Disc]) -> Vec<&[Disc]> {
    let mut pieces = Vec::new();
    let mut first = 0;
    for i in 1..discs.len().saturating_sub(1) {
        let [a, b, c] = [discs[i - 1], discs[i], discs[i + 1]];
        let (before, after) = (b.at - a.at, c.at - b.at);
        let turn = before.angle_to(after).abs();
        let steep = |d: DVec2, change: f64| change.abs() > 0.7 * d.length();
        let stuck = steep(before, b.radius - a.radius) || steep(after, c.radius - b.radius);
        // NaN (no direction) cuts as well.
        let gentle = turn * b.radius * BEND_RADII <= before.length().min(after.length()) && turn < 0.5;
        if stuck || !gentle {
            pieces.push(&discs[first..=i]);
            first = i;
        }
    }
    if !discs.is_empty() {
        pieces.push(&discs[first..]);
    }
    pieces
}

/// How far a disc's radius is off the cone's between its neighbours.
fn off_the_cone(a: &Disc, b: &Disc, disc: &Disc, share: f64) -> f64 {
    (a.radius + (b.radius - a.radius) * share - disc.radius).abs()
}

/// Path data under construction.
#[derive(Debug, Default)]
struct Path {
    text: String,
    /// Where the pen is, in written units.
    pen: [i64; 2],
}

impl Path {
    /// The outline of a run of discs: out along one side, round the end, back along the other, round the start.
    fn outline(&mut self, discs: &[Disc], tolerance_px: f64) {
        let (Some(&start), Some(&end)) = (discs.first(), discs.last()) else { return };
        let mut tangents = Vec::with_capacity(discs.len());
        for i in 0..discs.len() {
            let before = i.checked_sub(1).map_or(DVec2::ZERO, |k| (discs[i].at - discs[k].at).normalize_or_zero());
            let after = discs.get(i + 1).map_or(DVec2::ZERO, |n| (n.at - discs[i].at).normalize_or_zero());
            tangents.push((before + after).try_normalize().unwrap_or(DVec2::X));
        }
        // A cone's outline touches its discs not square to the axis but tilted by the sine of its slope.
        let slope = |i: usize| {
            let (a, b) = (discs[i.saturating_sub(1)], discs[(i + 1).min(discs.len() - 1)]);
            let length = a.at.distance(b.at);
            if length > 0.0 { ((b.radius - a.radius) / length).clamp(-0.999, 0.999) } else { 0.0 }
        };
        let contact = |i: usize, side: f64| {
            let (t, sine) = (tangents[i], slope(i));
            t.perp() * (side * (1.0 - sine * sine).sqrt()) - t * sine
        };
        let last = discs.len() - 1;
        let mut points: Vec<DVec2> = Vec::new();
        // y points down, so `perp` is clockwise on the screen: out on one side, back on the other.
        points.extend((0..=last).map(|i| discs[i].at + contact(i, -1.0) * discs[i].radius));
        arc(&mut points, end, contact(last, -1.0), contact(last, 1.0), tolerance_px);
        points.extend((0..=last).rev().map(|i| discs[i].at + contact(i, 1.0) * discs[i].radius));
        arc(&mut points, start, contact(0, 1.0), contact(0, -1.0), tolerance_px);
        self.polygon(&points);
    }

    fn polygon(&mut self, points: &[DVec2]) {
        let mut command = 'm';
        for point in points {
            let at = [point.x, point.y].map(|c| (c * UNITS_PER_PX).round() as i64);
            let step = [at[0] - self.pen[0], at[1] - self.pen[1]];
            if command == ' ' && step == [0, 0] {
                continue;
            }
            // Signs part numbers by themselves.
            let part = |x: i64| if x < 0 { "" } else { " " };
            let _ = match command {
                ' ' => write!(self.text, "{}{}{}{}", part(step[0]), step[0], part(step[1]), step[1]),
                _ => write!(self.text, "{command}{}{}{}", step[0], part(step[1]), step[1]),
            };
            self.pen = at;
            command = if command == 'm' { 'l' } else { ' ' };
        }
        if command == ' ' {
            self.text.push('z');
        }
        // `z` brings the pen back to the polygon's start.
        if let Some(first) = points.first() {
            self.pen = [first.x, first.y].map(|c| (c * UNITS_PER_PX).round() as i64);
        }
    }
}

/// Points between two directions on a disc, counter-clockwise in y-up terms, as fine as the tolerance asks.
fn arc(points: &mut Vec<DVec2>, disc: Disc, from: DVec2, to: DVec2, tolerance_px: f64) {
    let mut turn = from.angle_to(to);
    if turn <= 0.0 {
        turn += 2.0 * PI;
    }
    let step = 2.0 * (1.0 - (tolerance_px / disc.radius.max(tolerance_px)).min(0.5)).acos();
    let count = (turn / step).ceil().clamp(1.0, 256.0) as usize;
    for k in 1..count {
        let direction = DVec2::from_angle(turn * k as f64 / count as f64).rotate(from);
        points.push(disc.at + direction * disc.radius);
    }
}
