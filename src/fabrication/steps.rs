//! The bending in steps, each shown from the side from which it is seen best.

use crate::seen::{Side, runs};
use crate::{BendList, Centreline};
use serde::Serialize;

/// Fewest and most steps.
const STEPS: [usize; 2] = [15, 40];
/// Bends in a step, where that many steps allow it.
const BENDS_A_STEP: usize = 6;
/// Sides to look from: all round, from a little below, from level and from above.
const AZIMUTHS: usize = 8;
const ELEVATIONS: [f64; 4] = [-20.0, 0.0, 30.0, 60.0];
/// Of sides that are about as good, the level one, and the one nearest to the front: it is easier to read.
const STEEP: f64 = 0.05;
const TURNED: f64 = 0.03;

/// A side is judged by no more steps of the line than these.
const MOST_STEPS: usize = 4000;

/// What is bent in one go.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// The new stretch begins here, mm from the start.
    pub from_mm: f64,
    /// And ends here.
    pub to_mm: f64,
    /// The bends in it, counted from 1: the first, and the one after the last.
    pub bends: [usize; 2],
    /// Where to look from.
    pub side: Side,
    /// How much of the new stretch is seen from there, 0 to 1: how long it looks, without what other strands hide.
    pub seen: f64,
}

impl Step {
    /// One sentence.
    pub fn sentence(&self) -> String {
        let [from, to] = self.bends;
        let bends = match to - from {
            0 => "no bend: go straight".to_owned(),
            1 => format!("bend {from}"),
            _ => format!("bends {from} to {}", to - 1),
        };
        format!("{:.0} to {:.0} mm, {bends}", self.from_mm, self.to_mm)
    }
}

/// Fifteen to forty steps with as many bends each as can be.
pub fn steps(line: &Centreline, list: &BendList) -> Vec<Step> {
    let bends = list.bends.len();
    let count = bends.div_ceil(BENDS_A_STEP).clamp(STEPS[0], STEPS[1]);
    // Few bends: even lengths in place of even numbers of bends.
    let ends: Vec<f64> = if bends >= count {
        let ends = (1..count).map(|k| &list.bends[k * bends / count]).map(|bend| bend.at_mm);
        ends.chain([line.length_mm()]).collect()
    } else {
        (1..=count).map(|k| line.length_mm() * k as f64 / count as f64).collect()
    };
    let starts = [0.0].into_iter().chain(ends.iter().copied());
    starts
        .zip(&ends)
        .map(|(from_mm, &to_mm)| {
            let number = |mm: f64| 1 + list.bends.partition_point(|bend| bend.at_mm < mm);
            let (side, seen) = best_side(line, [from_mm, to_mm]);
            let last = if to_mm < line.length_mm() { number(to_mm) } else { bends + 1 };
            Step { from_mm, to_mm, bends: [number(from_mm), last], side, seen }
        })
        .collect()
}

/// The steps of a line from one length to another.
pub fn range(line: &Centreline, [from_mm, to_mm]: [f64; 2]) -> [usize; 2] {
    let at = |mm: f64| (mm / line.step_mm()).round().clamp(0.0, line.steps() as f64) as usize;
    [at(from_mm), at(to_mm)]
}

/// Where a new stretch looks longest and is hidden least by itself and what was there before; and the share that is seen.
fn best_side(line: &Centreline, stretch_mm: [f64; 2]) -> (Side, f64) {
    let stretch = range(line, stretch_mm);
    let length = (stretch_mm[1] - stretch_mm[0]).max(1e-9);
    let every = stretch[1].div_ceil(MOST_STEPS).min((stretch[1] - stretch[0]).max(1));
    let seen = |side: Side| {
        let runs = runs(line, side, stretch, [0, stretch[1]], every);
        let lengths = runs.iter().filter(|run| !run.hidden).flat_map(|run| run.places.windows(2));
        (lengths.map(|pair| pair[0].distance(pair[1])).sum::<f64>() / length).min(1.0)
    };
    let sides = ELEVATIONS.into_iter().flat_map(|elevation_deg| {
        (0..AZIMUTHS).map(move |k| Side { azimuth_deg: 360.0 * k as f64 / AZIMUTHS as f64, elevation_deg })
    });
    let judged = sides.map(|side| (side, seen(side)));
    let worth = |&(side, seen): &(Side, f64)| {
        let turned = 0.5 - 0.5 * side.azimuth_deg.to_radians().cos();
        seen - STEEP * side.elevation_deg.abs() / 90.0 - TURNED * turned
    };
    judged.max_by(|a, b| worth(a).total_cmp(&worth(b))).unwrap_or((Side::FRONT, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Metal;
    use wire4d_core::wire::Wire;

    #[test]
    fn steps_cover_the_wire_and_look_at_what_is_new() {
        // A wire in the plane of front and top alone, and one that winds.
        for (points, depth) in [(12, 0.0), (300, 0.4)] {
            let points = (0..points).map(|i| f64::from(i) * 0.35);
            let points = points.map(|t| [0.25 * t, 0.3 * t.sin(), depth * t.cos(), 0.02]).collect();
            let line = Centreline::new(&Wire::open_uniform(points).unwrap(), 300.0, 1.0).unwrap();
            let list = BendList::new(&line, Metal::Copper);
            let steps = steps(&line, &list);
            assert!((STEPS[0]..=STEPS[1]).contains(&steps.len()), "{}", steps.len());
            assert_eq!(steps[0].from_mm, 0.0);
            assert!((steps[steps.len() - 1].to_mm - line.length_mm()).abs() < 1e-9);
            assert!(
                steps.windows(2).all(|pair| pair[0].to_mm == pair[1].from_mm && pair[0].bends[1] == pair[1].bends[0])
            );
            assert_eq!((steps[0].bends[0], steps[steps.len() - 1].bends[1]), (1, list.bends.len() + 1));
            assert!(steps.iter().all(|step| step.seen > 0.6), "{steps:?}");
            if depth == 0.0 {
                let ahead = |step: &Step| step.side == Side::FRONT;
                assert!(steps.iter().all(ahead), "a flat wire is seen from the front: {steps:?}");
            }
        }
    }
}
