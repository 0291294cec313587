//! What happened in a run: the loss of every iteration, term by term, and the events.

use super::term::{Term, term_count};

/// What kind of thing happened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum EventKind {
    /// A stage began; the count is its number from 1.
    Stage,
    /// Adam's moments were zeroed; the count is that of the control points.
    Restart,
    /// Control points were re-initialised; the count says how many.
    Reinit,
    /// Control points were inserted; the count says how many.
    Refine,
    /// Control points were laid anew at even steps; the count says how many there are now.
    Respace,
    /// Control points were removed that the curve does not need; the count says how many.
    Thin,
    /// A step made numbers that are not finite and was undone, and the rate halved; the count is the number of
    /// halvings so far.
    Undone,
    /// The run is complete; the count is that of its iterations.
    Done,
    /// What guided failed and was switched off; the count says how many so far.
    Unguided,
}

/// Something that happened before the iteration of that number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Event {
    /// Iterations done before it.
    pub iteration: usize,
    /// What.
    pub kind: EventKind,
    /// How many; see [`EventKind`].
    pub count: usize,
}

/// The weighted terms of the loss, one row an iteration. The row of an undone step holds what that step saw, which may
/// not be finite; such values are stored as 0.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct History {
    /// Names of the columns: `total`, each view's, then those of [`Term::ALL`].
    pub columns: Vec<String>,
    values: Vec<f32>,
}

impl History {
    /// The loss of every iteration, term by term, as `loss.csv`.
    pub fn to_csv(&self) -> String {
        let mut text = format!("iteration,{}\n", self.columns.join(","));
        for (iteration, row) in self.rows().enumerate() {
            text.push_str(&iteration.to_string());
            for value in row {
                text.push_str(&format!(",{value:e}"));
            }
            text.push('\n');
        }
        text
    }

    pub(super) fn new(views: impl Iterator<Item = String>, iterations: usize) -> Self {
        let mut columns = vec!["total".to_owned()];
        columns.extend(views);
        columns.extend(Term::ALL.map(|term| term.name().to_owned()));
        let values = Vec::with_capacity(columns.len() * iterations);
        History { columns, values }
    }

    /// Rows so far.
    pub fn len(&self) -> usize {
        self.values.len() / self.columns.len().max(1)
    }

    /// Whether there is no row yet.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The terms of every iteration in order, in the order of the columns.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[f32]> + ExactSizeIterator {
        self.values.chunks_exact(self.columns.len().max(1))
    }

    /// The row of iteration `i`, if it has been done.
    pub fn row(&self, i: usize) -> Option<&[f32]> {
        self.rows().nth(i)
    }

    pub(super) fn push(&mut self, terms: &[f32]) {
        self.values.extend(terms.iter().map(|&term| if term.is_finite() { term } else { 0.0 }));
    }

    /// With the columns that have come since it was written.
    pub(super) fn completed(mut self) -> Self {
        let known = self.columns.len();
        let missing = Term::ALL
            .map(Term::name)
            .into_iter()
            .filter(|name| !self.columns[1.min(known)..].iter().any(|c| c == name));
        let missing: Vec<_> = missing.map(str::to_owned).collect();
        if !missing.is_empty() && known > 0 {
            let zeros = vec![0.0; missing.len()];
            self.values = self.values.chunks(known).flat_map(|row| [row, &zeros].concat()).collect();
            self.columns.extend(missing);
        }
        self
    }

    pub(super) fn is_valid(&self, views: usize) -> bool {
        self.columns.len() == term_count(views)
            && self.values.len().is_multiple_of(self.columns.len())
            && self.values.iter().all(|value| value.is_finite())
    }
}
