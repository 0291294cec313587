//! The exact rasteriser's backward pass against differences of its own image, and what must hold of any pass.

use wire4d::raster::{ExactRaster, Raster};
use wire4d::rng::Rng;
use wire4d::wire::Stroke;

use crate::raster_wires;
use raster_wires::{FAMILIES, SIZE, Wires, wires};

fn adjoint_image(seed: u64) -> Vec<f32> {
    // Smooth, as a loss's adjoint is, and nowhere symmetric.
    let mut rng = Rng::new(seed, 3);
    let waves: Vec<[f64; 4]> = (0..6).map(|_| [0.0; 4].map(|_: f64| rng.range(-1.0, 1.0))).collect();
    let value =
        |x: f64, y: f64| waves.iter().map(|w| w[3] * (0.5 * (w[0] * x + w[1] * y) + 3.0 * w[2]).sin()).sum::<f64>();
    (0..SIZE * SIZE).map(|i| value((i % SIZE) as f64, (i / SIZE) as f64) as f32).collect()
}

/// A smooth way to move vertices, so that strands on top of each other stay there.
fn field(seed: u64, [x, y, _]: [f32; 3]) -> [f32; 3] {
    let mut rng = Rng::new(seed, 4);
    std::array::from_fn(|_| {
        let [a, b, c] = [0.0; 3].map(|_: f64| rng.range(-3.0, 3.0));
        (0.06 * (a * f64::from(x) + b * f64::from(y)) + c).sin() as f32
    })
}

/// The derivative of `sum(adjoint * image)` along a field: by the backward pass, by central differences, and the
/// same with a gradient whose radius part is left out.
fn derivatives(family: &str, seed: u64, h: f32) -> [f64; 3] {
    let Wires { vertices, strokes } = wires(family, seed);
    let (mut raster, mut gradient) = (ExactRaster::new(), Vec::new());
    let adjoint = adjoint_image(seed);
    let direction: Vec<[f32; 3]> = vertices.iter().map(|&v| field(seed, v)).collect();
    let mut energy = |h: f32| {
        let moved: Vec<[f32; 3]> =
            vertices.iter().zip(&direction).map(|(v, d)| std::array::from_fn(|c| v[c] + h * d[c])).collect();
        let image = raster.forward(SIZE, SIZE, &moved, &strokes);
        image.iter().zip(&adjoint).map(|(&c, &a)| f64::from(c) * f64::from(a)).sum::<f64>()
    };
    let difference = (energy(h) - energy(-h)) / f64::from(2.0 * h);
    raster.forward(SIZE, SIZE, &vertices, &strokes);
    raster.backward(&adjoint, &mut gradient);
    let along = |components: usize| {
        let pairs = gradient.iter().zip(&direction);
        pairs.map(|(g, d)| (0..components).map(|c| f64::from(g[c]) * f64::from(d[c])).sum::<f64>()).sum::<f64>()
    };
    [along(3), difference, along(2)]
}

#[test]
fn backward_is_the_derivative_of_the_image() {
    for family in FAMILIES {
        // Zero radii cannot shrink; huge discs move their whole outline across the picture.
        if ["discs", "huge radii"].contains(&family) {
            continue;
        }
        let (mut error, mut blind, mut norm) = (0.0, 0.0, 0.0);
        for seed in 0..8 {
            let [found, difference, without_radius] = derivatives(family, seed, 0.02);
            error += (found - difference).powi(2);
            blind += (without_radius - difference).powi(2);
            norm += difference.powi(2);
        }
        let (error, blind) = ((error / norm).sqrt(), (blind / norm).sqrt());
        println!("{family}: relative error {error:.4}, without the radii {blind:.3}");
        // Where strands nearly or partly cover each other, which one is on top changes within a difference's step.
        let kinked = ["back, offset 1e-3", "collinear, other vertices"].contains(&family);
        let limit = if kinked { 0.15 } else { 0.03 };
        assert!(error < limit, "{family}: the derivative is off by {error}");
        assert!(blind > 0.05, "{family}: the check would accept a gradient without radii");
    }
}

