//! Hairpins of a wire that bends: where a path turns back on itself in a cusp, its legs are moved apart.
//!
//! No loss does that: the shorter a cusp, the less its bending costs, and the legs of one that is straight have no side to
//! be pushed to.

use glam::{DVec3, DVec4, Vec4Swizzles};

/// Steps a radius in which the path is walked.
const STEPS: usize = 4;
/// Radii along each leg after which it is where it was.
const REACH: usize = 5;
/// Where a radius before and a radius after are nearer than this, in radii, is a cusp; in an open hairpin that is 1.7.
const CUSP: f64 = 1.15;
/// Legs nearer than this, in radii, do not say to which side they belong.
const SAME: f64 = 0.1;
/// The most steps: longer paths stay as they are.
const MOST: usize = 400_000;

/// The same path (points `[x, y, z, width]`) at even steps, with each of its cusps opened to a bend of `radius_world` that
/// ends where the cusp does. A closed path's first point is not repeated at its end. Without cusps, and where that cannot
/// be done, the path comes back as it is.
pub fn with_open_hairpins(points: &[[f64; 4]], closed: bool, radius_world: f64) -> Vec<[f64; 4]> {
    let Some(even) = even_steps(points, closed, radius_world / STEPS as f64) else { return points.to_vec() };
    let path = Even { points: even, closed };
    let cusps = path.cusps(radius_world);
    if cusps.is_empty() {
        return points.to_vec();
    }
    let mut opened = path.points.clone();
    for (k, &cusp) in cusps.iter().enumerate() {
        let between = |other: Option<&usize>| other.map_or(usize::MAX, |&other| path.apart(cusp, other) / 2);
        let others = [cusps.get((k + cusps.len() - 1) % cusps.len()), cusps.get((k + 1) % cusps.len())];
        let room = others.into_iter().filter(|other| *other != Some(&cusp)).map(between).min().unwrap_or(usize::MAX);
        path.open(cusp, room.min(REACH * STEPS), radius_world, &mut opened);
    }
    opened.into_iter().map(|point| point.to_array()).collect()
}

struct Even {
    points: Vec<DVec4>,
    closed: bool,
}

impl Even {
    /// The index so many steps on from `i`, back if negative; `None` beyond an end.
    fn on(&self, i: usize, steps: isize) -> Option<usize> {
        let there = i as isize + steps;
        let count = self.points.len() as isize;
        if self.closed {
            Some(there.rem_euclid(count) as usize)
        } else {
            (0..count).contains(&there).then_some(there as usize)
        }
    }

    fn apart(&self, i: usize, j: usize) -> usize {
        let steps = i.abs_diff(j);
        if self.closed { steps.min(self.points.len() - steps) } else { steps }
    }

    fn place(&self, i: usize) -> DVec3 {
        self.points[i].xyz()
    }

    /// How far the path a radius before `i` is from itself a radius after.
    fn gap(&self, i: usize) -> f64 {
        let reach = STEPS as isize;
        let ends = self.on(i, -reach).zip(self.on(i, reach));
        ends.map_or(f64::INFINITY, |(before, after)| self.place(before).distance(self.place(after)))
    }

    /// The sharpest place of each turn that is a cusp of this radius.
    fn cusps(&self, radius: f64) -> Vec<usize> {
        let gaps: Vec<f64> = (0..self.points.len()).map(|i| self.gap(i)).collect();
        let near = 2 * STEPS as isize;
        let sharpest = |&i: &usize| {
            gaps[i] < CUSP * radius
                && (1..=near).all(|s| {
                    let other = |steps| self.on(i, steps).map_or(f64::INFINITY, |j| gaps[j]);
                    gaps[i] <= other(-s) && gaps[i] < other(s)
                })
        };
        (0..self.points.len()).filter(sharpest).collect()
    }

    /// Moves both legs of a cusp apart, over `reach` steps.
    fn open(&self, cusp: usize, reach: usize, radius: f64, opened: &mut [DVec4]) {
        let legs: Vec<[usize; 2]> =
            (1..=reach as isize).map_while(|s| Some([self.on(cusp, -s)?, self.on(cusp, s)?])).collect();
        let Some(&[before, after]) = legs.last() else { return };
        let axis = (self.place(cusp) - 0.5 * (self.place(before) + self.place(after))).normalize_or_zero();
        let half = |&[before, after]: &[usize; 2]| 0.5 * (self.place(after) - self.place(before));
        let square = |v: DVec3| v - axis * v.dot(axis);
        let apart = legs.iter().map(half).map(square).find(|v| v.length() > SAME * radius);
        // Legs that lie on each other part along the axis of the world that they run along the least.
        let sideways = apart.unwrap_or_else(|| square(DVec3::AXES[axis.abs().min_position()])).normalize_or_zero();
        for (k, leg) in legs.iter().enumerate() {
            let along = (k + 1) as f64 / STEPS as f64;
            let beyond = ((along - 1.0) / (legs.len() as f64 / STEPS as f64 - 1.0).max(0.5)).clamp(0.0, 1.0);
            let round = if along < 1.0 { (along * (2.0 - along)).sqrt() } else { 1.0 };
            let wanted = radius * round * (1.0 - beyond * beyond * (3.0 - 2.0 * beyond));
            let lacking = (wanted - half(leg).dot(sideways)).max(0.0);
            for (i, side) in leg.iter().zip([-lacking, lacking]) {
                opened[*i] += (sideways * side).extend(0.0);
            }
        }
    }
}

