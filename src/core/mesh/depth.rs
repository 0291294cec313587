//! What a view sees of a mesh: depth, triangle and place on it, a pixel.

use super::Mesh;
use crate::view::{Camera, Image, View};
use glam::{DMat3, DVec3};

/// No triangle.
const GROUND: u32 = u32::MAX;

/// A view's depth buffer, with what was seen.
#[derive(Debug, Clone, PartialEq)]
pub struct Depths {
    depths: Image,
    /// A triangle a pixel, or [`GROUND`].
    triangles: Vec<u32>,
    /// Weights of the triangle's last two corners.
    weights: Vec<[f32; 2]>,
}

impl Depths {
    /// Depth at pixel centres, both sides of triangles seen alike; of equally near triangles the lowest is seen.
    /// What is nearer than [`Camera::NEAREST_DEPTH`] is not.
    ///
    /// Homogeneous (Olano and Greer 1997): a pixel's ray meets the plane of corners p1, p2, p3, given as
    /// (x w, y w, w) in pixels with w the depth (1 if rays are parallel), where Σ b p = (x, y, 1). The b are linear over
    /// the picture, so triangles that reach behind the eye need no clipping.
    pub fn render(mesh: &Mesh, view: &View) -> Depths {
        let (width, height) = (view.width_px, view.height_px);
        let camera: Camera<f64> = view.camera();
        let mut seen = Depths {
            depths: Image { width, height, data: vec![f32::INFINITY; width * height] },
            triangles: vec![GROUND; width * height],
            weights: vec![[0.0; 2]; width * height],
        };
        let corners: Vec<(DVec3, f64)> = mesh.positions().iter().map(|p| corner(&camera, *p)).collect();
        for (i, triangle) in mesh.triangles().iter().enumerate() {
            seen.add(i as u32, triangle.map(|c| corners[c as usize]), camera.is_perspective());
        }
        seen
    }

    fn add(&mut self, triangle: u32, corners: [(DVec3, f64); 3], perspective: bool) {
        let (width, height) = (self.depths.width, self.depths.height);
        let points = corners.map(|(point, _)| point);
        let depths = DVec3::from(corners.map(|(_, depth)| depth));
        if depths.max_element() < Camera::<f64>::NEAREST_DEPTH {
            return;
        }
        // A side's line; the triangle on its other side computes the very same with the other sign, so no pixel falls
        // between the two.
        let sides = [1, 2, 0].map(|k| points[k].cross(points[(k + 1) % 3]));
        let determinant = points[0].dot(sides[0]);
        if determinant == 0.0 || !determinant.is_finite() {
            return;
        }
        let sides = DMat3::from_cols_array_2d(&sides.map(|side| side.to_array())).transpose();
        let behind = perspective && depths.min_element() < Camera::<f64>::NEAREST_DEPTH;
        let (mut low, mut high) = (DVec3::ZERO, DVec3::new(width as f64, height as f64, 1.0));
        if !behind {
            let flat = points.map(|point| point / point.z);
            low = low.max(flat[0].min(flat[1]).min(flat[2]) - 0.5);
            high = high.min(flat[0].max(flat[1]).max(flat[2]) + 0.5);
        }
        for y in low.y.ceil() as usize..high.y.max(0.0) as usize {
            let row = sides.y_axis * (y as f64 + 0.5) + sides.z_axis;
            for x in low.x.ceil() as usize..high.x.max(0.0) as usize {
                let share = sides.x_axis * (x as f64 + 0.5) + row;
                let inside = if determinant > 0.0 { share.min_element() >= 0.0 } else { share.max_element() <= 0.0 };
                if !inside {
                    continue;
                }
                let sum = share.element_sum() / determinant;
                if sum <= 0.0 {
                    continue;
                }
                let weights = share / (determinant * sum);
                let depth = if perspective { 1.0 / sum } else { weights.dot(depths) };
                let at = y * width + x;
                if depth >= Camera::<f64>::NEAREST_DEPTH && (depth as f32) < self.depths.data[at] {
                    self.depths.data[at] = depth as f32;
                    self.triangles[at] = triangle;
                    self.weights[at] = [weights.y as f32, weights.z as f32];
                }
            }
        }
    }

    /// Camera depth at pixel centres ([`Camera::depth`]), world units; +infinity where the ground shows.
    pub fn depths(&self) -> &Image {
        &self.depths
    }

