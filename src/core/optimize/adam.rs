//! Adam (Kingma & Ba 2015) over points of N components, each component with its own rate.

use crate::{Error, Result};

/// Which gradients share a second moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SecondMoment {
    /// Every component has its own: plain Adam.
    #[default]
    PerComponent,
    /// The components of a position share the squared length of their gradient, so that a step keeps the gradient's
    /// direction: VectorAdam (Ling et al. 2022). The width keeps its own.
    PerPoint,
}

/// Adam's constants.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AdamOptions {
    /// Decay of the first moment an iteration.
    pub beta1: f64,
    /// Decay of the second moment an iteration.
    pub beta2: f64,
    /// Added to the root of the second moment.
    pub epsilon: f64,
    /// Which gradients share a second moment.
    pub second_moment: SecondMoment,
}

impl Default for AdamOptions {
    fn default() -> Self {
        AdamOptions::PLAIN
    }
}

impl AdamOptions {
    /// Usual decays, each component on its own.
    pub const PLAIN: AdamOptions =
        AdamOptions { beta1: 0.9, beta2: 0.99, epsilon: 1e-8, second_moment: SecondMoment::PerComponent };

    /// An error unless both decays lie in 0..1 and epsilon is positive.
    pub fn check(&self) -> Result<()> {
        let decays = [self.beta1, self.beta2].iter().all(|beta| (0.0..1.0).contains(beta));
        if decays && self.epsilon.is_finite() && self.epsilon > 0.0 {
            return Ok(());
        }
        Err(Error::setting(
            "adam",
            format!("beta1 {}, beta2 {}, epsilon {}", self.beta1, self.beta2, self.epsilon),
            "give decays from 0 to below 1 and an epsilon above 0",
        ))
    }
}

/// The moments of N-component parameters, and how many steps they have seen.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Adam<const N: usize> {
    /// First moments: running means of gradients.
    pub first: Vec<[f32; N]>,
    /// Second moments: running means of squared gradients.
    pub second: Vec<[f32; N]>,
    /// Steps since the moments were last zeroed.
    pub count: u32,
}

impl<const N: usize> Adam<N> {
    /// Zero moments for `count` points.
    pub fn new(count: usize) -> Self {
        Adam { first: vec![[0.0; N]; count], second: vec![[0.0; N]; count], count: 0 }
    }

    /// Forgets all moments.
    pub fn restart(&mut self) {
        self.first.fill([0.0; N]);
        self.second.fill([0.0; N]);
        self.count = 0;
    }

    /// Copies another one's moments without allocating where lengths agree.
    pub fn copy_from(&mut self, other: &Self) {
        self.first.clone_from(&other.first);
        self.second.clone_from(&other.second);
        self.count = other.count;
    }

    /// `p -= rate · m̂ / (√v̂ + ε)`, m̂ and v̂ corrected for their zero start; `rates` has one entry a component.
    pub fn step(&mut self, options: &AdamOptions, rates: &[f32; N], points: &mut [[f32; N]], gradient: &[[f32; N]]) {
        self.count += 1;
        let (beta1, beta2) = (options.beta1 as f32, options.beta2 as f32);
        let correction1 = (1.0 - options.beta1.powi(self.count as i32)) as f32;
        let correction2 = (1.0 - options.beta2.powi(self.count as i32)) as f32;
        let epsilon = options.epsilon as f32;
        let position = N.min(3);
        let moments = self.first.iter_mut().zip(&mut self.second);
        for ((point, g), (first, second)) in points.iter_mut().zip(gradient).zip(moments) {
            let mut squares = g.map(|g| g * g);
            if options.second_moment == SecondMoment::PerPoint {
                let shared = squares[..position].iter().sum();
                squares[..position].fill(shared);
            }
            for c in 0..N {
                first[c] = beta1 * first[c] + (1.0 - beta1) * g[c];
                second[c] = beta2 * second[c] + (1.0 - beta2) * squares[c];
                let root = (second[c] / correction2).sqrt() + epsilon;
                point[c] -= rates[c] * (first[c] / correction1) / root;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_steps(options: &AdamOptions) -> [f32; 2] {
        let mut adam = Adam::<2>::new(1);
        let mut points = [[1.0, 2.0]];
        adam.step(options, &[0.1, 0.2], &mut points, &[[3.0, -4.0]]);
        adam.step(options, &[0.1, 0.2], &mut points, &[[1.0, 0.0]]);
        points[0]
    }

    #[test]
    fn two_steps_by_hand() {
        // β1 .5, β2 .75. Step 1: m̂ = g, v̂ = g²: each moves by its rate. Step 2, first component:
        // m = .5·1.5 + .5·1 = 1.25, m̂ = 1.25 / .75; v = .75·2.25 + .25 = 1.9375, v̂ = 1.9375 / .4375.
        let options = AdamOptions { beta1: 0.5, beta2: 0.75, epsilon: 1e-12, ..Default::default() };
        let expected = [
            0.9 - 0.1 * (1.25 / 0.75) / (1.9375f32 / 0.4375).sqrt(),
            2.2 + 0.2 * (1.0 / 0.75) / (3.0f32 / 0.4375).sqrt(),
        ];
        let points = two_steps(&options);
        let off = |other: [f32; 2]| (0..2).fold(0.0f32, |a, c| a.max((points[c] - other[c]).abs()));
        assert!(off(expected) < 1e-6, "{points:?} {expected:?}");
        assert!(off(two_steps(&AdamOptions { beta2: 0.7, ..options })) > 1e-3, "another decay, other steps");
    }

    #[test]
    fn a_shared_second_moment_keeps_the_direction() {
        let direction = |second_moment| {
            let options = AdamOptions { second_moment, ..Default::default() };
            let mut points = [[0.0f32; 4]];
            Adam::new(1).step(&options, &[1.0; 4], &mut points, &[[0.3, 0.4, 0.0, 7.0]]);
            points[0]
        };
        let shared = direction(SecondMoment::PerPoint);
        assert!((shared[0] + 0.6).abs() < 1e-5 && (shared[1] + 0.8).abs() < 1e-5 && (shared[3] + 1.0).abs() < 1e-5);
        let plain = direction(SecondMoment::PerComponent);
        assert!((plain[0] + 1.0).abs() < 1e-5 && (plain[1] + 1.0).abs() < 1e-5);
    }

    #[test]
    fn restart_forgets() {
        let mut adam = Adam::<2>::new(1);
        let step = |adam: &mut Adam<2>, g: f32| {
            let mut points = [[0.0, 0.0]];
            adam.step(&AdamOptions::default(), &[0.1, 0.1], &mut points, &[[g, g]]);
            points[0]
        };
        let fresh = step(&mut adam, 1.0);
        assert_ne!(step(&mut adam, -2.0), [0.1, 0.1]);
        adam.restart();
        assert_eq!(step(&mut adam, 1.0), fresh);
    }

    #[test]
    fn constants_out_of_range_are_refused() {
        for (beta1, beta2, epsilon) in [(1.0, 0.9, 1e-8), (0.9, f64::NAN, 1e-8), (0.9, 0.9, 0.0)] {
            let options = AdamOptions { beta1, beta2, epsilon, ..Default::default() };
            assert!(options.check().is_err());
        }
        assert!(AdamOptions::default().check().is_ok());
    }
}
