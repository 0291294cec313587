//! Takes off a tree what shows nothing that the rest doesn't show: spurs, ends, whole branches.

use super::super::grid::Grid;
use super::super::pairing::Graph;
#[cfg(test)]
use super::super::plane::Plane;
use super::super::tree::Tree;
use crate::sorting::sort_by_key;

/// No edge.
const NONE: u32 = u32::MAX;

/// How often each pixel of the views' lines is met by the voxels counted so far.
pub(super) struct Cover<'a> {
    grid: &'a Grid,
    tree: &'a Tree,
    slack_px: f32,
    times: Vec<Vec<u16>>,
}

impl<'a> Cover<'a> {
    /// Nothing is met yet. A voxel meets lines `slack_px` farther away than it did while the tree grew, but where strokes
    /// are so fat that it met all their width anyway.
    pub fn new(grid: &'a Grid, tree: &'a Tree, slack_px: f32) -> Cover<'a> {
        let times = tree.planes.iter().map(|plane| vec![0; plane.lines.len()]).collect();
        Cover { grid, tree, slack_px, times }
    }

    /// Counts a voxel once more.
    pub fn add(&mut self, voxel: u32) {
        let mut times = std::mem::take(&mut self.times);
        self.each_line(voxel, |view, i| {
            times[view][i] += 1;
            true
        });
        self.times = times;
    }

    /// Counts a voxel once less.
    pub fn remove(&mut self, voxel: u32) {
        let mut times = std::mem::take(&mut self.times);
        self.each_line(voxel, |view, i| {
            times[view][i] -= 1;
            true
        });
        self.times = times;
    }

    /// How many line pixels nothing meets.
    #[cfg(test)]
    pub fn unmet(&self) -> usize {
        let unmet = |(plane, times): (&Plane, &Vec<u16>)| {
            plane.lines.iter().zip(times).filter(|(line, times)| **line && **times == 0).count()
        };
        self.tree.planes.iter().zip(&self.times).map(unmet).sum()
    }

    /// Whether others meet all lines that a counted voxel meets.
    pub fn is_spare(&self, voxel: u32) -> bool {
        self.each_line(voxel, |view, i| self.times[view][i] > 1)
    }

    /// For each view whether a place of the walk is the nearest to some line pixel that it meets; of equally near ones the
    /// first.
    pub fn nearest(&self, walk: &[u32]) -> Vec<Vec<bool>> {
        let mut best: Vec<Vec<(usize, usize)>> =
            self.times.iter().map(|times| vec![(usize::MAX, usize::MAX); times.len()]).collect();
        for (place, &voxel) in walk.iter().enumerate() {
            self.each_line(voxel, |view, i| {
                let width = self.tree.planes[view].width;
                let p = self.grid.pixel[view][voxel as usize] as usize;
                let apart = (p % width).abs_diff(i % width).pow(2) + (p / width).abs_diff(i / width).pow(2);
                best[view][i] = best[view][i].min((apart, place));
                true
            });
        }
        let holds = |best: &Vec<(usize, usize)>| {
            let mut holds = vec![false; walk.len()];
            best.iter().filter(|best| best.1 != usize::MAX).for_each(|best| holds[best.1] = true);
            holds
        };
        best.iter().map(holds).collect()
    }

    /// Calls `visit` with the view and pixel of every line pixel that a voxel meets, until it says no; whether it never did.
    fn each_line(&self, voxel: u32, mut visit: impl FnMut(usize, usize) -> bool) -> bool {
        for (view, (plane, pixel)) in self.tree.planes.iter().zip(&self.grid.pixel).enumerate() {
            let p = pixel[voxel as usize] as usize;
            let (x, y) = (p % plane.width, p / plane.width);
            let (thin, fat) = self.tree.meets_px(plane.depth_px[p]);
            let meets = (thin + self.slack_px).max(fat);
            let reach = meets as usize;
            for row in y.saturating_sub(reach)..(y + reach + 1).min(plane.height) {
                for column in x.saturating_sub(reach)..(x + reach + 1).min(plane.width) {
                    let (dx, dy) = (column.abs_diff(x), row.abs_diff(y));
                    let i = row * plane.width + column;
                    if plane.lines[i] && ((dx * dx + dy * dy) as f32) <= meets * meets && !visit(view, i) {
                        return false;
                    }
                }
            }
        }
        true
    }
}

/// The tree's edges that are left when redundant ends are taken off, short branches first. Lines count as met up to
/// `slack_px` farther away than while the tree grew.
pub fn pruned(grid: &Grid, tree: &Tree, slack_px: f32) -> Vec<[u32; 2]> {
    let graph = Graph::new(grid, &tree.edges);
    let count = graph.voxels.len();
    let mut cover = Cover::new(grid, tree, slack_px);
    graph.voxels.iter().for_each(|&voxel| cover.add(voxel));
    let mut degree: Vec<usize> = graph.incident.iter().map(Vec::len).collect();
    let mut kept = vec![true; tree.edges.len()];
    loop {
        // Each end's way to the next fork.
        let mut branches: Vec<Vec<u32>> = Vec::new();
        for end in (0..count as u32).filter(|&v| degree[v as usize] == 1) {
            let (mut at, mut from, mut branch) = (end, NONE, Vec::new());
            loop {
                let next = graph.incident[at as usize].iter().find(|&&e| kept[e as usize] && e != from);
                match next {
                    Some(&edge) if at == end || degree[at as usize] == 2 => {
                        branch.push(edge);
                        at = graph.across(edge, at);
                        from = edge;
                    }
                    _ => break,
                }
            }
            branches.push([&[end], &branch[..]].concat());
        }
        sort_by_key(&mut branches, |branch| (branch.len(), branch[0]));
        let before = kept.iter().filter(|kept| **kept).count();
        let mut left = before;
        for branch in branches {
            let mut at = branch[0];
            for &edge in &branch[1..] {
                // One edge stays, for a walk needs one.
                if left == 1 || degree[at as usize] != 1 || !cover.is_spare(graph.voxels[at as usize]) {
                    break;
                }
                cover.remove(graph.voxels[at as usize]);
                kept[edge as usize] = false;
                left -= 1;
                degree[at as usize] = 0;
                at = graph.across(edge, at);
                degree[at as usize] -= 1;
            }
        }
        if left == before {
            break;
        }
    }
    tree.edges.iter().zip(&kept).filter(|(_, kept)| **kept).map(|(edge, _)| *edge).collect()
}
