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

/// A matrix with rows of at most four consecutive entries, applied to 4D points.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearMap<R> {
    columns: usize,
    rows: Vec<Row<R>>,
}

impl<R: Real> LinearMap<R> {
    /// From rows over `columns` inputs.
    pub fn new(columns: usize, rows: Vec<Row<R>>) -> Self {
        debug_assert!(rows.iter().all(|row| (row.first as usize) < columns));
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
    pub fn apply(&self, inputs: &[[R; 4]], outputs: &mut Vec<[R; 4]>) {
        debug_assert_eq!(inputs.len(), self.columns);
        outputs.clear();
        outputs.extend(self.rows.iter().map(|row| {
            let mut sum = [R::zero(); 4];
            for (k, &weight) in row.weights.iter().enumerate() {
                let input = inputs[self.column(row.first, k)];
                for c in 0..4 {
                    sum[c] = sum[c] + weight * input[c];
                }
            }
            sum
        }));
    }

    /// `d_inputs += Mᵀ d_outputs`, in row order, so that sums are reproducible.
    pub fn apply_transpose(&self, d_outputs: &[[R; 4]], d_inputs: &mut [[R; 4]]) {
        debug_assert_eq!(d_outputs.len(), self.rows.len());
        debug_assert_eq!(d_inputs.len(), self.columns);
        for (row, d_output) in self.rows.iter().zip(d_outputs) {
            for (k, &weight) in row.weights.iter().enumerate() {
                let d_input = &mut d_inputs[self.column(row.first, k)];
                for c in 0..4 {
                    d_input[c] = d_input[c] + weight * d_output[c];
                }
            }
        }
    }

    #[inline]
    fn column(&self, first: u32, k: usize) -> usize {
        let column = first as usize + k;
        if column >= self.columns { column % self.columns } else { column }
    }
}
