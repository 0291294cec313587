//! Pulls a closed walk taut: every point goes to the middle of those before and after it as far as no view sees it. Voxel
//! paths go in eight directions a plane and turn where they need not; depth is free, and here it is used.

use super::super::grid::Grid;
use super::super::tree::Tree;
use super::joins::Prices;
use super::prune::Cover;

/// How many points away those lie between which a point is pulled, one after the other: long waves go first.
const SPANS: [usize; 5] = [16, 8, 4, 2, 1];
/// Rounds over all points for each.
const ROUNDS: usize = 24;
/// Farthest that a point moves at once along an axis, voxels: it never jumps over what is forbidden.
const MOST: f64 = 0.5;
/// A point that shows a line in a view stays within so many px there.
const LOOSE_PX: usize = 1;

/// Places of the walk's voxels after the pull, world units. No point costs more than before, and every line keeps the
/// point next to it.
pub fn taut(grid: &Grid, tree: &Tree, walk: &[u32], slack_px: f32, prices: &Prices) -> Vec<[f64; 3]> {
    let n = walk.len();
    let holds = Cover::new(grid, tree, slack_px).nearest(walk);
    let keeps_line = |i: usize, voxel: usize| {
        tree.planes.iter().zip(&grid.pixel).zip(&holds).all(|((plane, pixel), holds)| {
            let (p, q) = (pixel[walk[i] as usize] as usize, pixel[voxel] as usize);
            let [x, y] = [(p % plane.width).abs_diff(q % plane.width), (p / plane.width).abs_diff(q / plane.width)];
            let loose = x.max(y) <= LOOSE_PX && plane.to_line_px[q] <= plane.to_line_px[p].max(1.0);
            loose || !holds[i]
        })
    };
    // What lies between two points must be as cheap as they were.
    let hidden = |i: usize, j: usize, points: &[[f64; 3]]| {
        let middle = std::array::from_fn(|c| 0.5 * (points[i][c] + points[j][c]));
        let most = prices.at(walk[i]).max(prices.at(walk[j]));
        grid.voxel(middle).is_some_and(|voxel| prices.at(voxel as u32) <= most)
    };
    let may_be = |i: usize, points: &[[f64; 3]]| {
        grid.voxel(points[i]).is_some_and(|voxel| prices.at(voxel as u32) <= prices.at(walk[i]) && keeps_line(i, voxel))
            && hidden(i, (i + 1) % n, points)
            && hidden(i, (i + n - 1) % n, points)
    };
    let most = MOST * grid.spacing_world;
    let mut points: Vec<[f64; 3]> = walk.iter().map(|&voxel| grid.position(voxel as usize)).collect();
    for span in SPANS.into_iter().filter(|&span| 4 * span < n) {
        for _ in 0..ROUNDS {
            for i in 0..n {
                let (before, after) = (points[(i + n - span) % n], points[(i + span) % n]);
                for axis in 0..3 {
                    let old = points[i][axis];
                    let to = 0.5 * (before[axis] + after[axis]);
                    points[i][axis] += (to - old).clamp(-most, most);
                    if !may_be(i, &points) {
                        points[i][axis] = old;
                    }
                }
            }
        }
    }
    points
}
