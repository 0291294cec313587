//! Makes a closed walk shorter that shows some lines more than once: a stretch that shows nothing alone gives way to the
//! shortest hidden way between its ends.

use super::super::grid::Grid;
use super::super::shortest::Shortest;
use super::joins::Prices;
use super::prune::Cover;

/// What a way must save at least, voxels.
const LEAST_SAVING: f32 = 0.5;
/// After a stretch without a shorter way the next one tried ends at least so many voxels later.
const STRIDE: usize = 3;
/// Rounds over the whole walk; later ones find next to nothing.
const ROUNDS: usize = 4;

/// Shortens `walk`, a ring of neighbouring voxels, and keeps every line met that it meets now, as `cover` counts it.
pub fn shortened(grid: &Grid, mut walk: Vec<u32>, mut cover: Cover, prices: &Prices) -> Vec<u32> {
    let neighbours = grid.neighbours();
    let mut shortest = Shortest::new(grid.voxels());
    walk.iter().for_each(|&voxel| cover.add(voxel));
    for _ in 0..ROUNDS {
        let before = walk.len();
        // Every stretch begins at the ring's first place, which moves on.
        let mut steps = walk.len();
        // Places 1..last are taken out.
        let mut last = 1;
        let mut tried = 0;
        while steps > 0 && walk.len() > 8 {
            while last + 2 < walk.len() && cover.is_spare(walk[last]) {
                cover.remove(walk[last]);
                last += 1;
            }
            let stretch = &walk[..=last];
            let apart = distance(grid, walk[0], walk[last]);
            let mut turned = 1;
            if last >= tried + STRIDE && length(grid, stretch) - apart > LEAST_SAVING {
                let now = prices.along(stretch, |a, b| distance(grid, a, b));
                let mut found = false;
                prices.search(&mut shortest, &neighbours, walk[0], now - LEAST_SAVING, |voxel| {
                    found = voxel == walk[last];
                    found
                });
                if found {
                    let mut way: Vec<u32> = shortest.path_back(walk[last]).collect();
                    way.reverse();
                    way[1..way.len() - 1].iter().for_each(|&voxel| cover.add(voxel));
                    turned = way.len() - 1;
                    steps = steps.saturating_sub(last - 1);
                    walk.splice(..=last, way);
                    last = turned;
                } else {
                    tried = last;
                }
            }
            let taken = turned.min(walk.len());
            if turned == 1 && last > 1 {
                cover.add(walk[1]);
            }
            walk.rotate_left(taken);
            last = last.saturating_sub(taken).max(1);
            tried = tried.saturating_sub(taken);
            steps = steps.saturating_sub(taken);
        }
        (1..last).for_each(|i| cover.add(walk[i]));
        if walk.len() == before {
            break;
        }
    }
    walk
}

fn distance(grid: &Grid, a: u32, b: u32) -> f32 {
    let (a, b) = (grid.position(a as usize), grid.position(b as usize));
    let squared: f64 = (0..3).map(|c| (a[c] - b[c]).powi(2)).sum();
    (squared.sqrt() / grid.spacing_world) as f32
}

fn length(grid: &Grid, walk: &[u32]) -> f32 {
    walk.windows(2).map(|step| distance(grid, step[0], step[1])).sum()
}
