//! Edits of the control points at given moments of a run; refinement by knot insertion.

use super::engine::State;
use super::reinit::Reinit;
use crate::sorting::sort_by;
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
    /// Control points are laid anew at even steps along the wire.
    Respace(Respace),
    /// Control points go that the curve can do without.
    Thin(Thin),
}

/// Knot removal: the curve stays within a tolerance of where it is. Moments start anew.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Thin {
    /// How far the curve may move, pixels of a 256 px picture.
    pub tolerance_px: f64,
}

impl Thin {
    fn check(&self) -> Result<()> {
        if self.tolerance_px.is_finite() && self.tolerance_px >= 0.0 {
            return Ok(());
        }
        Err(Error::setting("thin", format!("{} px", self.tolerance_px), "give a distance from 0 up"))
    }
}

/// Even steps along the wire. Moments start anew.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Respace {
    /// From control point to control point, pixels of a 256 px picture.
    pub spacing_px: f64,
    /// Radius of the bends that cusps are opened to, likewise; 0 leaves them.
    pub hairpin_px: f64,
}

impl Respace {
    fn check(&self) -> Result<()> {
        if !(self.spacing_px.is_finite() && self.spacing_px > 0.0) {
            return Err(Error::setting("spacing", format!("{} px", self.spacing_px), "give a distance above 0"));
        }
        if self.hairpin_px.is_finite() && self.hairpin_px >= 0.0 {
            return Ok(());
        }
        Err(Error::setting("hairpin", format!("{} px", self.hairpin_px), "give a radius from 0 up"))
    }
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
            TopologyEdit::Respace(respace) => respace.check(),
            TopologyEdit::Thin(thin) => thin.check(),
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
        sort_by(&mut ranked, |a, b| b.0.total_cmp(&a.0).then(a.1.total_cmp(&b.1)));
        let wanted = (self.share * count as f64).round() as usize;
        // A knot adds one control point to a spline, more to the baselines.
        let added_by = |knots: &[f64]| wire.insert_knots(knots).ok();
        let Some((with_one, _)) = ranked.first().and_then(|first| added_by(&[first.1])) else { return 0 };
        let each = with_one.control_points().len() - count;
        let knots: Vec<f64> = ranked.iter().take(wanted / each).map(|&(_, knot)| knot).collect();
        let Some((refined, map)) = added_by(&knots) else { return 0 };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optimize::Adam;
    use crate::rng::Rng;
    use crate::wire::Form;

    fn random(form: Form, closed: bool, count: usize) -> (Wire, State) {
        let mut rng = Rng::new(2, 0);
        let mut point = || [rng.range(-1.0, 1.0), rng.range(-1.0, 1.0), rng.range(-1.0, 1.0), 0.1 + rng.unit()];
        let points: Vec<[f64; 4]> = (0..count).map(|_| point().map(|c| f64::from(c as f32))).collect();
        let mut adam = Adam::new(count);
        adam.first = (0..count).map(|_| point().map(|c| c as f32)).collect();
        adam.second = (0..count).map(|_| point().map(|c| (c * c) as f32)).collect();
        let state = State { points: points.iter().map(|p| p.map(|c| c as f32)).collect(), adam };
        (Wire::uniform(form, closed, points).unwrap(), state)
    }

    fn furthest(a: &Wire, b: &Wire) -> f64 {
        let (start, end) = a.domain();
        (0..=200)
            .map(|i| start + (end - start) * f64::from(i) / 200.0)
            .map(|t| (a.evaluate(t), b.evaluate(t)))
            .map(|(p, q)| (0..4).map(|c| (p[c] - q[c]).abs()).fold(0.0, f64::max))
            .fold(0.0, f64::max)
    }

    #[test]
    fn refinement_keeps_the_curve_and_goes_where_gradients_are_large() {
        for (form, closed, count) in
            [(Form::Spline, false, 12), (Form::Spline, true, 12), (Form::Chain, false, 13), (Form::Bag, false, 12)]
        {
            let (before, mut state) = random(form, closed, count);
            let mut wire = before.clone();
            let norms: Vec<f32> = (0..count).map(|i| if i >= count - 6 { 1.0 } else { 0.0 }).collect();
            let added = Refine::default().apply(1e-3, &norms, &mut wire, &mut state);
            assert!((3..=4).contains(&added), "{form:?}: {added}");
            assert_eq!(wire.control_points().len(), count + added);
            assert_eq!(state.adam.first.len(), count + added);
            assert!(state.adam.second.iter().flatten().all(|&v| v >= 0.0));
            assert!(furthest(&before, &wire) < 1e-9);
            let mut carried = wire.clone();
            let points: Vec<[f64; 4]> = state.points.iter().map(|p| p.map(f64::from)).collect();
            carried.set_control_points(&points).unwrap();
            assert!(furthest(&before, &carried) < 1e-6, "{form:?}");
            let mut shifted = points.clone();
            shifted[5][1] += 1e-3;
            carried.set_control_points(&shifted).unwrap();
            assert!(furthest(&before, &carried) > 1e-4);
            let (_, end) = before.domain();
            let fresh = wire.knots().iter().filter(|knot| !before.knots().contains(knot)).copied();
            assert!(fresh.clone().next().is_some());
            if !closed {
                assert!(
                    fresh.into_iter().all(|knot| knot > end / 3.0),
                    "{form:?}: at the end with the large gradients"
                );
            }
        }
    }

    #[test]
    fn moments_follow_the_weights_of_the_insertion() {
        // Halfway into the only span of a Bézier, new points are means: weights ½ ½ next to the ends, so a second
        // moment of 1 everywhere becomes ½ there.
        let (mut wire, mut state) = random(Form::Spline, false, 4);
        state.adam.first = vec![[0.0; 4], [2.0; 4], [4.0; 4], [6.0; 4]];
        state.adam.second = vec![[1.0; 4]; 4];
        let options = Refine { share: 0.25, ..Refine::default() };
        assert_eq!(options.apply(0.0, &[1.0; 4], &mut wire, &mut state), 1);
        let column = |values: &[[f32; 4]]| values.iter().map(|v| v[0]).collect::<Vec<_>>();
        assert_eq!(column(&state.adam.first), [0.0, 1.0, 3.0, 5.0, 6.0]);
        assert_eq!(column(&state.adam.second), [1.0, 0.5, 0.5, 0.5, 1.0]);
    }

    #[test]
    fn short_spans_and_full_wires_get_no_knots() {
        let (mut wire, mut state) = random(Form::Spline, false, 12);
        assert_eq!(Refine::default().apply(100.0, &[1.0; 12], &mut wire, &mut state), 0);
        assert_eq!(Refine { share: 0.0, ..Refine::default() }.apply(0.0, &[1.0; 12], &mut wire, &mut state), 0);
        assert_eq!(wire, random(Form::Spline, false, 12).0);
    }
}
