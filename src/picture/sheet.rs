//! A sheet of paper that does not fill its picture: photographed on a desk, framed, or scanned with strips beside it.

use super::spread::otsu;
use super::{Ink, Mask};
use crate::view::Image;

/// Where more of the border is of the sheet's shade, the sheet fills its picture.
const MOST_BORDER: f64 = 0.65;
/// Least share of the picture of one part of the sheet: what is smaller lies on the desk.
const LEAST_PART: f64 = 0.03;
/// Share of the sheet that is marked.
const MARKED: [f64; 2] = [0.002, 0.4];
/// Most of what is outside that may be of the sheet's shade.
const MOST_OUTSIDE: f64 = 0.15;
/// Least share of the sheet's margin that is unmarked.
const LEAST_MARGIN: f64 = 0.9;
/// How far inside its edge the sheet is surely paper, as a share of the picture's longer side.
const INSET: f32 = 0.012;

/// Where a picture surely shows a sheet with marks on it that other shades surround, and whether it is light; `least` is
/// the share of the picture that a dark and a light one must cover. `None` for all other pictures: they are all ground.
///
/// The sheet is the quadrangle that its shade's farthest pixels span.
pub fn sheet(luma: &Image, least: [f64; 2]) -> Option<(Mask, bool)> {
    let light = luma.threshold(otsu(luma.data.iter().copied()));
    let (width, height) = (luma.width, luma.height);
    let border = (0..light.data.len()).filter(|&i| is_rim(i, width, height, 1));
    let (all, bright) = border.fold((0u32, 0u32), |(all, bright), i| (all + 1, bright + u32::from(light.data[i])));
    let bright = f64::from(bright) / f64::from(all);
    if bright < MOST_BORDER
        && let Some(inside) = spanned(&light, least[1])
    {
        return Some((inside, true));
    }
    if 1.0 - bright >= MOST_BORDER {
        return None;
    }
    spanned(&light.inverted(), least[0]).map(|inside| (inside, false))
}

/// Whether a pixel is one of the outermost `rim`.
pub fn is_rim(i: usize, width: usize, height: usize, rim: usize) -> bool {
    let (x, y) = (i % width, i / width);
    x < rim || y < rim || x + rim >= width || y + rim >= height
}

/// The quadrangle that a shade spans, if it is a marked sheet.
fn spanned(shade: &Mask, least: f64) -> Option<Mask> {
    let (width, height) = (shade.width, shade.height);
    let parts = shade.components();
    let large = |label: u32| label > 0 && parts.sizes[label as usize - 1] as f64 > LEAST_PART * shade.data.len() as f64;
    // A corner is farthest in one of four directions; of a sheet that stands on a corner, in four others.
    let mut corners = [[[0.0f32; 2]; 4]; 2];
    let mut reach = [[f32::MIN; 4]; 2];
    for i in (0..shade.data.len()).filter(|&i| large(parts.labels[i])) {
        let [x, y] = [(i % width) as f32 + 0.5, (i / width) as f32 + 0.5];
        for (set, far) in [[-x - y, x - y, x + y, y - x], [-y, x, y, -x]].into_iter().enumerate() {
            for k in 0..4 {
                if far[k] > reach[set][k] {
                    (reach[set][k], corners[set][k]) = (far[k], [x, y]);
                }
            }
        }
    }
    let area =
        |c: &[[f32; 2]; 4]| (0..4).map(|k| c[k][0] * c[(k + 1) % 4][1] - c[(k + 1) % 4][0] * c[k][1]).sum::<f32>();
    let [straight, askew] = corners;
    let corners = if area(&straight) >= area(&askew) { straight } else { askew };
    let inset = (INSET * width.max(height) as f32).max(2.0);
    let edges: Vec<([f32; 2], [f32; 2], bool)> = (0..4)
        .map(|k| {
            let ([ax, ay], [bx, by]) = (corners[k], corners[(k + 1) % 4]);
            let length = (bx - ax).hypot(by - ay).max(1e-3);
            // The outermost pixels' centres are half a pixel from the border.
            let at_rim = |x: f32, y: f32| x.min(y).min(width as f32 - x).min(height as f32 - y) < 1.0;
            ([ax, ay], [(ay - by) / length, (bx - ax) / length], at_rim(0.5 * (ax + bx), 0.5 * (ay + by)))
        })
        .collect();
    // Distance from the nearest edge of the sheet that is not the picture's own.
    let depth = |i: usize| {
        let [x, y] = [(i % width) as f32 + 0.5, (i / width) as f32 + 0.5];
        let depths = edges.iter().filter(|edge| !edge.2).map(|([ax, ay], [u, v], _)| (x - ax) * u + (y - ay) * v);
        depths.fold(f32::MAX, f32::min)
    };
    let (mut inside, mut margin, mut outside) = ([0usize; 2], [0usize; 2], [0usize; 2]);
    let mut mask = Mask::new(width, height);
    for i in 0..mask.data.len() {
        let depth = depth(i);
        mask.data[i] = depth >= inset;
        let counted = |counts: &mut [usize; 2], here: bool| counts[usize::from(shade.data[i])] += usize::from(here);
        counted(&mut inside, mask.data[i]);
        counted(&mut margin, mask.data[i] && depth < 2.0 * inset);
        counted(&mut outside, depth < -0.9);
    }
    let all = |counts: [usize; 2]| (counts[0] + counts[1]) as f64;
    let marked = inside[0] as f64 / all(inside);
    let is_sheet = all(inside) >= least * mask.data.len() as f64
        && (MARKED[0]..MARKED[1]).contains(&marked)
        && margin[1] as f64 >= LEAST_MARGIN * all(margin)
        && all(outside) > 0.0
        && outside[1] as f64 <= MOST_OUTSIDE * all(outside);
    is_sheet.then_some(mask)
}
