//! The rasteriser's stages on a device against the processor's, on random and hostile strokes.
use crate::gpu_common;
use crate::raster_wires;

use gpu_common::{device, distance, step};
use raster_wires::{FAMILIES, SIZE, Wires, wires};
use wire4d::gpu::{Pipeline, Slot};
use wire4d::optimize::{Scene, SceneView, wait};
use wire4d::raster::{ExactRaster, Raster};
use wire4d::rng::Rng;
use wire4d::view::{Image, View};
use wire4d::wire::{LinearMap, Row, Wire};

/// A scene whose samples are drawn as the strokes of `wires`; the two views share their size only.
fn scene(wires: &Wires) -> Scene {
    let rows = (0..wires.vertices.len()).map(|_| Row { first: 0, weights: [0.25; 4] }).collect();
    let wire = Wire::open_uniform(vec![[0.0, 0.0, 0.0, 0.1]; 4]).unwrap();
    let camera = View::orthographic("any", 0.0, 0.0, 2.0, SIZE).camera();
    let views = [SIZE, SIZE - 7].map(|width| SceneView::new(camera, Image::new(width, SIZE), 1.0));
    Scene { sampling: LinearMap::new(4, rows), strokes: wires.strokes.clone(), ..Scene::new(&wire, 1, views.to_vec()) }
}

struct Drawn {
    coverage: Vec<f32>,
    d_vertices: Vec<[f32; 3]>,
}

/// Coverage and adjoint of the processor's picture of `width` columns.
fn on_processor(wires: &Wires, width: usize, d_coverage: &[f32]) -> Drawn {
    let mut raster = ExactRaster::new();
    let coverage = raster.forward(width, SIZE, &wires.vertices, &wires.strokes).to_vec();
    let mut d_vertices = Vec::new();
    raster.backward(d_coverage, &mut d_vertices);
    Drawn { coverage, d_vertices }
}

/// The processor up to the vertices, the device from there, both views.
fn on_device(pipeline: &mut Pipeline, wires: &Wires, d_coverage: &[f32]) -> [Drawn; 2] {
    pipeline.load(&scene(wires)).unwrap();
    let usable = |v: &[f32; 3]| v.iter().all(|c| c.abs() <= 1e6);
    let drawn = |k: usize| wires.strokes.iter().any(|s| (s.start..s.start + s.count).contains(&k));
    let packed = wires.vertices.iter().enumerate().map(|(k, v)| {
        let seen = f32::from(usable(v) && drawn(k));
        [v[0], v[1], v[2].max(0.0), seen]
    });
    let packed: Vec<[f32; 4]> = packed.collect();
    loop {
        pipeline.write(Slot::Vertices, &[packed.clone(), packed.clone()].concat()).unwrap();
        pipeline.run("join_pieces", "finish_rows", &[step()], 0).unwrap();
        let wanted = pipeline.read::<u32>(Slot::Cells, 1).unwrap()[0] as usize;
        if wanted <= pipeline.room() {
            break;
        }
        wait(pipeline.make_room(wanted)).unwrap();
    }
    pipeline.write(Slot::Pyramid, d_coverage).unwrap();
    pipeline.run("pull_back", "gather_pulls", &[step()], 0).unwrap();
    let (first, count) = (SIZE * SIZE, packed.len());
    let coverage: Vec<f32> = pipeline.read(Slot::Coverage, first + (SIZE - 7) * SIZE).unwrap();
    let d_vertices: Vec<[f32; 4]> = pipeline.read(Slot::DVertices, 2 * count).unwrap();
    let d_vertices: Vec<[f32; 3]> = d_vertices.into_iter().map(|[x, y, r, _]| [x, y, r]).collect();
    let view = |coverage: &[f32], d_vertices: &[[f32; 3]]| Drawn {
        coverage: coverage.to_vec(),
        d_vertices: d_vertices.to_vec(),
    };
    [view(&coverage[..first], &d_vertices[..count]), view(&coverage[first..], &d_vertices[count..])]
}