    /// The farthest of each pixel and its eight neighbours: a strand that lies on the mesh but falls a pixel beside its
    /// silhouette, or beside an edge nearer to the eye, is not taken for hidden.
    pub fn widened(&self) -> Image {
        let (width, height) = (self.depths.width, self.depths.height);
        let mut rows = self.depths.clone();
        let mut both = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                rows.data[y * width + x] =
                    (x.saturating_sub(1)..(x + 2).min(width)).fold(0.0, |most, x| self.depths.at(x, y).max(most));
            }
        }
        for y in 0..height {
            for x in 0..width {
                both.data[y * width + x] =
                    (y.saturating_sub(1)..(y + 2).min(height)).fold(0.0, |most, y| rows.at(x, y).max(most));
            }
        }
        both
    }

    /// The triangle seen at column `x`, row `y`, and the weights of its corners there; `None` on the ground.
    ///
    /// # Panics
    /// Outside the picture.
    pub fn triangle_at(&self, x: usize, y: usize) -> Option<(usize, [f64; 3])> {
        assert!(x < self.depths.width, "column {x} is in the picture");
        let at = y * self.depths.width + x;
        let [v, w] = self.weights[at].map(f64::from);
        (self.triangles[at] != GROUND).then_some((self.triangles[at] as usize, [1.0 - v - w, v, w]))
    }

    /// A picture of the mesh that was rendered: `tone` is asked for the world point and the outward unit normal of the
    /// triangle that a pixel sees; the ground is 0.
    pub fn shade(&self, mesh: &Mesh, mut tone: impl FnMut([f64; 3], [f64; 3]) -> f32) -> Image {
        let (width, height) = (self.depths.width, self.depths.height);
        let mut picture = Image::new(width, height);
        for y in 0..height {
            for x in 0..width {
                if let Some((triangle, weights)) = self.triangle_at(x, y) {
                    let corners = mesh.corners(triangle);
                    let point: DVec3 = (0..3).map(|k| weights[k] * corners[k]).sum();
                    picture.data[y * width + x] = tone(point.to_array(), mesh.triangle_normal(triangle));
                }
            }
        }
        picture
    }
}

/// The share of each pixel that shows the mesh, from 2 x 2 places in it.
pub fn silhouette(mesh: &Mesh, view: &View) -> Image {
    let (width, height) = (view.width_px, view.height_px);
    let fine = Depths::render(mesh, &view.with_size(2 * width, 2 * height));
    let mut share = Image::new(width, height);
    for (at, &triangle) in fine.triangles.iter().enumerate() {
        if triangle != GROUND {
            share.data[at / (2 * width) / 2 * width + at % (2 * width) / 2] += 0.25;
        }
    }
    share
}

/// A corner in pixels, homogeneous, and its depth.
fn corner(camera: &Camera<f64>, [x, y, z]: [f64; 3]) -> (DVec3, f64) {
    let point = [x, y, z, 0.0];
    let depth = camera.depth(&point);
    (DVec3::from(camera.homogeneous_px(&point)), depth)
}

#[cfg(test)]
mod tests {
    use super::super::{Nearest, Shape};
    use super::*;
    use crate::rng::Rng;
    use crate::view::Projection;

    fn perspective(eye: [f64; 3], size_px: usize) -> View {
        let projection = Projection::Perspective { fov_y_rad: 0.8 };
        View { projection, eye, ..View::orthographic("front", 0.0, 0.0, 2.2, size_px) }
    }

    #[test]
    fn a_sphere_has_its_depth_and_area() {
        let mesh = Shape::Sphere.mesh();
        let view = View::orthographic("front", 0.3, 0.2, 2.2, 200);
        let seen = Depths::render(&mesh, &view);
        for y in 0..200 {
            for x in 0..200 {
                let [u, v] = [x, y].map(|i| (f64::from(i) + 0.5 - 100.0) * 2.2 / 200.0);
                let height = 1.0 - u * u - v * v;
                let depth = seen.depths().at(x as usize, y as usize);
                if height > 0.01 {
                    assert!((f64::from(depth) - (3.0 - height.sqrt())).abs() < 0.004, "{x} {y}");
                } else if height < 0.0 {
                    assert_eq!(depth, f32::INFINITY);
                    assert_eq!(seen.triangle_at(x as usize, y as usize), None);
                }
            }
        }
        let area: f32 = silhouette(&mesh, &view).data.iter().sum();
        let disc = std::f32::consts::PI * (100.0f32 / 1.1).powi(2);
        assert!((area / disc - 1.0).abs() < 0.002, "{area} {disc}");
    }

