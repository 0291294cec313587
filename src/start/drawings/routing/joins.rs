//! Which hidden ways to add so that every voxel is left as often as it is entered (route inspection, Kwan 1962): the odd
//! places of a tree paired at least cost (Edmonds and Johnson 1973).

use super::super::grid::{Grid, OFF_PICTURE};
use super::super::shortest::Shortest;
use super::super::tree::Tree;
use super::CircuitOptions;
use super::matching::cheapest_pairs;
use crate::parallel;
use crate::sorting::sort_by;
use std::collections::HashMap;

/// Other odd places each search looks for: the one a place is paired with is nearly always among the nearest few.
const NEAREST: usize = 10;
/// Odd places that are paired exactly; where there are more, the nearest two are paired until this many are left.
const MOST_EXACT: usize = 400;
/// Parts of a voxel's price that matching can tell apart.
const RESOLUTION: f32 = 256.0;

/// Price of a voxel's length: 1 where all views show ink already, more where something would show or the tree is.
pub struct Prices {
    of: Vec<f32>,
    most: f32,
}

impl Prices {
    /// Prices beside a graph of `voxels`.
    pub fn new(grid: &Grid, tree: &Tree, voxels: &[u32], options: &CircuitOptions) -> Prices {
        let across = grid.plane_size.iter().map(|size| size[1]).max().unwrap_or(64) as f32;
        let farthest = options.farthest_px_at_128 * across / 128.0;
        let mut of = vec![1.0f32; grid.voxels()];
        for (plane, pixel) in tree.planes.iter().zip(&grid.pixel) {
            let mut sheet: Vec<f32> = plane
                .stray_px
                .iter()
                .map(|&stray| match stray {
                    0.0 => 0.0,
                    stray if stray <= farthest => options.stray_price * stray,
                    _ => f32::INFINITY,
                })
                .collect();
            for &voxel in voxels {
                let p = pixel[voxel as usize] as usize;
                sheet[p] = sheet[p].min(options.shown_price);
            }
            for (price, &p) in of.iter_mut().zip(pixel) {
                *price += if p == OFF_PICTURE { f32::INFINITY } else { sheet[p as usize] };
            }
        }
        for &voxel in voxels {
            of[voxel as usize] += options.again_price;
        }
        let most = of.iter().copied().filter(|price| price.is_finite()).fold(1.0, f32::max);
        Prices { of, most }
    }

    /// Price of a voxel.
    pub fn at(&self, voxel: u32) -> f32 {
        self.of[voxel as usize]
    }

    /// What a walk costs.
    pub fn along(&self, walk: &[u32], length: impl Fn(u32, u32) -> f32) -> f32 {
        let step =
            |step: &[u32]| 0.5 * (self.of[step[0] as usize] + self.of[step[1] as usize]) * length(step[0], step[1]);
        walk.windows(2).map(step).sum()
    }

    /// Searches from `source` up to cost `limit` or a voxel of which `enough` says so.
    pub fn search(
        &self,
        shortest: &mut Shortest,
        neighbours: &[(isize, f32)],
        source: u32,
        limit: f32,
        enough: impl FnMut(u32) -> bool,
    ) {
        shortest.search_until(neighbours, |voxel| self.of[voxel], [1.0, self.most], &[source], limit, enough);
    }
}

/// A way between two odd places.
struct Way {
    to: usize,
    cost: f32,
    voxels: Vec<u32>,
}

