//! Numbers that come one after another, written as what is surprising about them: several guesses of the next one, each
//! a bell of some width, are mixed by how well they did so far, and the mixture's probabilities are range coded.
//!
//! Doubles, but only `+ - * /`, square roots and `floor`, whose results IEEE 754 fixes to the last bit: the page's reader
//! (`guess.ts`) does the same in the same order.

use super::range::{Coder, Model, NumberModels};

/// Numbers that a guess is made from.
pub const INPUTS: usize = 4;

/// Bins round the guess that a number may fall in; what is further out is escaped.
const BINS: usize = 64;
const BIN_BITS: u32 = 6;
/// Bins are doubled until the typical miss is at most this many.
const TYPICAL_BINS: f64 = 6.0;
/// Numbers stay within this, whatever a damaged code says.
pub const MAX_NUMBER: i64 = 1 << 27;

/// A weighted sum of the inputs, fitted to all numbers so far (recursive least squares with slow forgetting).
struct Fit {
    weights: [f64; INPUTS],
    inverse: [[f64; INPUTS]; INPUTS],
}

const FORGETTING: f64 = 0.998;
/// How far the weights may go from those given at first.
const FREEDOM: f64 = 0.01;

impl Fit {
    fn new(weights: [f64; INPUTS]) -> Fit {
        let mut inverse = [[0.0; INPUTS]; INPUTS];
        for (k, row) in inverse.iter_mut().enumerate() {
            row[k] = FREEDOM;
        }
        Fit { weights, inverse }
    }

    fn guess(&self, inputs: &[f64; INPUTS]) -> f64 {
        self.weights.iter().zip(inputs).fold(0.0, |sum, (weight, input)| sum + weight * input)
    }

    fn learn(&mut self, inputs: &[f64; INPUTS], number: f64) {
        let gain = self.inverse.map(|row| row.iter().zip(inputs).fold(0.0, |sum, (p, input)| sum + p * input));
        let scale = inputs.iter().zip(&gain).fold(FORGETTING, |sum, (input, g)| sum + input * g);
        let miss = number - self.guess(inputs);
        for i in 0..INPUTS {
            self.weights[i] += gain[i] / scale * miss;
        }
        for i in 0..INPUTS {
            for j in 0..INPUTS {
                self.inverse[i][j] = (self.inverse[i][j] - gain[i] * gain[j] / scale) / FORGETTING;
            }
        }
        let trace = (0..INPUTS).fold(0.0, |sum, k| sum + self.inverse[k][k]);
        let sound = self.weights.iter().all(|weight| weight.abs() < 16.0) && trace > 0.0 && trace < 1e6;
        if !sound {
            *self = Fit::new([1.0, 0.0, 0.0, 0.0]);
        }
    }
}

/// Means of what a guess misses by, over the last fifty and the last seven numbers.
#[derive(Clone, Copy)]
struct Misses {
    slow: f64,
    fast: f64,
}

impl Misses {
    fn learn(&mut self, miss: f64) {
        self.slow += (miss - self.slow) * 0.02;
        self.fast += (miss - self.fast) * 0.15;
    }
}

/// A bell `(1 + x²/3)^-3` about a guess.
#[derive(Clone, Copy)]
struct Bell {
    centre: f64,
    width: f64,
}

impl Bell {
    fn new(centre: f64, miss: f64) -> Bell {
        Bell { centre, width: miss.max(0.2) * 1.5 }
    }

    fn at(&self, x: f64) -> f64 {
        let t = (x - self.centre) / self.width;
        let a = 1.0 + t * t / 3.0;
        1.0 / (a * a * a)
    }
}

const BELLS: usize = 6;
/// A coordinate's last experts know how far it is from one point to the next as well.
const EXPERTS: usize = BELLS + 3;

/// How well each expert did so far.
struct Mixture {
    shares: [f64; EXPERTS],
    count: usize,
    outside: Model,
    escaped: NumberModels,
}

/// Every expert gets this much of the trust back after each number.
const FORGIVEN: f64 = 0.02;

impl Mixture {
    fn new(count: usize) -> Mixture {
        let mut shares = [0.0; EXPERTS];
        shares[..count].fill(1.0 / count as f64);
        Mixture { shares, count, outside: Model::default(), escaped: NumberModels::default() }
    }

    /// A number about `centre`, in bins of 2^`doublings`, by the experts' probability densities.
    fn number(
        &mut self,
        coder: &mut impl Coder,
        number: i64,
        centre: i64,
        doublings: u32,
        density: impl Fn(usize, f64) -> f64,
    ) -> i64 {
        let start = centre - ((BINS as i64 / 2) << doublings);
        let bin = (number - start) >> doublings;
        if coder.bit(!(0..BINS as i64).contains(&bin), &mut self.outside) {
            let read = centre + coder.number(number - centre, &mut self.escaped);
            return read.clamp(-MAX_NUMBER, MAX_NUMBER);
        }
        let half = ((1i64 << doublings) - 1) as f64 / 2.0;
        let mut densities = [[0.0; BINS]; EXPERTS];
        let mut mixed = [0.0; BINS];
        for expert in 0..self.count {
            let mut sum = 0.0;
            for (k, out) in densities[expert].iter_mut().enumerate() {
                *out = density(expert, (start + ((k as i64) << doublings)) as f64 + half);
                sum += *out;
            }
            for (out, mixed) in densities[expert].iter_mut().zip(&mut mixed) {
                *out /= sum;
                *mixed += self.shares[expert] * *out;
            }
        }
        let read = choose(coder, bin as usize & (BINS - 1), &mixed);
        let mut sum = 0.0;
        for expert in 0..self.count {
            self.shares[expert] *= densities[expert][read] + 1e-9;
            sum += self.shares[expert];
        }
        for share in &mut self.shares[..self.count] {
            *share = (1.0 - FORGIVEN) * *share / sum + FORGIVEN / self.count as f64;
        }
        let low = (0..doublings)
            .rev()
            .fold(0, |read, k| (read << 1) | i64::from(coder.flag(((number - start) >> k) & 1 == 1)));
        (start + ((read as i64) << doublings) + low).clamp(-MAX_NUMBER, MAX_NUMBER)
    }
}