    #[test]
    fn depth_is_that_of_the_point_seen_and_it_is_seen_first() {
        let mesh = Shape::Creature.mesh();
        let nearest = Nearest::new(&mesh);
        for view in [perspective([1.7, 1.0, 2.2], 90), View::orthographic("side", 1.0, 0.4, 2.2, 90)] {
            let camera = view.camera::<f64>();
            let seen = Depths::render(&mesh, &view);
            let mut rng = Rng::new(4, 4);
            let mut count = 0;
            for _ in 0..400 {
                let (x, y) = (rng.below(90), rng.below(90));
                let Some((triangle, weights)) = seen.triangle_at(x, y) else { continue };
                let corners = mesh.corners(triangle);
                let point: DVec3 = (0..3).map(|k| weights[k] * corners[k]).sum();
                let at = [point.x, point.y, point.z, 0.0];
                let [px, py, _] = camera.project(&at);
                assert!((px - x as f64 - 0.5).abs() < 1e-3 && (py - y as f64 - 0.5).abs() < 1e-3);
                assert!((camera.depth(&at) - f64::from(seen.depths().at(x, y))).abs() < 1e-5);
                // On the way from the eye nothing is met before: steps as long as the nearest point is far.
                let eye = match view.projection {
                    Projection::Perspective { .. } => DVec3::from(view.eye),
                    Projection::Orthographic { .. } => point + DVec3::from(view.eye),
                };
                let (way, length) = ((point - eye).normalize(), point.distance(eye));
                let mut gone = 0.0;
                while gone < length - 1e-3 {
                    let step = nearest.nearest(&(eye + gone * way).to_array()).distance;
                    if step < 1e-4 {
                        break;
                    }
                    gone += step;
                }
                assert!(gone > length - 0.02, "{gone} {length}");
                count += 1;
            }
            assert!(count > 60, "{count}");
        }
    }

    #[test]
    fn triangles_behind_the_eye_do_no_harm() {
        let corners = vec![[-1.0, -1.0, 0.9], [1.0, -1.0, 0.9], [0.0, 1.0, -1.0], [0.0, -0.5, -1.0]];
        let mesh = Mesh::new("x", corners, vec![[0, 1, 2], [1, 0, 3]]).unwrap();
        // From inside: what lies before the eye is seen, what lies behind is not.
        for eye in [[0.0, 0.0, 0.5], [0.1, 0.3, -0.3], [0.0, -1.0, 0.9], [0.0, 0.0, -3.0]] {
            let seen = Depths::render(&mesh, &perspective(eye, 40));
            let least = seen.depths().data.iter().copied().fold(f32::INFINITY, f32::min);
            assert!(least >= 1e-3 && seen.depths().data.iter().all(|d| !d.is_nan()));
        }
        let seen = Depths::render(&mesh, &perspective([0.0, -0.8, 0.5], 40));
        let count = seen.depths().data.iter().filter(|d| d.is_finite()).count();
        assert!(count > 100, "{count}");
    }

    #[test]
    fn widened_is_the_farthest_neighbour() {
        let seen = Depths::render(&Shape::Knot.mesh(), &View::orthographic("front", 0.0, 0.0, 2.2, 64));
        let wide = seen.widened();
        for y in 1..63 {
            for x in 1..63 {
                let most = (0..9).map(|i| seen.depths().at(x + i % 3 - 1, y + i / 3 - 1)).fold(0.0, f32::max);
                assert_eq!(wide.at(x, y), most);
            }
        }
        assert_eq!(wide.at(0, 0), f32::INFINITY);
    }

    #[test]
    fn shade_is_told_where_it_is() {
        let mesh = Shape::Sphere.mesh();
        let view = View::orthographic("front", 0.0, 0.0, 2.2, 64);
        let picture = Depths::render(&mesh, &view).shade(&mesh, |point, normal| {
            let (point, normal) = (DVec3::from(point), DVec3::from(normal));
            assert!((point.length() - 1.0).abs() < 1e-3 && point.dot(normal) > 0.99);
            (0.5 + 0.5 * point.x) as f32
        });
        assert!(picture.at(12, 32) < 0.2 && picture.at(52, 32) > 0.8);
        assert_eq!(picture.at(0, 0), 0.0);
    }
}
