//! The paper's start: points spread evenly in a ball, joined by a short tour.

use super::Path;
use super::tour::short_tour;
use crate::rng::Rng;

/// A path through `count` points in the ball of `radius_world`, all of one width.
pub fn ball_path(count: usize, radius_world: f64, width_world: f64, closed: bool, seed: u64) -> Path {
    let points = ball_points(count, radius_world, seed);
    let order = short_tour(&points, closed);
    let points = order.into_iter().map(|i| points[i as usize]).map(|[x, y, z]| [x, y, z, width_world]).collect();
    Path { points, closed }
}

/// `count` points spread evenly in the ball.
pub fn ball_points(count: usize, radius_world: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut rng = Rng::new(seed, 1);
    spread_points(count, || rng.in_ball(radius_world))
}

/// `count` points spread evenly over what `candidate` draws from: each the best of several, the one farthest from all
/// points so far (Mitchell 1991). For very many points, where chance alone is even enough, fewer candidates.
pub(super) fn spread_points(count: usize, mut candidate: impl FnMut() -> [f64; 3]) -> Vec<[f64; 3]> {
    // About 4e7 distances at most.
    let candidates = (40_000_000 / (count * count).max(1)).clamp(1, 16);
    let mut points: Vec<[f64; 3]> = Vec::with_capacity(count);
    for _ in 0..count {
        let mut best = (candidate(), -1.0);
        for _ in 1..candidates {
            let candidate = candidate();
            let nearest = points.iter().map(|p| squared(p, &candidate)).fold(f64::INFINITY, f64::min);
            if nearest > best.1 {
                best = (candidate, nearest);
            }
        }
        points.push(best.0);
    }
    points
}

fn squared(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_lie_in_the_ball_evenly_and_repeat_with_the_seed() {
        let points = ball_points(200, 0.8, 3);
        assert!(points.iter().all(|p| squared(p, &[0.0; 3]) <= 0.64 + 1e-12));
        let closest = |points: &[[f64; 3]]| {
            (0..points.len())
                .flat_map(|i| (0..i).map(move |j| (i, j)))
                .map(|(i, j)| squared(&points[i], &points[j]).sqrt())
                .fold(f64::INFINITY, f64::min)
        };
        let mut rng = Rng::new(3, 1);
        let chance: Vec<_> = (0..200).map(|_| rng.in_ball(0.8)).collect();
        assert!(closest(&points) > 2.0 * closest(&chance));
        assert_eq!(points, ball_points(200, 0.8, 3));
        assert_ne!(points, ball_points(200, 0.8, 4));
    }

    #[test]
    fn any_count_is_fine() {
        for count in [0, 1, 2, 3, 4, 5] {
            assert_eq!(ball_path(count, 0.8, 0.01, false, 0).points.len(), count);
        }
    }
}
