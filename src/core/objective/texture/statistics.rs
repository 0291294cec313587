//! Which directions a texture has, and how its features go together, here and some pixels away.

use super::features::{DIRECTIONS, FEATURES};
use super::jet::REACH;
use crate::wire::Real;

/// Where the second of two features is taken, in pixels of the features' maps: the same place, and steps to all sides.
pub const SHIFTS: [(isize, isize); 5] = [(0, 0), (3, 0), (0, 3), (2, 2), (-2, 2)];
/// Pixels along the border of the features' maps where filters see too little.
pub const MARGIN: usize = REACH / 2;
/// Variance below which there is nothing to compare: of all directions' amplitudes, and of the ink.
pub const FAINT: f64 = 1e-4;

/// For each feature how it goes with each.
type Gram<R> = [[R; FEATURES]; FEATURES];

/// A level's statistics. None depends on how strong the lines are or on how much ink there is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics<R> {
    /// Each direction's share of the mean amplitude.
    pub directions: [R; DIRECTIONS],
    /// For each shift: covariance of a feature here and another there, over the scales of both. The directions' scale is
    /// the deviation of all their amplitudes together, the ink's is its own.
    pub together: [Gram<R>; SHIFTS.len()],
}

impl<R: Real> Statistics<R> {
    fn none() -> Self {
        let zero = R::zero();
        Statistics { directions: [zero; DIRECTIONS], together: [[[zero; FEATURES]; FEATURES]; SHIFTS.len()] }
    }

    /// In another precision.
    pub fn map<S: Real>(&self, round: impl Fn(R) -> S + Copy) -> Statistics<S> {
        Statistics {
            directions: self.directions.map(round),
            together: self.together.map(|gram| gram.map(|row| row.map(round))),
        }
    }

    /// Squared distance from what is `wanted`, for each of the two parts relative to the wanted one's squares, and its
    /// gradient.
    pub fn distance(&self, wanted: &Self) -> (R, Self) {
        let mut gradient = Self::none();
        let (found_flat, wanted_flat) =
            (self.together.as_flattened().as_flattened(), wanted.together.as_flattened().as_flattened());
        let gradient_flat = gradient.together.as_flattened_mut().as_flattened_mut();
        let distance = relative(&self.directions, &wanted.directions, &mut gradient.directions)
            + relative(found_flat, wanted_flat, gradient_flat);
        (distance, gradient)
    }
}

/// |found - wanted|² / |wanted|² and its gradient.
fn relative<R: Real>(found: &[R], wanted: &[R], gradient: &mut [R]) -> R {
    let size = wanted.iter().map(|&w| w * w).sum::<R>() + R::from_f64(1e-12);
    let mut squares = R::zero();
    for ((gradient, &f), &w) in gradient.iter_mut().zip(found).zip(wanted) {
        let off = f - w;
        squares = squares + off * off;
        *gradient = (off + off) / size;
    }
    squares / size
}

/// How much each pixel of the features' maps counts.
#[derive(Debug, Clone)]
pub struct Weights<R> {
    width: usize,
    height: usize,
    /// Row by row, 0 in the margin.
    pub values: Vec<R>,
    /// Their sum.
    pub total: R,
    /// For each shift the sum over all pairs of the product of both.
    pub pairs: [R; SHIFTS.len()],
}

impl<R: Real> Weights<R> {
    /// For maps of `width` x `height`.
    pub fn new(width: usize, height: usize) -> Weights<R> {
        let zero = R::zero();
        Weights { width, height, values: vec![zero; width * height], total: zero, pairs: [zero; SHIFTS.len()] }
    }

    /// Takes over other weights.
    pub fn set(&mut self, weights: &[R]) {
        let (width, height) = (self.width, self.height);
        if width <= 2 * MARGIN {
            return;
        }
        for y in MARGIN..height.saturating_sub(MARGIN) {
            let inside = y * width + MARGIN..(y + 1) * width - MARGIN;
            self.values[inside.clone()].copy_from_slice(&weights[inside]);
        }
        self.total = self.values.iter().copied().sum();
        for (pairs, &shift) in self.pairs.iter_mut().zip(&SHIFTS) {
            let sums = rows(width, height, shift).map(|(here, there)| dot(&self.values[here], &self.values[there]));
            *pairs = sums.sum::<R>() + R::from_f64(1e-12);
        }
    }

