//! The paper's error figure, reproduced: slope 2, the bound never violated, under 0.1 px at the default settings.

// The figure's drawing is the bench's.
use crate::figure;

use wire4d::view::{Flattening, PROJECTION_TOLERANCE_PX, View, pieces_per_span, projection_error_bound_px};

#[test]
fn errors_fall_with_the_square_of_the_length() {
    let columns = figure::columns(60);
    // Where pieces are short enough for the leading term to lead.
    let fine = &columns[3..];
    for (name, slope) in [
        ("bound", figure::slope(fine, |c| c.bound_px)),
        ("largest", figure::slope(fine, |c| c.largest_px)),
        ("mean", figure::slope(fine, |c| c.mean_px)),
    ] {
        assert!((slope - 2.0).abs() < 0.15, "{name}: slope {slope}");
    }
    // What a picture shows falls faster: the leading error lies along the curve.
    let drawn = figure::slope(&columns[..4], |c| c.drawn_px);
    assert!(drawn > 2.5, "as drawn: slope {drawn}");
    let paper = figure::slope(&columns, |c| c.by_arc_length);
    assert!(paper > 1.9, "by arc length: slope {paper}");
}

#[test]
fn the_bound_holds_and_is_no_idle_one() {
    for column in figure::columns(60) {
        assert!(column.bound_used <= 1.0, "{column:?}");
        assert!(column.bound_used > 0.25, "a bound four times too wide would be useless: {column:?}");
    }
}

#[test]
fn the_default_settings_are_below_a_tenth_of_a_pixel() {
    let view = figure::view(0.7, 0.3);
    let camera = view.camera::<f64>();
    for (seed, count) in [(0, 30), (1, 100), (2, 210)] {
        let wire = figure::tour(count, seed);
        let pieces = pieces_per_span(&wire, &[camera], PROJECTION_TOLERANCE_PX);
        let counts: Vec<usize> = pieces.iter().map(|pieces| pieces * 8).collect();
        let (mut world, mut flat, mut exact) = (Vec::new(), Vec::new(), Vec::new());
        let route = Flattening::<f64>::beziers(&wire, &pieces, 8);
        route.to_world(wire.control_points(), &mut world);
        route.project(&camera, &world, &mut flat);
        wire.sampling_map_per_span::<f64>(&counts, false).0.apply(wire.control_points(), &mut exact);
        let off = |flat: &[[f64; 3]]| {
            let pairs = flat.iter().zip(exact.iter().map(|point| camera.project(point)));
            pairs.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max)
        };
        assert_eq!(flat.len(), exact.len());
        assert!(off(&flat) < 0.1, "{count} control points: {} px", off(&flat));
        // Sibling: one piece a span is not enough.
        let coarse = Flattening::<f64>::beziers(&wire, &vec![1; pieces.len()], 8);
        let mut points = Vec::new();
        coarse.to_world(wire.control_points(), &mut points);
        let bound = |bezier| projection_error_bound_px(&camera, bezier)[0];
        assert!(points.as_chunks::<4>().0.iter().map(bound).fold(0.0, f64::max) > 0.1);
    }
}

#[test]
fn the_figure_is_an_svg() {
    let svg = figure::svg(&figure::columns(20));
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(svg.contains("mean, slope 2.0") && !svg.contains("NaN") && !svg.contains("inf"));
    let parallel = View::orthographic("front", 0.0, 0.0, 2.0, 512).camera::<f64>();
    assert_eq!(projection_error_bound_px(&parallel, &[[0.3, 0.1, 0.9, 0.1]; 4]), [0.0; 2]);
}
