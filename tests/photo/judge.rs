//! The twelve photographs, and somebody who draws strokes where a cut is wrong.

use crate::photo_judge::{mask, picture};
use crate::scenes::{Photograph, SIDE, photograph, twelve};
use std::sync::LazyLock;
use wire4d::picture::cut::Stroke;
use wire4d::picture::{Mask, Photo};
use wire4d::view::Image;

/// The twelve photographs, as they were taken and as they are looked at.
pub static PHOTOS: LazyLock<Vec<(Photograph, Photo)>> = LazyLock::new(|| {
    let seen = |taken: Photograph| {
        let photo = Photo::of(&picture(&taken));
        (taken, photo)
    };
    twelve().iter().map(|scene| seen(photograph(scene))).collect()
});

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
