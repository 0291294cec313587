//! The wire at its true size, as the round cones that a printer or a jig has to do with.

use glam::DVec3;
use wire4d_core::wire::Wire;
use wire4d_core::{Error, Result};

/// Smaller than that nothing can be told apart; mm.
pub const MIN_SIZE_MM: f64 = 10.0;
/// Larger than that no jig and no printer is; mm.
pub const MAX_SIZE_MM: f64 = 5000.0;
/// What a usual nozzle lays down; thinner wire is not printed. mm.
pub const MIN_GAUGE_MM: f64 = 0.4;
/// Thicker wire is a rod; mm.
pub const MAX_GAUGE_MM: f64 = 50.0;

/// Samples before thinning, about, and how many a knot span has.
const SAMPLES: usize = 8000;
const SAMPLES_PER_SPAN: [usize; 2] = [8, 64];
/// How far a chord may leave the curve, as a share of the wire's radius.
pub(crate) const CHORD_SHARE: f64 = 0.015;

/// How thick the wire is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gauge {
    /// The same everywhere; mm.
    Constant(f64),
    /// As thick as the wire is on the screen, but nowhere thinner than this; mm.
    Own {
        /// The least thickness.
        least_mm: f64,
    },
}

/// The hull of two balls; mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cone {
    pub ends: [DVec3; 2],
    pub radii: [f64; 2],
}

impl Cone {
    /// How far `place` is outside, negative inside: exact for the hull of two balls. Beyond the mantle's rims the nearer
    /// ball counts, and only that where one ball holds the other. (I. Quílez, "Distance functions", round cone.)
    pub fn distance(&self, place: DVec3) -> f64 {
        let [a, b] = self.ends;
        let [ra, rb] = self.radii;
        let (axis, from) = (b - a, place - a);
        let taper = ra - rb;
        let length2 = axis.length_squared();
        let mantle2 = length2 - taper * taper;
        let balls = || (from.length() - ra).min((place - b).length() - rb);
        if mantle2 <= 1e-12 {
            return balls();
        }
        let ahead = from.dot(axis) / length2;
        let aside = (from - axis * ahead).length();
        // Along the axis to where the mantle's normal through the place meets it.
        let foot = ahead - aside * taper / (mantle2.sqrt() * length2.sqrt());
        if foot <= 0.0 {
            from.length() - ra
        } else if foot >= 1.0 {
            (place - b).length() - rb
        } else {
            let length = length2.sqrt();
            (aside * mantle2.sqrt() + ahead * length * taper) / length - ra
        }
    }

    /// Corners of the box round it.
    pub fn bounds(&self) -> [DVec3; 2] {
        let [a, b] = self.ends;
        let [r, s] = self.radii.map(DVec3::splat);
        [(a - r).min(b - s), (a + r).max(b + s)]
    }
}

/// A wire in millimetres, standing on the bed (its lowest point has z = 0, and the middle of its box is above the origin).
#[derive(Debug, Clone)]
pub struct Strands {
    pub(crate) cones: Vec<Cone>,
    pub(crate) least_radius_mm: f64,
}

