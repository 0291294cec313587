//! Arc length by adaptive Gauss-Legendre quadrature of the speed. Position only: width is no distance.

use super::{Wire, basis};

/// Nodes (positive half) and weights of the eight-point rule on [-1, 1] (Abramowitz and Stegun, table 25.4).
const GAUSS_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// Halvings at which a cusp is as short as rounding errors.
const MAX_DEPTH: u32 = 40;

impl Wire {
    /// Arc length in world units, to within `accuracy` in all (limited by rounding). Gaps of a bag do not count.
    pub fn length(&self, accuracy: f64) -> f64 {
        let (start, end) = self.domain();
        self.length_between(start, end, accuracy)
    }

    /// Arc length from parameter `from` to `to`, both kept inside the domain; 0 unless `from < to`.
    pub fn length_between(&self, from: f64, to: f64, accuracy: f64) -> f64 {
        let (start, end) = self.domain();
        let (from, to) = (from.max(start), to.min(end));
        let spans = || self.spans().filter(|span| span.start < to && span.end > from);
        let accuracy = if accuracy > 0.0 { accuracy / spans().count().max(1) as f64 } else { 0.0 };
        spans()
            .map(|span| {
                let (from, to) = (from.max(span.start), to.min(span.end));
                let points = basis::bezier(&self.knots, span.knot(), from, to)
                    .map(|weights| self.combine(span.knot(), &weights));
                Piece::new(&points).length(accuracy)
            })
            .sum()
    }
}

/// Velocity of a cubic Bézier over [0, 1], as a quadratic Bézier.
struct Piece {
    velocity: [[f64; 3]; 3],
}

impl Piece {
    fn new(points: &[[f64; 4]; 4]) -> Self {
        let difference = |i: usize| [0, 1, 2].map(|c| 3.0 * (points[i + 1][c] - points[i][c]));
        Piece { velocity: [difference(0), difference(1), difference(2)] }
    }

    fn length(&self, accuracy: f64) -> f64 {
        // No finer than rounding: the control polygon bounds the length.
        let bound = self.velocity.iter().map(norm).sum::<f64>() / 3.0;
        let accuracy = accuracy.max(1e-15 * bound);
        self.refine(0.0, 1.0, self.gauss(0.0, 1.0), accuracy, MAX_DEPTH)
    }

    fn refine(&self, from: f64, to: f64, whole: f64, accuracy: f64, depth: u32) -> f64 {
        let middle = 0.5 * (from + to);
        let (left, right) = (self.gauss(from, middle), self.gauss(middle, to));
        // The negation ends the search on NaN as well. The halves are far better than what this difference says.
        if depth == 0 || !((left + right - whole).abs() > accuracy) {
            return left + right;
        }
        self.refine(from, middle, left, 0.5 * accuracy, depth - 1)
            + self.refine(middle, to, right, 0.5 * accuracy, depth - 1)
    }

    fn gauss(&self, from: f64, to: f64) -> f64 {
        let (centre, half) = (0.5 * (from + to), 0.5 * (to - from));
        let sum: f64 =
            GAUSS_8.iter().map(|(x, w)| w * (self.speed(centre - half * x) + self.speed(centre + half * x))).sum();
        sum * half
    }

    fn speed(&self, s: f64) -> f64 {
        let r = 1.0 - s;
        let [a, b, c] = &self.velocity;
        norm(&[0, 1, 2].map(|i| r * r * a[i] + 2.0 * r * s * b[i] + s * s * c[i]))
    }
}

fn norm(v: &[f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}
