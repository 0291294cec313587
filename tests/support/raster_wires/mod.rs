//! Random and adversarial wires for the rasteriser: tests and the bench's sweep share them.

use std::f64::consts::TAU;
use wire4d::rng::Rng;
use wire4d::wire::Stroke;

pub const SIZE: usize = 64;

pub struct Wires {
    pub vertices: Vec<[f32; 3]>,
    pub strokes: Vec<Stroke>,
}

pub const FAMILIES: [&str; 20] = [
    "smooth",
    "zigzag",
    "cusps",
    "tapered",
    "thin",
    "tiny steps, r 5",
    "off image",
    "closed loops",
    "hatching",
    "discs",
    "there and back",
    "there and back, varying r",
    "back, offset 1e-6",
    "back, offset 1e-3",
    "back, offset 0.05",
    "walked twice",
    "tree walk, smoothed",
    "collinear, other vertices",
    "U-turns, tapered",
    "huge radii",
];

fn one(vertices: Vec<[f32; 3]>, closed: bool) -> Wires {
    let count = vertices.len();
    Wires { vertices, strokes: vec![Stroke { start: 0, count, closed }] }
}

/// A smooth random walk: position by integrating a slowly turning direction.
fn walk(rng: &mut Rng, count: usize, step: f64, turn: f64, radius: impl Fn(&mut Rng, usize) -> f64) -> Vec<[f32; 3]> {
    let size = SIZE as f64;
    let (mut x, mut y) = (rng.range(0.2, 0.8) * size, rng.range(0.2, 0.8) * size);
    let (mut angle, mut bend) = (rng.range(0.0, TAU), 0.0);
    (0..count)
        .map(|i| {
            let r = radius(rng, i);
            let vertex = [x as f32, y as f32, r as f32];
            bend = 0.8 * bend + turn * rng.range(-1.0, 1.0);
            // Turn back towards the middle near the border.
            let (to_x, to_y) = (size / 2.0 - x, size / 2.0 - y);
            if to_x.hypot(to_y) > 0.42 * size && (angle.cos() * to_x + angle.sin() * to_y) < 0.0 {
                bend += 0.3;
            }
            angle += bend;
            x += step * angle.cos();
            y += step * angle.sin();
            vertex
        })
        .collect()
}

fn there_and_back(path: Vec<[f32; 3]>, offset: f32, rng: &mut Rng) -> Vec<[f32; 3]> {
    let mut all = path.clone();
    for v in path.iter().rev().skip(1) {
        let mut shift = || offset * rng.range(-1.0, 1.0) as f32;
        all.push([v[0] + shift(), v[1] + shift(), v[2]]);
    }
    all
}

