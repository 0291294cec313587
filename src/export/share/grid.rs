//! Rounds a wire to the coarsest grid with which its curve stays where it is, as far as its views can show.
//!
//! A control point may go to any neighbour on the grid that keeps the curve in place: where roundings work against each
//! other, the grid can be a good deal coarser than if each point had to stay by itself.

use crate::sculpture::{Sculpture, strands};
use crate::view::{Camera, View};
use crate::wire::{LinearMap, Wire};

/// Picture size for which the precision is chosen.
const SIZE_PX: f64 = 512.0;
/// How far a point of the curve and its radius may move together, in those pixels: 0.3, with some left for knots.
const MOST_PX: f64 = 0.298;
/// The coarsest steps that are tried, of coordinates and of widths, and the finest, which always do.
const COARSEST_PX: [f64; 2] = [0.61, 0.29];
const FINEST_PX: [f64; 2] = [0.21, 0.23];
/// Coordinates are at most this many steps, however near an eye is.
const MAX_STEPS: f64 = (1u64 << 24) as f64;
/// Steps have four bits after the leading one.
const STEP_ZEROS: u32 = 19;
const SAMPLES: usize = 4;
const CHECKED_SAMPLES: usize = 16;
const ROUNDS: usize = 16;

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
        let fits = |rounded: &Rounded| sight.moved_px(&sculpture.wire, rounded) <= MOST_PX;
        let mut tried = grids.iter().map(|&steps| sight.round(&sculpture.wire, steps));
        // The finest is right by itself.
        tried.find(fits).unwrap_or_else(|| nearest(&sculpture.wire, *grids.last().unwrap_or(&[1e-6; 2])))
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

fn nearest(wire: &Wire, steps: [f32; 2]) -> Rounded {
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

    /// How far the curve moved at most.
    fn moved_px(&self, wire: &Wire, rounded: &Rounded) -> f64 {
        let points =
            |wire: &Wire| strands(wire, CHECKED_SAMPLES).into_iter().flat_map(|s| s.points).collect::<Vec<_>>();
        placed(wire, rounded).map_or(f64::INFINITY, |other| self.apart_px(&points(wire), &points(&other)).0)
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

    /// To the grid, with the curve held in place as well as can be.
    fn round(&self, wire: &Wire, steps: [f32; 2]) -> Rounded {
        let mut rounded = nearest(wire, steps);
        let (map, _) = wire.sampling_map::<f64>(SAMPLES, false);
        let misses = wire.control_points().iter().zip(&rounded.points);
        let misses =
            misses.map(|(point, &steps)| std::array::from_fn(|c| point_from(steps, rounded.steps)[c] - point[c]));
        let mut tension =
            Tension { misses: misses.collect(), samples: self.samples(wire, &map), touching: touching(&map) };
        for _ in 0..ROUNDS {
            let moves = (0..rounded.points.len()).filter(|&i| tension.relax(i, &mut rounded)).count();
            if moves == 0 {
                break;
            }
        }
        rounded
    }

    /// What each sample of the curve shows, linear about where it is.
    fn samples(&self, wire: &Wire, map: &LinearMap<f64>) -> Vec<Sample> {
        let mut places = Vec::new();
        map.apply(wire.control_points(), &mut places);
        let columns = map.columns();
        let rows = map.rows().iter().zip(&places);
        rows.map(|(row, place)| Sample {
            columns: std::array::from_fn(|k| (row.first as usize + k) % columns),
            weights: row.weights,
            shown: self.cameras.iter().map(|camera| Shown::new(camera, place)).collect(),
        })
        .collect()
    }
}

/// The nearest number below that has few bits.
fn short(x: f64) -> f32 {
    f32::from_bits((x as f32).to_bits() >> STEP_ZEROS << STEP_ZEROS)
}

/// Pixels a world unit along x, y, z and of width.
struct Shown {
    x: [f64; 3],
    y: [f64; 3],
    radius: f64,
}

impl Shown {
    fn new(camera: &Camera<f64>, place: &[f64; 4]) -> Shown {
        let x = camera.project_vjp(place, &[1.0, 0.0, 0.0]);
        let y = camera.project_vjp(place, &[0.0, 1.0, 0.0]);
        let radius = camera.project_vjp(place, &[0.0, 0.0, 1.0]);
        Shown { x: [x[0], x[1], x[2]], y: [y[0], y[1], y[2]], radius: radius[3] }
    }
}

struct Sample {
    columns: [usize; 4],
    weights: [f64; 4],
    shown: Vec<Shown>,
}

/// The samples that each control point moves.
fn touching(map: &LinearMap<f64>) -> Vec<Vec<usize>> {
    let mut touching = vec![Vec::new(); map.columns()];
    for (at, row) in map.rows().iter().enumerate() {
        for k in (0..4).filter(|&k| row.weights[k] != 0.0) {
            touching[(row.first as usize + k) % map.columns()].push(at);
        }
    }
    touching
}

/// How the rounding pulls at the curve.
struct Tension {
    /// By how much each control point is off.
    misses: Vec<[f64; 4]>,
    samples: Vec<Sample>,
    touching: Vec<Vec<usize>>,
}

impl Tension {
    /// Rises steeply where a sample comes to the limit.
    fn about(&self, point: usize) -> f64 {
        self.touching[point].iter().map(|&at| (self.moved_px(&self.samples[at]) / MOST_PX).powi(14)).sum()
    }

    fn moved_px(&self, sample: &Sample) -> f64 {
        let mut d = [0.0; 4];
        for (column, weight) in sample.columns.iter().zip(sample.weights) {
            for (d, miss) in d.iter_mut().zip(self.misses[*column]) {
                *d += weight * miss;
            }
        }
        let dot = |a: &[f64; 3]| a[0] * d[0] + a[1] * d[1] + a[2] * d[2];
        let moved = |shown: &Shown| dot(&shown.x).hypot(dot(&shown.y)) + (shown.radius * d[3]).abs();
        sample.shown.iter().map(moved).fold(0.0, f64::max)
    }

    /// Moves a control point to the neighbour on the grid with the least tension; whether that is another place.
    fn relax(&mut self, point: usize, rounded: &mut Rounded) -> bool {
        let mut least = self.about(point);
        // Nothing comes near the limit.
        if least < 0.05 {
            return false;
        }
        let (place, miss) = (rounded.points[point], self.misses[point]);
        let step = point_from([1, 1, 1, 1], rounded.steps);
        let mut best = [0i64; 4];
        let moves = (0..27).map(|k| [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1, 0]).chain([[0, 0, 0, 1], [0, 0, 0, -1]]);
        for by in moves.filter(|by| place[3] + by[3] >= 0) {
            self.misses[point] = std::array::from_fn(|c| miss[c] + by[c] as f64 * step[c]);
            let tension = self.about(point);
            if tension < least - 1e-9 {
                (least, best) = (tension, by);
            }
        }
        self.misses[point] = std::array::from_fn(|c| miss[c] + best[c] as f64 * step[c]);
        rounded.points[point] = std::array::from_fn(|c| place[c] + best[c]);
        best != [0; 4]
    }
}
