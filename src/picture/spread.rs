//! How values spread: the threshold between two classes of them, and quantiles.

/// Otsu's threshold (1979) of values in 0 to 1, halfway between the two classes' means; 0.5 for a single value.
pub(super) fn otsu(values: impl Iterator<Item = f32>) -> f32 {
    let mut histogram = [0u64; 256];
    for value in values {
        histogram[(value.clamp(0.0, 1.0) * 255.0).round() as usize] += 1;
    }
    let moments = |bins: std::ops::Range<usize>| {
        bins.fold((0u64, 0u64), |(count, sum), bin| (count + histogram[bin], sum + histogram[bin] * bin as u64))
    };
    let (all, total) = moments(0..256);
    let (mut low, mut low_sum) = (0u64, 0u64);
    let mut best = (0.0, 0.5);
    for bin in 0..255 {
        low += histogram[bin];
        low_sum += histogram[bin] * bin as u64;
        let high = all - low;
        if low == 0 || high == 0 {
            continue;
        }
        let (mean_low, mean_high) = (low_sum as f64 / low as f64, (total - low_sum) as f64 / high as f64);
        let between = low as f64 * high as f64 * (mean_high - mean_low).powi(2);
        if between > best.0 {
            best = (between, (mean_low + mean_high) / 510.0);
        }
    }
    best.1 as f32
}

/// The value below which `share` of the values lie; reorders them. 0 without values.
pub(super) fn quantile(values: &mut [f32], share: f64) -> f32 {
    if values.is_empty() {
        return 0.0;
    }
    let rank = ((values.len() - 1) as f64 * share).round() as usize;
    *values.select_nth_unstable_by(rank, f32::total_cmp).1
}
