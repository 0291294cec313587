//! The numbers a self-test is made of, by formulas of 32-bit integers that are equal in every language. Source:
//! `tools/guidance/guidance/noise.py`.

/// A bijection of 32-bit integers that leaves no visible pattern.
fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// `count` numbers, 0 or more and less than 1.
pub fn uniform(seed: u32, count: usize) -> Vec<f32> {
    let first = seed.wrapping_mul(0x9e37_79b9);
    (0..count as u32).map(|i| (mix(i.wrapping_add(first)) >> 8) as f32 / 16_777_216.0).collect()
}

/// `count` numbers, -1 or more and less than 1.
pub fn signed(seed: u32, count: usize) -> Vec<f32> {
    uniform(seed, count).into_iter().map(|u| 2.0 * u - 1.0).collect()
}

/// `count` numbers in rows of `width`, each row of length 1.
pub fn unit_rows(seed: u32, count: usize, width: usize) -> Vec<f32> {
    let mut rows = signed(seed, count);
    for row in rows.chunks_mut(width) {
        let length = length(row);
        row.iter_mut().for_each(|value| *value = (f64::from(*value) / length) as f32);
    }
    rows
}

/// 64 signed sums of many numbers, or all of a few, by which they are compared without being shipped.
pub fn sketch(values: &[f32]) -> Vec<f64> {
    let mut sums = vec![0.0; values.len().clamp(1, 64)];
    let buckets = sums.len();
    for (i, &value) in values.iter().enumerate() {
        sums[i % buckets] += if mix(i as u32) < 1 << 31 { f64::from(value) } else { -f64::from(value) };
    }
    sums
}

/// The Euclidean length, in double precision.
pub fn length(values: &[f32]) -> f64 {
    values.iter().map(|&value| f64::from(value) * f64::from(value)).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_python_side() {
        // `noise.uniform(1, (3,))` and `noise.sketch(noise.uniform(1, (130,)))[:2]` there.
        assert_eq!(uniform(1, 3).iter().map(|&u| f64::from(u)).collect::<Vec<_>>(), UNIFORM);
        let sums = sketch(&uniform(1, 130));
        assert!(sums.len() == 64 && sums[..2].iter().zip(SKETCH).all(|(a, b)| (a - b).abs() < 1e-12), "{sums:?}");
        let rows = unit_rows(2, 32, 16);
        assert!(rows.chunks(16).all(|row| (length(row) - 1.0).abs() < 1e-6));
    }

    const UNIFORM: [f64; 3] = [0.0077651143074035645, 0.6223195791244507, 0.02977454662322998];
    const SKETCH: [f64; 2] = [-0.4624069333076477, 0.8106173872947693];
}
