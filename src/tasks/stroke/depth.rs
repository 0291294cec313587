//! A depth picture as nearness over the object's picture.

use crate::picture::{Ink, Mask, Object, Picture};
use crate::view::Image;
use crate::{Error, Result};

/// Things are nearer in their middle than at their rim: where a measured depth goes the other way by this much of its
/// spread, it tells distances.
const INWARD: f32 = 0.1;

/// How near the object is, light is near, over its picture. What is not known of the object is filled in from round it.
pub(super) fn nearness(depth: &Picture, picture: &Picture, object: &Object, notes: &mut Vec<String>) -> Result<Image> {
    let (width, height) = (depth.width(), depth.height());
    if (width, height) != (picture.width(), picture.height()) {
        let problem = format!("is {width} x {height} px, and its picture {} x {}", picture.width(), picture.height());
        return Err(Error::picture(depth.name(), problem, "give a depth picture of the same size"));
    }
    let grey = |p: &[u8]| (f32::from(p[0]) + f32::from(p[1]) + f32::from(p[2])) / 765.0;
    let data: Vec<f32> = depth.rgba().chunks_exact(4).map(grey).collect();
    // What is known of the object: its ground's depth has no say, nor has nothing, where depths were measured.
    let body = object.body.resized(width, height);
    let known = |i: usize| f32::from(body.data[i] > 0.9 && (!depth.is_measured() || data[i] > 0.0));
    let known: Vec<f32> = (0..data.len()).map(known).collect();
    let small = |data: Vec<f32>| Image { width, height, data }.resized(object.mask.width, object.mask.height);
    let values = small(data.iter().zip(&known).map(|(value, known)| value * known).collect());
    let weights = small(known);
    let sigma_px = FILLED_IN * values.width.max(values.height) as f64;
    let (values_near, weights_near) = (values.blurred(sigma_px), weights.blurred(sigma_px));
    let filled = (0..values.data.len()).map(|i| match weights.data[i] {
        0.0 => values_near.data[i] / weights_near.data[i].max(1e-6),
        weight => values.data[i] / weight,
    });
    let mut near = Image { data: filled.collect(), ..values };
    let body = object.body.threshold(0.5);
    if depth.is_measured() && correlation(&near, &body.inverted().distance_px(), &body) < -INWARD {
        let name = depth.name();
        notes.push(format!("{name}: its middle is darker than its rim, so it is taken for distances, dark is near"));
        near.data.iter_mut().for_each(|value| *value = 1.0 - *value);
    }
    Ok(near)
}

/// How far known depths reach into what is not known, as a share of the picture's longer side.
const FILLED_IN: f64 = 0.02;

/// Pearson's, of two pictures within a mask; 0 where one of them is even.
fn correlation(a: &Image, b: &Image, mask: &Mask) -> f32 {
    let inside = || (0..mask.data.len()).filter(|&i| mask.data[i]);
    let mean = |of: &dyn Fn(usize) -> f32| inside().map(of).sum::<f32>() / inside().count().max(1) as f32;
    let [mean_a, mean_b] = [a, b].map(|image| mean(&|i| image.data[i]));
    let moment = |p: &Image, m: f32, q: &Image, n: f32| mean(&|i| (p.data[i] - m) * (q.data[i] - n));
    let spread = (moment(a, mean_a, a, mean_a) * moment(b, mean_b, b, mean_b)).sqrt();
    if spread > 0.0 { moment(a, mean_a, b, mean_b) / spread } else { 0.0 }
}
