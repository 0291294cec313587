//! Shades to draw from: tones stretched to what lines can show, edges, highlights.

use super::{LineOptions, around, sides};
use crate::picture::{Ink, Mask};
use crate::view::Image;

/// Shades this close together are one shade.
const LEAST_RANGE: f32 = 0.25;
/// A tone this dark is as dark as ink gets.
const DARKEST: f32 = 0.55;
/// Standard deviation of the blur before edges are looked for, px at 256.
const EDGE_BLUR_PX: f64 = 1.5;
/// Slope of the tone, per pixel at 256, of a clear edge.
const EDGE_SLOPE: f64 = 0.05;
/// Shorter edges are texture, px at 256.
const SHORTEST_EDGE_PX: f64 = 10.0;
/// Smaller highlights are specks, px at 256 across.
const SMALLEST_HIGHLIGHT_PX: f64 = 5.0;

/// Tones of the object blurred and stretched: its lightest shade becomes 0 and its darkest 1, or less where even that is
/// light in itself. An object of one shade keeps it.
pub fn stretched(tone: &Image, solid: &Mask, sigma_px: f64) -> Image {
    let inside: Vec<usize> = (0..tone.data.len()).filter(|&i| solid.data[i]).collect();
    let mut shades: Vec<f32> = inside.iter().map(|&i| tone.data[i]).collect();
    shades.sort_unstable_by(f32::total_cmp);
    let at = |share: f64| shades.get((share * shades.len() as f64) as usize).copied().unwrap_or(0.0);
    let (low, high) = (at(0.02), at(0.98));
    let low = low.min(high - LEAST_RANGE);
    let darkest = (high / DARKEST).min(1.0);
    let mut out = Image::new(tone.width, tone.height);
    inside.iter().for_each(|&i| out.data[i] = darkest * ((tone.data[i] - low) / (high - low)).clamp(0.0, 1.0));
    // Weighted by the mask, so that the ground does not lighten the rim.
    let sigma_px = sigma_px.min(2.0);
    let (blurred, weight) = (out.blurred(sigma_px), solid.to_image().blurred(sigma_px));
    inside.iter().for_each(|&i| out.data[i] = (blurred.data[i] / weight.data[i].max(1e-3)).min(1.0));
    out
}

/// Places that stay blank, and the lines round them.
pub struct Highlights {
    pub inside: Mask,
    pub rim: Mask,
}

/// Where a highlight is clear enough for the gloss asked for: more than 1 - gloss.
pub fn highlights(highlight: &Image, depth: &[f32], scale: f32, options: &LineOptions) -> Highlights {
    let side = highlight.width;
    let outline = options.outline_px as f32 * scale;
    let clear = highlight.blurred(f64::from(scale)).threshold(1.0 - options.gloss as f32);
    let parts = Mask { data: (0..side * side).map(|i| clear.data[i] && depth[i] > 2.0 * outline).collect(), ..clear };
    let labels = parts.components();
    let least = (SMALLEST_HIGHLIGHT_PX * f64::from(scale)).powi(2);
    let large = |label: u32| label > 0 && labels.sizes[label as usize - 1] as f64 >= least;
    let inside = Mask { data: labels.labels.iter().map(|&label| large(label)).collect(), ..parts };
    let rim = (0..side * side).map(|i| inside.data[i] && sides(i, side).any(|n| !inside.data[n])).collect();
    Highlights { rim: Mask { data: rim, ..inside }, inside }
}

/// Strong edges of the tone inside the object, one pixel wide (Canny 1986).
pub fn edges(tone: &Image, depth: &[f32], scale: f32, options: &LineOptions) -> Mask {
    let side = tone.width;
    let mut strong = Mask::new(side, side);
    if options.edges <= 0.0 {
        return strong;
    }
    let tone = tone.blurred(EDGE_BLUR_PX * f64::from(scale));
    let slope = |i: usize| {
        let (x, y) = (i % side, i / side);
        if x == 0 || y == 0 || x + 1 == side || y + 1 == side {
            return [0.0; 2];
        }
        [0.5 * (tone.data[i + 1] - tone.data[i - 1]), 0.5 * (tone.data[i + side] - tone.data[i - side])]
    };
    let steep = Image { data: (0..side * side).map(|i| slope(i)[0].hypot(slope(i)[1])).collect(), ..tone };
    let wanted = (EDGE_SLOPE / options.edges) as f32 / scale;
    // The outline draws what lies close to it.
    let inner = 1.5 * options.outline_px as f32 * scale + 3.0 * EDGE_BLUR_PX as f32 * scale;
    let mut weak = Mask::new(side, side);
    for i in (0..side * side).filter(|&i| depth[i] > inner && steep.data[i] > 0.4 * wanted) {
        let [gx, gy] = slope(i).map(|g| g / steep.data[i]);
        let (x, y) = ((i % side) as f32 + 0.5, (i / side) as f32 + 0.5);
        weak.data[i] = steep.data[i] >= steep.sample(x + gx, y + gy) && steep.data[i] > steep.sample(x - gx, y - gy);
    }
    let parts = weak.components();
    let mut highest = vec![0.0f32; parts.sizes.len()];
    for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
        highest[part as usize - 1] = highest[part as usize - 1].max(steep.data[i]);
    }
    let shortest = SHORTEST_EDGE_PX * f64::from(scale);
    for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
        let part = part as usize - 1;
        strong.data[i] = highest[part] > wanted && parts.sizes[part] as f64 >= shortest;
    }
    strong.thin()
}

/// Half widths that grow by no more than a pixel a pixel: a wide round line must not reach far into what is light. Two
/// sweeps with steps to the eight neighbours (Borgefors 1986).
pub fn held_back(mut half_px: Vec<f32>, side: usize) -> Vec<f32> {
    let order: [Box<dyn Iterator<Item = usize>>; 2] = [Box::new(0..half_px.len()), Box::new((0..half_px.len()).rev())];
    for i in order.into_iter().flatten() {
        half_px[i] = around(i, side).map(|(n, length)| half_px[n] + length).fold(half_px[i], f32::min);
    }
    half_px
}
