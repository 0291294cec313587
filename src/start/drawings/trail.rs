//! From the tree to one trail: every branch is walked there and back (which costs no visible ink and fills strokes with
//! two strands), except one path from end to end; at forks the trail goes on as straight as it can. A shorter trail
//! takes shortcuts instead of walking back.

use super::grid::{Grid, OFF_PICTURE};
use super::pairing::{Graph, Pairing};
use super::shortcuts::take_shortcuts;
use super::tree::Tree;
use crate::start::Path;
use std::collections::HashSet;

/// How the tree becomes a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrailOptions {
    /// Standard deviation of the smoothing along the path, steps of the reference grid of 64 voxels. Enough for the
    /// grid's stairs; more (such as 1.5) pulls small curls flat and costs .01 soft IoU after the fit.
    pub smoothing_steps: f64,
    /// Width where the path shows ink only, px of a 128 px picture.
    pub width_px_at_128: f64,
    /// Width where some view shows blank paper, px of a 128 px picture.
    pub stray_width_px_at_128: f64,
    /// Whether to take shortcuts through ink instead of walking branches there and back: the wire gets shorter, but
    /// fewer strokes have two strands to fill them.
    pub shorter: bool,
}

impl Default for TrailOptions {
    fn default() -> Self {
        TrailOptions { smoothing_steps: 0.6, width_px_at_128: 2.0, stray_width_px_at_128: 0.6, shorter: false }
    }
}

/// The smoothed path along the tree's trail.
pub fn path_along(grid: &Grid, tree: &Tree, options: &TrailOptions) -> Path {
    let voxels = voxel_trail(grid, tree, options.shorter);
    let across = grid.plane_size.iter().map(|size| size[1]).max().unwrap_or(64) as f64;
    // World units a pixel of a 128 px picture.
    let pixel_world = grid.spacing_world * across / 128.0;
    let on_ink = |voxel: u32| {
        tree.planes.iter().zip(&grid.pixel).all(|(plane, pixel)| {
            let p = pixel[voxel as usize];
            p == OFF_PICTURE || plane.stray_px[p as usize] <= 0.9 * across as f32 / 64.0
        })
    };
    let mut points: Vec<[f64; 4]> = voxels
        .iter()
        .map(|&voxel| {
            let [x, y, z] = grid.position(voxel as usize);
            let width_px = if on_ink(voxel) { options.width_px_at_128 } else { options.stray_width_px_at_128 };
            [x, y, z, width_px * pixel_world]
        })
        .collect();
    smooth(&mut points, options.smoothing_steps * across / 64.0);
    Path { points, closed: false }
}

/// Gaussian smoothing of position and width along the index; the window shrinks towards both ends, which stay.
pub fn smooth(points: &mut [[f64; 4]], sigma: f64) {
    if sigma <= 0.0 {
        return;
    }
    let source = points.to_vec();
    let weights = gaussian(sigma);
    for i in 0..points.len() {
        let window = (weights.len() - 1).min(i).min(points.len() - 1 - i);
        let mut sum = [0.0; 4];
        let mut total = 0.0;
        for j in i - window..=i + window {
            let weight = weights[i.abs_diff(j)];
            total += weight;
            for c in 0..4 {
                sum[c] += weight * source[j][c];
            }
        }
        points[i] = sum.map(|s| s / total);
    }
}

/// [`smooth`] round a closed path, whose last point comes before its first.
pub fn smooth_ring(points: &mut [[f64; 4]], sigma: f64) {
    if sigma <= 0.0 {
        return;
    }
    let source = points.to_vec();
    let weights = gaussian(sigma);
    let total = 2.0 * weights.iter().sum::<f64>() - weights[0];
    let n = source.len();
    for (i, point) in points.iter_mut().enumerate() {
        *point = source[i].map(|x| weights[0] * x);
        for (k, weight) in weights.iter().enumerate().skip(1) {
            let (before, after) = (source[(i + n - k % n) % n], source[(i + k) % n]);
            for c in 0..4 {
                point[c] += weight * (before[c] + after[c]);
            }
        }
        *point = point.map(|x| x / total);
    }
}

/// Weights of the points 0, 1, 2… away.
fn gaussian(sigma: f64) -> Vec<f64> {
    let reach = (3.0 * sigma).ceil() as usize;
    (0..=reach).map(|k| (-0.5 * (k as f64 / sigma).powi(2)).exp()).collect()
}

