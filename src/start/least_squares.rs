//! The cubic B-spline nearest to a path, by least squares.

use super::Path;
use super::banded::Banded;
use super::path::{length, resampled};
use crate::error::{Error, Result};
use crate::wire::{MAX_CONTROL_POINTS, Wire};

/// How often points look for their nearest place on the wire anew.
const ROUNDS: usize = 3;

/// Points fitted for each control point, at least.
const POINTS_A_CONTROL: usize = 4;

/// The weight of an open path's two ends: they are met.
const END_WEIGHT: f64 = 1e3;

/// The closed (or clamped open) uniform cubic B-spline with `control_points` control points for which Σ |point - wire|²
/// over points along the path, plus `smoothing` times the second differences of control points, is least. `smoothing` is
/// relative: 1 weighs both alike; 1e-6 to 1e-4 only steadies the fit. Points start at their share of the path's length
/// and are then moved to the nearest place on the wire, three times over (Hoschek 1988). Width is fitted with the rest.
///
/// # Errors
/// [`Error::Wire`] if the path holds no two points or values that are not finite, and for a number of control points that
/// a wire cannot have.
pub fn fitted(path: &Path, control_points: usize, smoothing: f64) -> Result<Wire> {
    if path.points.len() < 2 || path.points.iter().flatten().any(|x| !x.is_finite()) || length(path) <= 0.0 {
        return Err(Error::wire("wire", "there is no path to fit it to", "use a longer path"));
    }
    // More than a wire may have is refused before anything of that size is made.
    let mut wire = super::wire_with(path, control_points.min(MAX_CONTROL_POINTS + 1))?;
    let count = path.points.len().max(POINTS_A_CONTROL * control_points);
    let points = resampled(path, count);
    let (start, end) = wire.domain();
    let steps = if path.closed { count } else { count - 1 } as f64;
    let mut places: Vec<f64> = (0..count).map(|i| start + (end - start) * i as f64 / steps).collect();
    for round in 0..=ROUNDS {
        if round > 0 {
            nearer(&wire, &points, &mut places);
        }
        let solved = least_squares(&wire, &points, &places, smoothing)?;
        wire.set_control_points(&solved)?;
    }
    Ok(wire)
}

/// Moves each place by a Newton step of the distance, at most half a span and never past its neighbours.
fn nearer(wire: &Wire, points: &[[f64; 4]], places: &mut [f64]) {
    let (start, end) = wire.domain();
    let (first, last) = if wire.closed() { (start - 0.5, end + 0.5) } else { (start, end) };
    let mut before = first;
    for i in 0..places.len() {
        let (at, tangent, bend) =
            (wire.evaluate(places[i]), wire.derivative(places[i], 1), wire.derivative(places[i], 2));
        let (mut slope, mut speed, mut curve) = (0.0, 0.0, 0.0);
        for c in 0..3 {
            let off = at[c] - points[i][c];
            slope += off * tangent[c];
            speed += tangent[c] * tangent[c];
            curve += off * bend[c];
        }
        // Where the distance bends the wrong way, the speed alone still points downhill.
        let step = -slope / (speed + curve).max(0.5 * speed).max(f64::MIN_POSITIVE);
        let next = places.get(i + 1).copied().unwrap_or(last);
        let place = (places[i] + step.clamp(-0.5, 0.5)).min(next).max(before);
        let end_point = !wire.closed() && (i == 0 || i + 1 == places.len());
        places[i] = if end_point { places[i] } else { place };
        before = places[i];
    }
}

