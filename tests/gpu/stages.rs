//! Each stage but the rasteriser's on a device against its twin on the processor, on random input.
use crate::gpu_common;
use crate::optimize_common;

use gpu_common::{device, distance, enclosed, points, scene, step, views, wiry, with_strands};
use optimize_common::random_wire;
use wire4d::gpu::{Pipeline, Slot};
use wire4d::objective::{
    MultiscaleMse, Pyramid, clearance_and_gradient, elastic_and_gradient, length_and_gradient, surface_and_gradient,
};
use wire4d::optimize::{Adam, AdamOptions, Scene, SceneView, SecondMoment, Step, Term, term_count};
use wire4d::rng::Rng;
use wire4d::view::drop_hidden;
use wire4d::wire::{Form, Wire};

const LOSS: f64 = 1e-4;
const GRADIENT: f64 = 1e-3;
/// Plain arithmetic in the same order: rounding only.
const ROUNDING: f64 = 1e-5;

fn random(count: usize, seed: u64) -> Vec<[f32; 4]> {
    let mut rng = Rng::new(seed, 4);
    (0..count).map(|_| std::array::from_fn(|_| rng.range(-1.0, 1.0) as f32)).collect()
}

/// Fails unless `gpu` agrees with `cpu`, and unless the same measure rejects `cpu` with one entry in ten off by 5%.
fn agree<const N: usize>(what: &str, gpu: &[[f32; N]], cpu: &[[f32; N]], tolerance: f64) {
    assert_eq!(gpu.len(), cpu.len(), "{what}");
    let off = distance(gpu.as_flattened(), cpu.as_flattened());
    assert!(off <= tolerance, "{what}: {off:.2e}, more than {tolerance:.0e}");
    let mut wrong = cpu.to_vec();
    wrong.as_flattened_mut().iter_mut().step_by(10).for_each(|value| *value *= 1.05);
    assert!(distance(gpu.as_flattened(), wrong.as_flattened()) > tolerance, "{what}: nothing would be rejected");
    eprintln!("{what}: {off:.1e}");
}

fn wires() -> Vec<Wire> {
    let open = random_wire(23, 5);
    let closed = Wire::closed_uniform(random_wire(17, 6).control_points().to_vec()).unwrap();
    let bag = Wire::uniform(Form::Bag, false, random_wire(24, 7).control_points().to_vec());
    [Ok(open), Ok(closed), bag].into_iter().map(Result::unwrap).collect()
}

/// How much of each sample a view shows.
fn visibilities(view: &SceneView, samples: &[[f32; 4]]) -> Vec<f32> {
    let visibility = |sample: &[f32; 4]| {
        let [x, y, _] = view.camera.project(sample);
        view.occluder.as_ref().map_or(1.0, |occluder| occluder.visibility([x, y], view.camera.depth(sample)))
    };
    samples.iter().map(visibility).collect()
}

/// As the device has them: place, radius, and 1 where drawn.
fn vertices(view: &SceneView, samples: &[[f32; 4]], scene: &Scene, seen: &[f32]) -> Vec<[f32; 4]> {
    let mut vertices: Vec<[f32; 3]> = samples.iter().map(|sample| view.camera.project(sample)).collect();
    let mut drawn = vertices.clone();
    drop_hidden(seen, &scene.strokes, &mut drawn);
    vertices.iter_mut().zip(seen).for_each(|(vertex, seen)| vertex[2] = vertex[2].max(0.0) * seen);
    let pairs = vertices.iter().zip(drawn);
    pairs.map(|(&[x, y, radius], drawn)| [x, y, radius, f32::from(drawn[0].is_finite())]).collect()
}

fn sample_vjp(view: &SceneView, sample: &[f32; 4], seen: f32, d_vertex: [f32; 3]) -> [f32; 4] {
    let [x, y, z, width] = *sample;
    let d_thinned = view.camera.project_vjp(&[x, y, z, seen * width], &d_vertex);
    match &view.occluder {
        Some(occluder) => occluder.thinned_vjp(&view.camera, sample, seen, d_thinned),
        None => d_thinned,
    }
}

fn load(pipeline: &mut Pipeline, scene: &Scene, points: &[[f32; 4]]) {
    pipeline.load(scene).unwrap();
    let moments = vec![[0.0f32; 4]; 2 * points.len()];
    pipeline.write(Slot::State, &[points, &moments].concat()).unwrap();
}

