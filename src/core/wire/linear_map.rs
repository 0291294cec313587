//! Banded linear maps with at most four entries a row: curve evaluation, Bézier conversion, knot insertion.

use num_traits::Float;

/// `f32` for fitting, `f64` where a test asks for exactness.
pub trait Real: Float + Send + Sync + std::fmt::Debug + std::iter::Sum + 'static {
    /// Rounds from `f64`.
    fn from_f64(x: f64) -> Self;
}
impl Real for f32 {
    fn from_f64(x: f64) -> Self {
        x as f32
    }
}
impl Real for f64 {
    fn from_f64(x: f64) -> Self {
        x
    }
}

/// Four consecutive weights, the first for column `first`; columns wrap round at the map's width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row<R> {
    /// Column of `weights[0]`.
    pub first: u32,
    /// Weights of columns `first..first + 4` (modulo the map's width).
    pub weights: [R; 4],
}

impl<R: Real> Row<R> {
    /// Rounds the weights.
    pub(super) fn from_f64(first: usize, weights: &[f64; 4]) -> Self {
        Row { first: first as u32, weights: weights.map(R::from_f64) }
    }
}

/// A matrix with rows of at most four consecutive entries, applied to 4D points.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearMap<R> {
    columns: usize,
    rows: Vec<Row<R>>,
}

impl<R: Real> LinearMap<R> {
    /// From rows over `columns` inputs, at least 4.
    ///
    /// # Panics
    /// If there are fewer columns or a row starts beyond them.
    pub fn new(columns: usize, rows: Vec<Row<R>>) -> Self {
        assert!(columns >= 4, "a row has four columns");
        assert!(rows.iter().all(|row| (row.first as usize) < columns), "every row starts inside the columns");
        LinearMap { columns, rows }
    }

    /// Number of inputs.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Its rows, one an output.
    pub fn rows(&self) -> &[Row<R>] {
        &self.rows
    }

    /// `outputs = M inputs`; `outputs` is resized, nothing is allocated once it has grown.
    ///
    /// # Panics
    /// If there is not one input a column.
    pub fn apply(&self, inputs: &[[R; 4]], outputs: &mut Vec<[R; 4]>) {
        assert_eq!(inputs.len(), self.columns, "one input a column");
        outputs.resize(self.rows.len(), [R::zero(); 4]);
        let mut outputs = outputs.as_mut_slice();
        // Rows of one span share their columns: load those once.
        for run in self.rows.chunk_by(|a, b| a.first == b.first) {
            let (run_outputs, rest) = outputs.split_at_mut(run.len());
            outputs = rest;
            let window = self.window(run[0].first, inputs);
            for (row, output) in run.iter().zip(run_outputs) {
                *output = combine(&row.weights, &window);
            }
        }
    }

    /// `d_inputs += Mᵀ d_outputs`, always summed in the same order.
    ///
    /// # Panics
    /// If there is not one input a column and one output a row.
    pub fn apply_transpose(&self, d_outputs: &[[R; 4]], d_inputs: &mut [[R; 4]]) {
        assert_eq!(d_outputs.len(), self.rows.len(), "one output a row");
        assert_eq!(d_inputs.len(), self.columns, "one input a column");
        // Rows of one span share their columns: sum those in registers before memory is touched.
        let mut d_outputs = d_outputs;
        for run in self.rows.chunk_by(|a, b| a.first == b.first) {
            let (d_run, rest) = d_outputs.split_at(run.len());
            d_outputs = rest;
            let mut sums = [[R::zero(); 4]; 4];
            for (row, d_output) in run.iter().zip(d_run) {
                for k in 0..4 {
                    for c in 0..4 {
                        sums[k][c] = sums[k][c] + row.weights[k] * d_output[c];
                    }
                }
            }
            self.add_to_window(run[0].first, &sums, d_inputs);
        }
    }

    /// The same map in another precision.
    pub fn cast<S: Real>(&self) -> LinearMap<S> {
        let cast = |weight: R| S::from_f64(weight.to_f64().unwrap_or(f64::NAN));
        let rows = self.rows.iter().map(|row| Row { first: row.first, weights: row.weights.map(cast) }).collect();
        LinearMap { columns: self.columns, rows }
    }

    /// One row of [`LinearMap::apply`].
    #[inline]
    pub(super) fn apply_row(&self, row: usize, inputs: &[[R; 4]]) -> [R; 4] {
        let row = &self.rows[row];
        combine(&row.weights, &self.window(row.first, inputs))
    }

    /// One row of [`LinearMap::apply_transpose`].
    #[inline]
    pub(super) fn apply_row_transpose(&self, row: usize, d_output: &[R; 4], d_inputs: &mut [[R; 4]]) {
        let row = &self.rows[row];
        self.add_to_window(row.first, &row.weights.map(|weight| d_output.map(|d| weight * d)), d_inputs);
    }

