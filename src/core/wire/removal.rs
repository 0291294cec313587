//! Knot removal, the inverse of insertion: fewer control points, nearly the same curve.

use super::{Form, MIN_CONTROL_POINTS, Wire};
use crate::Result;

/// Fewest control points that removal leaves.
const LEAST: usize = 2 * MIN_CONTROL_POINTS;

impl Wire {
    /// The wire without the knots that it can do without: the curve moves by at most `tolerance` (world units, widths as
    /// positions) from where it was. The knot whose loss shows least goes first (Tiller 1992); how far the curve may have
    /// moved already is kept with each control point, so that errors do not add up. Ends stay, and so does an eighth
    /// control point. Chains and bags stay as they are.
    ///
    /// # Errors
    /// As [`Wire::new`].
    pub fn without_spare_knots(&self, tolerance: f64) -> Result<Wire> {
        if self.form != Form::Spline || tolerance.is_nan() || tolerance <= 0.0 {
            return Ok(self.clone());
        }
        let mut thinning = Thinning::new(self);
        while thinning.points.len() > LEAST {
            let Some(loss) = thinning.least_loss(tolerance) else { break };
            thinning.remove(loss);
        }
        Wire::new(self.form, self.closed, thinning.knots, thinning.points)
    }
}

impl Wire {
    /// Without the knot in the middle of what control point `index` pulls, and how far the curve may have moved; `None` where that
    /// may not go.
    pub(super) fn without_point(&self, index: usize) -> Option<Result<(Wire, f64)>> {
        let mut thinning = Thinning::new(self);
        let loss = thinning.losses.get(index.checked_sub(1)?).copied().flatten()?;
        thinning.remove(loss);
        Some(Wire::new(self.form, self.closed, thinning.knots, thinning.points).map(|wire| (wire, loss.error)))
    }
}

/// A wire that loses knots.
struct Thinning {
    closed: bool,
    knots: Vec<f64>,
    points: Vec<[f64; 4]>,
    /// How far the curve may have moved already near each control point.
    moved: Vec<f64>,
    /// What each removal would cost; computed anew where something nearby has changed.
    losses: Vec<Option<Loss>>,
}

/// A knot that may go: control points `first..first + 3` become two.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Loss {
    first: usize,
    become_two: [[f64; 4]; 2],
    error: f64,
}

impl Thinning {
    fn new(wire: &Wire) -> Thinning {
        let count = wire.control_points.len();
        let mut thinning = Thinning {
            closed: wire.closed,
            knots: wire.knots.clone(),
            points: wire.control_points.clone(),
            moved: vec![0.0; count],
            losses: Vec::new(),
        };
        thinning.losses = (0..count).map(|first| thinning.loss(first)).collect();
        thinning
    }

    /// What it costs to remove the knot in the middle of control points `first..first + 3`, `None` where there is none that
    /// may go. Its neighbours to the left and right each say what the two new points should be; they differ by the error.
    #[inline(never)]
    fn loss(&self, first: usize) -> Option<Loss> {
        let count = self.points.len();
        // Control points 0 and last of an open wire are its ends. Those round the seam of a closed one stay.
        let removable = if self.closed { 4..count.saturating_sub(6) } else { 1..count.saturating_sub(3) };
        if !removable.contains(&first) {
            return None;
        }
        let knot = self.knots[first + 3];
        if self.knots[first + 2] == knot || self.knots[first + 4] == knot {
            return None;
        }
        let share = |i: usize| (knot - self.knots[i]) / (self.knots[i + 4] - self.knots[i]);
        let [before, a, b, c, after] = std::array::from_fn(|k| self.points[(first + count + k - 1) % count]);
        let (left, middle, right) = (share(first), share(first + 1), share(first + 2));
        let from_left: [f64; 4] = std::array::from_fn(|k| (a[k] - (1.0 - left) * before[k]) / left);
        let from_right: [f64; 4] = std::array::from_fn(|k| (c[k] - right * after[k]) / (1.0 - right));
        let met: [f64; 4] = std::array::from_fn(|k| middle * from_right[k] + (1.0 - middle) * from_left[k]);
        let error = (0..4).map(|k| (met[k] - b[k]).powi(2)).sum::<f64>().sqrt();
        let become_two = [from_left, from_right].map(|point| [point[0], point[1], point[2], point[3].max(0.0)]);
        error.is_finite().then_some(Loss { first, become_two, error })
    }

