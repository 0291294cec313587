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
        // No finer than rounding and underflow allow, else the search would not end.
        let bound = self.velocity.iter().map(norm).sum::<f64>() / 3.0;
        let accuracy = accuracy.max(1e-14 * bound).max(1e-100);
        self.refine(0.0, 1.0, self.gauss(0.0, 1.0), accuracy, MAX_DEPTH)
    }

    fn refine(&self, from: f64, to: f64, whole: f64, accuracy: f64, depth: u32) -> f64 {
        let middle = 0.5 * (from + to);
        let (left, right) = (self.gauss(from, middle), self.gauss(middle, to));
        // The halves are far better than this difference says.
        if depth == 0 || (left + right - whole).abs() <= accuracy {
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

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::super::test_wires::{all_wires, new_knots, random_wire};
    use super::*;
    use crate::rng::Rng;
    use std::f64::consts::{PI, TAU};

    /// Length of a closed wire with control points on a circle, over that of the circle through its knots.
    fn circle_ratio(count: usize) -> f64 {
        let turn = TAU / count as f64;
        let points =
            (0..count).map(|i| [(i as f64 * turn).cos(), 0.2, (i as f64 * turn).sin(), i as f64 * 0.01]).collect();
        let radius = (2.0 + turn.cos()) / 3.0;
        Wire::closed_uniform(points).unwrap().length(1e-12) / (TAU * radius)
    }

    #[test]
    fn circle_like_wires_converge_to_the_circle() {
        let errors = [8, 16, 32, 64].map(|count| (circle_ratio(count) - 1.0).abs());
        assert!(errors[3] < 1e-6, "{errors:?}");
        for pair in errors.windows(2) {
            assert!(pair[0] / pair[1] > 12.0, "fourth order: {errors:?}");
        }
    }

    #[test]
    fn parabola_has_its_closed_form() {
        // y = x² from 0 to 1: (2 √5 + asinh 2) / 4.
        let points = vec![[0.0; 4], [1.0 / 3.0, 0.0, 0.0, 9.0], [2.0 / 3.0, 1.0 / 3.0, 0.0, 0.0], [1.0, 1.0, 0.0, 0.0]];
        let wire = Wire::open_uniform(points).unwrap();
        let exact = (2.0 * 5.0_f64.sqrt() + 2.0_f64.asinh()) / 4.0;
        assert!((wire.length(1e-13) - exact).abs() < 1e-12);
        assert!((wire.length(0.1) - exact).abs() < 0.1);
        assert!((wire.length(1e-13) - 1.001 * exact).abs() > 1e-12);
    }

    #[test]
    fn accuracy_is_kept_even_at_cusps() {
        // There and back on the same points: speed touches zero at the turns.
        let cusp =
            Wire::open_uniform([0.0, 0.5, 1.0, 0.5, 0.0, 0.7, 0.0].iter().map(|&x| [x, x * 0.3, 0.0, 0.0]).collect());
        for wire in all_wires(8).into_iter().chain(cusp) {
            let exact = wire.length(1e-13);
            for accuracy in [1e-2, 1e-4, 1e-7, 1e-10] {
                assert!((wire.length(accuracy) - exact).abs() <= accuracy);
            }
        }
        // Out to a half and back, in closed form: x = 3 s (1 - s) · 0.5 … extremes at the ends and the middle.
        let back = Wire::open_uniform(vec![[0.0; 4], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0; 4]]).unwrap();
        assert!((back.length(1e-12) - 1.5).abs() < 1e-12);
    }

    #[test]
    fn ranges_add_up_and_width_is_no_distance() {
        for wire in all_wires(9) {
            let (start, end) = wire.domain();
            let middle = start + 0.377 * (end - start);
            let sum = wire.length_between(start, middle, 1e-12) + wire.length_between(middle, end, 1e-12);
            assert!((sum - wire.length(1e-12)).abs() < 1e-11);
            assert_eq!(wire.length_between(middle, start, 1e-3), 0.0);
            assert_eq!(wire.length_between(end, end + 1.0, 1e-3), 0.0);
            let finer = wire.insert_knots(&new_knots(&wire, 5, &mut Rng::new(9, 9))).unwrap().0;
            assert!((finer.length(1e-12) - wire.length(1e-12)).abs() < 1e-11);
            let mut wide = wire.clone();
            let points: Vec<_> = wire.control_points().iter().map(|p| [p[0], p[1], p[2], 5.0 * p[3]]).collect();
            wide.set_control_points(&points).unwrap();
            assert_eq!(wide.length(1e-6), wire.length(1e-6));
        }
    }

    #[test]
    fn hostile_wires_and_accuracies_end() {
        let tiny = |scale: f64| {
            let wire = random_wire(Form::Spline, false, 40, 2);
            Wire::open_uniform(wire.control_points().iter().map(|p| p.map(|x| x.abs() * scale)).collect()).unwrap()
        };
        for wire in [tiny(1.0), tiny(1e-160), tiny(1e-310), tiny(0.0), tiny(5e3)] {
            for accuracy in [0.0, -1.0, f64::NAN, f64::INFINITY] {
                assert!(wire.length(accuracy).is_finite());
            }
            assert!(wire.length_between(f64::NAN, f64::NAN, 1e-3).is_finite());
        }
        let half = Wire::closed_uniform((0..12).map(|i| [(f64::from(i) * PI / 6.0).cos(), 0.0, 0.0, 0.0]).collect());
        assert!((half.unwrap().length(0.0) - 4.0 * (2.0 + (PI / 6.0).cos()) / 3.0).abs() < 1e-9);
    }
}
