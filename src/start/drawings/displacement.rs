//! A smooth displacement field over a square picture: uniform cubic B-splines on a coarse lattice.

/// For each pixel of a side its first control and the four weights of value, first and second derivative (per pixel).
#[derive(Debug, Clone)]
struct Axis {
    first: Vec<usize>,
    weights: [Vec<[f32; 4]>; 3],
}

impl Axis {
    fn new(pixels: usize, controls: usize) -> Axis {
        // Parameter units a pixel.
        let step = (controls - 3) as f32 / pixels as f32;
        let mut axis = Axis { first: Vec::new(), weights: Default::default() };
        for i in 0..pixels {
            let t = (i as f32 + 0.5) * step;
            let first = (t as usize).min(controls - 4);
            let u = t - first as f32;
            let v = 1.0 - u;
            axis.first.push(first);
            axis.weights[0].push([
                v * v * v / 6.0,
                (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
                u * u * u / 6.0,
            ]);
            axis.weights[1].push(
                [-v * v / 2.0, (3.0 * u * u - 4.0 * u) / 2.0, (-3.0 * v * v + 4.0 * v) / 2.0, u * u / 2.0]
                    .map(|w| w * step),
            );
            axis.weights[2].push([v, 3.0 * u - 2.0, 3.0 * v - 2.0, u].map(|w| w * step * step));
        }
        axis
    }
}

/// Evaluation of `controls` x `controls` lattices at the pixel centres of a `pixels` x `pixels` picture.
#[derive(Debug, Clone)]
pub struct Lattice {
    /// Pixels a side.
    pub pixels: usize,
    /// Lattice points a side.
    pub controls: usize,
    axis: Axis,
    rows: Vec<f32>,
}

impl Lattice {
    /// For pictures of `pixels` a side and lattices of `controls` (at least 4) a side.
    pub fn new(pixels: usize, controls: usize) -> Lattice {
        Lattice { pixels, controls, axis: Axis::new(pixels, controls), rows: vec![0.0; pixels * controls] }
    }

    /// The field (or its derivative of order `along_x`, `along_y`, 0 to 2 each) at every pixel; overwrites `out`.
    pub fn evaluate(&mut self, lattice: &[f32], along_x: usize, along_y: usize, out: &mut [f32]) {
        let (n, k) = (self.pixels, self.controls);
        for (row, controls) in self.rows.chunks_exact_mut(n).zip(lattice.chunks_exact(k)) {
            for (x, value) in row.iter_mut().enumerate() {
                let (c, w) = (&controls[self.axis.first[x]..][..4], &self.axis.weights[along_x][x]);
                *value = w[0] * c[0] + w[1] * c[1] + w[2] * c[2] + w[3] * c[3];
            }
        }
        for (y, line) in out.chunks_exact_mut(n).enumerate() {
            let w = &self.axis.weights[along_y][y];
            let rows = &self.rows[self.axis.first[y] * n..][..4 * n];
            for x in 0..n {
                line[x] = w[0] * rows[x] + w[1] * rows[n + x] + w[2] * rows[2 * n + x] + w[3] * rows[3 * n + x];
            }
        }
    }

    /// Adjoint of [`Lattice::evaluate`]: adds to `d_lattice`.
    pub fn evaluate_vjp(&mut self, d_out: &[f32], along_x: usize, along_y: usize, d_lattice: &mut [f32]) {
        let (n, k) = (self.pixels, self.controls);
        self.rows.fill(0.0);
        for (y, line) in d_out.chunks_exact(n).enumerate() {
            let w = &self.axis.weights[along_y][y];
            let rows = &mut self.rows[self.axis.first[y] * n..][..4 * n];
            for (row, &weight) in rows.chunks_exact_mut(n).zip(w) {
                for x in 0..n {
                    row[x] += weight * line[x];
                }
            }
        }
        for (row, controls) in self.rows.chunks_exact(n).zip(d_lattice.chunks_exact_mut(k)) {
            for (x, &value) in row.iter().enumerate() {
                let (c, w) = (&mut controls[self.axis.first[x]..][..4], &self.axis.weights[along_x][x]);
                for q in 0..4 {
                    c[q] += w[q] * value;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn lines_and_parabolas_come_back_with_their_derivatives() {
        let (n, k) = (32, 7);
        let mut lattice = Lattice::new(n, k);
        let per_control = n as f32 / (k - 3) as f32;
        let at = |i: usize| (i as f32 - 1.0) * per_control;
        // Controls on x²: a cubic B-spline gives x² + a constant.
        let parabola: Vec<f32> = (0..k * k).map(|i| at(i % k).powi(2) + 3.0 * at(i / k)).collect();
        let mut out = vec![0.0; n * n];
        lattice.evaluate(&parabola, 2, 0, &mut out);
        assert!(out.iter().all(|&v| (v - 2.0).abs() < 1e-3));
        lattice.evaluate(&parabola, 1, 0, &mut out);
        assert!((0..n * n).all(|i| (out[i] - 2.0 * ((i % n) as f32 + 0.5)).abs() < 1e-2));
        lattice.evaluate(&parabola, 0, 1, &mut out);
        assert!(out.iter().all(|&v| (v - 3.0).abs() < 1e-3));
        lattice.evaluate(&parabola, 0, 0, &mut out);
        let constant = out[0] - 0.25 - 1.5;
        assert!((0..n * n).all(|i| {
            let (x, y) = ((i % n) as f32 + 0.5, (i / n) as f32 + 0.5);
            (out[i] - x * x - 3.0 * y - constant).abs() < 2e-2
        }));
    }

    #[test]
    fn adjoint_identity() {
        let mut rng = Rng::new(1, 0);
        let (n, k) = (16, 6);
        let mut lattice = Lattice::new(n, k);
        let mut random = |count: usize| (0..count).map(|_| rng.range(-1.0, 1.0) as f32).collect::<Vec<_>>();
        let (x, y) = (random(k * k), random(n * n));
        let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum::<f64>();
        for (along_x, along_y) in [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)] {
            let (mut out, mut back) = (vec![0.0; n * n], vec![0.0; k * k]);
            lattice.evaluate(&x, along_x, along_y, &mut out);
            lattice.evaluate_vjp(&y, along_x, along_y, &mut back);
            assert!((dot(&out, &y) - dot(&x, &back)).abs() < 1e-4);
            back[0] += 0.1;
            assert!((dot(&out, &y) - dot(&x, &back)).abs() > 1e-4, "the check can fail");
        }
    }
}
