//! A texture's levels and weights on a device, and where its numbers lie.

use super::layout::TextureLevel;
use crate::objective::packed_texture::{BUNDLES, DIRECTIONS, FEATURES, STATISTICS, constants, levels, wanted, weights};
use crate::optimize::{Scene, SceneView};

/// Numbers of a level: means, what goes through them, covariances, their gradient, the means' own; see
/// `shaders/texture.wgsl`.
const NUMBERS: usize = 512;
const _: () = assert!(NUMBERS >= 2 * FEATURES + 2 * FEATURES * BUNDLES + DIRECTIONS);

/// What shaders know of a texture; empty without one.
#[derive(Debug, Default)]
pub(super) struct TextureUpload {
    /// Level by level, view by view.
    pub levels: Vec<TextureLevel>,
    /// Constants, what is wanted of each level, then the weights.
    pub given: Vec<f32>,
    /// How many values a device keeps.
    pub room: usize,
    /// Levels of each view.
    pub a_view: usize,
}

impl TextureUpload {
    /// Before [`TextureUpload::set_views`] nothing counts.
    pub fn new(scene: &Scene) -> TextureUpload {
        let Some(texture) = &scene.texture else { return TextureUpload::default() };
        let sides = |view: &SceneView| (view.target.width, view.target.height);
        let of_view = |view: &SceneView| levels(texture, sides(view).0, sides(view).1).collect::<Vec<_>>();
        let of_views: Vec<_> = scene.views.iter().map(of_view).collect();
        let a_view = of_views.iter().map(Vec::len).max().unwrap_or(0);
        let mut given = constants();
        let first_wanted = given.len();
        given.extend(wanted(texture));
        let (mut levels, mut room) = (vec![TextureLevel::default(); a_view * scene.views.len()], 0);
        for (v, (view, of_view)) in scene.views.iter().zip(&of_views).enumerate() {
            for (l, &(halvings, share)) in of_view.iter().enumerate() {
                let (width, height) = (sides(view).0 >> halvings, sides(view).1 >> halvings);
                let (pixels, map) = (width * height, (width / 2) * (height / 2));
                let mut take = |count: usize| {
                    room += count;
                    (room - count) as u32
                };
                let weights = given.len() as u32;
                given.resize(given.len() + map, 0.0);
                levels[v * a_view + l] = TextureLevel {
                    width: width as u32,
                    height: height as u32,
                    halvings: halvings as u32,
                    share,
                    picture: take(pixels),
                    maps: take(FEATURES * map),
                    d_maps: take(FEATURES * map),
                    jets: take(FEATURES * pixels),
                    d_picture: take(pixels),
                    numbers: take(NUMBERS),
                    weights,
                    wanted: (first_wanted + l * STATISTICS) as u32,
                    ..TextureLevel::default()
                };
            }
        }
        TextureUpload { levels, given, room, a_view }
    }

    /// Which pixels of each view count.
    pub fn set_views(&mut self, views: &[SceneView]) {
        if self.a_view == 0 {
            return;
        }
        for (levels, view) in self.levels.chunks_exact_mut(self.a_view).zip(views) {
            let (width, height) = (view.target.width, view.target.height);
            let all = view.texture_mask.is_none().then(|| vec![1.0; width * height]);
            let mask = all.as_ref().or(view.texture_mask.as_ref().map(|mask| &mask.data));
            for level in levels.iter_mut().filter(|level| level.width > 0) {
                let Some(mask) = mask else { continue };
                let found = weights(mask, width, height, level.halvings as usize);
                (level.inverse_weight, level.inverse_pairs) = (0.0, [0.0; 5]);
                if found.count() {
                    level.inverse_weight = 1.0 / found.total;
                    level.inverse_pairs = found.pairs.map(|pairs| 1.0 / pairs);
                }
                self.given[level.weights as usize..][..found.values.len()].copy_from_slice(&found.values);
            }
        }
    }

    /// The most values any level has.
    pub fn most_pixels(&self) -> usize {
        self.levels.iter().map(|level| (level.width * level.height) as usize).max().unwrap_or(0)
    }
}
