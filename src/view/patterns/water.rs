//! Waves and scales: rows that overlap, each painted over the one behind.

use super::canvas::{Canvas, along};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Rows of breaking waves: a back that swells, a crest that curls over, echoes of the back below.
pub(super) fn waves(canvas: &mut Canvas) {
    const ACROSS: usize = 2;
    const ROWS: usize = 4;
    let (width, height) = (1.0 / ACROSS as f64, 0.3);
    // Two rows more than there are, so that the last lies over the first as over any other.
    for row in 0..ROWS + 2 {
        let foot = (row as f64 + 0.9) / ROWS as f64;
        for i in 0..ACROSS {
            let left = (i as f64 + 0.5 * (row % 2) as f64) * width;
            if row >= ROWS + 1 {
                continue;
            }
            wave(canvas, |u, v| DVec2::new(left + u * width, foot - v * height));
        }
    }
    // The first row again, where it lies over the last.
    let foot = 0.9 / ROWS as f64;
    for i in 0..ACROSS {
        let left = i as f64 * width;
        wave(canvas, |u, v| DVec2::new(left + u * width, foot - v * height));
    }
}

/// One wave from its foot (0, 0) to the next one's (1, 0); the crest is about 1 high.
fn wave(canvas: &mut Canvas, place: impl Fn(f64, f64) -> DVec2) {
    const CURL: (f64, f64, f64) = (0.66, 0.68, 0.27);
    let (x, y, radius) = CURL;
    // Up the back, as steep at the crest as the curl begins.
    let back = |s: f64| (x * s, (y + radius) * (0.5 - 0.5 * (PI * s).cos()).powf(1.15));
    let curl = |s: f64| {
        let (angle, r) = (TAU * 1.45 * s, radius * (1.0 - 0.86 * s.powf(0.9)));
        (x + 0.9 * r * angle.sin(), y + r * angle.cos() - 0.02 * s)
    };
    let face = |s: f64| (0.90 - 0.22 * (PI * s).sin() * (1.0 - s) + 0.1 * s * s, 0.56 * (1.0 - s).powf(1.3));
    let at = |(u, v): (f64, f64)| place(u, v);
    let mut body = along(40, |s| at(back(s)));
    body.extend(along(24, |s| at(curl(0.3 * s))));
    body.extend(along(24, |s| at(face(s))));
    body.push(place(1.0, -0.75));
    body.push(place(0.0, -0.75));
    canvas.fill(&body, 0.0);
    // Echoes of the back, drawn together towards the foot of the face.
    for echo in 1..6 {
        let scale = 1.0 - 0.155 * f64::from(echo);
        let shrink = |(u, v): (f64, f64)| {
            place(1.0 + (u - 1.0) * scale, -0.06 + (v + 0.06) * scale * (0.98 - 0.02 * f64::from(echo)))
        };
        let thick = 0.0105 - 0.001 * f64::from(echo);
        let line = along(48, |s| {
            let whole = if s < 0.72 { back(s / 0.72) } else { below_curl((s - 0.72) / 0.28, CURL) };
            (shrink(whole), thick * (0.35 + 1.1 * (PI * s).sin()))
        });
        canvas.stroke(&line, 1.0);
    }
    let face_line = along(24, |s| (at(face(s)), 0.004 + 0.009 * s));
    canvas.stroke(&face_line, 1.0);
    let mut crest = along(40, |s| (at(back(s)), 0.008 + 0.016 * s));
    crest.extend(along(70, |s| (at(curl(s)), 0.024 - 0.014 * s)));
    canvas.stroke(&crest, 1.0);
    // Spray.
    for (u, v, size) in [(0.99, 0.98, 0.010), (1.07, 0.84, 0.0075), (1.05, 1.10, 0.006), (0.92, 1.12, 0.0065)] {
        canvas.dot(place(u, v), size, 1.0);
    }
}

/// From the crest down to the foot of the face, as an echo goes.
fn below_curl(s: f64, (x, y, radius): (f64, f64, f64)) -> (f64, f64) {
    let fall = 0.5 - 0.5 * (PI * s).cos();
    (x + (1.0 - x) * s.powf(0.8), (y + radius) * (1.0 - fall))
}

/// Pointed scales in rows, each over the two behind it, with rays and a heavy rim.
pub(super) fn scales(canvas: &mut Canvas) {
    const ACROSS: usize = 5;
    const ROWS: usize = 8;
    let (width, height) = (1.0 / ACROSS as f64, 1.0 / ROWS as f64);
    // From the bottom up: an upper row covers the one below. The last row again ends the circle.
    for row in (0..ROWS).rev().chain([ROWS - 1]) {
        for i in 0..ACROSS {
            let x = (i as f64 + 0.5 * (row % 2) as f64 + 0.5) * width;
            // The bottom row comes back only with the half that lies over the top row's neighbours.
            scale(canvas, DVec2::new(x, row as f64 * height), width, 2.0 * height);
        }
    }
}

/// Hangs from the middle of its upper edge.
fn scale(canvas: &mut Canvas, top: DVec2, width: f64, height: f64) {
    let edge = |s: f64| {
        // From the left shoulder round the tip to the right one.
        let angle = PI * (s - 0.5);
        let drop = angle.cos().powf(0.62) * (0.86 + 0.14 * (1.0 - (angle / (0.5 * PI)).abs()).powi(3));
        top + DVec2::new(0.5 * width * angle.sin(), height * drop)
    };
    let mut outline = along(48, edge);
    outline.push(top + DVec2::new(0.5 * width, -0.2 * height));
    outline.push(top + DVec2::new(-0.5 * width, -0.2 * height));
    canvas.fill(&outline, 0.0);
    let rim = along(48, |s| (edge(s), 0.006 + 0.016 * (PI * s).sin().powi(2)));
    canvas.stroke(&rim, 1.0);
    let inner = along(40, |s| {
        let s = 0.1 + 0.8 * s;
        (top.lerp(edge(s), 0.8), 0.003 + 0.004 * (PI * s).sin())
    });
    canvas.stroke(&inner, 1.0);
    for ray in [-0.27, -0.14, 0.0, 0.14, 0.27] {
        let tip = top.lerp(edge(0.5 + ray), 0.68 - 0.2 * f64::abs(ray));
        let start = top.lerp(tip, 0.3);
        let line = along(8, |s| (start.lerp(tip, s), 0.0115 * (1.0 - 0.72 * s)));
        canvas.stroke(&line, 1.0);
    }
}
