//! A wire in its room as the stage shows it, drawn without a graphics card: three walls, on each the shadow that the wire
//! casts along that axis, and the wire as round, polished copper. What the stage's shaders do
//! (www/packages/wire-sculpture/src/scene/shaders.ts) is done here for each pixel, in the same colours and under the same lamps.

use super::vector::{Vec3, along, dot, minus, mix, plus, smoothstep, times, unit};
use crate::tube::chords;
use image::{RgbImage, imageops};
use wire4d_core::wire::Wire;

/// Drawn so many times larger, then averaged down.
const OVERSAMPLING: usize = 2;
/// Balls are no farther apart than this share of their radius, and no strand looks thinner than this radius, px drawn.
const STEP: f64 = 0.12;
const THINNEST_PX: f64 = 1.1;
/// The room: distance of its walls from the middle, half of the square that a shadow fills at least, and what the picture shows of it.
const WALL_AWAY: f64 = 1.22;
const SHADOW_EXTENT: f64 = 1.15;
const SHADOW_HALF: f64 = 0.8;
const ROOM_SHARE: f64 = 0.98;
const SHADOW_PX: usize = 512;
/// The camera's place, and its lens.
const AZIMUTH_RAD: f64 = 0.7;
const ELEVATION_RAD: f64 = 0.4;
const FOV_Y_RAD: f64 = 0.46;
/// What is right, up and towards the room on the back wall, the side wall and the floor, and how bright each is.
const WALLS: [([Vec3; 3], f64); 3] = [
    ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], 1.0),
    ([[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]], 0.975),
    ([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]], 0.985),
];

/// The colours of a room, as bytes.
pub struct Paint {
    metal: [u8; 3],
    sky: [u8; 3],
    ground: [u8; 3],
    wall: [u8; 3],
    lit: [u8; 3],
    shadow: [u8; 3],
}

/// The stage's own by day and by night (www/packages/wire-sculpture/src/scene/tints.ts).
pub const LIGHT: Paint = Paint {
    metal: [0xbf, 0x76, 0x40],
    sky: [0xef, 0xeb, 0xe4],
    ground: [0x7c, 0x65, 0x52],
    wall: [0xf6, 0xf3, 0xee],
    lit: [0xff, 0xfe, 0xfb],
    shadow: [0x3d, 0x34, 0x2d],
};
pub const DARK: Paint = Paint {
    metal: [0xd1, 0x8a, 0x50],
    sky: [0xa3, 0x9c, 0x92],
    ground: [0x2c, 0x22, 0x1a],
    wall: [0x30, 0x2d, 0x29],
    lit: [0x5a, 0x53, 0x4a],
    shadow: [0x0b, 0x0a, 0x09],
};

const GLOSS: f64 = 0.8;

/// The wire in its room, `size` pixels wide and high.
pub fn draw(wire: &Wire, size: [usize; 2], paint: &Paint) -> RgbImage {
    let [width, height] = size.map(|side| side * OVERSAMPLING);
    let points = samples(wire);
    let reach = points.iter().flat_map(|p| p[..3].iter().map(|x| x.abs() + p[3])).fold(SHADOW_HALF, f64::max);
    let camera = Camera::new([width, height], reach);
    let shadows = WALLS.each_ref().map(|(axes, _)| shadow(&points, axes));
    let seen = camera.normals(&points);
    let colours = Colours::of(paint);
    let large = RgbImage::from_fn(width as u32, height as u32, |x, y| {
        let (x, y) = (x as usize, y as usize);
        let place = &seen[y * width + x];
        let colour = match place.depth {
            depth if depth.is_finite() => {
                let ray = camera.ray(x, y);
                colours.metal(
                    plus(camera.eye, times(ray, depth / -dot(ray, camera.back))),
                    place.normal,
                    times(ray, -1.0),
                )
            }
            _ => colours.walls(&camera, camera.ray(x, y), &shadows),
        };
        image::Rgb(colour.map(|c| (255.0 * c).round().clamp(0.0, 255.0) as u8))
    });
    imageops::resize(&large, size[0] as u32, size[1] as u32, imageops::FilterType::Triangle)
}

