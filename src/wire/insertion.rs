//! Knot insertion: more control points, the very same curve.

use super::basis::{self, Argument};
use super::layout::{MIN_KNOT_SPACING, check_count, wire_error};
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
        // In a closed wire control points 3..n + 3 have their first knot inside the domain; they wrap round.
        let points = if self.closed { 3..count + 3 } else { 0..count };
        for j in points {
            let k = self.find_span(knots[j]);
            let arguments = [knots[j + 1], knots[j + 2], knots[j + 3]].map(Argument::At);
            rows[j % count] = Row { first: (k - 3) as u32, weights: basis::blossom(&self.knots, k, arguments) };
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
        sorted.sort_by(f64::total_cmp);
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
            let period = end - start;
            for i in 0..3 {
                knots[i] = knots[i + count] - period;
                knots[count + 4 + i] = knots[4 + i] + period;
            }
        }
        Ok(knots)
    }
}
