//! Knot vectors: how they are laid out, what makes one valid, and the non-empty spans between them.
//!
//! All three forms are cubic B-splines; they differ in how often an interior knot is repeated: once in a spline (C2),
//! three times in a chain (C0, control points are Bézier points), four times in a bag (independent Béziers). So one
//! layout serves all: open wires have `n + 4` clamped knots, closed ones `n + 7` periodic knots.

use super::Form;
use crate::{Error, Result};

/// Fewest control points of a wire.
pub const MIN_CONTROL_POINTS: usize = 4;
/// Most control points of a wire.
pub const MAX_CONTROL_POINTS: usize = 20_000;
/// Largest coordinate or width, world units (the object fits the unit ball), so that squares stay finite in `f32`.
pub const MAX_COORDINATE: f64 = 1e4;
/// Largest absolute knot.
pub const MAX_KNOT: f64 = 1e6;
/// Least distance of two different knots, so that the jerk's `1 / D⁵` stays finite in `f32`.
pub const MIN_KNOT_SPACING: f64 = 1e-5;

/// A non-empty knot interval: one cubic polynomial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Parameter at its start.
    pub start: f64,
    /// Parameter at its end.
    pub end: f64,
    /// First of its four consecutive control points (modulo their number when closed).
    pub first: usize,
}

impl Span {
    /// Index of the knot at its start.
    pub(super) fn knot(&self) -> usize {
        self.first + 3
    }

    /// Its length in knot units.
    pub fn width(&self) -> f64 {
        self.end - self.start
    }

    /// The parameter at `fraction` 0 to 1 of the span; exact at both ends.
    pub fn at(&self, fraction: f64) -> f64 {
        self.start * (1.0 - fraction) + self.end * fraction
    }
}

impl Form {
    /// How often an interior knot is repeated.
    pub(super) fn multiplicity(self) -> usize {
        match self {
            Form::Spline => 1,
            Form::Chain => 3,
            Form::Bag => 4,
        }
    }

    /// The largest valid number of control points up to `count`.
    pub(super) fn fitting_count(self, closed: bool, count: usize) -> usize {
        match (self, closed) {
            (Form::Spline, _) => count,
            (Form::Chain, false) => count.saturating_sub(1) / 3 * 3 + 1,
            (Form::Chain, true) => count / 3 * 3,
            (Form::Bag, _) => count / 4 * 4,
        }
    }
}

/// Whether `form` can have `count` control points.
pub(super) fn check_count(form: Form, closed: bool, count: usize) -> Result<()> {
    if !(MIN_CONTROL_POINTS..=MAX_CONTROL_POINTS).contains(&count) {
        return Err(wire_error(
            format!("it has {count} control points"),
            format!("use {MIN_CONTROL_POINTS} to {MAX_CONTROL_POINTS}"),
        ));
    }
    if form == Form::Bag && closed {
        return Err(wire_error("a bag of separate Béziers cannot be closed", "use the form spline or chain"));
    }
    if form.fitting_count(closed, count) != count {
        let remedy = match (form, closed) {
            (Form::Bag, _) => "use 4 control points a segment",
            (_, false) => "use 3 control points a segment and one more",
            (_, true) => "use 3 control points a segment",
        };
        return Err(wire_error(format!("{count} control points make no whole number of Bézier segments"), remedy));
    }
    Ok(())
}

/// Knots 0, 1, 2, … repeated as `form` asks, for a valid `count` of control points.
pub(super) fn uniform_knots(form: Form, closed: bool, count: usize) -> Vec<f64> {
    let repeat = form.multiplicity() as f64;
    let total = if closed { count + 7 } else { count + 4 };
    // Knot 3 is the start in every layout; runs of `repeat` equal knots end at 3, 3 + repeat, …
    let knot = |i: usize| ((i as f64 - 3.0) / repeat).ceil();
    if closed {
        (0..total).map(knot).collect()
    } else {
        let end = knot(count);
        (0..total).map(|i| knot(i).clamp(0.0, end)).collect()
    }
}

/// Checks `knots` for `count` control points and makes the periodic part of closed ones exact to the last bit.
pub(super) fn validate_knots(form: Form, closed: bool, count: usize, mut knots: Vec<f64>) -> Result<Vec<f64>> {
    let expected = if closed { count + 7 } else { count + 4 };
    if knots.len() != expected {
        return Err(wire_error(
            format!("{count} control points come with {} knots", knots.len()),
            format!("give {expected} ({})", if closed { "closed: n + 7" } else { "open: n + 4" }),
        ));
    }
    if knots.iter().any(|knot| !knot.is_finite() || knot.abs() > MAX_KNOT) {
        return Err(wire_error("a knot is not a usable number", format!("use knots within ±{MAX_KNOT}")));
    }
    if knots.windows(2).any(|pair| pair[1] < pair[0]) {
        return Err(wire_error("its knots fall", "sort them in ascending order"));
    }
    if closed {
        let given = knots.clone();
        make_periodic(count, &mut knots);
        let tolerance = 1e-9 * (knots[count + 3] - knots[3] + knots[3].abs());
        if knots.iter().zip(&given).any(|(exact, given)| (exact - given).abs() > tolerance) {
            return Err(wire_error(
                "its knots are not periodic",
                "let knots[i + n] - knots[i] be the same for every i, n the number of control points",
            ));
        }
    } else if knots[0] != knots[3] || knots[count] != knots[count + 3] {
        return Err(wire_error("its knots are not clamped", "repeat the first and the last knot four times"));
    }
    if knots.windows(2).any(|pair| pair[1] > pair[0] && pair[1] - pair[0] < MIN_KNOT_SPACING) {
        return Err(wire_error(
            "two knots nearly coincide",
            format!("keep different knots {MIN_KNOT_SPACING} apart, or scale them all"),
        ));
    }
    let (most, interior) = match (form, closed) {
        (Form::Bag, _) => (4, &knots[..]),
        (_, true) => (3, &knots[..]),
        (_, false) => (3, &knots[4..count]),
    };
    // Clamped ends have four equal knots and no fifth.
    if interior.windows(most + 1).any(|run| run[0] == run[most]) || knots.windows(5).any(|run| run[0] == run[4]) {
        return Err(wire_error("a knot is repeated too often", "repeat interior knots three times at most"));
    }
    if form != Form::Spline {
        let repeat = form.multiplicity();
        let last = if closed { count + 3 } else { count };
        if (3..last).any(|k| (knots[k] < knots[k + 1]) != (k - 3).is_multiple_of(repeat)) {
            return Err(wire_error(
                "its knots do not cut it into Bézier segments",
                format!("repeat each interior knot exactly {repeat} times"),
            ));
        }
    }
    Ok(knots)
}

/// Fills in the knots before `knots[3]` and after `knots[n + 3]` from those between; `n` control points.
pub(super) fn make_periodic(count: usize, knots: &mut [f64]) {
    let (start, end) = (knots[3], knots[count + 3]);
    let period = end - start;
    // Copies of the end and the start must hit them to the last bit, or a repeated knot would fall apart.
    for i in 0..3 {
        knots[i] = if knots[i + count] == end { start } else { knots[i + count] - period };
    }
    for i in 4..7 {
        knots[i + count] = if knots[i] == start { end } else { knots[i] + period };
    }
}

pub(super) fn wire_error(problem: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::wire("wire", problem, remedy)
}
