//! The one formula behind every map of the wire: the cubic blossom (polar form) over arbitrary knots.
//!
//! A cubic piece `f` has one symmetric, affine-in-each-argument function `F(a, b, c)` with `f(t) = F(t, t, t)`
//! (Ramshaw 1989). Points of the curve, Bézier control points `F(a, a, b)`, control points after knot insertion
//! `F(v₁, v₂, v₃)` and derivatives `6/(3-d)! F(δ, …, t)`, `δ` the unit vector, are all values of it.

/// An argument of the blossom.
#[derive(Debug, Clone, Copy)]
pub(super) enum Argument {
    /// A parameter value.
    At(f64),
    /// The unit vector of the parameter line: differentiates once.
    Direction,
}

impl Argument {
    /// The argument measured from `knot`.
    #[inline]
    fn minus(self, knot: f64) -> f64 {
        match self {
            Argument::At(t) => t - knot,
            Argument::Direction => 1.0,
        }
    }
}

/// Weights of control points `k-3..=k` in `F(a, b, c)` of the piece on the non-empty span `knots[k]..knots[k + 1]`.
///
/// Cox-de Boor's recurrence with an argument of its own at each level (the Oslo algorithm, Cohen, Lyche and Riesenfeld
/// 1980). All terms are convex when the arguments ascend along knots that refine `knots`, so nothing cancels.
/// Needs `3 <= k` and `k + 3 < knots.len()`.
#[inline]
pub(super) fn blossom(knots: &[f64], k: usize, arguments: [Argument; 3]) -> [f64; 4] {
    let mut weights = [1.0, 0.0, 0.0, 0.0];
    for (level, argument) in (1..=3).zip(arguments) {
        let mut carried = 0.0;
        for i in 0..level {
            let low = knots[k + 1 + i - level];
            let high = knots[k + 1 + i];
            let share = weights[i] / (high - low);
            weights[i] = carried - share * argument.minus(high);
            carried = share * argument.minus(low);
        }
        weights[level] = carried;
    }
    weights
}

/// Weights of the point at `t`.
#[inline]
pub(super) fn point(knots: &[f64], k: usize, t: f64) -> [f64; 4] {
    blossom(knots, k, [Argument::At(t); 3])
}

/// Weights of the derivative of `order` at `t`; zero above order 3.
pub(super) fn derivative(knots: &[f64], k: usize, t: f64, order: usize) -> [f64; 4] {
    use Argument::{At, Direction};
    // Directions last: there the knot differences are largest, which keeps short spans accurate.
    let (factor, arguments) = match order {
        0 => (1.0, [At(t); 3]),
        1 => (3.0, [At(t), At(t), Direction]),
        2 => (6.0, [At(t), Direction, Direction]),
        3 => (6.0, [Direction; 3]),
        _ => return [0.0; 4],
    };
    blossom(knots, k, arguments).map(|weight| factor * weight)
}

/// Weights of the four Bézier control points of the part `a..b` of span `k`.
pub(super) fn bezier(knots: &[f64], k: usize, a: f64, b: f64) -> [[f64; 4]; 4] {
    use Argument::At;
    [[a, a, a], [a, a, b], [a, b, b], [b, b, b]].map(|arguments| blossom(knots, k, arguments.map(At)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KNOTS: [f64; 12] = [0.0, 0.0, 0.0, 0.0, 0.7, 1.0, 2.5, 2.5, 4.0, 4.0, 4.0, 4.0];

    fn spans() -> impl Iterator<Item = usize> {
        (3..8).filter(|&k| KNOTS[k] < KNOTS[k + 1])
    }

    #[test]
    fn partition_of_unity_and_derivatives_that_sum_to_zero() {
        for k in spans() {
            for j in 0..=10 {
                let t = KNOTS[k] + (KNOTS[k + 1] - KNOTS[k]) * f64::from(j) / 10.0;
                let weights = point(&KNOTS, k, t);
                assert!(weights.iter().all(|&w| w >= 0.0));
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                for order in 1..=3 {
                    let weights = derivative(&KNOTS, k, t, order);
                    let scale = weights.iter().map(|w| w.abs()).sum::<f64>();
                    assert!(weights.iter().sum::<f64>().abs() <= 1e-14 * scale);
                }
            }
        }
    }

    #[test]
    fn partition_of_unity_fails_in_the_wrong_span() {
        // Knots of another span: still an affine combination, but no longer the non-negative basis.
        assert!(point(&KNOTS, 4, 2.0).iter().any(|&w| w < 0.0));
    }

    #[test]
    fn uniform_span_has_the_textbook_bezier_rows() {
        let knots: Vec<f64> = (0..8).map(f64::from).collect();
        let expected = [
            [1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0],
            [0.0, 2.0 / 3.0, 1.0 / 3.0, 0.0],
            [0.0, 1.0 / 3.0, 2.0 / 3.0, 0.0],
            [0.0, 1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0],
        ];
        for (row, expected) in bezier(&knots, 3, 3.0, 4.0).iter().zip(&expected) {
            for (a, b) in row.iter().zip(expected) {
                assert!((a - b).abs() < 1e-15);
            }
        }
        for (a, b) in derivative(&knots, 3, 3.2, 3).iter().zip([-1.0, 3.0, -3.0, 1.0]) {
            assert!((a - b).abs() < 1e-15);
        }
    }

    #[test]
    fn derivatives_match_central_differences() {
        let step = 1e-5;
        for k in spans() {
            let t = 0.37 * KNOTS[k] + 0.63 * KNOTS[k + 1];
            for order in 1..=3 {
                let low = derivative(&KNOTS, k, t - step, order - 1);
                let high = derivative(&KNOTS, k, t + step, order - 1);
                let exact = derivative(&KNOTS, k, t, order);
                for i in 0..4 {
                    let difference = (high[i] - low[i]) / (2.0 * step);
                    let scale = 1.0 + exact[i].abs();
                    assert!((difference - exact[i]).abs() < 1e-6 * scale, "order {order}: {difference} {}", exact[i]);
                }
                let off = (0..4).any(|i| ((high[i] - low[i]) / (2.0 * step) - 1.01 * exact[i]).abs() > 1e-4);
                assert!(off, "the comparison sees one per cent");
            }
        }
        assert_eq!(derivative(&KNOTS, 3, 0.1, 4), [0.0; 4]);
    }
}
