//! Whether a wire can be bent from its stock, and what to change where it cannot.

use crate::close::{FAR_GAUGES, Pair, nearest, pairs};
use crate::{Centreline, MAX_SIZE_MM, MIN_GAUGE_MM, Pieces, Stock};
use serde::Serialize;
use std::f64::consts::PI;
use wire4d_core::Result;
use wire4d_core::wire::Wire;

/// Strands nearer than so many gauges do not only touch: one would have to pass through the other.
const THROUGH: f64 = 0.9;
/// Rounding and sampling are no faults.
const ENOUGH: f64 = 0.995;
/// Pairs of steps that are so many steps apart, along both strands, are one meeting.
const SAME_MEETING: usize = 6;
/// Faults beyond these are counted, not listed.
pub const MOST_LISTED: usize = 500;
/// A picture's height in world units and pixels, as width settings count.
const PX_PER_WORLD: f64 = 256.0 / 2.2;

/// What came out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    /// Whether it can be built as it is.
    pub passes: bool,
    /// The wire's length, mm.
    pub length_mm: f64,
    /// Its mass, g.
    pub mass_g: f64,
    /// Width, height and depth of the sculpture, thickness of the wire included, mm.
    pub box_mm: [f64; 3],
    /// How tightly it bends.
    pub bends: Bends,
    /// How near strands come.
    pub clearance: Clearance,
    /// Pieces of stock, and where they are joined.
    pub pieces: Pieces,
    /// What makes it pass; `None` if it passes.
    pub passing: Option<Passing>,
    /// Settings of a fit that keeps to this size and gauge.
    pub refit: Refit,
}

/// A place of the wire.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Spot {
    /// Distance from the start, mm.
    pub at_mm: f64,
    /// Where that is in the wire's own units.
    pub world: [f64; 3],
}

/// How tightly a wire bends. Radii are of its middle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Bends {
    /// The tightest bend's, mm.
    pub least_radius_mm: f64,
    /// Where that is.
    pub tightest: Spot,
    /// What the metal bears, mm.
    pub needed_radius_mm: f64,
    /// How many stretches are tighter.
    pub tight_count: usize,
    /// Those stretches, the tightest first, [`MOST_LISTED`] at most.
    pub tight: Vec<TightBend>,
}

/// A stretch that is too tight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TightBend {
    /// Where it begins, mm from the start.
    pub from_mm: f64,
    /// Where it ends.
    pub to_mm: f64,
    /// Its tightest place's radius, mm.
    pub least_radius_mm: f64,
    /// That place.
    pub tightest: Spot,
}

/// How near strands come to each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Clearance {
    /// Air between the nearest two strands, mm; less than 0 where they overlap. `None` if all are at least seven gauges apart.
    pub least_mm: Option<f64>,
    /// Both places there.
    pub nearest: Option<[Spot; 2]>,
    /// How many times strands overlap.
    pub meeting_count: usize,
    /// How many times one would have to pass through the other.
    pub through_count: usize,
    /// Where they overlap, the deepest first, [`MOST_LISTED`] at most.
    pub meetings: Vec<Meeting>,
}

/// Two stretches that are in the same place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Meeting {
    /// The first stretch, mm from the start.
    pub stretch_mm: [f64; 2],
    /// The other stretch.
    pub other_mm: [f64; 2],
    /// Least distance of the two strands' middles, mm.
    pub distance_mm: f64,
    /// Whether one would have to pass through the other, or they only touch.
    pub through: bool,
    /// Where they are nearest, on both.
    pub nearest: [Spot; 2],
}

/// Either of these makes it pass.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Passing {
    /// The least size at which it does, whole mm, with the same wire; `None` if no size that can be built does.
    pub size_mm: Option<f64>,
    /// The thickest wire with which it does, at this size; `None` if that is thinner than wire to bend.
    pub gauge_mm: Option<f64>,
}

