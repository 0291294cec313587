//! Width-guided re-initialisation: control points whose width has vanished start again elsewhere.

use super::engine::State;
use crate::rng::Rng;
use crate::view::{Camera, Image};
use crate::{Error, Result};

/// Where a re-initialised control point goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NewPoint {
    /// To a place that is ink in every view and still lacks it in some, spliced in between the two neighbours that add
    /// the least length. Control points change their order along the wire.
    #[default]
    LackingInk,
    /// Anywhere in a ball of 0.8 half picture sides, in its place in the order: the paper's text.
    RandomInVolume,
    /// Halfway between its neighbours: the authors' release.
    Midpoint,
}

/// Which control points start again, and where.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Reinit {
    /// Thinner ones than this (full diameter, pixels of a 256 px picture) do.
    pub below_px: f64,
    /// Where they go.
    pub new_point: NewPoint,
}

impl Default for Reinit {
    fn default() -> Self {
        Reinit { below_px: 0.1, new_point: NewPoint::LackingInk }
    }
}

impl Reinit {
    pub(super) fn check(&self) -> Result<()> {
        if self.below_px.is_finite() && self.below_px >= 0.0 {
            return Ok(());
        }
        Err(Error::setting("reinit", format!("a width of {} px", self.below_px), "give a width from 0 up"))
    }
}

/// The volume new points come from, and what each view lacks there.
pub(super) struct Volume<'a> {
    /// Half the side of the cube that pictures show, world units.
    pub half_world: f64,
    /// For each view: camera, ink and ink that lacks, all at one small size.
    pub views: &'a [(Camera<f32>, Image, Image)],
}

/// Voxels along each side of the cube that is searched for places that lack ink.
const GRID: usize = 64;
/// Share of ink from which on a pixel of the small pictures counts as ink.
const INK: f32 = 0.15;

impl Volume<'_> {
    /// The lack of ink at a point, summed over the views: 0 unless every view has ink there.
    fn lack(&self, point: [f32; 3]) -> f32 {
        let mut sum = 0.0;
        for (camera, ink, lack) in self.views {
            let [x, y, _] = camera.project(&[point[0], point[1], point[2], 0.0]);
            // Off the picture there is no ink; NaN and negative values become 0, so compare first.
            if !(x >= 0.0 && y >= 0.0 && x < ink.width as f32 && y < ink.height as f32) {
                return 0.0;
            }
            if ink.at(x as usize, y as usize) < INK {
                return 0.0;
            }
            sum += lack.at(x as usize, y as usize);
        }
        sum
    }

    fn voxel(&self, index: usize, offset: [f64; 3]) -> [f32; 3] {
        let cell = [index % GRID, index / GRID % GRID, index / (GRID * GRID)];
        [0, 1, 2].map(|c| (((cell[c] as f64 + offset[c]) / GRID as f64 * 2.0 - 1.0) * self.half_world) as f32)
    }

    /// `count` points drawn with the lack of ink as their probability; none where nothing lacks.
    fn draw_lacking(&self, count: usize, rng: &mut Rng) -> Vec<[f32; 3]> {
        let mut running = 0.0;
        let cumulative: Vec<f64> = (0..GRID * GRID * GRID)
            .map(|i| {
                running += f64::from(self.lack(self.voxel(i, [0.5; 3])));
                running
            })
            .collect();
        if running <= 0.0 {
            return Vec::new();
        }
        (0..count)
            .map(|_| {
                let at = rng.range(0.0, running);
                let index = cumulative.partition_point(|&sum| sum <= at).min(cumulative.len() - 1);
                self.voxel(index, [rng.unit(), rng.unit(), rng.unit()])
            })
            .collect()
    }

    fn random(&self, rng: &mut Rng) -> [f32; 3] {
        rng.in_ball(0.8 * self.half_world).map(|c| c as f32)
    }
}

/// Starts vanished control points again, with the median width of the others and zero moments, and says how many.
/// `splice`: whether control points may change their order (a plain spline's may). `below`: width in world units.
pub(super) fn reinit(
    options: &Reinit,
    below: f32,
    closed: bool,
    splice: bool,
    volume: &Volume,
    state: &mut State,
    rng: &mut Rng,
) -> usize {
    let vanished: Vec<usize> = (0..state.points.len()).filter(|&i| state.points[i][3] <= below).collect();
    let mut live: Vec<f32> = state.points.iter().map(|point| point[3]).filter(|&width| width > below).collect();
    if vanished.is_empty() || live.is_empty() {
        return 0;
    }
    live.sort_unstable_by(f32::total_cmp);
    let width = live[live.len() / 2];
    let places = match options.new_point {
        NewPoint::LackingInk => volume.draw_lacking(vanished.len(), rng),
        _ => Vec::new(),
    };
    // From the last on, so that removing one leaves the indices of those before it alone.
    for (turn, &i) in vanished.iter().rev().enumerate() {
        let count = state.points.len();
        let neighbours = match (closed, i) {
            (true, _) => [(i + count - 1) % count, (i + 1) % count],
            (false, 0) => [0, 1],
            (false, _) => [i - 1, (i + 1).min(count - 1)],
        };
        let place = match options.new_point {
            NewPoint::Midpoint => {
                let [a, b] = neighbours.map(|j| state.points[j]);
                [0, 1, 2].map(|c| 0.5 * (a[c] + b[c]))
            }
            NewPoint::RandomInVolume => volume.random(rng),
            NewPoint::LackingInk => match places.get(turn) {
                Some(&place) => place,
                // Nothing lacks: out of the way is as good as anywhere.
                None => volume.random(rng),
            },
        };
        state.points[i] = [place[0], place[1], place[2], width];
        state.adam.first[i] = [0.0; 4];
        state.adam.second[i] = [0.0; 4];
    }
    if splice && options.new_point == NewPoint::LackingInk {
        splice_in(&vanished, closed, state);
    }
    vanished.len()
}

