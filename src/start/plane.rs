//! One view's ink on the grid's own pixels: what is ink, how far it is to ink, to ground, to the strokes' middle lines.

use crate::view::Image;

/// Ink on a coarse grid of pixels, one pixel about one voxel wide, with the distances that growing a wire needs.
#[derive(Debug, Clone)]
pub struct Plane {
    /// Width in plane pixels.
    pub width: usize,
    /// Height in plane pixels.
    pub height: usize,
    /// Whether a pixel is ink.
    pub inked: Vec<bool>,
    /// Distance to the nearest ground pixel, px; 0 on ground.
    pub depth_px: Vec<f32>,
    /// Distance to the nearest ink pixel, px; 0 on ink.
    pub stray_px: Vec<f32>,
    /// The lines a wire should follow: the strokes' middle lines, and an even pattern of lines inside fat areas.
    pub lines: Vec<bool>,
    /// Distance to the nearest of those lines, px.
    pub to_line_px: Vec<f32>,
}

/// Share of a pixel that must be ink for the pixel to count: just under half, so that thin strokes do not break.
const INK_SHARE: f32 = 0.4;

impl Plane {
    /// The plane of `ink` at `width` x `height`; areas fatter than twice `strand_px` (half width of the widest strand,
    /// plane pixels) get inner lines two strands apart.
    pub fn new(ink: &Image, width: usize, height: usize, strand_px: f32) -> Plane {
        let inked: Vec<bool> = ink.resized(width, height).data.iter().map(|&share| share > INK_SHARE).collect();
        let ground: Vec<bool> = inked.iter().map(|&ink| !ink).collect();
        let depth_px = distance(width, height, &ground);
        let stray_px = distance(width, height, &inked);
        let mut lines = thinned(width, height, &inked);
        add_inner_lines(width, height, &depth_px, strand_px, &mut lines);
        let to_line_px = distance(width, height, &lines);
        Plane { width, height, inked, depth_px, stray_px, lines, to_line_px }
    }

    /// Whether there is any ink at all.
    pub fn is_blank(&self) -> bool {
        !self.inked.contains(&true)
    }
}

/// Contours at depths strand, 3 strand, 5 strand… inside areas deeper than twice the strand's half width: with the
/// outline's own middle line they fill the area evenly.
fn add_inner_lines(width: usize, height: usize, depth_px: &[f32], strand_px: f32, lines: &mut [bool]) {
    let fat: Vec<bool> = depth_px.iter().map(|&depth| depth > 2.0 * strand_px).collect();
    if !fat.contains(&true) {
        return;
    }
    let to_fat = distance(width, height, &fat);
    for i in 0..depth_px.len() {
        // Within a strand of the fat part's rim: its first contour lies one strand deep.
        let near_fat = to_fat[i] <= strand_px + 1.5;
        let on_contour = depth_px[i] >= strand_px && (depth_px[i] - strand_px).rem_euclid(2.0 * strand_px) < 1.0;
        if near_fat && on_contour {
            lines[i] = true;
        }
    }
}

/// Exact Euclidean distance (px) from each pixel's centre to that of the nearest pixel in `set`; large where `set` is
/// empty. Columns by two sweeps, rows by direct minimum: plenty at these sizes.
pub fn distance(width: usize, height: usize, set: &[bool]) -> Vec<f32> {
    const FAR: f32 = 1e6;
    let mut column = vec![FAR; width * height];
    for x in 0..width {
        let mut run = FAR;
        for y in 0..height {
            run = if set[y * width + x] { 0.0 } else { run + 1.0 };
            column[y * width + x] = run;
        }
        run = FAR;
        for y in (0..height).rev() {
            run = if set[y * width + x] { 0.0 } else { run + 1.0 };
            column[y * width + x] = column[y * width + x].min(run);
        }
    }
    let mut out = vec![FAR; width * height];
    for (row, nearest) in column.chunks_exact(width).zip(out.chunks_exact_mut(width)) {
        for x in 0..width {
            let mut best = row[x] * row[x];
            for step in 1..width {
                let across = (step * step) as f32;
                if across >= best {
                    break;
                }
                if x >= step {
                    best = best.min(across + row[x - step] * row[x - step]);
                }
                if x + step < width {
                    best = best.min(across + row[x + step] * row[x + step]);
                }
            }
            nearest[x] = best.sqrt();
        }
    }
    out
}

/// Thinning to lines one pixel wide that keep every part connected (Zhang & Suen 1984).
pub fn thinned(width: usize, height: usize, inked: &[bool]) -> Vec<bool> {
    // A border of ground, so that ink may touch the picture's edge.
    let (w, h) = (width + 2, height + 2);
    let mut ink = vec![false; w * h];
    for y in 0..height {
        ink[(y + 1) * w + 1..][..width].copy_from_slice(&inked[y * width..][..width]);
    }
    let mut doomed = Vec::new();
    loop {
        let mut changed = false;
        for pass in 0..2 {
            doomed.clear();
            for y in 1..h - 1 {
                for x in 1..w - 1 {
                    let i = y * w + x;
                    if ink[i] && may_go(&ink, i, w, pass) {
                        doomed.push(i);
                    }
                }
            }
            for &i in &doomed {
                // Looked at again in turn: taken away all at once, a 2 x 2 block would vanish.
                let (count, rises) = crossings(&neighbours_of(&ink, i, w));
                if count >= 2 && rises == 1 {
                    ink[i] = false;
                    changed = true;
                }
            }
        }
        if !changed {
            break;
        }
    }
    (0..width * height).map(|i| ink[(i / width + 1) * w + i % width + 1]).collect()
}

