//! Jerk: the integral of the squared third derivative, exact over any knots.

use super::{LinearMap, Real, Row, Wire, basis};

/// `∫ |C'''|² dt` as a quadratic form in the control points, prepared once a knot vector.
///
/// `C'''` is constant on a span, so the integral is the sum of `D |C'''|²` over spans of length D, which is
/// `|6 (Z₃ - 3 Z₂ + 3 Z₁ - Z₀)|² / D⁵` in Bézier points: knot insertion leaves it as it was. It is not normalised:
/// knots h apart instead of 1 multiply it by `h⁻⁵`. For a mean over spans use unit knots at birth and the weight
/// `λ / spans` with the number of spans **at birth**; keep that weight when knots are inserted.
#[derive(Debug, Clone, PartialEq)]
pub struct Jerk<R> {
    /// Rows `√D C'''`, one a span.
    rows: LinearMap<R>,
}

impl<R: Real> Jerk<R> {
    /// For the knots of `wire`.
    pub fn new(wire: &Wire) -> Self {
        let rows = wire
            .spans()
            .map(|span| {
                let weights = basis::derivative(&wire.knots, span.knot(), span.start, 3);
                Row::from_f64(span.first, &weights.map(|weight| weight * span.width().sqrt()))
            })
            .collect();
        Jerk { rows: LinearMap::new(wire.control_points.len(), rows) }
    }

    /// Number of spans.
    pub fn spans(&self) -> usize {
        self.rows.rows().len()
    }

    /// `position_weight ∫|(x, y, z)'''|² + width_weight ∫|width'''|²` at the control points `points`; **adds** its
    /// gradient to `d_points`. Both have one entry a control point.
    pub fn energy_and_gradient(
        &self,
        points: &[[R; 4]],
        position_weight: R,
        width_weight: R,
        d_points: &mut [[R; 4]],
    ) -> R {
        let weights = [position_weight, position_weight, position_weight, width_weight];
        let two = R::one() + R::one();
        let mut energy = R::zero();
        for i in 0..self.spans() {
            let jerk = self.rows.apply_row(i, points);
            let mut d_jerk = jerk;
            for c in 0..4 {
                energy = energy + weights[c] * jerk[c] * jerk[c];
                d_jerk[c] = two * weights[c] * jerk[c];
            }
            self.rows.apply_row_transpose(i, &d_jerk, d_points);
        }
        energy
    }

    /// The energy alone.
    pub fn energy(&self, points: &[[R; 4]], position_weight: R, width_weight: R) -> R {
        (0..self.spans())
            .map(|i| {
                let [x, y, z, w] = self.rows.apply_row(i, points);
                position_weight * (x * x + y * y + z * z) + width_weight * w * w
            })
            .sum()
    }
}
