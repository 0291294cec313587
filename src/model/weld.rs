//! Corners in the same place become one.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Corners nearer than this along every axis are one; the points lie in the box from -1 to 1. A single-precision file
/// is precise to about a tenth of it.
const TOLERANCE: f64 = 1e-6;

/// Mixes the words of a cell; the map's order is never looked at.
#[derive(Default)]
struct Mix(u64);

impl Hasher for Mix {
    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 29
    }
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(byte.into()));
    }
    fn write_i32(&mut self, word: i32) {
        self.write_u64(word as u32 as u64);
    }
    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(23) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
}

/// For each point the lowest-numbered one that stands for all in its place.
pub(super) fn weld(points: &[[f64; 3]]) -> Vec<u32> {
    // Cells much larger than the tolerance: a point looks into a neighbour only if it lies at its border.
    const CELL: f64 = 8.0 * TOLERANCE;
    let mut first: HashMap<(i32, i32, i32), u32, BuildHasherDefault<Mix>> = HashMap::default();
    first.reserve(points.len() / 3);
    // Several points may share a cell: each knows the one before it.
    let mut before = vec![u32::MAX; points.len()];
    let mut standing = Vec::with_capacity(points.len());
    for (i, point) in points.iter().enumerate() {
        let low = point.map(|c| ((c - TOLERANCE) / CELL).floor() as i32);
        let high = point.map(|c| ((c + TOLERANCE) / CELL).floor() as i32);
        let mut found = u32::MAX;
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                for x in low[0]..=high[0] {
                    let mut at = first.get(&(x, y, z)).copied().unwrap_or(u32::MAX);
                    while at != u32::MAX {
                        let other = &points[at as usize];
                        if (0..3).all(|c| (other[c] - point[c]).abs() <= TOLERANCE) {
                            found = found.min(at);
                        }
                        at = before[at as usize];
                    }
                }
            }
        }
        if found == u32::MAX {
            found = i as u32;
            let [x, y, z] = point.map(|c| (c / CELL).floor() as i32);
            before[i] = first.insert((x, y, z), found).unwrap_or(u32::MAX);
        }
        standing.push(found);
    }
    standing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn the_same_place_is_found_across_cells() {
        let mut rng = Rng::new(3, 3);
        let places: Vec<[f64; 3]> = (0..500).map(|_| rng.in_ball(1.0)).collect();
        let mut points = places.clone();
        for _ in 0..4 {
            points.extend(places.iter().map(|p| p.map(|c| c + 0.9 * TOLERANCE * rng.range(-1.0, 1.0))));
        }
        let standing = weld(&points);
        assert!(standing.iter().enumerate().all(|(i, &to)| to as usize == i % places.len()));
        let apart: Vec<[f64; 3]> = (0..50).map(|i| [2.0 * TOLERANCE * f64::from(i), 0.0, 0.0]).collect();
        assert!(weld(&apart).iter().enumerate().all(|(i, &to)| to as usize == i), "what is apart stays apart");
    }
}