/// Largest difference of coverage that passes, and of the adjoint, relative.
const COVERAGE: f32 = 1e-3;
const ADJOINT: f64 = 1e-3;

fn largest_difference(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

fn adjoint_distance(a: &Drawn, b: &Drawn) -> f64 {
    distance(a.d_vertices.as_flattened(), b.d_vertices.as_flattened())
}

#[test]
fn more_samples_than_a_row_of_workgroups_are_drawn() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 1);
    let few = wires("smooth", 1);
    // Most are in no stroke; what is drawn comes last.
    let unused = 70_000;
    let mut many = Wires { vertices: vec![[0.0, 0.0, 1.0]; unused], strokes: few.strokes.clone() };
    many.vertices.extend(&few.vertices);
    many.strokes.iter_mut().for_each(|stroke| stroke.start += unused);
    let mut rng = Rng::new(1, 8);
    let d_coverage: Vec<f32> = (0..SIZE * (2 * SIZE - 7)).map(|_| rng.range(-1.0, 1.0) as f32).collect();
    let [mut drawn, _] = on_device(&mut pipeline, &many, &d_coverage);
    let expected = on_processor(&few, SIZE, &d_coverage[..SIZE * SIZE]);
    drawn.d_vertices.drain(..unused);
    assert!(largest_difference(&drawn.coverage, &expected.coverage) <= COVERAGE);
    assert!(adjoint_distance(&drawn, &expected) <= ADJOINT);
    // Sibling: nothing drawn would be seen.
    many.strokes.clear();
    let [blank, _] = on_device(&mut pipeline, &many, &d_coverage);
    assert!(largest_difference(&blank.coverage, &expected.coverage) > COVERAGE);
}

#[test]
fn coverage_and_its_adjoint_agree() {
    let Some(device) = device() else { return };
    let mut pipeline = Pipeline::new(&device, 1);
    let mut wrong = Vec::new();
    for family in FAMILIES {
        let (mut worst, mut worst_adjoint) = (0.0f32, 0.0f64);
        for seed in 0..3 {
            let wires = wires(family, seed);
            let mut rng = Rng::new(seed, 8);
            let d_coverage: Vec<f32> = (0..SIZE * (2 * SIZE - 7)).map(|_| rng.range(-1.0, 1.0) as f32).collect();
            let (d_first, d_second) = d_coverage.split_at(SIZE * SIZE);
            let device = on_device(&mut pipeline, &wires, &d_coverage);
            let processor = [on_processor(&wires, SIZE, d_first), on_processor(&wires, SIZE - 7, d_second)];
            for (device, processor) in device.iter().zip(&processor) {
                worst = worst.max(largest_difference(&device.coverage, &processor.coverage));
                worst_adjoint = worst_adjoint.max(adjoint_distance(device, processor));
                // Siblings: a picture a pixel off, and the adjoint of another one, are rejected.
                let flat = processor.coverage.iter().all(|c| *c == processor.coverage[0]);
                let shifted = largest_difference(&device.coverage[1..], &processor.coverage);
                assert!(flat || shifted > COVERAGE, "{family}: a shift passes");
                let grown = processor.d_vertices.iter().map(|d| d.map(|c| 1.05 * c)).collect();
                let wrong = Drawn { coverage: Vec::new(), d_vertices: grown };
                let any = processor.d_vertices.as_flattened().iter().any(|d| *d != 0.0);
                assert!(!any || adjoint_distance(device, &wrong) > ADJOINT, "{family}: a wrong adjoint passes");
            }
        }
        eprintln!("{family}: coverage {worst:.1e}, adjoint {worst_adjoint:.1e}");
        if worst > COVERAGE || worst_adjoint > ADJOINT {
            wrong.push(format!("{family}: coverage {worst:.1e}, adjoint {worst_adjoint:.1e}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
