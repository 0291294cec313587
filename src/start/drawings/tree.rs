//! A tree grown through the voxels until every stroke of every drawing is met: branch by branch the cheapest path that
//! pays for stray ink and earns newly met ink.

use super::grid::{Grid, OFF_PICTURE};
use super::hull::nothing_shared;
use super::plane::Plane;
use super::shortest::{NO_PARENT, Shortest};
use crate::error::{Error, Result};
use crate::sorting::sort_by;
use crate::view::Target;

/// Prices of the tree, per voxel step on a grid of [`TreeOptions::REFERENCE_ACROSS`] (finer grids scale themselves).
/// The prices were found by sweeps over letters, animals and vehicles; the grid from our own on six sets of drawings: 64, 96 and
/// 128 voxels gave soft IoU .765, .779, .793 after the same short fit, and one of 128 takes about a second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TreeOptions {
    /// Voxels along a picture's height; even.
    pub across: usize,
    /// Any step, so that paths are short.
    pub step_price: f32,
    /// A step on ink but 2 px or more off the stroke's middle line, per view.
    pub ink_price: f32,
    /// A step on ink that is met already, per view.
    pub met_price: f32,
    /// A step on blank paper, per view: stray ink that everybody sees.
    pub stray_price: f32,
    /// Added to a stray step for each px between it and the nearest ink, up to 8 px: far strays hurt more.
    pub far_price: f32,
    /// Earned for each newly met pixel of a stroke's middle line.
    pub gain: f32,
    /// How many stray steps a pixel of missing stroke is worth in the end: 0 leaves out what does not pay for itself,
    /// large values reach every stroke of every drawing.
    pub missing_weight: f32,
    /// How far each search goes at first, in stray steps; farther only when nothing nearby pays.
    pub nearby: f32,
    /// Middle lines within this distance count as met, reference px; more under fat strokes.
    pub meet_px: f32,
    /// Half width of the widest strand, px of a 128 px picture: fatter areas are filled with several strands.
    pub strand_px_at_128: f32,
}

impl TreeOptions {
    /// The grid for which the prices are given.
    pub const REFERENCE_ACROSS: f32 = 64.0;

    /// Prices of a tree for [`circuit_path`](super::circuit_path): length is dear, and paths that draw in several views at
    /// once are cheap.
    pub fn for_circuit() -> TreeOptions {
        TreeOptions { step_price: 0.5, met_price: 0.4, stray_price: 10.0, ..TreeOptions::default() }
    }
}

impl Default for TreeOptions {
    fn default() -> Self {
        TreeOptions {
            across: 128,
            step_price: 0.03,
            ink_price: 0.15,
            met_price: 0.05,
            stray_price: 4.0,
            far_price: 0.0,
            gain: 2.0,
            missing_weight: 8.0,
            nearby: 3.0,
            meet_px: 0.75,
            strand_px_at_128: 5.0,
        }
    }
}

/// A tree of voxels with what it shows.
#[derive(Debug, Clone)]
pub struct Tree {
    /// Voxel pairs (parent, child), each one step of the 26-neighbourhood; they form one tree.
    pub edges: Vec<[u32; 2]>,
    /// The voxel growth began with.
    pub root: u32,
    /// Each view's plane.
    pub planes: Vec<Plane>,
    /// Each view's share of stroke pixels that the tree meets.
    pub met_share: Vec<f32>,
    /// Branches grown.
    pub branches: usize,
    /// How near a voxel comes to the lines it meets and how wide a strand gets, px.
    reach_px: [f32; 2],
}

impl Tree {
    /// How far away a voxel meets lines where ink is `depth_px` deep: in any ink, and all across fat strokes.
    pub(super) fn meets_px(&self, depth_px: f32) -> (f32, f32) {
        let [meets, widest] = self.reach_px;
        (meets, 1.1 * depth_px.min(widest))
    }
}