    /// The four inputs from `first` on.
    #[inline]
    fn window(&self, first: u32, inputs: &[[R; 4]]) -> [[R; 4]; 4] {
        let first = first as usize;
        match inputs.get(first..first + 4) {
            Some(window) => [window[0], window[1], window[2], window[3]],
            None => [0, 1, 2, 3].map(|k| inputs[(first + k) % self.columns]),
        }
    }

    #[inline]
    fn add_to_window(&self, first: u32, sums: &[[R; 4]; 4], d_inputs: &mut [[R; 4]]) {
        for (k, sum) in sums.iter().enumerate() {
            let column = first as usize + k;
            let d_input = &mut d_inputs[if column < self.columns { column } else { column - self.columns }];
            for c in 0..4 {
                d_input[c] = d_input[c] + sum[c];
            }
        }
    }
}

/// `Σ weights[k] window[k]`.
#[inline]
fn combine<R: Real>(weights: &[R; 4], window: &[[R; 4]; 4]) -> [R; 4] {
    let mut sum = [R::zero(); 4];
    for c in 0..4 {
        sum[c] = weights[0] * window[0][c]
            + weights[1] * window[1][c]
            + weights[2] * window[2][c]
            + weights[3] * window[3][c];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::all_wires;
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    fn random<R: Real>(count: usize, rng: &mut Rng) -> Vec<[R; 4]> {
        (0..count).map(|_| [0; 4].map(|_| R::from_f64(rng.range(-1.0, 1.0)))).collect()
    }

    fn dot<R: Real>(a: &[[R; 4]], b: &[[R; 4]]) -> f64 {
        let product = |(x, y): (&R, &R)| x.to_f64().unwrap() * y.to_f64().unwrap();
        a.iter().flatten().zip(b.iter().flatten()).map(product).sum()
    }

    /// `<M x, y> - <x, Mᵀ y>` for random x and y.
    fn adjoint_gap<R: Real>(forward: &LinearMap<R>, backward: &LinearMap<R>, rng: &mut Rng) -> f64 {
        let x = random::<R>(forward.columns(), rng);
        let y = random::<R>(forward.rows().len(), rng);
        let mut mx = Vec::new();
        forward.apply(&x, &mut mx);
        let mut mty = vec![[R::zero(); 4]; x.len()];
        backward.apply_transpose(&y, &mut mty);
        (dot(&mx, &y) - dot(&x, &mty)).abs()
    }

    fn all_maps(seed: u64) -> Vec<LinearMap<f64>> {
        let mut maps = Vec::new();
        for wire in all_wires(seed) {
            let middles: Vec<f64> = wire.spans().map(|span| span.at(0.5)).collect();
            maps.push(wire.bezier_map());
            maps.push(wire.subdivision_map(&vec![3; wire.spans().count()]));
            maps.push(wire.sampling_map(5, false).0);
            maps.push(wire.sampling_map(5, true).0);
            maps.push(wire.insert_knots(&middles).unwrap().1);
        }
        maps
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn transpose_is_the_adjoint(seed in 0u64..1000) {
            let mut rng = Rng::new(seed, 9);
            for map in all_maps(seed) {
                proptest::prop_assert!(adjoint_gap(&map, &map, &mut rng) < 1e-12);
                let single = map.cast::<f32>();
                proptest::prop_assert!(adjoint_gap(&single, &single, &mut rng) < 1e-4);
                let mut rows = map.rows().to_vec();
                rows[seed as usize % map.rows().len()].weights.rotate_left(1);
                let other = LinearMap::new(map.columns(), rows);
                proptest::prop_assert!(adjoint_gap(&map, &other, &mut rng) > 1e-9, "one other row is noticed");
            }
        }
    }

    #[test]
    fn agrees_with_the_plain_sum() {
        let mut rng = Rng::new(1, 1);
        for map in all_maps(2) {
            let x = random::<f64>(map.columns(), &mut rng);
            let mut outputs = vec![[7.0; 4]; 3];
            map.apply(&x, &mut outputs);
            assert_eq!(outputs.len(), map.rows().len());
            for (row, output) in map.rows().iter().zip(&outputs) {
                for c in 0..4 {
                    let sum: f64 =
                        (0..4).map(|k| row.weights[k] * x[(row.first as usize + k) % map.columns()][c]).sum();
                    assert!((sum - output[c]).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn buffers_are_kept() {
        let map = &all_maps(3)[2];
        let x = random::<f64>(map.columns(), &mut Rng::new(1, 2));
        let mut outputs = Vec::new();
        map.apply(&x, &mut outputs);
        let address = outputs.as_ptr();
        map.apply(&x, &mut outputs);
        assert_eq!(address, outputs.as_ptr());
    }
}
