//! A stroke of wire: the hull of two balls. Where a ray enters it is known in closed form.

use glam::Vec3A;

/// The hull of two balls, world units.
#[derive(Debug, Clone, Copy)]
pub struct Cone {
    /// Their middles.
    pub ends: [Vec3A; 2],
    /// Their radii, from 0.
    pub radii: [f32; 2],
}

/// Where a ray enters something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Entry {
    /// From the ray's origin, in its direction's lengths.
    pub distance: f32,
    /// Outward, of length 1.
    pub normal: Vec3A,
}

impl Cone {
    /// Lowest and highest corner of the box round it.
    pub fn bounds(&self) -> [Vec3A; 2] {
        let [a, b] = self.ends;
        let [r, s] = self.radii.map(Vec3A::splat);
        [(a - r).min(b - s), (a + r).max(b + s)]
    }

    /// Where a ray of direction `along` (length 1) from `origin` enters it in front of the origin.
    ///
    /// With a the first ball's middle, A its radius, d the way to the second one, δ = A less the other radius, q = p − a and
    /// s = |d|² − δ²: places p of the mantle have s |q|² = (q·d)² − 2 δA (q·d) + |d|² A² and 0 < q·d − δA < s. So where a ray
    /// enters it is the root of a quadratic, and beyond the mantle's rims there are balls.
    pub fn entry(&self, origin: Vec3A, along: Vec3A) -> Option<Entry> {
        let [a, b] = self.ends;
        let [ra, rb] = self.radii;
        // From the ray's nearest place, since squares of long ways drown a thin wire.
        let near = (0.5 * (a + b) - origin).dot(along);
        let from = origin + near * along;
        let (axis, from_a, from_b) = (b - a, from - a, from - b);
        let taper = ra - rb;
        let spread = axis.length_squared() - taper * taper;
        if spread > 0.0 {
            let (ahead, advance) = (axis.dot(from_a), axis.dot(along));
            let square = spread - advance * advance;
            let half = spread * along.dot(from_a) - ahead * advance + advance * taper * ra;
            let rest = spread * from_a.length_squared() - ahead * ahead + 2.0 * ahead * taper * ra
                - axis.length_squared() * ra * ra;
            let under = half * half - rest * square;
            if under < 0.0 && square > 0.0 {
                // Whoever passes by the endless cone passes by both balls.
                return None;
            }
            // Steeper than the mantle (a negative square), the same root is where it comes in from the tip's side.
            if under >= 0.0 && square != 0.0 {
                let t = (-half - under.sqrt()) / square;
                let place = ahead - ra * taper + t * advance;
                if place > 0.0 && place < spread {
                    let normal = (spread * (from_a + t * along) - axis * place).normalize();
                    return entering(near + t, normal);
                }
            }
        }
        let ball = |from: Vec3A, radius: f32| {
            let middle = from.dot(along);
            let under = middle * middle - from.length_squared() + radius * radius;
            (under > 0.0 && radius > 0.0).then(|| {
                let t = -middle - under.sqrt();
                (t, (from + t * along) / radius)
            })
        };
        let first = match (ball(from_a, ra), ball(from_b, rb)) {
            (Some(a), Some(b)) => Some(if a.0 < b.0 { a } else { b }),
            (a, b) => a.or(b),
        };
        first.and_then(|(t, normal)| entering(near + t, normal))
    }
}

fn entering(distance: f32, normal: Vec3A) -> Option<Entry> {
    (distance > 0.0).then_some(Entry { distance, normal })
}

#[cfg(test)]
mod tests {
    use super::*;
    use wire4d_core::rng::Rng;

    /// How far a place is outside the hull; negative inside (the distance to the nearest ball of the row between the ends).
    fn outside(cone: &Cone, place: Vec3A) -> f32 {
        let ball = |t: f32| {
            let middle = cone.ends[0].lerp(cone.ends[1], t);
            (place - middle).length() - (cone.radii[0] + t * (cone.radii[1] - cone.radii[0]))
        };
        // Distance less radius is convex along the row.
        let (mut low, mut high) = (0.0f32, 1.0f32);
        for _ in 0..60 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if ball(a) < ball(b) { high = b } else { low = a }
        }
        ball(0.5 * (low + high)).min(ball(0.0)).min(ball(1.0))
    }

    #[test]
    fn rays_enter_where_the_hull_begins_and_miss_it_where_it_is_not() {
        let mut rng = Rng::new(3, 1);
        let mut place = |size: f64| Vec3A::from_array(rng.in_ball(size).map(|c| c as f32));
        let mut hits = 0;
        for i in 0..4000 {
            let radii = [[0.02, 0.05], [0.05, 0.05], [0.3, 0.01], [0.04, 0.0]][i % 4];
            let cone = Cone { ends: [place(0.3), place(0.3)], radii };
            let origin = 4.0 * place(1.0).normalize();
            let along = (place(0.35) - origin).normalize();
            let least =
                (0..=4000).map(|k| outside(&cone, origin + (3.0 + k as f32 / 2000.0) * along)).fold(9.0, f32::min);
            match cone.entry(origin, along) {
                Some(Entry { distance, normal }) => {
                    hits += 1;
                    let at = origin + distance * along;
                    assert!(outside(&cone, at).abs() < 2e-4, "{cone:?}: {}", outside(&cone, at));
                    assert!(normal.dot(along) < 1e-3 && (normal.length() - 1.0).abs() < 1e-4);
                    let step = 1e-3;
                    let climb = (outside(&cone, at + step * normal) - outside(&cone, at)) / step;
                    assert!((climb - 1.0).abs() < 0.15, "the normal leads straight away: {climb}");
                    let before = (1..200).map(|k| outside(&cone, at - 0.01 * k as f32 * along)).fold(9.0, f32::min);
                    assert!(before > -2e-4, "nothing was entered before: {before}");
                }
                None => assert!(least > -1e-3, "{cone:?} was missed by {least}"),
            }
        }
        assert!(hits > 300, "{hits}");
    }

    #[test]
    fn who_starts_inside_or_behind_enters_nothing() {
        let cone = Cone { ends: [Vec3A::ZERO, Vec3A::X], radii: [0.2, 0.1] };
        assert_eq!(cone.entry(Vec3A::new(0.5, 0.0, 0.0), Vec3A::Y), None);
        assert_eq!(cone.entry(Vec3A::new(0.5, 1.0, 0.0), Vec3A::Y), None);
        let end_on = cone.entry(Vec3A::new(-1.0, 0.0, 0.0), Vec3A::X).expect("along the axis it enters the first ball");
        assert!((end_on.distance - 0.8).abs() < 1e-5 && end_on.normal.abs_diff_eq(-Vec3A::X, 1e-5));
    }
}
