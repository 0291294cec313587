//! Points on a triangle.

use glam::DVec3;

/// The point of the triangle (0, u, v) nearest to `p`, by its coordinates in (u, v) and as itself: the foot of the
/// perpendicular if that is inside, else the nearest point of the nearest edge.
pub fn nearest_on_triangle(p: DVec3, [u, v]: [DVec3; 2]) -> ([f64; 2], DVec3) {
    let (uu, uv, vv) = (u.length_squared(), u.dot(v), v.length_squared());
    let (pu, pv) = (p.dot(u), p.dot(v));
    // Coordinates of the foot in (u, v), times the determinant of the normal equations.
    let determinant = uu * vv - uv * uv;
    let (s, t) = (vv * pu - uv * pv, uu * pv - uv * pu);
    // A needle's normal equations say nothing: its edges do.
    if determinant > 1e-12 * uu * vv && s >= 0.0 && t >= 0.0 && s + t <= determinant {
        return ([s / determinant, t / determinant], (s * u + t * v) / determinant);
    }
    let on_edge = |from: DVec3, along: DVec3| {
        let length = along.length_squared();
        let share = if length > 0.0 { ((p - from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        (share, from + share * along)
    };
    let (share, point) = on_edge(DVec3::ZERO, u);
    let mut best = ([share, 0.0], point);
    let (on_v, across) = (on_edge(DVec3::ZERO, v), on_edge(u, v - u));
    for other in [([0.0, on_v.0], on_v.1), ([1.0 - across.0, across.0], across.1)] {
        if other.1.distance_squared(p) < best.1.distance_squared(p) {
            best = other;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn a_triangles_nearest_point_beats_a_fine_grid() {
        let mut rng = Rng::new(2, 5);
        for round in 0..200 {
            let mut random = || DVec3::from(rng.in_ball(1.0));
            let (u, mut v, p) = (random(), random(), 2.0 * random());
            if round % 10 == 0 {
                v = 0.3 * u;
            }
            let ([s, t], point) = nearest_on_triangle(p, [u, v]);
            let found = point.distance(p);
            assert!(s >= 0.0 && t >= 0.0 && s + t < 1.0 + 1e-12 && (s * u + t * v).distance(point) < 1e-9);
            let mut grid = f64::INFINITY;
            for i in 0..=40 {
                for j in 0..=40 - i {
                    grid = grid.min((f64::from(i) / 40.0 * u + f64::from(j) / 40.0 * v).distance(p));
                }
            }
            assert!(found <= grid + 1e-12 && found > grid - 0.05, "{found} {grid}");
        }
    }
}
