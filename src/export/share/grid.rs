//! Rounds a wire to the coarsest grid with which its curve stays where it is, as far as its views can show.
//!
//! A control point may go to any neighbour on the grid that keeps the curve in place, the sooner if that takes fewer bits
//! to write: where roundings work against each other, the grid can be a good deal coarser than if each point had to stay
//! by itself.

use super::contents::STEP_ZEROS;
use crate::sculpture::{Sculpture, Strand, strands};
use crate::view::{Camera, View};
use crate::wire::Wire;

/// Picture size for which the precision is chosen.
const SIZE_PX: f64 = 512.0;
/// How far a point of the curve and its radius may move together, in those pixels: 0.3, with some left for knots.
const MOST_PX: f64 = 0.297;
/// The coarsest steps that are tried, of coordinates and of widths, and the finest, which always do.
const COARSEST_PX: [f64; 2] = [0.8, 0.4];
const FINEST_PX: [f64; 2] = [0.21, 0.23];
/// Coordinates are at most this many steps, however near an eye is.
const MAX_STEPS: f64 = (1u64 << 24) as f64;
const SAMPLES: usize = 4;
const CHECKED_SAMPLES: usize = 16;
const ROUNDS: usize = 8;
/// How often the curve is let slip less where it went too far.
const REPAIRS: usize = 3;
/// How much it counts if the curve slips along itself.
const SLIP: f64 = 0.3;
/// What a bit is worth in tension.
const THRIFT: f64 = 0.4;
/// What it costs to go beyond the limit, whatever it saves.
const BEYOND: f64 = 100.0;
/// Cosine of the turn from one sample to the next up to which it may.
const STRAIGHT: f64 = 0.9;

/// Control points in steps.
pub struct Rounded {
    /// World units of one step of x, y, z and of one step of width.
    pub steps: [f32; 2],
    pub points: Vec<[i64; 4]>,
}

/// To no more than 0.3 px at 512 px from where it is, in any view. A wire that lies on a grid as it is stays there.
pub fn rounded(sculpture: &Sculpture) -> Rounded {
    let sight = Sight::new(sculpture);
    let grids = sight.grids(1.0);
    let fine = on_grid(&sculpture.wire, &grids).unwrap_or_else(|| {
        let mut at = 0;
        while at + 1 < grids.len() {
            let (rounded, moved) = sight.round(&sculpture.wire, grids[at]);
            if moved <= MOST_PX {
                return rounded;
            }
            at += ((moved / MOST_PX).log2() * 8.0).clamp(1.0, 3.0) as usize;
        }
        // The finest is right by itself.
        nearest(&sculpture.wire, *grids.last().unwrap_or(&[1e-6; 2]))
    });
    // Whatever is opened from this and shared again must give the same.
    match placed(&sculpture.wire, &fine) {
        Some(wire) => on_grid(&wire, &grids).unwrap_or(fine),
        None => fine,
    }
}

/// To a grid that is `coarser` times as coarse as the coarsest of [`rounded`], wherever that moves it.
pub fn rounded_coarsely(sculpture: &Sculpture, coarser: f64) -> Rounded {
    let sight = Sight::new(sculpture);
    let steps = sight.grids(coarser).first().copied().unwrap_or([1e-3; 2]);
    nearest(&sculpture.wire, steps)
}

/// The same wire with its control points where they were rounded to.
pub fn placed(wire: &Wire, rounded: &Rounded) -> Option<Wire> {
    let points: Vec<_> = rounded.points.iter().map(|&point| point_from(point, rounded.steps)).collect();
    let mut wire = wire.clone();
    wire.set_control_points(&points).ok()?;
    Some(wire)
}

/// In world units.
pub fn point_from([x, y, z, width]: [i64; 4], steps: [f32; 2]) -> [f64; 4] {
    let [step, width_step] = steps.map(f64::from);
    let [x, y, z] = [x, y, z].map(|c| c as f64 * step);
    [x, y, z, width as f64 * width_step]
}

pub fn nearest(wire: &Wire, steps: [f32; 2]) -> Rounded {
    let [step, width_step] = steps.map(f64::from);
    let point = |&[x, y, z, width]: &[f64; 4]| {
        let [x, y, z] = [x, y, z].map(|c| (c / step).round() as i64);
        [x, y, z, (width / width_step).round() as i64]
    };
    Rounded { steps, points: wire.control_points().iter().map(point).collect() }
}

