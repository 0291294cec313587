//! The start where nothing was drawn: a ring that every view sees from inside its edge.

use super::Path;
use crate::view::View;
use glam::DVec3;

/// Points of the ring.
const POINTS: usize = 256;

/// A closed ring of `radius_world` round the origin, in the plane that all `views` see best: their own, of a single one.
pub fn ring_path(views: &[View], radius_world: f64, width_world: f64) -> Path {
    let sight = |view: &View| (DVec3::from(view.target) - DVec3::from(view.eye)).normalize_or(DVec3::NEG_Z);
    let first = views.first().map_or(DVec3::NEG_Z, sight);
    // Front and back see the same plane.
    let sum: DVec3 = views.iter().map(sight).map(|line| if line.dot(first) < 0.0 { -line } else { line }).sum();
    let normal = sum.normalize_or(first);
    let up = views.first().map_or(DVec3::Y, |view| DVec3::from(view.up));
    let right = normal.cross(up).normalize_or(normal.any_orthonormal_vector());
    let up = right.cross(normal);
    let point = |k: usize| {
        let (sin, cos) = (std::f64::consts::TAU * k as f64 / POINTS as f64).sin_cos();
        let [x, y, z] = (radius_world * (cos * right + sin * up)).to_array();
        [x, y, z, width_world]
    };
    Path { points: (0..POINTS).map(point).collect(), closed: true }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half the width and half the height of what a view shows of the ring of radius 1, world units.
    fn shown(ring: &Path, view: &View) -> [f64; 2] {
        let camera = view.camera::<f64>();
        let most = |of: fn(&[f64; 3]) -> f64| {
            let all = ring.points.iter().map(|point| of(&camera.project(point)));
            let (least, most) = all.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
            0.5 * (most - least) * 2.2 / 64.0
        };
        [most(|p| p[0]), most(|p| p[1])]
    }

    #[test]
    fn one_view_sees_a_circle_and_several_no_edge() {
        let views = View::canonical(2.2, 64);
        for view in &views {
            let ring = ring_path(std::slice::from_ref(view), 1.0, 0.01);
            assert!(ring.closed && shown(&ring, view).iter().all(|half| (half - 1.0).abs() < 1e-3));
        }
        let back = View::orthographic("back", std::f64::consts::PI, 0.0, 2.2, 64);
        for seen in [&views[..2], &views, &[views[0].clone(), back]] {
            let ring = ring_path(seen, 1.0, 0.01);
            for view in seen {
                assert!(shown(&ring, view).iter().all(|&half| half > 0.57), "{:?}", shown(&ring, view));
            }
        }
    }
}
