//! Cubic Bézier strokes to vertices, and both ways back.
//!
//! A Bézier is cut into `K` equal parameter steps. Vertices on the curve would put every chord inside its arc, and
//! the gradient, a difference of a stroke's two sides, feels that at once; so each vertex is moved against the sag,
//! `v(t) = B(t) - B''(t) / (12 K^2)`, which lets the chords average to the curve. That is linear in the control
//! values (x, y and radius alike), so the same weights carry the gradient back.

use super::exact::ExactRaster;
use crate::wire::Stroke;

/// Into how many pieces a Bézier is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Subdivision {
    /// So that a chord leaves its curve by at most so many pixels (counting the radius too).
    Tolerance(f32),
    /// The same number for all.
    Fixed(usize),
}

/// Most pieces a Bézier is cut into.
const MOST_PIECES: usize = 48;

/// Where on its Bézier a vertex lies.
#[derive(Debug, Clone, Copy)]
struct Place {
    segment: u32,
    t: f32,
}

/// A flattened Bézier stroke. Control values are `[x_px, y_px, radius_px]`, three a segment (start and two inner
/// ones) and, if open, one more at the end.
#[derive(Debug, Default)]
pub struct FlatStroke {
    closed: bool,
    control_count: usize,
    pieces: Vec<u32>,
    places: Vec<Place>,
    vertices: Vec<[f32; 3]>,
    /// Weights by number of pieces, made when first needed.
    weights: Vec<Vec<[f32; 4]>>,
}

impl FlatStroke {
    /// With empty buffers, which grow on the first use.
    pub fn new() -> Self {
        Self::default()
    }

    /// `[x_px, y_px, radius_px]`.
    pub fn vertices(&self) -> &[[f32; 3]] {
        &self.vertices
    }

    /// The one stroke over [`FlatStroke::vertices`].
    pub fn strokes(&self) -> [Stroke; 1] {
        [Stroke { start: 0, count: self.vertices.len(), closed: self.closed }]
    }

    /// How many pieces a Bézier was cut into, on average.
    pub fn pieces_a_bezier(&self) -> f32 {
        self.pieces.iter().sum::<u32>() as f32 / self.pieces.len().max(1) as f32
    }

    /// Flattens `control` (3 n values if `closed`, else 3 n + 1; a remainder is left out).
    pub fn flatten(&mut self, control: &[[f32; 3]], closed: bool, subdivision: Subdivision) {
        let segments = if closed { control.len() / 3 } else { control.len().saturating_sub(1) / 3 };
        self.closed = closed;
        self.control_count = control.len();
        self.pieces.clear();
        self.places.clear();
        for s in 0..segments {
            let pieces = match subdivision {
                Subdivision::Fixed(pieces) => pieces.clamp(1, MOST_PIECES),
                Subdivision::Tolerance(tolerance_px) => {
                    let p = corners(s, control.len()).map(|i| control[i]);
                    needed_pieces(&p, tolerance_px)
                }
            };
            self.pieces.push(pieces as u32);
            let places = (0..pieces).map(|j| Place { segment: s as u32, t: j as f32 / pieces as f32 });
            self.places.extend(places);
            while self.weights.len() <= pieces {
                self.weights.push(vertex_weights(self.weights.len()));
            }
        }
        if !closed && segments > 0 {
            self.places.push(Place { segment: segments as u32 - 1, t: 1.0 });
        }
        self.vertices.clear();
        self.vertices.resize(self.places.len(), [0.0; 3]);
        let mut vertices = std::mem::take(&mut self.vertices);
        self.each_weight(|vertex, i, weight| {
            for c in 0..3 {
                vertices[vertex][c] += weight * control[i][c];
            }
        });
        for vertex in &mut vertices {
            vertex[2] = vertex[2].max(0.0);
        }
        self.vertices = vertices;
    }

    /// From the adjoint of the vertices to that of the control values; overwrites. With the rasteriser's own
    /// backward pass this is the exact derivative of the drawn image; fine for three or more pieces a Bézier.
    pub fn pull_back(&self, d_vertices: &[[f32; 3]], d_control: &mut Vec<[f32; 3]>) {
        assert_eq!(d_vertices.len(), self.vertices.len(), "one adjoint a vertex");
        d_control.clear();
        d_control.resize(self.control_count, [0.0; 3]);
        self.each_weight(|vertex, i, weight| {
            for c in 0..3 {
                d_control[i][c] += weight * d_vertices[vertex][c];
            }
        });
    }

