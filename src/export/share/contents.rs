//! What a share code holds, as whole numbers, and the order in which it is written: [`Contents::transcode`] describes
//! the format once for both directions.

use super::guess::MAX_NUMBER;
use super::range::{Coder, Model, Nonsense, NumberModels};
use super::series;
use crate::view::{Projection, View};
use crate::wire::{Form, MAX_CONTROL_POINTS};

/// Everything in the code, quantised.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Contents {
    pub form: Form,
    pub closed: bool,
    /// World units of one step of x, y, z and of one step of width.
    pub steps: [f32; 2],
    /// In steps.
    pub control_points: Vec<[i64; 4]>,
    pub knots: KnotCode,
    pub views: Vec<View>,
    pub task: String,
    pub seed: u64,
}

/// Knot intervals in powers of two of the longest: 0 for an empty one, else 1 + k for `longest · 2^(-k / per_octave)`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct KnotCode {
    pub start: f64,
    pub longest: f64,
    /// 1 for knots made by halving, finer for any others.
    pub per_octave: u64,
    /// One an interval of the curve's domain.
    pub intervals: Vec<i64>,
}

/// Most that is read of each; a wire needs less.
const MAX_VIEWS: u64 = 64;
const MAX_NAME_BYTES: u64 = 256;
/// What a task is mostly called; any other name is spelled.
const TASKS: [&str; 3] = ["multiview", "stroke", "fill"];
/// Low bits of a step that are 0 in version 2: it is one of sixteen in an octave.
pub const STEP_ZEROS: u32 = 19;
impl Contents {
    /// Writes `self`, or reads into `self`, as a code of that version.
    pub fn transcode(&mut self, coder: &mut impl Coder, version: u8) -> Result<(), Nonsense> {
        self.form = match coder.bits(self.form as u64, 2) {
            0 => Form::Spline,
            1 => Form::Chain,
            2 => Form::Bag,
            _ => return Err(Nonsense),
        };
        self.closed = coder.flag(self.closed);
        let count = coder.whole(self.control_points.len() as u64);
        if count > MAX_CONTROL_POINTS as u64 {
            return Err(Nonsense);
        }
        let count = count as usize;
        let zeros = if version == 1 { 0 } else { STEP_ZEROS };
        for step in &mut self.steps {
            transcode_step(coder, step, zeros);
        }
        self.control_points.resize(count, [0; 4]);
        let intervals = if self.closed { count } else { count.saturating_sub(3) };
        if version == 1 {
            transcode_columns(coder, &mut self.control_points, 0..3)?;
            transcode_columns(coder, &mut self.control_points, 3..4)?;
            self.knots.transcode(coder, intervals)?;
        } else {
            series::transcode(coder, &mut self.control_points)?;
            self.knots.transcode_mostly_uniform(coder, intervals)?;
        }
        let views = coder.whole(self.views.len() as u64);
        if views > MAX_VIEWS {
            return Err(Nonsense);
        }
        self.views.resize_with(views as usize, blank_view);
        let mut before = usual_view();
        for view in &mut self.views {
            transcode_view(coder, view, (version > 1).then_some(&before))?;
            before.clone_from(view);
        }
        let task = TASKS.iter().position(|task| *task == self.task).unwrap_or(TASKS.len());
        match if version == 1 { None } else { TASKS.get(coder.bits(task as u64, 2) as usize) } {
            Some(task) => (*task).clone_into(&mut self.task),
            None => text(coder, &mut self.task)?,
        }
        self.seed = coder.whole(self.seed);
        Ok(())
    }
}

/// How a column's next value is guessed from the three before: nothing, the last, on a straight line (half or all the
/// way), on a parabola. Smooth wires like the last ones, rough wires the first.
const PREDICTORS: [fn(&[i64; 3]) -> i64; 5] =
    [|_| 0, |p| p[0], |p| p[0] + (p[0] - p[1]) / 2, |p| 2 * p[0] - p[1], |p| 3 * p[0] - 3 * p[1] + p[2]];

fn residual_weight(points: &[[i64; 4]], columns: std::ops::Range<usize>, predict: fn(&[i64; 3]) -> i64) -> u32 {
    let weight = |c: usize| {
        let mut last = [0; 3];
        points
            .iter()
            .map(|point| {
                let residual = point[c] - predict(&last);
                last = [point[c], last[0], last[1]];
                i64::BITS - residual.unsigned_abs().leading_zeros()
            })
            .sum::<u32>()
    };
    columns.map(weight).sum()
}

/// Columns of the control points with one shared choice of predictor.
fn transcode_columns(
    coder: &mut impl Coder,
    points: &mut [[i64; 4]],
    columns: std::ops::Range<usize>,
) -> Result<(), Nonsense> {
    let best = (0..PREDICTORS.len()).min_by_key(|&k| residual_weight(points, columns.clone(), PREDICTORS[k]));
    let chosen = coder.bits(best.unwrap_or(0) as u64, 3) as usize;
    let predict = PREDICTORS.get(chosen).ok_or(Nonsense)?;
    let mut models = NumberModels::default();
    let mut last = [[0i64; 3]; 4];
    for point in points {
        for c in columns.clone() {
            let guess = predict(&last[c]);
            let value = guess + coder.number(point[c] - guess, &mut models);
            point[c] = value.clamp(-MAX_NUMBER, MAX_NUMBER);
            last[c] = [point[c], last[c][0], last[c][1]];
        }
        if coder.exhausted() {
            return Err(Nonsense);
        }
    }
    Ok(())
}

