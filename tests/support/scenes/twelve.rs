//! The twelve scenes.

use super::noise::{cloud, value};
use super::solids::{ball, block, cylinder, moved, rounded, standing, tube, turned};
use super::{Ground, Lamp, Paint, Part, Scene};
use glam::{DMat3, DVec3};
use wire4d_core::mesh::{Mesh, Shape};

fn rgb(hex: u32) -> DVec3 {
    // Linear light of an encoded colour, near enough.
    DVec3::new(f64::from(hex >> 16 & 255), f64::from(hex >> 8 & 255), f64::from(hex & 255))
        .map(|c| (c / 255.0).powf(2.2))
}

/// One colour, a little uneven.
fn plain(hex: u32) -> Paint {
    let colour = rgb(hex);
    Box::new(move |p| (colour * (0.94 + 0.12 * value(9.0 * p, 5)), 0))
}

/// Two colours by a rule that says which.
fn two(first: u32, second: u32, is_second: impl Fn(DVec3) -> bool + 'static) -> Paint {
    let colours = [rgb(first), rgb(second)];
    Box::new(move |p| {
        let patch = u32::from(is_second(p));
        (colours[patch as usize] * (0.94 + 0.12 * value(9.0 * p, 5)), patch)
    })
}

/// Fine grain along x, as of wood.
fn wood(hex: u32, scale: f64) -> impl Fn(DVec3) -> DVec3 + Clone {
    let colour = rgb(hex);
    move |p| {
        let rings = (scale * (6.0 * p.y + 6.0 * p.z + 1.5 * cloud(p * DVec3::new(0.6, 3.0, 3.0), 11))).sin();
        colour * (0.78 + 0.14 * rings + 0.25 * (cloud(p * DVec3::new(4.0, 40.0, 40.0), 12) - 0.5))
    }
}

fn painted(colour: impl Fn(DVec3) -> DVec3 + 'static) -> Paint {
    Box::new(move |p| (colour(p), 0))
}

fn part(mesh: Mesh, paint: Paint, gloss: f64) -> Part {
    Part { mesh, paint, gloss }
}

fn lamp(towards: [f64; 3], strength: f64, softness: f64) -> Lamp {
    Lamp { towards: towards.into(), colour: strength * DVec3::new(1.0, 0.97, 0.9), softness }
}

fn floor(colour: impl Fn(DVec3) -> DVec3 + 'static) -> Ground {
    Ground { colour: Box::new(colour), floor: true }
}

fn wall(colour: impl Fn(DVec3) -> DVec3 + 'static) -> Ground {
    Ground { colour: Box::new(colour), floor: false }
}

fn scaled(shape: Shape, by: f64) -> Mesh {
    moved(&shape.mesh(), DMat3::from_diagonal(DVec3::splat(by)), [0.0; 3])
}

/// All of them, in a fixed order; rendering one takes a second or so.
pub fn twelve() -> Vec<Scene> {
    vec![
        striped_ball(),
        ring(),
        knot(),
        vase(),
        spotted_creature(),
        mug(),
        chair(),
        lamp_on_desk(),
        bottle_and_ball(),
        toy_car(),
        teapot(),
        brown_creature(),
    ]
}

/// A beach ball on plain paper.
fn striped_ball() -> Scene {
    let axis = DVec3::new(0.4, 0.8, 0.45).normalize();
    let side = axis.any_orthonormal_vector();
    let stripes = move |p: DVec3| {
        let p = p - DVec3::Y;
        let angle = p.dot(axis.cross(side)).atan2(p.dot(side));
        p.dot(axis).abs() < 0.93 && (angle * 4.0 / std::f64::consts::PI).rem_euclid(2.0) < 1.0
    };
    Scene {
        name: "striped ball",
        parts: vec![part(ball([0.0, 1.0, 0.0], 1.0), two(0xf0ece0, 0xc8342c, stripes), 0.25)],
        ground: floor(|_| rgb(0xb9b4a8)),
        lamps: vec![lamp([-0.7, 1.2, 0.8], 0.85, 0.12)],
        ambient: 0.3,
        azimuth_rad: 0.2,
        elevation_rad: 0.25,
        fill: 0.6,
        shift: [-0.03, 0.04],
        noise: 2.0,
        seed: 1,
    }
}