/// One view while the tree grows.
struct Sheet {
    plane: Plane,
    /// Stroke pixels not met yet.
    missing: Vec<bool>,
    missing_count: usize,
    /// Pixels the tree has drawn on already: drawing there again is no new stray ink.
    drawn: Vec<bool>,
    price: Vec<f32>,
    /// The nearest missing pixel within one px, or [`NONE`].
    near: Vec<u32>,
}

/// How far a search goes before missing ink becomes dearer, in stray steps.
const FARTHEST: f32 = 10.0;
/// Strays farther from ink than this cost no more, reference px.
const FARTHEST_PX: f32 = 8.0;
/// No pixel, no branch.
const NONE: u32 = u32::MAX;

struct Growth<'a> {
    grid: &'a Grid,
    options: TreeOptions,
    /// Grid voxels a reference voxel.
    scale: f32,
    sheets: Vec<Sheet>,
    in_tree: Vec<bool>,
    voxels: Vec<u32>,
    edges: Vec<[u32; 2]>,
    branches: usize,
}

/// Grows the tree. `progress` is told the share of strokes met and stops the growth by returning false.
///
/// # Errors
/// If a view is blank or no point of space lies on ink in all views.
pub fn grow_tree(
    grid: &Grid,
    targets: &[Target],
    options: &TreeOptions,
    progress: &mut dyn FnMut(f32) -> bool,
) -> Result<Tree> {
    let scale = options.across as f32 / TreeOptions::REFERENCE_ACROSS;
    let strand_px = options.strand_px_at_128 * options.across as f32 / 128.0;
    let mut sheets = Vec::with_capacity(targets.len());
    for (target, &[width, height]) in targets.iter().zip(&grid.plane_size) {
        let plane = Plane::new(&target.ink, width, height, strand_px);
        if plane.is_blank() {
            return Err(Error::picture(
                &target.view.name,
                "there is no ink to draw",
                "use a picture with lines, or invert it",
            ));
        }
        sheets.push(Sheet::new(plane));
    }
    let mut growth = Growth {
        grid,
        options: *options,
        scale,
        sheets,
        in_tree: vec![false; grid.voxels()],
        voxels: Vec::new(),
        edges: Vec::new(),
        branches: 0,
    };
    let root = growth.best_root().ok_or_else(nothing_shared)?;
    growth.refresh_all();
    growth.add_voxel(root);
    growth.grow(progress);
    let met_share = growth
        .sheets
        .iter()
        .map(|sheet| {
            let all = sheet.plane.lines.iter().filter(|&&line| line).count();
            1.0 - sheet.missing_count as f32 / all.max(1) as f32
        })
        .collect();
    let planes = growth.sheets.into_iter().map(|sheet| sheet.plane).collect();
    let reach_px = [options.meet_px * scale, strand_px];
    Ok(Tree { edges: growth.edges, root, planes, met_share, branches: growth.branches, reach_px })
}

impl Sheet {
    fn new(plane: Plane) -> Sheet {
        let count = plane.inked.len();
        let missing = plane.lines.clone();
        let missing_count = missing.iter().filter(|&&line| line).count();
        Sheet {
            plane,
            missing,
            missing_count,
            drawn: vec![false; count],
            price: vec![0.0; count],
            near: vec![NONE; count],
        }
    }

    /// Recomputes price and nearest missing pixel of the pixels within `reach` of (x, y).
    fn refresh(&mut self, x: usize, y: usize, reach: usize, options: &TreeOptions, scale: f32) {
        let (width, height) = (self.plane.width, self.plane.height);
        for row in y.saturating_sub(reach)..(y + reach + 1).min(height) {
            for column in x.saturating_sub(reach)..(x + reach + 1).min(width) {
                let i = row * width + column;
                self.near[i] = self.nearest_missing(column, row);
                self.price[i] = self.price_of(i, options, scale);
            }
        }
    }

    fn nearest_missing(&self, x: usize, y: usize) -> u32 {
        let (width, height) = (self.plane.width, self.plane.height);
        let mut best = (usize::MAX, NONE);
        for row in y.saturating_sub(1)..(y + 2).min(height) {
            for column in x.saturating_sub(1)..(x + 2).min(width) {
                let i = row * width + column;
                let apart = row.abs_diff(y) + column.abs_diff(x);
                if self.missing[i] && apart < best.0 {
                    best = (apart, i as u32);
                }
            }
        }
        best.1
    }