/// Control points of the best wire whose points at `places` should be `points`: (AᵀA + μ G) P = AᵀQ.
fn least_squares(wire: &Wire, points: &[[f64; 4]], places: &[f64], smoothing: f64) -> Result<Vec<[f64; 4]>> {
    let count = wire.control_points().len();
    let mut system = Banded::new(count, wire.closed());
    let mut sides = vec![[0.0; 4]; count];
    for (i, (point, &place)) in points.iter().zip(places).enumerate() {
        let (first, weights) = basis(wire, place);
        let end_point = !wire.closed() && (i == 0 || i + 1 == points.len());
        let importance = if end_point { END_WEIGHT } else { 1.0 };
        system.add_square(first, &weights, importance);
        for (k, weight) in weights.iter().enumerate() {
            for c in 0..4 {
                sides[(first + k) % count][c] += importance * weight * point[c];
            }
        }
    }
    let differences = if wire.closed() { count } else { count - 2 };
    // A hair of it even where none is wanted: control points that no point needs are still somewhere.
    let smoothing = if smoothing.is_nan() { 0.0 } else { smoothing };
    let strength = smoothing.clamp(1e-9, 1e6) * points.len() as f64 / (6.0 * differences as f64);
    for first in 0..differences {
        system.add_square(first, &[1.0, -2.0, 1.0, 0.0], strength);
    }
    let no_fit = || Error::wire("wire", "the path cannot be fitted", "use fewer control points or more smoothing");
    let mut solved = system.solve(sides).ok_or_else(no_fit)?;
    for point in &mut solved {
        point[3] = point[3].max(0.0);
    }
    Ok(solved)
}

/// The first of the four control points that `place` depends on and their weights (Cox and de Boor).
fn basis(wire: &Wire, place: f64) -> (usize, [f64; 4]) {
    let knots = wire.knots();
    let (start, end) = wire.domain();
    let place = if wire.closed() { start + (place - start).rem_euclid(end - start) } else { place.clamp(start, end) };
    let spans = knots.len() - 7;
    // Uniform: the span is the whole part.
    let span = ((place - start) / (end - start) * spans as f64).floor().clamp(0.0, spans as f64 - 1.0) as usize;
    let k = span + 3;
    let mut weights = [1.0, 0.0, 0.0, 0.0];
    for degree in 1..4 {
        let mut carried = 0.0;
        for i in 0..degree {
            let (right, left) = (knots[k + i + 1], knots[k + 1 + i - degree]);
            let share = weights[i] / (right - left);
            weights[i] = carried + (right - place) * share;
            carried = (place - left) * share;
        }
        weights[degree] = carried;
    }
    (span, weights)
}

