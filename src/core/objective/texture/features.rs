//! What a texture's statistics are taken of: which way lines run at each place, and how much ink there is.

use super::jet::{JETS, Jet, REACH, gains};
use crate::wire::Real;

/// Directions that are told apart, evenly over half a turn.
pub const DIRECTIONS: usize = 6;
/// Maps of features: a direction each, then ink.
pub const FEATURES: usize = DIRECTIONS + 1;
/// Squared amplitude below which there is no line to speak of: keeps the root's slope finite.
pub const FAINT: f64 = 1e-3;

/// Weights of the maps in the even and the odd response at one angle, in the maps' order.
pub type Steering<R> = [R; JETS];

/// For each direction: weights of the first three maps in the even response, and of the other four in the odd one.
pub fn steering() -> [Steering<f64>; DIRECTIONS] {
    let [second, third] = gains();
    std::array::from_fn(|d| {
        let (sin, cos) = (std::f64::consts::PI * d as f64 / DIRECTIONS as f64).sin_cos();
        let even = [cos * cos, 2.0 * cos * sin, sin * sin].map(|weight| second * weight);
        let odd = [cos.powi(3), 3.0 * cos * cos * sin, 3.0 * cos * sin * sin, sin.powi(3)].map(|weight| third * weight);
        [even[0], even[1], even[2], odd[0], odd[1], odd[2], odd[3]]
    })
}

/// Pixels that are worked on at once: what vector registers like.
const LANES: usize = 8;
type Lanes<R> = [R; LANES];

/// The even and the odd response, and the root of their squares' sum.
#[inline(always)]
fn respond<R: Real>(weights: &Steering<R>, jets: &[Lanes<R>; JETS]) -> [Lanes<R>; 3] {
    let faint = R::from_f64(FAINT);
    let mut out = [[R::zero(); LANES]; 3];
    for i in 0..LANES {
        let even = weights[0] * jets[0][i] + weights[1] * jets[1][i] + weights[2] * jets[2][i];
        let odd =
            (weights[3] * jets[3][i] + weights[4] * jets[4][i]) + (weights[5] * jets[5][i] + weights[6] * jets[6][i]);
        out[0][i] = even;
        out[1][i] = odd;
        out[2][i] = (even * even + odd * odd + faint).sqrt();
    }
    out
}

/// Up to [`LANES`] values from `start` on; 0 beyond `end`.
#[inline(always)]
fn load<R: Real>(values: &[R], start: usize, end: usize) -> Lanes<R> {
    let mut lanes = [R::zero(); LANES];
    match values.get(start..start + LANES) {
        Some(whole) if start + LANES <= end => lanes.copy_from_slice(whole),
        _ => lanes.iter_mut().zip(&values[start..end]).for_each(|(lane, &value)| *lane = value),
    }
    lanes
}

/// Features of pictures of one size, at half that size, and the adjoint.
#[derive(Debug, Clone)]
pub struct Features<R> {
    width: usize,
    height: usize,
    steering: [Steering<R>; DIRECTIONS],
    jet: Jet<R>,
}

impl<R: Real> Features<R> {
    /// For pictures of `width` x `height`.
    pub fn new(width: usize, height: usize) -> Features<R> {
        let steering = steering().map(|weights| weights.map(R::from_f64));
        Features { width, height, steering, jet: Jet::new(width, height) }
    }

    /// Fills the directions' maps, of `width / 2` x `height / 2`: √(even² + odd² + ε) - √ε, averaged over 2 x 2 pixels.
    pub fn forward(&mut self, picture: &[R], maps: &mut [Vec<R>; FEATURES]) {
        let (width, half) = (self.width, self.width / 2);
        self.jet.forward(picture);
        let (quarter, faint) = (R::from_f64(0.25), R::from_f64(FAINT).sqrt());
        for y in 0..self.height / 2 {
            for start in (0..2 * half).step_by(LANES) {
                let at =
                    |row: usize| self.jet.maps.each_ref().map(|map| load(map, row * width + start, (row + 1) * width));
                let (upper, lower) = (at(2 * y), at(2 * y + 1));
                let count = (LANES / 2).min(half - start / 2);
                for (weights, map) in self.steering.iter().zip(&mut *maps) {
                    let (upper, lower) = (respond(weights, &upper)[2], respond(weights, &lower)[2]);
                    let sums: Lanes<R> = std::array::from_fn(|i| upper[i] + lower[i]);
                    let out: [R; LANES / 2] =
                        std::array::from_fn(|i| quarter * (sums[2 * i] + sums[2 * i + 1]) - faint);
                    map[y * half + start / 2..][..count].copy_from_slice(&out[..count]);
                }
            }
        }
    }

    /// Adds to `d_picture` what the directions' adjoints come to. Uses up what [`Features::forward`] found.
    pub fn backward(&mut self, d_maps: &[Vec<R>; FEATURES], d_picture: &mut [R]) {
        let (width, half) = (self.width, self.width / 2);
        let quarter = R::from_f64(0.25);
        for y in 0..self.height {
            let (row, end) = (y * width, (y + 1) * width);
            for start in (0..width).step_by(LANES) {
                let jets = self.jet.maps.each_ref().map(|map| load(map, row + start, end));
                let mut sums = [[R::zero(); LANES]; JETS];
                for (weights, d_map) in self.steering.iter().zip(d_maps) {
                    let pooled = match y / 2 < self.height / 2 {
                        true => load(d_map, (y / 2) * half + (start / 2).min(half), (y / 2 + 1) * half),
                        false => [R::zero(); LANES],
                    };
                    let [even, odd, amplitude] = respond(weights, &jets);
                    for i in 0..LANES {
                        let pull = quarter * pooled[i / 2] / amplitude[i];
                        let (even, odd) = (pull * even[i], pull * odd[i]);
                        for m in 0..JETS {
                            sums[m][i] = sums[m][i] + weights[m] * if m < 3 { even } else { odd };
                        }
                    }
                }
                let inside_y = y >= REACH && y + REACH < self.height;
                for (map, sums) in self.jet.maps.iter_mut().zip(&sums) {
                    let out = &mut map[row + start..(row + start + LANES).min(end)];
                    for (i, (out, &sum)) in out.iter_mut().zip(sums).enumerate() {
                        let inside = inside_y && start + i >= REACH && start + i + REACH < width;
                        *out = if inside { sum } else { R::zero() };
                    }
                }
            }
        }
        self.jet.backward(d_picture);
    }
}
