//! The wire as straight stretches and bends of one radius each, in the order in which they are made.

use crate::{Centreline, Metal};
use glam::{DQuat, DVec3};
use serde::Serialize;
use std::f64::consts::PI;

/// How far the list may lead off the wire, as a share of the wire's size.
const TOLERANCE: f64 = 0.005;
/// Lengths and radii are told to so many parts of a millimetre: what hands can measure.
const PER_MM: f64 = 10.0;
/// In sculptures smaller than [`SMALL_MM`] they are told to so many.
const FINE_PER_MM: f64 = 100.0;
const SMALL_MM: f64 = 60.0;
/// Angles are told to so many parts of a degree.
const PER_DEGREE: f64 = 10.0;
/// What bends less is straight, degrees.
const STRAIGHT_DEGREES: f64 = 0.5;
/// So is what bends less and leads off less than lengths are told to.
const NEARLY_STRAIGHT_DEGREES: f64 = 3.0;
/// No stretch is fitted to more steps, which bounds the work.
const MOST_STEPS: usize = 4096;
/// So many places of a stretch are compared with the wire.
const PLACES: usize = 24;

/// One bend, and the straight stretch before it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Bend {
    /// How far along the wire it begins, mm: on the drawings, for what is bent may be a little shorter.
    pub at_mm: f64,
    /// Go straight so far, mm.
    pub feed_mm: f64,
    /// Turn the plane of bending about the wire by this, degrees, anticlockwise as seen by who looks along the wire at what is done;
    /// -180 to 180.
    pub turn_deg: f64,
    /// Bend by this, degrees, 0 to 180 or more in a coil.
    pub angle_deg: f64,
    /// Of the wire's middle, mm; 0 for a fold.
    pub radius_mm: f64,
    /// Bend to this, degrees: it springs back to the angle.
    pub bend_to_deg: f64,
}

impl Bend {
    /// Length of wire in the bend itself, mm.
    pub fn arc_mm(&self) -> f64 {
        self.radius_mm * self.angle_deg.to_radians()
    }
}

/// How to bend a wire.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BendList {
    /// Where the wire begins, mm from the middle of its box.
    pub start: [f64; 3],
    /// Where it goes from there.
    pub direction: [f64; 3],
    /// The axis of its first bend, right-handed.
    pub axis: [f64; 3],
    /// In order.
    pub bends: Vec<Bend>,
    /// Straight to the end, mm.
    pub last_feed_mm: f64,
    /// How far the list leads off the wire, mm.
    pub deviation_mm: f64,
}

/// Where a list leads to.
#[derive(Debug, Clone, Copy)]
struct Tip {
    place: DVec3,
    direction: DVec3,
    axis: DVec3,
}

impl Tip {
    fn straight(&mut self, mm: f64) {
        self.place += self.direction * mm;
    }

    fn turn(&mut self, radians: f64) {
        self.axis = DQuat::from_axis_angle(self.direction, radians) * self.axis;
    }

    fn bend(&mut self, radians: f64, radius: f64) {
        let inward = self.axis.cross(self.direction);
        self.place += radius * (radians.sin() * self.direction + (1.0 - radians.cos()) * inward);
        self.direction = (DQuat::from_axis_angle(self.axis, radians) * self.direction).normalize();
        self.axis = self.axis.reject_from_normalized(self.direction).normalize();
    }
}

impl BendList {
    /// Fitted to a wire of `metal`.
    ///
    /// Pairs of arcs (biarcs) lead from where the list has come to a place farther along and its direction; of all such
    /// places the farthest that keeps within the tolerance. So neither rounding nor what was taken for straight adds up.
    pub fn new(line: &Centreline, metal: Metal) -> BendList {
        let size = 2.0 * line.half_box_mm().max_element();
        let tolerance = TOLERANCE * size;
        let direction = line.tangent(0);
        let tip = Tip { place: line.point(0), direction, axis: direction.any_orthonormal_vector() };
        let per_mm = if size < SMALL_MM { FINE_PER_MM } else { PER_MM };
        let mut making =
            Making { tip, per_mm, feed: 0.0, at: 0.0, bends: Vec::new(), gauge: line.gauge_mm(), metal, first: None };
        let (mut from, mut deviation) = (0, 0.0f64);
        while from < line.steps() {
            let most = (line.steps() - from).min(MOST_STEPS);
            let fits = |steps: usize| {
                biarc(&making.tip, line.point(from + steps), line.tangent(from + steps))
                    .is_some_and(|arcs| off(line, making.tip, &arcs, from, steps) <= tolerance)
            };
            let steps = farthest(most, fits);
            let to = line.point(from + steps);
            let before = making.tip;
            let arcs = biarc(&before, to, line.tangent(from + steps)).unwrap_or([to, to]);
            deviation = deviation.max(off(line, before, &arcs, from, steps));
            let share =
                before.place.distance(arcs[0]) / (before.place.distance(arcs[0]) + arcs[0].distance(to)).max(1e-9);
            for (end, share) in arcs.into_iter().zip([0.0, share]) {
                making.at = (from as f64 + share * steps as f64) * line.step_mm();
                making.go_to(end);
            }
            from += steps;
        }
        let Making { feed, bends, first, .. } = making;
        BendList {
            start: tip.place.to_array(),
            direction: direction.to_array(),
            axis: first.unwrap_or(tip.axis).to_array(),
            bends,
            last_feed_mm: feed,
            deviation_mm: deviation.max(making.tip.place.distance(line.point(line.steps()))),
        }
    }