/// A glossy ring before a gradient.
fn ring() -> Scene {
    Scene {
        name: "ring",
        parts: vec![part(scaled(Shape::Torus, 1.0), plain(0x2a5fa8), 0.5)],
        ground: wall(|p| rgb(0xd8cdb8).lerp(rgb(0x7c7468), (0.5 + 0.28 * p.y).clamp(0.0, 1.0))),
        lamps: vec![lamp([-0.8, 0.9, 0.9], 0.7, 0.05), lamp([1.0, 0.2, 0.7], 0.25, 0.1)],
        ambient: 0.3,
        azimuth_rad: 0.35,
        elevation_rad: 0.15,
        fill: 0.68,
        shift: [0.02, 0.0],
        noise: 2.5,
        seed: 2,
    }
}

/// Terracotta with a hard shadow.
fn knot() -> Scene {
    let clay = rgb(0xb5623a);
    let grain = move |p: DVec3| clay * (0.85 + 0.3 * cloud(14.0 * p, 21));
    Scene {
        name: "knot",
        parts: vec![part(standing(&scaled(Shape::Knot, 1.0)), painted(grain), 0.05)],
        ground: floor(|_| rgb(0x8fa3ad)),
        lamps: vec![lamp([0.7, 1.3, 0.7], 0.9, 0.0)],
        ambient: 0.28,
        azimuth_rad: -0.3,
        elevation_rad: 0.3,
        fill: 0.66,
        shift: [0.0, -0.02],
        noise: 2.5,
        seed: 3,
    }
}

/// A painted vase before wallpaper, on boards.
fn vase() -> Scene {
    let bands = |p: DVec3| (0.78..0.94).contains(&p.y) || (1.32..1.4).contains(&p.y);
    let boards = wood(0x8a5a34, 1.6);
    let paper = |p: DVec3| {
        let stripe = (5.0 * p.x).rem_euclid(1.0) < 0.5;
        let flower = ((10.0 * p.x).sin() * (8.0 * p.y).sin()) > 0.55;
        if flower { rgb(0xa8765c) } else { rgb(if stripe { 0xcfc4a4 } else { 0xb4ab88 }) }
    };
    Scene {
        name: "vase",
        parts: vec![part(standing(&scaled(Shape::Vase, 1.0)), two(0x3d7a78, 0xe6dcc0, bands), 0.4)],
        ground: floor(move |p| if p.y < 1e-6 { boards(p) } else { paper(p) }),
        lamps: vec![lamp([-0.9, 1.1, 0.8], 0.8, 0.1)],
        ambient: 0.3,
        azimuth_rad: 0.1,
        elevation_rad: 0.3,
        fill: 0.72,
        shift: [0.04, 0.02],
        noise: 2.5,
        seed: 4,
    }
}

/// A spotted animal on grass.
fn spotted_creature() -> Scene {
    let spots = |p: DVec3| value(4.2 * p, 31) > 0.64;
    let grass = |p: DVec3| {
        let blades = cloud(DVec3::new(22.0 * p.x, 5.0 * p.y + 5.0 * p.z, 9.0), 41);
        rgb(0x55742e).lerp(rgb(0x9db35e), (1.8 * blades - 0.4).clamp(0.0, 1.0)) * (0.75 + 0.5 * cloud(2.0 * p, 42))
    };
    Scene {
        name: "spotted creature",
        parts: vec![part(standing(&scaled(Shape::Creature, 1.0)), two(0xe8e2d6, 0x2c2622, spots), 0.1)],
        ground: floor(grass),
        lamps: vec![lamp([-0.5, 1.4, 0.7], 0.85, 0.06)],
        ambient: 0.32,
        azimuth_rad: 0.45,
        elevation_rad: 0.25,
        fill: 0.74,
        shift: [-0.02, 0.03],
        noise: 3.0,
        seed: 5,
    }
}

