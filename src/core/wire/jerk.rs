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

    /// The map to `√D C'''`, one row a span.
    pub fn rows(&self) -> &LinearMap<R> {
        &self.rows
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
        let mut squares = [R::zero(); 4];
        for i in 0..self.spans() {
            let jerk = self.rows.apply_row(i, points);
            let mut d_jerk = jerk;
            for c in 0..4 {
                squares[c] = squares[c] + jerk[c] * jerk[c];
                d_jerk[c] = two * weights[c] * jerk[c];
            }
            self.rows.apply_row_transpose(i, &d_jerk, d_points);
        }
        weights.iter().zip(squares).map(|(&weight, square)| weight * square).sum()
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

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::super::test_wires::{all_wires, new_knots, random_wire, splines};
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    const WEIGHTS: (f64, f64) = (0.7, 30.0);

    fn energy(wire: &Wire) -> f64 {
        Jerk::<f64>::new(wire).energy(wire.control_points(), WEIGHTS.0, WEIGHTS.1)
    }

    /// Quadrature of second derivatives' differences, a route that never takes a third derivative.
    fn by_quadrature(wire: &Wire) -> f64 {
        let mut sum = 0.0;
        for span in wire.spans() {
            let steps = 8;
            let step = span.width() / f64::from(steps);
            for i in 0..steps {
                // Inside the step, so that knots where C'' jumps stay outside.
                let at = |fraction: f64| wire.derivative(span.at((f64::from(i) + fraction) / f64::from(steps)), 2);
                let (before, after) = (at(0.1), at(0.9));
                for c in 0..4 {
                    let third = (after[c] - before[c]) / (0.8 * step);
                    sum += if c < 3 { WEIGHTS.0 } else { WEIGHTS.1 } * third * third * step;
                }
            }
        }
        sum
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn is_the_integral(seed in 0u64..1000) {
            for wire in all_wires(seed) {
                let (exact, numeric) = (energy(&wire), by_quadrature(&wire));
                proptest::prop_assert!((exact / numeric - 1.0).abs() < 1e-7, "{} {}", exact, numeric);
                let mut other = wire.clone();
                let points: Vec<_> = wire.control_points().iter().map(|p| p.map(|x| 1.001 * x)).collect();
                other.set_control_points(&points).unwrap();
                proptest::prop_assert!((energy(&other) / numeric - 1.0).abs() > 1e-4, "another wire differs");
            }
        }

        #[test]
        fn insertion_leaves_it(seed in 0u64..1000) {
            for wire in splines(seed) {
                let (finer, _) = wire.insert_knots(&new_knots(&wire, 6, &mut Rng::new(seed, 5))).unwrap();
                proptest::prop_assert!((energy(&finer) / energy(&wire) - 1.0).abs() < 1e-6);
                // The plain third difference of control points would not stay.
                let unit = |wire: &Wire| {
                    energy(&Wire::uniform(wire.form(), wire.closed(), wire.control_points().to_vec()).unwrap())
                };
                proptest::prop_assert!((unit(&finer) / unit(&wire) - 1.0).abs() > 1e-2);
            }
        }

        #[test]
        fn gradient_is_its_derivative(seed in 0u64..1000) {
            for wire in all_wires(seed) {
                let jerk = Jerk::<f64>::new(&wire);
                let points = wire.control_points().to_vec();
                let mut gradient = vec![[1.0; 4]; points.len()];
                let energy = jerk.energy_and_gradient(&points, WEIGHTS.0, WEIGHTS.1, &mut gradient);
                proptest::prop_assert!((energy / jerk.energy(&points, WEIGHTS.0, WEIGHTS.1) - 1.0).abs() < 1e-13);
                // It adds: take what was there away again.
                gradient.iter_mut().flatten().for_each(|d| *d -= 1.0);
                let mut rng = Rng::new(seed, 6);
                let direction: Vec<[f64; 4]> = points.iter().map(|_| [0; 4].map(|_| rng.range(-1.0, 1.0))).collect();
                let moved = |step: f64| -> f64 {
                    let points: Vec<_> =
                        points.iter().zip(&direction).map(|(p, d)| [0, 1, 2, 3].map(|c| p[c] + step * d[c])).collect();
                    jerk.energy(&points, WEIGHTS.0, WEIGHTS.1)
                };
                // A quadratic form: the central difference is exact for any step.
                let difference = (moved(0.5) - moved(-0.5)) / 1.0;
                let analytic: f64 = gradient.iter().flatten().zip(direction.iter().flatten()).map(|(g, d)| g * d).sum();
                let scale = moved(0.5) + moved(-0.5);
                proptest::prop_assert!((difference - analytic).abs() < 1e-11 * scale);
                proptest::prop_assert!((difference - 1.01 * analytic).abs() > 1e-11 * scale, "one per cent is noticed");
            }
        }
    }

    #[test]
    fn unit_knots_have_the_known_rows() {
        let jerk = Jerk::<f64>::new(&Wire::open_uniform(vec![[0.0; 4]; 9]).unwrap());
        let expected = [
            [-6.0, 10.5, -5.5, 1.0],
            [-1.5, 3.5, -3.0, 1.0],
            [-1.0, 3.0, -3.0, 1.0],
            [-1.0, 3.0, -3.0, 1.0],
            [-1.0, 3.0, -3.5, 1.5],
            [-1.0, 5.5, -10.5, 6.0],
        ];
        for (row, expected) in jerk.rows.rows().iter().zip(expected) {
            for (a, b) in row.weights.iter().zip(expected) {
                assert!((a - b).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn spacing_counts_with_the_inverse_fifth_power() {
        let wire = random_wire(Form::Spline, true, 11, 3);
        let knots = wire.knots().iter().map(|knot| knot * 2.0).collect();
        let wide = Wire::new(Form::Spline, true, knots, wire.control_points().to_vec()).unwrap();
        assert!((energy(&wide) * 32.0 / energy(&wire) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn weights_are_apart() {
        let wire = random_wire(Form::Spline, false, 11, 4);
        let jerk = Jerk::<f32>::new(&wire);
        let points: Vec<_> = wire.control_points().iter().map(|p| p.map(|x| x as f32)).collect();
        let mut gradient = vec![[0.0; 4]; points.len()];
        jerk.energy_and_gradient(&points, 1.0, 0.0, &mut gradient);
        assert!(gradient.iter().all(|d| d[3] == 0.0) && gradient.iter().any(|d| d[0] != 0.0));
        gradient.fill([0.0; 4]);
        jerk.energy_and_gradient(&points, 0.0, 1.0, &mut gradient);
        assert!(gradient.iter().all(|d| d[0] == 0.0) && gradient.iter().any(|d| d[3] != 0.0));
    }
}