    /// Whether there is anything to look at.
    pub fn count(&self) -> bool {
        self.total > R::one()
    }
}

/// Takes statistics of maps of one size under weights, and the adjoint.
#[derive(Debug, Clone)]
pub struct Survey<R> {
    width: usize,
    height: usize,
    /// The features less their means.
    centred: [Vec<R>; FEATURES],
    weights: Weights<R>,
    means: [R; FEATURES],
    /// Variance of all amplitudes, and of the ink.
    variances: [R; 2],
    found: Statistics<R>,
    /// A row of each feature times the weights of both places.
    row: [Vec<R>; FEATURES],
}

/// Which of [`Survey::variances`] is a feature's.
fn kind(feature: usize) -> usize {
    usize::from(feature >= DIRECTIONS)
}

impl<R: Real> Survey<R> {
    /// For maps of `width` x `height`.
    pub fn new(width: usize, height: usize) -> Survey<R> {
        let zero = R::zero();
        Survey {
            width,
            height,
            centred: std::array::from_fn(|_| vec![zero; width * height]),
            weights: Weights::new(width, height),
            means: [zero; FEATURES],
            variances: [zero; 2],
            found: Statistics::none(),
            row: std::array::from_fn(|_| vec![zero; width]),
        }
    }

    /// The statistics of `maps`; none where the weights leave nothing to look at.
    pub fn take(&mut self, maps: &[Vec<R>; FEATURES], weights: &[R]) -> Option<&Statistics<R>> {
        let (width, height) = (self.width, self.height);
        self.weights.set(weights);
        if !self.weights.count() {
            return None;
        }
        for ((map, centred), mean) in maps.iter().zip(&mut self.centred).zip(&mut self.means) {
            *mean = dot(map, &self.weights.values) / self.weights.total;
            centred.iter_mut().zip(map).for_each(|(centred, &value)| *centred = value - *mean);
        }
        let mut grams = Statistics::none().together;
        for (s, &shift) in SHIFTS.iter().enumerate() {
            for (here, there) in rows(width, height, shift) {
                self.weigh(here, there.clone());
                for (weighed, sums) in self.row.iter().zip(&mut grams[s]) {
                    for (centred, sum) in self.centred.iter().zip(sums) {
                        *sum = *sum + dot(&weighed[..there.len()], &centred[there.clone()]);
                    }
                }
            }
            let pairs = self.weights.pairs[s];
            grams[s].as_flattened_mut().iter_mut().for_each(|sum| *sum = *sum / pairs);
        }
        self.variances = [R::from_f64(FAINT); 2];
        for f in 0..FEATURES {
            self.variances[kind(f)] = self.variances[kind(f)] + grams[0][f][f];
        }
        let scales = self.variances.map(R::sqrt);
        for (gram, found) in grams.iter().zip(&mut self.found.together) {
            for (i, (row, found)) in gram.iter().zip(found).enumerate() {
                for (j, (&value, found)) in row.iter().zip(found).enumerate() {
                    *found = value / (scales[kind(i)] * scales[kind(j)]);
                }
            }
        }
        let amplitude = self.amplitude();
        for (share, &mean) in self.found.directions.iter_mut().zip(&self.means) {
            *share = mean / amplitude;
        }
        Some(&self.found)
    }

    /// Mean amplitude of all directions.
    pub fn amplitude(&self) -> R {
        self.means[..DIRECTIONS].iter().copied().sum::<R>() + R::from_f64(FAINT)
    }

