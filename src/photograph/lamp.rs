//! Lamps: a round disc that looks at a place, with a beam like a theatre's. Small and far, it throws sharp shadows; as a point at
//! any distance, exactly what a camera at its place would see.

use glam::{Vec3, Vec3A};
use std::f32::consts::TAU;

/// A lamp. Lengths in world units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamp {
    /// The disc's middle.
    pub place: Vec3A,
    /// What it looks at.
    pub aim: Vec3A,
    /// The disc's radius; 0 is a point.
    pub radius: f32,
    /// How far from its axis it shines, where it aims.
    pub beam: f32,
    /// Light a square unit that falls straight on a surface where it aims.
    pub light: Vec3,
}

/// Share of the beam's radius over which it fades.
const FADE: f32 = 0.6;

/// Light on its way to a place.
#[derive(Debug, Clone, Copy)]
pub struct Shine {
    /// To the lamp, of length 1, and how far it is.
    pub to_lamp: Vec3A,
    /// How far the lamp's place is.
    pub distance: f32,
    /// What would fall straight on a surface, a square unit.
    pub light: Vec3,
}

impl Lamp {
    /// Light from one of the disc's places to `place`; `None` outside its beam. `numbers` in [0, 1) choose the place evenly.
    pub fn shine(&self, place: Vec3A, numbers: [f32; 2]) -> Option<Shine> {
        let axis = self.aim - self.place;
        let far = axis.length();
        let axis = axis / far;
        let from_middle = place - self.place;
        let ahead = from_middle.dot(axis);
        if ahead <= 0.0 {
            return None;
        }
        let off = (from_middle - ahead * axis).length() * far / ahead;
        let inside = ((self.beam - off) / (FADE * self.beam)).clamp(0.0, 1.0);
        if inside <= 0.0 {
            return None;
        }
        let ((sin, cos), out) = ((TAU * numbers[1]).sin_cos(), self.radius * numbers[0].sqrt());
        let (across, up) = axis.any_orthonormal_pair();
        let way = self.place + out * (cos * across + sin * up) - place;
        let distance = way.length();
        let to_lamp = way / distance;
        // A disc fades with the cosine; a point does not, or it would not be one.
        let facing = if self.radius > 0.0 { -to_lamp.dot(axis) } else { 1.0 };
        let fade = inside * inside * (3.0 - 2.0 * inside);
        let light = self.light * (fade * facing.max(0.0) * (far / distance).powi(2));
        Some(Shine { to_lamp, distance, light })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAMP: Lamp =
        Lamp { place: Vec3A::new(0.0, 0.0, 5.0), aim: Vec3A::ZERO, radius: 0.0, beam: 1.5, light: Vec3::ONE };

    #[test]
    fn light_falls_with_the_square_of_the_way_and_ends_with_the_beam() {
        let at = |place| LAMP.shine(place, [0.3, 0.7]);
        let straight = at(Vec3A::ZERO).unwrap();
        assert!(straight.light.abs_diff_eq(Vec3::ONE, 1e-6) && straight.to_lamp.abs_diff_eq(Vec3A::Z, 1e-6));
        assert!(at(Vec3A::new(0.0, 0.0, -5.0)).unwrap().light.abs_diff_eq(Vec3::splat(0.25), 1e-6));
        assert!(at(Vec3A::new(1.6, 0.0, 0.0)).is_none() && at(Vec3A::new(0.0, 0.0, 6.0)).is_none());
        let rim = at(Vec3A::new(1.42, 0.0, 0.0)).unwrap().light.x;
        assert!(0.0 < rim && rim < 0.6, "{rim}");
    }

    #[test]
    fn a_disc_sends_on_the_mean_what_a_point_does() {
        let disc = Lamp { radius: 0.2, ..LAMP };
        let mean = |lamp: &Lamp| {
            let each = (0..1024).map(|i| {
                lamp.shine(Vec3A::new(0.2, 0.1, 0.0), [(i % 32) as f32 / 32.0, (i / 32) as f32 / 32.0]).unwrap().light.x
            });
            each.sum::<f32>() / 1024.0
        };
        assert!((mean(&disc) / mean(&LAMP) - 1.0).abs() < 0.01, "{} {}", mean(&disc), mean(&LAMP));
    }
}
