//! The joint warp: while the wire moves towards the targets, the targets bend a little towards the wire.

use super::{Adam, AdamOptions, Schedule};
use crate::objective::{Warp, WarpWeights};
use crate::parallel;
use crate::view::Image;
use crate::{Error, Result};

/// How targets bend. `Default` is `little`: a pixel or two of 256 on average.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Bending {
    /// Control vectors along each side of a view's displacement field.
    pub grid: usize,
    /// Progress of the run (0 to 1) from which on targets bend.
    pub from: f64,
    /// Iterations between two updates.
    pub every: usize,
    /// Adam's rate for displacements, pixels at 256.
    pub rate_px: Schedule,
    /// What keeps the field small, smooth and kind to straight strokes.
    pub weights: WarpWeights,
}

impl Default for Bending {
    fn default() -> Self {
        Bending {
            grid: 24,
            from: 0.2,
            every: 4,
            rate_px: Schedule::Piecewise(vec![[0.0, 0.08], [1.0, 0.0]]),
            weights: WarpWeights { smooth: 3e-4, magnitude: 2e-5, straight: 0.3 },
        }
    }
}

/// Displacements forget faster than the wire does: their loss changes under them.
const ADAM: AdamOptions = AdamOptions { beta1: 0.9, beta2: 0.97, epsilon: 1e-7, ..AdamOptions::PLAIN };

impl Bending {
    pub(super) fn check(&self) -> Result<()> {
        let WarpWeights { smooth, magnitude, straight } = self.weights;
        let weights_fine = [smooth, magnitude, straight].iter().all(|weight| weight.is_finite() && *weight >= 0.0);
        if weights_fine && (4..=128).contains(&self.grid) && (0.0..=1.0).contains(&self.from) && self.every > 0 {
            return self.rate_px.check("bend rate");
        }
        Err(Error::setting(
            "bend",
            format!("{self:?}"),
            "give a grid of 4 to 128, a start from 0 to 1, an update every 1 or more and weights from 0 up",
        ))
    }

    /// Whether targets bend after iteration `iteration` of `total`.
    pub(super) fn is_due(&self, iteration: usize, total: usize) -> bool {
        iteration as f64 >= self.from * total as f64 && iteration.is_multiple_of(self.every)
    }
}

/// One view's field and its moments: what a checkpoint keeps.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Field {
    pub values: Vec<[f32; 2]>,
    pub adam: Adam<2>,
}

impl Field {
    pub(super) fn new(grid: usize) -> Self {
        Field { values: vec![[0.0; 2]; grid * grid], adam: Adam::new(grid * grid) }
    }
}

/// One view's bending at the size that is fitted.
struct BentView {
    warp: Warp<f32>,
    field: Field,
    before: Field,
    bent: Vec<f32>,
    d_bent: Vec<f32>,
    d_field: Vec<[f32; 2]>,
}

/// Every view's bending.
pub(super) struct Bender {
    options: Bending,
    views: Vec<BentView>,
}

impl Bender {
    /// For clean `inks` at the size that is fitted.
    pub(super) fn new(options: Bending, inks: &[Image], fields: Vec<Field>) -> Self {
        let mut views: Vec<BentView> = inks
            .iter()
            .zip(fields)
            .map(|(ink, field)| BentView {
                warp: Warp::new(ink, options.grid),
                before: field.clone(),
                d_field: vec![[0.0; 2]; field.values.len()],
                field,
                bent: ink.data.clone(),
                d_bent: vec![0.0; ink.data.len()],
            })
            .collect();
        parallel::each_mut(&mut views, 2, |_, view| view.warp.bend(&view.field.values, &mut view.bent));
        Bender { options, views }
    }

    pub(super) fn fields(&self) -> impl Iterator<Item = &Field> {
        self.views.iter().map(|view| &view.field)
    }

    pub(super) fn into_fields(self) -> Vec<Field> {
        self.views.into_iter().map(|view| view.field).collect()
    }

    /// The bent ink of view `view` at the size that is fitted.
    pub(super) fn bent(&self, view: usize) -> &[f32] {
        &self.views[view].bent
    }

    /// One step of every field. The loss sees coverage minus target, so its gradient to the target is minus
    /// `d_coverage`.
    pub(super) fn update<'a>(&mut self, progress: f64, d_coverage: impl Fn(usize) -> &'a [f32]) {
        for (v, view) in self.views.iter_mut().enumerate() {
            for (d_bent, d) in view.d_bent.iter_mut().zip(d_coverage(v)) {
                *d_bent = -d;
            }
        }
        let rate = self.options.rate_px.at(progress) as f32;
        let weights = self.options.weights;
        parallel::each_mut(&mut self.views, 2, |_, view| {
            let BentView { warp, field, before, bent, d_bent, d_field } = view;
            d_field.fill([0.0; 2]);
            warp.bend_vjp(d_bent, d_field);
            warp.regularise(&field.values, &weights, d_field);
            before.values.clone_from(&field.values);
            before.adam.copy_from(&field.adam);
            field.adam.step(&ADAM, &[rate; 2], &mut field.values, d_field);
            let moments = field.adam.first.iter().chain(&field.adam.second);
            if !field.values.iter().chain(moments).flatten().all(|value| value.is_finite()) {
                field.values.clone_from(&before.values);
                field.adam.copy_from(&before.adam);
            }
            warp.bend(&field.values, bent);
        });
    }
}
