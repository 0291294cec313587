//! Soft visibility: strands behind a solid's surface thin out to nothing.
//!
//! V = sigmoid(k (z_mesh - z_curve + b)), and a sample is drawn at V times its width ("Optimizing 4D Wires for Sparse 3D
//! Abstraction", section 4.3). The surface's depth is a constant to the gradient; V moves with the sample's own depth.

use super::{Camera, Image};
use crate::wire::{Real, Stroke};

/// A strand less visible than this is not drawn at all. Its gradient, which is no more than this share either, is 0.
pub const LEAST_VISIBILITY: f32 = 1e-3;

/// Where the sigmoid's argument is cut off: beyond, V is 0 or 1 in any precision, and its exponential still finite.
const STEEPEST: f64 = 80.0;

/// A solid as one view sees it: what lies behind its surface is hidden.
#[derive(Debug, Clone, PartialEq)]
pub struct Occluder {
    /// Depth of the surface before the camera in each pixel, world units ([`Camera::depth`]), widened by a pixel so that
    /// strands along a silhouette are not taken for hidden; infinite on the ground.
    pub depth: Image,
    /// k, per world unit, above 0: how sharply strands vanish behind the surface.
    pub steepness: f32,
    /// b, world units: how far behind the surface half of a strand's width is left.
    pub bias_world: f32,
}

impl Occluder {
    /// The paper's bias, and the steepness that its figures imply.
    pub fn new(depth: Image) -> Occluder {
        Occluder { depth, steepness: 60.0, bias_world: 0.05 }
    }

    /// V of a sample that is seen at `[x, y]` px and lies `depth` world units before the camera. The surface's depth is
    /// that of the nearest pixel; outside the picture all is visible.
    pub fn visibility<R: Real>(&self, [x, y]: [R; 2], depth: R) -> R {
        let cell = |along: R, size: usize| -> Option<usize> {
            let inside = along >= R::zero() && along < R::from_f64(size as f64);
            if inside { along.to_usize() } else { None }
        };
        let Some((column, row)) = cell(x, self.depth.width).zip(cell(y, self.depth.height)) else { return R::one() };
        let before = R::from_f64(self.depth.at(column, row).into()) - depth + R::from_f64(self.bias_world.into());
        let steepest = R::from_f64(STEEPEST);
        let argument = (R::from_f64(self.steepness.into()) * before).max(-steepest).min(steepest);
        R::one() / (R::one() + (-argument).exp())
    }

    /// Adjoint of `[x, y, z, V width]` at `sample`: from the gradient to that to the gradient to `sample` itself.
    pub fn thinned_vjp<R: Real>(
        &self,
        camera: &Camera<R>,
        sample: &[R; 4],
        visibility: R,
        d_thinned: [R; 4],
    ) -> [R; 4] {
        let [x, y, z, d_width] = d_thinned;
        let slope = R::from_f64(self.steepness.into()) * visibility * (R::one() - visibility);
        let d_depth = -slope * sample[3] * d_width;
        let [fx, fy, fz, _] = camera.forward;
        [x + fx * d_depth, y + fy * d_depth, z + fz * d_depth, visibility * d_width]
    }

    /// The same view at another size. Each pixel takes the farthest depth it overlaps with, so that no strand is hidden
    /// which was not before.
    pub fn resized(&self, width: usize, height: usize) -> Occluder {
        let from = &self.depth;
        let window = |i: usize, to: usize, size: usize| i * size / to..((i + 1) * size).div_ceil(to);
        let mut depth = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                let rows = window(y, height, from.height);
                let farthest =
                    rows.flat_map(|row| window(x, width, from.width).map(move |column| from.at(column, row)));
                depth.data[y * width + x] = farthest.fold(f32::NEG_INFINITY, f32::max);
            }
        }
        Occluder { depth, ..self.clone() }
    }
}