/// The voxels in the order of the trail, with shortcuts if it should be `shorter`.
pub fn voxel_trail(grid: &Grid, tree: &Tree, shorter: bool) -> Vec<u32> {
    if tree.edges.is_empty() {
        return vec![tree.root; 2];
    }
    let graph = Graph::new(grid, &tree.edges);
    let mut twice: Vec<bool> = graph.longest_path().into_iter().map(|once| !once).collect();
    let shortcuts = if shorter { take_shortcuts(grid, tree, &graph, &mut twice) } else { Vec::new() };
    // Every step of the trail: the tree's, those walked twice, the shortcuts'.
    let again = tree.edges.iter().zip(&twice).filter(|(_, twice)| **twice).map(|(edge, _)| *edge);
    let steps: Vec<[u32; 2]> = tree.edges.iter().copied().chain(again).chain(shortcuts).collect();
    let mut known = HashSet::with_capacity(steps.len());
    let distinct: Vec<[u32; 2]> = steps.iter().copied().filter(|&[a, b]| known.insert([a.min(b), a.max(b)])).collect();
    let graph = Graph::new(grid, &distinct);
    let mut pairing = Pairing::new(&graph, &steps, 0.0);
    pairing.join_trails(&graph);
    pairing.walk().into_iter().map(|vertex| graph.voxels[vertex as usize]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::testing::letters;
    use crate::start::{TreeOptions, grow_tree};
    use std::collections::HashMap;

    fn walks_all(grid: &Grid, tree: &Tree, trail: &[u32]) -> Result<(), String> {
        let mut times: HashMap<[u32; 2], usize> = tree.edges.iter().map(|&[a, b]| ([a.min(b), a.max(b)], 0)).collect();
        let neighbours = grid.neighbours();
        for step in trail.windows(2) {
            let apart = step[1] as isize - step[0] as isize;
            if !neighbours.iter().any(|n| n.0 == apart) {
                return Err(format!("a jump from {} to {}", step[0], step[1]));
            }
            *times.get_mut(&[step[0].min(step[1]), step[0].max(step[1])]).ok_or("a step off the tree")? += 1;
        }
        match times.values().find(|&&count| !(1..=2).contains(&count)) {
            Some(count) => Err(format!("an edge walked {count} times")),
            None => Ok(()),
        }
    }

    #[test]
    fn trail_walks_every_edge_once_or_twice() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| true).unwrap();
        let trail = voxel_trail(&grid, &tree, false);
        walks_all(&grid, &tree, &trail).unwrap();
        assert!(trail.len() < 2 * tree.edges.len(), "one path is walked only once");
        let mut jumps = trail.clone();
        jumps.swap(3, trail.len() / 2);
        assert!(walks_all(&grid, &tree, &jumps).is_err() && walks_all(&grid, &tree, &trail[..9]).is_err());
        let path = path_along(&grid, &tree, &TrailOptions::default());
        assert_eq!(path.points.len(), trail.len());
        assert!(path.points.iter().flatten().all(|x| x.is_finite()));
    }

    #[test]
    fn shorter_trail_still_walks_every_edge() {
        let targets = letters();
        let grid = Grid::new(&targets, [0.55; 3], 64).unwrap();
        let tree = grow_tree(&grid, &targets, &TreeOptions::default(), &mut |_| true).unwrap();
        let neighbours = grid.neighbours();
        let steps = |trail: &[u32]| -> Result<(f32, HashSet<[u32; 2]>), String> {
            let mut length = 0.0;
            for step in trail.windows(2) {
                let apart = step[1] as isize - step[0] as isize;
                length += neighbours.iter().find(|n| n.0 == apart).ok_or("a jump")?.1;
            }
            Ok((length, trail.windows(2).map(|step| [step[0].min(step[1]), step[0].max(step[1])]).collect()))
        };
        let all = |steps: &HashSet<[u32; 2]>| tree.edges.iter().all(|&[a, b]| steps.contains(&[a.min(b), a.max(b)]));
        let (doubled, short) = (voxel_trail(&grid, &tree, false), voxel_trail(&grid, &tree, true));
        let ((long_length, _), (short_length, walked)) = (steps(&doubled).unwrap(), steps(&short).unwrap());
        assert!(short_length < long_length, "{short_length} against {long_length}");
        assert!(all(&walked), "an edge of the tree is left out");
        // The checks can fail.
        assert!(!all(&steps(&short[..short.len() / 2]).unwrap().1));
        assert!(steps(&[short[0], short[short.len() / 2]]).is_err());
    }

    #[test]
    fn smoothing_keeps_ends_and_straight_lines() {
        let line: Vec<[f64; 4]> = (0..30).map(|i| [f64::from(i), 2.0 * f64::from(i), -f64::from(i), 0.1]).collect();
        let mut smoothed = line.clone();
        smooth(&mut smoothed, 2.5);
        for (a, b) in line.iter().zip(&smoothed) {
            assert!((0..4).all(|c| (a[c] - b[c]).abs() < 1e-12));
        }
        let mut zigzag = line.clone();
        zigzag.iter_mut().enumerate().for_each(|(i, p)| p[0] += if i % 2 == 0 { 1.0 } else { -1.0 });
        let rough = zigzag[15][0] - line[15][0];
        smooth(&mut zigzag, 2.5);
        assert!((zigzag[15][0] - line[15][0]).abs() < 0.01 * rough.abs());
    }
}