/// Takes the control points `moved` out of the order and puts each in where it adds the least length.
fn splice_in(moved: &[usize], closed: bool, state: &mut State) {
    let mut order: Vec<usize> = (0..state.points.len()).filter(|i| moved.binary_search(i).is_err()).collect();
    let distance = |a: usize, b: usize| {
        let (p, q) = (state.points[a], state.points[b]);
        (0..3).map(|c| (p[c] - q[c]) * (p[c] - q[c])).sum::<f32>().sqrt()
    };
    for &i in moved {
        let edges = if closed { order.len() } else { order.len() - 1 };
        let added = |e: usize| {
            let (a, b) = (order[e], order[(e + 1) % order.len()]);
            distance(a, i) + distance(i, b) - distance(a, b)
        };
        let best = (0..edges).min_by(|&e, &f| added(e).total_cmp(&added(f))).unwrap_or(0);
        order.insert((best + 1).min(order.len()), i);
    }
    let reordered = |values: &[[f32; 4]]| order.iter().map(|&i| values[i]).collect::<Vec<_>>();
    state.points = reordered(&state.points);
    state.adam.first = reordered(&state.adam.first);
    state.adam.second = reordered(&state.adam.second);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optimize::Adam;
    use crate::view::View;

    fn line(count: usize) -> State {
        let points = (0..count).map(|i| [0.1 * i as f32, 0.0, 0.0, if i == 2 { 0.0 } else { 0.04 }]).collect();
        let mut adam = Adam::new(count);
        adam.second.fill([1.0; 4]);
        State { points, adam }
    }

    /// Two views that lack ink only in the corner x, y, z ≈ 0.5.
    fn views() -> Vec<(Camera<f32>, Image, Image)> {
        let [front, side, _] = View::canonical(2.0, 64);
        [front, side]
            .iter()
            .map(|view| {
                let camera = view.camera::<f32>();
                let [x, y, _] = camera.project(&[0.5, 0.5, 0.5, 0.0]);
                let mut ink = Image::new(64, 64);
                ink.data[y as usize * 64 + x as usize] = 1.0;
                (camera, ink.clone(), ink)
            })
            .collect()
    }

    fn run(new_point: NewPoint, views: &[(Camera<f32>, Image, Image)]) -> (usize, State) {
        let mut state = line(6);
        let volume = Volume { half_world: 1.0, views };
        let options = Reinit { new_point, ..Default::default() };
        let count = reinit(&options, 1e-3, false, true, &volume, &mut state, &mut Rng::new(0, 0));
        (count, state)
    }

    #[test]
    fn lacking_ink_is_found_and_the_point_spliced_in_at_the_nearest_end() {
        let (count, state) = run(NewPoint::LackingInk, &views());
        assert_eq!(count, 1);
        let i = state.points.iter().position(|p| p[1] != 0.0).unwrap();
        let p = state.points[i];
        assert!((0..3).all(|c| (p[c] - 0.5).abs() < 0.05) && p[3] == 0.04, "{p:?}");
        assert_eq!(i, 4, "between the last two control points, near x = 0.5");
        assert_eq!((state.adam.second[i], state.adam.second[0]), ([0.0; 4], [1.0; 4]));
    }

    #[test]
    fn the_other_places_keep_the_order() {
        let (_, midpoint) = run(NewPoint::Midpoint, &[]);
        assert!((midpoint.points[2][0] - 0.2).abs() < 1e-6 && midpoint.points[2][3] == 0.04);
        let (_, random) = run(NewPoint::RandomInVolume, &[]);
        assert!(random.points[2][1] != 0.0);
        let others = |state: &State| [0, 1, 3, 4, 5].map(|i| state.points[i]);
        assert!(others(&random) == others(&line(6)) && others(&midpoint) == others(&line(6)));
    }

    #[test]
    fn nothing_vanished_nothing_done() {
        let mut state = line(6);
        state.points[2][3] = 0.04;
        let before = state.clone();
        let volume = Volume { half_world: 1.0, views: &[] };
        assert_eq!(reinit(&Reinit::default(), 1e-3, false, true, &volume, &mut state, &mut Rng::new(0, 0)), 0);
        assert_eq!(state, before);
    }
}