#[cfg(feature = "threads")]
#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mut rng = Rng::new(9, 0);
    let mut at = |i: usize| {
        let angle = i as f64 * 0.05;
        let far = 10.0 + 0.02 * i as f64 + rng.range(-0.5, 0.5);
        [(64.0 + far * angle.cos()) as f32, (64.0 + far * angle.sin()) as f32, rng.range(0.2, 1.5) as f32]
    };
    let mut vertices: Vec<[f32; 3]> = (0..2000).map(&mut at).collect();
    let strokes = [Stroke { start: 0, count: 1200, closed: false }, Stroke { start: 1200, count: 800, closed: true }];
    let adjoint: Vec<f32> = (0..128 * 128).map(|i| (i as f32 * 0.1).sin()).collect();
    let draw = |threads: usize, vertices: &[[f32; 3]]| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let (mut raster, mut gradient) = (ExactRaster::new(), Vec::new());
            let image: Vec<u32> = raster.forward(128, 128, vertices, &strokes).iter().map(|c| c.to_bits()).collect();
            raster.backward(&adjoint, &mut gradient);
            (image, gradient.iter().flatten().map(|g| g.to_bits()).collect::<Vec<u32>>())
        })
    };
    let one = draw(1, &vertices);
    assert!(one == draw(2, &vertices) && one == draw(5, &vertices));
    vertices[700][0] += 1e-3;
    assert!(one != draw(2, &vertices), "the check would not see a difference");
}

#[test]
fn used_buffers_change_nothing() {
    let mut used = ExactRaster::new();
    for (size, family, seed) in [(64, "zigzag", 1), (40, "tapered", 2), (64, "closed loops", 3), (9, "smooth", 4)] {
        let Wires { vertices, strokes } = wires(family, seed);
        let (mut gradient, mut fresh_gradient) = (Vec::new(), Vec::new());
        let adjoint = vec![1.0; size * (size + 3)];
        let mut fresh = ExactRaster::new();
        assert_eq!(
            used.forward(size, size + 3, &vertices, &strokes),
            fresh.forward(size, size + 3, &vertices, &strokes)
        );
        used.backward(&adjoint, &mut gradient);
        fresh.backward(&adjoint, &mut fresh_gradient);
        assert_eq!(gradient, fresh_gradient, "{family}");
    }
}

#[test]
fn hostile_vertices_do_no_harm() {
    let special = [f32::NAN, f32::INFINITY, -1e30, 1e30, 3e38, -9.9e5, 9.9e5, 1e-38, 0.0, -0.0, -5.0, 1.0, 31.9, 5e4];
    let (mut raster, mut gradient) = (ExactRaster::new(), Vec::new());
    for seed in 0..300 {
        let mut rng = Rng::new(seed, 5);
        let number = |rng: &mut Rng| {
            if rng.below(3) == 0 { special[rng.below(special.len())] } else { rng.range(-4.0, 36.0) as f32 }
        };
        let vertices: Vec<[f32; 3]> = (0..12).map(|_| [0.0; 3].map(|_: f32| number(&mut rng))).collect();
        let strokes: Vec<Stroke> = (0..3)
            .map(|_| Stroke { start: rng.below(14), count: rng.below(14), closed: rng.below(2) == 0 })
            .chain([
                Stroke { start: usize::MAX, count: 3, closed: true },
                Stroke { start: 2, count: usize::MAX, closed: true },
            ])
            .collect();
        let (width, height) = (1 + rng.below(40), 1 + rng.below(40));
        let image = raster.forward(width, height, &vertices, &strokes);
        assert!(image.len() == width * height && image.iter().all(|c| (0.0..=1.0).contains(c)), "seed {seed}");
        raster.backward(&vec![1.0; width * height], &mut gradient);
        assert!(gradient.len() == 12 && gradient.iter().flatten().all(|g| g.is_finite()), "seed {seed}: {gradient:?}");
    }
    assert!(raster.forward(0, 7, &[[1.0; 3]], &[Stroke { start: 0, count: 1, closed: false }]).is_empty());
    raster.backward(&[], &mut gradient);
    assert_eq!(gradient, [[0.0; 3]]);
    assert!(raster.forward(5, 5, &[], &[]).iter().all(|&c| c == 0.0));
}

#[test]
fn thousands_of_huge_pieces_stay_within_bounds() {
    // Every box covers the whole picture, or a good deal of it.
    let mut rng = Rng::new(3, 0);
    let mut far = || rng.range(-9e5, 9e5) as f32;
    let vertices: Vec<[f32; 3]> = (0..600).map(|i| [far(), far(), if i % 7 == 0 { 300.0 } else { 0.5 }]).collect();
    let strokes = [Stroke { start: 0, count: 600, closed: true }];
    let (mut raster, mut gradient) = (ExactRaster::new(), Vec::new());
    assert!(raster.forward(256, 256, &vertices, &strokes).iter().all(|c| (0.0..=1.0).contains(c)));
    raster.backward(&vec![1.0; 256 * 256], &mut gradient);
    assert!(gradient.iter().flatten().all(|g| g.is_finite()));
}
