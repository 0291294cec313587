//! Looping script.

use super::canvas::{Canvas, along};
use glam::DVec2;
use std::f64::consts::TAU;

/// Lines of loops that rise and fall, written with a broad nib: thick and thin by direction.
pub(super) fn calligraphy(canvas: &mut Canvas) {
    const LINES: usize = 3;
    for line in 0..LINES {
        let (foot, phase) = ((line as f64 + 0.5) / LINES as f64, 2.1 * line as f64);
        // Whole numbers of turns over the tile, so that the line joins itself.
        let loops = [7.0, 8.0, 7.0][line];
        let at = |s: f64| {
            let turn = TAU * loops * s;
            let tall = 0.058 + 0.034 * (TAU * 2.0 * s + phase).sin() + 0.026 * (TAU * 3.0 * s + 2.0 * phase).cos();
            let x = s + (0.036 + 0.3 * tall) * turn.sin() + 0.2 * tall * turn.cos();
            let y = foot + tall * turn.cos() + 0.022 * (TAU * s + phase).sin() - 0.35 * (tall - 0.058);
            DVec2::new(x, y)
        };
        canvas.stroke(&written(1100, 0.036, at), 1.0);
    }
    // Flourishes and points between the lines.
    for (x, y, size, turn) in [
        (0.20, 0.335, 0.75, 0.2),
        (0.70, 0.33, 0.7, -0.1),
        (0.45, 0.67, 0.75, 0.1),
        (0.93, 0.665, 0.7, -0.2),
        (0.12, 0.99, 0.75, 0.15),
        (0.62, 1.0, 0.7, -0.1),
    ] {
        let (centre, turn) = (DVec2::new(x, y), DVec2::from_angle(turn));
        let at = |s: f64| {
            let reach = 0.17 * size * (s - 0.5);
            centre + turn.rotate(DVec2::new(reach, -0.03 * size * (TAU * s).sin()))
        };
        let mut line = written(60, 0.03, at);
        for (i, nib) in line.iter_mut().enumerate() {
            nib.1 *= (std::f64::consts::PI * i as f64 / 60.0).sin().max(0.12);
        }
        canvas.stroke(&line, 1.0);
    }
}

/// What a nib `broad` tiles broad, held at 40°, writes along a curve.
fn written(steps: usize, broad: f64, curve: impl Fn(f64) -> DVec2) -> Vec<(DVec2, f64)> {
    let nib = DVec2::from_angle(-40.0_f64.to_radians());
    along(steps, |s| {
        let way = (curve(s + 1e-4) - curve(s - 1e-4)).normalize_or(DVec2::X);
        (curve(s), 0.006 + broad * nib.perp_dot(way).abs().powf(1.4) * 0.85)
    })
}