/// What to ask of a fit, so that its wire can be built at this size.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Refit {
    /// `--max-width` with `--width constant`, px of a 256 px picture; views are as high as they usually are.
    pub width_px: f64,
    /// `--bend-radius`, in diameters.
    pub bend_radius: f64,
}

impl Check {
    /// Of `wire`, from `stock`, where `line` is its true size.
    ///
    /// # Errors
    /// As [`Stock::pieces`].
    pub fn new(wire: &Wire, line: &Centreline, stock: &Stock) -> Result<Check> {
        let needed_radius_mm = stock.metal.least_radius_mm(stock.gauge_mm);
        let bends = bends(line, needed_radius_mm);
        let clearance = clearance(line, needed_radius_mm);
        let passes = bends.tight.is_empty() && clearance.meetings.is_empty();
        let box_mm = 2.0 * line.half_box_mm() + stock.gauge_mm;
        let size_mm = 2.0 * line.half_box_mm().max_element();
        Ok(Check {
            passes,
            length_mm: line.length_mm(),
            mass_g: stock.metal.mass_g(line.length_mm(), stock.gauge_mm),
            box_mm: box_mm.to_array(),
            pieces: stock.pieces(line)?,
            passing: (!passes).then(|| {
                let larger = passing_size(wire, stock, size_mm, ratio(&bends, &clearance, stock));
                // A wire is as bendable as its size in gauges says.
                let gauge = larger.map(|larger| (100.0 * stock.gauge_mm * size_mm / larger).floor() / 100.0);
                Passing {
                    size_mm: larger.filter(|&size| size <= MAX_SIZE_MM),
                    gauge_mm: gauge.filter(|&gauge| gauge >= MIN_GAUGE_MM),
                }
            }),
            bends,
            clearance,
            refit: Refit {
                width_px: stock.gauge_mm / line.mm_per_world() * PX_PER_WORLD,
                bend_radius: stock.metal.least_inside_radius() + 0.5,
            },
        })
    }
}

fn spot(line: &Centreline, i: usize) -> Spot {
    Spot { at_mm: i as f64 * line.step_mm(), world: line.to_world(line.point(i)) }
}

/// Radii by how far the direction turns within a gauge: a corner between two steps, or a wave too small for wire, is no other
/// bend than a round one of that turn.
fn bends(line: &Centreline, needed: f64) -> Bends {
    let (step, count) = (line.step_mm(), line.points().len());
    let half = ((0.5 * line.gauge_mm() / step).round() as usize).max(1);
    let radius = |i: usize| {
        let (from, to) = if line.closed() {
            (i + count - half, i + count + half)
        } else {
            (i.saturating_sub(half), (i + half).min(count - 1))
        };
        let turn = line.tangent(from).angle_between(line.tangent(to));
        (to - from) as f64 * step / turn.max(1e-9)
    };
    let radii: Vec<f64> = (0..count).map(radius).collect();
    let tightest_of =
        |range: std::ops::Range<usize>| range.min_by(|&a, &b| radii[a].total_cmp(&radii[b])).unwrap_or_default();
    let tight = runs(&radii, |&radius| radius < ENOUGH * needed).into_iter().map(|run| {
        let tightest = tightest_of(run.clone());
        TightBend {
            from_mm: run.start as f64 * step,
            to_mm: (run.end - 1) as f64 * step,
            least_radius_mm: radii[tightest],
            tightest: spot(line, tightest),
        }
    });
    let mut tight: Vec<TightBend> = tight.collect();
    let tight_count = tight.len();
    tight.sort_by(|a, b| a.least_radius_mm.total_cmp(&b.least_radius_mm));
    tight.truncate(MOST_LISTED);
    let tightest = tightest_of(0..count);
    Bends {
        least_radius_mm: radii[tightest],
        tightest: spot(line, tightest),
        needed_radius_mm: needed,
        tight_count,
        tight,
    }
}