    /// Where the wire goes when it is bent so, in order.
    pub fn pieces(&self) -> Vec<Piece> {
        let [place, direction, axis] = [self.start, self.direction, self.axis].map(DVec3::from_array);
        let mut tip = Tip { place, direction, axis };
        let mut pieces = Vec::with_capacity(2 * self.bends.len() + 1);
        let straight = |tip: &mut Tip, mm: f64| {
            let from = tip.place;
            tip.straight(mm);
            (mm > 0.0).then_some(Piece::Straight { from, to: tip.place })
        };
        for bend in &self.bends {
            pieces.extend(straight(&mut tip, bend.feed_mm));
            tip.turn(bend.turn_deg.to_radians());
            let (centre, axis) = (tip.place + bend.radius_mm * tip.axis.cross(tip.direction), tip.axis);
            let angle_rad = bend.angle_deg.to_radians();
            if bend.radius_mm > 0.0 {
                pieces.push(Piece::Arc { from: tip.place, centre, axis, angle_rad });
            }
            tip.bend(angle_rad, bend.radius_mm);
        }
        pieces.extend(straight(&mut tip, self.last_feed_mm));
        pieces
    }
}

/// A part of a bent wire, mm from the middle of its box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Piece {
    /// What was fed.
    Straight {
        /// Its beginning.
        from: DVec3,
        /// Its end.
        to: DVec3,
    },
    /// What was bent.
    Arc {
        /// Its beginning.
        from: DVec3,
        /// What it goes round.
        centre: DVec3,
        /// Right-handed, of length 1.
        axis: DVec3,
        /// How far it goes.
        angle_rad: f64,
    },
}

impl Piece {
    /// A share (0 to 1) of the way along it.
    pub fn at(&self, share: f64) -> DVec3 {
        match *self {
            Piece::Straight { from, to } => from.lerp(to, share),
            Piece::Arc { from, centre, axis, angle_rad } => {
                centre + DQuat::from_axis_angle(axis, share * angle_rad) * (from - centre)
            }
        }
    }
}

/// A list being made.
struct Making {
    tip: Tip,
    per_mm: f64,
    /// Straight so far since the last bend.
    feed: f64,
    /// How far along the wire, mm.
    at: f64,
    bends: Vec<Bend>,
    gauge: f64,
    metal: Metal,
    first: Option<DVec3>,
}

impl Making {
    /// By an arc that leaves in the tip's direction, or straight, in numbers as they will be told.
    fn go_to(&mut self, end: DVec3) {
        let Some(arc) = Arc::to(&self.tip, end) else { return };
        let rounded = |x: f64, per: f64| (x * per).round() / per;
        let length = rounded(arc.length, self.per_mm);
        let angle_deg = rounded(arc.angle.to_degrees(), PER_DEGREE);
        let radius_mm = rounded(length / angle_deg.to_radians(), self.per_mm);
        let leads_off = 0.5 * length * angle_deg.to_radians() * self.per_mm;
        if angle_deg < STRAIGHT_DEGREES || (angle_deg < NEARLY_STRAIGHT_DEGREES && leads_off < 1.0) {
            self.straight(length);
        } else if arc.angle < PI && radius_mm > 0.0 {
            self.bend(arc.axis, angle_deg, radius_mm);
        } else {
            // A fold: no arc is so small, or goes so far round.
            self.bend(arc.axis, rounded(0.5 * arc.angle.to_degrees(), PER_DEGREE), 0.0);
            self.straight(rounded(self.tip.place.distance(end), self.per_mm));
        }
    }