    /// Fills `d_maps` with the gradient to the maps last seen, from the gradient to their statistics.
    pub fn pull_back(&mut self, gradient: &Statistics<R>, d_maps: &mut [Vec<R>; FEATURES]) {
        let scales = self.variances.map(R::sqrt);
        let mut d_grams = gradient.together;
        let mut d_variances = [R::zero(); 2];
        let half = R::from_f64(0.5);
        for (d_gram, found) in d_grams.iter_mut().zip(&self.found.together) {
            for (i, (d_row, found)) in d_gram.iter_mut().zip(found).enumerate() {
                for (j, (d, &found)) in d_row.iter_mut().zip(found).enumerate() {
                    for kind in [kind(i), kind(j)] {
                        d_variances[kind] = d_variances[kind] - half * *d * found / self.variances[kind];
                    }
                    *d = *d / (scales[kind(i)] * scales[kind(j)]);
                }
            }
        }
        for f in 0..FEATURES {
            d_grams[0][f][f] = d_grams[0][f][f] + d_variances[kind(f)];
        }
        let (width, height) = (self.width, self.height);
        d_maps.iter_mut().for_each(|map| map.fill(R::zero()));
        for (s, &shift) in SHIFTS.iter().enumerate() {
            for (here, there) in rows(width, height, shift) {
                let count = here.len();
                let weights = (&self.weights.values[here.clone()], &self.weights.values[there.clone()]);
                // The first of each pair, from the second one, and the other way round.
                for (from, to, turned) in [(&there, &here, false), (&here, &there, true)] {
                    let values = self.centred.each_ref().map(|map| &map[from.clone()][..count]);
                    for f in 0..FEATURES {
                        let factors: [R; FEATURES] = std::array::from_fn(|g| {
                            (if turned { d_grams[s][g][f] } else { d_grams[s][f][g] }) / self.weights.pairs[s]
                        });
                        let d_map = &mut d_maps[f][to.clone()][..count];
                        let (a, b) = (&weights.0[..count], &weights.1[..count]);
                        for x in 0..count {
                            let mut sum = R::zero();
                            for g in 0..FEATURES {
                                sum = sum + factors[g] * values[g][x];
                            }
                            d_map[x] = d_map[x] + a[x] * b[x] * sum;
                        }
                    }
                }
            }
        }
        let amplitude = self.amplitude();
        let lost: R = gradient.directions.iter().zip(&self.found.directions).map(|(&d, &share)| d * share).sum();
        for (f, d_map) in d_maps.iter_mut().enumerate() {
            let direct = if f < DIRECTIONS { (gradient.directions[f] - lost) / amplitude } else { R::zero() };
            // Through the mean.
            let through = (direct - d_map.iter().copied().sum::<R>()) / self.weights.total;
            d_map.iter_mut().zip(&self.weights.values).for_each(|(d, &weight)| *d = *d + through * weight);
        }
    }

    /// Begins the rows with the features at `here` times both places' weights.
    fn weigh(&mut self, here: std::ops::Range<usize>, there: std::ops::Range<usize>) {
        for (row, centred) in self.row.iter_mut().zip(&self.centred) {
            let weights = self.weights.values[here.clone()].iter().zip(&self.weights.values[there.clone()]);
            for ((out, &value), (&a, &b)) in row.iter_mut().zip(&centred[here.clone()]).zip(weights) {
                *out = a * b * value;
            }
        }
    }
}

/// Row by row the places of all pairs that are `shift` apart.
fn rows(
    width: usize,
    height: usize,
    (dx, dy): (isize, isize),
) -> impl Iterator<Item = (std::ops::Range<usize>, std::ops::Range<usize>)> {
    let (left, right) = ((-dx).max(0) as usize, dx.max(0) as usize);
    let count = width.saturating_sub(left + right);
    let down = dy.max(0) as usize;
    (0..height.saturating_sub(down)).map(move |y| {
        let (here, there) = (y * width + left, (y + down) * width + right);
        (here..here + count, there..there + count)
    })
}

/// In eight interleaved sums, so that it can use vector registers.
fn dot<R: Real>(a: &[R], b: &[R]) -> R {
    let mut sums = [R::zero(); 8];
    let (a_chunks, b_chunks) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: R = a_chunks.remainder().iter().zip(b_chunks.remainder()).map(|(&a, &b)| a * b).sum();
    for (a, b) in a_chunks.zip(b_chunks) {
        for k in 0..8 {
            sums[k] = sums[k] + a[k] * b[k];
        }
    }
    sums.into_iter().sum::<R>() + rest
}
