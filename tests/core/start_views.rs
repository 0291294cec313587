//! The start in views other than front, side and top: any number, any direction, with perspective.

use wire4d::Error;
use wire4d::start::{Path, TrailOptions, TreeOptions, length, tree_path, wire_along};
use wire4d::view::{Image, Projection, Target, View};

const SIZE_PX: usize = 128;

/// A trefoil knot seen from `view`: 5 px discs along its projection.
fn knot_seen_from(view: View) -> Target {
    let camera = view.camera::<f64>();
    let mut ink = Image::new(SIZE_PX, SIZE_PX);
    for step in 0..2000 {
        let t = f64::from(step) / 2000.0 * std::f64::consts::TAU;
        let (x, y, z) = (t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -(3.0 * t).sin());
        let [x_px, y_px, _] = camera.project(&[0.18 * x, 0.18 * y, 0.4 * z, 0.0]);
        for (row, column) in (-3..=3).flat_map(|row| (-3..=3).map(move |column| (row, column))) {
            let (px, py) = (x_px as i64 + column, y_px as i64 + row);
            if row * row + column * column <= 7 && (0..128).contains(&px) && (0..128).contains(&py) {
                ink.data[py as usize * SIZE_PX + px as usize] = 1.0;
            }
        }
    }
    Target { view, ink }
}

/// Each view's share of ink within 4 px of the path.
fn shown(path: &Path, targets: &[Target]) -> Vec<f64> {
    let share = |target: &Target| {
        let camera = target.view.camera::<f64>();
        let on_path: Vec<[f64; 3]> = path.points.iter().map(|point| camera.project(point)).collect();
        let ink: Vec<usize> = (0..SIZE_PX * SIZE_PX).filter(|&i| target.ink.data[i] > 0.5).collect();
        let near = |i: usize| {
            let (x, y) = ((i % SIZE_PX) as f64 + 0.5, (i / SIZE_PX) as f64 + 0.5);
            on_path.iter().any(|p| (p[0] - x).hypot(p[1] - y) < 4.0)
        };
        ink.iter().filter(|&&i| near(i)).count() as f64 / ink.len() as f64
    };
    targets.iter().map(share).collect()
}

fn views() -> Vec<View> {
    let oblique = |name: &str, azimuth: f64, elevation: f64| View::orthographic(name, azimuth, elevation, 1.6, SIZE_PX);
    let mut views = vec![oblique("a", 0.3, 0.1), oblique("b", 1.6, -0.4), oblique("c", 2.9, 0.9)];
    let mut near = oblique("d", 0.9, 0.5);
    near.projection = Projection::Perspective { fov_y_rad: 0.55 };
    views.push(near);
    views
}

#[test]
fn a_knot_comes_back_from_two_to_four_oblique_views() {
    let targets: Vec<Target> = views().into_iter().map(knot_seen_from).collect();
    let options = TreeOptions { across: 64, ..TreeOptions::default() };
    for count in 2..=4 {
        let targets = &targets[..count];
        let path = tree_path(targets, [0.6, 0.6, 0.6], &options, &TrailOptions::default(), &mut |_| true).unwrap();
        let shown = shown(&path, targets);
        assert!(shown.iter().all(|&share| share > 0.9), "{count} views: {shown:?}");
        let wire = wire_along(&path, 0.02).unwrap();
        assert!(wire.control_points().len() > 50 && length(&path) > 2.0);
    }
}

#[test]
fn half_a_path_shows_half() {
    let targets: Vec<Target> = views().into_iter().take(3).map(knot_seen_from).collect();
    let options = TreeOptions { across: 64, ..TreeOptions::default() };
    let mut path = tree_path(&targets, [0.6; 3], &options, &TrailOptions::default(), &mut |_| true).unwrap();
    path.points.truncate(path.points.len() / 4);
    assert!(shown(&path, &targets).iter().any(|&share| share < 0.8), "the check can fail");
}

#[test]
fn hostile_targets_get_an_error() {
    let targets: Vec<Target> = views().into_iter().take(2).map(knot_seen_from).collect();
    let grow = |targets: &[Target], half: [f64; 3]| {
        tree_path(
            targets,
            half,
            &TreeOptions { across: 32, ..TreeOptions::default() },
            &TrailOptions::default(),
            &mut |_| true,
        )
    };
    assert!(matches!(grow(&targets[..1], [0.6; 3]), Err(Error::Pictures { .. })));
    assert!(grow(&targets, [0.6, f64::INFINITY, 0.6]).is_err());
    assert!(grow(&targets, [0.6, 0.0, 0.6]).is_err());
    let mut blank = targets.clone();
    blank[1].ink = Image::new(SIZE_PX, SIZE_PX);
    assert!(matches!(grow(&blank, [0.6; 3]), Err(Error::Picture { .. })));
    let mut full = targets;
    full.iter_mut().for_each(|target| target.ink.data.fill(1.0));
    assert!(grow(&full, [0.6; 3]).is_ok());
}