/// The wire on the first of the grids that it lies on already.
fn on_grid(wire: &Wire, grids: &[[f32; 2]]) -> Option<Rounded> {
    grids.iter().map(|&steps| nearest(wire, steps)).find(|rounded| {
        let points = wire.control_points().iter().zip(&rounded.points);
        points.into_iter().all(|(point, &steps)| *point == point_from(steps, rounded.steps))
    })
}

/// The views at 512 px, or three usual ones.
pub struct Sight {
    cameras: Vec<Camera<f64>>,
    pixels_per_world: f64,
    largest: f64,
}

impl Sight {
    pub fn new(sculpture: &Sculpture) -> Sight {
        let standard = View::canonical(2.2, SIZE_PX as usize);
        let views = if sculpture.views.is_empty() { &standard[..] } else { &sculpture.views };
        let points = sculpture.wire.control_points();
        let sized = |view: &View| {
            let scale = SIZE_PX / view.width_px.max(view.height_px) as f64;
            let size = |px: usize| ((px as f64 * scale).round() as usize).max(1);
            view.with_size(size(view.width_px), size(view.height_px)).camera::<f64>()
        };
        let cameras: Vec<_> = views.iter().map(sized).collect();
        let scales = cameras.iter().flat_map(|camera| points.iter().map(|point| camera.pixels_per_world(point)));
        let pixels_per_world = scales.fold(0.0, f64::max);
        let largest = points.iter().flatten().fold(0.0f64, |most, c| most.max(c.abs()));
        Sight { cameras, pixels_per_world, largest }
    }

    /// Steps from the coarsest, made `coarser`, to the finest.
    fn grids(&self, coarser: f64) -> Vec<[f32; 2]> {
        let step = |px: f64| short((px / self.pixels_per_world).max(self.largest / MAX_STEPS).max(1e-9));
        let coarsest = COARSEST_PX.map(|px| step(px * coarser).to_bits() >> STEP_ZEROS);
        let finest = FINEST_PX.map(|px| step(px).to_bits() >> STEP_ZEROS);
        let step_of = |bits: u32| f32::from_bits(bits << STEP_ZEROS);
        (0..=coarsest[0].saturating_sub(finest[0]))
            .map(|down| [step_of(coarsest[0] - down), step_of(coarsest[1].saturating_sub(down).max(finest[1]))])
            .collect()
    }

    /// How far the curve moved about each of its [`SAMPLES`] a span, as it is seen: along itself it may slip.
    fn moved_px(&self, wire: &Wire, rounded: &Rounded) -> Vec<f64> {
        let (_, strokes) = wire.sampling_map::<f64>(SAMPLES, false);
        let mut moved = vec![f64::INFINITY; strokes.iter().map(|stroke| stroke.count).sum()];
        let Some(other) = placed(wire, rounded) else { return moved };
        moved.fill(0.0);
        let pairs = strands(wire, CHECKED_SAMPLES).into_iter().zip(strands(&other, CHECKED_SAMPLES));
        for (stroke, (before, after)) in strokes.iter().zip(pairs) {
            for camera in &self.cameras {
                let seen =
                    |strand: &Strand| strand.points.iter().map(|point| camera.project(point)).collect::<Vec<_>>();
                let (before, after) = (seen(&before), seen(&after));
                for (from, to) in [(&before, &after), (&after, &before)] {
                    for at in 0..from.len() {
                        let most = &mut moved[stroke.start + at * SAMPLES / CHECKED_SAMPLES];
                        *most = most.max(strayed_px(at, from, to, *most));
                    }
                }
            }
        }
        moved
    }

    /// How far points are apart in the views, centre and radius together: at most, and in the mean.
    pub fn apart_px(&self, points: &[[f64; 4]], others: &[[f64; 4]]) -> (f64, f64) {
        let (mut most, mut sum, mut count) = (0.0f64, 0.0, 0.0f64);
        for camera in &self.cameras {
            for (p, q) in points.iter().zip(others) {
                let ([x, y, r], [u, v, s]) = (camera.project(p), camera.project(q));
                let moved = (x - u).hypot(y - v) + (r - s).abs();
                most = most.max(moved);
                sum += moved;
                count += 1.0;
            }
        }
        (most, sum / count.max(1.0))
    }

    /// To the grid, with the curve held in place as well as can be; and how far it moved at most.
    fn round(&self, wire: &Wire, steps: [f32; 2]) -> (Rounded, f64) {
        let mut rounded = nearest(wire, steps);
        let mut tension = Tension::new(self, wire, &rounded);
        let mut most = f64::INFINITY;
        for _ in 0..REPAIRS {
            for _ in 0..ROUNDS {
                let moves = (0..rounded.points.len()).filter(|&i| tension.relax(i, &mut rounded)).count();
                if moves == 0 {
                    break;
                }
            }
            let moved = self.moved_px(wire, &rounded);
            most = moved.iter().copied().fold(0.0, f64::max);
            if !tension.hold(&moved) {
                break;
            }
        }
        (rounded, most)
    }
}

