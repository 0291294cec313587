//! Strands that nearly coincide: stretches of fitted wires, at their cusps, where the rasteriser once lost whole edges.
//! Of three outlines so close that the total order of polygons decides, each hid the next, and the last hid the first.
//! Vertices as they were drawn, moved by whole pixels; `lost` says what was: a row, or part of one pixel.

use wire4d::raster::{ExactRaster, Raster, sampled_union};
use wire4d::wire::Stroke;

const SIZE: usize = 32;

/// Name and vertices of each stretch.
fn stretches() -> Vec<(String, Vec<[f32; 3]>)> {
    let text = std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/raster/coincident.json")).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let numbers = |vertex: &serde_json::Value| [0, 1, 2].map(|c| vertex[c].as_f64().unwrap() as f32);
    let stretch = |case: &serde_json::Value| {
        let vertices = case["vertices"].as_array().unwrap().iter().map(numbers).collect();
        (format!("{}, {}", case["of"], case["lost"]), vertices)
    };
    json.as_array().unwrap().iter().map(stretch).collect()
}

fn whole(vertices: &[[f32; 3]]) -> [Stroke; 1] {
    [Stroke { start: 0, count: vertices.len(), closed: false }]
}

/// Largest difference in coverage to the union, counted on 256 points a pixel.
fn worst(found: &[f32], vertices: &[[f32; 3]]) -> f32 {
    let sampled = sampled_union(SIZE, SIZE, vertices, &whole(vertices), 16);
    found.iter().zip(&sampled).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

#[test]
fn nearly_coincident_strands_are_drawn_like_any() {
    let mut raster = ExactRaster::new();
    for (name, vertices) in stretches() {
        let image = raster.forward(SIZE, SIZE, &vertices, &whole(&vertices));
        let error = worst(image, &vertices);
        assert!(error < 0.05, "{name}: off by {error}");
        // Sibling: a tenth of a pixel less would be seen.
        let mut image = image.to_vec();
        let edge = image.iter_mut().max_by(|a, b| (**a).total_cmp(b)).unwrap();
        *edge -= 0.1;
        assert!(worst(&image, &vertices) > 0.05, "{name}: anything passes");
    }
}

/// Moving everything sideways moves ink along rows, so it changes no row's ink: what an outline gains on its right it
/// loses on its left, if no edge is missing.
#[test]
fn backward_sees_both_sides_of_every_row() {
    let mut raster = ExactRaster::new();
    let mut d_vertices = Vec::new();
    for (name, vertices) in stretches() {
        raster.forward(SIZE, SIZE, &vertices, &whole(&vertices));
        let mut change = |counts: &dyn Fn(usize, usize) -> bool| {
            let adjoint: Vec<f32> = (0..SIZE * SIZE).map(|i| f32::from(counts(i % SIZE, i / SIZE))).collect();
            raster.backward(&adjoint, &mut d_vertices);
            d_vertices.iter().map(|d| d[0]).sum::<f32>()
        };
        let mut of_columns = 0.0f32;
        for i in 0..SIZE {
            let of_row = change(&|_, row| row == i);
            assert!(of_row.abs() < 0.1, "{name}: row {i} changes by {of_row} a pixel");
            of_columns = of_columns.max(change(&|column, _| column == i).abs());
        }
        // Sibling: it does change columns.
        assert!(of_columns > 0.1, "{name}: nothing moves");
    }
}
