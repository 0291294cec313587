//! The wire as it looks from a side: parallel, at true size, and which of it lies behind other strands.

use crate::Centreline;
use crate::close::Grid;
use glam::{DVec2, DVec3};
use serde::Serialize;

/// Where to look from.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Side {
    /// 0 is the front, 90 the side.
    pub azimuth_deg: f64,
    /// 90 is the top.
    pub elevation_deg: f64,
}

impl Side {
    /// Looks along -z.
    pub const FRONT: Side = Side { azimuth_deg: 0.0, elevation_deg: 0.0 };
    /// Looks along -x.
    pub const SIDE: Side = Side { azimuth_deg: 90.0, elevation_deg: 0.0 };
    /// Looks along -y, the front below.
    pub const TOP: Side = Side { azimuth_deg: 0.0, elevation_deg: 90.0 };

    /// Right, up, and towards who looks.
    fn axes(self) -> [DVec3; 3] {
        let ((sin, cos), (rise, flat)) =
            (self.azimuth_deg.to_radians().sin_cos(), self.elevation_deg.to_radians().sin_cos());
        [
            DVec3::new(cos, 0.0, -sin),
            DVec3::new(-sin * rise, flat, -cos * rise),
            DVec3::new(sin * flat, rise, cos * flat),
        ]
    }

    /// Right and up, mm, and how near.
    pub fn project(self, point: DVec3) -> (DVec2, f64) {
        let [right, up, near] = self.axes().map(|axis| axis.dot(point));
        (DVec2::new(right, up), near)
    }
}

/// A stretch of the wire's places that is all seen or all hidden.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// mm, y up; the middle of the wire's box is the origin.
    pub places: Vec<DVec2>,
    /// Whether it lies behind another strand.
    pub hidden: bool,
}

/// The steps from the first to the last of `stretch`, as they look from `side` where nothing is there but the steps of `around`;
/// `every` of them are taken as one.
pub fn runs(line: &Centreline, side: Side, stretch: [usize; 2], around: [usize; 2], every: usize) -> Vec<Run> {
    let of = |[from, to]: [usize; 2]| {
        let steps = (from..to).step_by(every).chain([to]);
        steps.map(|i| side.project(line.point(i)))
    };
    let others: Vec<(DVec2, f64)> = of(around).collect();
    let flat: Vec<DVec3> = others.iter().map(|(at, _)| at.extend(0.0)).collect();
    // A step may reach as far over a place as the wire does.
    let reach = 0.5 * line.gauge_mm() + 0.5 * every as f64 * line.step_mm();
    let grid = Grid::new(&flat, reach);
    let mut runs: Vec<Run> = Vec::new();
    for (at, near) in of(stretch) {
        let over = |i: usize| others[i].1 > near + line.gauge_mm() && others[i].0.distance(at) < reach;
        let hidden = grid.near(at.extend(0.0)).any(over);
        match runs.last_mut() {
            Some(run) if run.hidden == hidden => run.places.push(at),
            last => {
                let joined = last.and_then(|run| run.places.last().copied());
                runs.push(Run { places: joined.into_iter().chain([at]).collect(), hidden });
            }
        }
    }
    runs
}

/// A line without the places that it goes straight through, to within `tolerance`.
pub fn thinned(places: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    const MOST_SKIPPED: usize = 64;
    let mut kept: Vec<DVec2> = places.first().copied().into_iter().collect();
    let mut from = 0;
    for to in 2..=places.len() {
        let fits = to < places.len() && to - from <= MOST_SKIPPED && {
            let (a, along) = (places[from], places[to] - places[from]);
            places[from + 1..to].iter().all(|&p| {
                let share = ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
                p.distance(a + share * along) <= tolerance
            })
        };
        if !fits {
            kept.push(places[to - 1]);
            from = to - 1;
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use wire4d_core::wire::Wire;

    #[test]
    fn sides_look_as_the_contract_says() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        assert!(Side::FRONT.project(p).0.distance(DVec2::new(1.0, 2.0)) < 1e-12);
        assert!(Side::SIDE.project(p).0.distance(DVec2::new(-3.0, 2.0)) < 1e-12);
        assert!(Side::TOP.project(p).0.distance(DVec2::new(1.0, -3.0)) < 1e-12);
        assert!((Side::TOP.project(p).1 - 2.0).abs() < 1e-12);
    }

    #[test]
    fn a_strand_is_hidden_behind_another_and_nowhere_else() {
        // An eight whose strands are 10 mm apart where they cross.
        let points = (0..96).map(|i| f64::from(i) * std::f64::consts::TAU / 96.0);
        let points = points.map(|t| [t.cos(), 0.6 * (2.0 * t).sin(), 0.05 * t.sin(), 0.02]).collect();
        let line = Centreline::new(&Wire::closed_uniform(points).unwrap(), 200.0, 2.0).unwrap();
        let all = [0, line.steps()];
        let hidden: Vec<Run> = runs(&line, Side::FRONT, all, all, 1).into_iter().filter(|run| run.hidden).collect();
        let [run] = &hidden[..] else { panic!("{} stretches", hidden.len()) };
        assert!(run.places.iter().all(|at| at.length() < 3.0), "{:?}", run.places);
        let behind = Side { azimuth_deg: 180.0, elevation_deg: 0.0 };
        assert_eq!(runs(&line, behind, all, all, 1).iter().filter(|run| run.hidden).count(), 1);
        // With the first half alone nothing is in the way.
        let half = [0, line.steps() / 2];
        assert!(runs(&line, Side::FRONT, half, half, 1).iter().all(|run| !run.hidden));
    }
}
