//! Which parts of a tree to walk twice when the wire should be short: the Chinese postman's problem (Kwan 1962), with
//! shortcuts through ink or, where that saves more than it shows, past it.

use super::grid::{Grid, OFF_PICTURE};
use super::pairing::Graph;
use super::shortest::{NO_PARENT, Shortest};
use super::tree::Tree;

/// Shortcuts longer than this are not looked for, as a share of the grid's side.
const REACH: f32 = 0.35;
/// What a shortcut must save at least, voxels: less is not worth losing a second strand.
const LEAST_SAVING: f32 = 2.0;
/// Price of a voxel that shows new stray ink, per view, where a voxel's length costs 1.
const STRAY_PRICE: f32 = 1.0;
/// No voxel to go to: spare, or outside a picture.
const NOWHERE: u8 = u8::MAX;
/// Rounds over all odd vertices; later ones find next to nothing.
const ROUNDS: usize = 3;

/// Shortens a trail that walks the tree once and the edges marked in `twice` once more: shortcut by shortcut the tree's
/// path between its two ends changes sides (what was walked twice is walked once and the other way round), which leaves
/// every vertex as even or odd as it was. Returns the shortcuts' steps. The trail only ever gets shorter.
pub fn take_shortcuts(grid: &Grid, tree: &Tree, graph: &Graph, twice: &mut [bool]) -> Vec<[u32; 2]> {
    let neighbours = grid.neighbours();
    let strays = new_strays(grid, tree, graph);
    let price = |voxel: usize| match strays[voxel] {
        NOWHERE => f32::INFINITY,
        views => 1.0 + STRAY_PRICE * f32::from(views),
    };
    let prices = [1.0, 1.0 + STRAY_PRICE * tree.planes.len() as f32];
    let across = grid.plane_size.iter().map(|size| size[1]).max().unwrap_or(64);
    let reach = REACH * across as f32;
    let voxel_per_world = 1.0 / grid.spacing_world;
    let lengths: Vec<f32> = (0..twice.len() as u32).map(|e| (graph.length(e) * voxel_per_world) as f32).collect();
    let mut shortest = Shortest::new(grid.voxels());
    let mut steps = Vec::new();
    // For each vertex what changing sides on the tree's path to it saves, and its edge on that path.
    let mut saved = vec![0.0f32; graph.voxels.len()];
    let mut back = vec![u32::MAX; graph.voxels.len()];
    for _ in 0..ROUNDS {
        let before = steps.len();
        for source in 0..graph.voxels.len() as u32 {
            if graph.incident[source as usize].len().is_multiple_of(2) {
                continue;
            }
            let mut stack = vec![(source, u32::MAX)];
            saved[source as usize] = 0.0;
            let mut most = 0.0f32;
            while let Some((vertex, edge)) = stack.pop() {
                back[vertex as usize] = edge;
                most = most.max(saved[vertex as usize]);
                for &next in graph.incident[vertex as usize].iter().filter(|&&next| next != edge) {
                    let e = next as usize;
                    let to = graph.across(next, vertex);
                    saved[to as usize] = saved[vertex as usize] + if twice[e] { lengths[e] } else { -lengths[e] };
                    stack.push((to, next));
                }
            }
            let limit = reach.min(most - LEAST_SAVING);
            if limit <= 0.0 {
                continue;
            }
            shortest.search(&neighbours, price, prices, &[graph.voxels[source as usize]], limit);
            let best = (0..graph.voxels.len())
                .map(|v| (saved[v] - shortest.distance(graph.voxels[v]), v))
                .filter(|found| found.0 > LEAST_SAVING)
                .max_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            let Some((_, end)) = best else { continue };
            let path: Vec<u32> = shortest.path_back(graph.voxels[end]).collect();
            steps.extend(path.windows(2).map(|step| [step[0], step[1]]));
            let mut at = end as u32;
            while back[at as usize] != NO_PARENT {
                let edge = back[at as usize];
                twice[edge as usize] = !twice[edge as usize];
                at = graph.across(edge, at);
            }
        }
        if steps.len() == before {
            break;
        }
    }
    steps
}

/// In how many views a voxel shows blank paper that the tree does not show already, or [`NOWHERE`].
fn new_strays(grid: &Grid, tree: &Tree, graph: &Graph) -> Vec<u8> {
    let mut all: Vec<u8> = (0..grid.voxels()).map(|voxel| if grid.is_spare(voxel) { NOWHERE } else { 0 }).collect();
    for (plane, pixel) in tree.planes.iter().zip(&grid.pixel) {
        let mut shown = plane.inked.clone();
        for &voxel in &graph.voxels {
            shown[pixel[voxel as usize] as usize] = true;
        }
        for (count, &p) in all.iter_mut().zip(pixel) {
            if p == OFF_PICTURE {
                *count = NOWHERE;
            } else if *count != NOWHERE && !shown[p as usize] {
                *count += 1;
            }
        }
    }
    all
}
