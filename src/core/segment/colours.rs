//! What colours object and ground have: mixtures of Gaussians over a palette.
//!
//! Pixels of one small cell of colour space are one entry of the palette, so that a mixture is fitted to, and asked of,
//! some thousand colours instead of all pixels.

/// Cells along each axis of colour space, and what each spans.
const CELLS: i32 = 64;
const CELL: f32 = 2.5;
/// Gaussians in a mixture (Rother, Kolmogorov and Blake 2004).
const COUNT: usize = 5;
/// Rounds of fitting.
const ROUNDS: usize = 3;
/// Variance that no Gaussian falls below: noise of a sensor, and the cells' own size.
const LEAST_VARIANCE: f64 = 2.0;
/// Share of colours that may be anything, and how dense anything is.
const ANYTHING: f64 = 1e-2;
const ANYTHING_DENSITY: f64 = 1.0 / (100.0 * 120.0 * 120.0);
/// How much is left of colours (the cube root of their light) in shadow, and each shadow's share.
const SHADOWS: [f64; 3] = [0.9, 0.8, 0.7];
const SHADOW_SHARE: f64 = 0.02;

/// Colours that occur, and which of them each pixel has.
pub struct Palette {
    /// Their means.
    pub colours: Vec<[f64; 3]>,
    /// Index of each pixel's colour.
    pub entry: Vec<u32>,
}

impl Palette {
    /// Of pixels whose channels reach from 0 to 160 and from -80 to 80.
    pub fn of(lab: &[[f32; 3]]) -> Palette {
        let cell = |[l, a, b]: [f32; 3]| {
            let place = |v: f32, shift: f32| ((v / CELL + shift) as i32).clamp(0, CELLS - 1);
            ((place(l, 0.0) * CELLS + place(a, 32.0)) * CELLS + place(b, 32.0)) as usize
        };
        let mut number = vec![u32::MAX; (CELLS * CELLS * CELLS) as usize];
        let (mut sums, mut entry) = (Vec::<[f64; 4]>::new(), Vec::with_capacity(lab.len()));
        for &colour in lab {
            let known = &mut number[cell(colour)];
            if *known == u32::MAX {
                *known = sums.len() as u32;
                sums.push([0.0; 4]);
            }
            let sum = &mut sums[*known as usize];
            (0..3).for_each(|c| sum[c] += f64::from(colour[c]));
            sum[3] += 1.0;
            entry.push(*known);
        }
        Palette { colours: sums.iter().map(|s| [s[0] / s[3], s[1] / s[3], s[2] / s[3]]).collect(), entry }
    }

    /// How often each colour occurs, by a pixel's weight.
    pub fn histogram(&self, weight: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut counts = vec![0.0; self.colours.len()];
        self.entry.iter().enumerate().for_each(|(pixel, &entry)| counts[entry as usize] += weight(pixel));
        counts
    }
}

/// A mixture of Gaussians.
pub struct Mixture(Vec<Gaussian>);

#[derive(Clone, Copy)]
struct Gaussian {
    share: f64,
    mean: [f64; 3],
    /// The covariance's inverse: xx, xy, xz, yy, yz, zz.
    inverse: [f64; 6],
    /// Logarithm of the share times the density at the mean.
    log_peak: f64,
    /// The covariance's longest axis, and the variance along it.
    axis: [f64; 3],
    spread: f64,
}

impl Mixture {
    /// Fitted to the colours, each counted `weights` times; `None` if nothing counts.
    ///
    /// The widest Gaussian is split along its longest axis until there are enough (Orchard and Bouman 1991), then every
    /// colour goes to the likeliest.
    pub fn fit(palette: &Palette, weights: &[f64]) -> Option<Mixture> {
        let total: f64 = weights.iter().sum();
        if total <= 0.0 {
            return None;
        }
        let used: Vec<usize> = (0..weights.len()).filter(|&i| weights[i] > 0.0).collect();
        let mut member = vec![0usize; weights.len()];
        let one = |member: &[usize], k: usize| {
            Gaussian::of(used.iter().filter(|&&i| member[i] == k).map(|&i| (palette.colours[i], weights[i])), total)
        };
        let mut parts = vec![one(&member, 0)?];
        while parts.len() < COUNT {
            let widest = (0..parts.len()).max_by(|&a, &b| {
                let spread = |k: usize| parts[k].share * parts[k].spread;
                spread(a).total_cmp(&spread(b))
            })?;
            let Gaussian { mean, axis, .. } = parts[widest];
            let fresh = parts.len();
            for &i in &used {
                let beyond: f64 = (0..3).map(|c| axis[c] * (palette.colours[i][c] - mean[c])).sum();
                if member[i] == widest && beyond > 0.0 {
                    member[i] = fresh;
                }
            }
            match (one(&member, widest), one(&member, fresh)) {
                (Some(a), Some(b)) => {
                    parts[widest] = a;
                    parts.push(b);
                }
                _ => break,
            }
        }
        for _ in 0..ROUNDS {
            for &i in &used {
                let best = |&a: &usize, &b: &usize| {
                    parts[a].log_density(palette.colours[i]).total_cmp(&parts[b].log_density(palette.colours[i]))
                };
                member[i] = (0..parts.len()).max_by(best)?;
            }
            let kept: Vec<Gaussian> = (0..parts.len()).filter_map(|k| one(&member, k)).collect();
            if kept.len() < parts.len() {
                parts = kept;
                // Numbers moved: members are looked for again.
                continue;
            }
            parts = kept;
        }
        Some(Mixture(parts))
    }

