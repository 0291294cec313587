//! Strands that lie on one another, moved apart a little: what coincides cannot push itself away.

use super::Path;
use crate::rng::Rng;

/// Distance along the path over which it is moved alike, in what it is moved by.
const ALIKE: f64 = 6.0;

/// Moves the path's points by up to about `reach_world` in directions drawn from the seed, each stretch of a few times that
/// length smoothly on its own.
pub fn jittered(path: &mut Path, reach_world: f64, seed: u64) {
    if reach_world <= 0.0 {
        return;
    }
    let mut rng = Rng::new(seed, 0x6a69_7474);
    let mut draw = || rng.in_ball(reach_world);
    let (mut from, mut to) = (draw(), draw());
    let mut along = 0.0;
    let mut before: Option<[f64; 4]> = None;
    for point in &mut path.points {
        let here = *point;
        if let Some(before) = before {
            along += (0..3).map(|c| (here[c] - before[c]).powi(2)).sum::<f64>().sqrt() / (ALIKE * reach_world);
        }
        before = Some(here);
        while along >= 1.0 {
            (from, to, along) = (to, draw(), (along - 1.0).min(1.0));
        }
        let share = along * along * (3.0 - 2.0 * along);
        for c in 0..3 {
            point[c] += from[c] + share * (to[c] - from[c]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coincident_strands_part_and_nothing_moves_far() {
        let there = (0..100).map(|i| f64::from(i) * 0.01);
        let points: Vec<[f64; 4]> = there.clone().chain(there.rev()).map(|x| [x, 0.0, 0.0, 0.02]).collect();
        let path = |seed| {
            let mut path = Path { points: points.clone(), closed: true };
            jittered(&mut path, 0.01, seed);
            path
        };
        let moved = path(3);
        let apart = |a: &[f64; 4], b: &[f64; 4]| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt();
        assert!(points.iter().zip(&moved.points).all(|(a, b)| apart(a, b) <= 0.02 && a[3] == b[3]));
        let parted = (0..100).filter(|&i| apart(&moved.points[i], &moved.points[199 - i]) > 1e-4).count();
        assert!(parted > 90, "{parted} of 100");
        assert!(moved.points.windows(2).all(|pair| apart(&pair[0], &pair[1]) < 0.02), "smoothly");
        assert_eq!(moved, path(3));
        assert_ne!(moved, path(4));
        let mut dot = Path { points: vec![[0.0; 4]; 3], closed: false };
        jittered(&mut dot, 0.0, 1);
        assert!(dot.points.iter().flatten().all(|c| c.is_finite()));
    }
}