    /// Calls `f(vertex, control, weight)` for every entry of the linear map.
    fn each_weight(&self, mut f: impl FnMut(usize, usize, f32)) {
        let mut first = 0;
        for (s, &pieces) in self.pieces.iter().enumerate() {
            let pieces = pieces as usize;
            let corners = corners(s, self.control_count);
            for (j, weights) in self.weights[pieces].iter().enumerate() {
                let vertex = if first + j == self.places.len() { 0 } else { first + j };
                let open_end = !self.closed && (vertex == 0 || vertex + 1 == self.places.len());
                if open_end {
                    f(vertex, corners[if j == 0 { 0 } else { 3 }], 1.0);
                } else {
                    for i in 0..4 {
                        f(vertex, corners[i], weights[i]);
                    }
                }
            }
            first += pieces;
        }
    }

    /// The adjoint of the control values straight from the outline: each bit of outline pushes its Bézier's four
    /// control values by their Bernstein weights there. Overwrites. Also right where a Bézier is one piece, whose
    /// vertices do not see the inner control values. `raster` must have drawn this stroke, and nothing else, last.
    pub fn pull_back_moments(&self, raster: &ExactRaster, d_coverage: &[f32], d_control: &mut Vec<[f32; 3]>) {
        d_control.clear();
        d_control.resize(self.control_count, [0.0; 3]);
        raster.visit_outline(|vertex, [nx, ny], sub_edges, u_per_px| {
            let Place { segment, t: start } = self.places[vertex];
            let step = 1.0 / self.pieces[segment as usize] as f32;
            let mut powers = [0.0f32; 4];
            for edge in sub_edges {
                let weight = d_coverage[edge.pixel as usize] * edge.length_px;
                let spread = (edge.length_px * u_per_px).abs();
                let (low, high) = (edge.u - 0.5 * spread, edge.u + 0.5 * spread);
                if (low >= 0.0 && high <= 1.0) || spread < 1e-9 {
                    add_powers(&mut powers, weight, start + step * edge.u.clamp(0.0, 1.0), step * spread);
                    continue;
                }
                // Past a tangent point (a mitre's tip) the outline belongs to the end of the piece.
                let density = weight / spread;
                let (from, to) = (low.clamp(0.0, 1.0), high.clamp(0.0, 1.0));
                add_powers(&mut powers, density * (to - from), start + step * 0.5 * (from + to), step * (to - from));
                add_powers(&mut powers, density * (high.min(0.0) - low).max(0.0), start, 0.0);
                add_powers(&mut powers, density * (high - low.max(1.0)).max(0.0), start + step, 0.0);
            }
            let [one, t, t2, t3] = powers;
            let bernstein = [one - 3.0 * (t - t2) - t3, 3.0 * (t - 2.0 * t2 + t3), 3.0 * (t2 - t3), t3];
            for (i, weight) in corners(segment as usize, self.control_count).into_iter().zip(bernstein) {
                d_control[i][0] += weight * nx;
                d_control[i][1] += weight * ny;
                d_control[i][2] += weight;
            }
        });
    }
}

/// Adds the integral of 1, t, t^2, t^3 over an interval of width `h` round `t`, times `weight / h`.
#[inline(always)]
fn add_powers(powers: &mut [f32; 4], weight: f32, t: f32, h: f32) {
    let h2 = h * h;
    powers[0] += weight;
    powers[1] += weight * t;
    powers[2] += weight * (t * t + h2 / 12.0);
    powers[3] += weight * t * (t * t + h2 / 4.0);
}

/// Control values of segment `s`; a closed stroke's last one is its first.
fn corners(s: usize, count: usize) -> [usize; 4] {
    let last = 3 * s + 3;
    [3 * s, 3 * s + 1, 3 * s + 2, if last >= count { 0 } else { last }]
}

/// A chord of a curve with second derivative `m` leaves it by at most `m / (8 K^2)`.
fn needed_pieces(p: &[[f32; 3]; 4], tolerance_px: f32) -> usize {
    let bend = |i: usize| {
        let [x, y, r] = std::array::from_fn(|c| p[i][c] - 2.0 * p[i + 1][c] + p[i + 2][c]);
        6.0 * ((x * x + y * y).sqrt() + r.abs())
    };
    // A cast of NaN gives 0.
    ((bend(0).max(bend(1)) / (8.0 * tolerance_px)).sqrt().ceil() as usize).clamp(1, MOST_PIECES)
}

/// Weights of the four control values for the `pieces + 1` vertices; at both ends half, as the neighbouring Bézier
/// gives the other half.
fn vertex_weights(pieces: usize) -> Vec<[f32; 4]> {
    let count = pieces.max(1) as f64;
    let sag = 1.0 / (12.0 * count * count);
    (0..=pieces)
        .map(|j| {
            let t = j as f64 / count;
            let s = 1.0 - t;
            let value = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
            let second = [6.0 * s, 6.0 * t - 12.0 * s, 6.0 * s - 12.0 * t, 6.0 * t];
            let share = if j == 0 || j == pieces { 0.5 } else { 1.0 };
            std::array::from_fn(|i| (share * (value[i] - sag * second[i])) as f32)
        })
        .collect()
}
