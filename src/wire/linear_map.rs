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
        outputs.clear();
        outputs.extend(self.rows.iter().map(|row| combine(&row.weights, &self.window(row.first, inputs))));
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