/// Points along the wire, `[x, y, z, radius]`, so close that the balls round them look like a tube.
fn samples(wire: &Wire) -> Vec<[f64; 4]> {
    let mut balls = Vec::new();
    for [a, b] in chords(wire) {
        let apart = (0..3).map(|c| (b[c] - a[c]).powi(2)).sum::<f64>().sqrt();
        let steps = (apart / (STEP * (0.5 * a[3]).max(0.004))).ceil().clamp(1.0, 1e4) as usize;
        balls.extend((0..steps).map(|k| {
            let share = k as f64 / steps as f64;
            [0, 1, 2, 3].map(|c| (a[c] + (b[c] - a[c]) * share) * if c == 3 { 0.5 } else { 1.0 })
        }));
    }
    balls
}

struct Camera {
    right: Vec3,
    up: Vec3,
    back: Vec3,
    eye: Vec3,
    width: usize,
    height: usize,
    /// Pixels a world unit at distance 1.
    scale: f64,
}

/// What one pixel shows of the wire; nothing where the depth is infinite.
#[derive(Clone)]
struct Place {
    depth: f64,
    normal: Vec3,
}

impl Camera {
    /// So far away that three shadows of which each reaches so far from its middle fill the picture.
    fn new([width, height]: [usize; 2], reach: f64) -> Camera {
        let ((sin_a, cos_a), (sin_e, cos_e)) = (AZIMUTH_RAD.sin_cos(), ELEVATION_RAD.sin_cos());
        let (right, up, back) =
            ([cos_a, 0.0, -sin_a], [-sin_a * sin_e, cos_e, -cos_a * sin_e], [sin_a * cos_e, sin_e, cos_a * cos_e]);
        let slope = (FOV_Y_RAD / 2.0).tan();
        let aspect = width as f64 / height as f64;
        let (mut target, mut distance) = ([0.0; 3], 2.0 / slope);
        for _ in 0..8 {
            let mut edges = [f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY];
            for corner in room_corners(reach) {
                let from = minus(corner, target);
                let depth = (distance - dot(from, back)).max(0.1 * distance) / distance;
                let (x, y) = (dot(from, right) / depth, dot(from, up) / depth);
                edges = [edges[0].min(x), edges[1].max(x), edges[2].min(y), edges[3].max(y)];
            }
            let [left, rightmost, bottom, top] = edges;
            target = plus(target, plus(times(right, (left + rightmost) / 2.0), times(up, (bottom + top) / 2.0)));
            distance = ((rightmost - left) / aspect).max(top - bottom) / 2.0 / ROOM_SHARE / slope;
        }
        let eye = plus(target, times(back, distance));
        Camera { right, up, back, eye, width, height, scale: height as f64 / 2.0 / slope }
    }

    /// From the eye through a pixel, length 1.
    fn ray(&self, x: usize, y: usize) -> Vec3 {
        let across = (x as f64 + 0.5 - self.width as f64 / 2.0) / self.scale;
        let above = (self.height as f64 / 2.0 - y as f64 - 0.5) / self.scale;
        unit(minus(plus(times(self.right, across), times(self.up, above)), self.back))
    }