/// Takes out of their strokes the vertices whose strands are hidden on both sides, so that no raster spends time on them.
/// Such a vertex is made one that cannot be drawn; ends of visible strands stay and taper off.
pub fn drop_hidden(visibilities: &[f32], strokes: &[Stroke], vertices: &mut [[f32; 3]]) {
    let hidden = |k: usize| visibilities[k] < LEAST_VISIBILITY;
    for stroke in strokes {
        let (start, end) = (stroke.start, stroke.start.saturating_add(stroke.count).min(vertices.len()));
        for k in start..end {
            let before = if k > start {
                k - 1
            } else if stroke.closed {
                end - 1
            } else {
                k
            };
            let after = if k + 1 < end {
                k + 1
            } else if stroke.closed {
                start
            } else {
                k
            };
            if hidden(k) && hidden(before) && hidden(after) {
                vertices[k] = [f32::INFINITY; 3];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use crate::view::{Projection, View};

    fn eye() -> View {
        View {
            name: "eye".into(),
            projection: Projection::Perspective { fov_y_rad: 0.785 },
            eye: [0.4, 0.3, 3.0],
            target: [0.0; 3],
            up: [0.0, 1.0, 0.0],
            width_px: 96,
            height_px: 80,
        }
    }

    /// A ball of this radius, by formula, as the view sees it.
    fn ball(view: &View, radius: f64) -> Occluder {
        let camera = view.camera::<f64>();
        let mut depth = Image::new(view.width_px, view.height_px);
        for (i, depth) in depth.data.iter_mut().enumerate() {
            let pixel = [(i % view.width_px) as f64 + 0.5, (i / view.width_px) as f64 + 0.5];
            let across = [0, 1].map(|c| (pixel[c] - camera.centre_px[c]) / camera.scale);
            // Camera axes: the ball's centre, and the ray from `from` along `along`.
            let centre = [&camera.right, &camera.down, &camera.forward].map(|row| row[3]);
            let (from, along) = match view.projection {
                Projection::Perspective { .. } => ([0.0; 3], [across[0], across[1], 1.0]),
                Projection::Orthographic { .. } => ([across[0], across[1], 0.0], [0.0, 0.0, 1.0]),
            };
            let to = [0, 1, 2].map(|c| centre[c] - from[c]);
            let dot = |a: [f64; 3], b: [f64; 3]| (0..3).map(|c| a[c] * b[c]).sum::<f64>();
            let (a, b, c) = (dot(along, along), dot(along, to), dot(to, to) - radius * radius);
            let root = b * b - a * c;
            *depth = if root >= 0.0 { ((b - root.sqrt()) / a) as f32 } else { f32::INFINITY };
        }
        Occluder::new(depth)
    }

    /// The farthest depth of each pixel and its neighbours.
    fn widened(mut occluder: Occluder) -> Occluder {
        let from = occluder.depth.clone();
        let around = |i: usize, size: usize| i.saturating_sub(1)..size.min(i + 2);
        for (i, depth) in occluder.depth.data.iter_mut().enumerate() {
            let (x, y) = (i % from.width, i / from.width);
            let cells = around(y, from.height).flat_map(|y| around(x, from.width).map(move |x| (x, y)));
            *depth = cells.map(|(x, y)| from.at(x, y)).fold(f32::NEG_INFINITY, f32::max);
        }
        occluder
    }

    fn seen(occluder: &Occluder, camera: &Camera<f64>, sample: &[f64; 4]) -> f64 {
        let [x, y, _] = camera.project(sample);
        occluder.visibility([x, y], camera.depth(sample))
    }

    #[test]
    fn the_near_side_is_visible_and_the_far_side_is_not() {
        for view in [eye(), View::orthographic("any", 0.7, 0.3, 2.2, 96)] {
            let (camera, occluder) = (view.camera::<f64>(), widened(ball(&view, 0.6)));
            let mut rng = Rng::new(3, 0);
            let (mut near, mut far) = (0, 0);
            for _ in 0..2000 {
                let mut sample: [f64; 4] = std::array::from_fn(|_| rng.range(-1.0, 1.0));
                let length = (0..3).map(|c| sample[c] * sample[c]).sum::<f64>().sqrt();
                (0..3).for_each(|c| sample[c] *= 0.6 / length);
                let (v, depth) = (seen(&occluder, &camera, &sample), camera.depth(&sample));
                let [x, y, _] = camera.project(&sample);
                let before = f64::from(occluder.depth.at(x as usize, y as usize));
                let away = if camera.perspective { 0.36 } else { 0.0 };
                if (0..3).map(|c| sample[c] * view.eye[c]).sum::<f64>() > away {
                    assert!(v >= 0.95, "{}: {v} on the surface", view.name);
                    near += 1;
                } else if depth > before + 0.2 {
                    assert!(v <= 0.01, "{}: {v} behind", view.name);
                    far += 1;
                }
            }
            assert!(near > 500 && far > 500, "{near} {far}: tests nothing");
        }
    }

    #[test]
    fn ground_and_what_is_outside_the_picture_hide_nothing() {
        let mut occluder = Occluder::new(Image { width: 2, height: 1, data: vec![f32::INFINITY, 1.0] });
        assert_eq!(occluder.visibility([0.5, 0.5], 1e6), 1.0f64);
        assert_eq!(occluder.visibility([0.5f32, 0.5], 1e6), 1.0);
        for outside in [[-0.1, 0.5], [2.0, 0.5], [1.5, 1.0], [1.5, -1e9], [1e30, 0.5]] {
            assert_eq!(occluder.visibility(outside, 5.0f64), 1.0, "{outside:?}");
        }
        assert!(occluder.visibility([1.5, 0.5], 5.0f64) < 1e-6);
        assert!((occluder.visibility([1.5, 0.5], 1.05f64) - 0.5).abs() < 1e-6, "half is left at the bias");
        // No numbers that are none, however steep.
        occluder.steepness = f32::MAX;
        for depth in [0.0f32, 1.05, 2.0, f32::MAX] {
            let v = occluder.visibility([1.5, 0.5], depth);
            assert!((0.0..=1.0).contains(&v), "{v} at {depth}");
        }
    }

    /// Largest difference between the adjoint and central differences, relative to the largest entry.
    fn vjp_error(view: &View, tweak: f64) -> f64 {
        let camera = view.camera::<f64>();
        let mut rng = Rng::new(9, 0);
        let mut worst: f64 = 0.0;
        for _ in 0..50 {
            let sample: [f64; 4] = std::array::from_fn(|c| rng.range(if c == 3 { 0.02 } else { -0.4 }, 0.4));
            let depth = (camera.depth(&sample) + rng.range(-0.1, 0.05)) as f32;
            let count = view.width_px * view.height_px;
            let flat = Image { width: view.width_px, height: view.height_px, data: vec![depth; count] };
            let occluder = Occluder::new(flat);
            let d_pixel: [f64; 3] = std::array::from_fn(|_| rng.range(-1.0, 1.0));
            let thinned = |sample: &[f64; 4]| {
                let v = seen(&occluder, &camera, sample);
                (v, [sample[0], sample[1], sample[2], v * sample[3]])
            };
            let (v, thin) = thinned(&sample);
            let mut d_sample = occluder.thinned_vjp(&camera, &sample, v, camera.project_vjp(&thin, &d_pixel));
            d_sample[2] *= tweak;
            let size = d_sample.iter().fold(0.0f64, |m, d| m.max(d.abs()));
            for c in 0..4 {
                let value = |step: f64| -> f64 {
                    let mut moved = sample;
                    moved[c] += step;
                    camera.project(&thinned(&moved).1).iter().zip(&d_pixel).map(|(p, d)| p * d).sum()
                };
                let difference = (value(1e-5) - value(-1e-5)) / 2e-5;
                worst = worst.max((difference - d_sample[c]).abs() / size);
            }
        }
        worst
    }

    #[test]
    fn gradients_agree_with_central_differences() {
        for view in [eye(), View::orthographic("oblique", 0.6, -0.4, 2.2, 96)] {
            let error = vjp_error(&view, 1.0);
            assert!(error < 1e-6, "{}: {error}", view.name);
            assert!(vjp_error(&view, 1.01) > 1e-4, "a wrong adjoint is seen");
        }
    }

    #[test]
    fn other_sizes_take_the_farthest_depth() {
        let data = vec![1.0, 2.0, f32::INFINITY, 4.0, 5.0, 6.0];
        let occluder = Occluder::new(Image { width: 3, height: 2, data });
        assert_eq!(occluder.resized(3, 2), occluder);
        assert_eq!(occluder.resized(1, 2).depth.data, [f32::INFINITY, 6.0]);
        assert_eq!(occluder.resized(2, 1).depth.data, [5.0, f32::INFINITY]);
        assert_eq!(occluder.resized(6, 4).depth.at(3, 3), 5.0, "doubling repeats pixels");
    }

    #[test]
    fn only_strands_hidden_on_both_sides_are_dropped() {
        let strokes = [
            Stroke { start: 0, count: 5, closed: false },
            Stroke { start: 5, count: 4, closed: true },
            Stroke { start: 9, count: 2, closed: false },
        ];
        let seen = [0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut vertices = vec![[1.0; 3]; 12];
        drop_hidden(&seen, &strokes, &mut vertices);
        let dropped: Vec<usize> = (0..12).filter(|&k| vertices[k][0].is_infinite()).collect();
        assert_eq!(dropped, [0, 1, 7, 9, 10]);
    }
}
