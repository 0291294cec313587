//! Ten pictures by formula, of the kinds people give to `wire4d stroke`.
//!
//! Each is a function of a place, both coordinates from -1 to 1 and y up, to a colour: red, green, blue and how much there
//! is of it, 0 to 1.

use image::{Rgba, RgbaImage};

type Colour = [f64; 4];

/// A picture's name and its formula.
pub type Picture = (&'static str, fn(f64, f64) -> Colour);

/// Shaded solids, flat shapes, line art, a letter, a face; on plain, sloping, busy, dark and no ground.
pub const PICTURES: [Picture; 10] = [
    ("ball", ball),
    ("cat", cat),
    ("face", face),
    ("fish", fish),
    ("glyph", glyph),
    ("mushroom", mushroom),
    ("pear", pear),
    ("star", star),
    ("torus", torus),
    ("vase", vase),
];

/// Side of a picture, px.
const SIDE_PX: u32 = 192;
/// Places a pixel is averaged from, along each side.
const SAMPLES: u32 = 4;

/// The picture, edges soft.
pub fn drawn(formula: fn(f64, f64) -> Colour) -> RgbaImage {
    let place =
        |p: u32, k: u32| 2.0 * (f64::from(p) + (f64::from(k) + 0.5) / f64::from(SAMPLES)) / f64::from(SIDE_PX) - 1.0;
    RgbaImage::from_fn(SIDE_PX, SIDE_PX, |x, y| {
        let mut sum = [0.0; 4];
        for k in 0..SAMPLES * SAMPLES {
            let [r, g, b, a] = formula(place(x, k % SAMPLES), -place(y, k / SAMPLES));
            sum = [sum[0] + a * r, sum[1] + a * g, sum[2] + a * b, sum[3] + a];
        }
        let byte = |value: f64| (255.0 * value).round().clamp(0.0, 255.0) as u8;
        let colour = |c: usize| byte(sum[c] / sum[3].max(1e-9));
        Rgba([colour(0), colour(1), colour(2), byte(sum[3] / f64::from(SAMPLES * SAMPLES))])
    })
}

const BLACK: [f64; 3] = [0.03, 0.03, 0.05];

fn solid([r, g, b]: [f64; 3]) -> Colour {
    [r, g, b, 1.0]
}

/// Light from the upper left on a dull surface, and a highlight where it shines (Phong 1975).
fn lit(colour: [f64; 3], [x, y, z]: [f64; 3], shine: f64) -> Colour {
    let length = (x * x + y * y + z * z).sqrt().max(1e-9);
    let [x, y, z] = [x / length, y / length, z / length];
    let light = (-0.5 * x + 0.55 * y + 0.67 * z).max(0.0);
    let mirrored = (2.0 * z * light - 0.67).max(0.0).powi(40);
    solid(colour.map(|c| c * (0.16 + 0.84 * light) + shine * mirrored))
}

fn disc(x: f64, y: f64, [u, v]: [f64; 2], radius: f64) -> bool {
    (x - u).hypot(y - v) < radius
}

/// Whether a place lies on a round stroke from a to b.
fn stroke(x: f64, y: f64, [ax, ay]: [f64; 2], [bx, by]: [f64; 2], width: f64) -> bool {
    let (dx, dy) = (bx - ax, by - ay);
    let t = (((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy).max(1e-12)).clamp(0.0, 1.0);
    disc(x, y, [ax + t * dx, ay + t * dy], 0.5 * width)
}

/// Whether a place lies on a round stroke along a circle, from one angle to another (degrees, from the right, upwards).
fn arc(x: f64, y: f64, [u, v]: [f64; 2], radius: f64, [from, to]: [f64; 2], width: f64) -> bool {
    let middle = 0.5 * (from + to);
    let turned = ((y - v).atan2(x - u).to_degrees() - middle + 540.0).rem_euclid(360.0) - 180.0;
    let angle = (middle + turned.clamp(from - middle, to - middle)).to_radians();
    disc(x, y, [u + radius * angle.cos(), v + radius * angle.sin()], 0.5 * width)
}

/// Whether a place lies in a closed polygon (even-odd).
fn polygon(x: f64, y: f64, corners: &[[f64; 2]]) -> bool {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges.filter(|([ax, ay], [bx, by])| (*ay > y) != (*by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)).count() % 2
        == 1
}

/// The normal of a solid of revolution about the y axis, and `None` beside it.
fn turned(x: f64, y: f64, radius: impl Fn(f64) -> f64) -> Option<[f64; 3]> {
    let r = radius(y);
    let slope = (radius(y + 1e-3) - radius(y - 1e-3)) / 2e-3;
    (x.abs() < r).then(|| [x, -slope * r, (r * r - x * x).sqrt()])
}

fn ball(x: f64, y: f64) -> Colour {
    match 0.49 - x * x - y * y {
        square if square > 0.0 => lit([0.86, 0.27, 0.22], [x, y, square.sqrt()], 0.8),
        _ => solid([0.97; 3]),
    }
}

fn cat(x: f64, y: f64) -> Colour {
    let ears = [[-0.32, 0.75], [-0.1, 0.55], [0.1, 0.55], [0.32, 0.75], [0.33, 0.3], [-0.33, 0.3]];
    let tail = arc(x, y, [0.42, -0.36], 0.33, [-95.0, 100.0], 0.17);
    let cat = disc(x, y, [0.0, 0.27], 0.34) || polygon(x, y, &ears) || disc(x, y, [0.0, -0.42], 0.45) || tail;
    solid(if cat { [0.1; 3] } else { [0.93, 0.9, 0.85] })
}

fn face(x: f64, y: f64) -> Colour {
    let eye = |u: f64| ((x - u) / 0.09).hypot((y - 0.22) / 0.16) < 1.0;
    let mouth = arc(x, y, [0.0, -0.1], 0.45, [200.0, 340.0], 0.1);
    match x.hypot(y) {
        _ if eye(-0.28) || eye(0.28) || mouth => solid([0.27, 0.13, 0.05]),
        r if r < 0.8 => solid([1.0, 0.82 - 0.12 * r * r, 0.2]),
        _ => solid([1.0; 3]),
    }
}

fn fish(x: f64, y: f64) -> Colour {
    let width = 0.045;
    // Two arcs of a circle make the body.
    let body =
        arc(x, y, [-0.1, -0.45], 0.8, [41.0, 139.0], width) || arc(x, y, [-0.1, 0.6], 0.8, [-139.0, -41.0], width);
    let tail = [[0.5, 0.075], [0.85, 0.35], [0.75, 0.075], [0.85, -0.2]];
    let tail = (0..4).any(|k| stroke(x, y, tail[k], tail[(k + 1) % 4], width));
    let fin = stroke(x, y, [-0.1, 0.35], [0.1, 0.58], width) || stroke(x, y, [0.1, 0.58], [0.2, 0.29], width);
    let eye = arc(x, y, [-0.46, 0.14], 0.055, [0.0, 360.0], 0.035);
    let gill = arc(x, y, [-0.45, 0.05], 0.3, [-40.0, 40.0], width);
    let scales = [0.08, 0.26].iter().any(|&u| arc(x, y, [u, 0.05], 0.12, [-60.0, 60.0], width));
    let mouth = stroke(x, y, [-0.68, 0.04], [-0.55, 0.0], width);
    solid(if body || tail || fin || eye || gill || scales || mouth { BLACK } else { [1.0; 3] })
}

fn glyph(x: f64, y: f64) -> Colour {
    let width = 0.2;
    let stem = stroke(x, y, [-0.35, 0.7], [-0.35, -0.7], width);
    let bars = stroke(x, y, [-0.35, 0.7], [0.1, 0.7], width) || stroke(x, y, [-0.35, 0.0], [0.1, 0.0], width);
    let bowl = arc(x, y, [0.1, 0.35], 0.35, [-90.0, 90.0], width);
    let leg = stroke(x, y, [0.05, 0.0], [0.43, -0.7], width);
    solid(if stem || bars || bowl || leg { [0.0; 3] } else { [1.0; 3] })
}

/// A number from 0 to 1 that looks random.
fn noise(k: u32) -> f64 {
    let mut bits = k.wrapping_mul(0x9e37_79b9) ^ 0x85eb_ca6b;
    for _ in 0..3 {
        bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    }
    f64::from(bits ^ (bits >> 16)) / f64::from(u32::MAX)
}

fn mushroom(x: f64, y: f64) -> Colour {
    let cap = 1.0 - (x / 0.72).powi(2) - ((y + 0.05) / 0.62).powi(2);
    if y > -0.05 && cap > 0.0 {
        let normal = [x / 0.72, (y + 0.05) / 0.62, cap.sqrt()];
        let spots = [[-0.3, 0.2, 0.1], [0.16, 0.33, 0.12], [0.4, 0.1, 0.09], [-0.05, 0.06, 0.07], [-0.14, 0.46, 0.06]];
        let spot = spots.iter().any(|&[u, v, radius]| disc(x, y, [u, v], radius));
        return lit(if spot { [1.0, 0.98, 0.9] } else { [0.85, 0.1, 0.08] }, normal, 0.0);
    }
    let stalk = |y: f64| if (-0.75..=-0.05).contains(&y) { 0.19 + 0.08 * (-(y + 0.75) / 0.12).exp() } else { 0.0 };
    if let Some(normal) = turned(x, y, stalk) {
        return lit([0.95, 0.9, 0.8], normal, 0.0);
    }
    // Leaves on leaves.
    let leaf = (0..120).rev().find(|&k| {
        let at = |n: u32| 2.4 * noise(7 * k + n) - 1.2;
        disc(x, y, [at(0), at(1)], 0.04 + 0.07 * noise(7 * k + 2))
    });
    let shade = |n: u32| leaf.map_or(0.0, |k| noise(7 * k + n) - 0.5);
    solid([0.42 + 0.07 * shade(3), 0.56 + 0.09 * shade(4), 0.38 + 0.07 * shade(5)])
}

fn pear(x: f64, y: f64) -> Colour {
    if stroke(x, y, [0.0, 0.55], [0.1, 0.83], 0.07) && y > 0.5 {
        return solid([0.35, 0.22, 0.12]);
    }
    // The body is the smooth union of a large and a small ball.
    let profile = |y: f64| {
        let square = |middle: f64, radius: f64| (radius * radius - (y - middle).powi(2)) / radius;
        let blend = |a: f64, b: f64| 0.07 * ((a / 0.07).exp() + (b / 0.07).exp()).ln();
        let body = blend(square(-0.3, 0.47), square(0.27, 0.26));
        (body * 0.47).max(0.0).sqrt()
    };
    match turned(x, y, profile) {
        Some(normal) => lit([0.72, 0.76, 0.24], normal, 0.25),
        None => solid([0.58 - 0.13 * x + 0.05 * y, 0.68 - 0.05 * x + 0.08 * y, 0.82 + 0.05 * x - 0.04 * y]),
    }
}

fn star(x: f64, y: f64) -> Colour {
    let corner = |k: usize| {
        let (radius, angle) = (if k.is_multiple_of(2) { 0.85 } else { 0.36 }, (90.0 + 36.0 * k as f64).to_radians());
        [radius * angle.cos(), radius * angle.sin() - 0.05]
    };
    let corners: [[f64; 2]; 10] = std::array::from_fn(corner);
    solid(if polygon(x, y, &corners) { [0.96, 0.85, 0.3] } else { [0.08, 0.09, 0.25] })
}

fn torus(x: f64, y: f64) -> Colour {
    let (ring, tube) = (0.55, 0.25);
    let r = x.hypot(y);
    let square = tube * tube - (r - ring).powi(2);
    if square <= 0.0 {
        return [0.0; 4];
    }
    lit([0.4, 0.62, 0.95], [(r - ring) * x / r, (r - ring) * y / r, square.sqrt()], 0.0)
}

fn vase(x: f64, y: f64) -> Colour {
    let profile = |y: f64| match y {
        y if !(-0.8..0.8).contains(&y) => 0.0,
        y => 0.3 + 0.22 * (-((y + 0.15) / 0.3).powi(2)).exp() - 0.12 * (-((y - 0.45) / 0.2).powi(2)).exp(),
    };
    let band = (y - 0.1).abs() < 0.06 || (y + 0.42).abs() < 0.06;
    match turned(x, y, profile) {
        Some(normal) => lit(if band { [0.15, 0.22, 0.6] } else { [0.85, 0.82, 0.75] }, normal, 0.0),
        None => solid([0.9, 0.93, 0.9]),
    }
}
