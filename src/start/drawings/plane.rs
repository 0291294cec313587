//! One view's ink on the grid's own pixels: what is ink, how far it is to ink, to ground, to the strokes' middle lines.

use crate::picture::{Ink, Mask};
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
        let inked = Plane::ink_mask(ink, width, height);
        let depth_px = inked.inverted().distance_px().data;
        let stray_px = inked.distance_px().data;
        let mut lines = inked.thin();
        add_inner_lines(&depth_px, strand_px, &mut lines);
        let to_line_px = lines.distance_px().data;
        Plane { width, height, inked: inked.data, depth_px, stray_px, lines: lines.data, to_line_px }
    }

    /// Which pixels of a plane of `width` x `height` are ink.
    pub fn ink_mask(ink: &Image, width: usize, height: usize) -> Mask {
        ink.resized(width, height).threshold(INK_SHARE)
    }

    /// Which pixels are ink.
    pub fn inked_mask(&self) -> Mask {
        Mask { width: self.width, height: self.height, data: self.inked.clone() }
    }

    /// Whether there is any ink at all.
    pub fn is_blank(&self) -> bool {
        !self.inked.contains(&true)
    }
}

/// Contours at depths strand, 3 strand, 5 strand… inside areas deeper than twice the strand's half width: with the
/// outline's own middle line they fill the area evenly.
fn add_inner_lines(depth_px: &[f32], strand_px: f32, lines: &mut Mask) {
    let fat = Mask { data: depth_px.iter().map(|&depth| depth > 2.0 * strand_px).collect(), ..*lines };
    let to_fat = fat.distance_px().data;
    for (i, &depth) in depth_px.iter().enumerate() {
        // Within a strand of the fat part's rim: its first contour lies one strand deep.
        let near_fat = to_fat[i] <= strand_px + 1.5;
        let on_contour = depth >= strand_px && (depth - strand_px).rem_euclid(2.0 * strand_px) < 1.0;
        lines.data[i] |= near_fat && on_contour;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
