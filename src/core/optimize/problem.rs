//! What to fit, as pure data: the first wire, what each view should show, and the recipe.

use super::SurfacePull;
use super::recipe::Recipe;
use crate::objective::Texture;
use crate::view::{Image, Occluder, Target};
use crate::wire::Wire;
use crate::{Error, Result};
use std::sync::Arc;

/// Hard bounds of the width (full diameter) in world units. Equal bounds give a wire of constant width.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct WidthBounds {
    /// Thinnest, from 0.
    pub min_world: f64,
    /// Thickest.
    pub max_world: f64,
}

/// What a fit looks at for a while.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Seen {
    /// The views and what they should show.
    pub targets: Vec<Target>,
    /// As [`Problem::occluders`].
    pub occluders: Vec<Occluder>,
    /// As [`Problem::texture_masks`].
    pub texture_masks: Vec<Image>,
}

/// A fit to be done: pure data, all a [`super::Session`] needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Where the wire starts.
    pub wire: Wire,
    /// What each view should show; at least one.
    pub targets: Vec<Target>,
    /// Weight of each view's image loss; empty means 1 each.
    pub view_weights: Vec<f64>,
    /// What hides strands from each view, of its target's size; empty means nothing does.
    pub occluders: Vec<Occluder>,
    /// What all views' textures should be like, if anything.
    pub texture: Option<Arc<Texture>>,
    /// Weight of the texture's loss, times each view's.
    pub texture_weight: f64,
    /// How much each pixel of a view counts for the texture, 0 to 1, of its target's size; empty means all count.
    pub texture_masks: Vec<Image>,
    /// What the wire is kept on, if anything.
    pub surface: Option<SurfacePull>,
    /// Hard bounds of the width.
    pub width: WidthBounds,
    /// How to fit it.
    pub recipe: Recipe,
    /// Drives everything random: where re-initialised control points go.
    pub seed: u64,
}

/// Pictures beyond this side are refused: an iteration would take seconds.
const LARGEST_SIDE_PX: usize = 8192;

impl Problem {
    /// Unit weights and seed 0, and a width from one pixel to twenty of a 256 px picture: thin enough to draw with,
    /// and never so thin that the wire seems to break.
    pub fn for_drawings(wire: Wire, targets: Vec<Target>, recipe: Recipe) -> Problem {
        let px_256 = world_per_px(&targets, 256.0);
        let width = WidthBounds { min_world: px_256, max_world: 20.0 * px_256 };
        Problem {
            wire,
            targets,
            view_weights: Vec::new(),
            occluders: Vec::new(),
            texture: None,
            texture_weight: 0.0,
            texture_masks: Vec::new(),
            surface: None,
            width,
            recipe,
            seed: 0,
        }
    }

    /// Looks at something else, and says what it looked at before.
    pub(super) fn look_at(&mut self, seen: Seen) -> Seen {
        let Seen { targets, occluders, texture_masks } = seen;
        Seen {
            targets: std::mem::replace(&mut self.targets, targets),
            occluders: std::mem::replace(&mut self.occluders, occluders),
            texture_masks: std::mem::replace(&mut self.texture_masks, texture_masks),
        }
    }

    /// Weight of view `v`'s image loss.
    pub fn view_weight(&self, v: usize) -> f64 {
        self.view_weights.get(v).copied().unwrap_or(1.0)
    }

    /// World units in one pixel of pictures whose larger side is `size_px`; the mean over the views, at the origin.
    pub fn world_per_px(&self, size_px: f64) -> f64 {
        world_per_px(&self.targets, size_px)
    }

    /// Refuses what cannot be fitted.
    ///
    /// # Errors
    /// [`Error::Pictures`] without views or with another number of occluders, [`Error::Picture`] for ink or depths that do
    /// not fit their view or are out of range, [`Error::Setting`] for widths, weights or recipe entries out of range.
    pub fn check(&self) -> Result<()> {
        check_seen(&self.targets, &self.occluders, &self.texture_masks)?;
        self.check_texture()?;
        if let Some(surface) = &self.surface {
            surface.check()?;
        }
        let weights_fit = self.view_weights.is_empty() || self.view_weights.len() == self.targets.len();
        if !weights_fit || !self.view_weights.iter().all(|weight| weight.is_finite() && *weight >= 0.0) {
            return Err(Error::setting(
                "view weights",
                format!("{:?} for {} views", self.view_weights, self.targets.len()),
                "give one weight from 0 up for each view, or none at all",
            ));
        }
        let WidthBounds { min_world, max_world } = self.width;
        if !(min_world.is_finite() && max_world.is_finite() && 0.0 <= min_world && min_world <= max_world) {
            return Err(Error::setting(
                "width",
                format!("from {min_world} to {max_world}"),
                "give a minimum from 0 up and a maximum not below it",
            ));
        }
        self.recipe.check()
    }