/// The farthest that a point of the path is from a wire that runs along it, world units: an upper bound, as each point is
/// compared only with the wire near where the last one was found.
pub fn fit_error(path: &Path, wire: &Wire) -> f64 {
    const A_SPAN: usize = 12;
    const WINDOW: usize = 6 * A_SPAN;
    let (start, end) = wire.domain();
    let count = A_SPAN * wire.spans().count();
    let sample = |i: usize| wire.evaluate(start + (end - start) * i as f64 / count as f64);
    let samples: Vec<[f64; 4]> = (0..=count).map(sample).collect();
    let controls = wire.control_points().len();
    let points = resampled(path, path.points.len().max(4 * controls));
    let to_piece = |point: &[f64; 4], i: usize| {
        let (a, b) = (&samples[i], &samples[i + 1]);
        let (mut dot, mut square) = (0.0, 0.0);
        for c in 0..3 {
            dot += (point[c] - a[c]) * (b[c] - a[c]);
            square += (b[c] - a[c]).powi(2);
        }
        let t = if square > 0.0 { (dot / square).clamp(0.0, 1.0) } else { 0.0 };
        (0..3).map(|c| (point[c] - a[c] - t * (b[c] - a[c])).powi(2)).sum::<f64>()
    };
    let mut last: Option<usize> = None;
    let mut worst: f64 = 0.0;
    for point in &points {
        let pieces = match last {
            None => 0..count,
            Some(last) => last + count - WINDOW.min(count / 2)..last + count + WINDOW.min(count / 2),
        };
        let mut best = (f64::INFINITY, 0);
        for piece in pieces {
            // An open wire's ends are not neighbours, but to look there does no harm.
            let distance = to_piece(point, piece % count);
            if distance < best.0 {
                best = (distance, piece % count);
            }
        }
        last = Some(best.1);
        worst = worst.max(best.0);
    }
    worst.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Turns of a spiral on a sphere, wobbling in width; closed it comes back inside.
    fn spiral(closed: bool, count: usize) -> Path {
        let points = (0..count)
            .map(|i| i as f64 / count as f64)
            .map(|s| {
                let (turn, height) =
                    if closed { (TAU * 12.0 * s, (TAU * s).cos()) } else { (TAU * 12.0 * s, 1.6 * s - 0.8) };
                let radius = if closed { 0.8 + 0.15 * (TAU * s).sin() } else { (1.0 - height * height).sqrt() };
                [radius * turn.cos(), 0.9 * height, radius * turn.sin(), 0.02 + 0.01 * (TAU * 3.0 * s).sin()]
            })
            .collect();
        Path { points, closed }
    }

    #[test]
    fn the_weights_are_the_wires() {
        for wire in [Wire::closed_uniform, Wire::open_uniform] {
            let wire = wire((0..9).map(|i| [f64::from(i * i % 7), f64::from(i), 0.5, 0.1]).collect()).unwrap();
            let (start, end) = wire.domain();
            for i in 0..=57 {
                let place = start + (end - start) * f64::from(i) / 57.0;
                let (first, weights) = basis(&wire, place);
                let at = wire.evaluate(place);
                for c in 0..4 {
                    let sum: f64 = (0..4).map(|k| weights[k] * wire.control_points()[(first + k) % 9][c]).sum();
                    assert!((sum - at[c]).abs() < 1e-12, "{place}");
                }
            }
        }
    }

    #[test]
    fn a_smooth_path_is_met_and_resampling_alone_is_not() {
        for closed in [false, true] {
            let path = spiral(closed, 3000);
            let wire = fitted(&path, 300, 1e-6).unwrap();
            assert_eq!((wire.control_points().len(), wire.closed()), (300, closed));
            let error = fit_error(&path, &wire);
            let without = fit_error(&path, &super::super::wire_with(&path, 300).unwrap());
            assert!(error < 1e-3 && without > 5.0 * error, "closed {closed}: {error} {without}");
            if !closed {
                for (place, point) in [(wire.domain().0, path.points[0]), (wire.domain().1, path.points[2999])] {
                    let at = wire.evaluate(place);
                    assert!((0..3).all(|c| (at[c] - point[c]).abs() < 1e-3), "the ends are met");
                }
            }
            assert!(wire.control_points().iter().all(|p| (0.005..0.035).contains(&p[3])));
        }
    }

    #[test]
    fn more_smoothing_gives_a_smoother_wire_and_a_larger_error() {
        let path = spiral(true, 2000);
        let [fine, smooth] = [1e-6, 1.0].map(|smoothing| fitted(&path, 200, smoothing).unwrap());
        assert!(fit_error(&path, &smooth) > 2.0 * fit_error(&path, &fine));
        assert!(smooth.length(1e-3) < fine.length(1e-3));
    }

    #[test]
    fn few_control_points_few_points_and_corners() {
        let square = |closed| Path {
            points: vec![[0.0; 4], [1.0, 0.0, 0.0, 0.1], [1.0, 1.0, 0.0, 0.1], [0.0, 1.0, 0.0, 0.0]],
            closed,
        };
        for closed in [false, true] {
            for count in [4, 5, 6, 7, 8, 9, 40] {
                let wire = fitted(&square(closed), count, 1e-5).unwrap();
                let error = fit_error(&square(closed), &wire);
                assert!(
                    error
                        < if count < 8 {
                            0.5
                        } else if count < 40 {
                            0.2
                        } else {
                            0.06
                        },
                    "{closed} {count}: {error}"
                );
                assert!(wire.control_points().iter().all(|p| p[3] >= 0.0));
            }
        }
        assert!(fitted(&square(true), 3, 0.0).is_err());
        assert!(fitted(&square(true), 1_000_000_000, 0.0).is_err());
        assert!(fitted(&Path::default(), 10, 0.0).is_err());
        assert!(fitted(&Path { points: vec![[0.5; 4]; 9], closed: true }, 10, 0.0).is_err());
        assert!(fitted(&Path { points: vec![[0.0; 4], [f64::NAN; 4]], closed: true }, 10, 0.0).is_err());
        assert!(fitted(&square(false), 10, f64::NAN).is_ok_and(|wire| fit_error(&square(false), &wire).is_finite()));
    }
}
