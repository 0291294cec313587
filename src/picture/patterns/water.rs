//! Waves and scales: rows that overlap, each painted over the one behind.

use super::canvas::{Canvas, along};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Rings of swelling line in rows, as on old Japanese cloth (seigaiha), on a sea that heaves.
pub(super) fn waves(canvas: &mut Canvas) {
    const ACROSS: i32 = 3;
    const ROWS: i32 = 6;
    const RADIUS: f64 = 0.5 / ACROSS as f64;
    canvas.cut();
    // The sea: what is straight is bent, and comes back after a tile.
    let heave = |p: DVec2| {
        let (u, v) = (TAU * p.x, TAU * p.y);
        p + DVec2::new(
            0.022 * (v + (u + 0.8).sin()).sin(),
            0.042 * (u + 0.7 * v.cos()).sin() + 0.014 * (2.0 * u + v).sin(),
        )
    };
    // From far to near; rows beyond both borders reach in.
    for row in -2..ROWS + 2 {
        for i in -1..=ACROSS {
            let shift = if row % 2 == 0 { 0.0 } else { 0.5 };
            let centre = DVec2::new((f64::from(i) + shift) / f64::from(ACROSS), f64::from(row) / f64::from(ROWS));
            let at = |angle: f64, share: f64| heave(centre + RADIUS * share * DVec2::new(angle.sin(), -angle.cos()));
            canvas.fill(&along(32, |s| at(TAU * s, 1.04)), 0.0);
            for (share, width) in [(0.985, 0.017), (0.79, 0.0115), (0.62, 0.0135), (0.46, 0.009), (0.31, 0.0105)] {
                // Heavy where the wave rises, light where it falls.
                let ring = along(56, |s| {
                    let angle = TAU * (s - 0.5);
                    (at(angle, share), width * (1.0 + 0.55 * (angle + 0.9).cos()))
                });
                canvas.stroke(&ring, 1.0);
            }
            canvas.fill(&along(24, |s| at(TAU * s, 0.17)), 1.0);
        }
    }
}

/// Pointed scales in rows, each over the two behind it, with rays and a heavy rim.
pub(super) fn scales(canvas: &mut Canvas) {
    const ACROSS: i32 = 5;
    const ROWS: i32 = 8;
    let (width, height) = (1.0 / f64::from(ACROSS), 1.0 / f64::from(ROWS));
    canvas.cut();
    // From the bottom up: an upper row lies over the one below. Rows beyond both borders reach in.
    for row in (-3..ROWS + 2).rev() {
        for i in -1..=ACROSS {
            let x = (f64::from(i) + if row % 2 == 0 { 0.5 } else { 1.0 }) * width;
            scale(canvas, DVec2::new(x, f64::from(row) * height), width, 2.0 * height);
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
