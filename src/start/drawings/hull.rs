//! The visual hull of the drawings: what any object could show, and a simple start through it.

use super::grid::{Grid, OFF_PICTURE};
use super::plane::Plane;
use super::shared::{MOST_ACROSS, are_canonical, shown_together};
use crate::error::{Error, Result};
use crate::picture::Mask;
use crate::start::Path;
use crate::start::tour::short_tour;
use crate::view::{Image, Target};

/// How much of one view's ink any object could show.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverable {
    /// Share of the view's ink, 0 to 1.
    pub share: f32,
    /// The ink that no object shows without stray lines in other views, at the target's size.
    pub missing: Image,
}

/// Mean over the views of the share of ink that any object could show, 0 to 1.
pub fn mean_share(views: &[Coverable]) -> f64 {
    views.iter().map(|view| f64::from(view.share)).sum::<f64>() / views.len().max(1) as f64
}

/// Voxels across a picture for the report: one voxel is 2.7 px of 256.
pub const REPORT_ACROSS: usize = 96;

/// For each view the share of ink over which some voxel lies on ink in all views; a pixel counts if such a voxel is
/// seen within one voxel of it.
///
/// # Errors
/// As [`Grid::new`].
pub fn coverable(targets: &[Target], half_extents_world: [f64; 3], across: usize) -> Result<Vec<Coverable>> {
    let size = Grid::size(targets, half_extents_world, across)?;
    let shown = if are_canonical(targets) && across.is_multiple_of(2) && across <= MOST_ACROSS {
        let inked: Vec<Mask> = targets.iter().map(|target| Plane::ink_mask(&target.ink, across, across)).collect();
        shown_together(&inked, size.map(|cells| cells - 2))
    } else {
        shown_on_grid(targets, &Grid::new(targets, half_extents_world, across)?)
    };
    Ok(targets.iter().zip(&shown).map(|(target, shown)| compare(&target.ink, shown)).collect())
}

/// For each view the pixels of its plane on which some voxel lies that is on ink in every view.
fn shown_on_grid(targets: &[Target], grid: &Grid) -> Vec<Mask> {
    let inked: Vec<Mask> = targets
        .iter()
        .zip(&grid.plane_size)
        .map(|(target, &[width, height])| Plane::ink_mask(&target.ink, width, height))
        .collect();
    let mut shown: Vec<Mask> = inked.iter().map(|mask| Mask::new(mask.width, mask.height)).collect();
    for_each_hull_voxel(grid, &inked, |voxel| {
        for (mask, pixel) in shown.iter_mut().zip(&grid.pixel) {
            mask.data[pixel[voxel] as usize] = true;
        }
    });
    shown
}

fn compare(ink: &Image, shown: &Mask) -> Coverable {
    let near: Vec<bool> = shown.distance_px().data.iter().map(|&distance| distance < 1.5).collect();
    let mut missing = Image::new(ink.width, ink.height);
    let (mut lost, mut all) = (0.0, 0.0);
    for (i, &value) in ink.data.iter().enumerate() {
        let x = (i % ink.width) * shown.width / ink.width;
        let y = (i / ink.width) * shown.height / ink.height;
        all += value;
        if !near[y * shown.width + x] {
            missing.data[i] = value;
            lost += value;
        }
    }
    Coverable { share: if all > 0.0 { 1.0 - lost / all } else { 0.0 }, missing }
}

/// Calls `visit` for each voxel that lies on ink in every view.
fn for_each_hull_voxel(grid: &Grid, inked: &[Mask], mut visit: impl FnMut(usize)) {
    for voxel in 0..grid.voxels() {
        let on_ink = |(mask, pixel): (&Mask, &Vec<u32>)| {
            let p = pixel[voxel];
            p != OFF_PICTURE && mask.data[p as usize]
        };
        if inked.iter().zip(&grid.pixel).all(on_ink) && !grid.is_spare(voxel) {
            visit(voxel);
        }
    }
}

/// How the hull start is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HullOptions {
    /// Voxels along a picture's height; even.
    pub across: usize,
    /// A point covers strokes within this distance, px of a 128 px picture.
    pub reach_px_at_128: f32,
    /// Width of the path, px of a 128 px picture.
    pub width_px_at_128: f64,
}

impl Default for HullOptions {
    fn default() -> Self {
        // Finer grids and smaller cells give longer tours, no better matches.
        HullOptions { across: 80, reach_px_at_128: 2.5, width_px_at_128: 2.0 }
    }
}

/// The simpler start: hull voxels that together cover the strokes' middle lines, joined by a short tour. Ink that the
/// hull does not reach stays empty, and the tour's hops show.
///
/// # Errors
/// If a view is blank or the hull is empty.
pub fn hull_path(targets: &[Target], half_extents_world: [f64; 3], options: &HullOptions) -> Result<Path> {
    let grid = Grid::new(targets, half_extents_world, options.across)?;
    let planes: Vec<Plane> = targets
        .iter()
        .zip(&grid.plane_size)
        .map(|(target, &[width, height])| {
            Plane::new(&target.ink, width, height, options.reach_px_at_128 * options.across as f32 / 128.0)
        })
        .collect();
    let inked: Vec<Mask> = planes.iter().map(Plane::inked_mask).collect();
    let mut hull = Vec::new();
    for_each_hull_voxel(&grid, &inked, |voxel| hull.push(voxel as u32));
    if hull.is_empty() {
        return Err(nothing_shared());
    }
    let points: Vec<[f64; 3]> = cover(&grid, &planes, &hull, options.reach_px_at_128 * options.across as f32 / 128.0)
        .into_iter()
        .map(|voxel| grid.position(voxel as usize))
        .collect();
    let width = options.width_px_at_128 * grid.spacing_world * options.across as f64 / 128.0;
    let order = short_tour(&points, false);
    let points = order.into_iter().map(|i| points[i as usize]).map(|[x, y, z]| [x, y, z, width]).collect();
    Ok(Path { points, closed: false })
}