/// A step with some low bits that are 0.
pub fn transcode_step(coder: &mut impl Coder, step: &mut f32, zeros: u32) {
    *step = f32::from_bits((coder.bits(u64::from(step.to_bits() >> zeros), 32 - zeros) as u32) << zeros);
}

impl KnotCode {
    /// In one bit, if it is what most wires have.
    pub fn transcode_mostly_uniform(&mut self, coder: &mut impl Coder, count: usize) -> Result<(), Nonsense> {
        let uniform = KnotCode { start: 0.0, longest: 1.0, per_octave: 1, intervals: vec![1; count] };
        if coder.flag(*self == uniform) {
            *self = uniform;
            return Ok(());
        }
        self.transcode(coder, count)
    }

    fn transcode(&mut self, coder: &mut impl Coder, count: usize) -> Result<(), Nonsense> {
        self.start = float(coder, self.start);
        self.longest = float(coder, self.longest);
        self.per_octave = coder.whole(self.per_octave).min(MAX_NUMBER as u64);
        self.intervals.resize(count, 0);
        let mut models = NumberModels::default();
        let mut model = Model::default();
        for k in 0..count {
            // Mostly the same as the one before.
            let before = if k > 0 { self.intervals[k - 1] } else { 1 };
            let same = coder.bit(self.intervals[k] == before, &mut model);
            self.intervals[k] =
                if same { before } else { coder.number(self.intervals[k], &mut models).clamp(0, MAX_NUMBER) };
            if coder.exhausted() {
                return Err(Nonsense);
            }
        }
        Ok(())
    }
}

fn blank_view() -> View {
    View::orthographic("", 0.0, 0.0, 1.0, 1)
}

/// What most first views are.
fn usual_view() -> View {
    View::orthographic("", 0.0, 0.0, 2.2, 256)
}

/// From version 2 on a view's size and lens may be as those of the one before.
fn transcode_view(coder: &mut impl Coder, view: &mut View, before: Option<&View>) -> Result<(), Nonsense> {
    let lens = |view: &View| (view.width_px, view.height_px, view.projection);
    match before {
        Some(before) if coder.flag(lens(view) == lens(before)) => {
            (view.width_px, view.height_px, view.projection) = lens(before);
        }
        _ => transcode_lens(coder, view),
    }
    // Front, side and top are known by heart; 3 is any other view.
    let known = View::canonical(1.0, 1);
    let same = |a: &View, b: &View| (&a.name, a.eye, a.target, a.up) == (&b.name, b.eye, b.target, b.up);
    let which = known.iter().position(|canonical| same(canonical, view)).unwrap_or(known.len());
    if let Some(canonical) = known.get(coder.bits(which as u64, 2) as usize) {
        view.name.clone_from(&canonical.name);
        [view.eye, view.target, view.up] = [canonical.eye, canonical.target, canonical.up];
        return Ok(());
    }
    text(coder, &mut view.name)?;
    for vector in [&mut view.eye, &mut view.target, &mut view.up] {
        for c in vector {
            *c = float(coder, *c);
        }
    }
    Ok(())
}

fn transcode_lens(coder: &mut impl Coder, view: &mut View) {
    view.width_px = size(coder, view.width_px);
    let square = coder.flag(view.height_px == view.width_px);
    view.height_px = if square { view.width_px } else { size(coder, view.height_px) };
    let perspective = coder.flag(matches!(view.projection, Projection::Perspective { .. }));
    let (Projection::Orthographic { height_world: extent } | Projection::Perspective { fov_y_rad: extent }) =
        view.projection;
    let extent = float(coder, extent);
    view.projection = match perspective {
        true => Projection::Perspective { fov_y_rad: extent },
        false => Projection::Orthographic { height_world: extent },
    };
}

fn size(coder: &mut impl Coder, size: usize) -> usize {
    // Any number is read; the view's own check judges it.
    usize::try_from(coder.whole(size as u64)).unwrap_or(usize::MAX)
}

fn float(coder: &mut impl Coder, x: f64) -> f64 {
    let short = coder.flag(f64::from(x as f32).to_bits() == x.to_bits());
    if short {
        f64::from(f32::from_bits(coder.bits(u64::from((x as f32).to_bits()), 32) as u32))
    } else {
        f64::from_bits(coder.bits(x.to_bits(), 64))
    }
}

fn text(coder: &mut impl Coder, text: &mut String) -> Result<(), Nonsense> {
    let count = coder.whole(text.len() as u64);
    if count > MAX_NAME_BYTES {
        return Err(Nonsense);
    }
    let mut bytes = std::mem::take(text).into_bytes();
    bytes.resize(count as usize, 0);
    for byte in &mut bytes {
        *byte = coder.bits(u64::from(*byte), 8) as u8;
    }
    *text = String::from_utf8(bytes).map_err(|_| Nonsense)?;
    Ok(())
}