/// Stretches in which `is` holds.
fn runs<T>(of: &[T], is: impl Fn(&T) -> bool) -> Vec<std::ops::Range<usize>> {
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for i in (0..of.len()).filter(|&i| is(&of[i])) {
        match runs.last_mut().filter(|run| run.end == i) {
            Some(run) => run.end = i + 1,
            None => runs.push(i..i + 1),
        }
    }
    runs
}

/// A wire that nowhere bends tighter than `needed` cannot come near itself within half a turn (Schur's comparison theorem),
/// and where it bends tighter, that is the fault to name.
fn clearance(line: &Centreline, needed: f64) -> Clearance {
    let (gauge, apart) = (line.gauge_mm(), PI * needed);
    let close = pairs(line, ENOUGH * gauge, apart);
    let deepest = close.iter().copied().min_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
    let nearest = deepest.or_else(|| nearest(line, apart));
    let spots = |pair: &Pair| [spot(line, pair.first), spot(line, pair.second)];
    let met = meetings(close).into_iter().map(|met| {
        let mm = |[from, to]: [usize; 2]| [from, to + 1].map(|i| i as f64 * line.step_mm());
        let distance_mm = met.deepest.distance_mm;
        Meeting {
            stretch_mm: mm(met.first),
            other_mm: mm(met.second),
            distance_mm,
            through: distance_mm < THROUGH * gauge,
            nearest: spots(&met.deepest),
        }
    });
    let mut meetings: Vec<Meeting> = met.collect();
    let (meeting_count, through_count) = (meetings.len(), meetings.iter().filter(|met| met.through).count());
    meetings.sort_by(|a, b| a.distance_mm.total_cmp(&b.distance_mm));
    meetings.truncate(MOST_LISTED);
    Clearance {
        least_mm: nearest.map(|pair| pair.distance_mm - gauge),
        nearest: nearest.as_ref().map(spots),
        meeting_count,
        through_count,
        meetings,
    }
}

struct Met {
    first: [usize; 2],
    second: [usize; 2],
    deepest: Pair,
}

/// Pairs that belong together; they come in the order of their first steps.
fn meetings(close: Vec<Pair>) -> Vec<Met> {
    let mut all: Vec<Met> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    for pair in close {
        open.retain(|&met| all[met].first[1] + SAME_MEETING >= pair.first);
        let belongs =
            |met: &Met| met.second[0] <= pair.second + SAME_MEETING && pair.second <= met.second[1] + SAME_MEETING;
        match open.iter().copied().find(|&met| belongs(&all[met])) {
            Some(met) => {
                let met = &mut all[met];
                met.first[1] = pair.first;
                met.second = [met.second[0].min(pair.second), met.second[1].max(pair.second)];
                if pair.distance_mm < met.deepest.distance_mm {
                    met.deepest = pair;
                }
            }
            None => {
                open.push(all.len());
                all.push(Met { first: [pair.first; 2], second: [pair.second; 2], deepest: pair });
            }
        }
    }
    all
}

/// How many times larger everything is to be, as the worst place says.
fn ratio(bends: &Bends, clearance: &Clearance, stock: &Stock) -> f64 {
    let air = clearance.least_mm.unwrap_or(FAR_GAUGES * stock.gauge_mm);
    (bends.needed_radius_mm / bends.least_radius_mm).max(stock.gauge_mm / (air + stock.gauge_mm).max(1e-9))
}

