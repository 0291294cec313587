//! Strands as a view shows them, for drawings.

use crate::view::{Camera, Occluder, View};
use glam::DVec2;

/// No place is left out for longer than this, which bounds the work of thinning.
const MAX_SKIP: usize = 64;

/// A place of a strand in a picture.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// px, y down.
    pub at: DVec2,
    /// px.
    pub radius: f64,
    /// 0 to 1.
    pub visibility: f64,
}

/// A view, and what hides strands from it; that may be finer or coarser than the view's picture.
pub(super) struct Seen<'a> {
    camera: Camera<f64>,
    occluder: Option<&'a Occluder>,
    size: DVec2,
}

impl<'a> Seen<'a> {
    pub fn new(view: &View, occluder: Option<&'a Occluder>) -> Seen<'a> {
        Seen { camera: view.camera(), occluder, size: DVec2::new(view.width_px as f64, view.height_px as f64) }
    }

    pub fn place(&self, point: &[f64; 4]) -> Place {
        let [x, y, radius] = self.camera.project(point);
        let visibility = self.occluder.map_or(1.0, |occluder| {
            let finer = DVec2::new(occluder.depth.width as f64, occluder.depth.height as f64) / self.size;
            occluder.visibility((DVec2::new(x, y) * finer).to_array(), self.camera.depth(point))
        });
        Place { at: DVec2::new(x, y), radius, visibility }
    }
}

/// Leaves out places that the line between their neighbours stands for, and equal ones. `off` adds to how far the third is
/// off the line from the first to the second, of which the last number is the share it has gone.
pub(super) fn thinned(
    places: &[Place],
    tolerance_px: f64,
    off: impl Fn(&Place, &Place, &Place, f64) -> f64,
) -> Vec<Place> {
    let mut kept = vec![places[0]];
    let mut from = 0;
    for to in 2..=places.len() {
        let fits = to < places.len() && to - from <= MAX_SKIP && {
            let (a, b) = (&places[from], &places[to]);
            let along = b.at - a.at;
            let squared = along.length_squared().max(1e-12);
            places[from + 1..to].iter().all(|place| {
                let share = ((place.at - a.at).dot(along) / squared).clamp(0.0, 1.0);
                (a.at + along * share).distance(place.at) + off(a, b, place, share) <= tolerance_px
            })
        };
        if !fits {
            kept.push(places[to - 1]);
            from = to - 1;
        }
    }
    kept
}
