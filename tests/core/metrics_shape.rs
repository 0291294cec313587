//! Figures of wires whose length, parts and bends are known.

use crate::export_support;

use export_support as wires;
use std::f64::consts::{PI, TAU};
use wire4d::metrics::{Elegance, ResultReport, shape};
use wire4d::sculpture::render;
use wire4d::view::View;
use wire4d::wire::Wire;

fn views() -> Vec<View> {
    View::canonical(2.2, 256).to_vec()
}

/// World width that is `px` wide at 256 px in the canonical views.
fn width(px: f64) -> f64 {
    px * 2.2 / 256.0
}

fn circle(radius: f64, width: impl Fn(f64) -> f64) -> Wire {
    let point = |i: usize| {
        let a = TAU * i as f64 / 48.0;
        [radius * a.cos(), radius * a.sin(), 0.0, width(a)]
    };
    Wire::closed_uniform((0..48).map(point).collect()).unwrap()
}

#[test]
fn a_circle_has_the_figures_of_a_circle() {
    let found = shape(&circle(0.5, |_| width(2.0)), &views());
    assert_eq!((found.components, found.connectivity_cost), (1, 0.0));
    assert!((found.length / PI - 1.0).abs() < 5e-3, "{found:?}");
    assert!((found.min_bend_radius.unwrap() / 0.5 - 1.0).abs() < 5e-3, "{found:?}");
    assert!((found.min_width - width(2.0)).abs() < 1e-12 && (found.max_width - width(2.0)).abs() < 1e-12);
    assert!((shape(&circle(0.52, |_| 0.01), &views()).length / PI - 1.0).abs() > 5e-3, "4% more would be seen");
}

#[test]
fn invisible_runs_part_the_wire() {
    let dashes = |width_of_gap: f64| circle(0.5, |a| if (2.0 * a).sin() > 0.0 { width(2.0) } else { width_of_gap });
    let parted = shape(&dashes(0.0), &views());
    assert_eq!(parted.components, 2, "{parted:?}");
    assert!(parted.length < 0.7 * PI && parted.length > 0.5 * PI, "{parted:?}");
    // The two arcs end a little less than a quarter turn apart: one chord joins them.
    let chord = 0.5 * 2f64.sqrt();
    assert!(parted.connectivity_cost < chord && parted.connectivity_cost > 0.7 * chord, "{parted:?}");
    let whole = shape(&dashes(width(0.26)), &views());
    assert_eq!((whole.components, whole.connectivity_cost), (1, 0.0));
    assert_eq!(shape(&dashes(width(0.24)), &views()).components, 2, "the limit is a quarter of a pixel");
}

#[test]
fn parts_that_touch_are_one() {
    // Out, an invisible jump, and back at a distance: two parallel rods.
    let rods = |gap: f64| {
        let rod = |y: f64| (0..12).map(move |i| [0.05 * i as f64 - 0.3, y, 0.0, width(4.0)]);
        let jump = (0..8).map(|i| [0.6, gap * i as f64 / 7.0, 0.3, 0.0]);
        Wire::open_uniform(rod(0.0).chain(jump).chain(rod(gap)).collect()).unwrap()
    };
    assert_eq!(shape(&rods(width(3.9)), &views()).components, 1);
    let apart = shape(&rods(width(4.1)), &views());
    assert_eq!(apart.components, 2);
    assert!((apart.connectivity_cost - width(4.1)).abs() < 1e-6, "{apart:?}");
}

#[test]
fn a_straight_wire_has_no_bend_and_no_jerk() {
    let wire = Wire::open_uniform((0..9).map(|i| [0.1 * i as f64, 0.0, 0.0, 0.02]).collect()).unwrap();
    let found = shape(&wire, &views());
    assert_eq!(found.min_bend_radius, None);
    assert!(shape(&wires::helix(), &views()).jerk > 0.0);
}

#[test]
fn every_wire_gets_finite_figures() {
    for (name, wire) in wires::all() {
        for views in [views(), vec![], vec![wires::perspective()]] {
            let found = shape(&wire, &views);
            let figures = [found.length, found.connectivity_cost, found.min_width, found.max_width, found.jerk];
            assert!(figures.iter().all(|x| x.is_finite() && *x >= 0.0), "{name}: {found:?}");
            let Elegance { turning_per_unit, tight_share, touching_share, penetrating_share, .. } = found.elegance;
            assert!(turning_per_unit.is_finite() && turning_per_unit >= 0.0, "{name}: {found:?}");
            for share in [tight_share, touching_share, penetrating_share] {
                assert!((0.0..=1.0).contains(&share), "{name}: {found:?}");
            }
            assert!(found.min_bend_radius.is_none_or(|r| r.is_finite() && r >= 0.0), "{name}: {found:?}");
        }
    }
}

#[test]
fn large_wires_are_measured_in_moments() {
    let mut points = wires::random(3, 20_000).control_points().to_vec();
    for (i, point) in points.iter_mut().enumerate() {
        // Two thousand visible parts of a few spans each.
        point[3] = if i % 10 < 5 { 0.003 } else { 0.0 };
        (0..3).for_each(|c| point[c] *= 0.3);
    }
    for (i, point) in points.iter_mut().enumerate() {
        point[0] += (i / 10 % 45) as f64 * 0.02 - 0.45;
    }
    let found = shape(&Wire::open_uniform(points).unwrap(), &views());
    assert!(found.components >= 1 && found.connectivity_cost.is_finite(), "{found:?}");
}

#[test]
fn a_report_has_the_fields_of_the_contract() {
    let sculpture = wires::sculpture(wires::helix());
    let own = render(&sculpture.wire, &sculpture.views[0]);
    let report = ResultReport::measure(&sculpture, &[Some(own), None]);
    assert!(report.views[0].soft_iou.unwrap() > 0.999 && report.views[0].psnr_db == Some(100.0));
    assert_eq!((report.views[0].precision_2px, report.views[0].recall_2px), (Some(1.0), Some(1.0)));
    let other = render(&sculpture.wire, &sculpture.views[1]);
    let against = ResultReport::measure(&sculpture, &[Some(other)]);
    assert!(against.views[0].soft_iou.unwrap() < 0.9, "another view's picture does not match");
    let value = serde_json::to_value(&report).unwrap();
    for key in
        ["views", "control_points", "length", "components", "connectivity_cost", "min_width", "max_width", "jerk"]
    {
        assert!(!value[key].is_null(), "{key}");
    }
    assert!(value["min_bend_radius"].is_f64());
    for key in ["turning_per_unit", "kinks", "tight_share", "touching_share", "penetrating_share", "length_over_lines"]
    {
        assert!(value[key].is_number(), "{key}");
    }
    let mut old = value.clone();
    old.as_object_mut().unwrap().retain(|key, _| !key.starts_with("tight") && key != "length_over_lines");
    let old = serde_json::from_value::<ResultReport>(old).unwrap();
    assert_eq!((old.length_over_lines, old.shape.elegance.tight_share), (None, 0.0), "reports from before can be read");
    let view = value["views"][0].as_object().unwrap();
    for key in ["name", "soft_iou", "psnr_db", "precision_2px", "recall_2px", "target_coverable", "bent", "stretch"] {
        assert!(view.contains_key(key), "{key}");
    }
    assert_eq!(serde_json::from_value::<ResultReport>(value).unwrap(), report);
}
