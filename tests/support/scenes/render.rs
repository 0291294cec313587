//! A camera with lamps: Lambert's and Blinn and Phong's light, shadow maps (Williams 1978), noise.

use super::noise::hash;
use super::truth::{Seen, truth};
use super::{Lamp, Photograph, SIDE, Scene};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use wire4d_core::mesh::{Depths, Mesh};
use wire4d_core::rng::Rng;
use wire4d_core::view::{Projection, View};

/// Camera's distance from the object's middle, world units.
const DISTANCE: f64 = 5.0;
/// Where the wall is behind the object's middle.
const WALL_Z: f64 = -1.6;
/// Side of a shadow map, px, and what it spans, world units.
const SHADOW_PX: usize = 800;
const SHADOW_SPAN: f64 = 5.0;
/// Bends sharper than this are edges, not shading: cosine.
const SMOOTH: f64 = 0.8;
/// Places a shadow is asked at.
const TAPS: u64 = 8;

/// Takes the photograph.
pub fn photograph(scene: &Scene) -> Photograph {
    let all = Assembled::of(scene);
    let view = view(scene, &all.mesh);
    let fine = 2 * SIDE;
    let depths = Depths::render(&all.mesh, &view.with_size(fine, fine));
    let shadows: Vec<Shadow> = scene.lamps.iter().map(|lamp| Shadow::new(lamp, &all.mesh)).collect();
    let eye = DVec3::from(view.eye);
    let rays = Rays::of(&view);
    let mut seen = vec![None; fine * fine];
    let mut light = vec![DVec3::ZERO; SIDE * SIDE];
    for i in 0..fine * fine {
        let (x, y) = (i % fine, i / fine);
        let colour = match depths.triangle_at(x, y) {
            Some((triangle, weights)) => {
                let corners = all.mesh.corners(triangle);
                let place: DVec3 = (0..3).map(|k| weights[k] * corners[k]).sum();
                let normal: DVec3 = (0..3).map(|k| weights[k] * all.normals[triangle][k]).sum::<DVec3>().normalize();
                // Both sides are seen alike.
                let normal = if normal.dot(eye - place) < 0.0 { -normal } else { normal };
                let part = all.part[triangle];
                let (paint, patch) = (scene.parts[part].paint)(place);
                seen[i] = Some(Seen { place, normal, part, patch });
                lit(scene, &shadows, place, normal, eye, paint, scene.parts[part].gloss, i as u64)
            }
            None => {
                let ray = rays.towards((x as f64 + 0.5) / fine as f64, (y as f64 + 0.5) / fine as f64);
                let down = if ray.y < 0.0 && scene.ground.floor { -eye.y / ray.y } else { f64::INFINITY };
                let back = if ray.z < 0.0 { (WALL_Z - eye.z) / ray.z } else { f64::INFINITY };
                let (t, normal) = if down < back { (down, DVec3::Y) } else { (back.min(40.0), DVec3::Z) };
                let place = eye + t * ray;
                // A paper bent from floor to wall: lit as the floor is.
                let normal = if scene.ground.floor { DVec3::Y } else { normal };
                lit(scene, &shadows, place, normal, eye, (scene.ground.colour)(place), 0.0, i as u64)
            }
        };
        light[y / 2 * SIDE + x / 2] += 0.25 * colour;
    }
    let [mask, contours, creases, painted] = truth(&seen);
    Photograph { name: scene.name, rgb: developed(&light, scene), mask, contours, creases, painted }
}

/// All parts as one mesh, with a normal a corner.
struct Assembled {
    mesh: Mesh,
    part: Vec<usize>,
    normals: Vec<[DVec3; 3]>,
}