    fn price_of(&self, i: usize, options: &TreeOptions, scale: f32) -> f32 {
        if self.plane.inked[i] {
            let off_line = (self.plane.to_line_px[i] / scale).min(2.0) / 2.0;
            options.ink_price * off_line + if self.near[i] == NONE { options.met_price } else { 0.0 }
        } else if self.drawn[i] {
            options.ink_price
        } else {
            let away = self.plane.stray_px[i] / scale;
            options.ink_price
                + options.stray_price * away.min(1.0)
                + options.far_price * (away - 1.0).clamp(0.0, FARTHEST_PX)
        }
    }
}

impl Growth<'_> {
    /// The voxel that lies on ink in every view and on the middle line in most of them, nearest the object's middle.
    fn best_root(&self) -> Option<u32> {
        let mut best: Option<(usize, f64, u32)> = None;
        for voxel in 0..self.grid.voxels() {
            if self.grid.is_spare(voxel) {
                continue;
            }
            let mut on_lines = 0;
            let inked = self.sheets.iter().zip(&self.grid.pixel).all(|(sheet, pixel)| {
                let p = pixel[voxel];
                let inked = p != OFF_PICTURE && sheet.plane.inked[p as usize];
                on_lines += usize::from(inked && sheet.plane.lines[p as usize]);
                inked
            });
            if inked {
                let [x, y, z] = self.grid.position(voxel);
                let from_middle = x * x + y * y + z * z;
                if best.is_none_or(|b| (on_lines, -from_middle) > (b.0, -b.1)) {
                    best = Some((on_lines, from_middle, voxel as u32));
                }
            }
        }
        best.map(|b| b.2)
    }

    fn refresh_all(&mut self) {
        for sheet in &mut self.sheets {
            let (width, height) = (sheet.plane.width, sheet.plane.height);
            sheet.refresh(0, 0, width.max(height), &self.options, self.scale);
        }
    }

    /// Adds a voxel: the strokes under it are met, the pixels round it drawn.
    fn add_voxel(&mut self, voxel: u32) {
        let v = voxel as usize;
        if self.in_tree[v] {
            return;
        }
        self.in_tree[v] = true;
        self.voxels.push(voxel);
        let widest = self.options.strand_px_at_128 * self.options.across as f32 / 128.0;
        for (sheet, pixel) in self.sheets.iter_mut().zip(&self.grid.pixel) {
            let p = pixel[v] as usize;
            let (width, height) = (sheet.plane.width, sheet.plane.height);
            let (x, y) = (p % width, p / width);
            let meets = (self.options.meet_px * self.scale).max(1.1 * sheet.plane.depth_px[p].min(widest));
            let reach = meets as usize + 1;
            for row in y.saturating_sub(reach)..(y + reach + 1).min(height) {
                for column in x.saturating_sub(reach)..(x + reach + 1).min(width) {
                    let (dx, dy) = (column.abs_diff(x), row.abs_diff(y));
                    let i = row * width + column;
                    if ((dx * dx + dy * dy) as f32) <= meets * meets && sheet.missing[i] {
                        sheet.missing[i] = false;
                        sheet.missing_count -= 1;
                    }
                    sheet.drawn[i] |= dx <= 1 && dy <= 1;
                }
            }
            sheet.refresh(x, y, reach + 1, &self.options, self.scale);
        }
    }

    /// Branch after branch; when nothing pays any more, missing ink becomes dearer, up to what it is said to be worth.
    fn grow(&mut self, progress: &mut dyn FnMut(f32) -> bool) {
        let neighbours = self.grid.neighbours();
        let all: usize = self.sheets.iter().map(|sheet| sheet.missing_count).sum();
        let mut shortest = Shortest::new(self.grid.voxels());
        let mut gains = vec![0.0f32; self.grid.voxels()];
        let mut branch_of = vec![NONE; self.grid.voxels()];
        let dearest = self.options.missing_weight * self.options.stray_price;
        let mut gain = self.options.gain;
        // Most branches are short: search near the tree first, and far only when nothing near pays.
        let mut farthest = FARTHEST * self.options.stray_price * self.scale;
        let nearby = self.options.nearby * self.options.stray_price * self.scale;
        let mut limit = nearby;
        let mut missing = all;
        // How far the search has gone since the tree last grew.
        let mut searched = None;
        loop {
            // No path is worth more than all that is missing.
            let worth = gain * missing as f32;
            let within = limit.min(worth);
            if searched.is_none() {
                shortest.begin(&neighbours, |voxel| self.price(voxel), self.prices(), &self.voxels);
            }
            if searched.is_none_or(|searched| searched < within) {
                shortest.extend(&neighbours, |voxel| self.price(voxel), within);
                searched = Some(within);
            }
            let added = self.add_best_branches(&shortest, within, gain, &mut gains, &mut branch_of);
            missing = self.sheets.iter().map(|sheet| sheet.missing_count).sum();
            if missing == 0 || !progress(1.0 - missing as f32 / all.max(1) as f32) {
                return;
            }
            if added > 0 {
                (limit, searched) = (nearby, None);
            } else if limit < farthest.min(worth) {
                limit *= 3.0;
            } else if gain < dearest {
                gain = (2.0 * gain).min(dearest);
                farthest *= 2.0;
                limit = nearby;
            } else {
                return;
            }
        }
    }

    /// Price of a step on a voxel; infinite where nothing may go.
    fn price(&self, voxel: usize) -> f32 {
        let mut sum = self.options.step_price;
        for (sheet, pixel) in self.sheets.iter().zip(&self.grid.pixel) {
            let p = pixel[voxel];
            sum += if p == OFF_PICTURE { f32::INFINITY } else { sheet.price[p as usize] };
        }
        sum
    }

    /// The least and the largest finite price.
    fn prices(&self) -> [f32; 2] {
        let TreeOptions { step_price, ink_price, met_price, stray_price, far_price, .. } = self.options;
        let view = ink_price + met_price.max(stray_price + far_price * FARTHEST_PX);
        [step_price, step_price + self.sheets.len() as f32 * view]
    }

    /// How many missing pixels the step from `from` to `to` meets first.
    fn newly_met(&self, from: u32, to: u32) -> u32 {
        let mut count = 0;
        for (sheet, pixel) in self.sheets.iter().zip(&self.grid.pixel) {
            let near = sheet.near[pixel[to as usize] as usize];
            count += u32::from(near != NONE && near != sheet.near[pixel[from as usize] as usize]);
        }
        count
    }

    /// Adds the best branch that is no dearer than `limit`, and every other one that is nearly as good with it as without it.
    /// Returns how many.
    fn add_best_branches(
        &mut self,
        shortest: &Shortest,
        limit: f32,
        gain: f32,
        gains: &mut [f32],
        branch: &mut [u32],
    ) -> usize {
        let least_net = 2.0 * self.scale;
        // The best end of each branch that leaves the tree, by the branch's first voxel.
        let mut ends: Vec<(f32, u32)> = Vec::new();
        for voxel in shortest.within(limit) {
            let v = voxel as usize;
            let parent = shortest.parent[v];
            if parent == NO_PARENT {
                gains[v] = 0.0;
                continue;
            }
            let p = parent as usize;
            gains[v] = gains[p] + gain * self.newly_met(parent, voxel) as f32;
            let net = gains[v] - shortest.distance(voxel);
            branch[v] = if shortest.parent[p] == NO_PARENT {
                ends.push((net, voxel));
                (ends.len() - 1) as u32
            } else {
                branch[p]
            };
            let end = &mut ends[branch[v] as usize];
            if net > end.0 {
                *end = (net, voxel);
            }
        }
        ends.retain(|end| end.0 > least_net);
        sort_by(&mut ends, |a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut added = 0;
        for (promised, end) in ends {
            let path: Vec<u32> = shortest.path_back(end).collect();
            if added > 0 {
                // What it earns now that others have been added.
                let met: u32 = path.windows(2).map(|step| self.newly_met(step[1], step[0])).sum();
                let net = gain * met as f32 - shortest.distance(end);
                if net < 0.9 * promised || net <= least_net {
                    continue;
                }
            }
            self.add_path(&path);
            added += 1;
        }
        self.branches += added;
        added
    }

    /// Adds a path given from its end back to the tree, from where it leaves the tree for the last time.
    fn add_path(&mut self, path: &[u32]) {
        let joint = path.iter().position(|&voxel| self.in_tree[voxel as usize]).unwrap_or(path.len() - 1);
        for step in path[..=joint].windows(2).rev() {
            self.edges.push([step[1], step[0]]);
            self.add_voxel(step[0]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::testing::{letters, picture, targets};
    use crate::view::Image;

    #[test]
    fn grows_one_tree_that_meets_every_stroke() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| true).unwrap();
        assert!(tree.met_share.iter().all(|&share| share > 0.99), "{:?}", tree.met_share);
        // One tree: n - 1 edges, each child new and its parent known.
        let mut known = std::collections::HashSet::from([tree.root]);
        for &[parent, child] in &tree.edges {
            assert!(known.contains(&parent), "a branch hangs in the air");
            assert!(known.insert(child), "a loop");
        }
        // What it meets it also draws: every line pixel has a tree voxel near, which a pruned tree does not achieve.
        let far = |edges: &[[u32; 2]]| {
            let mut far = 0;
            for (plane, pixel) in tree.planes.iter().zip(&grid.pixel) {
                let drawn: Vec<[usize; 2]> = edges
                    .iter()
                    .map(|edge| pixel[edge[1] as usize] as usize)
                    .map(|p| [p % plane.width, p / plane.width])
                    .collect();
                far += (0..plane.lines.len())
                    .filter(|&i| plane.lines[i])
                    .filter(|&i| {
                        drawn.iter().all(|d| {
                            let (dx, dy) = (d[0].abs_diff(i % plane.width), d[1].abs_diff(i / plane.width));
                            dx * dx + dy * dy > 36
                        })
                    })
                    .count();
            }
            far
        };
        assert_eq!(far(&tree.edges), 0);
        assert!(far(&tree.edges[..tree.edges.len() / 2]) > 0, "the check can fail");
    }

    #[test]
    fn same_input_same_tree() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 48).unwrap();
        let options = TreeOptions { across: 48, ..TreeOptions::default() };
        let grow = || grow_tree(&grid, &targets, &options, &mut |_| true).unwrap().edges;
        assert_eq!(grow(), grow());
    }

    #[test]
    fn blank_and_disjoint_drawings_are_refused() {
        let grow = |drawings: [Image; 2]| {
            let targets = targets(drawings.to_vec());
            let grid = Grid::new(&targets, [0.55; 3], 32)?;
            grow_tree(&grid, &targets, &TreeOptions { across: 32, ..TreeOptions::default() }, &mut |_| true)
        };
        let upper = picture(|x, y| (0.3..0.7).contains(&x) && (0.2..0.3).contains(&y));
        let lower = picture(|x, y| (0.3..0.7).contains(&x) && (0.7..0.8).contains(&y));
        assert!(matches!(grow([upper.clone(), Image::new(128, 128)]), Err(Error::Picture { .. })));
        assert!(matches!(grow([upper.clone(), lower]), Err(Error::Pictures { .. })));
        let mut dot = Image::new(128, 128);
        dot.data[128 * 32 + 64] = 1.0;
        assert!(grow([upper.clone(), dot]).is_err(), "one pixel is below what the grid can see");
        assert!(grow([upper.clone(), upper]).is_ok());
    }

    #[test]
    fn stops_when_told() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| false).unwrap();
        assert!(tree.branches > 0 && tree.met_share.iter().any(|&share| share < 0.9));
    }
}
