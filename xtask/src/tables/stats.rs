//! Means and spreads of a grid of runs: inputs by seeds.

/// A mean and how far values are from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    pub mean: f64,
    /// Standard deviation over the seeds of one input, pooled over the inputs; `None` with one seed.
    pub seeds: Option<f64>,
    /// Standard deviation over the inputs' means; `None` with one input.
    pub inputs: Option<f64>,
}

/// `None` for nothing.
pub fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// Of a sample (divided by n - 1); `None` for fewer than two values.
pub fn deviation(values: &[f64]) -> Option<f64> {
    let middle = mean(values).filter(|_| values.len() > 1)?;
    Some((values.iter().map(|value| (value - middle).powi(2)).sum::<f64>() / (values.len() - 1) as f64).sqrt())
}

/// `grid[input][seed]`; `None` for nothing.
pub fn spread(grid: &[Vec<f64>]) -> Option<Spread> {
    let means: Vec<f64> = grid.iter().filter_map(|seeds| mean(seeds)).collect();
    let squares: Vec<f64> = grid.iter().filter_map(|seeds| deviation(seeds)).map(|d| d * d).collect();
    Some(Spread { mean: mean(&means)?, seeds: mean(&squares).map(f64::sqrt), inputs: deviation(&means) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreads_by_hand() {
        assert_eq!(mean(&[]), None);
        assert_eq!(deviation(&[1.0]), None);
        assert_eq!(deviation(&[1.0, 3.0]), Some(2f64.sqrt()));
        let found = spread(&[vec![1.0, 3.0], vec![5.0, 7.0]]).unwrap();
        assert_eq!(found, Spread { mean: 4.0, seeds: Some(2f64.sqrt()), inputs: Some(8f64.sqrt()) });
        assert_eq!(spread(&[vec![2.0]]), Some(Spread { mean: 2.0, seeds: None, inputs: None }));
        assert_eq!(spread(&[]), None);
    }
}
