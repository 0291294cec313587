//! The exact rasteriser against a sampled union of round cones, over many random and adversarial wires.

use wire4d::raster::{BandRaster, ExactRaster, Raster, sampled_union};

#[path = "raster_wires/mod.rs"]
mod raster_wires;
use raster_wires::{FAMILIES, SIZE, Wires, wires};

/// Pixels off by more than 0.1, the worst error, and the longest run of such pixels along a row.
fn compare(found: &[f32], sampled: &[f32]) -> (usize, f32, usize) {
    let (mut wrong, mut worst, mut longest) = (0, 0.0f32, 0);
    for (found, sampled) in found.chunks(SIZE).zip(sampled.chunks(SIZE)) {
        let mut run = 0;
        for (f, s) in found.iter().zip(sampled) {
            let error = (f - s).abs();
            worst = worst.max(error);
            run = if error > 0.1 { run + 1 } else { 0 };
            wrong += usize::from(error > 0.1);
            longest = longest.max(run);
        }
    }
    (wrong, worst, longest)
}

#[test]
fn coverage_is_that_of_the_union() {
    let mut raster = ExactRaster::new();
    let (mut all_wrong, mut all_pixels) = (0, 0);
    for family in FAMILIES {
        let (mut wrong, mut worst, mut longest, mut pixels) = (0, 0.0f32, 0, 0);
        for seed in 0..12 {
            let Wires { vertices, strokes } = wires(family, seed);
            let image = raster.forward(SIZE, SIZE, &vertices, &strokes);
            assert!(image.iter().all(|c| (0.0..=1.0).contains(c)), "{family} {seed}: not a coverage");
            let sampled = sampled_union(SIZE, SIZE, &vertices, &strokes, 16);
            let (w, e, l) = compare(image, &sampled);
            (wrong, worst, longest) = (wrong + w, worst.max(e), longest.max(l));
            pixels += sampled.iter().filter(|s| (0.001..0.999).contains(*s)).count();
        }
        println!("{family}: {wrong} of {pixels} edge pixels off by > 0.1, worst {worst:.3}, longest run {longest}");
        assert!(longest <= 2, "{family}: a leak of {longest} pixels along a row");
        assert!(wrong * 200 <= pixels, "{family}: {wrong} of {pixels} edge pixels are off by more than 0.1");
        (all_wrong, all_pixels) = (all_wrong + wrong, all_pixels + pixels);
    }
    assert!(all_wrong * 1000 <= all_pixels, "{all_wrong} of {all_pixels} edge pixels are off by more than 0.1");
}

#[test]
fn the_comparison_would_see_a_leak_and_the_plain_band() {
    let Wires { vertices, strokes } = wires("zigzag", 0);
    let sampled = sampled_union(SIZE, SIZE, &vertices, &strokes, 16);
    let mut raster = ExactRaster::new();
    let mut image = raster.forward(SIZE, SIZE, &vertices, &strokes).to_vec();
    for x in 10..20 {
        image[12 * SIZE + x] = (image[12 * SIZE + x] - 0.15).abs();
    }
    assert!(compare(&image, &sampled).2 >= 9);
    let (wrong, _, _) = compare(BandRaster::new().forward(SIZE, SIZE, &vertices, &strokes), &sampled);
    assert!(wrong * 1000 > sampled.iter().filter(|s| (0.001..0.999).contains(*s)).count());
}
