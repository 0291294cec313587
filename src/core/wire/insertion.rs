//! Knot insertion: more control points, the very same curve.

use super::basis::{self, Argument};
use super::layout::{MIN_KNOT_SPACING, check_count, make_periodic, wire_error};
use super::{LinearMap, Row, Wire};
use crate::Result;

impl Wire {
    /// Inserts knots (in any order) strictly inside the domain: the same curve with more control points, and the map
    /// from the old control points to the new ones (use it on first moments too).
    ///
    /// A spline gains one control point a knot (Boehm 1980); a chain gains three and a bag four, since a new knot splits
    /// one of their segments in two. All knots go in at once by the Oslo algorithm; rows are non-negative, sum to 1
    /// and have at most four entries.
    ///
    /// # Errors
    /// [`crate::Error::Wire`] for a knot that is outside the domain, not finite or nearly on another one, and for more
    /// than [`super::MAX_CONTROL_POINTS`] points.
    pub fn insert_knots(&self, new_knots: &[f64]) -> Result<(Wire, LinearMap<f64>)> {
        let count_old = self.control_points.len();
        let repeat = self.form.multiplicity();
        let count = count_old + new_knots.len().saturating_mul(repeat);
        check_count(self.form, self.closed, count)?;
        let knots = self.refined_knots(new_knots, count)?;

        let mut rows = vec![Row { first: 0, weights: [0.0; 4] }; count];
        let end = self.domain().1;
        // In a closed wire control points 3..n + 3 have their first knot in the domain; they wrap round at n, as does a
        // first knot at the very end.
        for i in if self.closed { 3..count + 3 } else { 0..count } {
            let j = if knots[i] == end { i - count } else { i };
            let k = self.find_span(knots[j]);
            let arguments = [knots[j + 1], knots[j + 2], knots[j + 3]].map(Argument::At);
            rows[i % count] = Row { first: (k - 3) as u32, weights: basis::blossom(&self.knots, k, arguments) };
        }
        let map = LinearMap::new(count_old, rows);
        let mut control_points = Vec::new();
        map.apply(&self.control_points, &mut control_points);
        for point in &mut control_points {
            // A convex combination of widths ≥ 0, but for rounding.
            point[3] = point[3].max(0.0);
        }
        Ok((Wire::new(self.form, self.closed, knots, control_points)?, map))
    }