/// A white mug on a table: the table shows through its handle.
fn mug() -> Scene {
    let cup = turned(&[
        (0.0, 0.0),
        (0.52, 0.0),
        (0.58, 0.06),
        (0.6, 1.3),
        (0.57, 1.34),
        (0.53, 1.3),
        (0.51, 0.12),
        (0.0, 0.1),
    ]);
    let handle = tube(
        &[[0.55, 1.05, 0.0], [0.8, 1.12, 0.0], [1.02, 0.85, 0.0], [0.95, 0.45, 0.0], [0.56, 0.28, 0.0]],
        0.085,
        0.085,
    );
    let band = |p: DVec3| (0.5..0.78).contains(&p.y) && p.x.hypot(p.z) > 0.55;
    let table = wood(0x9c6a3e, 2.3);
    Scene {
        name: "mug",
        parts: vec![part(cup, two(0xe9e6df, 0x2f4f86, band), 0.35), part(handle, plain(0xe9e6df), 0.35)],
        ground: floor(table),
        lamps: vec![lamp([-0.8, 1.2, 0.6], 0.75, 0.15), lamp([0.9, 0.9, 0.5], 0.25, 0.2)],
        ambient: 0.28,
        azimuth_rad: 0.25,
        elevation_rad: 0.45,
        fill: 0.62,
        shift: [0.0, 0.03],
        noise: 2.5,
        seed: 6,
    }
}

/// A wooden chair with a hard shadow on floor and wall.
fn chair() -> Scene {
    let grain = wood(0xa9713f, 0.9);
    let mut parts: Vec<Part> = Vec::new();
    let mut add = |low: [f64; 3], high: [f64; 3]| parts.push(part(block(low, high), painted(grain.clone()), 0.1));
    for (x, z) in [(-0.5, 0.38), (0.38, 0.38)] {
        add([x, 0.0, z], [x + 0.12, 0.9, z + 0.12]);
    }
    for x in [-0.5, 0.38] {
        add([x, 0.0, -0.5], [x + 0.12, 2.0, -0.38]);
    }
    add([-0.56, 0.9, -0.52], [0.56, 1.02, 0.56]);
    for y in [1.3, 1.62] {
        add([-0.38, y, -0.48], [0.38, y + 0.2, -0.41]);
    }
    Scene {
        name: "chair",
        parts,
        ground: floor(|p| if p.z > -1.59 { rgb(0xa9a7a0) } else { rgb(0xc3c6c4) }),
        lamps: vec![lamp([0.9, 1.5, 0.9], 0.85, 0.0)],
        ambient: 0.3,
        azimuth_rad: 0.6,
        elevation_rad: 0.32,
        fill: 0.76,
        shift: [-0.01, 0.0],
        noise: 2.0,
        seed: 7,
    }
}

/// A lamp with a bent arm before a gradient.
fn lamp_on_desk() -> Scene {
    let shade = turned(&[(0.14, 0.42), (0.17, 0.45), (0.45, 0.0), (0.42, 0.0), (0.13, 0.41)]);
    let shade = moved(&shade, DMat3::from_rotation_z(0.35), [0.62, 1.42, 0.0]);
    let arm =
        tube(&[[0.0, 0.1, 0.0], [-0.15, 0.8, 0.0], [-0.05, 1.6, 0.0], [0.3, 1.95, 0.0], [0.5, 1.83, 0.0]], 0.05, 0.05);
    Scene {
        name: "lamp",
        parts: vec![
            part(
                turned(&rounded(&[(0.0, 0.0), (0.5, 0.0), (0.5, 0.1), (0.2, 0.16), (0.0, 0.18)])),
                plain(0x333a3d),
                0.3,
            ),
            part(arm, plain(0x8d8f92), 0.5),
            part(shade, plain(0xc2402f), 0.35),
        ],
        ground: floor(|p| {
            let wall = rgb(0x9fb8c4).lerp(rgb(0xe4e0d2), (0.35 * p.y).clamp(0.0, 1.0));
            if p.z > -1.59 { rgb(0x9fb8c4) * (0.96 + 0.08 * value(3.0 * p, 51)) } else { wall }
        }),
        lamps: vec![lamp([-0.6, 1.0, 1.0], 0.7, 0.08), lamp([0.9, 0.8, 0.3], 0.3, 0.1)],
        ambient: 0.3,
        azimuth_rad: -0.25,
        elevation_rad: 0.2,
        fill: 0.76,
        shift: [0.0, 0.0],
        noise: 2.5,
        seed: 8,
    }
}