/// Points at even steps of about `step` along a path; `None` if it is no path or `step` no step.
fn even_steps(points: &[[f64; 4]], closed: bool, step: f64) -> Option<Vec<DVec4>> {
    let mut line: Vec<DVec4> = points.iter().map(|&point| point.into()).collect();
    if closed {
        line.extend(line.first().copied());
    }
    let piece = |pair: &[DVec4]| pair[0].xyz().distance(pair[1].xyz());
    let length: f64 = line.windows(2).map(piece).sum();
    let count = (length / step).round();
    if !(count >= (4 * STEPS) as f64 && count <= MOST as f64) {
        return None;
    }
    let step = length / count;
    let mut even = Vec::with_capacity(count as usize + 1);
    let mut passed = 0.0;
    for pair in line.windows(2) {
        let piece = piece(pair);
        while (even.len() as f64) * step < passed + piece {
            even.push(pair[0].lerp(pair[1], (even.len() as f64 * step - passed) / piece));
        }
        passed += piece;
    }
    even.truncate(count as usize);
    if !closed {
        even.extend(line.last());
    }
    Some(even)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADIUS: f64 = 0.03;

    /// The least distance, in radii, of places two radii apart along the path.
    fn sharpest(points: &[[f64; 4]], closed: bool) -> f64 {
        let path = Even { points: even_steps(points, closed, RADIUS / STEPS as f64).unwrap(), closed };
        (0..path.points.len()).map(|i| path.gap(i)).fold(f64::INFINITY, f64::min) / RADIUS
    }

    #[test]
    fn a_walk_there_and_back_becomes_a_hairpin_that_ends_at_the_same_place() {
        for lean in [0.0, 0.1, 0.4] {
            let out = (0..=100).map(|i| f64::from(i) / 100.0);
            let back = out.clone().rev().skip(1).map(|x| [x, lean * (1.0 - x), 0.0, 0.01]);
            let there: Vec<[f64; 4]> = out.map(|x| [x, 0.0, 0.0, 0.01]).chain(back).collect();
            assert!(sharpest(&there, false) < 0.8);
            let opened = with_open_hairpins(&there, false, RADIUS);
            assert!(sharpest(&opened, false) > CUSP, "{}", sharpest(&opened, false));
            let farthest = opened.iter().map(|p| p[0]).fold(0.0, f64::max);
            assert!((farthest - 1.0).abs() < 0.5 * RADIUS / STEPS as f64, "{farthest}");
            for (end, was) in [(opened[0], there[0]), (opened[opened.len() - 1], there[there.len() - 1])] {
                assert!((DVec4::from(end) - DVec4::from(was)).length() < 1e-9);
            }
            let widest = opened.iter().map(|p| p[1].hypot(p[2])).fold(0.0, f64::max);
            assert!(widest < 1.5 * RADIUS + lean);
        }
    }

    #[test]
    fn paths_that_bend_softly_and_what_is_no_path_stay_as_they_are() {
        let ring = |r: f64| -> Vec<[f64; 4]> {
            let angle = |i: i32| f64::from(i) / 200.0 * std::f64::consts::TAU;
            (0..200).map(|i| [r * angle(i).cos(), r * angle(i).sin(), 0.0, 0.01]).collect()
        };
        for r in [RADIUS, 0.2, 1.0] {
            assert_eq!(with_open_hairpins(&ring(r), true, RADIUS), ring(r));
        }
        for odd in [vec![], vec![[0.0; 4]], vec![[0.1; 4]; 9], vec![[f64::NAN; 4]; 9], ring(1e-9)] {
            for closed in [false, true] {
                let same = with_open_hairpins(&odd, closed, RADIUS);
                assert!(same.len() == odd.len());
            }
        }
        assert_eq!(with_open_hairpins(&ring(1.0), true, 0.0), ring(1.0));
        assert_eq!(with_open_hairpins(&ring(1.0), true, f64::NAN), ring(1.0));
    }

    #[test]
    fn cusps_of_a_closed_path_open_across_its_first_point() {
        let out = (0..50).map(|i| [f64::from(i) / 50.0, 0.0, 0.0, 0.01]);
        let there: Vec<[f64; 4]> = out.clone().chain(out.map(|p| [1.0 - p[0], 0.0, 0.0, 0.01])).collect();
        let opened = with_open_hairpins(&there, true, RADIUS);
        assert!(sharpest(&there, true) < 0.3 && sharpest(&opened, true) > CUSP);
    }
}