    fn straight(&mut self, mm: f64) {
        self.tip.straight(mm);
        self.feed = ((self.feed + mm) * self.per_mm).round() / self.per_mm;
    }

    fn bend(&mut self, axis: DVec3, angle_deg: f64, radius_mm: f64) {
        let rounded = |x: f64| (x * PER_DEGREE).round() / PER_DEGREE;
        let turn_deg = match self.first {
            Some(_) => {
                let about = self.tip.axis.cross(axis).dot(self.tip.direction);
                rounded(about.atan2(self.tip.axis.dot(axis)).to_degrees())
            }
            None => {
                self.tip.axis = axis;
                self.first = Some(axis);
                0.0
            }
        };
        self.tip.turn(turn_deg.to_radians());
        self.tip.bend(angle_deg.to_radians(), radius_mm);
        let tightest = radius_mm.max(0.5 * self.gauge);
        let bend_to_deg = rounded(angle_deg * self.metal.overbend(tightest, self.gauge));
        let bend = Bend { at_mm: self.at, feed_mm: self.feed, turn_deg, angle_deg, radius_mm, bend_to_deg };
        self.feed = 0.0;
        self.bends.push(bend);
    }
}

/// An arc from a tip, in its direction.
struct Arc {
    length: f64,
    angle: f64,
    axis: DVec3,
}

impl Arc {
    /// `None` where it has no length.
    fn to(tip: &Tip, end: DVec3) -> Option<Arc> {
        let chord = end - tip.place;
        let reach = chord.length();
        if reach < 1e-9 {
            return None;
        }
        let half = tip.direction.angle_between(chord);
        let length = if half > 1e-6 { reach * half / half.sin().max(1e-6) } else { reach };
        let axis = tip.direction.cross(chord).try_normalize().unwrap_or(tip.axis);
        Some(Arc { length, angle: 2.0 * half, axis })
    }
}

/// Where the two arcs of equal reach end that lead from `tip` to `end` and arrive there in `direction` (Bolton, *Biarc curves*); `None`
/// where they would go round more than half a circle.
fn biarc(tip: &Tip, end: DVec3, direction: DVec3) -> Option<[DVec3; 2]> {
    let chord = end - tip.place;
    let both = tip.direction + direction;
    let (along, curl) = (chord.dot(both), 2.0 * (1.0 - tip.direction.dot(direction)));
    let squared = chord.length_squared();
    let reach = if curl > 1e-9 {
        ((along * along + curl * squared).sqrt() - along) / curl
    } else if along > 1e-9 {
        0.5 * squared / along
    } else {
        return None;
    };
    let joint = 0.5 * (tip.place + end + reach * (tip.direction - direction));
    let halves = [(tip.direction, joint - tip.place), (direction, end - joint)];
    let gentle = halves.iter().all(|(direction, chord)| direction.angle_between(*chord) < 0.5 * PI);
    (reach.is_finite() && gentle).then_some([joint, end])
}

/// How far two arcs from `tip` over `ends` lead off so many steps of the line, each place compared with the one as far along.
fn off(line: &Centreline, mut tip: Tip, ends: &[DVec3; 2], from: usize, steps: usize) -> f64 {
    let mut arcs = Vec::with_capacity(2);
    for &end in ends {
        if let Some(arc) = Arc::to(&tip, end) {
            let begins = Tip { axis: arc.axis, ..tip };
            tip = begins;
            if arc.angle > 1e-9 {
                tip.bend(arc.angle, arc.length / arc.angle);
            } else {
                tip.straight(arc.length);
            }
            arcs.push((begins, arc));
        }
    }
    let whole: f64 = arcs.iter().map(|(_, arc)| arc.length).sum();
    let mut worst = 0.0f64;
    let mut gone = 0.0;
    for (begins, arc) in &arcs {
        for k in 0..=PLACES {
            let share = k as f64 / PLACES as f64;
            let mut at = *begins;
            if arc.angle > 1e-9 {
                at.bend(share * arc.angle, arc.length / arc.angle);
            } else {
                at.straight(share * arc.length);
            }
            let step = from as f64 + steps as f64 * (gone + share * arc.length) / whole;
            let before = step.floor();
            let there = line.point(before as usize).lerp(line.point(before as usize + 1), step - before);
            worst = worst.max(at.place.distance(there));
        }
        gone += arc.length;
    }
    worst
}

