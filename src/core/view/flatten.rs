//! From the wire to the picture's polyline, by two routes with adjoints, and how far the first is off.
//!
//! - Exact samples (the default): points of the curve, projected. The only error is the chords' sag.
//! - Projected Béziers (the paper's): Bézier control points are projected and taken for a plane cubic. Exact for parallel
//!   rays; in perspective the true curve is rational and the difference is bounded by [`projection_error_bound_px`].

use super::Camera;
use crate::wire::{LinearMap, Real, Stroke, Wire};

/// Error bound at which [`pieces_per_span`] stops halving by default, in pixels.
pub const PROJECTION_TOLERANCE_PX: f64 = 0.1;

/// Most pieces a span is cut into; the bound is infinite for pieces that reach behind the eye.
const MAX_PIECES: usize = 64;

/// Bounds of the error of projecting a Bézier piece by its control points: `[centre_px, radius_px]`.
///
/// With Bernstein weights B as probabilities, exact minus approximate is `Cov_B(p, z) / z(s)`, at most
/// `¼ diam(p) (z_max - z_min) / z_min`: both standard deviations are at most half the range. The same holds for the
/// radius. Zero for parallel rays, infinite if a control point is not in front of the eye.
pub fn projection_error_bound_px(camera: &Camera<f64>, bezier: &[[f64; 4]; 4]) -> [f64; 2] {
    if !camera.is_perspective() {
        return [0.0; 2];
    }
    let depths = bezier.map(|point| camera.depth(&point));
    let near = depths.into_iter().fold(f64::INFINITY, f64::min);
    let far = depths.into_iter().fold(f64::NEG_INFINITY, f64::max);
    if near <= Camera::<f64>::NEAREST_DEPTH {
        return [f64::INFINITY; 2];
    }
    let pixels = bezier.map(|point| camera.project(&point));
    let (mut diameter, mut range) = (0.0f64, 0.0f64);
    for (i, p) in pixels.iter().enumerate() {
        for q in &pixels[..i] {
            diameter = diameter.max((p[0] - q[0]).hypot(p[1] - q[1]));
            range = range.max((p[2] - q[2]).abs());
        }
    }
    [diameter, range].map(|spread| 0.25 * spread * (far - near) / near)
}

/// Into how many equal pieces each span must be cut, a power of two, so that projecting their Bézier control points is
/// off by at most `tolerance_px` in every camera. Feeds [`Wire::subdivision_map`].
pub fn pieces_per_span(wire: &Wire, cameras: &[Camera<f64>], tolerance_px: f64) -> Vec<usize> {
    let mut pieces = vec![1; wire.spans().count()];
    let mut undecided: Vec<usize> = (0..pieces.len()).collect();
    let mut points = Vec::new();
    while !undecided.is_empty() {
        wire.subdivision_map::<f64>(&pieces).apply(wire.control_points(), &mut points);
        let (beziers, _) = points.as_chunks::<4>();
        let mut starts = Vec::with_capacity(pieces.len());
        let mut next = 0;
        for count in &pieces {
            starts.push(next);
            next += count;
        }
        let too_coarse = |bezier: &[[f64; 4]; 4]| {
            let worst = |camera| projection_error_bound_px(camera, bezier).into_iter().fold(0.0, f64::max);
            cameras.iter().any(|camera| worst(camera) > tolerance_px)
        };
        undecided.retain(|&span| {
            pieces[span] < MAX_PIECES && beziers[starts[span]..][..pieces[span]].iter().any(too_coarse)
        });
        for &span in &undecided {
            pieces[span] *= 2;
        }
    }
    pieces
}

/// The constant part of a route from control points to the vertices of a picture's polyline. One serves all views.
///
/// Control points → [`Flattening::to_world`] → world points → [`Flattening::project`] → vertices, and the adjoints back.
#[derive(Debug, Clone, PartialEq)]
pub struct Flattening<R> {
    map: LinearMap<R>,
    strokes: Vec<Stroke>,
    /// Weights of a piece's four control points at its samples; empty for exact samples.
    bernstein: Vec<[R; 4]>,
    /// For Béziers: piece and sample of each vertex.
    vertices: Vec<(u32, u32)>,
}

impl<R: Real> Flattening<R> {
    /// The exact route: `samples_per_span` points of the curve a span, moved against the chords' sag.
    pub fn exact(wire: &Wire, samples_per_span: usize) -> Self {
        let (map, strokes) = wire.sampling_map(samples_per_span, true);
        Flattening { map, strokes, bernstein: Vec::new(), vertices: Vec::new() }
    }

