//! What a view asks for: ink by density, style and how a place faces the eye; the texture's windows; what the surface hides.

use super::looks;
use super::plan::Plan;
use crate::mesh::Depths;
use crate::objective::crop_weights;
use crate::optimize::Seen;
use crate::parallel;
use crate::rng::Rng;
use crate::settings::Motif as Laid;
use crate::view::{Image, Occluder, Target, View};
use glam::DVec3;

/// Least and most ink of a style's blank and inked places, as shares of the density.
const TONES: [f64; 2] = [0.2, 1.8];
/// Crops of a view in which its texture is looked at, and their side as a share of the view's.
const CROPS: (usize, f64) = (6, 0.4);
/// Cosine between the normal and the way to the eye from which on a place faces it.
const FACING: f64 = 0.4;

impl Plan {
    pub(super) fn occluder(&self, depths: &Depths) -> Occluder {
        Occluder {
            depth: depths.widened(),
            steepness: self.settings.visibility as f32,
            bias_world: self.settings.visibility_bias as f32,
        }
    }

    /// What views should show, and the surface that hides what is behind it.
    pub(super) fn seen(&self, views: Vec<View>) -> Seen {
        let seen = parallel::map(&views, 1, |view| {
            let depths = Depths::render(&self.mesh, view);
            let ink = depths.shade(&self.mesh, |point, normal| self.wanted(&point, &normal, view) as f32);
            let occluder = self.occluder(&depths);
            (Target { view: view.clone(), ink }, occluder)
        });
        let (targets, occluders) = seen.into_iter().unzip();
        Seen { targets, occluders, texture_masks: Vec::new() }
    }

    /// How much ink a place should have in `view`, 0 to 1.
    fn wanted(&self, point: &[f64; 3], normal: &[f64; 3], view: &View) -> f64 {
        let settings = &self.settings;
        let style = match &self.motif {
            Some(motif) if settings.motif != Laid::Off => {
                let [least, most] = TONES;
                let strength = settings.style_strength * facing(point, normal, view);
                1.0 - strength + strength * (least + (most - least) * motif.tone(point, normal))
            }
            _ => 1.0,
        };
        (settings.density * style).min(1.0)
    }

    /// What iteration `iteration` looks at.
    pub(super) fn looked_at(&self, iteration: usize) -> Seen {
        let settings = &self.settings;
        let mut seen = self.seen(looks::drawn(iteration, settings));
        if self.texture.is_some() {
            let (count, share) = CROPS;
            let side_px = (share * settings.size as f64) as usize;
            let mask = |(view, occluder): (usize, &Occluder)| {
                let mut rng = Rng::new(settings.seed, 0x6372_6f70_0000_0000 + (iteration * 64 + view) as u64);
                let inside = occluder.depth.data.iter().map(|depth| if depth.is_finite() { 1.0 } else { 0.0 });
                crop_weights(&Image { data: inside.collect(), ..occluder.depth }, count, side_px, &mut rng)
            };
            seen.texture_masks = seen.occluders.iter().enumerate().map(mask).collect();
        }
        seen
    }
}

/// How much a place faces the eye: 1 for most, down to 0 at the silhouette, where a motif would be finer than pixels.
fn facing(point: &[f64; 3], normal: &[f64; 3], view: &View) -> f64 {
    let there = DVec3::from(view.eye) - DVec3::from(*point);
    (there.normalize_or_zero().dot(DVec3::from(*normal)) / FACING).clamp(0.0, 1.0)
}