/// The least size, whole mm, at which the wire passes; up to so large that thin wire at this size is as good.
fn passing_size(wire: &Wire, stock: &Stock, size_mm: f64, ratio: f64) -> Option<f64> {
    let most = (size_mm * stock.gauge_mm / MIN_GAUGE_MM).max(MAX_SIZE_MM);
    // Size over gauge is all that counts, so what is beyond buildable sizes is tried with thinner wire.
    let tried = |size: f64| {
        let shrink = (MAX_SIZE_MM / size).min(1.0);
        let line = Centreline::new(wire, size * shrink, stock.gauge_mm * shrink).ok()?;
        let needed = stock.metal.least_radius_mm(line.gauge_mm());
        let (bends, clearance) = (bends(&line, needed), clearance(&line, needed));
        let passes = bends.tight.is_empty() && clearance.meetings.is_empty();
        let stock = Stock { gauge_mm: line.gauge_mm(), ..*stock };
        Some((passes, self::ratio(&bends, &clearance, &stock)))
    };
    let (mut fails, mut passes) = (size_mm.floor(), (size_mm * ratio.max(1.0)).ceil());
    loop {
        if passes > most {
            return None;
        }
        let (done, ratio) = tried(passes)?;
        if done {
            break;
        }
        fails = passes;
        passes = (passes * ratio.max(1.0)).ceil().max(passes + 1.0);
    }
    while passes - fails > 1.0 {
        let middle = (0.5 * (fails + passes)).floor();
        *if tried(middle)?.0 { &mut passes } else { &mut fails } = middle;
    }
    Some(passes)
}

impl Check {
    /// The outcome in plain sentences, one a line.
    pub fn sentences(&self, stock: &Stock) -> Vec<String> {
        let Stock { metal, gauge_mm, length_mm: piece } = *stock;
        let name = metal.name();
        let [width, height, depth] = self.box_mm.map(f64::round);
        let mut said = vec![if self.passes {
            format!("It can be bent from {gauge_mm} mm {name} wire: {width} x {height} x {depth} mm.")
        } else {
            format!("It cannot be bent as it is from {gauge_mm} mm {name} wire: {width} x {height} x {depth} mm.")
        }];
        let (count, joints) = (self.pieces.count, self.pieces.joints_mm.len());
        said.push(format!(
            "It takes {:.2} m of wire, {:.0} g: {} of {:.2} m, with {}.",
            1e-3 * self.length_mm,
            self.mass_g,
            counted(count, "piece"),
            1e-3 * piece,
            if joints == 0 { "no joint".into() } else { counted(joints, "joint") },
        ));
        let Bends { least_radius_mm: least, tightest, needed_radius_mm: needed, tight_count, .. } = &self.bends;
        let tightest = tightest.at_mm;
        said.push(if *tight_count == 0 {
            format!("The tightest bend has a radius of {least:.1} mm; {name} bears {needed:.1} mm.")
        } else {
            format!(
                "{} tighter than {name} bears ({needed:.1} mm): the tightest, {least:.1} mm, is {tightest:.0} mm from the start.",
                is_are(*tight_count, "bend")
            )
        });
        let Clearance { least_mm, meeting_count, through_count, meetings, .. } = &self.clearance;
        if let Some(worst) = meetings.first() {
            let [at, other] = worst.nearest.map(|spot| spot.at_mm);
            said.push(format!(
                "The wire meets itself in {}, {through_count} of them so deeply that one strand would have to pass through the other; \
                 the deepest is where {at:.0} mm meets {other:.0} mm.",
                counted(*meeting_count, "place")
            ));
        } else if let Some(air) = least_mm {
            said.push(format!("Strands keep {air:.1} mm of air between them."));
        }
        if let Some(passing) = &self.passing {
            let larger = passing.size_mm.map(|size| format!("make it {size} mm large (--size-mm {size})"));
            let thinner = passing.gauge_mm.map(|gauge| format!("take wire of {gauge} mm (--wire-mm {gauge})"));
            let smoother = format!(
                "make the wire again, smoother and in one width (--width constant --max-width {width:.1} --bend-radius {radius:.2})",
                width = self.refit.width_px,
                radius = self.refit.bend_radius
            );
            let ways: Vec<String> = larger.into_iter().chain(thinner).chain([smoother]).collect();
            said.push(format!("What helps: {}.", ways.join("; or ")));
        }
        said
    }
}

fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn is_are(count: usize, what: &str) -> String {
    format!("{} {}", counted(count, what), if count == 1 { "is" } else { "are" })
}

#[cfg(test)]
mod tests;