/// The steps that make every voxel of connected `edges` even.
pub fn joins(grid: &Grid, edges: &[[u32; 2]], prices: &Prices) -> Vec<[u32; 2]> {
    let mut degree: HashMap<u32, usize> = HashMap::new();
    for voxel in edges.iter().flatten() {
        *degree.entry(*voxel).or_default() += 1;
    }
    let mut odd: Vec<u32> = degree.iter().filter(|(_, degree)| *degree % 2 == 1).map(|(&voxel, _)| voxel).collect();
    odd.sort_unstable();
    let ways = all_ways(grid, &odd, prices);
    let mut steps = Vec::new();
    for [a, b] in paired(&ways) {
        let way = ways[a].iter().find(|way| way.to == b).or_else(|| ways[b].iter().find(|way| way.to == a));
        let voxels = match way {
            Some(way) => way.voxels.clone(),
            None => {
                let mut shortest = Shortest::new(grid.voxels());
                prices.search(&mut shortest, &grid.neighbours(), odd[a], f32::MAX, |voxel| voxel == odd[b]);
                shortest.path_back(odd[b]).collect()
            }
        };
        steps.extend(voxels.windows(2).map(|step| [step[0], step[1]]));
    }
    steps
}

/// From each odd place the cheapest ways to the nearest others.
fn all_ways(grid: &Grid, odd: &[u32], prices: &Prices) -> Vec<Vec<Way>> {
    let index: HashMap<u32, usize> = odd.iter().copied().zip(0..).collect();
    let neighbours = grid.neighbours();
    let wanted = NEAREST.min(odd.len().saturating_sub(1));
    let ways = |shortest: &mut Shortest, &source: &u32| {
        let mut found = Vec::with_capacity(wanted);
        prices.search(shortest, &neighbours, source, f32::MAX, |voxel| {
            found.extend(index.get(&voxel).filter(|_| voxel != source));
            found.len() >= wanted
        });
        found
            .into_iter()
            .map(|to| Way { to, cost: shortest.distance(odd[to]), voxels: shortest.path_back(odd[to]).collect() })
            .collect::<Vec<_>>()
    };
    parallel::map_with(odd, || Shortest::new(grid.voxels()), ways)
}

/// Pairs of places at least total cost.
fn paired(ways: &[Vec<Way>]) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    let mut left: Vec<bool> = vec![true; ways.len()];
    let mut count = ways.len();
    if count > MOST_EXACT {
        let mut nearest: Vec<(f32, usize, usize)> =
            ways.iter().enumerate().flat_map(|(a, ways)| ways.iter().map(move |way| (way.cost, a, way.to))).collect();
        sort_by(&mut nearest, |x, y| x.0.total_cmp(&y.0).then((x.1, x.2).cmp(&(y.1, y.2))));
        for (_, a, b) in nearest {
            if count > MOST_EXACT && left[a] && left[b] {
                pairs.push([a, b]);
                (left[a], left[b]) = (false, false);
                count -= 2;
            }
        }
    }
    let rest: Vec<usize> = (0..ways.len()).filter(|&a| left[a]).collect();
    // Beyond what the searches found: over other places, or dearer than any way.
    let costs = closure(&rest, ways);
    let mate = cheapest_pairs(rest.len(), |a, b| costs[a * rest.len() + b]);
    pairs.extend((0..rest.len()).filter(|&a| a < mate[a]).map(|a| [rest[a], rest[mate[a]]]));
    pairs
}

/// Costs between all of `places`, where no way was found the cheapest over places between (Floyd 1962).
fn closure(places: &[usize], ways: &[Vec<Way>]) -> Vec<i64> {
    const FAR: i64 = 1 << 40;
    let n = places.len();
    let mut slot = vec![usize::MAX; ways.len()];
    places.iter().enumerate().for_each(|(i, &a)| slot[a] = i);
    let mut costs = vec![FAR; n * n];
    for (i, &a) in places.iter().enumerate() {
        costs[i * n + i] = 0;
        for way in ways[a].iter().filter(|way| slot[way.to] != usize::MAX) {
            let j = slot[way.to];
            let cost = (way.cost * RESOLUTION).round() as i64;
            costs[i * n + j] = costs[i * n + j].min(cost);
            costs[j * n + i] = costs[j * n + i].min(cost);
        }
    }
    for k in 0..n {
        for i in 0..n {
            let first = costs[i * n + k];
            if first < FAR {
                for j in 0..n {
                    let over = first + costs[k * n + j];
                    if over < costs[i * n + j] {
                        costs[i * n + j] = over;
                    }
                }
            }
        }
    }
    costs
}
