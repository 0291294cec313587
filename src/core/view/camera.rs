//! Cameras: world to pixels for the centre line and the width, and the adjoint.
//!
//! `radius_px = width_world / 2 · px_per_world` (orthographic), `· focal_px / depth` (perspective). Image y points down.

use crate::wire::Real;
use glam::DVec3;

/// How a view flattens the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Projection {
    /// Parallel rays; the picture is `height_world` world units high.
    Orthographic {
        /// World units from the picture's lower to its upper border.
        height_world: f64,
    },
    /// Rays through the eye.
    Perspective {
        /// Full vertical field of view in radians.
        fov_y_rad: f64,
    },
}

/// A named view: where from, where to, which way is up, and the picture's size.
///
/// Serialises as wire.json's `views` and is checked ([`View::check`]) when read.
///
/// ```
/// use wire4d_core::view::View;
///
/// let [front, side, top] = View::canonical(2.2, 256);
/// assert_eq!(side.eye.map(f64::round), [3.0, 0.0, 0.0], "the side is seen from +x");
/// assert_eq!((front.width_px, top.name.as_str()), (256, "top"));
/// ```
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS), ts(as = "super::spec::Record"))]
#[serde(into = "super::spec::Record", try_from = "super::spec::Record")]
pub struct View {
    /// `front`, `side`, `top` or the person's own.
    pub name: String,
    /// How the world is flattened.
    pub projection: Projection,
    /// Eye in world units.
    pub eye: [f64; 3],
    /// The point that is seen in the picture's middle.
    pub target: [f64; 3],
    /// A direction that points up in the picture.
    pub up: [f64; 3],
    /// Picture width.
    pub width_px: usize,
    /// Picture height.
    pub height_px: usize,
}

impl View {
    /// A square orthographic view of the origin from the direction (azimuth, elevation), both in radians.
    /// Azimuth 0 is the front (camera on +z), +90° the side (camera on +x); elevation 90° the top (up = -z).
    pub fn orthographic(name: &str, azimuth_rad: f64, elevation_rad: f64, height_world: f64, size_px: usize) -> View {
        let (sin_a, cos_a) = azimuth_rad.sin_cos();
        let (sin_e, cos_e) = elevation_rad.sin_cos();
        // The derivative of the direction by elevation: never parallel to it, and -z for the top seen from azimuth 0.
        let up = [-sin_a * sin_e, cos_e, -cos_a * sin_e];
        View {
            name: name.to_owned(),
            projection: Projection::Orthographic { height_world },
            eye: [3.0 * sin_a * cos_e, 3.0 * sin_e, 3.0 * cos_a * cos_e],
            target: [0.0; 3],
            up,
            width_px: size_px,
            height_px: size_px,
        }
    }

    /// The three canonical views in the order front, side, top.
    pub fn canonical(height_world: f64, size_px: usize) -> [View; 3] {
        let quarter = std::f64::consts::FRAC_PI_2;
        [
            View::orthographic("front", 0.0, 0.0, height_world, size_px),
            View::orthographic("side", quarter, 0.0, height_world, size_px),
            View::orthographic("top", 0.0, quarter, height_world, size_px),
        ]
    }

    /// The same view at another picture size.
    pub fn with_size(&self, width_px: usize, height_px: usize) -> View {
        View { width_px, height_px, ..self.clone() }
    }

    /// Its camera in the precision asked for. The view must pass [`View::check`].
    pub fn camera<R: Real>(&self) -> Camera<R> {
        let (eye, target) = (DVec3::from(self.eye), DVec3::from(self.target));
        let forward = (target - eye).normalize();
        let right = forward.cross(DVec3::from(self.up)).normalize();
        let up = right.cross(forward);
        let (scale, perspective) = match self.projection {
            Projection::Orthographic { height_world } => (self.height_px as f64 / height_world, false),
            Projection::Perspective { fov_y_rad } => (self.height_px as f64 / 2.0 / (fov_y_rad / 2.0).tan(), true),
        };
        let row = |axis: DVec3, sign: f64| {
            let origin = if perspective { eye } else { target };
            [axis.x, axis.y, axis.z, -axis.dot(origin)].map(|c| R::from_f64(sign * c))
        };
        Camera {
            right: row(right, 1.0),
            down: row(up, -1.0),
            // Depth is measured from the eye in both projections.
            forward: [forward.x, forward.y, forward.z, -forward.dot(eye)].map(R::from_f64),
            scale: R::from_f64(scale),
            centre_px: [self.width_px as f64 / 2.0, self.height_px as f64 / 2.0].map(R::from_f64),
            perspective,
        }
    }
}

