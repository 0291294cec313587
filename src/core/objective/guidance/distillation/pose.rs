//! How a view lies to another, as models that know new views of a thing ask for it.

use crate::view::Camera;

/// `[change of polar angle, sin and cos of the change of azimuth, polar angle of the reference]` of a view against the
/// reference's, radians: the camera embedding of Zero-1-to-3 (Liu et al. 2023) with the fourth number of Stable Zero123. Angles
/// are the directions' to the eyes, with y up.
pub fn relative_pose(reference: &Camera<f32>, view: &Camera<f32>) -> [f32; 4] {
    let angles = |camera: &Camera<f32>| {
        let [x, y, z] = [0, 1, 2].map(|axis| -f64::from(camera.forward[axis]));
        let length = (x * x + y * y + z * z).sqrt().max(1e-12);
        ((y / length).clamp(-1.0, 1.0).acos(), x.atan2(z))
    };
    let ((polar, azimuth), (its_polar, its_azimuth)) = (angles(reference), angles(view));
    let (sin, cos) = (its_azimuth - azimuth).sin_cos();
    [its_polar - polar, sin, cos, polar].map(|value| value as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::View;

    #[test]
    fn it_is_told_from_the_reference() {
        let camera = |azimuth: f64, elevation: f64| {
            View::orthographic("v", azimuth.to_radians(), elevation.to_radians(), 2.2, 64).camera::<f32>()
        };
        let found = |a, b| relative_pose(&camera(30.0, 5.0), &camera(a, b));
        let near =
            |found: [f32; 4], wanted: [f64; 4]| found.iter().zip(wanted).all(|(&f, w)| (f64::from(f) - w).abs() < 1e-5);
        let reference = 85.0f64.to_radians();
        assert!(near(found(30.0, 5.0), [0.0, 0.0, 1.0, reference]));
        assert!(near(found(120.0, 5.0), [0.0, 1.0, 0.0, reference]));
        assert!(near(found(30.0, 65.0), [-60.0f64.to_radians(), 0.0, 1.0, reference]));
        assert!(!near(found(31.0, 5.0), [0.0, 0.0, 1.0, reference]));
    }
}