/// The drawings leave no voxel that all views see as ink.
pub(super) fn nothing_shared() -> Error {
    Error::Pictures {
        problem: "the drawings have no ink at a common height or width, so no object can show them together".into(),
        remedy: "let the drawings be arranged, or use ones that fill the same part of the picture".into(),
    }
}

/// Hull voxels that cover the planes' lines: those that newly cover most views first.
fn cover(grid: &Grid, planes: &[Plane], hull: &[u32], reach: f32) -> Vec<u32> {
    let mut covered: Vec<Vec<bool>> =
        planes.iter().map(|plane| plane.lines.iter().map(|line| !line).collect()).collect();
    let mut chosen = Vec::new();
    for wanted in (1..=planes.len()).rev() {
        for &voxel in hull {
            let news = planes
                .iter()
                .enumerate()
                .filter(|&(v, plane)| {
                    let p = grid.pixel[v][voxel as usize] as usize;
                    plane.lines[p] && !covered[v][p]
                })
                .count();
            if news < wanted {
                continue;
            }
            chosen.push(voxel);
            for (v, plane) in planes.iter().enumerate() {
                let p = grid.pixel[v][voxel as usize] as usize;
                let (x, y) = (p % plane.width, p / plane.width);
                let r = reach as usize;
                for row in y.saturating_sub(r)..(y + r + 1).min(plane.height) {
                    for column in x.saturating_sub(r)..(x + r + 1).min(plane.width) {
                        let (dx, dy) = (column.abs_diff(x) as f32, row.abs_diff(y) as f32);
                        covered[v][row * plane.width + column] |= dx * dx + dy * dy <= reach * reach;
                    }
                }
            }
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Ink;
    use crate::start::testing::{HEIGHT_WORLD, letters, picture, targets};

    #[test]
    fn shares_equal_brute_force() {
        // Pictures as large as the planes, so that a pixel is a voxel: compare with a loop over all cells.
        let targets = letters();
        let across = 128;
        let found = coverable(&targets, [0.6; 3], across).unwrap();
        let ink = |v: usize, x: usize, y: usize| targets[v].ink.at(x, y) > 0.4;
        let mut shown = vec![vec![false; across * across]; 3];
        // The box of half side .6 is smaller than the picture of height 1.375.
        let rim = (across as f64 * (0.5 - 0.6 / HEIGHT_WORLD)) as usize;
        for i in rim..across - rim {
            for j in rim..across - rim {
                for k in rim..across - rim {
                    // x = i, y = -j, z = k: side shows -z.
                    if ink(0, i, j) && ink(1, across - 1 - k, j) && ink(2, i, k) {
                        shown[0][j * across + i] = true;
                        shown[1][j * across + across - 1 - k] = true;
                        shown[2][k * across + i] = true;
                    }
                }
            }
        }
        for (v, found) in found.iter().enumerate() {
            let all = targets[v].ink.data.iter().filter(|&&value| value > 0.5).count();
            let covered = (0..across * across)
                .filter(|&p| targets[v].ink.data[p] > 0.5)
                .filter(|&p| {
                    let (x, y) = (p % across, p / across);
                    (y - 1..y + 2).any(|y| (x - 1..x + 2).any(|x| shown[v][y * across + x]))
                })
                .count();
            assert!((found.share - covered as f32 / all as f32).abs() < 1e-3, "view {v}: {}", found.share);
            let missing: f32 = found.missing.data.iter().sum();
            assert!((missing - (all - covered) as f32).abs() < 1.0);
        }
        assert!(found.iter().any(|found| found.share < 0.95), "a set without a flaw would prove nothing");
    }

    #[test]
    fn rows_of_cells_show_what_the_voxels_show() {
        let mut all = letters();
        for (count, half, across) in [(3, [0.6, 0.5, 0.4], 96), (3, [0.55, 0.9, 0.6], 64), (2, [0.6; 3], 128)] {
            all.truncate(count);
            let grid = Grid::new(&all, half, across).unwrap();
            let slow = shown_on_grid(&all, &grid);
            let inked: Vec<Mask> = all.iter().map(|target| Plane::ink_mask(&target.ink, across, across)).collect();
            assert!(are_canonical(&all));
            assert!(shown_together(&inked, grid.size.map(|cells| cells - 2)) == slow);
            assert!(shown_together(&inked, [4; 3]) != slow, "the box counts");
        }
    }

    #[test]
    fn path_stays_on_ink_and_disjoint_drawings_are_refused() {
        let targets_ = letters();
        let path = hull_path(&targets_, [0.6; 3], &HullOptions::default()).unwrap();
        assert!(path.points.len() > 20);
        for target in &targets_ {
            let camera = target.view.camera::<f64>();
            for point in &path.points {
                let [x, y, _] = camera.project(point);
                let near = target.ink.threshold(0.3).distance_px();
                assert!(near.at(x as usize, y as usize) <= 2.0);
            }
        }
        let upper = picture(|_, y| (0.2..0.3).contains(&y));
        let lower = picture(|_, y| (0.7..0.8).contains(&y));
        let error = hull_path(&targets(vec![upper.clone(), lower.clone()]), [0.6; 3], &HullOptions::default());
        assert!(matches!(error, Err(Error::Pictures { .. })));
        let shares = coverable(&targets(vec![upper, lower]), [0.6; 3], 64).unwrap();
        assert!(shares.iter().all(|c| c.share == 0.0));
    }
}
