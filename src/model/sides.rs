//! How triangles hang together by their sides. Side k of a triangle runs from its corner k to the next.

use wire4d_core::geometry::DisjointSets;

/// No triangle on the other side.
pub(super) const OPEN: u32 = u32::MAX;

/// Keeps the first of triangles with the same corners, whichever way they are turned.
pub(super) fn drop_doubles(triangles: &mut Vec<[u32; 3]>) {
    let mut sorted: Vec<([u32; 3], u32)> = triangles
        .iter()
        .zip(0..)
        .map(|(t, i)| {
            let mut key = *t;
            key.sort_unstable();
            (key, i)
        })
        .collect();
    sorted.sort_unstable();
    let mut keep = vec![true; triangles.len()];
    for pair in sorted.windows(2) {
        keep[pair[1].1 as usize] = pair[0].0 != pair[1].0;
    }
    let mut kept = keep.iter();
    triangles.retain(|_| *kept.next().unwrap_or(&false));
}

/// All sides as (edge, 3 triangle + side), sorted.
fn sides(triangles: &[[u32; 3]]) -> Vec<(u64, u32)> {
    let mut sides: Vec<(u64, u32)> = Vec::with_capacity(3 * triangles.len());
    for (i, t) in triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            sides.push((u64::from(a.min(b)) << 32 | u64::from(a.max(b)), (3 * i + k) as u32));
        }
    }
    sides.sort_unstable();
    sides
}

/// Whether a side runs from the lower to the higher corner.
fn rises(triangles: &[[u32; 3]], side: u32) -> bool {
    let (t, k) = (triangles[side as usize / 3], side as usize % 3);
    t[k] < t[(k + 1) % 3]
}

/// Drops triangles from edges that more than one of them passes in one direction, the lowest stays; how many.
pub(super) fn thin_out(triangles: &mut Vec<[u32; 3]>) -> usize {
    let mut keep = vec![true; triangles.len()];
    for edge in sides(triangles).chunk_by(|a, b| a.0 == b.0) {
        for direction in [false, true] {
            for &(_, side) in edge.iter().filter(|side| rises(triangles, side.1) == direction).skip(1) {
                keep[side as usize / 3] = false;
            }
        }
    }
    let before = triangles.len();
    let mut kept = keep.iter();
    triangles.retain(|_| *kept.next().unwrap_or(&false));
    before - triangles.len()
}

/// The triangle at each side of each triangle, and how many edges had more than two. Of those, sides that run in
/// opposite directions are joined in the order of their triangles, the others stay open. No triangle may be there twice.
pub(super) fn link(triangles: &[[u32; 3]]) -> (Vec<[u32; 3]>, usize) {
    let mut links = vec![[OPEN; 3]; triangles.len()];
    let mut join = |a: u32, b: u32| {
        links[a as usize / 3][a as usize % 3] = b / 3;
        links[b as usize / 3][b as usize % 3] = a / 3;
    };
    let mut cut = 0;
    for edge in sides(triangles).chunk_by(|a, b| a.0 == b.0) {
        match edge {
            [_] => {}
            [a, b] => join(a.1, b.1),
            _ => {
                cut += 1;
                let (up, down): (Vec<u32>, Vec<u32>) =
                    edge.iter().map(|side| side.1).partition(|&side| rises(triangles, side));
                for (&a, &b) in up.iter().zip(&down) {
                    join(a, b);
                }
            }
        }
    }
    (links, cut)
}

/// Turns triangles so that joined ones agree, starting from the lowest of each part, and cuts joints that cannot agree
/// (a Möbius strip). Gives each triangle's part and whether it was turned.
pub(super) fn orient(triangles: &mut [[u32; 3]], links: &mut [[u32; 3]]) -> (Vec<u32>, Vec<bool>) {
    let mut part = vec![u32::MAX; triangles.len()];
    let mut turned = vec![false; triangles.len()];
    // Neighbours agree if they pass their common side in opposite directions.
    let agree = |triangles: &[[u32; 3]], i: usize, k: usize, j: usize| {
        let (a, b) = (triangles[i][k], triangles[i][(k + 1) % 3]);
        (0..3).any(|side| triangles[j][side] == b && triangles[j][(side + 1) % 3] == a)
    };
    let mut waiting = Vec::new();
    let mut parts = 0;
    for start in 0..triangles.len() {
        if part[start] != u32::MAX {
            continue;
        }
        part[start] = parts;
        waiting.push(start);
        while let Some(i) = waiting.pop() {
            for k in 0..3 {
                let j = links[i][k] as usize;
                if j == OPEN as usize || part[j] != u32::MAX {
                    continue;
                }
                part[j] = parts;
                if !agree(triangles, i, k, j) {
                    turned[j] = true;
                    triangles[j].swap(1, 2);
                    links[j].swap(0, 2);
                }
                waiting.push(j);
            }
        }
        parts += 1;
    }
    for i in 0..triangles.len() {
        for k in 0..3 {
            let j = links[i][k];
            if j != OPEN && !agree(triangles, i, k, j as usize) {
                links[i][k] = OPEN;
            }
        }
    }
    (part, turned)
}

/// Gives every fan of triangles that hang together round a corner a corner of its own; what belongs to triangles that
/// are not kept, or to none, goes. The new corners, and how many were added.
pub(super) fn separate(
    positions: &[[f64; 3]],
    triangles: &mut [[u32; 3]],
    links: &[[u32; 3]],
    keep: &[bool],
) -> (Vec<[f64; 3]>, usize) {
    // Corners of triangles in sets that share a place and are joined by sides.
    let mut sets = DisjointSets::new(3 * triangles.len());
    for (i, t) in triangles.iter().enumerate() {
        for k in 0..3 {
            let j = links[i][k] as usize;
            if j == OPEN as usize {
                continue;
            }
            for at in [k, (k + 1) % 3] {
                let Some(same) = triangles[j].iter().position(|&corner| corner == t[at]) else { continue };
                sets.join(3 * i + at, 3 * j + same);
            }
        }
    }
    let mut number = vec![u32::MAX; 3 * triangles.len()];
    let mut used = vec![false; positions.len()];
    let mut corners = Vec::new();
    for i in (0..triangles.len()).filter(|&i| keep[i]) {
        for k in 0..3 {
            let set = sets.root(3 * i + k);
            if number[set] == u32::MAX {
                number[set] = corners.len() as u32;
                corners.push(positions[triangles[i][k] as usize]);
                used[triangles[i][k] as usize] = true;
            }
            triangles[i][k] = number[set];
        }
    }
    let added = corners.len() - used.iter().filter(|&&used| used).count();
    (corners, added)
}