    fn check_texture(&self) -> Result<()> {
        if !(self.texture_weight.is_finite() && self.texture_weight >= 0.0) {
            let problem = format!("its weight is {}", self.texture_weight);
            return Err(Error::setting("texture", problem, "give a weight from 0 up"));
        }
        Ok(())
    }
}

impl Seen {
    /// Refuses what cannot be looked at.
    ///
    /// # Errors
    /// As [`Problem::check`].
    pub(super) fn check(&self) -> Result<()> {
        check_seen(&self.targets, &self.occluders, &self.texture_masks)
    }
}

fn check_seen(targets: &[Target], occluders: &[Occluder], texture_masks: &[Image]) -> Result<()> {
    if targets.is_empty() {
        return Err(Error::Pictures {
            problem: "there is no view to fit".into(),
            remedy: "give at least one picture".into(),
        });
    }
    for Target { view, ink } in targets {
        let refuse = |problem: String, remedy: &str| Err(Error::picture(&view.name, problem, remedy));
        let (width, height) = (ink.width, ink.height);
        if width == 0 || height == 0 || width.max(height) > LARGEST_SIDE_PX {
            return refuse(format!("{width} x {height} pixels"), "give a picture of 1 to 8192 pixels a side");
        }
        if ink.data.len() != width * height || (view.width_px, view.height_px) != (width, height) {
            return refuse(
                format!("{} values of ink for a view of {} x {}", ink.data.len(), view.width_px, view.height_px),
                "give ink of the view's size",
            );
        }
        if !ink.data.iter().all(|value| (0.0..=1.0).contains(value)) {
            return refuse("some ink is not from 0 to 1".into(), "give ink from 0 (ground) to 1");
        }
        let camera = view.camera::<f64>();
        let scale = camera.pixels_per_world(&[0.0; 4]);
        let seen = camera.project(&[0.1, 0.2, 0.3, 0.1]);
        if !(scale.is_finite() && scale > 0.0 && seen.iter().all(|c| c.is_finite())) {
            return refuse("the camera shows nothing".into(), "place eye and target apart, with up across");
        }
    }
    let (count, views) = (occluders.len(), targets.len());
    if count != 0 && count != views {
        let problem = format!("{count} occluders for {views} views");
        return Err(Error::Pictures { problem, remedy: "give one for each view, or none at all".into() });
    }
    for (Occluder { depth, steepness, bias_world }, Target { view, ink }) in occluders.iter().zip(targets) {
        let (width, height) = (ink.width, ink.height);
        if (depth.width, depth.height) != (width, height) || depth.data.len() != width * height {
            let problem = format!("{} depths for a view of {width} x {height}", depth.data.len());
            return Err(Error::picture(&view.name, problem, "give a depth for each pixel of the view"));
        }
        // NaN compares false.
        if !depth.data.iter().all(|&z| z > f32::NEG_INFINITY) {
            let remedy = "give distances from the eye, and infinity for the ground";
            return Err(Error::picture(&view.name, "some depths are no distances", remedy));
        }
        if !(steepness.is_finite() && *steepness > 0.0 && bias_world.is_finite()) {
            return Err(Error::setting(
                "visibility",
                format!("steepness {steepness}, bias {bias_world}"),
                "give a steepness above 0 and a finite bias",
            ));
        }
    }
    let (count, views) = (texture_masks.len(), targets.len());
    if count != 0 && count != views {
        let problem = format!("{count} texture masks for {views} views");
        return Err(Error::Pictures { problem, remedy: "give one for each view, or none at all".into() });
    }
    for (mask, Target { view, ink }) in texture_masks.iter().zip(targets) {
        let fits = (mask.width, mask.height) == (ink.width, ink.height) && mask.data.len() == ink.data.len();
        if !fits || !mask.data.iter().all(|weight| (0.0..=1.0).contains(weight)) {
            let problem = "its texture mask is of another size or not from 0 to 1";
            return Err(Error::picture(&view.name, problem, "give a weight for each pixel of the view"));
        }
    }
    Ok(())
}

fn world_per_px(targets: &[Target], size_px: f64) -> f64 {
    let sum: f64 = targets
        .iter()
        .map(|Target { view, .. }| {
            let larger = view.width_px.max(view.height_px) as f64;
            larger / (size_px * view.camera::<f64>().pixels_per_world(&[0.0; 4]))
        })
        .sum();
    sum / targets.len().max(1) as f64
}
