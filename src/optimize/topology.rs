//! Edits of the control points at given moments of a run; refinement by knot insertion.

use super::engine::State;
use super::reinit::Reinit;
use crate::wire::{LinearMap, Wire};
use crate::{Error, Result};

/// When something happens.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Moment {
    /// Before the iteration of this number.
    Iteration(usize),
    /// After this share (0 to 1) of the run.
    Progress(f64),
}

impl Moment {
    /// The iteration before which it happens in a run of `total`.
    pub fn iteration(&self, total: usize) -> usize {
        match *self {
            Moment::Iteration(iteration) => iteration,
            Moment::Progress(progress) => (progress * total as f64).round() as usize,
        }
    }
}

/// What happens.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TopologyEdit {
    /// Vanished control points start again elsewhere.
    Reinit(Reinit),
    /// Control points are added where the pictures pull hardest.
    Refine(Refine),
}

/// An edit and its moment.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct TopologyEvent {
    /// When.
    pub at: Moment,
    /// What.
    pub edit: TopologyEdit,
}

impl TopologyEvent {
    pub(super) fn check(&self) -> Result<()> {
        if let Moment::Progress(progress) = self.at
            && !(0.0..=1.0).contains(&progress)
        {
            return Err(Error::setting("topology", format!("progress {progress}"), "give a share from 0 to 1"));
        }
        match &self.edit {
            TopologyEdit::Reinit(reinit) => reinit.check(),
            TopologyEdit::Refine(refine) => refine.check(),
        }
    }
}

/// Gradient-ranked refinement: spans are ranked by the image gradient at their middle control points, averaged over the
/// iterations before, and the first ones get a knot halfway. The curve stays as it is.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Refine {
    /// Control points added, as a share of their present number.
    pub share: f64,
    /// Spans whose chord is shorter than this, in pixels of a 256 px picture, get none.
    pub shortest_px: f64,
    /// Iterations over which gradients are averaged.
    pub window: usize,
}

impl Default for Refine {
    fn default() -> Self {
        Refine { share: 1.0 / 3.0, shortest_px: 1.3, window: 20 }
    }
}

impl Refine {
    fn check(&self) -> Result<()> {
        let fine = |value: f64| value.is_finite() && value >= 0.0;
        if fine(self.share) && fine(self.shortest_px) && self.window > 0 {
            return Ok(());
        }
        Err(Error::setting("refine", format!("{self:?}"), "give shares and lengths from 0 up and a window from 1"))
    }

    /// Inserts the knots and carries points and moments over: first moments by the same map, second ones by its squared
    /// weights. `gradient_norms` has one entry a control point. Returns how many control points were added; none where
    /// the wire has no room for more.
    pub(super) fn apply(&self, shortest: f64, gradient_norms: &[f32], wire: &mut Wire, state: &mut State) -> usize {
        let count = wire.control_points().len();
        let mut ranked: Vec<(f32, f64)> = wire
            .spans()
            .filter_map(|span| {
                let [a, b] = [wire.evaluate(span.start), wire.evaluate(span.end)];
                let chord = (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt();
                let pull = gradient_norms[(span.first + 1) % count].max(gradient_norms[(span.first + 2) % count]);
                (chord >= shortest).then(|| (pull, span.at(0.5)))
            })
            .collect();
        ranked.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
        let added_by = |knots: &[f64]| wire.insert_knots(knots).map(|(refined, map)| (refined, map, knots.len()));
        let wanted = (self.share * count as f64).round() as usize;
        // A knot adds one control point to a spline, more to the baselines.
        let Some(each) = ranked.first().and_then(|first| added_by(&[first.1]).ok()) else { return 0 };
        let each = each.0.control_points().len() - count;
        let knots: Vec<f64> = ranked.iter().take(wanted / each).map(|&(_, knot)| knot).collect();
        let Ok((refined, map, _)) = added_by(&knots) else { return 0 };
        let (linear, squared) = (rounded(&map, |weight| weight), rounded(&map, |weight| weight * weight));
        let carry = |map: &LinearMap<f32>, values: &mut Vec<[f32; 4]>| {
            let mut carried = Vec::new();
            map.apply(values, &mut carried);
            *values = carried;
        };
        carry(&linear, &mut state.points);
        carry(&linear, &mut state.adam.first);
        carry(&squared, &mut state.adam.second);
        *wire = refined;
        state.points.len() - count
    }
}

fn rounded(map: &LinearMap<f64>, weight: impl Fn(f64) -> f64) -> LinearMap<f32> {
    use crate::wire::Row;
    let rows = map.rows().iter().map(|row| Row { first: row.first, weights: row.weights.map(|w| weight(w) as f32) });
    LinearMap::new(map.columns(), rows.collect())
}
