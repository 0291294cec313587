//! The camera that takes the picture: a thin lens.

use crate::setting::Place;
use glam::Vec3A;
use std::f32::consts::TAU;
use wire4d_core::{Error, Result};

/// Where the camera is and what it does. Angles in degrees, lengths in world units.
#[derive(Debug, Clone, PartialEq)]
pub struct Lens {
    /// Round the wire: 0 is the front, 90 the side.
    pub azimuth: f32,
    /// Above it.
    pub elevation: f32,
    /// What is in the picture's middle.
    pub aim: [f32; 3],
    /// From there, at least 2.
    pub distance: f32,
    /// The picture's height as an angle, 5 to 120.
    pub view_angle: f32,
    /// Radius of the lens; 0 is sharp everywhere, more is sharp at `aim` alone.
    pub aperture: f32,
}

impl Default for Lens {
    fn default() -> Lens {
        Lens {
            azimuth: 42.0,
            elevation: 28.0,
            aim: [-0.32, -0.34, -0.32],
            distance: 6.6,
            view_angle: 26.0,
            aperture: 0.0,
        }
    }
}

impl Lens {
    /// One that sees all of a place, whose walls or screens are `away` from the middle, from where its shadows are seen.
    pub fn of(place: Place, away: f32) -> Lens {
        match place {
            Place::Room => Lens::default(),
            Place::Studio => Lens { aim: [0.0, -0.2, 0.0], distance: 5.4, elevation: 20.0, ..Lens::default() },
            Place::Screens => Lens { aim: [0.0; 3], distance: 2.6 + 3.9 * away, ..Lens::default() },
        }
    }
}

/// A lens at work on a picture of some size.
pub(crate) struct Camera {
    eye: Vec3A,
    right: Vec3A,
    up: Vec3A,
    forward: Vec3A,
    distance: f32,
    /// World units at the aim's distance from the picture's middle to its upper border.
    half: f32,
    aperture: f32,
    size: [f32; 2],
}

impl Camera {
    pub fn new(lens: &Lens, [width, height]: [usize; 2]) -> Result<Camera> {
        let Lens { azimuth, elevation, aim, distance, view_angle, aperture } = lens;
        let refuse = |name: &str, remedy: &str| Err(Error::setting(name, "is out of range", remedy));
        if ![*azimuth, *elevation, aim[0], aim[1], aim[2]].iter().all(|value| value.is_finite()) {
            return refuse("camera", "give numbers");
        }
        if !(2.0..=1000.0).contains(distance) {
            return refuse("camera-distance", "give 2 to 1000");
        }
        if !(5.0..=120.0).contains(view_angle) {
            return refuse("view-angle", "give 5 to 120 degrees");
        }
        if !(0.0..=1.0).contains(aperture) {
            return refuse("aperture", "give 0 to 1");
        }
        let ((sin_a, cos_a), (sin_e, cos_e)) = (azimuth.to_radians().sin_cos(), elevation.to_radians().sin_cos());
        let back = Vec3A::new(sin_a * cos_e, sin_e, cos_a * cos_e);
        let up = Vec3A::new(-sin_a * sin_e, cos_e, -cos_a * sin_e);
        Ok(Camera {
            eye: Vec3A::from_array(*aim) + *distance * back,
            right: up.cross(back),
            up,
            forward: -back,
            distance: *distance,
            half: distance * (0.5 * view_angle).to_radians().tan(),
            aperture: *aperture,
            size: [width as f32, height as f32],
        })
    }

    /// A ray into the picture at a place in pixels from its upper left corner: origin and direction, of length 1.
    pub fn ray(&self, [x, y]: [f32; 2], lens: [f32; 2]) -> [Vec3A; 2] {
        let [width, height] = self.size;
        let scale = 2.0 * self.half / height;
        let sharp =
            self.distance * self.forward + scale * ((x - 0.5 * width) * self.right + (0.5 * height - y) * self.up);
        let ((sin, cos), out) = ((TAU * lens[1]).sin_cos(), self.aperture * lens[0].sqrt());
        let off = out * (cos * self.right + sin * self.up);
        [self.eye + off, (sharp - off).normalize()]
    }
}
