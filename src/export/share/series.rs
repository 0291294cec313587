//! The order in which control points are written, and what each is guessed from.

use super::guess::{MAX_NUMBER, Series};
use super::range::{Coder, Nonsense};

/// Weights of what guesses are made from, before anything is known.
const POINT_WEIGHTS: [f64; 4] = [0.95, -0.15, 0.05, 0.0];
const WIDTH_WEIGHTS: [f64; 4] = [0.7, 0.0, 0.0, 0.0];
const FOLLOWING_WEIGHTS: [f64; 4] = [1.0, -0.5, 0.0, 0.0];

/// Control points, in steps, one after another, then their widths: each from the last four differences.
pub fn transcode(coder: &mut impl Coder, points: &mut [[i64; 4]]) -> Result<(), Nonsense> {
    column(coder, points, [0, 1, 2], &mut Series::new(POINT_WEIGHTS), Along::new(|past| past[0]))?;
    column(coder, points, [3], &mut Series::new(WIDTH_WEIGHTS), Along::new(|_| 0.0))
}

/// What is learned of wires that follow each other.
pub struct Following {
    points: Series<3>,
    widths: Series<1>,
}

impl Following {
    pub fn new() -> Following {
        Following { points: Series::new(FOLLOWING_WEIGHTS), widths: Series::new(FOLLOWING_WEIGHTS) }
    }

    /// Control points that are guessed from as many `before`.
    pub fn transcode(
        &mut self,
        coder: &mut impl Coder,
        points: &mut [[i64; 4]],
        before: &[[i64; 4]],
    ) -> Result<(), Nonsense> {
        column(coder, points, [0, 1, 2], &mut self.points, After { before })?;
        column(coder, points, [3], &mut self.widths, After { before })
    }
}

/// What the next step of a column is guessed from.
trait Guesses {
    /// A first guess, and the inputs of a better one, of the step to `points[at]` in column `c`, from the points before it.
    fn of(&self, points: &[[i64; 4]], at: usize, c: usize) -> (f64, [f64; 4]);
}

/// A step of a column; there was none before the first point, which is as far from zero.
fn step(points: &[[i64; 4]], at: usize, back: usize, c: usize) -> f64 {
    match at.checked_sub(back) {
        Some(0) => points[0][c] as f64,
        Some(at) => (points[at][c] - points[at - 1][c]) as f64,
        None => 0.0,
    }
}

struct Along<F> {
    plain: F,
}

impl<F: Fn(&[f64; 4]) -> f64> Along<F> {
    fn new(plain: F) -> Along<F> {
        Along { plain }
    }
}

impl<F: Fn(&[f64; 4]) -> f64> Guesses for Along<F> {
    fn of(&self, points: &[[i64; 4]], at: usize, c: usize) -> (f64, [f64; 4]) {
        let past = std::array::from_fn(|k| step(points, at, k + 1, c));
        ((self.plain)(&past), past)
    }
}

struct After<'a> {
    before: &'a [[i64; 4]],
}

impl Guesses for After<'_> {
    /// To where the wire before was; or the step that it made, as far as this one is beside it.
    fn of(&self, points: &[[i64; 4]], at: usize, c: usize) -> (f64, [f64; 4]) {
        let last = if at > 0 { points[at - 1][c] } else { 0 };
        let beside = if at > 0 { last - self.before[at - 1][c] } else { 0 } as f64;
        let plain = (self.before[at][c] - last) as f64;
        (plain, [step(self.before, at, 0, c), beside, step(points, at, 1, c), step(points, at, 2, c)])
    }
}

fn column<const N: usize>(
    coder: &mut impl Coder,
    points: &mut [[i64; 4]],
    columns: [usize; N],
    series: &mut Series<N>,
    guesses: impl Guesses,
) -> Result<(), Nonsense> {
    for at in 0..points.len() {
        let guessed = columns.map(|c| guesses.of(points, at, c));
        let last = columns.map(|c| if at > 0 { points[at - 1][c] } else { 0 });
        let ahead = std::array::from_fn(|k| points[at][columns[k]] - last[k]);
        let ahead = series.next(coder, ahead, guessed.map(|(plain, _)| plain), &guessed.map(|(_, inputs)| inputs));
        for k in 0..N {
            points[at][columns[k]] = (last[k] + ahead[k]).clamp(-MAX_NUMBER, MAX_NUMBER);
        }
        if coder.exhausted() {
            return Err(Nonsense);
        }
    }
    Ok(())
}
