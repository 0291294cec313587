//! The pull to a surface: squared distances of samples from the planes that touch it next to them.

use crate::wire::Real;

/// `weight` times the mean over the samples of (n · x - d)², planes being `[n, d]` with unit normals, world units; adds
/// its gradient to `d_samples` (x, y and z). Without planes there is no pull.
pub fn surface_and_gradient<R: Real>(samples: &[[R; 4]], planes: &[[R; 4]], weight: R, d_samples: &mut [[R; 4]]) -> R {
    if planes.is_empty() {
        return R::zero();
    }
    let share = weight / R::from_f64(samples.len() as f64);
    let double = share + share;
    let mut total = R::zero();
    for ((sample, plane), d_sample) in samples.iter().zip(planes).zip(d_samples) {
        let off = plane[0] * sample[0] + plane[1] * sample[1] + plane[2] * sample[2] - plane[3];
        total = total + off * off;
        for c in 0..3 {
            d_sample[c] = d_sample[c] + double * off * plane[c];
        }
    }
    share * total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn gradients_agree_with_central_differences() {
        let mut rng = Rng::new(1, 0);
        let mut random = || -> [f64; 4] { std::array::from_fn(|_| rng.range(-1.0, 1.0)) };
        let mut samples: Vec<[f64; 4]> = (0..9).map(|_| random()).collect();
        let planes: Vec<[f64; 4]> = (0..9).map(|_| random()).collect();
        let mut gradient = vec![[0.0; 4]; 9];
        surface_and_gradient(&samples, &planes, 0.3, &mut gradient);
        let (mut worst, mut size) = (0.0f64, 0.0f64);
        for i in 0..9 {
            for c in 0..4 {
                let mut at = |h: f64| {
                    samples[i][c] += h;
                    let loss = surface_and_gradient(&samples, &planes, 0.3, &mut vec![[0.0; 4]; 9]);
                    samples[i][c] -= h;
                    loss
                };
                worst = worst.max(((at(1e-4) - at(-1e-4)) / 2e-4 - gradient[i][c]).abs());
                size = size.max(gradient[i][c].abs());
            }
        }
        assert!(worst < 1e-9, "{worst}");
        assert!(size > 1e-2, "{size}: an error of a hundredth would be seen");
    }

    #[test]
    fn the_loss_is_the_mean_squared_distance() {
        let samples = [[1.0, 2.0, 3.0, 0.1], [0.0, 0.5, 0.0, 0.1f32]];
        let planes = [[1.0, 0.0, 0.0, 0.5], [0.0, 1.0, 0.0, 0.5]];
        let mut gradient = [[0.0; 4]; 2];
        assert_eq!(surface_and_gradient(&samples, &planes, 8.0, &mut gradient), 1.0);
        assert_eq!(gradient, [[4.0, 0.0, 0.0, 0.0], [0.0; 4]]);
        assert_eq!(surface_and_gradient(&samples, &[], 8.0, &mut gradient), 0.0, "no planes, no pull");
    }
}
