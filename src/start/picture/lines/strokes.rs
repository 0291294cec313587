//! Lines that were drawn already, as a draughtsman draws a photograph: taken as they are.

use super::{LineOptions, Lines};
use crate::picture::Mask;
use crate::view::Image;

/// A drawn line.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Its corners, px of the object's picture.
    pub points: Vec<[f32; 2]>,
    /// Its width, px likewise.
    pub width_px: f32,
    /// Whether it runs where the object ends.
    pub is_outline: bool,
}

/// A corner every so often along a line, px.
const STEP_PX: f32 = 0.5;
/// A line that ends this near to the rim goes on to it, px at 256.
const TO_RIM_PX: f32 = 7.0;
/// A line from rim to rim goes on round the back as a ring if it is this long, and its middle this far from the rim, px at
/// 256; others would lie beside the rim there.
const SHORTEST_RING_PX: f32 = 50.0;
const RING_FROM_RIM_PX: f32 = 10.0;

impl Lines {
    /// Lines as they were drawn; the first ones say the most. Outlines are the rim where the solid's front meets its back.
    /// `mask` and `tone` as in [`super::Layers`].
    pub fn of_strokes(mask: &Image, tone: &Image, strokes: &[Stroke], options: &LineOptions) -> Lines {
        let side = mask.width;
        let scale = side as f32 / 256.0;
        let [least, most] = options.width_px.map(|width| 0.5 * width as f32 * scale);
        let empty = || Mask::new(side, side);
        // A line may run along the border, half of it outside.
        let everywhere = Image { data: vec![1.0; side * side], ..mask.clone() };
        let mut lines = Lines {
            side,
            on: empty(),
            rim: empty(),
            back: empty(),
            sections: empty(),
            half_width_px: vec![0.0; side * side],
            mask: everywhere,
            object: mask.clone(),
            shade: tone.clone(),
        };
        let add = |lines: &mut Lines, points: &[[f32; 2]], width_px: f32| {
            let pixels = pixels(points, side);
            for &i in &pixels {
                lines.on.data[i] = true;
                lines.half_width_px[i] = lines.half_width_px[i].max((0.5 * width_px).clamp(least, most));
            }
            pixels
        };
        for stroke in strokes.iter().filter(|stroke| stroke.is_outline) {
            for i in add(&mut lines, &stroke.points, stroke.width_px) {
                lines.rim.data[i] = true;
            }
        }
        // What is drawn once is on the front: lines on the back as well would show beside those of the front when turned.
        // Only what leads from rim to rim is a ring.
        lines.back = lines.rim.clone();
        let to_rim = lines.rim.distance_px().data;
        for stroke in strokes.iter().filter(|stroke| !stroke.is_outline) {
            let (points, is_ring) = lines.led_to_rim(&stroke.points, &to_rim, scale);
            for i in add(&mut lines, &points, stroke.width_px) {
                lines.back.data[i] |= is_ring;
            }
        }
        lines
    }

    /// A line with its ends led to the rim where they are near it, and whether it is one from rim to rim.
    fn led_to_rim(&self, points: &[[f32; 2]], to_rim: &[f32], scale: f32) -> (Vec<[f32; 2]>, bool) {
        let far = |[x, y]: [f32; 2]| {
            let within = |v: f32| v.clamp(0.0, self.side as f32 - 1.0) as usize;
            to_rim[within(y) * self.side + within(x)] / scale
        };
        let mut points = points.to_vec();
        let mut reached = 0;
        for _ in 0..2 {
            points.reverse();
            let Some(&end) = points.last() else { break };
            if far(end) <= TO_RIM_PX {
                reached += 1;
                points.extend(self.nearest_rim(end.map(f64::from)).map(|place| place.map(|c| c as f32)));
            }
        }
        let length: f32 = points.windows(2).map(|p| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1])).sum();
        let farthest = pixels(&points, self.side).into_iter().map(|i| to_rim[i] / scale).fold(0.0, f32::max);
        (points, reached == 2 && length > SHORTEST_RING_PX * scale && farthest > RING_FROM_RIM_PX)
    }

    /// The middle of the rim's pixel that is nearest to a place.
    pub(super) fn nearest_rim(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let centre = |i: usize| [(i % self.side) as f64 + 0.5, (i / self.side) as f64 + 0.5];
        let far = |i: usize| (centre(i)[0] - x).hypot(centre(i)[1] - y);
        let rim = (0..self.rim.data.len()).filter(|&i| self.rim.data[i]);
        rim.min_by(|&a, &b| far(a).total_cmp(&far(b))).map(centre)
    }
}

/// The pixels of a square picture that a line runs through.
pub(super) fn pixels(points: &[[f32; 2]], side: usize) -> Vec<usize> {
    let mut pixels = Vec::new();
    let mut add = |[x, y]: [f32; 2]| {
        if (0.0..side as f32).contains(&x) && (0.0..side as f32).contains(&y) {
            pixels.push(y as usize * side + x as usize);
        }
    };
    for pair in points.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / STEP_PX).ceil().max(1.0) as usize;
        for k in 0..steps {
            let t = k as f32 / steps as f32;
            add([0, 1].map(|c: usize| from[c] + t * (to[c] - from[c])));
        }
    }
    if let Some(&last) = points.last() {
        add(last);
    }
    pixels.dedup();
    pixels
}