#[test]
fn curve_stages_agree() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 2);
    let step = step();
    for wire in wires() {
        let scene = enclosed(scene(&wire, &views(32), 3, Pyramid::AveragePool, 1), 2);
        let points = points(&wire);
        load(&mut pipeline, &scene, &points);
        pipeline.run("sample", "project", &[step], 0).unwrap();
        let mut samples = Vec::new();
        scene.sampling.apply(&points, &mut samples);
        let count = samples.len();
        agree("samples", &pipeline.read(Slot::Samples, count).unwrap(), &samples, ROUNDING);

        let seen: Vec<Vec<f32>> = scene.views.iter().map(|view| visibilities(view, &samples)).collect();
        let pairs = || scene.views.iter().zip(&seen);
        let vertices: Vec<[f32; 4]> = pairs().flat_map(|(view, seen)| vertices(view, &samples, &scene, seen)).collect();
        let found: Vec<[f32; 4]> = pipeline.read(Slot::Vertices, vertices.len()).unwrap();
        agree("vertices", &found, &vertices, ROUNDING);
        assert!(vertices.iter().any(|vertex| vertex[3] == 0.0), "nothing is hidden: this tests little");

        let d_vertices = random(vertices.len(), 8);
        pipeline.write(Slot::DVertices, &d_vertices).unwrap();
        pipeline.run("project_vjp", "jerk_gradient", &[step], 0).unwrap();
        let mut d_samples = vec![[0.0f32; 4]; count];
        for ((view, seen), d_vertices) in pairs().zip(d_vertices.chunks_exact(count)) {
            let each = d_samples.iter_mut().zip(&samples).zip(seen).zip(d_vertices);
            for (((sum, sample), &seen), d) in each {
                let d_sample = sample_vjp(view, sample, seen, [d[0], d[1], d[2]]);
                (0..4).for_each(|c| sum[c] += d_sample[c]);
            }
        }
        agree("d_samples", &pipeline.read(Slot::DSamples, count).unwrap(), &d_samples, ROUNDING);

        let mut d_points = vec![[0.0; 4]; points.len()];
        scene.sampling.apply_transpose(&d_samples, &mut d_points);
        agree("d_points_image", &pipeline.read(Slot::DPointsImage, points.len()).unwrap(), &d_points, GRADIENT);
        let mut d_length = vec![[0.0; 4]; count];
        let length = length_and_gradient(&samples, &scene.strokes, step.length, &mut d_length);
        let surface = surface_and_gradient(&samples, &scene.planes, step.surface, &mut d_length);
        scene.sampling.apply_transpose(&d_length, &mut d_points);
        let jerk = scene.jerk.energy_and_gradient(&points, step.jerk_position, step.jerk_width, &mut d_points);
        agree("d_points", &pipeline.read(Slot::DPoints, points.len()).unwrap(), &d_points, GRADIENT);

        pipeline.run("measure_surface", "add_terms", &[step], 0).unwrap();
        let terms: Vec<f32> = pipeline.read(Slot::Terms, term_count(3)).unwrap();
        let found = [Term::Jerk, Term::Length, Term::Surface].map(|term| terms[term.at(3)]);
        agree("regularisers", &[found], &[[jerk, length, surface]], LOSS);
        assert!(surface > 0.0 && terms[Term::Texture.at(3)] == 0.0, "{terms:?}");
    }
}

