//! Polygons are cut into triangles.

use super::Soup;
use glam::{DVec2, DVec3};

/// Most corners of a polygon that is cut ear by ear, which takes time with their square.
const MOST_CORNERS: usize = 2000;

impl Soup {
    /// Adds a polygon as triangles: along the shorter diagonal that keeps both on one side if it has four corners, as a
    /// fan if it has more and is convex, else ear by ear. Of equal choices, that of the lowest corner is taken: a polygon
    /// that is there twice, however listed, is cut into the same triangles.
    pub(super) fn add_polygon(&mut self, corners: &[u32]) {
        let mut corners = corners.to_vec();
        let first = self.triangles.len();
        let mut turned = false;
        if corners.len() > 4 {
            let lowest = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(lowest);
            turned = corners[1] > corners[corners.len() - 1];
            if turned {
                corners[1..].reverse();
            }
        }
        let points: Option<Vec<DVec3>> =
            corners.iter().map(|&corner| self.positions.get(corner as usize).map(|&p| p.into())).collect();
        match points.as_deref() {
            Some(&[a, b, c, d]) => {
                let bends = |x: DVec3, y: DVec3, z: DVec3, w: DVec3| (y - x).cross(z - x).dot((z - x).cross(w - x));
                let (ac, bd) = (bends(a, b, c, d) > 0.0, bends(b, c, d, a) > 0.0);
                let (length, other) = (a.distance_squared(c), b.distance_squared(d));
                let lower = corners[1].min(corners[3]) < corners[0].min(corners[2]);
                let shorter = other < length || other == length && lower;
                let along_bd = if ac == bd { shorter } else { bd };
                if along_bd {
                    corners.rotate_left(1);
                }
            }
            Some(points) if (5..=MOST_CORNERS).contains(&points.len()) => self.cut_ears(&mut corners, points),
            _ => {}
        }
        for pair in corners.windows(2).skip(1) {
            self.triangles.push([corners[0], pair[0], pair[1]]);
        }
        if turned {
            self.triangles[first..].iter_mut().for_each(|triangle| triangle.swap(1, 2));
        }
    }

    /// Cuts ears off a polygon that is not convex, the best shaped first, until a triangle is left; or more, if it
    /// crosses itself.
    fn cut_ears(&mut self, corners: &mut Vec<u32>, points: &[DVec3]) {
        // Newell's normal: all sides count, whatever turn a single corner takes.
        let normal: DVec3 = points.windows(2).map(|pair| (pair[0] - points[0]).cross(pair[1] - points[0])).sum();
        let Some(normal) = normal.try_normalize() else { return };
        let (u, v) = normal.any_orthonormal_pair();
        let mut flat: Vec<DVec2> =
            points.iter().map(|&p| p - points[0]).map(|p| DVec2::new(p.dot(u), p.dot(v))).collect();
        // A flat corner would make a triangle without an area in a fan.
        if (0..flat.len()).all(|i| shape(tip(&flat, i)) > 1e-6) {
            return;
        }
        let mut ears: Vec<f64> = (0..flat.len()).map(|i| ear(&flat, i)).collect();
        while corners.len() > 3 {
            let count = corners.len();
            let best = (1..count).fold(0, |best, i| if ears[i] > ears[best] { i } else { best });
            if ears[best] <= 0.0 {
                return;
            }
            self.triangles.push([corners[(best + count - 1) % count], corners[best], corners[(best + 1) % count]]);
            corners.remove(best);
            flat.remove(best);
            ears.remove(best);
            for i in [(best + count - 2) % (count - 1), best % (count - 1)] {
                ears[i] = ear(&flat, i);
            }
        }
    }
}

/// A corner between its neighbours.
fn tip(polygon: &[DVec2], i: usize) -> [DVec2; 3] {
    let count = polygon.len();
    [polygon[(i + count - 1) % count], polygon[i], polygon[(i + 1) % count]]
}

/// Twice a triangle's area over its squared sides: most if all are alike, below zero if it turns the other way.
fn shape([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - b) / (a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a))
}

