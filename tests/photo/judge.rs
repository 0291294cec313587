//! What cuts and drawings are measured by, and somebody who draws strokes where a cut is wrong.

use crate::scenes::{Photograph, SIDE, photograph, twelve};
use std::sync::LazyLock;
use wire4d::picture::cut::Stroke;
use wire4d::picture::drawing::Line;
use wire4d::picture::{Mask, Photo, Picture};
use wire4d::view::Image;

/// The twelve photographs, as they were taken and as they are looked at.
pub static PHOTOS: LazyLock<Vec<(Photograph, Photo)>> = LazyLock::new(|| {
    let seen = |taken: Photograph| {
        let photo = photo_of(taken.name, &taken.rgb);
        (taken, photo)
    };
    twelve().iter().map(|scene| seen(photograph(scene))).collect()
});

/// A photograph as it is looked at.
pub fn photo_of(name: &str, rgb: &[u8]) -> Photo {
    let rgba = rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    Photo::of(&Picture::new(name, SIDE, SIDE, rgba).unwrap())
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

/// The stroke that somebody would draw next: through the middle of the largest part that is wrong, along it, at most
/// 90 px; and whether it marks object. `None` if nothing is wrong.
pub fn next_stroke(truth: &[bool], found: &Image) -> Option<(bool, Stroke)> {
    let mut largest: Option<(usize, Mask, bool)> = None;
    for object in [true, false] {
        let wrong = |i: usize| truth[i] == object && (found.data[i] > 0.5) != object;
        let parts = mask((0..SIDE * SIDE).map(wrong).collect()).components();
        for (label, &size) in (1..).zip(&parts.sizes) {
            if largest.as_ref().is_none_or(|known| size > known.0) {
                largest = Some((size, mask(parts.labels.iter().map(|&l| l == label).collect()), object));
            }
        }
    }
    let (_, part, object) = largest?;
    let depth = part.inverted().distance_px().data;
    let on = || (0..SIDE * SIDE).filter(|&i| part.data[i]);
    let middle = on().max_by(|&a, &b| depth[a].total_cmp(&depth[b]))?;
    let [cx, cy] = [middle % SIDE, middle / SIDE].map(|c| c as f64);
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for i in on() {
        let (x, y) = ((i % SIDE) as f64 - cx, (i / SIDE) as f64 - cy);
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
    let end = |way: f64| {
        let at = |t: f64| [cx + way * t * cos, cy + way * t * sin];
        let inside = |[x, y]: [f64; 2]| {
            x >= 0.0 && y >= 0.0 && x < SIDE as f64 && y < SIDE as f64 && depth[y as usize * SIDE + x as usize] >= 2.0
        };
        let long = (1..=45).take_while(|&t| inside(at(f64::from(t)))).last().unwrap_or(0);
        at(f64::from(long)).map(|c| (c + 0.5) as f32)
    };
    Some((object, Stroke { points: vec![end(1.0), end(-1.0)], radius_px: depth[middle].clamp(0.5, 3.0) }))
}
