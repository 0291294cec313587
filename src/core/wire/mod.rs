//! The 4D wire itself: control points (x, y, z, width), knots, and the linear maps from them.
//!
//! Geometry is `f64`; the maps that fitting applies every iteration come in `f32` or `f64` ([`Real`]).
//! Everything rests on one formula, the blossom in `basis`: evaluation, Bézier conversion, sampling, insertion.

mod basis;
mod bezier;
mod editing;
mod forms;
mod hairpins;
mod insertion;
mod jerk;
mod layout;
mod length;
mod linear_map;
mod nodes;
mod removal;
mod respacing;
mod sampling;

pub use editing::{Edit, Edited};
pub use hairpins::with_open_hairpins;
pub use jerk::Jerk;
pub use layout::{MAX_CONTROL_POINTS, MAX_COORDINATE, MAX_KNOT, MIN_CONTROL_POINTS, MIN_KNOT_SPACING, Span};
pub use linear_map::{LinearMap, Real, Row};
pub use nodes::Nodes;

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
///
/// ```
/// use wire4d_core::wire::Wire;
///
/// # fn main() -> wire4d_core::Result<()> {
/// let square = [[1.0, 0.0, 0.0, 0.1], [0.0, 1.0, 0.0, 0.1], [-1.0, 0.0, 0.0, 0.1], [0.0, -1.0, 0.0, 0.1]];
/// let ring = Wire::closed_uniform(square.to_vec())?;
/// let (start, end) = ring.domain();
/// assert_eq!(end - start, 4.0, "a knot span a control point");
/// // A cubic B-spline stays inside its control points: where it passes one it has 2/3 of its distance.
/// let [x, y, _, width] = ring.evaluate(start);
/// assert!((x.hypot(y) - 2.0 / 3.0).abs() < 1e-12 && (width - 0.1).abs() < 1e-12);
/// assert!(Wire::closed_uniform(vec![[f64::NAN; 4]; 4]).is_err());
/// # Ok(())
/// # }
/// ```
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
        let t = self.clamp_or_wrap(t);
        let k = self.find_span(t);
        self.combine(k, &basis::derivative(&self.knots, k, t, order))
    }

    /// Index of the knot at which the curve ends.
    fn last_knot(&self) -> usize {
        self.knots.len() - 4
    }

    fn clamp_or_wrap(&self, t: f64) -> f64 {
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
pub(crate) mod test_wires;

#[cfg(test)]
mod tests {
    use super::test_wires::{all_wires, distance};
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    fn points(count: usize) -> Vec<[f64; 4]> {
        (0..count).map(|i| [i as f64 * 0.1, (i * i % 7) as f64 * 0.1, 0.3, 0.02]).collect()
    }

    #[test]
    fn open_wires_touch_their_end_points_and_stay_there_beyond() {
        let wire = Wire::open_uniform(points(9)).unwrap();
        assert_eq!(wire.knots(), [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 6.0, 6.0, 6.0]);
        assert_eq!(wire.domain(), (0.0, 6.0));
        assert_eq!(wire.spans().count(), 6);
        for (t, point) in [(0.0, 0), (-5.0, 0), (6.0, 8), (1e300, 8)] {
            assert!(distance(&wire.evaluate(t), &wire.control_points()[point]) < 1e-15);
        }
    }

    #[test]
    fn closed_wires_go_round() {
        let wire = Wire::closed_uniform(points(9)).unwrap();
        assert_eq!(wire.knots().len(), 16);
        assert_eq!(wire.domain(), (0.0, 9.0));
        assert_eq!(wire.spans().count(), 9);
        for t in [0.0, 0.3, 4.0, 8.7] {
            for order in 0..3 {
                let here = wire.derivative(t, order);
                assert!(distance(&here, &wire.derivative(t + 9.0, order)) < 1e-12);
                assert!(distance(&here, &wire.derivative(t - 18.0, order)) < 1e-12);
                assert!(distance(&here, &wire.derivative(t + 1.0, order)) > 1e-3, "another place is another point");
            }
        }
    }

    #[test]
    fn baseline_layouts_are_bezier_splines() {
        let chain = Wire::uniform(Form::Chain, false, points(7)).unwrap();
        assert_eq!(chain.knots(), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0]);
        let ring = Wire::uniform(Form::Chain, true, points(6)).unwrap();
        assert_eq!(ring.knots(), [-1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0]);
        let bag = Wire::uniform(Form::Bag, false, points(8)).unwrap();
        assert_eq!(bag.knots(), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0]);
        for wire in [chain, ring, bag] {
            assert_eq!(wire.spans().count(), 2);
            let second = wire.spans().nth(1).unwrap().first;
            assert!(distance(&wire.evaluate(1.0), &wire.control_points()[second]) < 1e-15);
        }
    }

    #[test]
    fn hostile_parts_are_refused_in_words() {
        let good = Wire::open_uniform(points(6)).unwrap();
        let with_point = |point: [f64; 4]| {
            let mut bad = points(6);
            bad[2] = point;
            bad
        };
        let new = |closed, knots: &[f64], points| Wire::new(Form::Spline, closed, knots.to_vec(), points);
        assert!(new(false, good.knots(), points(6)).is_ok());
        let mut cases = vec![
            (Wire::open_uniform(vec![]), "0 control points"),
            (Wire::open_uniform(points(3)), "3 control points"),
            (Wire::closed_uniform(vec![[0.0; 4]; 20_001]), "20001 control points"),
            (Wire::open_uniform(with_point([f64::NAN, 0.0, 0.0, 0.0])), "control point 2 is not finite"),
            (Wire::open_uniform(with_point([0.0, f64::INFINITY, 0.0, 0.0])), "control point 2 is not finite"),
            (Wire::open_uniform(with_point([0.0, 1e300, 0.0, 0.0])), "far outside"),
            (Wire::open_uniform(with_point([0.0, 0.0, 0.0, -1e-9])), "negative width"),
            (Wire::uniform(Form::Chain, false, points(6)), "whole number"),
            (Wire::uniform(Form::Chain, true, points(7)), "whole number"),
            (Wire::uniform(Form::Chain, true, points(3)), "3 control points"),
            (Wire::uniform(Form::Bag, false, points(6)), "whole number"),
            (Wire::uniform(Form::Bag, true, points(8)), "cannot be closed"),
            (Wire::new(Form::Chain, false, (0..11).map(f64::from).collect(), points(7)), "clamped"),
            (new(true, good.knots(), points(6)), "come with 10 knots"),
        ];
        for (knots, problem) in [
            (&[0.0; 10], "repeated too often"),
            (&[0.0, 0.0, 0.0, 0.0, 2.0, 1.0, 3.0, 3.0, 3.0, 3.0], "fall"),
            (&[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0, 3.0], "repeated too often"),
            (&[0.0, 0.0, 0.0, 0.0, 1.0, 3.0, 3.0, 3.0, 3.0, 3.0], "repeated too often"),
            (&[0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.1], "clamped"),
            (&[-1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0], "clamped"),
            (&[0.0, 0.0, 0.0, 0.0, 1.0, 1.0 + 1e-9, 3.0, 3.0, 3.0, 3.0], "nearly coincide"),
            (&[0.0, 0.0, 0.0, 0.0, 1.0, f64::NAN, 3.0, 3.0, 3.0, 3.0], "usable number"),
            (&[0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 1e9, 1e9, 1e9, 1e9], "usable number"),
        ] {
            cases.push((new(false, knots, points(6)), problem));
        }
        let mut knots: Vec<f64> = (0..13).map(f64::from).collect();
        assert!(new(true, &knots, points(6)).is_ok());
        knots[1] -= 0.25;
        cases.push((new(true, &knots, points(6)), "periodic"));
        cases.push((new(true, &[1.0; 13], points(6)), "repeated too often"));
        for (result, problem) in cases {
            let message = result.expect_err(problem).to_string();
            assert!(message.contains(problem), "{message} says {problem}");
        }
    }

    proptest::proptest! {
        #![proptest_config(proptest::test_runner::Config { cases: 2000, ..few_cases() })]
        /// Any knots that pass the check serve every operation, however they are repeated; many do not pass.
        #[test]
        fn what_is_accepted_works(form in 0usize..3, closed: bool, count in 3usize..13, seed: u64) {
            let mut rng = Rng::new(seed, 0);
            let form = [Form::Spline, Form::Chain, Form::Bag][form];
            let mut knots = vec![0.0; count + if closed { 7 } else { 4 }];
            let inside = if closed { 4..count + 4 } else { 4..count + 1 };
            let steps = [0.0, 0.0, 0.001, 1.0, 1.0, 3.0];
            for i in inside.clone() {
                knots[i] = knots[i - 1] + steps[rng.below(steps.len())];
            }
            if closed {
                layout::make_periodic(count, &mut knots);
            } else {
                let end = knots[count];
                knots[count..].fill(end);
            }
            if seed % 5 == 0 {
                let i = rng.below(knots.len());
                knots[i] = [f64::NAN, f64::INFINITY, -1.0, 1e-300, 1e300][rng.below(5)];
            }
            let Ok(wire) = Wire::new(form, closed, knots, points(count)) else { return Ok(()) };
            let middles: Vec<f64> = wire.spans().map(|span| span.at(0.5)).collect();
            let (finer, _) = wire.insert_knots(&middles).unwrap();
            for span in finer.spans() {
                for fraction in [0.0, 0.3, 0.999] {
                    let t = span.at(fraction);
                    proptest::prop_assert!(distance(&wire.evaluate(t), &finer.evaluate(t)) < 1e-12);
                }
            }
            let mut outputs = Vec::new();
            for map in [wire.bezier_map(), wire.sampling_map::<f32>(3, true).0] {
                map.apply(&vec![[1.0; 4]; count], &mut outputs);
                proptest::prop_assert!(outputs.iter().flatten().all(|x| (x - 1.0).abs() < 1e-4));
            }
            proptest::prop_assert!(wire.length(1e-9).is_finite());
            let mut gradient = vec![[0.0; 4]; count];
            let energy = Jerk::<f32>::new(&wire).energy_and_gradient(&outputs[..1].repeat(count), 1.0, 1.0, &mut gradient);
            proptest::prop_assert!(energy.is_finite() && gradient.iter().flatten().all(|d| d.is_finite()));
        }
    }

    #[test]
    fn setting_control_points_checks_and_changes_nothing_on_error() {
        let mut wire = Wire::open_uniform(points(6)).unwrap();
        let before = wire.clone();
        assert!(wire.set_control_points(&points(5)).is_err());
        assert!(wire.set_control_points(&[[0.0, f64::NAN, 0.0, 0.0]; 6]).is_err());
        assert_eq!(wire, before);
        wire.set_control_points(&[[0.5; 4]; 6]).unwrap();
        assert!(distance(&wire.evaluate(1.5), &[0.5; 4]) < 1e-15);
    }

    #[test]
    fn text_round_trip_is_exact_and_checked() {
        for wire in all_wires(5) {
            let text = serde_json::to_string(&wire).unwrap();
            assert_eq!(serde_json::from_str::<Wire>(&text).unwrap(), wire);
            assert!(serde_json::from_str::<Wire>(&text.replacen('[', "[7,", 1)).is_err(), "one knot too many");
        }
        assert_eq!(serde_json::to_string(&Form::Chain).unwrap(), "\"chain\"");
    }
}