/// The most steps, of up to `most`, that fit, found by doubling and halving; at least one.
fn farthest(most: usize, fits: impl Fn(usize) -> bool) -> usize {
    let mut good = 1;
    while good < most && fits((2 * good).min(most)) {
        good = (2 * good).min(most);
    }
    let mut bad = (2 * good).min(most + 1);
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        *if fits(middle) { &mut good } else { &mut bad } = middle;
    }
    good
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::few_cases::few_cases;
    use proptest::prelude::*;
    use wire4d_core::rng::Rng;
    use wire4d_core::wire::Wire;

    fn fitted(wire: &Wire, size_mm: f64, gauge_mm: f64) -> (Centreline, BendList) {
        let line = Centreline::new(wire, size_mm, gauge_mm).unwrap();
        let list = BendList::new(&line, Metal::Copper);
        (line, list)
    }

    /// The farthest that any place of one is from the other, both ways.
    fn between(line: &Centreline, list: &BendList) -> f64 {
        let places = (0..20).map(|k| f64::from(k) / 19.0);
        let rebuilt: Vec<DVec3> =
            list.pieces().iter().flat_map(|piece| places.clone().map(|share| piece.at(share))).collect();
        let wire: Vec<DVec3> = (0..=line.steps()).map(|i| line.point(i)).collect();
        let far = |from: &[DVec3], to: &[DVec3]| {
            let near = |p: &DVec3| {
                let segments = to.windows(2).map(|pair| {
                    let along = pair[1] - pair[0];
                    let share = ((*p - pair[0]).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
                    p.distance(pair[0] + share * along)
                });
                segments.fold(f64::INFINITY, f64::min)
            };
            from.iter().step_by(3).map(near).fold(0.0, f64::max)
        };
        far(&rebuilt, &wire).max(far(&wire, &rebuilt))
    }

    fn random_wire(seed: u64, points: usize, closed: bool) -> Wire {
        let mut rng = Rng::new(seed, 1);
        // A walk, so that it is long and neither a ball of noise nor straight.
        let mut at = DVec3::ZERO;
        let points: Vec<[f64; 4]> = (0..points)
            .map(|_| {
                at = (at + DVec3::from_array(rng.in_ball(0.4))).clamp_length_max(1.0);
                [at.x, at.y, at.z, 0.02]
            })
            .collect();
        Wire::uniform(Default::default(), closed, points).unwrap()
    }

    proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn a_wire_rebuilt_from_its_list_is_the_wire(seed in 0u64..1000, points in 6usize..60, closed: bool, size in 40.0..400.0) {
            let (line, list) = fitted(&random_wire(seed, points, closed), size, 0.01 * size);
            let off = between(&line, &list);
            prop_assert!(off <= 0.01 * size, "{off} mm of {size}");
            prop_assert!(off <= list.deviation_mm + 0.002 * size, "{off} mm where {} is told", list.deviation_mm);
            let length = list.last_feed_mm + list.bends.iter().map(|bend| bend.feed_mm + bend.arc_mm()).sum::<f64>();
            prop_assert!((length / line.length_mm() - 1.0).abs() < 0.02);
        }
    }

    #[test]
    fn a_straight_wire_and_a_ring_are_what_they_are() {
        let straight = (0..8).map(|i| [0.2 * f64::from(i), 0.1 * f64::from(i), 0.0, 0.1]).collect();
        let (line, list) = fitted(&Wire::open_uniform(straight).unwrap(), 100.0, 1.0);
        assert!(list.bends.is_empty());
        assert!((list.last_feed_mm - line.length_mm()).abs() < 0.1);

        let ring = (0..64).map(|i| f64::from(i) * PI / 32.0).map(|t| [t.cos(), 0.0, t.sin(), 0.1]).collect();
        let (_, list) = fitted(&Wire::closed_uniform(ring).unwrap(), 100.0, 1.0);
        let whole: f64 = list.bends.iter().map(|bend| bend.angle_deg).sum();
        assert!(list.bends.len() <= 8 && (whole - 360.0).abs() < 2.0, "{} bends by {whole}", list.bends.len());
        for bend in &list.bends {
            assert!((bend.radius_mm - 50.0).abs() < 1.0 && bend.turn_deg.abs() < 1.0, "{:?}", list.bends);
            assert!(bend.bend_to_deg > bend.angle_deg);
        }
    }

    #[test]
    fn corners_and_cusps_are_followed() {
        let back = [[0.0; 4], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.01, 0.0, 0.0]];
        let (line, list) = fitted(&Wire::open_uniform(back.to_vec()).unwrap(), 200.0, 1.0);
        assert!(between(&line, &list) < 2.0);
    }
}
