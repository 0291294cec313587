//! What a person can do to drawings that do not go together: mirror one, turn one, let two change places.

use super::Drawing as Given;
use super::plan::{Plan, plan, thicken};
use crate::Result;
use crate::settings::{OnOff, Settings, Turn};
use crate::start::{Arrangement, Cutouts, Drawing, Orientation, REPORT_ACROSS, coverable, mean_share};
use crate::view::Target;
use serde::Serialize;

/// Something a person can do to the drawings with one click.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Remedy {
    /// What.
    pub kind: RemedyKind,
    /// The drawings it moves: one to mirror or turn, two to swap, all to arrange.
    pub sources: Vec<usize>,
    /// Counter-clockwise; 0 but for turns.
    pub quarter_turns: u8,
    /// Mean share of ink that any object could show, 0 to 1, after it.
    pub coverable: f64,
}

/// What a remedy does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum RemedyKind {
    /// Switches `arrange` on.
    Arrange,
    /// Mirrors one drawing left to right.
    Mirror,
    /// Turns one drawing.
    Turn,
    /// Exchanges two drawings.
    Swap,
}

/// What a remedy must gain to be worth a person's while.
const WORTH_TELLING: f64 = 0.01;
/// More than these nobody reads.
const MOST: usize = 5;

/// For each view the drawing it shows and how that lies.
type Ways = Vec<(usize, Orientation)>;

/// Drawings laid down in different ways and measured as [`Plan`] measures.
pub(super) struct Trials<'a> {
    cutouts: Cutouts,
    count: usize,
    settings: &'a Settings,
    /// Thickened targets, unmirrored and turned by a quarter at most, by what lies where: mirroring a drawing or turning
    /// it half round leaves the object's box as it is.
    laid: Vec<(Vec<(usize, bool)>, Arrangement)>,
}

impl<'a> Trials<'a> {
    /// # Errors
    /// As [`Cutouts::new`].
    pub(super) fn new(drawings: &[Drawing], settings: &'a Settings) -> Result<Trials<'a>> {
        Ok(Trials { cutouts: Cutouts::new(drawings)?, count: drawings.len(), settings, laid: Vec::new() })
    }

    /// [`Trials::share`] with every drawing where it was put, upright and not mirrored.
    pub(super) fn as_given(&mut self) -> Result<f64> {
        self.share(&(0..self.count).map(|source| (source, Orientation::default())).collect())
    }

    /// Mean share of ink that any object could show.
    ///
    /// # Errors
    /// As [`coverable`].
    pub(super) fn share(&mut self, ways: &Ways) -> Result<f64> {
        let key: Vec<(usize, bool)> = ways.iter().map(|&(source, way)| (source, way.lies_down())).collect();
        let at = match self.laid.iter().position(|(of, _)| *of == key) {
            Some(at) => at,
            None => {
                let turned = |&(source, lies): &(usize, bool)| {
                    (source, Orientation { mirrored: false, quarter_turns: u8::from(lies) })
                };
                let ways: Ways = key.iter().map(turned).collect();
                let mut laid = self.cutouts.lay_out(&ways, self.settings.max_stretch, self.settings.size);
                thicken(&mut laid.targets, self.settings);
                self.laid.push((key, laid));
                self.laid.len() - 1
            }
        };
        let laid = &self.laid[at].1;
        let targets: Vec<Target> = laid
            .targets
            .iter()
            .zip(&laid.placements)
            .zip(ways)
            .map(|((target, placed), &(_, way))| Target {
                view: target.view.clone(),
                ink: way.after(placed.orientation.inverse()).applied(&target.ink),
            })
            .collect();
        Ok(mean_share(&coverable(&targets, laid.half_extents_world, REPORT_ACROSS)?))
    }
}

/// What would help, best first. What arranging does by itself is left out where it may.
///
/// # Errors
/// As [`plan`] and [`coverable`].
pub(super) fn remedies(
    now: &Plan,
    drawings: &[Given],
    trials: &mut Trials,
    settings: &Settings,
) -> Result<Vec<Remedy>> {
    let base = now.mean_coverable();
    let now: Ways = now.arrangement.placements.iter().map(|placed| (placed.source, placed.orientation)).collect();
    let arranged = settings.arrange == OnOff::On;
    let mut found: Vec<Remedy> = Vec::new();
    let mut offer = |kind, sources: &[usize], quarter_turns, coverable| {
        if coverable >= base + WORTH_TELLING {
            let place = found.partition_point(|better| better.coverable >= coverable);
            found.insert(place, Remedy { kind, sources: sources.to_vec(), quarter_turns, coverable });
        }
    };
    for view in 0..now.len() {
        let source = now[view].0;
        let mut moved = |first: Orientation| {
            let mut ways = now.clone();
            ways[view].1 = ways[view].1.after(first);
            trials.share(&ways)
        };
        if !(arranged && settings.may_mirror) {
            let share = moved(Orientation { mirrored: true, quarter_turns: 0 })?;
            offer(RemedyKind::Mirror, &[source], 0, share);
        }
        if arranged && view == 2 && settings.may_turn == Turn::Top {
            continue;
        }
        let mut best = (0, 0.0);
        for quarter_turns in 1..4 {
            let share = moved(Orientation { mirrored: false, quarter_turns })?;
            if share > best.1 {
                best = (quarter_turns, share);
            }
        }
        offer(RemedyKind::Turn, &[source], best.0, best.1);
    }
    if !(arranged && settings.may_swap) {
        for (a, b) in [(0, 1), (0, 2), (1, 2)].into_iter().filter(|&(_, b)| b < now.len()) {
            let mut ways = now.clone();
            // The drawings change pads; how a view lays down what it is given stays.
            (ways[a].0, ways[b].0) = (now[b].0, now[a].0);
            offer(RemedyKind::Swap, &[now[a].0, now[b].0], 0, trials.share(&ways)?);
        }
    }
    if !arranged {
        let everything: Vec<usize> = (0..now.len()).collect();
        let share = plan(drawings, &Settings { arrange: OnOff::On, ..settings.clone() })?.mean_coverable();
        offer(RemedyKind::Arrange, &everything, 0, share);
    }
    found.truncate(MOST);
    Ok(found)
}
