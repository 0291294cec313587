//! Crumbs and pinholes taken out of a cut.

use crate::picture::Mask;

/// Parts smaller than this share of the largest go, holes smaller than this share of the object close.
const LEAST_PART: f64 = 0.12;
const LEAST_HOLE: f64 = 0.002;

/// The cut without crumbs and pinholes; what was `marked` as object is no crumb.
pub fn tidy(mask: &Mask, marked: impl Fn(usize) -> bool) -> Mask {
    let parts = mask.components();
    let largest = parts.sizes.iter().copied().max().unwrap_or(0) as f64;
    let mut is_kept: Vec<bool> = parts.sizes.iter().map(|&size| size as f64 >= LEAST_PART * largest).collect();
    for (i, &label) in parts.labels.iter().enumerate() {
        if label > 0 && marked(i) {
            is_kept[label as usize - 1] = true;
        }
    }
    let kept = |label: u32| label > 0 && is_kept[label as usize - 1];
    let mut out = Mask { data: parts.labels.iter().map(|&label| kept(label)).collect(), ..*mask };
    let area = out.count() as f64;
    let holes = out.inverted().components();
    for (on, &label) in out.data.iter_mut().zip(&holes.labels) {
        *on |= label > 0 && (holes.sizes[label as usize - 1] as f64) < LEAST_HOLE * area;
    }
    out
}

/// All pixels within a distance of the mask.
pub fn grown(mask: &Mask, radius_px: f32) -> Mask {
    mask.dilated(radius_px)
}
