//! What other sides should show: those that were given, and those drawn from the seed.

use super::given::Given;
use super::plan::Plan;
use crate::parallel;
use crate::picture::{Ink, OBJECT_PX, find_object};
use crate::rng::Rng;
use crate::sculpture::render_sampled;
use crate::settings::{Settings, Start};
use crate::view::{Image, Target, View};
use crate::wire::Wire;
use crate::{Error, Result};

/// World height of the pictures of the sides: the unit ball with a margin.
const SIDE_HEIGHT_WORLD: f64 = 2.2;
/// Elevations from which sides are drawn, degrees.
const ELEVATIONS: [f64; 2] = [-10.0, 80.0];
/// Width of creases in the sides' targets, px at 256.
const CREASE_PX: f64 = 2.0;
/// Ink of the sides' targets where the solid is.
const SIDE_INK: f32 = 0.4;
/// Samples a knot span of the first wire in the sides' targets: its spans are a few pixels long.
const SIDE_SAMPLES: usize = 4;

/// The silhouettes from other sides, as high as the front's, and the views they are seen from.
pub(super) fn other_sides(
    given: &Given,
    height_px: usize,
    height_world: f64,
    notes: &mut Vec<String>,
) -> Result<Vec<(View, Image)>> {
    let each = given.others.iter().map(|(picture, seen_from)| {
        let object = find_object(picture, None, 1)?;
        notes.extend(object.notes);
        let view = seen_from.resolve(&[], height_world, OBJECT_PX)?;
        let part =
            object.body.threshold(0.5).bounding_box().ok_or_else(|| {
                Error::picture(picture.name(), "shows no object", "use a picture with a larger object")
            })?;
        let half = 0.5 * OBJECT_PX as f64 * part.height() as f64 / height_px as f64;
        let [x, y] = [0.5 * (part.left + part.right) as f64, 0.5 * (part.top + part.bottom) as f64];
        Ok((view, object.body.window([x - half, y - half, x + half, y + half], OBJECT_PX, OBJECT_PX)))
    });
    each.collect()
}

/// Views from all round, drawn from the seed: azimuths evenly spread, elevations at random. Turn 0 is what the report
/// measures, named by its directions; others are fitted, and named by number since they change.
pub(super) fn side_views(turn: u64, settings: &Settings) -> Vec<View> {
    let mut rng = Rng::new(settings.seed, 0x7369_6465 + turn);
    let count = settings.side_views;
    let first = rng.unit();
    let each = (0..count).map(|k| {
        let azimuth = (360.0 * (k as f64 + first + rng.range(-0.25, 0.25)) / count as f64).round().rem_euclid(360.0);
        let elevation = rng.range(ELEVATIONS[0], ELEVATIONS[1]).round();
        let name = if turn == 0 { format!("{azimuth},{elevation}") } else { format!("side {}", k + 1) };
        View::orthographic(&name, azimuth.to_radians(), elevation.to_radians(), SIDE_HEIGHT_WORLD, settings.size)
    });
    each.collect()
}

impl Plan {
    /// What is fitted from iteration `iteration` on: the front, the sides that were given, and the drawn ones of that time.
    pub(super) fn fitted(&self, first: &Wire, iteration: usize) -> Vec<Target> {
        let settings = &self.settings;
        let turn = iteration.checked_div(settings.new_sides).map_or(0, |turn| turn as u64 + 1);
        let given = self.targets[1..self.sources.len()].iter().map(|target| target.view.clone());
        let sides: Vec<View> = given.chain(side_views(turn, settings)).collect();
        let sides = parallel::map(&sides, 1, |view| self.side_target(view, first));
        std::iter::once(self.targets[0].clone()).chain(sides).collect()
    }

    /// What the fit asks of the side seen in `view`: what it shows of the `first` wire within the solid, and faintly the
    /// solid's outline and creases there, so that strands nearby move onto them.
    fn side_target(&self, view: &View, first: &Wire) -> Target {
        let settings = &self.settings;
        let shown = self.solid.shown(view);
        let mut ink = shown.silhouette();
        match settings.start {
            Start::Contour => {
                let lines = render_sampled(first, view, SIDE_SAMPLES);
                ink.data.iter_mut().zip(&lines.data).for_each(|(ink, line)| *ink = ink.min(*line));
            }
            _ => ink.data.iter_mut().for_each(|ink| *ink *= SIDE_INK),
        }
        if settings.creases > 0.0 {
            let creases = shown.creases(CREASE_PX * view.height_px as f64 / 256.0);
            let wanted = |crease: &f32| settings.creases as f32 * crease;
            ink.data.iter_mut().zip(&creases.data).for_each(|(ink, crease)| *ink = ink.max(wanted(crease)));
        }
        Target { view: view.clone(), ink }
    }
}
