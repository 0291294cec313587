//! How a wire was found: some wires of its run, coded against each other.
//!
//! A control point is guessed from where it was in the wire before and where its neighbour has gone since; where the number
//! of control points changed, the wire before is taken as a polyline with as many corners. Bytes are
//! `[version][range-coded wires][CRC-32 of all before]`.

use super::contents::{KnotCode, STEP_ZEROS, transcode_step};
use super::grid::{nearest, point_from, short};
use super::range::{Coder, Decoder, Encoder, Nonsense};
use super::series::{self, Following};
use super::{knot_code, knots_from};
use crate::wire::{Form, MAX_CONTROL_POINTS, Wire};
use crate::{Error, Result};

const VERSION: u8 = 1;
/// Most wires of a replay.
pub const MAX_WIRES: usize = 40;
/// Most bytes that are read.
pub const MAX_BYTES: usize = 40 << 10;
/// Most bytes that are written: files that carry them as text carry drawings too.
const MOST_BYTES: usize = 32 << 10;
/// Control points of all wires together: what takes a moment to read.
const MAX_POINTS: usize = 80_000;
/// Steps of coordinates and widths at first, world units: about a pixel where 512 show the whole object.
const STEPS: [f64; 2] = [0.0043, 0.004];
/// How much coarser steps get where it is too long.
const COARSER: f64 = 1.4;
/// Coarser ones show nothing any more: fewer wires then.
const COARSEST: f64 = 0.02;

/// The bytes of a replay of some of these wires, with the numbers of their iterations, which rise: those that show most of
/// what moves, the first and the last among them. Empty where there are less than two, or two that take too much.
pub fn encode(wires: &[(u32, Wire)]) -> Vec<u8> {
    if wires.len() < 2 {
        return Vec::new();
    }
    let mut steps = STEPS;
    let mut shown = most_telling(wires, MAX_WIRES);
    loop {
        let total: usize = shown.iter().map(|(_, wire)| wire.control_points().len()).sum();
        let bytes = (total <= MAX_POINTS).then(|| written(&shown, steps.map(short)));
        match bytes {
            Some(bytes) if bytes.len() <= MOST_BYTES => return bytes,
            Some(_) if steps[0] < COARSEST => steps = steps.map(|step| step * COARSER),
            _ if shown.len() > 2 => shown = most_telling(wires, (shown.len() * 2 / 3).max(2)),
            _ => return Vec::new(),
        }
    }
}

