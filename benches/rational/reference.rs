//! The slow, exact picture of a wire: the perspective image of a cubic Bézier is a rational curve, and this draws it.
//!
//! A piece is kept as homogeneous control points `[x z, y z, r z, z]` (pixels, pixels, pixels, depth). Pieces are halved
//! until a bound on their curvature says that a chord is within the tolerance; the chords are drawn with exact coverage.

use wire4d::raster::{ExactRaster, Raster};
use wire4d::view::{Camera, View};
use wire4d::wire::{Stroke, Wire};

/// Homogeneous control points of a rational cubic.
pub type Rational = [[f64; 4]; 4];

/// Halvings after which a piece is drawn as it is: 2^-30 of a span.
const MOST_HALVINGS: usize = 30;

/// The exact image of a Bézier piece in front of the eye. `camera.project` divides by the depth; undoing that leaves what
/// is linear in the control point.
pub fn rational(camera: &Camera<f64>, bezier: &[[f64; 4]; 4]) -> Rational {
    bezier.map(|point| {
        let (depth, [x, y, radius]) =
            (if camera.is_perspective() { camera.depth(&point) } else { 1.0 }, camera.project(&point));
        [x * depth, y * depth, radius * depth, depth]
    })
}

/// The paper's image of a Bézier piece: its control points projected, and a polynomial cubic through those.
pub fn linearised(camera: &Camera<f64>, bezier: &[[f64; 4]; 4]) -> Rational {
    bezier.map(|point| {
        let [x, y, radius] = camera.project(&point);
        [x, y, radius, 1.0]
    })
}

/// The point `[x_px, y_px, radius_px]` at `s` (0 to 1).
pub fn point(curve: &Rational, s: f64) -> [f64; 3] {
    let r = 1.0 - s;
    let weights = [r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s];
    let sum = |c: usize| (0..4).map(|k| weights[k] * curve[k][c]).sum::<f64>();
    [0, 1, 2].map(|c| sum(c) / sum(3))
}

/// How far, in pixels, the chord from a piece's start to its end is from the piece at equal parameters, at most: of the
/// centre and of the radius together.
///
/// A chord over a parameter range of 1 is within `max |R''| / 8`. With `R = p + Q / z` for any fixed p,
/// `R' = (Q' - (R - p) z') / z` and `R'' = (Q'' - (R - p) z'' - 2 R' z') / z`; Q, z and their derivatives are Bézier
/// curves, inside the hulls of their control points.
pub fn chord_bound_px(curve: &Rational) -> f64 {
    let nearest = curve.iter().map(|point| point[3]).fold(f64::INFINITY, f64::min);
    if nearest <= 0.0 {
        return f64::INFINITY;
    }
    let middle = point(curve, 0.5);
    let depths = curve.map(|point| [point[3], 0.0]);
    let bound = |values: [[f64; 2]; 4]| {
        let [q, q1, q2] = largest(&values);
        let [_, z1, z2] = largest(&depths);
        let m0 = q / nearest;
        let m1 = (q1 + m0 * z1) / nearest;
        (q2 + m0 * z2 + 2.0 * m1 * z1) / nearest / 8.0
    };
    let off = |k: usize, c: usize| curve[k][c] - middle[c] * curve[k][3];
    bound([0, 1, 2, 3].map(|k| [off(k, 0), off(k, 1)])) + bound([0, 1, 2, 3].map(|k| [off(k, 2), 0.0]))
}

/// Largest length of the control points of a cubic, of its first and of its second derivative.
fn largest(control: &[[f64; 2]; 4]) -> [f64; 3] {
    let length = |v: [f64; 2]| v[0].hypot(v[1]);
    let first = [0, 1, 2].map(|k| [0, 1].map(|c| 3.0 * (control[k + 1][c] - control[k][c])));
    let second = [0, 1].map(|k| [0, 1].map(|c| 2.0 * (first[k + 1][c] - first[k][c])));
    let most = |values: &[[f64; 2]]| values.iter().map(|&v| length(v)).fold(0.0, f64::max);
    [most(control), most(&first), most(&second)]
}

/// Both halves of a piece, by de Casteljau's construction on the homogeneous points.
pub fn halves(curve: &Rational) -> [Rational; 2] {
    let mid = |a: [f64; 4], b: [f64; 4]| [0, 1, 2, 3].map(|c| 0.5 * (a[c] + b[c]));
    let [a, b, c, d] = *curve;
    let (ab, bc, cd) = (mid(a, b), mid(b, c), mid(c, d));
    let (abc, bcd) = (mid(ab, bc), mid(bc, cd));
    let middle = mid(abc, bcd);
    [[a, ab, abc, middle], [middle, bcd, cd, d]]
}

/// Vertices `[x_px, y_px, radius_px]` of one open stroke along `pieces`, whose chords are within `tolerance_px`.
pub fn vertices(pieces: &[Rational], tolerance_px: f64) -> Vec<[f32; 3]> {
    fn add(curve: &Rational, tolerance_px: f64, halvings: usize, out: &mut Vec<[f32; 3]>) {
        if halvings == MOST_HALVINGS || chord_bound_px(curve) <= tolerance_px {
            out.push(point(curve, 1.0).map(|c| c as f32));
            return;
        }
        for half in halves(curve) {
            add(&half, tolerance_px, halvings + 1, out);
        }
    }
    let mut out: Vec<[f32; 3]> = pieces.first().map(|piece| point(piece, 0.0).map(|c| c as f32)).into_iter().collect();
    pieces.iter().for_each(|piece| add(piece, tolerance_px, 0, &mut out));
    out
}

/// Every span of an open spline in `count` equal pieces, made a curve of the picture by `image`.
pub fn pieces(wire: &Wire, count: usize, image: impl Fn(&[[f64; 4]; 4]) -> Rational) -> Vec<Rational> {
    let mut points = Vec::new();
    wire.subdivision_map::<f64>(&vec![count; wire.spans().count()]).apply(wire.control_points(), &mut points);
    points.as_chunks::<4>().0.iter().map(image).collect()
}

/// Exact coverage of the stroke through `vertices`, at the view's size.
pub fn coverage(view: &View, vertices: &[[f32; 3]]) -> Vec<f32> {
    let stroke = Stroke { start: 0, count: vertices.len(), closed: false };
    ExactRaster::new().forward(view.width_px, view.height_px, vertices, &[stroke]).to_vec()
}
