//! The texture's loss and gradient on a device against the processor's.
use crate::gpu_common;
use crate::optimize_common;

use gpu_common::{device, distance, points, scene, step, views};
use optimize_common::random_wire;
use std::sync::Arc;
use wire4d::gpu::{GpuEngine, Pipeline, Slot};
use wire4d::objective::{MultiscaleMse, Pyramid, Texture, TextureLoss, TextureOptions, crop_weights};
use wire4d::optimize::{CpuEngine, Engine, Picture, Scene, Step, Term, term_count, wait};
use wire4d::rng::Rng;
use wire4d::view::Image;

const LOSS: f64 = 1e-4;
const GRADIENT: f64 = 1e-3;

fn random(width: usize, height: usize, stream: u64) -> Image {
    let mut rng = Rng::new(3, stream);
    Image { width, height, data: (0..width * height).map(|_| rng.unit() as f32).collect() }.blurred(0.8)
}

/// Three views, of which the second counts in windows and the third nowhere.
fn styled(size_px: usize, finest: usize) -> Scene {
    let options = TextureOptions { finest, ..TextureOptions::default() };
    let texture = Texture::of("style", &random(128, 128, 1), &options).unwrap();
    let mut scene = scene(&random_wire(24, 5), &views(size_px), 3, Pyramid::AveragePool, 1);
    let (width, height) = (scene.views[1].target.width, scene.views[1].target.height);
    let mut mask = random(width, height, 2);
    mask.data.iter_mut().for_each(|value| *value = value.min(1.0));
    scene.views[1].texture_mask = Some(crop_weights(&mask, 2, size_px / 2, &mut Rng::new(1, 1)));
    scene.views[2].texture_mask = Some(Image::new(size_px, size_px));
    scene.texture = Some(Arc::new(texture));
    scene
}

fn weights(scene: &Scene, view: usize) -> Vec<f32> {
    let view = &scene.views[view];
    view.texture_mask.as_ref().map_or_else(|| vec![1.0; view.target.data.len()], |mask| mask.data.clone())
}

/// Losses and gradients of pictures of noise: the processor's with the texture's weight times `skew`.
fn of_noise(pipeline: &mut Pipeline, scene: &Scene, skew: f32) -> [f64; 2] {
    let step = Step { texture: 0.3, ..step() };
    pipeline.load(scene).unwrap();
    let pictures: Vec<Image> =
        (0..).zip(&scene.views).map(|(v, view)| random(view.target.width, view.target.height, 9 + v)).collect();
    let coverage: Vec<f32> = pictures.iter().flat_map(|picture| picture.data.clone()).collect();
    pipeline.write(Slot::Coverage, &coverage).unwrap();
    pipeline.write(Slot::State, &points(&random_wire(24, 5))).unwrap();
    pipeline.run("compare", "add_terms", &[step], 0).unwrap();
    let (mut loss, mut d_coverage) = (0.0, Vec::new());
    for (v, (view, picture)) in scene.views.iter().zip(&pictures).enumerate() {
        let (width, height) = (view.target.width, view.target.height);
        let mut mse = MultiscaleMse::new(scene.pyramid, width, height);
        let mut gradient = mse.evaluate(&picture.data, &view.target.data, step.level_ratio, view.weight).1.to_vec();
        let mut texture = TextureLoss::new(scene.texture.as_ref().unwrap(), width, height);
        let weight = skew * step.texture * view.weight;
        let (value, pull) = texture.evaluate(&picture.data, &weights(scene, v), weight);
        loss += value;
        gradient.iter_mut().zip(pull).for_each(|(sum, d)| *sum += d);
        d_coverage.extend(gradient);
    }
    let terms: Vec<f32> = pipeline.read(Slot::Terms, term_count(3)).unwrap();
    let found: Vec<f32> = pipeline.read(Slot::Pyramid, d_coverage.len()).unwrap();
    assert!(loss > 0.01);
    [distance(&[terms[Term::Texture.at(3)]], &[loss]), distance(&found, &d_coverage)]
}

