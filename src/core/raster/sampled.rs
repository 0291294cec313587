//! The slow reference: the true union of round cones, counted on a lattice of samples a pixel. For tests and figures.

use super::{piece_indices, usable};
use crate::wire::Stroke;

/// Share of a `samples` x `samples` lattice in each pixel that lies in the union, row by row. Does not share a line of
/// geometry with [`super::ExactRaster`]: each piece is the set of points `p` with `min_t |p - c(t)| - r(t) <= 0`.
pub fn sampled_union(
    width: usize,
    height: usize,
    vertices: &[[f32; 3]],
    strokes: &[Stroke],
    samples: usize,
) -> Vec<f32> {
    let per_pixel = samples * samples;
    let words = per_pixel.div_ceil(64);
    let mut hits = vec![0u64; width * height * words];
    for (a, b) in piece_indices(strokes, vertices.len()) {
        if !usable(vertices[a]) || !usable(vertices[b]) {
            continue;
        }
        let cone = RoundCone::new(vertices[a].map(f64::from), vertices[b].map(f64::from));
        let (columns, rows) = cone.pixels(width, height);
        for y in rows {
            for x in columns.clone() {
                let at = (y * width + x) * words;
                let hits = &mut hits[at..at + words];
                let center = cone.signed_distance(x as f64 + 0.5, y as f64 + 0.5);
                // A signed distance changes by at most half a diagonal from the centre to a corner.
                if center > 0.7072 {
                    continue;
                }
                for i in 0..per_pixel {
                    let at = |i: usize| (i as f64 + 0.5) / samples as f64;
                    let inside = center < -0.7072
                        || cone.signed_distance(x as f64 + at(i % samples), y as f64 + at(i / samples)) <= 0.0;
                    hits[i / 64] |= u64::from(inside) << (i % 64);
                }
            }
        }
    }
    hits.chunks(words).map(|hits| hits.iter().map(|h| h.count_ones()).sum::<u32>() as f32 / per_pixel as f32).collect()
}

struct RoundCone {
    start: [f64; 3],
    end: [f64; 3],
    axis: [f64; 2],
    length: f64,
    sine: f64,
}

impl RoundCone {
    fn new(start: [f64; 3], end: [f64; 3]) -> Self {
        let (start, end) = ([start[0], start[1], start[2].max(0.0)], [end[0], end[1], end[2].max(0.0)]);
        let (dx, dy) = (end[0] - start[0], end[1] - start[1]);
        let length = dx.hypot(dy);
        if length <= (end[2] - start[2]).abs() {
            let larger = if end[2] > start[2] { end } else { start };
            return RoundCone { start: larger, end: larger, axis: [0.0; 2], length: 0.0, sine: 0.0 };
        }
        RoundCone { start, end, axis: [dx / length, dy / length], length, sine: (end[2] - start[2]) / length }
    }

    fn signed_distance(&self, x: f64, y: f64) -> f64 {
        let (wx, wy) = (x - self.start[0], y - self.start[1]);
        let along = wx * self.axis[0] + wy * self.axis[1];
        let across = if self.length > 0.0 { (wy * self.axis[0] - wx * self.axis[1]).abs() } else { wx.hypot(wy) };
        let tilt = self.sine / (1.0 - self.sine * self.sine).sqrt();
        let nearest = (along + across * tilt).clamp(0.0, self.length);
        (along - nearest).hypot(across) - self.start[2] - self.sine * nearest
    }

    fn pixels(&self, width: usize, height: usize) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let range = |axis: usize, count: usize| {
            let low = (self.start[axis] - self.start[2]).min(self.end[axis] - self.end[2]);
            let high = (self.start[axis] + self.start[2]).max(self.end[axis] + self.end[2]);
            (low.floor().max(0.0) as usize).min(count)..(high.ceil().max(0.0) as usize).min(count)
        };
        (range(0, width), range(1, height))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_has_its_area() {
        let disc = [Stroke { start: 0, count: 1, closed: false }];
        let image = sampled_union(32, 32, &[[16.3, 15.8, 7.0]], &disc, 16);
        let area: f32 = image.iter().sum();
        assert!((area - 49.0 * std::f32::consts::PI).abs() < 0.1, "{area}");
    }
}