    /// With what its colours become in shadow: less light of the same hue.
    pub fn with_shadows(mut self) -> Mixture {
        let lit = self.0.clone();
        for dim in SHADOWS {
            self.0.extend(lit.iter().map(|part| Gaussian {
                mean: part.mean.map(|c| c * dim),
                log_peak: part.log_peak + SHADOW_SHARE.ln(),
                ..*part
            }));
        }
        self
    }

    /// Minus the logarithm of a colour's density.
    pub fn surprise(&self, colour: [f64; 3]) -> f64 {
        let density: f64 = self.0.iter().map(|part| part.log_density(colour).exp()).sum();
        -((1.0 - ANYTHING) * density + ANYTHING * ANYTHING_DENSITY).ln()
    }
}

impl Gaussian {
    /// Of colours with weights, as a share of `total`; `None` without weight.
    fn of(colours: impl Iterator<Item = ([f64; 3], f64)>, total: f64) -> Option<Gaussian> {
        let (mut mass, mut first, mut second) = (0.0, [0.0; 3], [0.0; 6]);
        const PAIRS: [[usize; 2]; 6] = [[0, 0], [0, 1], [0, 2], [1, 1], [1, 2], [2, 2]];
        for (colour, weight) in colours {
            mass += weight;
            (0..3).for_each(|c| first[c] += weight * colour[c]);
            (0..6).for_each(|k| second[k] += weight * colour[PAIRS[k][0]] * colour[PAIRS[k][1]]);
        }
        if mass <= 0.0 {
            return None;
        }
        let mean = first.map(|sum| sum / mass);
        let mut covariance = [0.0; 6];
        for (k, [i, j]) in PAIRS.into_iter().enumerate() {
            covariance[k] = second[k] / mass - mean[i] * mean[j] + if i == j { LEAST_VARIANCE } else { 0.0 };
        }
        let [xx, xy, xz, yy, yz, zz] = covariance;
        let cofactors = [yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy];
        let determinant = xx * cofactors[0] + xy * cofactors[1] + xz * cofactors[2];
        let inverse =
            [cofactors[0], cofactors[1], cofactors[2], xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy]
                .map(|cofactor| cofactor / determinant);
        let share = mass / total;
        let log_peak = share.ln() - 0.5 * (determinant.ln() + 3.0 * std::f64::consts::TAU.ln());
        // The longest axis by repeated multiplication.
        let times =
            |[x, y, z]: [f64; 3]| [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z];
        let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let mut axis = [0.8, 0.5, 0.33];
        for _ in 0..24 {
            let next = times(axis);
            axis = next.map(|c| c / length(next).max(1e-300));
        }
        Some(Gaussian { share, mean, inverse, log_peak, axis, spread: length(times(axis)) })
    }

    fn log_density(&self, colour: [f64; 3]) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|c| colour[c] - self.mean[c]);
        let [xx, xy, xz, yy, yz, zz] = self.inverse;
        let squared = x * (xx * x + 2.0 * (xy * y + xz * z)) + y * (yy * y + 2.0 * yz * z) + zz * z * z;
        self.log_peak - 0.5 * squared
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn mixtures_tell_their_colours_from_others() {
        let mut rng = Rng::new(3, 0);
        let mut near = |[l, a, b]: [f32; 3]| [l, a, b].map(|c| c + rng.range(-4.0, 4.0) as f32);
        let lab: Vec<[f32; 3]> = (0..4000)
            .map(|i| near([[80.0, 5.0, 10.0], [30.0, 40.0, 20.0], [50.0, -30.0, 10.0], [20.0, 0.0, -30.0]][i % 4]))
            .collect();
        let palette = Palette::of(&lab);
        assert!(palette.colours.len() < 1500);
        let of = |which: [usize; 2]| {
            let weights = palette.histogram(|i| f64::from(u8::from(which.contains(&(i % 4)))));
            Mixture::fit(&palette, &weights).unwrap()
        };
        let (first, second) = (of([0, 1]), of([2, 3]));
        for (i, &entry) in palette.entry.iter().enumerate() {
            let colour = palette.colours[entry as usize];
            assert_eq!(first.surprise(colour) < second.surprise(colour), i % 4 < 2, "{colour:?}");
        }
        assert!(Mixture::fit(&palette, &palette.histogram(|_| 0.0)).is_none());
        let same = Palette::of(&[[50.0, 0.0, 0.0]; 9]);
        let flat = Mixture::fit(&same, &same.histogram(|_| 1.0)).unwrap();
        assert!(flat.surprise([50.0, 0.0, 0.0]).is_finite() && flat.surprise([0.0, 60.0, 60.0]).is_finite());
    }
}
