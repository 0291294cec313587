//! Control points anew, at even steps along the wire.

use super::{Form, MAX_CONTROL_POINTS, Wire, with_open_hairpins};
use crate::Result;

/// Pieces of a span between which its arc length is taken for straight.
const PIECES: usize = 16;
/// Rounds of the interpolation: each leaves at most two thirds of the error.
const ROUNDS: usize = 40;
/// Fewest control points: below, a closed wire can hardly be round.
const LEAST: usize = 8;

impl Wire {
    /// Nearly the same curve with control points about `spacing_world` apart along it (at least 8) and knots 0, 1, 2, …: the
    /// new wire meets the old one at its Greville points, which are evenly spaced. Where it turns back in a cusp, the new one
    /// has a bend of `hairpin_world` (0 leaves cusps). Chains and bags stay as they are.
    ///
    /// The interpolation is progressive iterative approximation (Lin, Wang and Dong 2004).
    ///
    /// # Errors
    /// As [`Wire::new`].
    pub fn respaced(&self, spacing_world: f64, hairpin_world: f64) -> Result<Wire> {
        if self.form != Form::Spline {
            return Ok(self.clone());
        }
        let track = Track::new(self, hairpin_world);
        let pieces = track.length() / spacing_world;
        let ends = if self.closed { 0 } else { 3 };
        let count = if pieces.is_finite() { pieces.round() as usize + ends } else { 0 };
        let count = count.clamp(LEAST, MAX_CONTROL_POINTS);
        let mut wire = Wire::uniform(self.form, self.closed, vec![[0.0; 4]; count])?;
        let (start, end) = wire.domain();
        // The Greville points of control points i, mean of the knots that it is about.
        let places: Vec<f64> = (0..count).map(|i| wire.knots[i + 1..i + 4].iter().sum::<f64>() / 3.0).collect();
        let wanted: Vec<[f64; 4]> = places.iter().map(|t| track.at((t - start) / (end - start))).collect();
        let mut points = wanted.clone();
        for _ in 0..ROUNDS {
            wire.control_points.copy_from_slice(&points);
            for (point, (&t, want)) in points.iter_mut().zip(places.iter().zip(&wanted)) {
                let there = wire.evaluate(t);
                for c in 0..4 {
                    point[c] += want[c] - there[c];
                }
            }
        }
        points.iter_mut().for_each(|point| point[3] = point[3].max(0.0));
        wire.set_control_points(&points)?;
        Ok(wire)
    }
}

/// A curve as a polyline, by arc length.
struct Track {
    closed: bool,
    points: Vec<[f64; 4]>,
    along: Vec<f64>,
}

impl Track {
    fn new(wire: &Wire, hairpin_world: f64) -> Track {
        let pieces = wire.spans().flat_map(|span| (0..PIECES).map(move |j| span.at(j as f64 / PIECES as f64)));
        let end = (!wire.closed).then(|| wire.domain().1);
        let points: Vec<[f64; 4]> = pieces.chain(end).map(|t| wire.evaluate(t)).collect();
        let mut points = with_open_hairpins(&points, wire.closed, hairpin_world);
        points.extend(wire.closed.then(|| points[0]));
        let mut track = Track { closed: wire.closed, points, along: vec![0.0] };
        let mut total = 0.0;
        for pair in track.points.windows(2) {
            total += (0..3).map(|c| (pair[1][c] - pair[0][c]).powi(2)).sum::<f64>().sqrt();
            track.along.push(total);
        }
        track
    }

    fn length(&self) -> f64 {
        self.along.last().copied().unwrap_or(0.0)
    }

    /// The point at a share of the length, going round where the curve is closed.
    fn at(&self, share: f64) -> [f64; 4] {
        let share = if self.closed { share.rem_euclid(1.0) } else { share.clamp(0.0, 1.0) };
        let along = share * self.length();
        let after = self.along.partition_point(|&a| a <= along).clamp(1, self.points.len() - 1);
        let (from, to) = (self.along[after - 1], self.along[after]);
        let part = if to > from { (along - from) / (to - from) } else { 0.0 };
        std::array::from_fn(|c| self.points[after - 1][c] + part * (self.points[after][c] - self.points[after - 1][c]))
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::distance;
    use super::*;

    fn wave(closed: bool, count: usize) -> Wire {
        let points = (0..count).map(|i| {
            // Crowded on one side.
            let a = (i as f64 / count as f64).powi(2) * std::f64::consts::TAU * if closed { 1.0 } else { 0.8 };
            [a.cos(), a.sin(), 0.3 * (2.0 * a).sin(), 0.02 + 0.01 * a.cos()]
        });
        Wire::uniform(Form::Spline, closed, points.collect()).unwrap()
    }

    #[test]
    fn the_curve_stays_and_its_points_become_even() {
        for closed in [false, true] {
            let wire = wave(closed, 80);
            let respaced = wire.respaced(0.05, 0.0).unwrap();
            let length = wire.length(1e-6);
            assert!((respaced.length(1e-6) - length).abs() < 2e-3 * length);
            assert_eq!(respaced.closed(), closed);
            let expected = (length / 0.05).round() as usize + if closed { 0 } else { 3 };
            assert_eq!(respaced.control_points().len(), expected);
            let (start, end) = respaced.domain();
            let track = Track::new(&wire, 0.0);
            let inner = if closed { 0 } else { 3 };
            let speeds: Vec<f64> = (inner..respaced.spans().count() - inner)
                .map(|i| {
                    let t = start + i as f64 + 0.5;
                    let point = respaced.evaluate(t);
                    let near = (0..4000).map(|k| distance(&point, &track.at(f64::from(k) / 4000.0)));
                    assert!(near.fold(f64::INFINITY, f64::min) < 2e-3, "off the curve at {t}");
                    let [x, y, z, _] = respaced.derivative(t, 1);
                    (x * x + y * y + z * z).sqrt()
                })
                .collect();
            assert!(end - start > 20.0);
            let (low, high) = speeds.iter().fold((f64::MAX, 0.0f64), |(low, high), &s| (low.min(s), high.max(s)));
            assert!(high / low < 1.1, "speeds from {low} to {high}");
            let crowded: Vec<f64> = (3..70).map(|i| wire.derivative(f64::from(i), 1)[0].hypot(0.0)).collect();
            assert!(crowded.iter().any(|s| *s < 0.2 * high), "the wave was uneven");
        }
    }

    #[test]
    fn wires_without_length_or_of_another_form_are_left_sound() {
        let dot = Wire::closed_uniform(vec![[0.1, 0.2, 0.3, 0.01]; 12]).unwrap();
        assert!(distance(&dot.respaced(0.05, 0.0).unwrap().evaluate(1.0), &[0.1, 0.2, 0.3, 0.01]) < 1e-9);
        assert!(dot.respaced(0.0, 0.0).is_ok() && dot.respaced(f64::NAN, f64::NAN).is_ok());
        let chain = Wire::uniform(Form::Chain, false, wave(false, 7).control_points().to_vec()).unwrap();
        assert_eq!(chain.respaced(0.05, 0.0).unwrap(), chain);
    }
}
