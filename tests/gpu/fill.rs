//! A whole fit to a mesh on a device: views, targets, what hides strands and the texture's windows change every iteration.
use crate::gpu_common;

use wire4d::mesh::Shape;
use wire4d::picture::Pattern;
use wire4d::settings::{Backend, Preset, Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::fill::{Given, Style, plan};

fn fitted(backend: Backend, seed: u64) -> Run {
    let settings = Settings {
        curve_spacing: 0.16,
        size: 96,
        iterations: 40,
        style_strength: 1.0,
        backend,
        seed,
        ..Task::Fill.preset(Preset::Best)
    };
    let style = Style { name: "waves".into(), ink: Pattern::Waves.picture(256), tiles: true };
    let given = Given { style: Some(style), ..Given::shape(Shape::Torus) };
    let mut run = Run::start(plan(&given, &settings, &mut |_| true).unwrap().unwrap(), &mut |_| true).unwrap();
    run.step(usize::MAX).unwrap();
    run
}

#[test]
fn a_fit_to_a_mesh_is_as_good_as_the_processors() {
    if gpu_common::device().is_none() {
        return;
    }
    let [cpu, gpu] = [Backend::Cpu, Backend::Gpu].map(|backend| fitted(backend, 0));
    assert!(gpu.session().engine_trouble().is_none());
    assert!([&cpu, &gpu].map(|run| run.session().place().backend) == ["cpu", "gpu"]);
    let total = |run: &Run| -> Vec<f32> { run.session().history().rows().map(|row| row[0]).collect() };
    let (of_cpu, of_gpu) = (total(&cpu), total(&gpu));
    let first = (of_cpu[0] - of_gpu[0]).abs() / of_cpu[0];
    assert!(first < 1e-4, "the first iteration's loss is off by {first:.1e}");
    let mean = |losses: &[f32]| losses[20..].iter().sum::<f32>() / 20.0;
    let off = (mean(&of_gpu) / mean(&of_cpu) - 1.0).abs();
    assert!(off < 0.02, "{} instead of {}", mean(&of_gpu), mean(&of_cpu));
    let [cpu, gpu] = [&cpu, &gpu].map(|run| run.result().surface.unwrap());
    eprintln!("drift {} on the processor, {} on the device; losses off by {off:.1e}", cpu.drift_mean, gpu.drift_mean);
    assert!((gpu.drift_mean / cpu.drift_mean - 1.0).abs() < 0.2 && gpu.drift_max < 0.05);
    assert!((total(&fitted(Backend::Cpu, 1))[0] - of_gpu[0]).abs() / of_gpu[0] > 1e-4, "another fit is seen");
}
