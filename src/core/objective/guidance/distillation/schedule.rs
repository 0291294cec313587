//! How noisy a view is made, iteration by iteration.

use crate::rng::Rng;

/// The noise of a diffusion model: at time t, 1 to [`Diffusion::steps`], a picture x becomes
/// `sqrt(alphabar) x + sqrt(1 - alphabar) noise` (Ho et al. 2020, eq. 4).
#[derive(Debug, Clone, PartialEq)]
pub struct Diffusion {
    alpha_bar: Vec<f64>,
}

impl Diffusion {
    /// Betas in even steps between two, as Ho et al.: from 1e-4 to .02 over 1000.
    pub fn linear(from: f64, to: f64, steps: usize) -> Diffusion {
        Diffusion::of_betas((0..steps).map(|i| from + (to - from) * i as f64 / (steps.max(2) - 1) as f64))
    }

    /// Square roots of betas in even steps, as Stable Diffusion: from .00085 to .012 over 1000.
    pub fn scaled_linear(from: f64, to: f64, steps: usize) -> Diffusion {
        let (from, to) = (from.sqrt(), to.sqrt());
        Diffusion::of_betas((0..steps).map(|i| (from + (to - from) * i as f64 / (steps.max(2) - 1) as f64).powi(2)))
    }

    /// A squared cosine, as Nichol and Dhariwal (2021), eq. 17, with betas of .999 at most.
    pub fn cosine(steps: usize) -> Diffusion {
        let level = |t: usize| {
            let share = t as f64 / steps as f64;
            ((share + 0.008) / 1.008 * std::f64::consts::FRAC_PI_2).cos().powi(2)
        };
        Diffusion::of_betas((0..steps).map(|t| (1.0 - level(t + 1) / level(t)).min(0.999)))
    }

    fn of_betas(betas: impl Iterator<Item = f64>) -> Diffusion {
        let product = |left: &mut f64, beta: f64| {
            *left *= 1.0 - beta;
            Some(*left)
        };
        Diffusion { alpha_bar: betas.scan(1.0, product).collect() }
    }

    /// Times there are.
    pub fn steps(&self) -> usize {
        self.alpha_bar.len()
    }

    /// What is left of a picture's variance at time `t`, 1 to [`Diffusion::steps`].
    pub fn alpha_bar(&self, t: usize) -> f64 {
        self.alpha_bar[t.clamp(1, self.steps()) - 1]
    }

    /// w(t) of score distillation: 1 - alphabar (Poole et al. 2022; so in the paper's code).
    pub fn weight(&self, t: usize) -> f64 {
        1.0 - self.alpha_bar(t)
    }
}

/// How the time falls as a fit goes on: first the whole, then details.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Annealing {
    /// One time for each iteration, never later than the one before: DreamTime (Huang et al. 2024), eq. 5 and 6, with the
    /// weight `sqrt((1 - alphabar) / alphabar)` times a plateau between `most` and `least` that falls off as Gaussians.
    DreamTime {
        /// Where the plateau begins, and how wide it falls off above.
        most: [f64; 2],
        /// Where it ends, and how wide it falls off below.
        least: [f64; 2],
    },
    /// Any time between two that fall in straight lines, as shares of all times.
    Falling {
        /// The least at the start and at the end.
        least: [f64; 2],
        /// The most, likewise.
        most: [f64; 2],
    },
}

impl Annealing {
    /// DreamTime with its authors' numbers: for 1000 times.
    pub const DREAM_TIME: Annealing = Annealing::DreamTime { most: [800.0, 300.0], least: [500.0, 100.0] };
    /// As the paper's code: from .98 to .5.
    pub const FALLING: Annealing = Annealing::Falling { least: [0.02, 0.02], most: [0.98, 0.5] };
    /// For models of pixels: where there is little noise they see a wire's edges and no thing (tried in `tools/iconnet`).
    pub const OF_PIXELS: Annealing = Annealing::Falling { least: [0.3, 0.1], most: [0.98, 0.5] };