#[test]
fn stages_of_nodes_agree() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 1);
    let step = wiry(1.0);
    let (mut near, mut tight) = (0, 0);
    for wire in wires() {
        let scene = with_strands(scene(&wire, &views(16), 1, Pyramid::AveragePool, 1), &wire);
        let (points, nodes) = (points(&wire), scene.nodes.as_ref().unwrap());
        load(&mut pipeline, &scene, &points);
        let mut d_points = random(points.len(), 3);
        pipeline.write(Slot::DPoints, &d_points).unwrap();
        pipeline.run("pull_nodes", "gather_nodes", &[step], 0).unwrap();

        let maps = [&nodes.place, &nodes.first, &nodes.second];
        let [place, first, second] = maps.map(|map| {
            let mut values = Vec::new();
            map.apply(&points, &mut values);
            values
        });
        let mut d = [0; 3].map(|_| vec![[0.0f32; 4]; nodes.len()]);
        let [d_place, d_first, d_second] = &mut d;
        elastic_and_gradient(nodes, [&place, &first, &second], &step.elastic, d_place, d_first, d_second);
        tight += d_place.iter().filter(|d| d[3] > 0.0).count();
        let pushed = clearance_and_gradient(&place, &nodes.steps, &scene.neighbours, &step.clearance, d_place);
        near += usize::from(pushed > 0.0);
        let found: Vec<[f32; 4]> = pipeline.read(Slot::DNodes, 3 * nodes.len()).unwrap();
        for (k, (name, d)) in ["d_place", "d_first", "d_second"].into_iter().zip(&d).enumerate() {
            agree(name, &found.iter().copied().skip(k).step_by(3).collect::<Vec<_>>(), d, GRADIENT);
        }
        maps.iter().zip(&d).for_each(|(map, d)| map.apply_transpose(d, &mut d_points));
        agree("d_points of nodes", &pipeline.read(Slot::DPoints, points.len()).unwrap(), &d_points, GRADIENT);
    }
    assert!(near > 1 && tight > 10, "{near} wires near themselves, {tight} nodes tight: this tests little");
}

#[test]
fn losses_and_their_gradients_agree() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 1);
    let step = Step { length: 0.0, surface: 0.0, jerk_position: 0.0, jerk_width: 0.0, ..step() };
    let wire = random_wire(12, 2);
    for (pyramid, size) in [Pyramid::AveragePool, Pyramid::Gaussian].into_iter().flat_map(|p| [(p, 64), (p, 41)]) {
        let scene = scene(&wire, &views(size), 2, pyramid, 4);
        load(&mut pipeline, &scene, &points(&wire));
        let mut rng = Rng::new(9, 9);
        let coverage: Vec<Vec<f32>> =
            scene.views.iter().map(|view| view.target.data.iter().map(|_| rng.unit() as f32).collect()).collect();
        pipeline.write(Slot::Coverage, &coverage.concat()).unwrap();
        pipeline.run("compare", "add_terms", &[step], 0).unwrap();
        let mut losses = Vec::new();
        let mut d_coverage: Vec<f32> = Vec::new();
        for (view, coverage) in scene.views.iter().zip(&coverage) {
            let mut mse = MultiscaleMse::new(pyramid, view.target.width, view.target.height);
            let (loss, gradient) = mse.evaluate(coverage, &view.target.data, step.level_ratio, view.weight);
            losses.push([loss]);
            d_coverage.extend(gradient);
        }
        let terms: Vec<f32> = pipeline.read(Slot::Terms, term_count(3)).unwrap();
        let found: Vec<[f32; 1]> = terms[1..4].iter().map(|&term| [term]).collect();
        agree("losses", &found, &losses, LOSS);
        let gradient: Vec<[f32; 1]> = pipeline.read(Slot::Pyramid, d_coverage.len()).unwrap();
        agree("d_coverage", &gradient, bytemuck::cast_slice(&d_coverage), GRADIENT);
    }
}

#[test]
fn adam_agrees() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 3);
    let wire = random_wire(40, 3);
    for second_moment in [SecondMoment::PerComponent, SecondMoment::PerPoint] {
        let scene = scene(&wire, &views(16), 1, Pyramid::AveragePool, 2);
        let step = Step { adam: AdamOptions { second_moment, ..AdamOptions::default() }, ..step() };
        let mut points = points(&wire);
        load(&mut pipeline, &scene, &points);
        let gradient = random(points.len(), 11);
        pipeline.write(Slot::DPoints, &gradient).unwrap();
        pipeline.run("adam", "adam", &[step; 3], 0).unwrap();
        let mut adam = Adam::<4>::new(points.len());
        for _ in 0..3 {
            adam.step(&step.adam, &step.rates, &mut points, &gradient);
            points.iter_mut().for_each(|point| point[3] = point[3].clamp(step.width_bounds[0], step.width_bounds[1]));
        }
        let state = [points, adam.first, adam.second].concat();
        agree("adam", &pipeline.read(Slot::State, state.len()).unwrap(), &state, ROUNDING);
    }
}