/// Two things on tiles, two lamps, hard shadows.
fn bottle_and_ball() -> Scene {
    let bottle = turned(&rounded(&[
        (0.0, 0.0),
        (0.38, 0.0),
        (0.4, 0.03),
        (0.4, 1.0),
        (0.38, 1.2),
        (0.14, 1.42),
        (0.12, 1.5),
        (0.12, 1.9),
        (0.16, 1.92),
        (0.16, 2.02),
        (0.0, 2.02),
    ]));
    let label = |p: DVec3| (0.3..0.85).contains(&p.y);
    let tiles = |p: DVec3| {
        let [u, v] = [p.x, p.z - p.y].map(|c| (1.6 * c).rem_euclid(1.0));
        let joint = u.min(v) < 0.05;
        let shade =
            0.9 + 0.2 * super::noise::hash((1.6 * p.x).floor() as i64, (1.6 * (p.z - p.y)).floor() as i64, 0, 61);
        if joint { rgb(0x8a857c) } else { shade * rgb(0xc4b8a4) }
    };
    Scene {
        name: "bottle and ball",
        parts: vec![
            part(bottle, two(0x2d6b3c, 0xe8dfc6, label), 0.5),
            part(ball([0.62, 0.36, 0.35], 0.36), plain(0xd9822b), 0.3),
        ],
        ground: floor(tiles),
        lamps: vec![lamp([-0.9, 1.3, 0.7], 0.6, 0.0), lamp([0.6, 1.1, 0.9], 0.35, 0.0)],
        ambient: 0.26,
        azimuth_rad: 0.15,
        elevation_rad: 0.3,
        fill: 0.74,
        shift: [0.02, 0.01],
        noise: 2.5,
        seed: 9,
    }
}

/// A toy car on a carpet.
fn toy_car() -> Scene {
    let mut parts = vec![
        part(
            block([-1.1, 0.22, -0.45], [1.1, 0.62, 0.45]),
            two(0xd8b021, 0x2b2b2b, |p| (0.3..0.36).contains(&p.y)),
            0.3,
        ),
        part(block([-0.62, 0.62, -0.4], [0.42, 1.02, 0.4]), plain(0xd8b021), 0.3),
        part(block([-0.52, 0.7, 0.36], [-0.14, 0.95, 0.41]), plain(0x3a4a58), 0.5),
        part(block([-0.04, 0.7, 0.36], [0.34, 0.95, 0.41]), plain(0x3a4a58), 0.5),
        part(block([0.4, 0.68, -0.34], [0.43, 0.96, 0.34]), plain(0x3a4a58), 0.5),
    ];
    for x in [-0.65, 0.65] {
        for z in [0.36, -0.54] {
            let wheel = moved(&cylinder(0.26, 0.18), DMat3::from_rotation_x(std::f64::consts::FRAC_PI_2), [x, 0.26, z]);
            let hub = move |p: DVec3| (p.x - x).hypot(p.y - 0.26) < 0.12;
            parts.push(part(wheel, two(0x1f1f20, 0xb8b8b4, hub), 0.15));
        }
    }
    let carpet = |p: DVec3| {
        let leaf = cloud(2.6 * p + DVec3::X, 71);
        let pile = 0.8 + 0.4 * cloud(40.0 * p, 72);
        pile * if leaf > 0.56 {
            rgb(0x7c3038)
        } else if leaf < 0.44 {
            rgb(0x2f4a6b)
        } else {
            rgb(0x9c8760)
        }
    };
    Scene {
        name: "toy car",
        parts,
        ground: floor(carpet),
        lamps: vec![lamp([-0.6, 1.4, 0.9], 0.85, 0.05)],
        ambient: 0.3,
        azimuth_rad: 0.55,
        elevation_rad: 0.4,
        fill: 0.74,
        shift: [0.0, 0.0],
        noise: 2.5,
        seed: 10,
    }
}