/// A view turned into numbers: affine rows from world to camera axes, and the scale to pixels.
///
/// ```
/// use wire4d_core::view::View;
///
/// let [front, ..] = View::canonical(2.0, 100);
/// let camera = front.camera::<f64>();
/// // Half the picture's height above its middle, a wire .2 world units thick: y points down, the radius is half the width.
/// let [x_px, y_px, radius_px] = camera.project(&[0.0, 0.5, 0.0, 0.2]);
/// assert_eq!([x_px, y_px, radius_px].map(|px| (1e6 * px).round() / 1e6), [50.0, 25.0, 5.0]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Camera<R> {
    /// From world to the picture's right, in world units.
    pub right: [R; 4],
    /// From world to the picture's down, in world units.
    pub down: [R; 4],
    /// From world to the depth from the eye, in world units.
    pub forward: [R; 4],
    /// Pixels per world unit (orthographic) or focal length in pixels (perspective).
    pub scale: R,
    /// Where the point looked at appears, in pixels.
    pub centre_px: [R; 2],
    /// Whether what is farther away appears smaller.
    pub perspective: bool,
}

fn dot<R: Real>(row: &[R; 4], p: &[R; 4]) -> R {
    row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3]
}

impl<R: Real> Camera<R> {
    /// Points at or behind the eye are clamped to this depth, in world units: far off the picture, but finite.
    pub const NEAREST_DEPTH: f64 = 1e-3;

    /// Whether rays meet in the eye.
    pub fn is_perspective(&self) -> bool {
        self.perspective
    }

    /// Distance in front of the eye, world units.
    pub fn depth(&self, point: &[R; 4]) -> R {
        dot(&self.forward, point)
    }

    /// `[x, y, z, width]` in the world to `[x_px, y_px, radius_px]`.
    pub fn project(&self, point: &[R; 4]) -> [R; 3] {
        let k = self.pixels_per_world(point);
        let half = R::from_f64(0.5);
        [
            self.centre_px[0] + k * dot(&self.right, point),
            self.centre_px[1] + k * dot(&self.down, point),
            k * half * point[3],
        ]
    }

    /// `[x w, y w, w]` of a point in pixels, w its depth, or 1 where rays are parallel: finite and straight behind the
    /// eye too.
    pub fn homogeneous_px(&self, point: &[R; 4]) -> [R; 3] {
        let w = if self.perspective { self.depth(point) } else { R::one() };
        [
            self.centre_px[0] * w + self.scale * dot(&self.right, point),
            self.centre_px[1] * w + self.scale * dot(&self.down, point),
            w,
        ]
    }

    /// Adjoint of [`Camera::project`]: from d(x_px, y_px, radius_px) to d(x, y, z, width).
    /// With p = k q, k = f / z: dq = k dp, dz = -(k / z) Σ q dp.
    pub fn project_vjp(&self, point: &[R; 4], d_pixel: &[R; 3]) -> [R; 4] {
        let k = self.pixels_per_world(point);
        let half = R::from_f64(0.5);
        let mut d_point = [R::zero(); 4];
        for c in 0..3 {
            d_point[c] = k * (self.right[c] * d_pixel[0] + self.down[c] * d_pixel[1]);
        }
        d_point[3] = k * half * d_pixel[2];
        if self.perspective {
            let along = dot(&self.right, point) * d_pixel[0]
                + dot(&self.down, point) * d_pixel[1]
                + half * point[3] * d_pixel[2];
            let d_depth = -(k / self.safe_depth(point)) * along;
            for c in 0..3 {
                d_point[c] = d_point[c] + self.forward[c] * d_depth;
            }
        }
        d_point
    }

    /// Pixels per world unit at the point's depth.
    pub fn pixels_per_world(&self, point: &[R; 4]) -> R {
        if self.perspective { self.scale / self.safe_depth(point) } else { self.scale }
    }