/// The shape of the triangle that would be cut off at a corner; 0 if none can, as it turns inward or something is in it.
fn ear(polygon: &[DVec2], i: usize) -> f64 {
    let [a, b, c] = tip(polygon, i);
    let shape = shape([a, b, c]);
    let in_it = |&p: &DVec2| {
        let left_of = |from: DVec2, to: DVec2| (to - from).perp_dot(p - from) >= 0.0;
        // Where a double edge leads to a hole, other corners lie in the same place.
        left_of(c, a) && left_of(a, b) && left_of(b, c) && p != a && p != b && p != c
    };
    if shape > 0.0 && !polygon.iter().any(in_it) { shape } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    /// The polygon's triangles, and the area that they turn to where it looks: sum and least.
    fn cut(points: &[DVec3], corners: &[u32], look: DVec3) -> (Vec<[u32; 3]>, f64, f64) {
        let mut soup = Soup { positions: points.iter().map(|p| p.to_array()).collect(), ..Soup::default() };
        soup.add_polygon(corners);
        let areas: Vec<f64> = soup
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|corner| points[corner as usize]);
                0.5 * (b - a).cross(c - a).dot(look)
            })
            .collect();
        (soup.triangles, areas.iter().sum(), areas.iter().copied().fold(f64::INFINITY, f64::min))
    }

    fn in_plane(flat: &[[f64; 2]], u: DVec3, v: DVec3) -> Vec<DVec3> {
        flat.iter().map(|p| DVec3::new(3.0, -2.0, 7.0) + p[0] * u + p[1] * v).collect()
    }

    /// All ways to list the same polygon.
    fn listings(count: u32) -> impl Iterator<Item = Vec<u32>> {
        (0..2 * count).map(move |i| {
            let mut corners: Vec<u32> = (0..count).collect();
            corners.rotate_left((i / 2) as usize);
            if i % 2 == 1 {
                corners.reverse();
            }
            corners
        })
    }

    #[test]
    fn concave_polygons_keep_their_shape() {
        let l = &[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]][..];
        let u = &[[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [2.0, 3.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]][..];
        // A square with corners on its sides.
        let flat = &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0], [0.0, 0.5]][..];
        // A square with a square hole, which a double edge leads to.
        let hole = [
            [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0], [0.0, 0.0]],
            [[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]],
        ]
        .concat();
        let u_axis = DVec3::new(0.2, 0.9, -0.4).normalize();
        let (v_axis, look) = u_axis.any_orthonormal_pair();
        for (shape, area) in [(l, 6.0), (u, 7.0), (flat, 4.0), (&hole[..], 8.0)] {
            for (u, v, look) in [(DVec3::X, DVec3::Y, DVec3::Z), (u_axis, v_axis, look)] {
                let points = in_plane(shape, u, v);
                for (i, corners) in listings(points.len() as u32).enumerate() {
                    let (triangles, sum, least) = cut(&points, &corners, if i % 2 == 1 { -look } else { look });
                    assert_eq!(triangles.len(), points.len() - 2);
                    assert!((sum - area).abs() < 1e-9 && least > 1e-3, "{area}, {corners:?}: {sum}, {least}");
                }
            }
        }
    }

    #[test]
    fn any_star_and_a_long_comb_keep_their_shape() {
        let mut rng = Rng::new(5, 5);
        for count in 5..60 {
            let star: Vec<[f64; 2]> = (0..count)
                .map(|i| {
                    let (angle, radius) =
                        (std::f64::consts::TAU * f64::from(i) / f64::from(count), rng.range(0.2, 1.0));
                    [radius * angle.cos(), radius * angle.sin()]
                })
                .collect();
            let area: f64 = (0..star.len())
                .map(|i| (star[i], star[(i + 1) % star.len()]))
                .map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0]))
                .sum();
            let corners: Vec<u32> = (0..star.len() as u32).collect();
            let (triangles, sum, least) = cut(&in_plane(&star, DVec3::Z, DVec3::X), &corners, DVec3::Y);
            assert_eq!(triangles.len(), star.len() - 2);
            assert!((sum - area).abs() < 1e-9 && least > -1e-12, "{count}: {sum} of {area}, {least}");
        }
        let teeth = 400;
        let mut comb = vec![[f64::from(teeth), -1.0], [f64::from(teeth), 0.0]];
        for i in (0..teeth).rev().map(f64::from) {
            comb.extend([[i + 0.7, 0.0], [i + 0.6, 50.0], [i + 0.3, 50.0], [i + 0.2, 0.0]]);
        }
        comb.extend([[0.0, 0.0], [0.0, -1.0]]);
        let corners: Vec<u32> = (0..comb.len() as u32).collect();
        let (_, sum, least) = cut(&in_plane(&comb, DVec3::X, DVec3::Y), &corners, DVec3::Z);
        let area = f64::from(teeth) * (1.0 + 50.0 * 0.4);
        assert!((sum - area).abs() < 1e-6 && least > -1e-9, "{sum} of {area}, {least}");
    }

    #[test]
    fn the_same_face_is_cut_the_same_way() {
        let round = |count: u32| -> Vec<DVec3> {
            (0..count)
                .map(|i| DVec2::from_angle(0.3 + f64::from(i) / f64::from(count) * std::f64::consts::TAU).extend(1.0))
                .collect()
        };
        let rectangle = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
        let cross = [1.0, 4.0, 1.0, 1.0].repeat(3);
        let cross: Vec<DVec3> =
            cross.iter().zip(round(12)).map(|(&far, point)| (far * point.truncate()).extend(1.0)).collect();
        for points in [in_plane(&rectangle, DVec3::Y, DVec3::Z), round(4), round(7), cross] {
            let sorted = |corners: Vec<u32>| {
                let mut triangles = cut(&points, &corners, DVec3::Z).0;
                triangles.iter_mut().for_each(|t| t.sort_unstable());
                triangles.sort_unstable();
                triangles
            };
            let count = points.len() as u32;
            let first = sorted((0..count).collect());
            assert!(listings(count).all(|corners| sorted(corners) == first), "{points:?}");
        }
    }

    #[test]
    fn no_polygon_is_too_odd() {
        let point = [DVec3::splat(0.1); 6];
        let star = [0.0, 2.0, 4.0, 1.0, 3.0].map(|i| DVec2::from_angle(i * 1.256_637).extend(0.0));
        let huge =
            [[1.0, 0.0], [0.0, 1.0], [0.1, 0.0], [0.0, -1.0], [-1.0, 0.0]].map(|p| DVec3::new(p[0], p[1], 0.0) * 1e300);
        let line: Vec<DVec3> = (0..7).map(|i| DVec3::splat(f64::from(i * i % 5))).collect();
        for points in [&point[..], &star, &huge, &line, &[DVec3::NAN; 5]] {
            let corners: Vec<u32> = (0..points.len() as u32).collect();
            assert_eq!(cut(points, &corners, DVec3::Z).0.len(), points.len() - 2);
        }
        for corners in [&[][..], &[0], &[0, 1], &[0, 1, 99, 2, 3, 4], &[0, 99, 1, 2], &[0, 0, 0, 0, 0]] {
            assert_eq!(cut_only(corners), corners.len().saturating_sub(2));
        }
    }

    fn cut_only(corners: &[u32]) -> usize {
        let mut soup = Soup { positions: vec![[0.0; 3]; 6], ..Soup::default() };
        soup.add_polygon(corners);
        soup.triangles.len()
    }
}
