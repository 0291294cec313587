//! Looping script.

use super::canvas::{Canvas, along};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Lines of loops that rise and fall, written with a broad nib: thick and thin by direction.
pub(super) fn calligraphy(canvas: &mut Canvas) {
    const LINES: usize = 4;
    for line in 0..LINES {
        let (foot, phase) = ((line as f64 + 0.5) / LINES as f64, 2.1 * line as f64);
        // Whole numbers of turns over the tile, so that the line joins itself.
        let loops = [8.0, 9.0, 8.0, 9.0][line];
        let at = |s: f64| {
            let turn = TAU * loops * s;
            let tall = 0.062 + 0.022 * (TAU * 2.0 * s + phase).sin() + 0.017 * (TAU * 3.0 * s + 2.0 * phase).cos();
            let x = s + (0.02 + 0.3 * tall) * turn.sin() - 0.25 * tall * turn.cos();
            let y = foot + tall * turn.cos() + 0.014 * (TAU * s + phase).sin() - 0.4 * (tall - 0.062);
            DVec2::new(x, y)
        };
        canvas.stroke(&written(1200, 0.033, at), 1.0);
    }
    // A flourish where a line leaves room under the next.
    for line in 0..LINES {
        for i in 0..3 {
            let x = (f64::from(i) + 0.37 * line as f64) / 3.0;
            let (centre, turn) =
                (DVec2::new(x, (line as f64 + 1.02) / LINES as f64), DVec2::from_angle(0.3 * f64::from(i) - 0.3));
            let at = |s: f64| centre + turn.rotate(DVec2::new(0.1 * (s - 0.5), -0.016 * (TAU * s).sin()));
            let mut stroke = written(40, 0.022, at);
            for (i, nib) in stroke.iter_mut().enumerate() {
                nib.1 *= (PI * i as f64 / 40.0).sin().max(0.15);
            }
            canvas.stroke(&stroke, 1.0);
        }
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