    fn safe_depth(&self, point: &[R; 4]) -> R {
        self.depth(point).max(R::from_f64(Self::NEAREST_DEPTH))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn perspective() -> View {
        View {
            name: "any".into(),
            projection: Projection::Perspective { fov_y_rad: 0.7 },
            eye: [1.9, 1.1, 2.3],
            target: [0.1, -0.2, 0.05],
            up: [0.1, 1.0, 0.0],
            width_px: 320,
            height_px: 200,
        }
    }

    /// A cross of points: +x, +y, +z one unit out, seen in a picture of 100 px for 2 world units.
    fn seen(view: &View) -> [[f64; 2]; 3] {
        let camera = view.camera::<f64>();
        let at = |x, y, z| {
            let [x_px, y_px, _] = camera.project(&[x, y, z, 0.0]);
            [(x_px - 50.0).round(), (y_px - 50.0).round()]
        };
        [at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0)]
    }

    #[test]
    fn canonical_axes_are_the_contract() {
        let [front, side, top] = View::canonical(2.0, 100);
        let still = [0.0, 0.0];
        // From +z: x to the right, y up (image y is down). From +x: z to the left. From +y: -z is up.
        assert_eq!(seen(&front), [[50.0, 0.0], [0.0, -50.0], still]);
        assert_eq!(seen(&side), [still, [0.0, -50.0], [-50.0, 0.0]]);
        assert_eq!(seen(&top), [[50.0, 0.0], still, [0.0, 50.0]]);
        // Sibling: a mirrored view would be told apart.
        let back = View::orthographic("back", std::f64::consts::PI, 0.0, 2.0, 100);
        assert_ne!(seen(&back), seen(&front));
        for (view, eye) in [(&front, [0.0, 0.0, 1.0]), (&side, [1.0, 0.0, 0.0]), (&top, [0.0, 1.0, 0.0])] {
            let camera = view.camera::<f64>();
            let near = camera.depth(&[eye[0], eye[1], eye[2], 0.0]);
            assert!((near - 2.0).abs() < 1e-12 && (camera.depth(&[0.0; 4]) - 3.0).abs() < 1e-12, "{}", view.name);
        }
    }

    #[test]
    fn width_scales_as_the_picture_does() {
        let front = &View::canonical(2.0, 100)[0];
        assert_eq!(front.camera::<f64>().project(&[0.3, 0.2, -0.9, 0.1])[2], 2.5);
        let camera =
            View { eye: [0.0, 0.0, 4.0], target: [0.0; 3], up: [0.0, 1.0, 0.0], ..perspective() }.camera::<f64>();
        let focal_px = 100.0 / 0.35f64.tan();
        let [x, y, radius] = camera.project(&[0.5, -0.25, 1.0, 0.1]);
        let expected = [160.0 + focal_px * 0.5 / 3.0, 100.0 + focal_px * 0.25 / 3.0, focal_px * 0.05 / 3.0];
        for (value, expected) in [x, y, radius].into_iter().zip(expected) {
            assert!((value - expected).abs() < 1e-10);
        }
        assert!(camera.project(&[0.0, 0.0, 9.0, 0.1]).iter().all(|x| x.is_finite()), "behind the eye");
    }

    /// Largest difference between the adjoint and central differences, relative to the largest entry.
    fn vjp_error(view: &View, tweak: f64) -> f64 {
        let camera = view.camera::<f64>();
        let mut rng = Rng::new(9, 0);
        let mut worst: f64 = 0.0;
        for _ in 0..50 {
            let point: [f64; 4] = std::array::from_fn(|_| rng.range(-0.8, 0.8));
            let d_pixel: [f64; 3] = std::array::from_fn(|_| rng.range(-1.0, 1.0));
            let mut d_point = camera.project_vjp(&point, &d_pixel);
            d_point[2] *= tweak;
            let size = d_point.iter().fold(0.0f64, |m, d| m.max(d.abs()));
            for c in 0..4 {
                let value = |step: f64| -> f64 {
                    let mut moved = point;
                    moved[c] += step;
                    camera.project(&moved).iter().zip(&d_pixel).map(|(p, d)| p * d).sum()
                };
                let difference = (value(1e-5) - value(-1e-5)) / 2e-5;
                worst = worst.max((difference - d_point[c]).abs() / size);
            }
        }
        worst
    }

    #[test]
    fn vjp_matches_finite_differences() {
        let oblique = View::orthographic("oblique", 0.6, -0.4, 2.2, 256);
        for view in [oblique, perspective()] {
            assert!(vjp_error(&view, 1.0) < 1e-8, "{} {}", view.name, vjp_error(&view, 1.0));
            assert!(vjp_error(&view, 1.01) > 1e-4, "a wrong adjoint is seen");
        }
    }
}