/// Zhang and Suen's conditions for taking pixel `i` away in one of the two passes.
fn may_go(ink: &[bool], i: usize, w: usize, pass: usize) -> bool {
    let n = neighbours_of(ink, i, w);
    let (count, rises) = crossings(&n);
    if !(2..=6).contains(&count) || rises != 1 {
        return false;
    }
    let [north, east, south, west] = [n[0], n[2], n[4], n[6]];
    match pass {
        0 => !(north && east && south) && !(east && south && west),
        _ => !(north && east && west) && !(north && south && west),
    }
}

/// Clockwise from north.
fn neighbours_of(ink: &[bool], i: usize, w: usize) -> [bool; 8] {
    [i - w, i - w + 1, i + 1, i + w + 1, i + w, i + w - 1, i - 1, i - w - 1].map(|j| ink[j])
}

/// How many neighbours are ink, and how often ink begins on the way round.
fn crossings(n: &[bool; 8]) -> (usize, usize) {
    (n.iter().filter(|&&set| set).count(), (0..8).filter(|&k| !n[k] && n[(k + 1) % 8]).count())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn blob(width: usize, height: usize, seed: u64) -> Vec<bool> {
        let mut rng = Rng::new(seed, 3);
        let mut set = vec![false; width * height];
        for _ in 0..6 {
            let (cx, cy, r) =
                (rng.range(0.0, width as f64), rng.range(0.0, height as f64), rng.range(1.0, height as f64 / 4.0));
            for i in 0..set.len() {
                let (dx, dy) = ((i % width) as f64 - cx, (i / width) as f64 - cy);
                set[i] |= dx * dx + dy * dy < r * r;
            }
        }
        set
    }

    fn components(width: usize, set: &[bool]) -> usize {
        let height = set.len() / width;
        let mut seen = vec![false; set.len()];
        let mut count = 0;
        for s in 0..set.len() {
            if !set[s] || seen[s] {
                continue;
            }
            count += 1;
            let mut stack = vec![s];
            seen[s] = true;
            while let Some(i) = stack.pop() {
                let (x, y) = ((i % width) as isize, (i / width) as isize);
                for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
                    let (x, y) = (x + dx, y + dy);
                    if x >= 0 && y >= 0 && (x as usize) < width && (y as usize) < height {
                        let j = y as usize * width + x as usize;
                        if set[j] && !seen[j] {
                            seen[j] = true;
                            stack.push(j);
                        }
                    }
                }
            }
        }
        count
    }

    #[test]
    fn distances_equal_brute_force() {
        let (width, height) = (23, 17);
        let set = blob(width, height, 1);
        let fast = distance(width, height, &set);
        for i in 0..set.len() {
            let brute = (0..set.len())
                .filter(|&j| set[j])
                .map(|j| {
                    let (dx, dy) = ((i % width).abs_diff(j % width), (i / width).abs_diff(j / width));
                    ((dx * dx + dy * dy) as f32).sqrt()
                })
                .fold(f32::MAX, f32::min);
            assert_eq!(fast[i], brute, "pixel {i}");
        }
    }

    #[test]
    fn thinning_keeps_parts_and_stays_inside() {
        for seed in 0..20 {
            let (width, height) = (40, 32);
            let set = blob(width, height, seed);
            let thin = thinned(width, height, &set);
            assert!((0..set.len()).all(|i| !thin[i] || set[i]), "seed {seed}: a line left the ink");
            assert_eq!(components(width, &thin), components(width, &set), "seed {seed}");
            let count = |s: &[bool]| s.iter().filter(|&&b| b).count();
            assert!(count(&thin) < count(&set) / 2, "seed {seed}: hardly thinner");
        }
    }

    #[test]
    fn fat_areas_get_inner_lines() {
        let mut ink = Image::new(64, 64);
        for i in 0..64 * 64 {
            let (x, y) = (i % 64, i / 64);
            ink.data[i] = f32::from((8..56).contains(&x) && (8..56).contains(&y));
        }
        let plane = Plane::new(&ink, 64, 64, 2.5);
        let farthest = (0..64 * 64).filter(|&i| plane.inked[i]).map(|i| plane.to_line_px[i]).fold(0.0, f32::max);
        assert!(farthest <= 5.0, "a place {farthest} px from every line would stay empty");
        let without = Plane::new(&ink, 64, 64, 100.0);
        assert!((0..64 * 64).any(|i| without.inked[i] && without.to_line_px[i] > 8.0), "the check can fail");
    }
}
