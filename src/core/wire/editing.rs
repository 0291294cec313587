//! What a hand does to a wire, a control point or a stretch of them at a time.

use super::layout::wire_error;
use super::{Form, Wire};
use crate::Result;

/// One thing done. Control points are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Edit {
    /// Puts a control point elsewhere.
    Move {
        /// Which.
        index: usize,
        /// x, y, z and full width, world units.
        to: [f64; 4],
    },
    /// One control point more behind another; the curve stays where it is.
    Insert {
        /// The one before it.
        after: usize,
    },
    /// One control point less; the curve stays as near as the knots that are left allow.
    Remove {
        /// Which.
        index: usize,
    },
    /// Takes a stretch half the way to where it bends least; its first and last control point stay.
    Smooth {
        /// The first.
        from: usize,
        /// The last.
        to: usize,
    },
    /// Lays a stretch on the straight line between its first and its last control point; widths stay.
    Straighten {
        /// The first.
        from: usize,
        /// The last.
        to: usize,
    },
}

/// What came of an edit.
#[derive(Debug, Clone, PartialEq)]
pub struct Edited {
    /// The wire.
    pub wire: Wire,
    /// The control point that a hand would hold now.
    pub held: usize,
    /// How far the curve may have moved though nobody moved it, world units.
    pub strayed: f64,
}

impl Wire {
    /// The wire after an edit.
    ///
    /// # Errors
    /// [`crate::Error::Wire`] for control points that are not there or may not go, for stretches with nothing between their ends,
    /// and as [`Wire::new`]. Chains and bags are refused: their joints are knots.
    pub fn edited(&self, edit: &Edit) -> Result<Edited> {
        if self.form != Form::Spline {
            return Err(wire_error("its pieces are joined by corners", "edit a wire that is one curve"));
        }
        let count = self.control_points.len();
        let there = |index: usize| match index < count {
            true => Ok(index),
            false => Err(wire_error(format!("there is no point {}", index + 1), format!("give 1 to {count}"))),
        };
        match *edit {
            Edit::Move { index, to } => {
                let mut points = self.control_points.clone();
                points[there(index)?] = to;
                Ok(Edited { wire: self.with_points(points)?, held: index, strayed: 0.0 })
            }
            Edit::Insert { after } => self.with_point_behind(there(after)?),
            Edit::Remove { index } => {
                let without = self.without_point(there(index)?);
                let (wire, strayed) = without.ok_or_else(|| {
                    wire_error(
                        format!("point {} holds an end or the seam", index + 1),
                        "take away one that is farther from it",
                    )
                })??;
                Ok(Edited { held: index.min(wire.control_points.len() - 1), wire, strayed })
            }
            Edit::Smooth { from, to } => {
                let stretch = self.stretch(there(from)?, there(to)?)?;
                Ok(Edited { wire: self.with_points(self.calmed(&stretch))?, held: from, strayed: 0.0 })
            }
            Edit::Straighten { from, to } => {
                let [first, last] = self.stretch(there(from)?, there(to)?)?;
                let mut points = self.control_points.clone();
                for k in first + 1..last {
                    let share =
                        (self.greville(k) - self.greville(first)) / (self.greville(last) - self.greville(first));
                    for c in 0..3 {
                        points[k][c] = (1.0 - share) * points[first][c] + share * points[last][c];
                    }
                }
                Ok(Edited { wire: self.with_points(points)?, held: from, strayed: 0.0 })
            }
        }
    }

    fn with_points(&self, points: Vec<[f64; 4]>) -> Result<Wire> {
        let mut wire = self.clone();
        wire.set_control_points(&points)?;
        Ok(wire)
    }

    /// In ascending order, with at least one between them.
    fn stretch(&self, from: usize, to: usize) -> Result<[usize; 2]> {
        let [first, last] = [from.min(to), from.max(to)];
        if last - first < 2 {
            return Err(wire_error("there is nothing between these points", "choose two that are farther apart"));
        }
        Ok([first, last])
    }

    /// The parameter at which a control point pulls most (Greville's abscissa).
    fn greville(&self, index: usize) -> f64 {
        self.knots[index + 1..=index + 3].iter().sum::<f64>() / 3.0
    }