    /// The nearest ball in each pixel, and which way its surface faces there.
    fn normals(&self, balls: &[[f64; 4]]) -> Vec<Place> {
        let mut places = vec![Place { depth: f64::INFINITY, normal: [0.0; 3] }; self.width * self.height];
        for &[x, y, z, radius] in balls {
            let from = minus([x, y, z], self.eye);
            let depth = -dot(from, self.back);
            if depth <= radius {
                continue;
            }
            let scale = self.scale / depth;
            let (radius, reach) = (radius.max(THINNEST_PX / scale), (radius * scale).max(THINNEST_PX));
            let column = self.width as f64 / 2.0 + dot(from, self.right) * scale;
            let row = self.height as f64 / 2.0 - dot(from, self.up) * scale;
            let range = |middle: f64, size: usize| {
                let to = (middle + reach).ceil().clamp(0.0, size as f64) as usize;
                (middle - reach).floor().clamp(0.0, size as f64) as usize..to
            };
            for j in range(row, self.height) {
                for i in range(column, self.width) {
                    let (u, v) = ((i as f64 + 0.5 - column) / reach, (row - j as f64 - 0.5) / reach);
                    let square = u * u + v * v;
                    let place = &mut places[j * self.width + i];
                    let w = (1.0 - square).max(0.0).sqrt();
                    if square < 1.0 && depth - w * radius < place.depth {
                        place.depth = depth - w * radius;
                        place.normal = plus(plus(times(self.right, u), times(self.up, v)), times(self.back, w));
                    }
                }
            }
        }
        places
    }
}

/// Corners of the three squares that shadows fill.
fn room_corners(reach: f64) -> impl Iterator<Item = Vec3> {
    let sides = [-reach, reach];
    (0..3).flat_map(move |wall| {
        (0..8).map(move |k| {
            let mut corner = [sides[k & 1], sides[k >> 1 & 1], sides[k >> 2]];
            corner[wall] = -WALL_AWAY;
            corner
        })
    })
}

/// The shadow on a wall, 0 to 1, SHADOW_PX square: softer and paler the farther from the wall the wire hangs.
fn shadow(balls: &[[f64; 4]], [right, up, inward]: &[Vec3; 3]) -> Vec<f32> {
    let n = SHADOW_PX;
    let (mut there, mut near) = (vec![0.0f32; n * n], vec![0.0f32; n * n]);
    let unit = n as f64 / (2.0 * SHADOW_EXTENT);
    for &[x, y, z, radius] in balls {
        let place = [x, y, z];
        let column = (dot(place, *right) + SHADOW_EXTENT) * unit;
        let row = (SHADOW_EXTENT - dot(place, *up)) * unit;
        let close = (1.0 - (dot(place, *inward) + WALL_AWAY) / (2.0 * WALL_AWAY)).clamp(0.02, 1.0) as f32;
        let reach = (radius * unit).max(0.6);
        let range = |middle: f64| {
            (middle - reach).floor().clamp(0.0, n as f64) as usize
                ..(middle + reach).ceil().clamp(0.0, n as f64) as usize
        };
        for j in range(row) {
            for i in range(column) {
                let inside = reach + 0.5 - (i as f64 + 0.5 - column).hypot(j as f64 + 0.5 - row);
                let inside = inside.clamp(0.0, 1.0) as f32;
                if inside > 0.0 {
                    there[j * n + i] = there[j * n + i].max(inside);
                    near[j * n + i] = near[j * n + i].max(close);
                }
            }
        }
    }
    let around = |map: &[f32]| blurred(map, n, 9.0);
    let (much, close) = (around(&there), around(&near));
    let soft = [1.0, 2.4, 4.4].map(|radius| blurred(&there, n, radius));
    (0..n * n)
        .map(|k| {
            if much[k] < 1e-4 {
                return 0.0;
            }
            let near = f64::from(close[k] / much[k]).clamp(0.0, 1.0);
            // Between the three blurs, the sharpest where the wire is at the wall.
            let blur = 2.0 * (1.0 - smoothstep(0.15, 0.95, near));
            let (low, share) = (blur.floor().min(1.0) as usize, blur - blur.floor().min(1.0));
            let dark = f64::from(soft[low][k]) * (1.0 - share) + f64::from(soft[low + 1][k]) * share;
            (smoothstep(0.0, 1.0, dark) * mix(0.78, 0.9, near)) as f32
        })
        .collect()
}

