//! What light does where it meets something: matte paper, or rough metal (GGX, Walter et al. 2007, its normals sampled as they are
//! seen: Dupuy and Benyoub 2023). Directions lead away from the surface, in its own frame: z is the normal.

use glam::{Vec3, Vec3A};
use std::f32::consts::{FRAC_1_PI, TAU};

/// What something is made of. Colours are linear, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there are a handful of them, and paths look them up")]
pub enum Matter {
    /// Reflects evenly (Lambert): this share of the light.
    Matte(Vec3),
    /// Reflects like a mirror with small facets: this share of the light where it comes straight down.
    Metal(Vec3, Rough),
}

/// How rough a metal is, with what its facets lose by hiding each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rough {
    /// GGX's width, the square of what artists call roughness.
    alpha: f32,
    /// Share of white light that comes back after one bounce, by the cosine of where it goes: what is missing would have bounced
    /// between facets (Turquin 2019).
    kept: [f32; KEPT],
}

/// Closer together at grazing angles, where it changes most.
const KEPT: usize = 65;
/// Nearer to the surface nothing is seen.
const LEAST_COS: f32 = 1e-3;
/// Of the grid over which `kept` is summed up.
const FINE: usize = 48;
/// Smoother than this, and a lamp's image is brighter than a picture can hold.
const LEAST_ALPHA: f32 = 0.01;

/// Where light goes on, and what is left of it.
#[derive(Debug, Clone, Copy)]
pub struct Bounce {
    /// Of length 1.
    pub along: Vec3A,
    /// Reflectance times cosine, over the density with which this direction was chosen.
    pub weight: Vec3,
}

impl Rough {
    /// For a roughness from 0 to 1.
    pub fn new(roughness: f32) -> Rough {
        let alpha = (roughness * roughness).max(LEAST_ALPHA);
        let mut rough = Rough { alpha, kept: [1.0; KEPT] };
        rough.kept = std::array::from_fn(|k| {
            let cos = (k as f32 / (KEPT - 1) as f32).powi(2).max(LEAST_COS);
            let to_eye = Vec3A::new((1.0 - cos * cos).sqrt(), 0.0, cos);
            let at = |i: usize| (i as f32 + 0.5) / FINE as f32;
            let sum: f32 = (0..FINE * FINE)
                .map(|i| {
                    let facet = rough.facet(to_eye, [at(i % FINE), at(i / FINE)]);
                    let along = reflected(to_eye, facet);
                    if along.z > 0.0 { rough.seen_too(to_eye, along) } else { 0.0 }
                })
                .sum();
            sum / (FINE * FINE) as f32
        });
        rough
    }

    /// A facet's normal as often as it is seen from `to_eye`.
    fn facet(&self, to_eye: Vec3A, [u, v]: [f32; 2]) -> Vec3A {
        let stretch = Vec3A::new(self.alpha, self.alpha, 1.0);
        let seen = (to_eye * stretch).normalize();
        let z = (1.0 - u) * (1.0 + seen.z) - seen.z;
        let (sin, cos) = (TAU * v).sin_cos();
        let flat = (1.0 - z * z).max(0.0).sqrt();
        let cap = Vec3A::new(flat * cos, flat * sin, z) + seen;
        (cap * stretch).normalize()
    }

    /// Smith's Λ.
    fn lambda(&self, along: Vec3A) -> f32 {
        let cos_squared = along.z * along.z;
        let tan_squared = ((1.0 - cos_squared) / cos_squared).max(0.0);
        0.5 * ((1.0 + self.alpha * self.alpha * tan_squared).sqrt() - 1.0)
    }

    /// Share of the facets that is seen from there.
    fn seen(&self, along: Vec3A) -> f32 {
        1.0 / (1.0 + self.lambda(along))
    }

    /// Share of the facets seen from one place that the other one sees as well, of what the first sees.
    fn seen_too(&self, first: Vec3A, second: Vec3A) -> f32 {
        let [first, second] = [self.lambda(first), self.lambda(second)];
        (1.0 + first) / (1.0 + first + second)
    }

    fn density(&self, facet: Vec3A) -> f32 {
        let squared = self.alpha * self.alpha;
        let base = facet.z * facet.z * (squared - 1.0) + 1.0;
        squared * FRAC_1_PI / (base * base)
    }

    fn kept(&self, cos: f32) -> f32 {
        let place = cos.clamp(0.0, 1.0).sqrt() * (KEPT - 1) as f32;
        let low = (place as usize).min(KEPT - 2);
        self.kept[low] + (place - low as f32) * (self.kept[low + 1] - self.kept[low])
    }

    /// Colour of one bounce that leaves towards `to_eye`, and of what would have bounced on.
    fn colour(&self, straight: Vec3, to_eye: Vec3A, facet: Vec3A) -> Vec3 {
        let off = (1.0 - to_eye.dot(facet)).clamp(0.0, 1.0).powi(5);
        let mirror = straight + (Vec3::ONE - straight) * off;
        mirror * (Vec3::ONE + straight * (1.0 / self.kept(to_eye.z) - 1.0))
    }
}