fn written(wires: &[&(u32, Wire)], steps: [f32; 2]) -> Vec<u8> {
    let frames = wires.iter().map(|(iteration, wire)| Frame {
        iteration: *iteration,
        closed: wire.closed(),
        form: wire.form(),
        knots: knot_code(wire),
        points: nearest(wire, steps).points,
    });
    let mut replay = Replay { steps, frames: frames.collect() };
    let mut encoder = Encoder::new();
    let written = replay.transcode(&mut encoder);
    debug_assert!(written.is_ok());
    let mut bytes = vec![VERSION];
    bytes.extend(encoder.finish());
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

/// The wires of a replay with the numbers of their iterations, which rise.
///
/// # Errors
/// [`Error::ShareCode`] for anything that is damaged, foreign, too large or newer than this program.
pub fn decode(bytes: &[u8]) -> Result<Vec<(u32, Wire)>> {
    let damaged = || super::bad("has a damaged replay", "open the file without it, or ask for the file again");
    if bytes.len() > MAX_BYTES {
        return Err(damaged());
    }
    let (body, checksum) = bytes.split_last_chunk::<4>().ok_or_else(damaged)?;
    let (&version, packed) = body.split_first().ok_or_else(damaged)?;
    if crc32fast::hash(body) != u32::from_le_bytes(*checksum) || version == 0 {
        return Err(damaged());
    }
    if version > VERSION {
        return Err(super::bad("has a replay newer than this program reads", "update Wire4D"));
    }
    let mut replay = Replay::default();
    replay.transcode(&mut Decoder::new(packed)).map_err(|_| damaged())?;
    let steps = replay.steps;
    let wire = |frame: Frame| {
        let points = frame.points.into_iter().map(|point| point_from(point, steps)).collect();
        Ok((frame.iteration, Wire::new(frame.form, frame.closed, knots_from(&frame.knots, frame.closed), points)?))
    };
    replay.frames.into_iter().map(wire).collect::<Result<_>>().map_err(|_: Error| damaged())
}

#[derive(Default)]
struct Replay {
    steps: [f32; 2],
    frames: Vec<Frame>,
}

#[derive(Clone, Default)]
struct Frame {
    iteration: u32,
    closed: bool,
    form: Form,
    knots: KnotCode,
    /// In steps.
    points: Vec<[i64; 4]>,
}

impl Replay {
    /// Writes `self`, or reads into `self`.
    fn transcode(&mut self, coder: &mut impl Coder) -> Result<(), Nonsense> {
        for step in &mut self.steps {
            transcode_step(coder, step, STEP_ZEROS);
        }
        let count = coder.bits(self.frames.len() as u64, 6) as usize;
        if !(2..=MAX_WIRES).contains(&count) {
            return Err(Nonsense);
        }
        self.frames.resize(count, Frame::default());
        let mut following = Following::new();
        let mut left = MAX_POINTS;
        let mut before = Frame::default();
        for (at, frame) in self.frames.iter_mut().enumerate() {
            let later = coder.whole(u64::from(frame.iteration.saturating_sub(before.iteration)));
            frame.iteration = u32::try_from(u64::from(before.iteration).saturating_add(later)).map_err(|_| Nonsense)?;
            if at > 0 && later == 0 {
                return Err(Nonsense);
            }
            frame.transcode_shape(coder, &before)?;
            left = left.checked_sub(frame.points.len()).ok_or(Nonsense)?;
            if at == 0 {
                series::transcode(coder, &mut frame.points)?;
            } else {
                let count = frame.points.len();
                following.transcode(coder, &mut frame.points, &as_many(&before.points, count))?;
            }
            before.clone_from(frame);
        }
        Ok(())
    }
}

impl Frame {
    /// All but where its points are; mostly as before.
    fn transcode_shape(&mut self, coder: &mut impl Coder, before: &Frame) -> Result<(), Nonsense> {
        let alike = |frame: &Frame| (frame.closed, frame.form, frame.points.len(), frame.knots.clone());
        if coder.flag(alike(self) == alike(before)) {
            (self.closed, self.form, self.knots) = (before.closed, before.form, before.knots.clone());
            self.points.resize(before.points.len(), [0; 4]);
            return if before.points.is_empty() { Err(Nonsense) } else { Ok(()) };
        }
        self.closed = coder.flag(self.closed);
        self.form = match coder.bits(self.form as u64, 2) {
            0 => Form::Spline,
            1 => Form::Chain,
            2 => Form::Bag,
            _ => return Err(Nonsense),
        };
        let count = coder.whole(self.points.len() as u64);
        if !(4..=MAX_CONTROL_POINTS as u64).contains(&count) {
            return Err(Nonsense);
        }
        self.points.resize(count as usize, [0; 4]);
        let intervals = if self.closed { self.points.len() } else { self.points.len() - 3 };
        self.knots.transcode_mostly_uniform(coder, intervals)
    }
}

/// A polyline with other corners: as many as given, evenly along it.
fn as_many(points: &[[i64; 4]], count: usize) -> Vec<[i64; 4]> {
    if points.len() == count {
        return points.to_vec();
    }
    let scale = (points.len() - 1) as f64 / (count - 1) as f64;
    let corner = |k: usize| {
        let along = k as f64 * scale;
        let at = (along.floor() as usize).min(points.len() - 2);
        let share = along - at as f64;
        std::array::from_fn(|c| {
            let (from, to) = (points[at][c] as f64, points[at + 1][c] as f64);
            (from + (to - from) * share + 0.5).floor() as i64
        })
    };
    (0..count).map(corner).collect()
}

/// At most `most` of the wires, so that about as much moves from each to the next: many where most happens.
fn most_telling(wires: &[(u32, Wire)], most: usize) -> Vec<&(u32, Wire)> {
    if wires.len() <= most {
        return wires.iter().collect();
    }
    // The square root: what moves little is to be seen as well.
    let moved = |pair: &[(u32, Wire)]| distance(&pair[0].1, &pair[1].1).sqrt() + 1e-6;
    let so_far: Vec<f64> = std::iter::once(0.0)
        .chain(wires.windows(2).scan(0.0, |sum, pair| {
            *sum += moved(pair);
            Some(*sum)
        }))
        .collect();
    let whole = so_far[wires.len() - 1];
    let mut shown: Vec<usize> = (0..most)
        .map(|k| {
            let wanted = whole * k as f64 / (most - 1) as f64;
            so_far.partition_point(|&sum| sum < wanted).min(wires.len() - 1)
        })
        .collect();
    shown.dedup();
    shown.into_iter().map(|k| &wires[k]).collect()
}

/// Mean distance of two wires at the same shares of their ranges, world units.
fn distance(one: &Wire, other: &Wire) -> f64 {
    const PLACES: usize = 128;
    let at = |wire: &Wire, k: usize| {
        let (start, end) = wire.domain();
        wire.evaluate(start + (end - start) * k as f64 / PLACES as f64)
    };
    let apart = |k: usize| {
        let (p, q) = (at(one, k), at(other, k));
        (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>().sqrt()
    };
    (0..=PLACES).map(apart).sum::<f64>() / (PLACES + 1) as f64
}
