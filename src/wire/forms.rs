//! The baseline forms from a wire, with as many degrees of freedom.

use super::{Form, Wire};
use crate::Result;

impl Wire {
    /// The wire in another form with the same number of control points, or the few less that make whole segments.
    ///
    /// Segments of equal parameter length pass through four points of the curve each, at 0, 1/3, 2/3 and 1, so a chain
    /// starts joined and a bag's segments start end to end. Widths stay within those of the wire. A closed wire becomes a
    /// closed chain but an open bag. To the wire's own form: a plain copy. To a spline: control points on the curve at
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
        Wire::uniform(form, closed, points)
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
