//! The smallest ball round points, and moving them so that it is the unit ball.

use glam::DVec3;

/// Centre of nearly the smallest ball round the points (Bădoiu and Clarkson 2003): ever smaller steps to the farthest.
fn centre(points: &[[f64; 3]]) -> DVec3 {
    const STEPS: u32 = 60;
    let (low, high) = points
        .iter()
        .map(|p| DVec3::from(*p))
        .fold((DVec3::MAX, DVec3::MIN), |(low, high), p| (low.min(p), high.max(p)));
    let mut centre = 0.5 * low + 0.5 * high;
    for step in 0..STEPS {
        centre += (farthest(points, centre) - centre) / f64::from(step + 3);
    }
    centre
}

fn farthest(points: &[[f64; 3]], from: DVec3) -> DVec3 {
    let mut best = (-1.0, from);
    for point in points {
        let point = DVec3::from(*point);
        let distance = point.distance_squared(from);
        if distance > best.0 {
            best = (distance, point);
        }
    }
    best.1
}

/// Moves and scales the points so that they lie in the unit ball and touch it. Points that all coincide stay.
pub fn fit_unit_ball(points: &mut [[f64; 3]]) {
    if points.is_empty() {
        return;
    }
    let centre = centre(points);
    let radius = farthest(points, centre).distance(centre);
    if radius > 0.0 && radius.is_finite() {
        // A hair inside, so that rounding leaves no corner outside.
        let scale = (1.0 - 1e-12) / radius;
        for point in points {
            *point = ((DVec3::from(*point) - centre) * scale).to_array();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn a_cap_of_a_ball_fills_the_unit_ball() {
        let mut rng = Rng::new(3, 1);
        let mut points: Vec<[f64; 3]> = (0..2000)
            .map(|_| DVec3::from(rng.in_ball(1.0)).normalize_or(DVec3::X))
            .filter(|p| p.y > -0.3)
            .map(|p| (7.0 * p + DVec3::new(100.0, -3.0, 5.0)).to_array())
            .collect();
        fit_unit_ball(&mut points);
        let lengths = points.iter().map(|p| DVec3::from(*p).length());
        let most = lengths.fold(0.0, f64::max);
        assert!(most <= 1.0 && most > 1.0 - 1e-9);
        let mean = points.iter().map(|p| DVec3::from(*p).length()).sum::<f64>() / points.len() as f64;
        assert!(mean > 0.97, "almost all corners lie on the smallest ball: {mean}");
    }

    #[test]
    fn a_point_stays() {
        let mut points = vec![[2.0, 3.0, 4.0]; 3];
        fit_unit_ball(&mut points);
        assert_eq!(points, [[2.0, 3.0, 4.0]; 3]);
        fit_unit_ball(&mut []);
    }
}