impl Assembled {
    fn of(scene: &Scene) -> Assembled {
        let (mut positions, mut triangles, mut part, mut normals) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for (index, body) in scene.parts.iter().enumerate() {
            let first = positions.len() as u32;
            let mut round = vec![Vec::new(); body.mesh.positions().len()];
            let faces: Vec<DVec3> =
                (0..body.mesh.triangles().len()).map(|i| DVec3::from(body.mesh.triangle_normal(i))).collect();
            let area = |i: usize| {
                let [a, b, c] = body.mesh.corners(i);
                (b - a).cross(c - a).length()
            };
            for (i, triangle) in body.mesh.triangles().iter().enumerate() {
                triangle.iter().for_each(|&corner| round[corner as usize].push(i));
            }
            for (i, triangle) in body.mesh.triangles().iter().enumerate() {
                normals.push(triangle.map(|corner| {
                    let smooth = round[corner as usize].iter().filter(|&&other| faces[i].dot(faces[other]) > SMOOTH);
                    smooth.map(|&other| area(other) * faces[other]).sum::<DVec3>().normalize_or(faces[i])
                }));
            }
            positions.extend_from_slice(body.mesh.positions());
            triangles.extend(body.mesh.triangles().iter().map(|t| t.map(|corner| corner + first)));
            part.resize(triangles.len(), index);
        }
        Assembled { mesh: Mesh::new(scene.name, positions, triangles).unwrap(), part, normals }
    }
}

/// A camera at eye's height that the object fills as asked.
fn view(scene: &Scene, mesh: &Mesh) -> View {
    let points = || mesh.positions().iter().map(|&p| DVec3::from(p));
    let low = points().fold(DVec3::INFINITY, DVec3::min);
    let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
    let middle = 0.5 * (low + high);
    let mut view = View::orthographic("photo", scene.azimuth_rad, scene.elevation_rad, 2.0, SIDE);
    view.eye = (middle + DISTANCE / 3.0 * DVec3::from(view.eye)).to_array();
    view.target = middle.to_array();
    view.projection = Projection::Perspective { fov_y_rad: 0.5 };
    let camera = view.camera::<f64>();
    let flat = |p: DVec3| {
        let [x, y, _] = camera.project(&[p.x, p.y, p.z, 0.0]);
        DVec2::new(x, y)
    };
    let (least, most) =
        points().map(flat).fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    let wide = (most - least).max_element() / SIDE as f64;
    let half = 0.25f64.tan() * wide / scene.fill;
    // The object's middle goes where it is asked to be, by turning the camera a little.
    let off = 0.5 * (least + most) / SIDE as f64 - 0.5;
    let rays = Rays::of(&view);
    let shift = DVec2::from(scene.shift) * (half / 0.25f64.tan());
    let aim = rays.towards(0.5 + off.x - shift.x, 0.5 + off.y - shift.y);
    let target = DVec3::from(view.eye) + DISTANCE * aim;
    View { target: target.to_array(), projection: Projection::Perspective { fov_y_rad: 2.0 * half.atan() }, ..view }
}

/// Directions through the picture.
struct Rays {
    forward: DVec3,
    right: DVec3,
    down: DVec3,
}

impl Rays {
    fn of(view: &View) -> Rays {
        let Projection::Perspective { fov_y_rad } = view.projection else { unreachable!("photographs are taken so") };
        let forward = (DVec3::from(view.target) - DVec3::from(view.eye)).normalize();
        let right = forward.cross(DVec3::from(view.up)).normalize();
        let half = (fov_y_rad / 2.0).tan();
        Rays { forward, right: half * right, down: -half * right.cross(forward) }
    }

    /// From shares of the picture's sides.
    fn towards(&self, u: f64, v: f64) -> DVec3 {
        (self.forward + (2.0 * u - 1.0) * self.right + (2.0 * v - 1.0) * self.down).normalize()
    }
}

/// What a lamp sees.
struct Shadow {
    towards: DVec3,
    colour: DVec3,
    softness_px: f64,
    camera: wire4d_core::view::Camera<f64>,
    depths: Depths,
}

