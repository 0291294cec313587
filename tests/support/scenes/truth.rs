//! Masks and lines from what a camera sees of the geometry.

use super::SIDE;
use glam::DVec3;

/// What is seen at a place of a grid twice as fine as the photograph; `None` on the ground.
#[derive(Clone, Copy)]
pub struct Seen {
    pub place: DVec3,
    pub normal: DVec3,
    pub part: usize,
    pub patch: u32,
}

/// Two neighbours further than this off each other's tangent planes do not hang together, world units.
const GAP: f64 = 0.025;
/// Cosine of the sharpest bend that is none.
const BEND: f64 = 0.88;
/// Lines with fewer pixels are specks.
const LEAST_PX: usize = 8;

/// Mask, contours, creases, painted borders.
pub fn truth(seen: &[Option<Seen>]) -> [Vec<bool>; 4] {
    let fine = 2 * SIDE;
    let mut counts = vec![0u8; SIDE * SIDE];
    let [mut contours, mut creases, mut painted] = [(); 3].map(|()| vec![false; SIDE * SIDE]);
    for i in 0..seen.len() {
        let (x, y) = (i % fine, i / fine);
        let at = y / 2 * SIDE + x / 2;
        counts[at] += u8::from(seen[i].is_some());
        for (n, inside) in [(i + 1, x + 1 < fine), (i + fine, y + 1 < fine)] {
            if !inside {
                continue;
            }
            let kind = match (&seen[i], &seen[n]) {
                (None, None) => continue,
                (Some(a), Some(b)) => {
                    let step = b.place - a.place;
                    let off = step.dot(a.normal).abs().min(step.dot(b.normal).abs());
                    if off > GAP {
                        &mut contours
                    } else if a.normal.dot(b.normal) < BEND {
                        &mut creases
                    } else if a.part != b.part || a.patch != b.patch {
                        &mut painted
                    } else {
                        continue;
                    }
                }
                _ => &mut contours,
            };
            kind[at] = true;
        }
    }
    let mask = counts.iter().map(|&count| count >= 2).collect();
    [mask, without_specks(contours), without_specks(creases), without_specks(painted)]
}

fn without_specks(mut lines: Vec<bool>) -> Vec<bool> {
    let mut met = vec![false; lines.len()];
    for seed in 0..lines.len() {
        if !lines[seed] || met[seed] {
            continue;
        }
        met[seed] = true;
        let mut piece = vec![seed];
        let mut k = 0;
        while k < piece.len() {
            let (x, y) = (piece[k] % SIDE, piece[k] / SIDE);
            for v in y.saturating_sub(1)..SIDE.min(y + 2) {
                for u in x.saturating_sub(1)..SIDE.min(x + 2) {
                    let n = v * SIDE + u;
                    if lines[n] && !std::mem::replace(&mut met[n], true) {
                        piece.push(n);
                    }
                }
            }
            k += 1;
        }
        if piece.len() < LEAST_PX {
            piece.iter().for_each(|&i| lines[i] = false);
        }
    }
    lines
}