/// Three running means along each axis: close to a bell curve whose standard deviation is half of `radius_px`.
fn blurred(map: &[f32], n: usize, radius_px: f64) -> Vec<f32> {
    let reach = (radius_px / 2.0).round().max(0.0) as usize;
    let mut map = map.to_vec();
    for (step, line) in [(1, n), (n, 1)] {
        for _ in 0..3 {
            let from = map.clone();
            for l in 0..n {
                for p in 0..n {
                    let (low, high) = (p.saturating_sub(reach), (p + reach).min(n - 1));
                    let sum: f32 = (low..=high).map(|q| from[l * line + q * step]).sum();
                    map[l * line + p * step] = sum / (2 * reach + 1) as f32;
                }
            }
        }
    }
    map
}

/// Colours as the arithmetic wants them: the metal's and the sky's linear in light, the walls' as they are shown.
struct Colours {
    metal: Vec3,
    sky: Vec3,
    ground: Vec3,
    wall: Vec3,
    lit: Vec3,
    shadow: Vec3,
}

impl Colours {
    fn of(paint: &Paint) -> Colours {
        let shown = |colour: [u8; 3]| colour.map(|c| f64::from(c) / 255.0);
        let linear = |colour: [u8; 3]| shown(colour).map(|c| c.powf(2.2));
        Colours {
            metal: linear(paint.metal),
            sky: linear(paint.sky),
            ground: linear(paint.ground),
            wall: shown(paint.wall),
            lit: shown(paint.lit),
            shadow: shown(paint.shadow),
        }
    }

    /// What a ray that leaves the wire meets: a quiet room with three soft boxes.
    fn room(&self, direction: Vec3, blur: f64) -> Vec3 {
        let lamp = |towards: Vec3, size: f64, edge: f64| {
            smoothstep(1.0 - size - edge, 1.0 - size + edge, dot(direction, unit(towards)))
        };
        let boxes = 3.8 * lamp([0.25, 0.45, 1.0], 0.07, 0.04 + blur)
            + 2.4 * lamp([1.0, 0.4, 0.1], 0.06, 0.04 + blur)
            + 3.2 * lamp([-0.15, 1.0, 0.1], 0.08, 0.05 + blur);
        let height = smoothstep(-0.65, 0.75, direction[1]);
        plus(times(along(self.ground, self.sky, height), 0.72), times([1.0, 0.97, 0.92], boxes))
    }

    /// Polished metal at a place whose surface faces `normal`, seen from `towards`.
    fn metal(&self, place: Vec3, normal: Vec3, towards: Vec3) -> Vec3 {
        let facing = dot(normal, towards).clamp(0.0, 1.0);
        let tint = along([0.045; 3], self.metal, smoothstep(0.3, 0.7, GLOSS));
        let grazing = 0.05 + 0.55 * (1.0 - facing).powi(5);
        let mirror = tint.map(|c| c + (1.0 - c) * grazing);
        let reflected = minus(times(normal, 2.0 * dot(normal, towards)), towards);
        let mirrored = product(self.room(reflected, mix(0.2, 0.07, GLOSS)), mirror).map(|c| c * mix(0.9, 0.72, GLOSS));
        let own = product(self.room(normal, 0.9), self.metal).map(|c| c * mix(0.62, 0.16, GLOSS));
        let rim = mix(0.6, 1.0, smoothstep(0.0, 0.6, facing));
        let open = mix(0.74, 1.0, smoothstep(-1.1, 0.6, place[1].min(place[0].min(place[2]) + 0.5)));
        plus(mirrored, own).map(|c| {
            let light = c * rim * open;
            (light / (1.0 + 0.2 * light)).powf(1.0 / 2.2)
        })
    }

