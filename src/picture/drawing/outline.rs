//! The borders of a mask as smooth closed lines.

use super::line::{length, smooth};
use crate::picture::Mask;
use crate::sorting::sort_by;

/// How much pixels' corners are smoothed away, px.
const SMOOTH: f32 = 3.0;
/// Shorter borders are not drawn, px.
const LEAST: f32 = 40.0;
/// Nearer to the picture's rim than this nothing is a border, px.
const RIM: f32 = 1.5;

/// The borders of the object and of its holes, without what runs along the picture's rim; longest first.
pub fn outlines(mask: &Mask) -> Vec<Vec<[f32; 2]>> {
    let (w, h) = (mask.width as f32, mask.height as f32);
    let on_rim = |p: &[f32; 2]| p[0] < RIM || p[1] < RIM || p[0] > w - RIM || p[1] > h - RIM;
    let mut found = Vec::new();
    for mut ring in rings(mask) {
        if let Some(first) = ring.iter().position(on_rim) {
            // Begins on the rim, so that no piece is cut in two.
            ring.pop();
            ring.rotate_left(first);
            found.extend(ring.split(on_rim).filter(|piece| piece.len() > 1).map(<[_]>::to_vec));
        } else {
            found.push(ring);
        }
    }
    found.retain(|line| length(line) >= LEAST);
    let mut smoothed: Vec<Vec<[f32; 2]>> = found.iter().map(|line| smooth(line, SMOOTH)).collect();
    sort_by(&mut smoothed, |a, b| length(b).total_cmp(&length(a)));
    smoothed
}

/// Closed walks along the cracks between the mask and what is not, the mask to the right; px. Corners where two pixels
/// touch keep the mask together.
fn rings(mask: &Mask) -> Vec<Vec<[f32; 2]>> {
    let (w, h) = (mask.width as isize, mask.height as isize);
    let on = |x: isize, y: isize| x >= 0 && y >= 0 && x < w && y < h && mask.data[(y * w + x) as usize];
    const STEPS: [[isize; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    // Pixels to the right and to the left of a step from a corner.
    const RIGHT: [[isize; 2]; 4] = [[0, 0], [-1, 0], [-1, -1], [0, -1]];
    const LEFT: [[isize; 2]; 4] = [[0, -1], [0, 0], [-1, 0], [-1, -1]];
    let is_crack =
        |x: isize, y: isize, d: usize| on(x + RIGHT[d][0], y + RIGHT[d][1]) && !on(x + LEFT[d][0], y + LEFT[d][1]);
    let mut walked = vec![false; (4 * (w + 1) * (h + 1)) as usize];
    let slot = |x: isize, y: isize, d: usize| (4 * (y * (w + 1) + x)) as usize + d;
    let mut found = Vec::new();
    for y0 in 0..=h {
        for x0 in 0..=w {
            for d0 in 0..4 {
                if walked[slot(x0, y0, d0)] || !is_crack(x0, y0, d0) {
                    continue;
                }
                let (mut x, mut y, mut d) = (x0, y0, d0);
                let mut ring = Vec::new();
                while !std::mem::replace(&mut walked[slot(x, y, d)], true) {
                    // The middle of each crack.
                    ring.push([x as f32 + 0.5 * STEPS[d][0] as f32, y as f32 + 0.5 * STEPS[d][1] as f32]);
                    x += STEPS[d][0];
                    y += STEPS[d][1];
                    // Left first: across a corner the mask hangs together.
                    let turn = [3, 0, 1].into_iter().map(|turn| (d + turn) % 4).find(|&d| is_crack(x, y, d));
                    d = turn.unwrap_or(d);
                }
                ring.push(ring[0]);
                found.push(ring);
            }
        }
    }
    found
}