impl Matter {
    /// Reflectance times the cosine of `to_light`, for light from there that goes on `to_eye`.
    pub fn reflects(&self, to_eye: Vec3A, to_light: Vec3A) -> Vec3 {
        if to_eye.z <= 0.0 || to_light.z <= 0.0 {
            return Vec3::ZERO;
        }
        match self {
            Matter::Matte(colour) => *colour * FRAC_1_PI * to_light.z,
            Matter::Metal(colour, rough) => {
                let facet = (to_eye + to_light).normalize();
                let both = rough.seen(to_eye) * rough.seen_too(to_eye, to_light);
                rough.colour(*colour, to_eye, facet) * (rough.density(facet) * both / (4.0 * to_eye.z))
            }
        }
    }

    /// Where light that goes `to_eye` may have come from; `None` where it is lost.
    pub fn bounce(&self, to_eye: Vec3A, numbers: [f32; 2]) -> Option<Bounce> {
        if to_eye.z <= 0.0 {
            return None;
        }
        match self {
            Matter::Matte(colour) => {
                let [u, v] = numbers;
                let ((sin, cos), flat) = ((TAU * v).sin_cos(), u.sqrt());
                Some(Bounce { along: Vec3A::new(flat * cos, flat * sin, (1.0 - u).sqrt()), weight: *colour })
            }
            Matter::Metal(colour, rough) => {
                let facet = rough.facet(to_eye, numbers);
                let along = reflected(to_eye, facet);
                let weight = rough.colour(*colour, to_eye, facet) * rough.seen_too(to_eye, along);
                (along.z > 0.0).then_some(Bounce { along, weight })
            }
        }
    }
}

fn reflected(to_eye: Vec3A, facet: Vec3A) -> Vec3A {
    2.0 * to_eye.dot(facet) * facet - to_eye
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampler::Sampler;

    fn eye(cos: f32) -> Vec3A {
        Vec3A::new((1.0 - cos * cos).sqrt(), 0.0, cos)
    }

    /// Mean of what comes back of white light from everywhere.
    fn furnace(matter: &Matter, cos: f32) -> Vec3 {
        let bounce = |index| matter.bounce(eye(cos), Sampler::new(1, 2, index).pair()).map_or(Vec3::ZERO, |b| b.weight);
        (0..16_384).map(bounce).sum::<Vec3>() / 16_384.0
    }

    #[test]
    fn white_things_return_all_light_and_others_never_more() {
        let colours = [Vec3::ONE, Vec3::new(0.95, 0.64, 0.54), Vec3::splat(0.1)];
        for colour in colours {
            let metals = [0.1, 0.25, 0.5, 0.8, 1.0].map(|roughness| Matter::Metal(colour, Rough::new(roughness)));
            for matter in metals.into_iter().chain([Matter::Matte(colour)]) {
                for cos in [0.08, 0.3, 0.7, 1.0] {
                    let back = furnace(&matter, cos);
                    assert!(back.max_element() < 1.005, "{matter:?} {cos}: {back}");
                    assert!(colour != Vec3::ONE || back.min_element() > 0.995, "{matter:?} {cos}: {back}");
                }
            }
        }
    }

    #[test]
    fn bounces_go_where_reflectance_says() {
        // The mean of any function over bounces is its integral against the reflectance.
        let measures: [fn(Vec3A) -> f32; 3] = [|_| 1.0, |l| l.z, |l| (l.x + 1.0).powi(2)];
        let matters = [Matter::Matte(Vec3::ONE), Matter::Metal(Vec3::new(0.9, 0.6, 0.5), Rough::new(0.6))];
        for (matter, cos) in matters.iter().flat_map(|matter| [0.3, 0.9].map(|cos| (matter, cos))) {
            for measure in measures {
                let count = 65_536;
                let chosen: Vec3 = (0..count)
                    .filter_map(|index| matter.bounce(eye(cos), Sampler::new(3, 4, index).pair()))
                    .map(|bounce| bounce.weight * measure(bounce.along))
                    .sum::<Vec3>()
                    / count as f32;
                let evenly: Vec3 = (0..count)
                    .map(|index| {
                        let [u, v] = Sampler::new(5, 6, index).pair();
                        let ((sin, cos_v), flat) = ((TAU * v).sin_cos(), (1.0 - u * u).sqrt());
                        let along = Vec3A::new(flat * cos_v, flat * sin, u);
                        matter.reflects(eye(cos), along) * measure(along) * TAU
                    })
                    .sum::<Vec3>()
                    / count as f32;
                assert!(chosen.abs_diff_eq(evenly, 0.02 * evenly.max_element()), "{matter:?} {cos}: {chosen} {evenly}");
            }
        }
    }
}