    /// The removal that shows least, if it stays within `tolerance` of where the curve began.
    fn least_loss(&self, tolerance: f64) -> Option<Loss> {
        let fits = |loss: &&Loss| loss.error + self.moved_near(loss.first) <= tolerance;
        self.losses.iter().flatten().filter(fits).min_by(|a, b| a.error.total_cmp(&b.error)).copied()
    }

    /// How far the curve may have moved wherever the middle one of control points `first..first + 3` has a say.
    fn moved_near(&self, first: usize) -> f64 {
        let near = first.saturating_sub(2)..self.moved.len().min(first + 5);
        self.moved[near].iter().copied().fold(0.0, f64::max)
    }

    fn remove(&mut self, Loss { first, become_two, error }: Loss) {
        let moved = error + self.moved_near(first);
        self.points.remove(first + 2);
        self.points[first..first + 2].copy_from_slice(&become_two);
        self.moved.remove(first + 2);
        self.moved[first..first + 2].fill(moved);
        self.knots.remove(first + 3);
        self.losses.remove(first + 2);
        for near in first.saturating_sub(6)..self.points.len().min(first + 6) {
            self.losses[near] = self.loss(near);
        }
        // Those behind have moved up by one.
        for (place, loss) in self.losses.iter_mut().enumerate().skip(first + 6) {
            if let Some(loss) = loss {
                loss.first = place;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::{distance, new_knots, random_wire};
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    /// Largest distance of the same parameter's points.
    fn apart(a: &Wire, b: &Wire) -> f64 {
        let (start, end) = a.domain();
        assert_eq!((start, end), b.domain());
        (0..=2000)
            .map(|i| start + (end - start) * f64::from(i) / 2000.0)
            .fold(0.0, |most, t| most.max(distance(&a.evaluate(t), &b.evaluate(t))))
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn what_was_inserted_goes_again_and_the_curve_stays(seed in 0u64..1000, closed: bool) {
            let wire = random_wire(Form::Spline, closed, 24, seed);
            let knots = new_knots(&wire, 9, &mut Rng::new(seed, 3));
            let (finer, _) = wire.insert_knots(&knots).unwrap();
            let thinned = finer.without_spare_knots(1e-7).unwrap();
            proptest::prop_assert!(apart(&finer, &thinned) <= 1e-7);
            let (least, was) = (thinned.control_points().len(), finer.control_points().len());
            // Those next to a closed wire's seam stay.
            proptest::prop_assert!(least + if closed { 4 } else { 9 } <= was, "{least} of {was}");
        }

        #[test]
        fn the_curve_stays_within_the_tolerance(seed in 0u64..1000, closed: bool, tolerance in 1e-4f64..0.2) {
            let wire = random_wire(Form::Spline, closed, 40, seed);
            let thinned = wire.without_spare_knots(tolerance).unwrap();
            proptest::prop_assert!(apart(&wire, &thinned) <= tolerance + 1e-12);
            proptest::prop_assert!(thinned.control_points().len() >= LEAST);
        }
    }

    #[test]
    fn a_straight_stretch_needs_few_points_and_a_bend_keeps_them() {
        let bent = |i: i32| {
            if i < 60 { [f64::from(i) * 0.02, 0.0, 0.0, 0.02] } else { [1.2, 0.02 * f64::from(i - 60), 0.0, 0.02] }
        };
        let wire = Wire::open_uniform((0..120).map(bent).collect()).unwrap();
        let thinned = wire.without_spare_knots(1e-3).unwrap();
        assert!(thinned.control_points().len() < 40, "{}", thinned.control_points().len());
        let corner = |wire: &Wire| wire.control_points().iter().filter(|p| (p[0] - 1.2).hypot(p[1]) < 0.1).count();
        let whole = |wire: &Wire| wire.control_points().len();
        assert!(corner(&thinned) * whole(&wire) > corner(&wire) * whole(&thinned), "points stay where it bends");
    }

    #[test]
    fn other_forms_and_no_tolerance_leave_it_as_it_is() {
        let spline = random_wire(Form::Spline, true, 20, 1);
        for tolerance in [0.0, -1.0, f64::NAN] {
            assert_eq!(spline.without_spare_knots(tolerance).unwrap(), spline);
        }
        let chain = random_wire(Form::Chain, false, 20, 1);
        assert_eq!(chain.without_spare_knots(1.0).unwrap(), chain);
    }
}
