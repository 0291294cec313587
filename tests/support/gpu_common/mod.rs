//! A device, scenes and measures for the tests of the graphics card's stages.

// Each test file uses its share of them.
#![allow(dead_code)]

use crate::notice::not_tested;
use std::sync::Once;
use wire4d::gpu::{Device, Kind};
use wire4d::objective::{Clearance, Elastic, Neighbours, Pyramid};
use wire4d::optimize::{AdamOptions, Scene, SceneView, Step};
use wire4d::rng::Rng;
use wire4d::view::{Image, Occluder, Projection, View};
use wire4d::wire::Wire;

/// A device, or none with a notice, once; with `WIRE4D_REQUIRE_GPU` set none is a failure.
pub fn device() -> Option<Device> {
    match Device::acquire(Kind::Any) {
        Ok(device) => Some(device),
        Err(error) if std::env::var_os("WIRE4D_REQUIRE_GPU").is_none() => {
            static SAID: Once = Once::new();
            SAID.call_once(|| not_tested(&format!("nothing on a graphics device: {error}")));
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Relative l2 distance.
pub fn distance<'a>(a: impl IntoIterator<Item = &'a f32>, b: impl IntoIterator<Item = &'a f32>) -> f64 {
    let (mut off, mut size) = (0.0, 0.0);
    for (&a, &b) in a.into_iter().zip(b) {
        off += (f64::from(a) - f64::from(b)).powi(2);
        size += f64::from(b).powi(2);
    }
    (off / f64::max(size, 1e-60)).sqrt()
}

/// A square view, a wide one and one from an eye.
pub fn views(size_px: usize) -> Vec<View> {
    vec![
        View::orthographic("front", 0.0, 0.0, 2.2, size_px),
        View::orthographic("side", 1.2, 0.3, 2.2, size_px).with_size(size_px + 5, size_px - 9),
        View {
            name: "eye".into(),
            projection: Projection::Perspective { fov_y_rad: 0.7 },
            eye: [1.9, 1.1, 2.3],
            target: [0.1, -0.2, 0.05],
            up: [0.1, 1.0, 0.0],
            width_px: size_px,
            height_px: size_px,
        },
    ]
}

/// A wire's scene with random ink.
pub fn scene(wire: &Wire, views: &[View], samples: usize, pyramid: Pyramid, seed: u64) -> Scene {
    let mut rng = Rng::new(seed, 3);
    let views = views.iter().enumerate().map(|(v, view)| {
        let (width, height) = (view.width_px, view.height_px);
        let data = (0..width * height).map(|_| rng.unit() as f32).collect();
        SceneView::new(view.camera(), Image { width, height, data }, 0.5 + v as f32)
    });
    Scene { pyramid, ..Scene::new(wire, samples, views.collect()) }
}

/// A wavy solid in the middle of each view but the second, and planes through nowhere near the samples.
pub fn enclosed(mut scene: Scene, seed: u64) -> Scene {
    let mut rng = Rng::new(seed, 6);
    for view in scene.views.iter_mut().step_by(2) {
        let middle = f64::from(view.camera.depth(&[0.0; 4]));
        let (width, height) = (view.target.width, view.target.height);
        let mut depth = Image::new(width, height);
        for (i, depth) in depth.data.iter_mut().enumerate() {
            let (x, y) = ((i % width) as f64, (i / width) as f64);
            let inside = (x - 0.5 * width as f64).hypot(y - 0.45 * height as f64) < 0.3 * width as f64;
            let wave = middle + 0.1 * (0.2 * x).sin() + 0.1 * (0.15 * y).cos();
            *depth = if inside { wave as f32 } else { f32::INFINITY };
        }
        view.occluder = Some(Occluder { steepness: 40.0, ..Occluder::new(depth) });
    }
    let count = scene.sampling.rows().len();
    scene.planes = (0..count)
        .map(|_| {
            let [x, y, z] = rng.in_ball(1.0);
            let length = (x * x + y * y + z * z).sqrt().max(1e-3);
            [x / length, y / length, z / length, rng.range(-0.5, 0.5)].map(|c| c as f32)
        })
        .collect();
    scene
}

pub fn points(wire: &Wire) -> Vec<[f32; 4]> {
    wire.control_points().iter().map(|point| point.map(|c| c as f32)).collect()
}

pub fn step() -> Step {
    Step {
        rates: [0.01, 0.01, 0.01, 0.003],
        adam: AdamOptions::default(),
        level_ratio: 0.7,
        jerk_position: 1e-3,
        jerk_width: 3e-2,
        length: 0.02,
        surface: 0.3,
        texture: 0.0,
        width_bounds: [0.01, 0.1],
        loss_scale: 1.0,
        gradient_share: 0.5,
        ..Step::default()
    }
}

/// The scene with nodes, and with neighbours as they are at the wire's own points.
pub fn with_strands(scene: Scene, wire: &Wire) -> Scene {
    let nodes = wire.nodes(3);
    let neighbours = neighbours(wire, &points(wire));
    Scene { nodes: Some(nodes), neighbours, ..scene }
}

/// Who is near whom at `points`, and not next to each other along the wire.
pub fn neighbours(wire: &Wire, points: &[[f32; 4]]) -> Neighbours {
    let nodes = wire.nodes::<f32>(3);
    let (mut places, mut first) = (Vec::new(), Vec::new());
    nodes.place.apply(points, &mut places);
    nodes.first.apply(points, &mut first);
    Neighbours::find(&places, &nodes.lengths(&first), nodes.closed, &wiry(1.0).clearance, 0.4, 0.1)
}

/// What makes a wire of it, besides. Some widths and places of random wires are on either side of each bound.
pub fn wiry(weight: f32) -> Step {
    let elastic = Elastic {
        bending: 2e-3 * weight,
        cusp_radius: 0.06,
        tightness: 0.3 * weight,
        least_radius: 0.13,
        least_diameters: 3.0,
        evenness: 0.05 * weight,
        speed: 0.3,
    };
    let clearance = Clearance { weight: 3.0 * weight, diameters: 5.0, least_world: 0.22, speed: 0.3 };
    Step { elastic, clearance, ..step() }
}
