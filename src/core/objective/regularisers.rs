//! Regularisers of the curve that need its samples. (Jerk is an exact integral over the knots: [`crate::wire::Jerk`].)

use crate::wire::{Real, Stroke};

/// Length of the sampled polylines in world units times `weight`; adds its gradient to `d_samples` (x, y and z).
pub fn length_and_gradient<R: Real>(samples: &[[R; 4]], strokes: &[Stroke], weight: R, d_samples: &mut [[R; 4]]) -> R {
    let mut total = R::zero();
    for stroke in strokes.iter().filter(|stroke| stroke.count > 1) {
        let mut add = |a: usize, b: usize| {
            let step = [0, 1, 2].map(|c| samples[b][c] - samples[a][c]);
            let length = (step[0] * step[0] + step[1] * step[1] + step[2] * step[2]).sqrt();
            total = total + length;
            if length > R::from_f64(1e-12) {
                for c in 0..3 {
                    let pull = weight * step[c] / length;
                    d_samples[a][c] = d_samples[a][c] - pull;
                    d_samples[b][c] = d_samples[b][c] + pull;
                }
            }
        };
        for i in stroke.start..stroke.start + stroke.count - 1 {
            add(i, i + 1);
        }
        if stroke.closed {
            add(stroke.start + stroke.count - 1, stroke.start);
        }
    }
    weight * total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn length_gradient_agrees_with_central_differences() {
        let mut rng = Rng::new(1, 0);
        let mut samples: Vec<[f64; 4]> = (0..12).map(|_| std::array::from_fn(|_| rng.range(-1.0, 1.0))).collect();
        let strokes = [Stroke { start: 0, count: 5, closed: true }, Stroke { start: 5, count: 6, closed: false }];
        let mut gradient = vec![[0.0; 4]; 12];
        length_and_gradient(&samples, &strokes, 0.3, &mut gradient);
        let mut worst = 0.0f64;
        for i in 0..12 {
            for c in 0..4 {
                let mut at = |h: f64| {
                    samples[i][c] += h;
                    let length = length_and_gradient(&samples, &strokes, 0.3, &mut vec![[0.0; 4]; 12]);
                    samples[i][c] -= h;
                    length
                };
                worst = worst.max(((at(1e-6) - at(-1e-6)) / 2e-6 - gradient[i][c]).abs());
            }
        }
        assert!(worst < 1e-8, "{worst}");
        assert!(gradient[11] == [0.0; 4] && gradient[0][0].abs() > 1e-3, "sample 11 belongs to no stroke");
    }

    #[test]
    fn a_square_is_as_long_as_its_sides() {
        let square = [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0f32]];
        let length =
            |closed| length_and_gradient(&square, &[Stroke { start: 0, count: 4, closed }], 2.0, &mut [[0.0; 4]; 4]);
        assert_eq!((length(true), length(false)), (8.0, 6.0));
    }
}