    /// The wall that a ray meets: plain, a soft shadow on it, and the page where the room ends.
    fn walls(&self, camera: &Camera, ray: Vec3, shadows: &[Vec<f32>; 3]) -> Vec3 {
        let mut seen = self.wall;
        for (([right, up, inward], brightness), shadow) in WALLS.iter().zip(shadows) {
            let falling = -dot(ray, *inward);
            if falling <= 1e-6 {
                continue;
            }
            let place = plus(camera.eye, times(ray, (dot(camera.eye, *inward) + WALL_AWAY) / falling));
            if place.iter().any(|&x| x < -WALL_AWAY - 1e-6) {
                continue;
            }
            let on_wall = [dot(place, *right), dot(place, *up)];
            let square = on_wall.map(|x| x * x);
            let pool = (-1.1 * (square[0] + square[1])).exp();
            let corner = place.map(|x| {
                let depth = (x + WALL_AWAY).max(0.0);
                (-7.0 * depth).exp() + 0.6 * (-1.7 * depth).exp()
            });
            let meeting = corner.iter().sum::<f64>() - corner.iter().fold(0.0, |a: f64, &b| a.max(b));
            let lit = along(self.wall, self.lit, pool);
            let plain = [0, 1, 2].map(|c| lit[c] * brightness * (1.0 - [0.050, 0.054, 0.060][c] * meeting));
            let dark = looked_up(shadow, on_wall);
            let shaded = [0, 1, 2].map(|c| mix(self.shadow[c], plain[c] * self.shadow[c], 0.35));
            let edge = 1.0 - smoothstep(1.0, 1.75, (square[0] * square[0] + square[1] * square[1]).sqrt().sqrt());
            seen = along(seen, along(plain, shaded, dark), edge);
        }
        seen
    }
}

/// The shadow at a place on its wall, between its four nearest values; none beside it.
fn looked_up(shadow: &[f32], [x, y]: [f64; 2]) -> f64 {
    let unit = SHADOW_PX as f64 / (2.0 * SHADOW_EXTENT);
    let (column, row) = ((x + SHADOW_EXTENT) * unit - 0.5, (SHADOW_EXTENT - y) * unit - 0.5);
    let last = (SHADOW_PX - 2) as f64;
    if !(0.0..last).contains(&column) || !(0.0..last).contains(&row) {
        return 0.0;
    }
    let (i, j) = (column as usize, row as usize);
    let at = |i: usize, j: usize| f64::from(shadow[j * SHADOW_PX + i]);
    let line = |j: usize| mix(at(i, j), at(i + 1, j), column.fract());
    mix(line(j), line(j + 1), row.fract())
}

fn product(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn upright() -> Wire {
        Wire::open_uniform((0..6).map(|k| [0.0, 0.28 * f64::from(k) - 0.7, 0.0, 0.08]).collect()).unwrap()
    }

    #[test]
    fn an_upright_wire_is_copper_and_casts_a_line_on_two_walls_and_a_dot_on_the_floor() {
        let picture = draw(&upright(), [240, 200], &LIGHT);
        let copper = |p: &image::Rgb<u8>| p.0[0] > p.0[2].saturating_add(50);
        let dark = |p: &image::Rgb<u8>| p.0[0] < 120 && p.0[0] < p.0[2].saturating_add(40);
        let row = |y: u32| (0..240).map(move |x| (x, y));
        let count =
            |y: u32, is: &dyn Fn(&image::Rgb<u8>) -> bool| row(y).filter(|&(x, y)| is(picture.get_pixel(x, y))).count();
        assert!(count(110, &copper) > 2, "the wire itself");
        let shadows: Vec<u32> = row(80).filter(|&(x, y)| dark(picture.get_pixel(x, y))).map(|(x, _)| x).collect();
        assert!(shadows.iter().any(|&x| x < 100) && shadows.iter().any(|&x| x > 140), "{shadows:?}");
    }

    #[test]
    fn night_is_darker_and_the_same_wire_gives_the_same_picture() {
        let bright = |picture: &RgbImage| picture.pixels().map(|p| u64::from(p.0[0])).sum::<u64>();
        let day = draw(&upright(), [96, 80], &LIGHT);
        assert_eq!(day, draw(&upright(), [96, 80], &LIGHT));
        assert!(bright(&draw(&upright(), [96, 80], &DARK)) * 2 < bright(&day));
    }
}