    /// The knot vector with `new_knots` merged in, for `count` control points.
    fn refined_knots(&self, new_knots: &[f64], count: usize) -> Result<Vec<f64>> {
        let (start, end) = self.domain();
        let repeat = self.form.multiplicity();
        let mut sorted = new_knots.to_vec();
        if sorted.iter().any(|&t| !(t > start && t < end)) {
            return Err(wire_error(
                "a new knot lies outside the wire",
                format!("insert strictly between {start} and {end}"),
            ));
        }
        sorted.sort_unstable_by(f64::total_cmp);
        let inside = &self.knots[3..=self.last_knot()];
        let crowded = |t: f64| {
            let above = inside.partition_point(|&knot| knot < t);
            inside[above] - t < MIN_KNOT_SPACING || t - inside[above - 1] < MIN_KNOT_SPACING
        };
        if sorted.iter().any(|&t| crowded(t)) || sorted.windows(2).any(|pair| pair[1] - pair[0] < MIN_KNOT_SPACING) {
            return Err(wire_error(
                "a new knot nearly coincides with another",
                format!("keep {MIN_KNOT_SPACING} between them"),
            ));
        }
        let mut knots = Vec::with_capacity(self.knots.len() + sorted.len() * repeat);
        let mut added = sorted.iter().peekable();
        for &knot in &self.knots {
            while let Some(&t) = added.next_if(|&&t| t < knot) {
                knots.extend(std::iter::repeat_n(t, repeat));
            }
            knots.push(knot);
        }
        if self.closed {
            make_periodic(count, &mut knots);
        }
        Ok(knots)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::super::test_wires::{all_wires, distance, new_knots, random_wire, splines};
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    /// Largest distance between two wires over the same domain, away from the knots where a bag jumps.
    fn error(a: &Wire, b: &Wire) -> f64 {
        let (start, end) = a.domain();
        (0..400)
            .map(|i| start + (end - start) * (f64::from(i) + 0.437) / 400.0)
            .map(|t| distance(&a.evaluate(t), &b.evaluate(t)))
            .fold(0.0, f64::max)
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn the_curve_stays(seed in 0u64..1000, count in 0usize..25) {
            for wire in all_wires(seed) {
                let knots = new_knots(&wire, count, &mut Rng::new(seed, 1));
                let (finer, map) = wire.insert_knots(&knots).unwrap();
                proptest::prop_assert_eq!(finer.domain(), wire.domain());
                proptest::prop_assert_eq!(finer.spans().count(), wire.spans().count() + count);
                proptest::prop_assert!(error(&wire, &finer) < 1e-12);
                for row in map.rows() {
                    proptest::prop_assert!(row.weights.iter().all(|&weight| weight >= -1e-15), "convex");
                    proptest::prop_assert!((row.weights.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                }
                let mut moved = finer.control_points().to_vec();
                moved.rotate_left(1);
                let mut other = finer.clone();
                other.set_control_points(&moved).unwrap();
                proptest::prop_assert!(error(&wire, &other) > 1e-9, "points out of place are noticed");
            }
        }

        #[test]
        fn splines_stay_smooth(seed in 0u64..1000) {
            for wire in splines(seed) {
                let (finer, _) = wire.insert_knots(&new_knots(&wire, 12, &mut Rng::new(seed, 2))).unwrap();
                // Anywhere on these knots, not only where the old curve was.
                let mut rng = Rng::new(seed, 3);
                let points: Vec<_> = finer.control_points().iter().map(|_| [0; 4].map(|_| rng.unit())).collect();
                let mut finer = finer;
                finer.set_control_points(&points).unwrap();
                let jumps = jumps(&finer);
                for order in 0..3 {
                    proptest::prop_assert!(jumps[order] < 1e-9, "order {}: {}", order, jumps[order]);
                }
                proptest::prop_assert!(jumps[3] > 1e-3, "the third derivative does jump");
            }
        }

        #[test]
        fn all_at_once_is_one_by_one(seed in 0u64..1000) {
            for wire in all_wires(seed) {
                let knots = new_knots(&wire, 7, &mut Rng::new(seed, 4));
                let (at_once, map) = wire.insert_knots(&knots).unwrap();
                let (mut one_by_one, mut composed) = (wire.clone(), dense(&wire.insert_knots(&[]).unwrap().1));
                for &t in &knots {
                    let (next, step) = one_by_one.insert_knots(&[t]).unwrap();
                    composed = product(&dense(&step), &composed);
                    one_by_one = next;
                }
                proptest::prop_assert_eq!(at_once.knots(), one_by_one.knots());
                let mut worst: f64 = 0.0;
                for (row, composed) in dense(&map).iter().zip(&composed) {
                    worst = row.iter().zip(composed).map(|(a, b)| (a - b).abs()).fold(worst, f64::max);
                    proptest::prop_assert!(composed.iter().filter(|weight| weight.abs() > 1e-15).count() <= 4);
                }
                proptest::prop_assert!(worst < 1e-13, "{}", worst);
            }
        }
    }

    /// Largest jump over knots of derivatives 0 to 3, relative to the size of the derivative.
    fn jumps(wire: &Wire) -> [f64; 4] {
        let spans: Vec<_> = wire.spans().collect();
        let mut pairs: Vec<_> = spans.windows(2).map(|pair| (pair[0], pair[1])).collect();
        if wire.closed() {
            pairs.push((spans[spans.len() - 1], spans[0]));
        }
        [0, 1, 2, 3].map(|order| {
            let mut worst: f64 = 0.0;
            for (left, right) in &pairs {
                let at = |k: usize, t| wire.combine(k, &basis::derivative(wire.knots(), k, t, order));
                let (before, after) = (at(left.knot(), left.end), at(right.knot(), right.start));
                let size = before.iter().chain(&after).fold(1.0, |size: f64, x| size.max(x.abs()));
                worst = worst.max(distance(&before, &after) / size);
            }
            worst
        })
    }

    fn dense(map: &LinearMap<f64>) -> Vec<Vec<f64>> {
        let row = |row: &Row<f64>| {
            let mut dense = vec![0.0; map.columns()];
            for (k, weight) in row.weights.iter().enumerate() {
                dense[(row.first as usize + k) % map.columns()] += weight;
            }
            dense
        };
        map.rows().iter().map(row).collect()
    }

    fn product(a: &[Vec<f64>], b: &[Vec<f64>]) -> Vec<Vec<f64>> {
        let entry = |row: &[f64], column: usize| row.iter().zip(b).map(|(x, b)| x * b[column]).sum();
        a.iter().map(|row| (0..b[0].len()).map(|column| entry(row, column)).collect()).collect()
    }

    #[test]
    fn middle_of_a_uniform_span_has_boehm_weights() {
        let wire = Wire::open_uniform(vec![[0.0; 4]; 12]).unwrap();
        let dense = dense(&wire.insert_knots(&[4.5]).unwrap().1);
        for (row, first, a) in [(5, 4, 5.0 / 6.0), (6, 5, 0.5), (7, 6, 1.0 / 6.0)] {
            assert!((dense[row][first] - (1.0 - a)).abs() < 1e-15);
            assert!((dense[row][first + 1] - a).abs() < 1e-15);
        }
        assert_eq!(dense[4][4], 1.0);
        assert_eq!(dense[8][7], 1.0);
    }

    #[test]
    fn extreme_spacing_stays_exact() {
        let mut wire = random_wire(Form::Spline, false, 9, 6);
        let original = wire.clone();
        // Halve towards one place until spans are as short as they may be.
        let place = 0.5 * (wire.spans().nth(2).unwrap().start + wire.spans().nth(2).unwrap().end) + 0.01;
        let widest = |wire: &Wire| wire.spans().find(|s| s.start <= place && place < s.end && s.width() > 4e-5);
        while let Some(span) = widest(&wire) {
            wire = wire.insert_knots(&[span.at(0.5)]).unwrap().0;
        }
        assert!(wire.control_points().len() > 20);
        assert!(error(&original, &wire) < 1e-12);
        assert!(jumps(&wire)[1] < 1e-7);
    }

    #[test]
    fn a_joint_breaks_a_chain_but_not_a_spline() {
        assert!(jumps(&random_wire(Form::Chain, false, 17, 1))[1] > 1e-2);
        assert!(jumps(&random_wire(Form::Spline, false, 17, 1))[1] < 1e-12);
    }

    #[test]
    fn bad_knots_are_refused() {
        let wire = random_wire(Form::Spline, false, 9, 1);
        let (start, end) = wire.domain();
        let middle = wire.spans().next().unwrap().at(0.5);
        let taken = wire.spans().nth(1).unwrap().start;
        assert!(wire.insert_knots(&[middle]).is_ok());
        for bad in [
            vec![start],
            vec![end],
            vec![end + 1.0],
            vec![f64::NAN],
            vec![f64::INFINITY],
            vec![taken],
            vec![taken + 1e-9],
            vec![middle, middle],
            vec![middle; 30_000],
        ] {
            assert!(wire.insert_knots(&bad).is_err(), "{:?}", &bad[..bad.len().min(3)]);
        }
    }
}
