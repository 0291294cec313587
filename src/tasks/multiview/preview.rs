//! What a person should know before a run: how well the drawings go together, what is missing, and what would help.

use super::given::{Drawing, named};
use super::plan::{Plan, plan};
pub use super::remedies::{Remedy, RemedyKind};
use super::remedies::{Trials, remedies};
use crate::Result;
use crate::metrics::soft_iou;
use crate::settings::{Bend, OnOff, Settings};
use crate::sorting::sort_by_key;
use crate::start::{self, BendOptions, REPORT_ACROSS, Sharing, coverable, mean_share};
use crate::tasks::Placed;
use crate::view::Image;
use serde::Serialize;

/// Longer side of the pictures of what the fit will see, px.
pub const SEEN_PX: usize = 256;

/// What two or three drawings come to before a run.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Preview {
    /// One a drawing, in the order they were given.
    pub drawings: Vec<DrawingPreview>,
    /// Mean over the views of the share of ink that any object could show, 0 to 1, as arranged.
    pub coverable: f64,
    /// The same with every drawing where it was put, upright and not mirrored.
    pub as_given: f64,
    /// What would help, best first.
    pub remedies: Vec<Remedy>,
    /// What each choice of `bend` comes to.
    pub bends: Vec<BendPreview>,
    /// [`Plan::notes`].
    pub notes: Vec<String>,
}

/// A drawing as the fit will see it.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct DrawingPreview {
    /// Where it went.
    #[serde(flatten)]
    pub placed: Placed,
    /// Its ink, lines thickened, laid back upright onto the drawing as given: same aspect, longer side [`SEEN_PX`].
    #[serde(skip)]
    pub seen: Image,
    /// The part of `seen` that no object can show together with the other drawings; nowhere more than it.
    #[serde(skip)]
    pub missing: Image,
}

/// What one choice of `bend` comes to. `None` where only the fit can tell.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct BendPreview {
    /// The choice.
    pub bend: Bend,
    /// Mean share of the bent ink that any object could show.
    pub coverable: Option<f64>,
    /// Mean soft IoU of the drawings as bent and as arranged, 0 to 1.
    pub likeness: Option<f64>,
    /// How far ink moves on average, pixels of 256.
    pub moved_px: Option<f64>,
}

/// Looks at drawings before a run.
///
/// # Errors
/// As [`plan`].
pub fn preview(drawings: &[Drawing], settings: &Settings) -> Result<Preview> {
    let plan = plan(drawings, settings)?;
    let now = plan.mean_coverable();
    // Drawings with sides of their own stay there: nothing can be moved.
    let moves = drawings.iter().all(|drawing| drawing.seen_from.is_none());
    let (as_given, remedies) = if moves {
        let mut trials = Trials::new(&named(drawings), settings)?;
        let as_given = if settings.arrange == OnOff::On { trials.as_given()? } else { now };
        // What is above each other was moved there by arranging, and shows all that it can.
        let is_above = plan.arrangement.sharing == Sharing::Width;
        let found = if is_above { Vec::new() } else { remedies(&plan, drawings, &mut trials, settings)? };
        (as_given, found)
    } else {
        (now, Vec::new())
    };
    let mut order: Vec<usize> = (0..drawings.len()).collect();
    sort_by_key(&mut order, |&view| plan.arrangement.placements[view].source);
    Ok(Preview {
        drawings: order.into_iter().map(|view| seen_in(&plan, view, drawings)).collect(),
        coverable: now,
        as_given,
        remedies,
        bends: bends(&plan)?,
        notes: plan.notes(),
    })
}

fn seen_in(plan: &Plan, view: usize, drawings: &[Drawing]) -> DrawingPreview {
    let placement = &plan.arrangement.placements[view];
    let given = &drawings[placement.source].ink;
    let longer = given.width.max(given.height);
    let side = |side: usize| ((side * SEEN_PX + longer / 2) / longer).max(1);
    let back = |picture: &Image| placement.laid_back(picture, side(given.width), side(given.height));
    let missing = back(&plan.coverable[view].missing);
    DrawingPreview { placed: plan.placed(view), seen: back(&plan.arrangement.targets[view].ink), missing }
}

fn bends(plan: &Plan) -> Result<Vec<BendPreview>> {
    let unbent = BendPreview {
        bend: Bend::None,
        coverable: Some(plan.mean_coverable()),
        likeness: Some(1.0),
        moved_px: Some(0.0),
    };
    let little = BendPreview { bend: Bend::Little, coverable: None, likeness: None, moved_px: None };
    let free = BendPreview { bend: Bend::Free, ..unbent.clone() };
    if plan.agrees() {
        return Ok(vec![unbent, little, free]);
    }
    let targets = &plan.arrangement.targets;
    let bent = start::bend(targets, &BendOptions::default(), &mut |_| true)?;
    let found = coverable(&bent.targets, plan.arrangement.half_extents_world, REPORT_ACROSS)?;
    let likeness = bent.targets.iter().zip(targets).map(|(bent, target)| soft_iou(&bent.ink, &target.ink));
    let free = BendPreview {
        coverable: Some(mean_share(&found)),
        likeness: Some(mean(likeness)),
        moved_px: Some(mean(bent.moved.iter().map(|moved| moved.mean_px))),
        ..free
    };
    Ok(vec![unbent, little, free])
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1);
    values.sum::<f64>() / count as f64
}
