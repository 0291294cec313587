//! From the tree to one closed trail that goes no way twice but where it must (route inspection): the tree pruned, its odd
//! places joined by the cheapest hidden ways, one circuit over all of it, as straight on as it can.

mod joins;
mod matching;
mod prune;
mod shorten;
mod taut;

use super::grid::Grid;
use super::pairing::{Graph, Pairing};
use super::trail::smooth_ring;
use super::tree::Tree;
use crate::start::Path;
use crate::start::path::{length, resampled};
use joins::Prices;
use prune::Cover;
use std::collections::HashSet;

/// How the tree becomes a circuit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircuitOptions {
    /// How much farther away than while the tree grew lines count as met when it is pruned, px of a 128 px picture.
    pub slack_px_at_128: f32,
    /// What a hidden way costs more for each px that it is off ink in a view, times its length: very dear, for a visible
    /// link is worse than walking back several times its length.
    pub stray_price: f32,
    /// The same where the tree shows there already, however far off ink: a second strand makes it stand out more.
    pub shown_price: f32,
    /// Beyond this no way goes, px of a 128 px picture off ink.
    pub farthest_px_at_128: f32,
    /// What walking a way of the tree again costs more than a way of its own, times its length.
    pub again_price: f32,
    /// What turning back costs where steps are put in order; bends cost -1 (straight on) to 1.
    pub hairpin_price: f64,
    /// Standard deviation of the smoothing round the circuit, steps of the reference grid of 64 voxels.
    pub smoothing_steps: f64,
    /// Width, px of a 128 px picture.
    pub width_px_at_128: f64,
}

impl Default for CircuitOptions {
    fn default() -> Self {
        CircuitOptions {
            slack_px_at_128: 1.0,
            stray_price: 8.0,
            shown_price: 0.5,
            farthest_px_at_128: 1.5,
            again_price: 0.2,
            hairpin_price: 2.0,
            smoothing_steps: 0.75,
            width_px_at_128: 2.0,
        }
    }
}

/// A closed walk over neighbouring voxels that shows what its tree shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Circuit {
    /// The voxels in order; the last is next to the first.
    pub voxels: Vec<u32>,
    /// Their places, world units, after the walk was pulled taut.
    pub places: Vec<[f64; 3]>,
    /// What is left of the tree's edges.
    pub pruned: Vec<[u32; 2]>,
    /// Steps added to it, those that go over one of its edges again with them.
    pub joins: Vec<[u32; 2]>,
}

impl Circuit {
    /// The circuit round a tree.
    pub fn new(grid: &Grid, tree: &Tree, options: &CircuitOptions) -> Circuit {
        if tree.edges.is_empty() {
            return Circuit {
                voxels: vec![tree.root; 2],
                places: vec![grid.position(tree.root as usize); 2],
                pruned: Vec::new(),
                joins: Vec::new(),
            };
        }
        let slack_px = options.slack_px_at_128 * across(grid) / 128.0;
        let pruned = prune::pruned(grid, tree, slack_px);
        let mut voxels: Vec<u32> = pruned.iter().flatten().copied().collect();
        voxels.sort_unstable();
        voxels.dedup();
        let prices = Prices::new(grid, tree, &voxels, options);
        let joins = without_pairs(joins::joins(grid, &pruned, &prices));
        let walk = closed_walk(grid, &pruned, &joins, options.hairpin_price);
        let voxels = shorten::shortened(grid, walk, Cover::new(grid, tree, slack_px), &prices);
        let places = taut::taut(grid, tree, &voxels, slack_px, &prices);
        Circuit { voxels, places, pruned, joins }
    }

    /// The smoothed path along it.
    pub fn path(&self, grid: &Grid, options: &CircuitOptions) -> Path {
        let across = f64::from(across(grid));
        let width = options.width_px_at_128 * grid.spacing_world * across / 128.0;
        let taut = Path { points: self.places.iter().map(|&[x, y, z]| [x, y, z, width]).collect(), closed: true };
        // A point a voxel, so that smoothing is as wide everywhere.
        let count = (length(&taut) / grid.spacing_world).round().max(self.voxels.len().min(4) as f64);
        let mut points = resampled(&taut, count as usize);
        smooth_ring(&mut points, options.smoothing_steps * across / 64.0);
        Path { points, closed: true }
    }
}

/// Voxels along the tallest picture's height.
fn across(grid: &Grid) -> f32 {
    grid.plane_size.iter().map(|size| size[1]).max().unwrap_or(64) as f32
}

