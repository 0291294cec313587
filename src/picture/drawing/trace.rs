//! From thin lines of pixels to chains of places, ended at every junction.

use crate::picture::Mask;
use crate::sorting::sort_by_key;

/// Chains with fewer pixels are dropped.
const LEAST: usize = 4;

/// The chains of a mask's skeleton, places as whole numbers.
pub fn chains(mask: &Mask) -> Vec<Vec<[f32; 2]>> {
    let mut thin = mask.thin();
    let (w, h) = (thin.width, thin.height);
    let around = move |i: usize| {
        let (x, y) = (i % w, i / w);
        // Straight neighbours first, so that corners are not cut.
        [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (1, -1), (-1, -1), (-1, 1)].into_iter().filter_map(
            move |(dx, dy): (isize, isize)| {
                let (u, v) = (x.checked_add_signed(dx)?, y.checked_add_signed(dy)?);
                (u < w && v < h).then_some(v * w + u)
            },
        )
    };
    let on: Vec<usize> = (0..w * h).filter(|&i| thin.data[i]).collect();
    let junctions: Vec<usize> =
        on.iter().copied().filter(|&i| around(i).filter(|&n| thin.data[n]).count() >= 3).collect();
    junctions.iter().for_each(|&i| thin.data[i] = false);
    let mut left = thin.data;
    let degree: Vec<usize> = on.iter().map(|&i| around(i).filter(|&n| left[n]).count()).collect();
    let mut order: Vec<usize> = (0..on.len()).collect();
    // From ends first, then what is left: rings.
    sort_by_key(&mut order, |&k| (degree[k], k));
    let mut found = Vec::new();
    for k in order {
        let mut at = on[k];
        if !std::mem::replace(&mut left[at], false) {
            continue;
        }
        let start = at;
        let mut chain = vec![[(at % w) as f32, (at / w) as f32]];
        while let Some(next) = around(at).find(|&n| left[n]) {
            left[next] = false;
            chain.push([(next % w) as f32, (next / w) as f32]);
            at = next;
        }
        if chain.len() > 8 && around(at).any(|n| n == start) {
            chain.push(chain[0]);
        }
        if chain.len() >= LEAST {
            found.push(chain);
        }
    }
    found
}
