//! Second and third derivatives of the Gaussian-smoothed picture: a steerable filter bank (Freeman and Adelson 1991).
//!
//! Seven maps give the response at any angle, as polynomials of its cosine and sine. They are separable: four kernels
//! along rows, the same four along columns.

use crate::wire::Real;

/// Pixels a filter reaches to each side; nearer to the picture's border than that the maps are 0.
pub const REACH: usize = 4;
/// Number of maps: xx, xy, yy, xxx, xxy, xyy, yyy.
pub const JETS: usize = 7;
/// Standard deviation of the Gaussian, px.
const SIGMA_PX: f64 = 1.0;
/// Order along x (and so along y) of each map.
const ORDERS: [(usize, usize); JETS] = [(2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];

/// Weights of neighbours 0 to 4 px to the right, for orders 0 to 3; those to the left have the sign (-1)^order.
pub type Kernels<R> = [[R; REACH + 1]; 4];

/// The Gaussian, which sums to 1, and its derivatives; the second is freed of what its cut-off tails leave of its mean.
pub fn kernels() -> Kernels<f64> {
    let whole = |kernel: &[f64; REACH + 1]| kernel[0] + 2.0 * kernel[1..].iter().sum::<f64>();
    let bell: [f64; REACH + 1] = std::array::from_fn(|k| (-0.5 * (k as f64 / SIGMA_PX).powi(2)).exp());
    let area = whole(&bell);
    let gaussian = bell.map(|tap| tap / area);
    // Hermite polynomials. A derivative's value right of the centre as a weight of that neighbour has its sign turned.
    let derivative = |polynomial: fn(f64) -> f64| -> [f64; REACH + 1] {
        std::array::from_fn(|k| polynomial(k as f64 / SIGMA_PX) * gaussian[k])
    };
    let mut second = derivative(|u| u * u - 1.0);
    let mean = whole(&second);
    (0..=REACH).for_each(|k| second[k] -= mean * gaussian[k]);
    [gaussian, derivative(|u| u), second, derivative(|u| u * u * u - 3.0 * u)]
}

/// Factors of the second and the third derivative with which both answer 1 to a wave that lies right across them and
/// that they like best (4 px long), and ink lines on blank ground get a positive second.
pub fn gains() -> [f64; 2] {
    let kernels = kernels();
    let wave = 2.5f64.sqrt() / SIGMA_PX;
    let answer = |kernel: &[f64; REACH + 1], basis: fn(f64) -> f64| -> f64 {
        kernel[0] * basis(0.0) + 2.0 * (1..=REACH).map(|k| kernel[k] * basis(wave * k as f64)).sum::<f64>()
    };
    [1.0 / answer(&kernels[2], f64::cos), 1.0 / answer(&kernels[3], f64::sin)]
}

/// Finds the maps of pictures of one size, and the adjoint.
#[derive(Debug, Clone)]
pub struct Jet<R> {
    width: usize,
    height: usize,
    kernels: Kernels<R>,
    /// The picture filtered along rows, by order.
    rows: [Vec<R>; 4],
    /// The maps, or their adjoints; 0 within [`REACH`] of the border.
    pub maps: [Vec<R>; JETS],
    /// A row of each order's adjoint with blank ends.
    padded: [Vec<R>; 4],
}

impl<R: Real> Jet<R> {
    pub fn new(width: usize, height: usize) -> Jet<R> {
        let plane = || vec![R::zero(); width * height];
        Jet {
            width,
            height,
            kernels: kernels().map(|kernel| kernel.map(R::from_f64)),
            rows: std::array::from_fn(|_| plane()),
            maps: std::array::from_fn(|_| plane()),
            padded: std::array::from_fn(|_| vec![R::zero(); width + 2 * REACH]),
        }
    }

    /// Fills the maps.
    pub fn forward(&mut self, picture: &[R]) {
        let (width, height) = (self.width, self.height);
        if width <= 2 * REACH || height <= 2 * REACH {
            return;
        }
        let inside = REACH..width - REACH;
        for (y, row) in picture.chunks_exact(width).enumerate() {
            let neighbours: [&[R]; 2 * REACH + 1] = std::array::from_fn(|k| &row[k..k + width - 2 * REACH]);
            for (order, out) in self.rows.iter_mut().enumerate() {
                correlate(&self.kernels[order], order % 2 == 1, neighbours, &mut out[y * width..][inside.clone()]);
            }
        }
        for y in REACH..height - REACH {
            for (map, &(x_order, y_order)) in self.maps.iter_mut().zip(&ORDERS) {
                let rows = &self.rows[x_order];
                let neighbours = std::array::from_fn(|k| &rows[(y + k - REACH) * width..][inside.clone()]);
                let out = &mut map[y * width..][inside.clone()];
                correlate(&self.kernels[y_order], y_order % 2 == 1, neighbours, out);
            }
        }
    }

    /// Adds to `d_picture` what the maps, which now hold adjoints, come to.
    pub fn backward(&mut self, d_picture: &mut [R]) {
        let (width, height) = (self.width, self.height);
        if width <= 2 * REACH || height <= 2 * REACH {
            return;
        }
        let inside = 2 * REACH..width;
        for y in 0..height {
            for padded in &mut self.padded {
                padded[inside.clone()].fill(R::zero());
            }
            for (map, &(x_order, y_order)) in self.maps.iter().zip(&ORDERS) {
                let out = &mut self.padded[x_order][inside.clone()];
                // The row at y gets from map row y - k what that row took from y.
                for k in 0..=2 * REACH {
                    let Some(from) = (y + REACH).checked_sub(k).filter(|&from| from < height) else { continue };
                    let tap = signed(&self.kernels[y_order], y_order, k);
                    let source = &map[from * width + REACH..][..width - 2 * REACH];
                    out.iter_mut().zip(source).for_each(|(out, &value)| *out = *out + tap * value);
                }
            }
            let d_row = &mut d_picture[y * width..][..width];
            for (order, padded) in self.padded.iter().enumerate() {
                for k in 0..=2 * REACH {
                    let tap = signed(&self.kernels[order], order, k);
                    let source = &padded[2 * REACH - k..][..width];
                    d_row.iter_mut().zip(source).for_each(|(out, &value)| *out = *out + tap * value);
                }
            }
        }
    }
}

/// The weight of neighbour `k` of 0 to 8, the middle one being 4.
fn signed<R: Real>(kernel: &[R; REACH + 1], order: usize, k: usize) -> R {
    let tap = kernel[k.abs_diff(REACH)];
    if order % 2 == 1 && k < REACH { -tap } else { tap }
}

/// Weighs nine neighbours of each entry.
fn correlate<R: Real>(taps: &[R; REACH + 1], odd: bool, neighbours: [&[R]; 2 * REACH + 1], out: &mut [R]) {
    let count = out.len();
    let n = neighbours.map(|neighbour| &neighbour[..count]);
    for i in 0..count {
        out[i] = if odd {
            taps[1] * (n[5][i] - n[3][i])
                + taps[2] * (n[6][i] - n[2][i])
                + taps[3] * (n[7][i] - n[1][i])
                + taps[4] * (n[8][i] - n[0][i])
        } else {
            taps[0] * n[4][i]
                + taps[1] * (n[5][i] + n[3][i])
                + taps[2] * (n[6][i] + n[2][i])
                + taps[3] * (n[7][i] + n[1][i])
                + taps[4] * (n[8][i] + n[0][i])
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn random(count: usize, stream: u64) -> Vec<f64> {
        let mut rng = Rng::new(3, stream);
        (0..count).map(|_| rng.range(-1.0, 1.0)).collect()
    }

    #[test]
    fn the_adjoint_is_one() {
        for (width, height) in [(16, 12), (9, 30), (8, 8)] {
            let picture = random(width * height, 1);
            let mut jet = Jet::new(width, height);
            jet.forward(&picture);
            let maps = jet.maps.clone();
            let adjoints: Vec<Vec<f64>> = (0..JETS as u64).map(|m| random(width * height, 2 + m)).collect();
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let left: f64 = maps.iter().zip(&adjoints).map(|(map, adjoint)| dot(map, adjoint)).sum();
            // Only the inside counts: the maps are 0 elsewhere and stay so.
            for (map, adjoint) in jet.maps.iter_mut().zip(&adjoints) {
                for i in 0..map.len() {
                    let (x, y) = (i % width, i / width);
                    let inside = |p: usize, size: usize| p >= REACH && p + REACH < size;
                    map[i] = if inside(x, width) && inside(y, height) { adjoint[i] } else { 0.0 };
                }
            }
            let mut d_picture = vec![0.0; width * height];
            jet.backward(&mut d_picture);
            let right = dot(&picture, &d_picture);
            assert!((left - right).abs() <= 1e-12 * left.abs(), "{width} x {height}: {left} and {right}");
            d_picture[width * height / 2] += 0.01;
            assert!(left == 0.0 || (left - dot(&picture, &d_picture)).abs() > 1e-9, "another adjoint is seen");
        }
    }

    #[test]
    fn filters_ignore_even_ground_and_like_their_wave() {
        let (width, height) = (24, 20);
        let mut jet = Jet::new(width, height);
        jet.forward(&vec![0.7; width * height]);
        assert!(jet.maps.iter().flatten().all(|value: &f64| value.abs() < 1e-12));
        let wave = 2.5f64.sqrt();
        let picture: Vec<f64> = (0..width * height).map(|i| (wave * ((i % width) as f64 - 12.0)).cos()).collect();
        jet.forward(&picture);
        let [second, third] = gains();
        assert!((second * jet.maps[0][10 * width + 12] - 1.0).abs() < 1e-9, "a ridge's top");
        let odd = jet.maps[3].iter().fold(0.0f64, |most, value| most.max((third * value).abs()));
        assert!((odd - 1.0).abs() < 0.05, "{odd}");
        assert!(jet.maps[2].iter().chain(&jet.maps[6]).all(|value| value.abs() < 1e-9), "nothing along the wave");
    }
}
