//! The exact rasteriser against a sampled union of round cones, over many random and adversarial wires.

use wire4d::raster::{BandRaster, ExactRaster, Raster, sampled_union};
use wire4d::wire::Stroke;

use crate::raster_wires;
use raster_wires::{FAMILIES, SIZE, Wires, wires};

/// Pixels off by more than 0.1, the worst error, and the longest run of such pixels along a row.
fn compare(size: usize, found: &[f32], sampled: &[f32]) -> (usize, f32, usize) {
    let (mut wrong, mut worst, mut longest) = (0, 0.0f32, 0);
    for (found, sampled) in found.chunks(size).zip(sampled.chunks(size)) {
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
            let (w, e, l) = compare(SIZE, image, &sampled);
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
    assert!(compare(SIZE, &image, &sampled).2 >= 9);
    let (wrong, _, _) = compare(SIZE, BandRaster::new().forward(SIZE, SIZE, &vertices, &strokes), &sampled);
    assert!(wrong * 1000 > sampled.iter().filter(|s| (0.001..0.999).contains(*s)).count());
}

/// Side of the small pictures.
const SMALL: usize = 24;

/// Wires of a family shrunk to a small picture.
fn small_wires(family: &str, seed: u64) -> Wires {
    let Wires { vertices, strokes } = wires(family, seed);
    let scale = SMALL as f32 / SIZE as f32;
    Wires { vertices: vertices.into_iter().map(|v| v.map(|c| c * scale)).collect(), strokes }
}

/// Half a pixel's diagonal: farther from its centre lies nothing of a pixel.
const HALF_DIAGONAL_PX: f32 = std::f32::consts::FRAC_1_SQRT_2;

/// Whether each pixel's centre lies within `reach_px` of the strokes.
fn within(reach_px: f32, vertices: &[[f32; 3]], strokes: &[Stroke]) -> Vec<bool> {
    let wider: Vec<[f32; 3]> = vertices.iter().map(|&[x, y, radius]| [x, y, radius + reach_px]).collect();
    sampled_union(SMALL, SMALL, &wider, strokes, 1).iter().map(|&inside| inside > 0.0).collect()
}

#[test]
fn thousands_of_small_wires_neither_leak_nor_break() {
    // Pixels wholly outside by this much must be blank to the last bit; it covers rounding at coordinates of 1,000 px.
    const MARGIN_PX: f32 = 0.01;
    let (mut raster, mut gradient) = (ExactRaster::new(), Vec::new());
    let adjoint: Vec<f32> = (0..SMALL * SMALL).map(|i| (i as f32 * 0.7).sin()).collect();
    let (mut count, mut all_wrong, mut all_pixels, mut touched) = (0, 0, 0, 0);
    for family in FAMILIES {
        let (mut wrong, mut worst, mut longest, mut pixels, mut leaks, mut largest) = (0, 0.0f32, 0, 0, 0, 0.0f32);
        for seed in 1000..1110 {
            let Wires { vertices, strokes } = small_wires(family, seed);
            let image = raster.forward(SMALL, SMALL, &vertices, &strokes);
            assert!(image.iter().all(|c| (0.0..=1.0).contains(c)), "{family} {seed}: not a coverage");
            let reach = within(HALF_DIAGONAL_PX + MARGIN_PX, &vertices, &strokes);
            for (&c, _) in image.iter().zip(&reach).filter(|(_, near)| !**near) {
                leaks += usize::from(c != 0.0);
                largest = largest.max(c);
            }
            // Sibling: with a shorter reach the check does see ink.
            let short = within(0.3, &vertices, &strokes);
            touched += image.iter().zip(&short).filter(|(c, near)| **c != 0.0 && !**near).count();
            // A lattice is at its worst where many edges lie along its rows.
            let samples = if family == "hatching" { 64 } else { 12 };
            let sampled = sampled_union(SMALL, SMALL, &vertices, &strokes, samples);
            let (w, e, l) = compare(SMALL, image, &sampled);
            (wrong, worst, longest) = (wrong + w, worst.max(e), longest.max(l));
            pixels += sampled.iter().filter(|s| (0.001..0.999).contains(*s)).count();
            raster.backward(&adjoint, &mut gradient);
            assert!(gradient.iter().flatten().all(|g| g.is_finite()), "{family} {seed}: no gradient");
            count += 1;
        }
        println!(
            "{family}: {wrong} of {pixels} edge pixels off by > 0.1, worst {worst:.3}, longest run {longest}, {leaks} \
             leaks up to {largest:e}"
        );
        assert_eq!(leaks, 0, "{family}: ink out of reach, up to {largest:e}");
        // Three pixels, each off by less than 0.15, happen where a strand runs back a thousandth of a pixel beside itself.
        assert!(longest <= 3, "{family}: a leak of {longest} pixels along a row");
        assert!(worst < 0.25, "{family}: a pixel off by {worst}");
        (all_wrong, all_pixels) = (all_wrong + wrong, all_pixels + pixels);
    }
    assert!(count >= 2000 && touched > 1000, "{count} wires, {touched} pixels");
    assert!(all_wrong * 1000 <= all_pixels, "{all_wrong} of {all_pixels} edge pixels are off by more than 0.1");
}
