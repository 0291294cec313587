//! Lines that were drawn already, as a draughtsman draws a photograph: taken as they are.

use super::{Layers, LineOptions, Lines};
use crate::picture::Mask;
use crate::view::Image;

/// A drawn line.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Its corners, px of the [`Layers`].
    pub points: Vec<[f32; 2]>,
    /// Its width, px of the layers.
    pub width_px: f32,
    /// Whether it runs where the object ends.
    pub is_outline: bool,
}

/// A corner every so often along a line, px.
const STEP_PX: f32 = 0.5;

impl Lines {
    /// Lines as they were drawn; the first ones say the most. Outlines are the rim where the solid's front meets its back.
    pub fn of_strokes(layers: &Layers, strokes: &[Stroke], options: &LineOptions) -> Lines {
        let mask = &layers.mask;
        let side = mask.width;
        let scale = side as f32 / 256.0;
        let [least, most] = options.width_px.map(|width| 0.5 * width as f32 * scale);
        let empty = || Mask::new(side, side);
        let (mut on, mut rim) = (empty(), empty());
        let mut half_width_px = vec![0.0f32; side * side];
        for stroke in strokes {
            for i in stroke.pixels(side) {
                on.data[i] = true;
                rim.data[i] |= stroke.is_outline;
                half_width_px[i] = half_width_px[i].max((0.5 * stroke.width_px).clamp(least, most));
            }
        }
        // A line may run along the border, half of it outside.
        let everywhere = Image { data: vec![1.0; side * side], ..mask.clone() };
        let shade = layers.tone.clone();
        // What is drawn once is on the front: lines on the back as well would show beside those of the front when turned.
        let back = rim.clone();
        Lines { side, on, rim, back, half_width_px, mask: everywhere, shade }
    }
}

impl Stroke {
    /// The pixels it runs through, of a square picture.
    fn pixels(&self, side: usize) -> Vec<usize> {
        let mut pixels = Vec::new();
        let mut add = |[x, y]: [f32; 2]| {
            if (0.0..side as f32).contains(&x) && (0.0..side as f32).contains(&y) {
                pixels.push(y as usize * side + x as usize);
            }
        };
        for pair in self.points.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / STEP_PX).ceil().max(1.0) as usize;
            for k in 0..steps {
                let t = k as f32 / steps as f32;
                add([0, 1].map(|c: usize| from[c] + t * (to[c] - from[c])));
            }
        }
        if let Some(&last) = self.points.last() {
            add(last);
        }
        pixels.dedup();
        pixels
    }
}
