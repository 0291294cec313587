//! The 4D wire itself: control points (x, y, z, width), knots, and the linear maps from them.
//!
//! Geometry is `f64`; the maps that fitting applies every iteration come in `f32` or `f64` ([`Real`]).
//! Everything rests on one formula, the blossom in `basis`: evaluation, Bézier conversion, sampling, insertion.

mod basis;
mod bezier;
mod forms;
mod insertion;
mod jerk;
mod layout;
mod length;
mod linear_map;
mod sampling;

pub use jerk::Jerk;
pub use layout::{MAX_CONTROL_POINTS, MAX_COORDINATE, MAX_KNOT, MIN_CONTROL_POINTS, MIN_KNOT_SPACING, Span};
pub use linear_map::{LinearMap, Real, Row};

use crate::Result;
use layout::wire_error;

/// How the control points make the curve. `Spline` is the wire; the other two are baselines to compare it with.
///
/// All are cubic B-splines with the same knot layout; interior knots are repeated once, three and four times.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// Cubic B-spline: C2 everywhere (where knots are simple, as they are unless a file says otherwise).
    #[default]
    Spline,
    /// Cubic Béziers that share end points: C0. 3s + 1 control points for s segments, 3s if closed.
    Chain,
    /// Independent cubic Béziers: 4s control points for s segments, never closed.
    Bag,
}

/// One run of consecutive samples that are joined: `start..start + count`, and back to `start` if `closed`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stroke {
    /// Index of the first sample.
    pub start: usize,
    /// Number of samples.
    pub count: usize,
    /// Whether the last sample joins the first.
    pub closed: bool,
}

/// Control points in world units (x, y, z, width; width is the full diameter) with their knots.
///
/// Always valid: every constructor and setter checks, so what holds a `Wire` need not.
/// Serialises as `{ form, closed, knots, control_points }` and is checked again when read.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(try_from = "Parts")]
pub struct Wire {
    form: Form,
    closed: bool,
    knots: Vec<f64>,
    control_points: Vec<[f64; 4]>,
}

/// What a serialised wire consists of, not yet checked.
#[derive(serde::Deserialize)]
struct Parts {
    #[serde(default)]
    form: Form,
    closed: bool,
    knots: Vec<f64>,
    control_points: Vec<[f64; 4]>,
}

impl TryFrom<Parts> for Wire {
    type Error = crate::Error;
    fn try_from(parts: Parts) -> Result<Wire> {
        Wire::new(parts.form, parts.closed, parts.knots, parts.control_points)
    }
}

impl Wire {
    /// From its parts, all checked.
    ///
    /// Open: n + 4 knots, clamped. Closed: the n control points are given once, the first three follow again
    /// implicitly; n + 7 periodic knots, the curve runs from `knots[3]` to `knots[n + 3]`.
    ///
    /// # Errors
    /// [`crate::Error::Wire`] for counts that do not fit the form or each other, numbers that are not finite or out of
    /// range, negative widths, and knots that fall, crowd or do not have the layout above.
    pub fn new(form: Form, closed: bool, knots: Vec<f64>, control_points: Vec<[f64; 4]>) -> Result<Wire> {
        layout::check_count(form, closed, control_points.len())?;
        let knots = layout::validate_knots(form, closed, control_points.len(), knots)?;
        check_control_points(&control_points)?;
        Ok(Wire { form, closed, knots, control_points })
    }

    /// With knots 0, 1, 2, … repeated as `form` asks.
    ///
    /// # Errors
    /// As [`Wire::new`].
    pub fn uniform(form: Form, closed: bool, control_points: Vec<[f64; 4]>) -> Result<Wire> {
        layout::check_count(form, closed, control_points.len())?;
        let knots = layout::uniform_knots(form, closed, control_points.len());
        Wire::new(form, closed, knots, control_points)
    }

    /// An open clamped spline with unit knot spans.
    ///
    /// # Errors
    /// As [`Wire::new`].
    pub fn open_uniform(control_points: Vec<[f64; 4]>) -> Result<Wire> {
        Wire::uniform(Form::Spline, false, control_points)
    }