    /// The paper's route: `pieces_per_span[i]` Bézier pieces of span i, each projected by its control points and drawn
    /// through `samples_per_piece` points.
    ///
    /// # Panics
    /// If there is not one number of pieces a span.
    pub fn beziers(wire: &Wire, pieces_per_span: &[usize], samples_per_piece: usize) -> Self {
        let samples = samples_per_piece.max(1);
        let map = wire.subdivision_map(pieces_per_span);
        let counts: Vec<usize> = pieces_per_span.iter().map(|&pieces| pieces.max(1) * samples).collect();
        // Only for the layout: the same number of samples, and one more where a stroke ends.
        let (_, strokes) = wire.sampling_map_per_span::<R>(&counts, false);
        let bernstein = (0..=samples).map(|j| {
            let (s, r) = (j as f64 / samples as f64, 1.0 - j as f64 / samples as f64);
            [r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s].map(R::from_f64)
        });
        let mut vertices = Vec::new();
        let mut piece = 0;
        for stroke in &strokes {
            let pieces = (stroke.count - usize::from(!stroke.closed)) / samples;
            for _ in 0..pieces {
                vertices.extend((0..samples).map(|j| (piece, j as u32)));
                piece += 1;
            }
            if !stroke.closed {
                vertices.push((piece - 1, samples as u32));
            }
        }
        Flattening { map, strokes, bernstein: bernstein.collect(), vertices }
    }

    /// The runs of vertices that are joined.
    pub fn strokes(&self) -> &[Stroke] {
        &self.strokes
    }

    /// World points, once for all views: exact points of the curve, or Bézier control points, four a piece.
    pub fn to_world(&self, control_points: &[[R; 4]], world: &mut Vec<[R; 4]>) {
        self.map.apply(control_points, world);
    }

    /// Adjoint of [`Flattening::to_world`]; adds to `d_control_points`.
    pub fn to_world_vjp(&self, d_world: &[[R; 4]], d_control_points: &mut [[R; 4]]) {
        self.map.apply_transpose(d_world, d_control_points);
    }

    /// Vertices `[x_px, y_px, radius_px]` of one view.
    pub fn project(&self, camera: &Camera<R>, world: &[[R; 4]], vertices: &mut Vec<[R; 3]>) {
        vertices.clear();
        if self.bernstein.is_empty() {
            vertices.extend(world.iter().map(|point| camera.project(point)));
            return;
        }
        let (pieces, _) = world.as_chunks::<4>();
        let mut projected = (u32::MAX, [[R::zero(); 3]; 4]);
        vertices.extend(self.vertices.iter().map(|&(piece, sample)| {
            if projected.0 != piece {
                projected = (piece, pieces[piece as usize].map(|point| camera.project(&point)));
            }
            let weights = &self.bernstein[sample as usize];
            std::array::from_fn(|c| (0..4).fold(R::zero(), |sum, k| sum + weights[k] * projected.1[k][c]))
        }));
    }