    /// The time, 1 to [`Diffusion::steps`], when `share` of the fit (0 to 1) is done.
    pub fn time(self, diffusion: &Diffusion, share: f64, rng: &mut Rng) -> usize {
        let steps = diffusion.steps();
        match self {
            Annealing::Falling { least, most } => {
                let [least, most] = [least, most].map(|[from, to]| from + (to - from) * share);
                let time = rng.range(least, most.max(least)) * steps as f64;
                (time.round() as usize).clamp(1, steps)
            }
            Annealing::DreamTime { most, least } => {
                let weight = |t: usize| {
                    let alpha_bar = diffusion.alpha_bar(t);
                    let fall = |[from, width]: [f64; 2]| (-(t as f64 - from).powi(2) / (2.0 * width * width)).exp();
                    let plateau = match t as f64 {
                        t if t > most[0] => fall(most),
                        t if t < least[0] => fall(least),
                        _ => 1.0,
                    };
                    ((1.0 - alpha_bar) / alpha_bar).sqrt() * plateau
                };
                let whole: f64 = (1..=steps).map(weight).sum();
                let mut above = 0.0;
                let off = |t: usize| {
                    above += weight(t) / whole;
                    ((above - share).abs(), t)
                };
                let nearest = (1..=steps).rev().map(off).min_by(|a, b| a.0.total_cmp(&b.0));
                nearest.map_or(1, |(_, t)| t)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alpha_bars_are_the_published_ones() {
        // Products of 1 - beta, computed once in double precision by the formulas.
        let ddpm = Diffusion::linear(1e-4, 0.02, 1000);
        let stable = Diffusion::scaled_linear(0.00085, 0.012, 1000);
        for (diffusion, t, known) in
            [(&ddpm, 1, 0.9999), (&ddpm, 1000, 4.0358e-5), (&stable, 1, 0.99915), (&stable, 1000, 4.6605e-3)]
        {
            assert!((diffusion.alpha_bar(t) / known - 1.0).abs() < 1e-3, "{t}: {}", diffusion.alpha_bar(t));
        }
        let cosine = Diffusion::cosine(1000);
        let half = ((0.508f64 / 1.008) * std::f64::consts::FRAC_PI_2).cos().powi(2);
        let first = ((0.008f64 / 1.008) * std::f64::consts::FRAC_PI_2).cos().powi(2);
        assert!((cosine.alpha_bar(500) - half / first).abs() < 1e-9);
        for diffusion in [ddpm, stable, cosine] {
            assert!((1..1000).all(|t| diffusion.alpha_bar(t + 1) < diffusion.alpha_bar(t)));
            assert!(diffusion.weight(700) > diffusion.weight(100) && diffusion.weight(1000) < 1.0);
        }
    }

    #[test]
    fn dream_time_falls_and_stays_where_its_weight_is() {
        let diffusion = Diffusion::scaled_linear(0.00085, 0.012, 1000);
        let mut rng = Rng::new(1, 1);
        let times: Vec<usize> =
            (0..=600).map(|i| Annealing::DREAM_TIME.time(&diffusion, f64::from(i) / 600.0, &mut rng)).collect();
        assert!(times.windows(2).all(|pair| pair[1] <= pair[0]), "it never rises");
        assert!(times[0] > 990 && times[600] < 60, "{} to {}", times[0], times[600]);
        // Its definition, at one place: as much weight lies above as of the fit is done.
        let weight = |t: usize| {
            let alpha_bar = diffusion.alpha_bar(t);
            let t = t as f64;
            let plateau = match t {
                t if t > 800.0 => (-(t - 800.0f64).powi(2) / (2.0 * 300.0 * 300.0)).exp(),
                t if t < 500.0 => (-(t - 500.0f64).powi(2) / (2.0 * 100.0 * 100.0)).exp(),
                _ => 1.0,
            };
            ((1.0 - alpha_bar) / alpha_bar).sqrt() * plateau
        };
        let whole: f64 = (1..=1000).map(weight).sum();
        let above: f64 = (times[300]..=1000).map(weight).sum();
        assert!((above / whole - 0.5).abs() < 2e-3, "{}", above / whole);
        // Sibling: without the root, most of the weight lies elsewhere.
        let flat: f64 = (times[300]..=1000)
            .map(|t| weight(t) / ((1.0 - diffusion.alpha_bar(t)) / diffusion.alpha_bar(t)).sqrt())
            .sum();
        let flat_whole: f64 =
            (1..=1000).map(|t| weight(t) / ((1.0 - diffusion.alpha_bar(t)) / diffusion.alpha_bar(t)).sqrt()).sum();
        assert!((flat / flat_whole - 0.5).abs() > 0.05);
    }

    #[test]
    fn the_falling_maximum_falls() {
        let diffusion = Diffusion::linear(1e-4, 0.02, 1000);
        let mut rng = Rng::new(2, 1);
        for (share, most) in [(0.0, 980), (0.5, 740), (1.0, 500)] {
            let times: Vec<usize> = (0..2000).map(|_| Annealing::FALLING.time(&diffusion, share, &mut rng)).collect();
            let (least, found) = (*times.iter().min().unwrap(), *times.iter().max().unwrap());
            assert!((20..60).contains(&least) && (most - 15..=most).contains(&found), "{least} to {found} at {share}");
        }
    }
}
