//! What cuts and drawings of photographs of known truth are measured by.

use crate::scenes::{Photograph, SIDE};
use wire4d::picture::drawing::Line;
use wire4d::picture::{Mask, Picture};
use wire4d::view::Image;

/// A photograph as a picture that somebody gives.
pub fn picture(taken: &Photograph) -> Picture {
    let rgba = taken.rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    Picture::new(taken.name, SIDE, SIDE, rgba).unwrap()
}

pub fn mask(data: Vec<bool>) -> Mask {
    Mask { width: SIDE, height: SIDE, data }
}

/// Intersection over union.
pub fn overlap(truth: &[bool], found: &Image) -> f64 {
    let count = |keep: &dyn Fn(bool, bool) -> bool| {
        truth.iter().zip(&found.data).filter(|(truth, found)| keep(**truth, **found > 0.5)).count()
    };
    count(&|a, b| a && b) as f64 / count(&|a, b| a || b) as f64
}

/// A box with so much margin on each side, as a share of the object's.
pub fn box_round(truth: &[bool], margin: f32) -> [f32; 4] {
    let frame = mask(truth.to_vec()).bounding_box().unwrap();
    let [x, y] = [frame.width(), frame.height()].map(|side| margin * side as f32);
    let sides = [frame.left as f32 - x, frame.top as f32 - y, frame.right as f32 + x, frame.bottom as f32 + y];
    sides.map(|side| side.clamp(0.0, SIDE as f32))
}

/// Pixels that lines run through.
pub fn pixels(lines: &[Line]) -> Vec<bool> {
    let mut on = vec![false; SIDE * SIDE];
    for w in lines.iter().flat_map(|line| line.points.windows(2)) {
        for step in 0..4 {
            let [x, y] = [0, 1].map(|k| w[0][k] + 0.25 * step as f32 * (w[1][k] - w[0][k]));
            if (0.0..SIDE as f32).contains(&x) && (0.0..SIDE as f32).contains(&y) {
                on[y as usize * SIDE + x as usize] = true;
            }
        }
    }
    on
}

/// Share of some pixels that have one of others within 2 px at 256 px.
pub fn share_near(some: &[bool], others: &[bool]) -> f64 {
    let far = mask(others.to_vec()).distance_px();
    let near = some.iter().zip(&far.data).filter(|(on, far)| **on && **far <= 4.0).count();
    near as f64 / some.iter().filter(|&&on| on).count().max(1) as f64
}

/// Pixels of a mask on its border.
pub fn border(truth: &[bool]) -> Vec<bool> {
    let far = mask(truth.to_vec()).inverted().distance_px();
    truth.iter().zip(&far.data).map(|(&on, &far)| on && far < 1.5).collect()
}

/// Lines drawn of a photograph: their precision (painted borders are lines too), and their recall of contours and creases
/// and of the outline.
pub fn judged(lines: &[Line], taken: &Photograph) -> [f64; 3] {
    let drawn = pixels(lines);
    let either = |a: &[bool], b: &[bool]| a.iter().zip(b).map(|(a, b)| *a || *b).collect::<Vec<_>>();
    let truth = either(&taken.contours, &taken.creases);
    let allowed = either(&truth, &taken.painted);
    [share_near(&drawn, &allowed), share_near(&truth, &drawn), share_near(&border(&taken.mask), &drawn)]
}
