//! What strokes say: the pixels under them, and like ones that hang together with those.

use super::Stroke;
use super::level::Level;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How far a stroke reaches through even colours, in units of colour, and what a pixel of the way costs at least.
const REACH: f32 = 14.0;
const A_PIXEL: f32 = 0.12;
/// Steps between pixels that are noise: this many times the usual step.
const NOISE: f32 = 1.6;

/// The pixels under strokes, for a picture whose pixel (0, 0) begins at `corner` and is `1 / scale` px of theirs wide.
pub fn under(strokes: &[Stroke], width: usize, height: usize, corner: [f64; 2], scale: f64) -> Vec<bool> {
    let mut on = vec![false; width * height];
    for stroke in strokes {
        // The least that meets a pixel, wherever it is.
        let radius = (f64::from(stroke.radius_px) * scale).max(0.75);
        let points: Vec<[f64; 2]> =
            stroke.points.iter().map(|p| [0, 1].map(|k| (f64::from(p[k]) - corner[k]) * scale)).collect();
        for k in 0..points.len() {
            let (a, b) = (points[k], points[(k + 1).min(points.len() - 1)]);
            let range = |c: usize, side: usize| {
                let low = (a[c].min(b[c]) - radius).floor().clamp(0.0, side as f64);
                let high = (a[c].max(b[c]) + radius).ceil().clamp(0.0, side as f64);
                low as usize..high as usize
            };
            let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
            let length2 = (dx * dx + dy * dy).max(1e-12);
            for y in range(1, height) {
                for x in range(0, width) {
                    let (px, py) = (x as f64 + 0.5 - a[0], y as f64 + 0.5 - a[1]);
                    let t = ((px * dx + py * dy) / length2).clamp(0.0, 1.0);
                    on[y * width + x] |= (px - t * dx).hypot(py - t * dy) <= radius;
                }
            }
        }
    }
    on
}

/// How near each pixel is to the marked ones along a way of like colours (Bai and Sapiro 2007): 1 there, 0 out of reach.
pub fn reach(level: &Level, marked: &[bool]) -> Vec<f32> {
    let (w, h) = (level.width, level.height);
    let noise = NOISE * level.usual_step();
    let mut far = vec![f32::INFINITY; w * h];
    let mut open = BinaryHeap::new();
    for i in (0..w * h).filter(|&i| marked[i]) {
        far[i] = 0.0;
        open.push((Reverse(0u32), i as u32));
    }
    // Distances above 0 have the order of their bits.
    while let Some((Reverse(bits), i)) = open.pop() {
        let (distance, i) = (f32::from_bits(bits), i as usize);
        if distance > far[i] {
            continue;
        }
        let (x, y) = (i % w, i / w);
        let mut visit = |n: usize| {
            let step: f32 = (0..3).map(|c| (level.lab[i][c] - level.lab[n][c]).powi(2)).sum::<f32>().sqrt();
            let next = distance + A_PIXEL + (step - noise).max(0.0);
            if next < far[n].min(REACH) {
                far[n] = next;
                open.push((Reverse(next.to_bits()), n as u32));
            }
        };
        if x > 0 {
            visit(i - 1);
        }
        if x + 1 < w {
            visit(i + 1);
        }
        if y > 0 {
            visit(i - w);
        }
        if y + 1 < h {
            visit(i + w);
        }
    }
    far.iter().map(|&distance| (1.0 - distance / REACH).max(0.0)).collect()
}