/// Wires number `seed` of a family, about [`SIZE`] pixels wide and high.
pub fn wires(family: &str, seed: u64) -> Wires {
    let rng = &mut Rng::new(seed, 77);
    let size = SIZE as f64;
    let base = rng.range(0.3, 3.0);
    let steady = move |_: &mut Rng, _: usize| base;
    let varying = move |_: &mut Rng, i: usize| base * (1.0 + 0.6 * (i as f64 * 0.7).sin());
    let point = |rng: &mut Rng, low: f64, high: f64, r: f64| {
        [rng.range(low, high) as f32, rng.range(low, high) as f32, r as f32]
    };
    match family {
        "smooth" => one(walk(rng, 60, 2.5, 0.15, varying), false),
        "zigzag" => one((0..25).map(|_| point(rng, 2.0, size - 2.0, base)).collect(), false),
        "cusps" => {
            // A cubic with a cusp, finely cut, with a big radius.
            let c: Vec<[f32; 3]> = (0..4).map(|_| point(rng, 5.0, size - 5.0, 0.0)).collect();
            let r = rng.range(0.5, 6.0) as f32;
            let at = |t: f32| {
                let s = 1.0 - t;
                let w = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                // Crossed inner points bring the turn near a cusp.
                let q = [c[0], c[3], c[0], c[3]];
                let blend = |i: usize| w.iter().enumerate().map(|(j, w)| w * (0.9 * q[j][i] + 0.1 * c[j][i])).sum();
                [blend(0), blend(1), r]
            };
            one((0..=40).map(|i| at(i as f32 / 40.0)).collect(), false)
        }
        "tapered" => {
            let r = |rng: &mut Rng, _: usize| rng.range(0.0, 5.0);
            one(walk(rng, 25, 6.0, 0.4, r), false)
        }
        "thin" => one(walk(rng, 60, 3.0, 0.3, |_, _| 0.05), false),
        "tiny steps, r 5" => one(walk(rng, 60, 0.4, 0.1, |_, _| 5.0), false),
        "off image" => one((0..20).map(|_| point(rng, -size, 2.0 * size, base)).collect(), false),
        "closed loops" => {
            let mut vertices = Vec::new();
            let mut strokes = Vec::new();
            for _ in 0..4 {
                let start = vertices.len();
                let (cx, cy) = (rng.range(10.0, size - 10.0), rng.range(10.0, size - 10.0));
                let (rx, ry, n) = (rng.range(1.0, 20.0), rng.range(0.3, 20.0), 3 + rng.below(30));
                let r = rng.range(0.1, 3.0) as f32;
                for i in 0..n {
                    let a = i as f64 * TAU / n as f64;
                    vertices.push([(cx + rx * a.cos()) as f32, (cy + ry * a.sin()) as f32, r]);
                }
                strokes.push(Stroke { start, count: n, closed: true });
            }
            Wires { vertices, strokes }
        }
        "hatching" => {
            let gap = rng.range(0.5, 3.0) as f32;
            let vertices = (0..40).map(|i| {
                let x = if (i / 2) % 2 == i % 2 { 8.0 } else { 56.0 };
                [x, 6.0 + gap * (i / 2) as f32, base as f32 * 0.5]
            });
            one(vertices.collect(), false)
        }
        "discs" => {
            let vertices: Vec<_> = (0..12)
                .map(|_| {
                    let r = rng.range(0.0, 8.0);
                    point(rng, -4.0, size + 4.0, r)
                })
                .collect();
            let strokes = (0..12).map(|start| Stroke { start, count: 1, closed: start % 2 == 0 }).collect();
            Wires { vertices, strokes }
        }
        "there and back" => one(there_and_back(walk(rng, 40, 2.5, 0.25, steady), 0.0, rng), false),
        "there and back, varying r" => one(there_and_back(walk(rng, 40, 2.5, 0.25, varying), 0.0, rng), false),
        "back, offset 1e-6" => one(there_and_back(walk(rng, 40, 2.5, 0.25, varying), 1e-6, rng), false),
        "back, offset 1e-3" => one(there_and_back(walk(rng, 40, 2.5, 0.25, varying), 1e-3, rng), false),
        "back, offset 0.05" => one(there_and_back(walk(rng, 40, 2.5, 0.25, varying), 0.05, rng), false),
        "walked twice" => {
            let back = there_and_back(walk(rng, 30, 2.0, 0.3, varying), 0.0, rng);
            let again = back.iter().skip(1).copied().collect::<Vec<_>>();
            one(back.into_iter().chain(again).collect(), false)
        }
        "tree walk, smoothed" => {
            // A trunk with branches walked there and back, then a moving average, as a fit's first wire.
            let mut path = Vec::new();
            for v in walk(rng, 20, 2.5, 0.2, steady) {
                path.push(v);
                if rng.below(4) == 0 {
                    let (dx, dy) = (rng.range(-2.0, 2.0) as f32, rng.range(-2.0, 2.0) as f32);
                    let branch: Vec<_> = (1..8).map(|i| [v[0] + dx * i as f32, v[1] + dy * i as f32, v[2]]).collect();
                    path.extend(branch.iter());
                    path.extend(branch.iter().rev().skip(1));
                    path.push(v);
                }
            }
            let smooth = |w: &[[f32; 3]]| std::array::from_fn(|c| (w[0][c] + 2.0 * w[1][c] + w[2][c]) / 4.0);
            one(path.windows(3).map(smooth).collect(), false)
        }
        "collinear, other vertices" => {
            let (a, b) = (point(rng, 8.0, size - 8.0, base), point(rng, 8.0, size - 8.0, base));
            let at = |t: f32| std::array::from_fn(|c| a[c] + t * (b[c] - a[c]));
            let mut ts: Vec<f32> = (0..=12).map(|i| i as f32 / 12.0).collect();
            ts.extend((0..=9).rev().map(|i| (i as f32 + rng.unit() as f32 * 0.5) / 10.0));
            one(ts.into_iter().map(at).collect(), false)
        }
        "U-turns, tapered" => {
            let vertices = (0..24).map(|i| {
                let x = if i % 2 == 0 { rng.range(5.0, 20.0) } else { rng.range(40.0, 60.0) };
                [x as f32, (32.0 + rng.range(-3.0, 3.0)) as f32, rng.range(0.1, 4.0) as f32]
            });
            one(vertices.collect(), false)
        }
        "huge radii" => {
            let r = |rng: &mut Rng| 10f64.powf(rng.range(0.5, 3.0));
            let vertices = (0..4).map(|_| {
                let r = r(rng);
                let angle = rng.range(0.0, TAU);
                let far = r + rng.range(-10.0, 25.0);
                [(32.0 + far * angle.cos()) as f32, (32.0 + far * angle.sin()) as f32, r as f32]
            });
            let strokes =
                vec![Stroke { start: 0, count: 2, closed: false }, Stroke { start: 2, count: 2, closed: false }];
            Wires { vertices: vertices.collect(), strokes }
        }
        _ => unreachable!("no family {family}"),
    }
}