/// Steps without pairs of the same one: what an even number of ways goes over needs none of them.
fn without_pairs(mut steps: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    let mut odd = HashSet::new();
    for &[a, b] in &steps {
        let key = [a.min(b), a.max(b)];
        if !odd.remove(&key) {
            odd.insert(key);
        }
    }
    steps.retain(|&[a, b]| odd.remove(&[a.min(b), a.max(b)]));
    steps
}

/// One closed walk over connected edges and what joins them, of which an even number meets at every voxel.
fn closed_walk(grid: &Grid, edges: &[[u32; 2]], joins: &[[u32; 2]], hairpin: f64) -> Vec<u32> {
    let steps = [edges, joins].concat();
    let mut known = HashSet::with_capacity(steps.len());
    let distinct: Vec<[u32; 2]> = steps.iter().copied().filter(|&[a, b]| known.insert([a.min(b), a.max(b)])).collect();
    let graph = Graph::new(grid, &distinct);
    let mut pairing = Pairing::new(&graph, &steps, hairpin);
    pairing.join_trails(&graph);
    let mut walk = pairing.walk();
    walk.pop();
    walk.into_iter().map(|vertex| graph.voxels[vertex as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::drawings::tree::{TreeOptions, grow_tree};
    use crate::start::testing::{letters, picture, targets};
    use crate::view::Target;

    fn grown(targets: &[Target], progress: &mut dyn FnMut(f32) -> bool) -> (Grid, Tree) {
        let options = TreeOptions { across: 64, ..TreeOptions::for_circuit() };
        let grid = Grid::new(targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, targets, &options, progress).unwrap();
        (grid, tree)
    }

    /// Rings of hair lines with a gap: a link would be short, and show.
    fn outlines() -> Vec<Target> {
        let ring = |radius: f64| {
            picture(move |x, y| {
                let (x, y) = (x - 0.5, y - 0.5);
                (x.hypot(y) - radius).abs() < 0.015 && (x < 0.0 || y.abs() > 0.06)
            })
        };
        targets(vec![ring(0.38), ring(0.37)])
    }

    fn walks_all(grid: &Grid, walk: &[u32], edges: &[[u32; 2]]) -> Result<(), String> {
        let neighbours = grid.neighbours();
        let mut walked = HashSet::new();
        for (i, &a) in walk.iter().enumerate() {
            let b = walk[(i + 1) % walk.len()];
            if !neighbours.iter().any(|n| n.0 == b as isize - a as isize) {
                return Err(format!("a jump from {a} to {b}"));
            }
            walked.insert([a.min(b), a.max(b)]);
        }
        let all = edges.iter().all(|&[a, b]| walked.contains(&[a.min(b), a.max(b)]));
        if all { Ok(()) } else { Err("an edge is left out".into()) }
    }

    /// Line pixels that the voxels do not meet.
    fn unmet(grid: &Grid, tree: &Tree, slack_px: f32, voxels: &[u32]) -> usize {
        let mut cover = Cover::new(grid, tree, slack_px);
        voxels.iter().for_each(|&voxel| cover.add(voxel));
        cover.unmet()
    }

    /// Pixels more than one off ink that the voxels show, over all views.
    fn stray_pixels(grid: &Grid, tree: &Tree, voxels: impl Iterator<Item = u32> + Clone) -> HashSet<(usize, u32)> {
        let shown = |(view, pixel): (usize, &Vec<u32>)| {
            let strays = |&p: &u32| tree.planes[view].stray_px[p as usize] > 1.0;
            voxels.clone().map(|voxel| pixel[voxel as usize]).filter(strays).map(|p| (view, p)).collect::<Vec<_>>()
        };
        grid.pixel.iter().enumerate().flat_map(shown).collect()
    }

    #[test]
    fn the_circuit_is_one_closed_walk_over_all_of_the_tree() {
        for targets in [letters(), outlines()] {
            let (grid, tree) = grown(&targets, &mut |_| true);
            let circuit = Circuit::new(&grid, &tree, &CircuitOptions::default());
            let walk = closed_walk(&grid, &circuit.pruned, &circuit.joins, 2.0);
            walks_all(&grid, &walk, &circuit.pruned).unwrap();
            assert_eq!(walk.len(), circuit.pruned.len() + circuit.joins.len(), "each step once");
            assert!(circuit.pruned.len() <= tree.edges.len() && walk.len() <= 2 * circuit.pruned.len());
            // Shortened, it may leave out what is shown twice.
            walks_all(&grid, &circuit.voxels, &[]).unwrap();
            assert!(circuit.voxels.len() <= walk.len());
            assert_eq!(unmet(&grid, &tree, 1.0, &circuit.voxels), 0);
            assert!(unmet(&grid, &tree, 1.0, &circuit.voxels[circuit.voxels.len() / 2..]) > 0);
            // The checks can fail.
            let mut jumps = walk.clone();
            jumps.swap(3, walk.len() / 2);
            assert!(walks_all(&grid, &jumps, &circuit.pruned).is_err());
            let there_and_back: Vec<u32> = walk[..9].iter().chain(walk[1..8].iter().rev()).copied().collect();
            assert!(walks_all(&grid, &there_and_back, &circuit.pruned).is_err());
            let path = circuit.path(&grid, &CircuitOptions::default());
            assert!(path.closed && path.points.iter().flatten().all(|x| x.is_finite()));
        }
    }

    #[test]
    fn sparse_outlines_get_no_visible_links() {
        let targets = outlines();
        let (grid, tree) = grown(&targets, &mut |_| true);
        let strays = |options: &CircuitOptions| {
            let circuit = Circuit::new(&grid, &tree, options);
            let shown = stray_pixels(&grid, &tree, circuit.voxels.iter().copied());
            let before = stray_pixels(&grid, &tree, circuit.pruned.iter().flatten().copied());
            shown.difference(&before).count()
        };
        assert_eq!(strays(&CircuitOptions::default()), 0);
        let careless = CircuitOptions { stray_price: 0.1, farthest_px_at_128: 50.0, ..CircuitOptions::default() };
        assert!(strays(&careless) > 5, "the check can fail: {}", strays(&careless));
    }

    #[test]
    fn what_is_pruned_shows_nothing_new() {
        let targets = letters();
        let (grid, tree) = grown(&targets, &mut |_| true);
        let unmet = |edges: &[[u32; 2]]| unmet(&grid, &tree, 0.5, edges.as_flattened());
        let pruned = prune::pruned(&grid, &tree, 0.5);
        assert!(pruned.len() < tree.edges.len());
        assert_eq!(unmet(&pruned), unmet(&tree.edges));
        assert!(unmet(&pruned[..pruned.len() - 9]) > unmet(&pruned), "the check can fail");
    }

    #[test]
    fn a_taut_walk_is_shorter_and_shows_as_much() {
        let (grid, tree) = grown(&letters(), &mut |_| true);
        let circuit = Circuit::new(&grid, &tree, &CircuitOptions::default());
        let apart = |a: [f64; 3], b: [f64; 3]| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt();
        let length = |places: &[[f64; 3]]| places.windows(2).map(|pair| apart(pair[0], pair[1])).sum::<f64>();
        let walked: Vec<[f64; 3]> = circuit.voxels.iter().map(|&voxel| grid.position(voxel as usize)).collect();
        assert!(length(&circuit.places) < 0.97 * length(&walked));
        let at = |places: &[[f64; 3]]| places.iter().map(|&at| grid.voxel(at).unwrap() as u32).collect::<Vec<u32>>();
        let voxels = at(&circuit.places);
        let strays = |voxels: &[u32]| stray_pixels(&grid, &tree, voxels.iter().copied());
        let shown = strays(tree.edges.as_flattened());
        assert!(strays(&voxels).is_subset(&shown));
        assert_eq!(unmet(&grid, &tree, 3.2, &voxels), 0);
        // The checks can fail: a ring that contracts freely shows less, and shows it elsewhere.
        let n = walked.len();
        let free: Vec<[f64; 3]> = (0..n)
            .map(|i| std::array::from_fn(|c| 0.5 * (walked[(i + n - 40) % n][c] + walked[(i + 40) % n][c])))
            .collect();
        assert!(!strays(&at(&free)).is_subset(&shown) && unmet(&grid, &tree, 3.2, &at(&free)) > 0);
    }

    #[test]
    #[cfg(feature = "threads")]
    fn same_circuit_on_any_number_of_threads() {
        let (grid, tree) = grown(&letters(), &mut |_| true);
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| Circuit::new(&grid, &tree, &CircuitOptions::default()))
        };
        let one = on(1);
        assert_eq!(one, on(4));
        assert_eq!(one, on(3));
    }

    #[test]
    fn what_has_grown_is_used_when_growth_is_stopped() {
        let (grid, tree) = grown(&letters(), &mut |_| false);
        let circuit = Circuit::new(&grid, &tree, &CircuitOptions::default());
        walks_all(&grid, &circuit.voxels, &[]).unwrap();
        assert!(circuit.voxels.len() > 4);
    }
}
