//! The baseline forms from a wire, with as many degrees of freedom.

use super::{Form, Wire, layout};
use crate::Result;

impl Wire {
    /// The wire in another form with the same number of control points, or the few less that make whole segments.
    ///
    /// Segments of equal parameter length pass through four points of the curve each, at 0, 1/3, 2/3 and 1, so a chain
    /// starts joined and a bag's segments start end to end. Widths stay within those of the wire. The parameter runs over
    /// as long a range as the wire's, so that the same curve has the same jerk and a fit's smoothness weighs alike in
    /// every form. A closed wire becomes a closed chain but an open bag. To the wire's own form: a plain copy. To a spline: control points on the curve at
    /// equal parameters, which smooths.
    ///
    /// # Errors
    /// [`crate::Error::Wire`] if there are too few control points for the form.
    pub fn to_form(&self, form: Form) -> Result<Wire> {
        if form == self.form {
            return Ok(self.clone());
        }
        let closed = self.closed && form != Form::Bag;
        let count = form.fitting_count(closed, self.control_points.len());
        let (start, end) = self.domain();
        let at = |fraction: f64| self.evaluate(start + (end - start) * fraction);
        let mut points = Vec::with_capacity(count + 4);
        if form == Form::Spline {
            let steps = if closed { count } else { count - 1 };
            points.extend((0..count).map(|i| at(i as f64 / steps as f64)));
        } else {
            let segments = if form == Form::Bag { count / 4 } else { count / 3 };
            let kept = if form == Form::Bag { 4 } else { 3 };
            for segment in 0..segments {
                let through = [0.0, 1.0, 2.0, 3.0].map(|j| at((segment as f64 + j / 3.0) / segments as f64));
                points.extend_from_slice(&interpolating_bezier(&through)[..kept]);
            }
            if form == Form::Chain && !closed {
                points.push(at(1.0));
            }
        }
        let widths = || self.control_points.iter().map(|point| point[3]);
        let (least, most) = (widths().fold(f64::INFINITY, f64::min), widths().fold(0.0, f64::max));
        for point in &mut points {
            point[3] = point[3].clamp(least, most);
        }
        layout::check_count(form, closed, points.len())?;
        let mut knots = layout::uniform_knots(form, closed, points.len());
        // Both layouts begin at knots[3]; uniform ones there with 0.
        let last = knots[if closed { points.len() + 3 } else { points.len() }];
        knots.iter_mut().for_each(|knot| *knot = start + (end - start) * (*knot / last));
        Wire::new(form, closed, knots, points)
    }
}

/// Bézier points of the cubic through `through` at 0, 1/3, 2/3, 1.
fn interpolating_bezier(through: &[[f64; 4]; 4]) -> [[f64; 4]; 4] {
    let [a, b, c, d] = through;
    let inner = |near: &[f64; 4], next: &[f64; 4], third: &[f64; 4], far: &[f64; 4]| {
        [0, 1, 2, 3].map(|i| (-5.0 * near[i] + 18.0 * next[i] - 9.0 * third[i] + 2.0 * far[i]) / 6.0)
    };
    [*a, inner(a, b, c, d), inner(d, c, b, a), *d]
}

#[cfg(test)]
mod tests {
    use super::super::Jerk;
    use super::super::test_wires::{all_wires, distance};
    use super::*;

    #[test]
    fn baselines_have_as_many_points_and_follow_the_wire() {
        // A gentle helix, as smooth as what three spans a segment can follow.
        let points: Vec<_> =
            (0..61).map(|i| f64::from(i) * 0.1).map(|a| [a.cos(), 0.1 * a, a.sin(), 0.02 + 0.001 * a]).collect();
        for closed in [false, true] {
            let wire = Wire::uniform(Form::Spline, closed, points.clone()).unwrap();
            for (form, count) in [(Form::Chain, if closed { 60 } else { 61 }), (Form::Bag, 60)] {
                let other = wire.to_form(form).unwrap();
                assert_eq!((other.form(), other.control_points().len()), (form, count));
                assert_eq!(other.closed(), closed && form == Form::Chain);
                // Parameters stretch, so that equal fractions of the domains are equal places. The ends, where
                // clamped knots or the seam bend the parameter, stay out.
                let error = |shift: f64| {
                    (5..45)
                        .map(|i| (f64::from(i) + 0.3) / 50.0)
                        .map(|fraction| {
                            let at = |wire: &Wire, fraction: f64| {
                                let (start, end) = wire.domain();
                                wire.evaluate(start + (end - start) * fraction)
                            };
                            distance(&at(&wire, fraction), &at(&other, fraction + shift))
                        })
                        .fold(0.0, f64::max)
                };
                assert!(error(0.0) < 2e-3, "{form:?}: {}", error(0.0));
                assert!(error(0.01) > 1e-2);
            }
        }
    }

    #[test]
    fn the_same_curve_has_the_same_jerk_in_every_form() {
        // A circle: no clamped ends, where a spline has jerk of its own.
        let step = std::f64::consts::TAU / 60.0;
        let points: Vec<_> = (0..60).map(|i| f64::from(i) * step).map(|a| [a.cos(), a.sin(), 0.0, 0.02]).collect();
        let wire = Wire::closed_uniform(points).unwrap();
        let jerk = |wire: &Wire| Jerk::<f64>::new(wire).energy(wire.control_points(), 1.0, 0.0);
        for form in [Form::Chain, Form::Bag] {
            let other = wire.to_form(form).unwrap();
            assert_eq!(other.domain(), wire.domain());
            let ratio = jerk(&other) / jerk(&wire);
            assert!((0.8..1.25).contains(&ratio), "{form:?}: {ratio}");
            let unit = Wire::uniform(form, other.closed(), other.control_points().to_vec()).unwrap();
            assert!(jerk(&unit) > 50.0 * jerk(&wire), "{form:?}: with unit spans");
        }
    }

    #[test]
    fn every_form_turns_into_every_other_with_widths_in_range() {
        for wire in all_wires(4) {
            for form in [Form::Spline, Form::Chain, Form::Bag] {
                match wire.to_form(form) {
                    Ok(other) => {
                        let most = wire.control_points().iter().map(|p| p[3]).fold(0.0, f64::max);
                        assert!(other.control_points().iter().all(|p| p[3] > 0.0 && p[3] <= most));
                        assert!(wire.control_points().len() - other.control_points().len() < 4);
                    }
                    Err(error) => assert!(wire.control_points().len() < 8, "{error}"),
                }
            }
        }
        assert_eq!(all_wires(4)[0].to_form(Form::Chain).unwrap(), all_wires(4)[0]);
    }
}