impl Strands {
    /// The longest side of the box round the wire's middle is `size_mm` long.
    ///
    /// # Errors
    /// [`Error::Setting`] for a size or gauge that cannot be made, [`Error::Wire`] for a wire without length.
    pub fn new(wire: &Wire, size_mm: f64, gauge: Gauge) -> Result<Strands> {
        let least_mm = match gauge {
            Gauge::Constant(mm) | Gauge::Own { least_mm: mm } => mm,
        };
        check("--size-mm", size_mm, [MIN_SIZE_MM, MAX_SIZE_MM], "give the longest side as")?;
        check("--wire-mm", least_mm, [MIN_GAUGE_MM, MAX_GAUGE_MM], "a usual nozzle lays down 0.4 mm: give")?;
        let [fewest, most] = SAMPLES_PER_SPAN;
        let (map, strokes) =
            wire.sampling_map::<f64>((SAMPLES / wire.spans().count().max(1)).clamp(fewest, most), false);
        let mut samples = Vec::new();
        map.apply(wire.control_points(), &mut samples);
        // What is up in the world is up on the bed.
        let place = |p: &[f64; 4]| DVec3::new(p[0], -p[2], p[1]);
        let low = samples.iter().map(place).reduce(DVec3::min).unwrap_or_default();
        let high = samples.iter().map(place).reduce(DVec3::max).unwrap_or_default();
        let longest = (high - low).max_element();
        if longest <= 1e-9 {
            return Err(Error::wire("wire", "all of it lies in one place", "open another wire"));
        }
        let scale = size_mm / longest;
        let middle = (0.5 * (low + high)).with_z(low.z);
        let ball = |p: &[f64; 4]| {
            let radius = match gauge {
                Gauge::Constant(mm) => 0.5 * mm,
                Gauge::Own { least_mm } => (0.5 * p[3] * scale).max(0.5 * least_mm),
            };
            ((place(p) - middle) * scale, radius)
        };
        let mut cones = Vec::new();
        for stroke in &strokes {
            let mut balls: Vec<_> = samples[stroke.start..stroke.start + stroke.count].iter().map(ball).collect();
            if stroke.closed {
                balls.push(balls[0]);
            }
            cones.extend(
                thinned(&balls)
                    .windows(2)
                    .map(|pair| Cone { ends: [pair[0].0, pair[1].0], radii: [pair[0].1, pair[1].1] }),
            );
        }
        let least_radius_mm = cones.iter().flat_map(|cone| cone.radii).fold(f64::INFINITY, f64::min);
        let sunk = cones.iter().map(|cone| cone.bounds()[0].z).fold(f64::INFINITY, f64::min);
        for cone in &mut cones {
            cone.ends.iter_mut().for_each(|end| end.z -= sunk);
        }
        Ok(Strands { cones, least_radius_mm })
    }

    /// The thinnest place, mm.
    pub fn least_thickness_mm(&self) -> f64 {
        2.0 * self.least_radius_mm
    }

    /// Corners of the box round all of it, mm.
    pub fn bounds(&self) -> [DVec3; 2] {
        let each = self.cones.iter().map(Cone::bounds);
        each.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or_default()
    }

    /// Surface if no strand met another, mm².
    pub(crate) fn area_mm2(&self) -> f64 {
        let sides = self.cones.iter().map(|cone| cone.ends[0].distance(cone.ends[1]) * (cone.radii[0] + cone.radii[1]));
        std::f64::consts::PI * sides.sum::<f64>()
    }
}

fn check(name: &str, given: f64, [least, most]: [f64; 2], remedy: &str) -> Result<()> {
    if (least..=most).contains(&given) {
        return Ok(());
    }
    Err(Error::setting(name, format!("{given} mm cannot be printed"), format!("{remedy} {least} to {most} mm")))
}

/// Greedily leaves out balls that the hull of their neighbours stands for.
fn thinned(balls: &[(DVec3, f64)]) -> Vec<(DVec3, f64)> {
    /// Bounds the work.
    const MOST: usize = 32;
    let fits = |from: usize, to: usize| {
        let (a, b) = (balls[from], balls[to]);
        let axis = b.0 - a.0;
        (from + 1..to).all(|i| {
            let share = (balls[i].0 - a.0).dot(axis) / axis.length_squared();
            let off = (a.0 + axis * share).distance(balls[i].0);
            let thicker = (a.1 + (b.1 - a.1) * share - balls[i].1).abs();
            (0.0..=1.0).contains(&share) && off.max(thicker) <= CHORD_SHARE * balls[i].1
        })
    };
    let mut kept = vec![balls[0]];
    let mut from = 0;
    while from + 1 < balls.len() {
        let mut to = from + 1;
        while to + 1 < balls.len() && to - from < MOST && fits(from, to + 1) {
            to += 1;
        }
        kept.push(balls[to]);
        from = to;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;
    use wire4d_core::rng::Rng;

    #[test]
    fn distance_is_that_to_the_nearest_ball_of_the_hull() {
        let mut rng = Rng::new(3, 1);
        for _ in 0..300 {
            let mut place = |size: f64| DVec3::from_array(rng.in_ball(size));
            let cone = Cone { ends: [place(1.0), place(1.0)], radii: [0.1 + 0.5 * place(1.0).x.abs(), 0.2] };
            let from = place(3.0);
            let ball = |i: usize| {
                let s = i as f64 / 4000.0;
                let [a, b] = cone.ends;
                a.lerp(b, s).distance(from) - (cone.radii[0] + (cone.radii[1] - cone.radii[0]) * s)
            };
            let nearest = (0..=4000).map(ball).fold(f64::INFINITY, f64::min);
            assert!((cone.distance(from) - nearest).abs() < 1e-4, "{cone:?} {from}");
        }
    }
}
