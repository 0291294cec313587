//! Lower envelopes of parabolas over a square grid: unions of balls and discs of different sizes, exactly and in linear
//! time.

/// Farther than any cell, squared.
pub const FAR: f32 = 1e9;

/// For each cell of a `side` x `side` grid the least of f(q) + |p - q|² over all cells q, in place: lower envelopes of
/// parabolas along rows, then columns (Felzenszwalb and Huttenlocher 2012).
pub fn lower_envelope(f: &mut [f32], side: usize) {
    let mut line = vec![0.0f64; side];
    let mut hull: Vec<(usize, f64)> = Vec::with_capacity(side); // a parabola's place, and where it takes over
    for along in 0..2 {
        for l in 0..side {
            let at = |k: usize| if along == 0 { l * side + k } else { k * side + l };
            (0..side).for_each(|k| line[k] = f64::from(f[at(k)]));
            hull.clear();
            for q in 0..side {
                let mut from = f64::NEG_INFINITY;
                while let Some(&(p, start)) = hull.last() {
                    let square = |k: usize| line[k] + (k * k) as f64;
                    from = (square(q) - square(p)) / (2 * (q - p)) as f64;
                    if from > start {
                        break;
                    }
                    hull.pop();
                    from = f64::NEG_INFINITY;
                }
                hull.push((q, from));
            }
            let mut k = 0;
            for p in 0..side {
                while k + 1 < hull.len() && hull[k + 1].1 < p as f64 {
                    k += 1;
                }
                let q = hull[k].0;
                f[at(p)] = (line[q] + (p.abs_diff(q) as f64).powi(2)) as f32;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn envelopes_equal_brute_force() {
        let side = 12;
        let mut rng = Rng::new(8, 0);
        let f: Vec<f32> = (0..side * side).map(|_| rng.range(-40.0, 40.0) as f32).collect();
        let mut found = f.clone();
        lower_envelope(&mut found, side);
        for p in 0..side * side {
            let away = |q: usize| ((p % side).abs_diff(q % side).pow(2) + (p / side).abs_diff(q / side).pow(2)) as f32;
            let least = (0..side * side).map(|q| f[q] + away(q)).fold(f32::MAX, f32::min);
            assert!((found[p] - least).abs() < 1e-3);
        }
    }
}