#[test]
fn the_loss_of_noise_and_its_gradient_agree() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 1);
    for (size_px, finest) in [(96, 0), (97, 1), (64, 0)] {
        let scene = styled(size_px, finest);
        let [loss, gradient] = of_noise(&mut pipeline, &scene, 1.0);
        eprintln!("{size_px} px from level {finest}: loss {loss:.1e}, gradient {gradient:.1e}");
        assert!(loss < LOSS && gradient < GRADIENT, "{size_px} px: {loss:e} and {gradient:e}");
        let [loss, gradient] = of_noise(&mut pipeline, &scene, 1.02);
        assert!(loss > LOSS && gradient > GRADIENT, "another weight is seen: {loss:e} and {gradient:e}");
    }
    let none = Scene { texture: None, ..styled(64, 0) };
    pipeline.load(&none).unwrap();
    pipeline.run("sample", "add_terms", &[Step { texture: 0.3, ..step() }], 0).unwrap();
    assert_eq!(pipeline.read::<f32>(Slot::Terms, term_count(3)).unwrap()[Term::Texture.at(3)], 0.0);
}

/// Terms, gradients to the pictures and to the points.
fn evaluate(engine: &mut dyn Engine, step: &Step) -> (Vec<f32>, Vec<f32>, Vec<[f32; 4]>) {
    let (mut terms, mut d_points, mut d_coverage) = (vec![0.0; term_count(3)], Vec::new(), Vec::new());
    wait(engine.evaluate(&points(&random_wire(24, 5)), step, &mut terms, &mut d_points).done());
    wait(engine.fetch(Picture::DCoverage).done());
    (0..3).for_each(|view| d_coverage.extend_from_slice(engine.picture(Picture::DCoverage, view)));
    (terms, d_coverage, d_points)
}

#[test]
fn whole_iterations_agree_with_other_masks_too() {
    let Some(device) = device() else { return };
    let (mut cpu, mut gpu) = (CpuEngine::new(), GpuEngine::new(&device, ""));
    let step = Step { texture: 0.2, ..step() };
    let scene = styled(96, 0);
    wait(cpu.load(scene.clone()).done());
    wait(gpu.load(scene.clone()).done());
    let mut first = None;
    for turn in 0..2 {
        if turn == 1 {
            let mut views = scene.views.clone();
            views[0].texture_mask = views[2].texture_mask.clone();
            views[2].texture_mask = None;
            wait(cpu.set_views(vec![views.clone()]).done());
            wait(gpu.set_views(vec![views]).done());
        }
        let (on_cpu, on_gpu) = (evaluate(&mut cpu, &step), evaluate(&mut gpu, &step));
        assert!(gpu.trouble().is_none(), "{:?}", gpu.trouble());
        let off = |other: &(Vec<f32>, Vec<f32>, Vec<[f32; 4]>)| {
            let flat = |points: &Vec<[f32; 4]>| points.concat();
            [
                distance(&[on_gpu.0[Term::Texture.at(3)]], &[other.0[Term::Texture.at(3)]]),
                distance(&on_gpu.1, &other.1),
                distance(&flat(&on_gpu.2), &flat(&other.2)),
            ]
        };
        let [loss, d_coverage, gradient] = off(&on_cpu);
        eprintln!("loss {loss:.1e}, d_coverage {d_coverage:.1e}, gradient {gradient:.1e}");
        // Coverage itself agrees to 1e-3, and what a texture asks of it is steep.
        assert!(loss < 1e-3 && d_coverage < 2e-3 && gradient < 2e-3, "{loss:e}, {d_coverage:e}, {gradient:e}");
        let other = off(&evaluate(&mut cpu, &Step { texture: 0.21, ..step }));
        assert!(other[0] > 1e-3 && other[1] > 2e-3 && other[2] > 2e-3, "another weight is seen: {other:?}");
        assert_eq!(evaluate(&mut gpu, &step), on_gpu, "the same bits again");
        let loss = on_gpu.0[Term::Texture.at(3)];
        assert_ne!(first.replace(loss), Some(loss), "another mask is another loss");
    }
}
