//! Which ink front, side and top show together, a row of cells at a time.

use crate::picture::Mask;
use crate::view::{Projection, Target, View};

/// Most cells across: a row is one word.
pub const MOST_ACROSS: usize = 128;

/// Whether the targets are the canonical square views front, side and perhaps top, all of one size.
pub fn are_canonical(targets: &[Target]) -> bool {
    if !(2..=3).contains(&targets.len()) {
        return false;
    }
    let Projection::Orthographic { height_world } = targets[0].view.projection else { return false };
    let size = targets[0].view.width_px;
    View::canonical(height_world, size).iter().zip(targets).all(|(canonical, target)| {
        let (wanted, found) = (canonical.camera::<f64>(), target.view.camera::<f64>());
        let same_size = target.view.width_px == size && target.view.height_px == size;
        let probes = [[0.0; 4], [0.3, 0.0, 0.0, 0.0], [0.0, 0.3, 0.0, 0.0], [0.0, 0.0, 0.3, 0.1]];
        same_size
            && target.view.projection == targets[0].view.projection
            && probes.iter().all(|probe| {
                let (a, b) = (wanted.project(probe), found.project(probe));
                (0..3).all(|c| (a[c] - b[c]).abs() < 1e-6)
            })
    })
}

/// For each view's ink the pixels on which some cell lies that is on ink in every view. The pictures are square, of an
/// even number of pixels up to [`MOST_ACROSS`], a pixel a cell; the box in their middle has `size` cells along x, y, z.
///
/// Front: row -y, column x. Side: row -y, column -z. Top: row z, column x.
pub fn shown_together(inked: &[Mask], size: [usize; 3]) -> Vec<Mask> {
    let across = inked[0].width;
    let range = |cells: usize| across / 2 - (cells / 2).min(across / 2)..across / 2 + (cells / 2).min(across / 2);
    let word = |row: &[bool]| row.iter().enumerate().fold(0u128, |word, (x, &on)| word | u128::from(on) << x);
    let rows: Vec<Vec<u128>> = inked.iter().map(|mask| mask.data.chunks_exact(across).map(word).collect()).collect();
    let within_x = range(size[0]).fold(0u128, |word, x| word | 1 << x);
    let mut shown = vec![vec![0u128; across]; 3];
    for y in range(size[1]) {
        for column in range(size[2]).filter(|column| rows[1][y] >> column & 1 == 1) {
            let z = across - 1 - column;
            let cells = rows[0][y] & rows.get(2).map_or(u128::MAX, |top| top[z]) & within_x;
            shown[0][y] |= cells;
            shown[1][y] |= u128::from(cells != 0) << column;
            shown[2][z] |= cells;
        }
    }
    let mask = |rows: &Vec<u128>| Mask {
        width: across,
        height: across,
        data: rows.iter().flat_map(|row| (0..across).map(move |x| row >> x & 1 == 1)).collect(),
    };
    shown.iter().take(inked.len()).map(mask).collect()
}
