//! Which strands come near each other: a grid of cells over the steps of a line.

use crate::Centreline;
use glam::{DVec3, IVec3};
use std::collections::HashMap;

/// Strands farther apart than so many gauges are not looked for.
pub const FAR_GAUGES: f64 = 8.0;

/// Along a half circle it is π/2 times as far as straight across: what is hardly farther is the next stretch of the same strand.
const A_TURN: f64 = 1.65;

/// Two steps of a line and how far apart their middles are, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// The step nearer to the start.
    pub first: usize,
    /// The other one.
    pub second: usize,
    /// Between the two, mm.
    pub distance_mm: f64,
}

/// Points by the cell that they lie in.
pub struct Grid {
    cells: HashMap<IVec3, Vec<u32>>,
    side: f64,
}

impl Grid {
    /// Of cells `side` wide.
    pub fn new(points: &[DVec3], side: f64) -> Grid {
        let mut cells: HashMap<IVec3, Vec<u32>> = HashMap::new();
        for (i, point) in points.iter().enumerate() {
            cells.entry(cell(*point, side)).or_default().push(i as u32);
        }
        Grid { cells, side }
    }

    /// Whatever may be nearer to `point` than the cells are wide.
    pub fn near(&self, point: DVec3) -> impl Iterator<Item = usize> + '_ {
        let middle = cell(point, self.side);
        let offsets = (0..27).map(move |i| middle + IVec3::new(i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1));
        offsets.filter_map(|at| self.cells.get(&at)).flatten().map(|&i| i as usize)
    }
}

fn cell(point: DVec3, side: f64) -> IVec3 {
    (point / side).floor().as_ivec3()
}

/// All pairs of steps nearer than `within_mm` that are more than `apart_mm` apart along the line,
/// and more than a half turn.
pub fn pairs(line: &Centreline, within_mm: f64, apart_mm: f64) -> Vec<Pair> {
    let (step, steps) = (line.step_mm(), line.steps());
    // A step reaches half its length from its middle, on both sides.
    let middles: Vec<DVec3> = (0..steps).map(|i| 0.5 * (line.point(i) + line.point(i + 1))).collect();
    let reach = within_mm + step;
    let grid = Grid::new(&middles, reach);
    let apart = (apart_mm / step).ceil() as usize;
    let mut found = Vec::new();
    for first in 0..steps {
        for second in grid.near(middles[first]) {
            let between = second.saturating_sub(first);
            let between = if line.closed() { between.min(steps - between) } else { between };
            if second <= first || between <= apart || middles[first].distance(middles[second]) > reach {
                continue;
            }
            let ends = |i: usize| [line.point(i), line.point(i + 1)];
            let distance_mm = between_segments(ends(first), ends(second));
            if distance_mm < within_mm && between as f64 * step > A_TURN * distance_mm {
                found.push(Pair { first, second, distance_mm });
            }
        }
    }
    found
}

/// The pair that is nearest, or `None` if all strands are more than [`FAR_GAUGES`] gauges apart.
pub fn nearest(line: &Centreline, apart_mm: f64) -> Option<Pair> {
    let mut gauges = 1.0;
    while gauges <= FAR_GAUGES {
        let found = pairs(line, gauges * line.gauge_mm(), apart_mm);
        let nearest = found.into_iter().min_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
        if nearest.is_some() {
            return nearest;
        }
        gauges *= 2.0;
    }
    None
}

/// Least distance of two segments (Ericson, *Real-Time Collision Detection*, 5.1.9).
fn between_segments([p, p_end]: [DVec3; 2], [q, q_end]: [DVec3; 2]) -> f64 {
    let (d, e, r) = (p_end - p, q_end - q, p - q);
    let (a, b, f) = (d.length_squared(), e.length_squared(), e.dot(r));
    if a <= 1e-18 || b <= 1e-18 {
        return r.length();
    }
    let (c, mixed) = (d.dot(r), d.dot(e));
    let denominator = a * b - mixed * mixed;
    let s = if denominator > 1e-12 * a * b { ((mixed * f - c * b) / denominator).clamp(0.0, 1.0) } else { 0.0 };
    let t = (mixed * s + f) / b;
    let (s, t) = match t {
        t if t < 0.0 => ((-c / a).clamp(0.0, 1.0), 0.0),
        t if t > 1.0 => (((mixed - c) / a).clamp(0.0, 1.0), 1.0),
        t => (s, t),
    };
    (p + d * s).distance(q + e * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_as_far_apart_as_they_are() {
        let x = [DVec3::ZERO, DVec3::X];
        for (other, distance) in [
            ([DVec3::new(0.5, 1.0, -1.0), DVec3::new(0.5, 1.0, 1.0)], 1.0),
            ([DVec3::new(0.3, 0.0, -1.0), DVec3::new(0.3, 0.0, 1.0)], 0.0),
            ([DVec3::new(0.2, 2.0, 0.0), DVec3::new(0.8, 2.0, 0.0)], 2.0),
            ([DVec3::new(2.0, 0.0, 0.0), DVec3::new(3.0, 5.0, 0.0)], 1.0),
            ([DVec3::new(-3.0, 4.0, 0.0), DVec3::new(-3.0, 8.0, 0.0)], 5.0),
        ] {
            assert!((between_segments(x, other) - distance).abs() < 1e-12);
            assert!((between_segments(other, x) - distance).abs() < 1e-12);
        }
    }
}