/// One of the bins, by halving.
fn choose(coder: &mut impl Coder, bin: usize, weights: &[f64; BINS]) -> usize {
    let mut sums = [0.0; 2 * BINS];
    sums[BINS..].copy_from_slice(weights);
    for node in (1..BINS).rev() {
        sums[node] = sums[2 * node] + sums[2 * node + 1];
    }
    let mut node = 1;
    for k in (0..BIN_BITS).rev() {
        let one = (sums[2 * node + 1] / sums[node] * 65_536.0).floor().clamp(1.0, 65_535.0);
        let bit = coder.split(bin >> k & 1 == 1, one as u32, 16);
        node = 2 * node + usize::from(bit);
    }
    node - BINS
}

/// Writes or reads a series of `N` numbers at a time: coordinates (3) or widths (1).
pub struct Series<const N: usize> {
    fit: Fit,
    misses: [Misses; 2],
    mixtures: [Mixture; N],
    /// Mean distance from one point to the next over many and over few points, and how much it differs from that.
    distance: [f64; 2],
    unevenness: f64,
}

impl<const N: usize> Series<N> {
    /// With the weights of the inputs at first.
    pub fn new(weights: [f64; INPUTS]) -> Series<N> {
        let count = |slot: usize| if slot == 2 { EXPERTS } else { BELLS };
        Series {
            fit: Fit::new(weights),
            misses: [Misses { slow: 4.0, fast: 4.0 }; 2],
            mixtures: std::array::from_fn(|slot| Mixture::new(count(slot))),
            distance: [12.0; 2],
            unevenness: 1.0,
        }
    }

    /// The next numbers, which are steps from the last. `plain` is a first guess of them, `inputs` what a better one is
    /// made from.
    pub fn next(
        &mut self,
        coder: &mut impl Coder,
        numbers: [i64; N],
        plain: [f64; N],
        inputs: &[[f64; INPUTS]; N],
    ) -> [i64; N] {
        let most = MAX_NUMBER as f64;
        let fitted: [f64; N] = std::array::from_fn(|c| self.fit.guess(&inputs[c]).clamp(-most, most));
        // The longest last: the distance to the next point, which is much the same everywhere, then tells it.
        let mut order: [usize; N] = std::array::from_fn(|c| c);
        order.sort_by(|&a, &b| fitted[a].abs().total_cmp(&fitted[b].abs()));
        let [of_plain, of_fitted] = self.misses;
        let mut doublings = 0;
        while of_fitted.slow.max(of_fitted.fast) > TYPICAL_BINS * f64::from(1u32 << doublings) {
            doublings += 1;
        }
        let mut read = [0; N];
        let mut squares = 0.0;
        for (slot, c) in order.into_iter().enumerate() {
            let bells = [
                Bell::new(plain[c], of_plain.slow),
                Bell::new(fitted[c], of_fitted.slow * 0.7),
                Bell::new(fitted[c], of_fitted.fast * 0.6),
                Bell::new(fitted[c], of_fitted.fast * 1.2),
                Bell::new(fitted[c], of_fitted.slow * 1.5),
                Bell::new(plain[c], of_plain.fast),
            ];
            let rings = [
                (bells[1], Bell::new(self.distance[0], self.unevenness)),
                (bells[2], Bell::new(self.distance[1], self.unevenness)),
                (bells[4], Bell::new(self.distance[0], self.unevenness * 0.5)),
            ];
            let density = |expert: usize, x: f64| match bells.get(expert) {
                Some(bell) => bell.at(x),
                None => {
                    let (bell, ring) = &rings[expert - BELLS];
                    bell.at(x) * ring.at((squares + x * x).sqrt())
                }
            };
            let centre = (fitted[c] + 0.5).floor() as i64;
            read[c] = self.mixtures[slot].number(coder, numbers[c], centre, doublings, density);
            squares += (read[c] * read[c]) as f64;
        }
        self.learn(&read, plain, fitted, inputs, squares.sqrt());
        read
    }

    fn learn(
        &mut self,
        read: &[i64; N],
        plain: [f64; N],
        fitted: [f64; N],
        inputs: &[[f64; INPUTS]; N],
        distance: f64,
    ) {
        self.unevenness += ((distance - self.distance[0]).abs() - self.unevenness) * 0.03;
        self.distance[0] += (distance - self.distance[0]) * 0.03;
        self.distance[1] += (distance - self.distance[1]) * 0.2;
        let miss = |guess: [f64; N]| (0..N).fold(0.0, |sum, c| sum + (read[c] as f64 - guess[c]).abs()) / N as f64;
        self.misses[0].learn(miss(plain));
        self.misses[1].learn(miss(fitted));
        for c in 0..N {
            self.fit.learn(&inputs[c], read[c] as f64);
        }
    }
}