    fn with_point_behind(&self, after: usize) -> Result<Edited> {
        // Behind the last one of an open wire there is nothing.
        let before = if self.closed { after } else { after.min(self.control_points.len() - 2) };
        let [here, next] = [self.greville(before), self.greville(before + 1)];
        let (start, end) = self.domain();
        let inside = |t: f64| if self.closed { start + (t - start).rem_euclid(end - start) } else { t };
        // Where a knot is already, a little beside it.
        let shares = [0.5, 0.4, 0.6, 0.3, 0.7];
        let mut refused = None;
        for knot in shares.map(|share| inside(here + share * (next - here))) {
            match self.insert_knots(&[knot]) {
                Ok((wire, _)) => {
                    // The point of which the new knot is the middle one.
                    let place =
                        wire.knots.iter().position(|&known| known == knot).map_or(before + 1, |k| k.saturating_sub(2));
                    return Ok(Edited { held: place % wire.control_points.len(), wire, strayed: 0.0 });
                }
                Err(error) => refused = Some(error),
            }
        }
        Err(refused.expect("all were tried"))
    }

    /// Its places between the ends halfway to where the sum of squared second differences is least, ends and what lies beyond them
    /// held: a symmetric system of five diagonals.
    fn calmed(&self, &[first, last]: &[usize; 2]) -> Vec<[f64; 4]> {
        let count = self.control_points.len() as isize;
        let at = |k: isize| match self.closed {
            true => k.rem_euclid(count) as usize,
            // Beyond an open end nothing pulls: it counts as if the wire went straight on.
            false => k.clamp(0, count - 1) as usize,
        };
        let points = &self.control_points;
        let inner = last - first - 1;
        const ROW: [f64; 5] = [1.0, -4.0, 6.0, -4.0, 1.0];
        let mut band = vec![[6.0, -4.0, 1.0]; inner];
        let mut right: Vec<[f64; 3]> = (0..inner as isize)
            .map(|i| {
                let k = first as isize + 1 + i;
                std::array::from_fn(|c| {
                    let held = |d: isize| !(0..inner as isize).contains(&(i + d));
                    (-2..=2).filter(|&d| held(d)).map(|d| -ROW[(d + 2) as usize] * points[at(k + d)][c]).sum()
                })
            })
            .collect();
        // LDLᵀ with two diagonals below the first.
        for i in 0..inner {
            let [pivot, one, two] = band[i];
            for (step, below) in [(1, one), (2, two)] {
                if i + step >= inner {
                    continue;
                }
                let factor = below / pivot;
                band[i + step][0] -= factor * below;
                if step == 1 {
                    band[i + 1][1] -= factor * two;
                }
                for c in 0..3 {
                    right[i + step][c] -= factor * right[i][c];
                }
            }
        }
        for i in (0..inner).rev() {
            for c in 0..3 {
                let later = |step: usize| right.get(i + step).map_or(0.0, |row| row[c]);
                right[i][c] = (right[i][c] - band[i][1] * later(1) - band[i][2] * later(2)) / band[i][0];
            }
        }
        let mut calmed = points.clone();
        for (point, calm) in calmed[first + 1..last].iter_mut().zip(&right) {
            for c in 0..3 {
                point[c] = 0.5 * (point[c] + calm[c]);
            }
        }
        calmed
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::{distance, random_wire};
    use super::*;
    use crate::few_cases::few_cases;

    fn apart(a: &Wire, b: &Wire) -> f64 {
        let (start, end) = a.domain();
        (0..=1000)
            .map(|i| start + (end - start) * f64::from(i) / 1000.0)
            .fold(0.0, |most, t| most.max(distance(&a.evaluate(t), &b.evaluate(t))))
    }

    fn roughness(wire: &Wire, [first, last]: [usize; 2]) -> f64 {
        let points = wire.control_points();
        let bend =
            |k: usize| (0..3).map(|c| (points[k - 1][c] - 2.0 * points[k][c] + points[k + 1][c]).powi(2)).sum::<f64>();
        (first..=last).map(bend).sum()
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn an_inserted_point_moves_nothing_and_goes_again(seed in 0u64..1000, closed: bool, after in 5usize..14) {
            let wire = random_wire(Form::Spline, closed, 24, seed);
            let more = wire.edited(&Edit::Insert { after }).unwrap();
            let count = wire.control_points().len();
            assert_eq!((more.wire.control_points().len(), more.strayed), (count + 1, 0.0));
            assert!(more.held.abs_diff(after) < 3);
            assert!(apart(&wire, &more.wire) < 1e-9);
            let less = more.wire.edited(&Edit::Remove { index: more.held }).unwrap();
            assert!(less.wire.control_points().len() == count && less.strayed < 1e-6, "{}", less.strayed);
            assert!(apart(&wire, &less.wire) < 1e-6);
        }

        #[test]
        fn what_is_taken_away_tells_how_far_the_curve_moved(seed in 0u64..1000, closed: bool, index in 6usize..16) {
            let wire = random_wire(Form::Spline, closed, 24, seed);
            let less = wire.edited(&Edit::Remove { index }).unwrap();
            assert!(apart(&wire, &less.wire) <= less.strayed + 1e-9);
        }

        #[test]
        fn a_smoothed_stretch_bends_less_and_the_rest_stays(seed in 0u64..1000, closed: bool, from in 2usize..8, longer in 2usize..12) {
            let (wire, to) = (random_wire(Form::Spline, closed, 24, seed), from + longer);
            let smooth = wire.edited(&Edit::Smooth { from, to }).unwrap().wire;
            assert!(roughness(&smooth, [from, to]) < roughness(&wire, [from, to]));
            let again = smooth.edited(&Edit::Smooth { from, to }).unwrap().wire;
            assert!(roughness(&again, [from, to]) < roughness(&smooth, [from, to]));
            let count = wire.control_points().len();
            for k in (0..=from).chain(to..count) {
                assert_eq!(smooth.control_points()[k], wire.control_points()[k]);
            }
            assert!((0..count).all(|k| smooth.control_points()[k][3] == wire.control_points()[k][3]));
        }

        #[test]
        fn a_straightened_stretch_is_straight(seed in 0u64..1000, closed: bool, from in 2usize..8, longer in 4usize..12) {
            let (wire, to) = (random_wire(Form::Spline, closed, 24, seed), from + longer);
            let straight = wire.edited(&Edit::Straighten { from: to, to: from }).unwrap().wire;
            let [a, b] = [from, to].map(|k| straight.control_points()[k]);
            let along: [f64; 3] = std::array::from_fn(|c| b[c] - a[c]);
            let long = along.iter().map(|c| c * c).sum::<f64>();
            for span in straight.spans().filter(|span| span.first >= from && span.first + 3 <= to) {
                let p = straight.evaluate(span.at(0.3));
                let share = (0..3).map(|c| (p[c] - a[c]) * along[c]).sum::<f64>() / long;
                let off = (0..3).map(|c| (p[c] - a[c] - share * along[c]).powi(2)).sum::<f64>().sqrt();
                assert!(off < 1e-9 && (0.0..=1.0).contains(&share), "{off} {share}");
            }
        }
    }

    #[test]
    fn what_cannot_be_is_said_and_changes_nothing() {
        let wire = random_wire(Form::Spline, false, 12, 3);
        for (edit, said) in [
            (Edit::Move { index: 15, to: [0.0; 4] }, "no point 16"),
            (Edit::Move { index: 1, to: [f64::NAN, 0.0, 0.0, 0.1] }, "finite"),
            (Edit::Move { index: 1, to: [0.0, 0.0, 0.0, -0.1] }, "width"),
            (Edit::Remove { index: 0 }, "an end"),
            (Edit::Smooth { from: 3, to: 4 }, "nothing between"),
            (Edit::Straighten { from: 3, to: 40 }, "no point 41"),
        ] {
            let refused = wire.edited(&edit).unwrap_err().to_string();
            assert!(refused.contains(said), "{edit:?}: {refused}");
        }
        let chain = random_wire(Form::Chain, false, 13, 3);
        assert!(chain.edited(&Edit::Insert { after: 2 }).unwrap_err().to_string().contains("corners"));
    }
}