/// A dotted pot, with spout, handle and lid.
fn teapot() -> Scene {
    let body = turned(&rounded(&[(0.0, 0.0), (0.5, 0.0), (0.85, 0.3), (0.88, 0.75), (0.6, 1.15), (0.32, 1.2)]));
    let lid = turned(&rounded(&[(0.36, 1.17), (0.36, 1.22), (0.25, 1.32), (0.08, 1.35), (0.06, 1.4)]));
    let spout = tube(&[[0.7, 0.45, 0.0], [1.05, 0.6, 0.0], [1.2, 0.95, 0.0], [1.42, 1.18, 0.0]], 0.17, 0.09);
    let handle = tube(
        &[[-0.68, 1.0, 0.0], [-1.05, 1.12, 0.0], [-1.3, 0.8, 0.0], [-1.12, 0.42, 0.0], [-0.8, 0.38, 0.0]],
        0.08,
        0.08,
    );
    let dots = |p: DVec3| {
        let around = p.x.atan2(p.z) * 9.0 / std::f64::consts::TAU;
        let row = (p.y - 0.2) / 0.3;
        let shifted = around + 0.5 * (row.floor().rem_euclid(2.0));
        let [u, v] = [shifted, row].map(|c| c.rem_euclid(1.0) - 0.5);
        (0.15..1.05).contains(&p.y) && (1.5 * u).hypot(v) < 0.3
    };
    Scene {
        name: "teapot",
        parts: vec![
            part(body, two(0xd9d3c4, 0xa8452f, dots), 0.4),
            part(lid, plain(0xd9d3c4), 0.4),
            part(ball([0.0, 1.47, 0.0], 0.1), plain(0xa8452f), 0.4),
            part(spout, plain(0xd9d3c4), 0.4),
            part(handle, plain(0xd9d3c4), 0.4),
        ],
        ground: floor(|p| rgb(0x4b5a52).lerp(rgb(0x8ea394), (0.5 + 0.3 * p.x - 0.1 * p.z).clamp(0.0, 1.0))),
        lamps: vec![lamp([-0.8, 1.2, 0.9], 0.75, 0.12)],
        ambient: 0.28,
        azimuth_rad: 0.15,
        elevation_rad: 0.3,
        fill: 0.78,
        shift: [0.0, 0.02],
        noise: 2.5,
        seed: 11,
    }
}

/// A brown animal on sand: colours near to each other.
fn brown_creature() -> Scene {
    let fur = rgb(0x7a5638);
    let coat = move |p: DVec3| fur * (0.75 + 0.5 * cloud(p * DVec3::new(10.0, 24.0, 24.0), 81));
    let sand = |p: DVec3| rgb(0xbfa27a) * (0.85 + 0.3 * cloud(5.0 * p, 91)) * (0.92 + 0.16 * value(60.0 * p, 92));
    Scene {
        name: "brown creature",
        parts: vec![part(standing(&scaled(Shape::Creature, 1.0)), painted(coat), 0.05)],
        ground: floor(sand),
        lamps: vec![lamp([0.8, 1.3, 0.8], 0.8, 0.08)],
        ambient: 0.3,
        azimuth_rad: -0.5,
        elevation_rad: 0.2,
        fill: 0.72,
        shift: [0.02, -0.02],
        noise: 3.0,
        seed: 12,
    }
}