    /// Adjoint of [`Flattening::project`]; adds to `d_world`.
    pub fn project_vjp(&self, camera: &Camera<R>, world: &[[R; 4]], d_vertices: &[[R; 3]], d_world: &mut [[R; 4]]) {
        let add = |into: &mut [R; 4], d_point: [R; 4]| {
            for c in 0..4 {
                into[c] = into[c] + d_point[c];
            }
        };
        if self.bernstein.is_empty() {
            for ((point, d_vertex), d_point) in world.iter().zip(d_vertices).zip(d_world) {
                add(d_point, camera.project_vjp(point, d_vertex));
            }
            return;
        }
        for (&(piece, sample), d_vertex) in self.vertices.iter().zip(d_vertices) {
            for k in 0..4 {
                let weight = self.bernstein[sample as usize][k];
                let i = 4 * piece as usize + k;
                add(&mut d_world[i], camera.project_vjp(&world[i], &d_vertex.map(|d| weight * d)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        rng::Rng,
        view::{Projection, View},
        wire::Form,
    };

    fn wire(form: Form, closed: bool, count: usize) -> Wire {
        let mut rng = Rng::new(11, 0);
        let point = |_| {
            let [x, y, z] = rng.in_ball(0.8);
            [x, y, z, 0.02 + 0.05 * rng.unit()]
        };
        Wire::uniform(form, closed, (0..count).map(point).collect()).unwrap()
    }

    fn view(perspective: bool) -> View {
        let mut view = View::orthographic("any", 0.5, 0.3, 2.2, 256);
        if perspective {
            view.projection = Projection::Perspective { fov_y_rad: 0.8 };
        }
        view
    }

    fn vertices(route: &Flattening<f64>, camera: &Camera<f64>, points: &[[f64; 4]]) -> Vec<[f64; 3]> {
        let (mut world, mut vertices) = (Vec::new(), Vec::new());
        route.to_world(points, &mut world);
        route.project(camera, &world, &mut vertices);
        vertices
    }

    fn farthest(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
        assert_eq!(a.len(), b.len());
        a.iter().zip(b).flat_map(|(p, q)| (0..3).map(move |c| (p[c] - q[c]).abs())).fold(0.0, f64::max)
    }

    #[test]
    fn both_routes_agree_for_parallel_rays_and_only_there() {
        for (form, closed, count) in
            [(Form::Spline, false, 12), (Form::Spline, true, 9), (Form::Chain, false, 13), (Form::Bag, false, 12)]
        {
            let wire = wire(form, closed, count);
            let pieces: Vec<usize> = (0..wire.spans().count()).map(|i| 1 + i % 3).collect();
            let counts: Vec<usize> = pieces.iter().map(|pieces| pieces * 4).collect();
            let beziers = Flattening::<f64>::beziers(&wire, &pieces, 4);
            let (map, strokes) = wire.sampling_map_per_span(&counts, false);
            let exact = Flattening { map, strokes, bernstein: vec![], vertices: vec![] };
            assert_eq!(beziers.strokes(), exact.strokes());
            let difference = |perspective| {
                let camera = view(perspective).camera();
                let [a, b] = [&beziers, &exact].map(|route| vertices(route, &camera, wire.control_points()));
                farthest(&a, &b)
            };
            assert!(difference(false) < 1e-10, "{form:?}");
            assert!(difference(true) > 1e-2, "{form:?}: perspective is not polynomial");
        }
    }

    #[test]
    fn adjoints_match_finite_differences() {
        let wire = wire(Form::Spline, false, 8);
        let camera = view(true).camera::<f64>();
        let pieces = vec![2; wire.spans().count()];
        for route in [Flattening::<f64>::exact(&wire, 3), Flattening::beziers(&wire, &pieces, 3)] {
            let mut rng = Rng::new(12, 0);
            let mut points = wire.control_points().to_vec();
            let mut world = Vec::new();
            route.to_world(&points, &mut world);
            let count = vertices(&route, &camera, &points).len();
            let d_vertices: Vec<[f64; 3]> = (0..count).map(|_| std::array::from_fn(|_| rng.range(-1.0, 1.0))).collect();
            let value = |points: &[[f64; 4]]| -> f64 {
                let vertices = vertices(&route, &camera, points);
                vertices.iter().zip(&d_vertices).map(|(p, d)| (0..3).map(|c| p[c] * d[c]).sum::<f64>()).sum()
            };
            let (mut d_world, mut d_points) = (vec![[0.0; 4]; world.len()], vec![[0.0; 4]; points.len()]);
            route.project_vjp(&camera, &world, &d_vertices, &mut d_world);
            route.to_world_vjp(&d_world, &mut d_points);
            for i in 0..points.len() {
                for c in 0..4 {
                    let place = points[i][c];
                    let [up, down] = [1e-5, -1e-5].map(|step| {
                        points[i][c] = place + step;
                        value(&points)
                    });
                    points[i][c] = place;
                    let difference = (up - down) / 2e-5;
                    assert!((difference - d_points[i][c]).abs() < 1e-5, "{difference} {}", d_points[i][c]);
                    assert!((difference - 1.01 * d_points[i][c]).abs() > 1e-5, "a wrong adjoint is seen");
                }
            }
        }
    }

    #[test]
    fn pieces_keep_the_tolerance_and_are_not_wasted() {
        let wire = wire(Form::Spline, false, 30);
        let cameras = [view(true).camera::<f64>(), view(false).camera()];
        let bounds = |pieces: &[usize]| -> Vec<f64> {
            let mut points = Vec::new();
            wire.subdivision_map::<f64>(pieces).apply(wire.control_points(), &mut points);
            let each = points.as_chunks::<4>().0.iter();
            each.map(|piece| projection_error_bound_px(&cameras[0], piece).into_iter().fold(0.0, f64::max)).collect()
        };
        let pieces = pieces_per_span(&wire, &cameras, 0.1);
        assert!(bounds(&pieces).iter().all(|&bound| bound <= 0.1));
        assert!(pieces.iter().any(|&count| count != pieces[0]), "adaptive");
        let halved: Vec<usize> = pieces.iter().map(|count| count.div_ceil(2)).collect();
        assert!(bounds(&halved).iter().any(|&bound| bound > 0.1), "no more than needed");
        assert!(
            pieces_per_span(&wire, &cameras[1..], 0.1).iter().all(|&count| count == 1),
            "nothing for parallel rays"
        );
        let behind = View { eye: [0.0, 0.0, 0.1], target: [0.0; 3], up: [0.0, 1.0, 0.0], ..view(true) };
        let most = pieces_per_span(&wire, &[behind.camera()], 0.1);
        assert!(most.iter().all(|&count| count <= MAX_PIECES) && most.contains(&MAX_PIECES));
    }
}