/// How far a place of a polyline, `[x, y, radius]`, is from another that runs beside it; what the radius differs by added.
/// Where that is at most `enough`, any number up to it. Never inlined, like [`Tension::relax`].
#[inline(never)]
fn strayed_px(at: usize, from: &[[f64; 3]], to: &[[f64; 3]], enough: f64) -> f64 {
    let mut least = f64::INFINITY;
    // From its own place outward: what is near is mostly there.
    for step in 0..CHECKED_SAMPLES {
        for start in [Some(at + step), at.checked_sub(step + 1)].into_iter().flatten() {
            if let Some([before, after]) = to.get(start..start + 2) {
                least = least.min(apart_px(&from[at], before, after));
            }
        }
        if least <= enough {
            break;
        }
    }
    least
}

/// How far a place is from the piece between two others.
fn apart_px(p: &[f64; 3], from: &[f64; 3], to: &[f64; 3]) -> f64 {
    let [along, off] = [[to[0] - from[0], to[1] - from[1]], [p[0] - from[0], p[1] - from[1]]];
    let square = along[0] * along[0] + along[1] * along[1];
    let share = if square > 0.0 { ((along[0] * off[0] + along[1] * off[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    let [x, y] = [off[0] - share * along[0], off[1] - share * along[1]];
    (x * x + y * y).sqrt() + (p[2] - from[2] - share * (to[2] - from[2])).abs()
}

/// The nearest number below that has few bits.
pub fn short(x: f64) -> f32 {
    f32::from_bits((x as f32).to_bits() >> STEP_ZEROS << STEP_ZEROS)
}

/// A sample of the curve: how far its rounding moves it, in world units, and what that shows.
struct Sample {
    off: [f64; 4],
    views: Vec<Shown>,
}

/// Pixels a world unit along x, y, z, seen across the curve and along it, and a unit of width.
struct Shown {
    across: [f64; 3],
    along: [f64; 3],
    radius: f64,
    /// How much it counts what it moves along itself.
    slip: f64,
}

impl Shown {
    fn new(camera: &Camera<f64>, behind: &[f64; 4], place: &[f64; 4], ahead: &[f64; 4]) -> Shown {
        let [x, y, radius] = [0, 1, 2].map(|k| camera.project_vjp(place, &std::array::from_fn(|c| f64::from(c == k))));
        let [from, at, to] = [behind, place, ahead].map(|place| camera.project(place));
        let [a, b] = [[at[0] - from[0], at[1] - from[1]], [to[0] - at[0], to[1] - at[1]]];
        let (u, v) = (a[0] + b[0], a[1] + b[1]);
        let length = u.hypot(v);
        // Where it is seen to turn, any way is across.
        let straight = length > 2.0 && a[0] * b[0] + a[1] * b[1] > STRAIGHT * a[0].hypot(a[1]) * b[0].hypot(b[1]);
        let (slip, [u, v]) = if straight { (SLIP, [u / length, v / length]) } else { (1.0, [1.0, 0.0]) };
        Shown {
            across: std::array::from_fn(|c| u * y[c] - v * x[c]),
            along: std::array::from_fn(|c| u * x[c] + v * y[c]),
            radius: radius[3],
            slip,
        }
    }

    fn moved_px(&self, off: &[f64; 4]) -> f64 {
        let dot = |a: &[f64; 3]| a[0] * off[0] + a[1] * off[1] + a[2] * off[2];
        let (across, along) = (dot(&self.across), self.slip * dot(&self.along));
        (across * across + along * along).sqrt() + (self.radius * off[3]).abs()
    }
}

/// About how many bits it takes to write a control point and the two that are guessed from it, up to a constant.
fn bits_about(points: &[[i64; 4]], point: usize) -> f64 {
    let step = |at: usize, c: usize| (points[at][c] - points[at - 1][c]) as f64;
    let bits = |at: usize| {
        let (mut miss, mut far, mut far_before) = (1.0, 0.0, 0.0);
        for c in 0..3 {
            let (now, before) = (step(at, c), step(at - 1, c));
            let bend = now - 0.9 * before + 0.1 * step(at - 2, c);
            miss += bend * bend / 6.0;
            far += now * now;
            far_before += before * before;
        }
        let uneven = far.sqrt() - far_before.sqrt();
        let thicker = step(at, 3) - 0.7 * step(at - 1, 3);
        (miss * miss * (1.0 + uneven * uneven / 2.0) * (1.0 + 2.0 * thicker * thicker)).log2() / 2.0
    };
    (point.max(3)..(point + 3).min(points.len())).map(bits).sum()
}

/// How the rounding pulls at the curve.
struct Tension {
    samples: Vec<Sample>,
    /// The samples that each control point moves, and how much.
    moved_by: Vec<Vec<(usize, f64)>>,
}

impl Tension {
    fn new(sight: &Sight, wire: &Wire, rounded: &Rounded) -> Tension {
        let (map, _) = wire.sampling_map::<f64>(SAMPLES, false);
        let pairs = wire.control_points().iter().zip(&rounded.points);
        let misses: Vec<[f64; 4]> = pairs
            .map(|(point, &steps)| {
                let rounded = point_from(steps, rounded.steps);
                std::array::from_fn(|c| rounded[c] - point[c])
            })
            .collect();
        let (mut places, mut offs) = (Vec::new(), Vec::new());
        map.apply(wire.control_points(), &mut places);
        map.apply(&misses, &mut offs);
        let view = |at: usize| {
            let [behind, ahead] = [at + places.len() - 1, at + 1].map(|at| &places[at % places.len()]);
            sight.cameras.iter().map(|camera| Shown::new(camera, behind, &places[at], ahead)).collect()
        };
        let samples = offs.into_iter().enumerate().map(|(at, off)| Sample { off, views: view(at) }).collect();
        let mut moved_by = vec![Vec::new(); map.columns()];
        for (at, row) in map.rows().iter().enumerate() {
            for k in (0..4).filter(|&k| row.weights[k] != 0.0) {
                moved_by[(row.first as usize + k) % map.columns()].push((at, row.weights[k]));
            }
        }
        Tension { samples, moved_by }
    }

    /// Lets samples that moved too far slip no more; whether there are any that did.
    fn hold(&mut self, moved: &[f64]) -> bool {
        let mut held = false;
        for (sample, _) in self.samples.iter_mut().zip(moved).filter(|(_, moved)| **moved > MOST_PX) {
            for view in sample.views.iter_mut().filter(|view| view.slip < 1.0) {
                held = true;
                view.slip = 1.0;
            }
        }
        held
    }

    /// With a control point moved `by`: rises steeply where a sample comes to the limit. What is `enough` is not looked into
    /// any further.
    fn about(&self, point: usize, by: &[f64; 4], enough: f64) -> f64 {
        let pull = |&(at, weight): &(usize, f64)| {
            let Sample { off, views } = &self.samples[at];
            let off = std::array::from_fn(|c| off[c] + weight * by[c]);
            let share = views.iter().map(|view| view.moved_px(&off)).fold(0.0, f64::max) / MOST_PX;
            let square = share * share;
            let fourth = square * square;
            let pull = fourth * fourth * fourth * square;
            if share > 1.0 { pull + BEYOND * share } else { pull }
        };
        let mut sum = 0.0;
        for sample in &self.moved_by[point] {
            sum += pull(sample);
            if sum >= enough {
                break;
            }
        }
        sum
    }

    /// Moves a control point to the neighbour on the grid with the least tension that is cheap to write; whether that is
    /// another place. Never inlined: an engine that compiles functions better only from call to call has to meet it anew.
    #[inline(never)]
    fn relax(&mut self, point: usize, rounded: &mut Rounded) -> bool {
        let place = rounded.points[point];
        let step = point_from([1; 4], rounded.steps);
        let (mut least, mut best) = (f64::INFINITY, [0i64; 4]);
        let moves = (0..27).map(|k| [(k + 1) % 3 - 1, (k / 3 + 1) % 3 - 1, (k / 9 + 1) % 3 - 1, 0]);
        let thicker = [[0, 0, 0, 1], [0, 0, 0, -1]];
        for by in moves.chain(thicker).filter(|by| place[3] + by[3] >= 0) {
            let tension = self.about(point, &std::array::from_fn(|c| by[c] as f64 * step[c]), least);
            if tension >= least {
                continue;
            }
            rounded.points[point] = std::array::from_fn(|c| place[c] + by[c]);
            let cost = tension + THRIFT * bits_about(&rounded.points, point);
            if cost < least - 1e-9 {
                (least, best) = (cost, by);
            }
        }
        rounded.points[point] = std::array::from_fn(|c| place[c] + best[c]);
        for &(at, weight) in &self.moved_by[point] {
            for c in 0..4 {
                self.samples[at].off[c] += weight * best[c] as f64 * step[c];
            }
        }
        best != [0; 4]
    }
}