    /// A closed periodic spline with unit knot spans.
    ///
    /// # Errors
    /// As [`Wire::new`].
    pub fn closed_uniform(control_points: Vec<[f64; 4]>) -> Result<Wire> {
        Wire::uniform(Form::Spline, true, control_points)
    }

    /// How the control points make the curve.
    pub fn form(&self) -> Form {
        self.form
    }

    /// Whether the curve is periodic.
    pub fn closed(&self) -> bool {
        self.closed
    }

    /// Open: n + 4 knots, clamped. Closed: n + 7, the curve runs from `knots[3]` to `knots[n + 3]`.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// `[x, y, z, width]` in world units.
    pub fn control_points(&self) -> &[[f64; 4]] {
        &self.control_points
    }

    /// Moves the control points; their number and the knots stay.
    ///
    /// # Errors
    /// [`crate::Error::Wire`], and nothing changed, for another number of points, numbers that are not finite or out of
    /// range, or negative widths.
    pub fn set_control_points(&mut self, control_points: &[[f64; 4]]) -> Result<()> {
        if control_points.len() != self.control_points.len() {
            return Err(wire_error(
                format!("{} control points given for {}", control_points.len(), self.control_points.len()),
                "give as many as there are",
            ));
        }
        check_control_points(control_points)?;
        self.control_points.copy_from_slice(control_points);
        Ok(())
    }

    /// Parameters at which the curve starts and ends.
    pub fn domain(&self) -> (f64, f64) {
        (self.knots[3], self.knots[self.last_knot()])
    }

    /// The non-empty knot intervals, in order.
    pub fn spans(&self) -> impl DoubleEndedIterator<Item = Span> + '_ {
        (3..self.last_knot())
            .map(|k| Span { start: self.knots[k], end: self.knots[k + 1], first: k - 3 })
            .filter(|span| span.start < span.end)
    }

    /// `[x, y, z, width]` at `t`; beyond the domain open wires stay at their ends and closed ones go round.
    pub fn evaluate(&self, t: f64) -> [f64; 4] {
        self.derivative(t, 0)
    }

    /// Derivative of `order` with respect to the parameter, from the right where knots make it jump.
    pub fn derivative(&self, t: f64, order: usize) -> [f64; 4] {
        let t = self.into_domain(t);
        let k = self.find_span(t);
        self.combine(k, &basis::derivative(&self.knots, k, t, order))
    }

    /// Index of the knot at which the curve ends.
    fn last_knot(&self) -> usize {
        self.knots.len() - 4
    }

    fn into_domain(&self, t: f64) -> f64 {
        let (start, end) = self.domain();
        if self.closed && !(start..=end).contains(&t) {
            start + (t - start).rem_euclid(end - start)
        } else {
            t.clamp(start, end)
        }
    }

    /// Knot index of the span that holds `t` (half open; the last one includes its end).
    fn find_span(&self, t: f64) -> usize {
        let last = self.last_knot();
        let mut k = 2 + self.knots[3..last].partition_point(|&knot| knot <= t).max(1);
        // At the very end of a closed wire whose start knot is repeated the last intervals may be empty.
        while self.knots[k] == self.knots[k + 1] {
            k -= 1;
        }
        k
    }

    /// Weighted sum of the four control points of span `k`.
    fn combine(&self, k: usize, weights: &[f64; 4]) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for (i, weight) in weights.iter().enumerate() {
            let point = self.control_points[(k - 3 + i) % self.control_points.len()];
            for c in 0..4 {
                sum[c] += weight * point[c];
            }
        }
        sum
    }
}

fn check_control_points(control_points: &[[f64; 4]]) -> Result<()> {
    for (i, point) in control_points.iter().enumerate() {
        if point.iter().any(|x| !x.is_finite()) {
            return Err(wire_error(format!("control point {i} is not finite"), "give four plain numbers a point"));
        }
        if point.iter().any(|x| x.abs() > MAX_COORDINATE) {
            return Err(wire_error(format!("control point {i} is far outside the unit ball"), "scale the wire down"));
        }
        if point[3] < 0.0 {
            return Err(wire_error(format!("control point {i} has a negative width"), "use widths of 0 or more"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