impl Shadow {
    fn new(lamp: &Lamp, mesh: &Mesh) -> Shadow {
        let towards = lamp.towards.normalize();
        let (azimuth, elevation) = (towards.x.atan2(towards.z), towards.y.asin());
        let view = View::orthographic("lamp", azimuth, elevation, SHADOW_SPAN, SHADOW_PX);
        let softness_px = lamp.softness * SHADOW_PX as f64 / SHADOW_SPAN;
        Shadow { towards, colour: lamp.colour, softness_px, camera: view.camera(), depths: Depths::render(mesh, &view) }
    }

    /// Share of the lamp that a place sees.
    fn light(&self, place: DVec3, seed: u64) -> f64 {
        let point = [place.x, place.y, place.z, 0.0];
        let [x, y, _] = self.camera.project(&point);
        let depth = self.camera.depth(&point);
        let open = |tap: u64| {
            let [u, v] = [0, 1].map(|k| hash(seed as i64, tap as i64, k, 7));
            let radius = self.softness_px.max(1.0) * u.sqrt();
            let (px, py) = (x + radius * (TAU * v).cos(), y + radius * (TAU * v).sin());
            let inside = |p: f64| p >= 0.0 && p < SHADOW_PX as f64;
            !(inside(px) && inside(py)) || f64::from(self.depths.depths().at(px as usize, py as usize)) > depth
        };
        (0..TAPS).filter(|&tap| open(tap)).count() as f64 / TAPS as f64
    }
}

fn lit(
    scene: &Scene,
    shadows: &[Shadow],
    place: DVec3,
    normal: DVec3,
    eye: DVec3,
    paint: DVec3,
    gloss: f64,
    seed: u64,
) -> DVec3 {
    // More light from above than from below.
    let mut diffuse = DVec3::splat(scene.ambient * (0.8 + 0.2 * normal.y));
    let mut shine = DVec3::ZERO;
    for shadow in shadows {
        let facing = normal.dot(shadow.towards);
        if facing <= 0.0 {
            continue;
        }
        // Lifted off the surface, so that it does not shade itself.
        let open = shadow.light(place + 0.03 * normal + 0.015 * shadow.towards, seed);
        diffuse += open * facing * shadow.colour;
        let half = (shadow.towards + (eye - place).normalize()).normalize();
        shine += open * gloss * normal.dot(half).max(0.0).powf(60.0) * shadow.colour;
    }
    paint * diffuse + shine
}

/// sRGB with a lens that is a little soft, darker corners and a sensor's noise.
fn developed(light: &[DVec3], scene: &Scene) -> Vec<u8> {
    let mut rng = Rng::new(scene.seed, 3);
    let mut rgb = Vec::with_capacity(3 * light.len());
    for y in 0..SIDE {
        for x in 0..SIDE {
            let (mut sum, mut mass) = (DVec3::ZERO, 0.0);
            for v in y.saturating_sub(1)..SIDE.min(y + 2) {
                for u in x.saturating_sub(1)..SIDE.min(x + 2) {
                    let weight = [1.0, 0.35][usize::from(u != x)] * [1.0, 0.35][usize::from(v != y)];
                    sum += weight * light[v * SIDE + u];
                    mass += weight;
                }
            }
            let [dx, dy] = [x, y].map(|p| 2.0 * p as f64 / SIDE as f64 - 1.0);
            let value = sum / mass * (1.0 - 0.08 * (dx * dx + dy * dy));
            // A sum of uniform numbers is normal enough.
            for c in 0..3 {
                let noise: f64 = (0..4).map(|_| rng.range(-0.5, 0.5)).sum::<f64>() * 3f64.sqrt();
                let v = value[c].clamp(0.0, 1.0);
                let encoded = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
                rgb.push((255.0 * encoded + scene.noise * noise).round().clamp(0.0, 255.0) as u8);
            }
        }
    }
    rgb
}
