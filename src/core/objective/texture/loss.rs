//! The loss of a picture against a texture, with its exact gradient.

use super::features::{DIRECTIONS, FEATURES, Features};
use super::jet::REACH;
use super::statistics::{Statistics, Survey};
use super::{Level as Wanted, Texture};
use crate::objective::{Guidance, Progress, Rendered};
use crate::wire::Real;
use crate::work::Work;
use crate::{Result, parallel};
use std::sync::Arc;

/// The shortest side of a level that has room for filters and shifts.
pub const LEAST_PX: usize = 2 * REACH + 16;

/// The least mean amplitude, over all directions, of a picture with lines in it.
const LEAST_AMPLITUDE: f64 = 0.02;

/// A picture of the pyramid with its weights, and the gradient to it.
#[derive(Debug, Clone)]
struct Floor<R> {
    width: usize,
    picture: Vec<R>,
    weights: Vec<R>,
    d_picture: Vec<R>,
}

/// What a level that counts needs beside its picture. Its features have the size of the next floor.
#[derive(Debug, Clone)]
struct Level<R> {
    features: Features<R>,
    survey: Survey<R>,
    maps: [Vec<R>; FEATURES],
    d_maps: [Vec<R>; FEATURES],
}

/// How many of `levels` levels from `finest` on have [`LEAST_PX`] a side.
pub fn level_count(width: usize, height: usize, finest: usize, levels: usize) -> usize {
    (0..levels).take_while(|level| width.min(height) >> (finest + level) >= LEAST_PX).count()
}

/// Floors of a pyramid of averages, and the levels between them that count.
#[derive(Debug, Clone)]
struct Tower<R> {
    finest: usize,
    floors: Vec<Floor<R>>,
    levels: Vec<Level<R>>,
}

impl<R: Real> Tower<R> {
    /// With as many levels as [`level_count`] says.
    fn new(width: usize, height: usize, finest: usize, levels: usize) -> Tower<R> {
        let count = level_count(width, height, finest, levels);
        let floor = |halvings: usize| {
            let (width, height) = (width >> halvings, height >> halvings);
            let plane = || vec![R::zero(); width * height];
            Floor { width, picture: plane(), weights: plane(), d_picture: plane() }
        };
        let level = |level: usize| {
            let (width, height) = (width >> (finest + level), height >> (finest + level));
            let maps = || std::array::from_fn(|_| vec![R::zero(); (width / 2) * (height / 2)]);
            let survey = Survey::new(width / 2, height / 2);
            Level { features: Features::new(width, height), survey, maps: maps(), d_maps: maps() }
        };
        let floors = if count == 0 { 1 } else { finest + count + 1 };
        Tower { finest, floors: (0..floors).map(floor).collect(), levels: (0..count).map(level).collect() }
    }

    /// Takes the statistics of level `l`.
    fn survey(&mut self, l: usize) -> Option<&Statistics<R>> {
        let level = &mut self.levels[l];
        let [here, above] = &self.floors[self.finest + l..][..2] else { return None };
        level.features.forward(&here.picture, &mut level.maps);
        level.maps[DIRECTIONS].copy_from_slice(&above.picture);
        level.survey.take(&level.maps, &above.weights)
    }

    /// Averages pictures and weights up to the top.
    fn climb(&mut self, picture: &[R], weights: &[R]) {
        self.floors[0].picture.copy_from_slice(picture);
        self.floors[0].weights.copy_from_slice(weights);
        for f in 1..self.floors.len() {
            let (below, above) = self.floors.split_at_mut(f);
            let (below, above) = (&below[f - 1], &mut above[0]);
            average(&below.picture, below.width, &mut above.picture, above.width);
            average(&below.weights, below.width, &mut above.weights, above.width);
        }
    }
}

/// The statistics of a whole picture; none if it has no lines.
pub fn survey(ink: &[f64], width: usize, height: usize, finest: usize, levels: usize) -> Option<Vec<Wanted>> {
    let mut tower = Tower::<f64>::new(width, height, finest, levels);
    tower.climb(ink, &vec![1.0; ink.len()]);
    let count = tower.levels.len();
    let take = |l| {
        let statistics = *tower.survey(l)?;
        Some(Wanted { statistics, amplitude: tower.levels[l].survey.amplitude() })
    };
    let found: Vec<Wanted> = (0..count).map_while(take).collect();
    found.iter().any(|level| level.amplitude > LEAST_AMPLITUDE).then_some(found)
}

/// Compares pictures of one size with a texture, with buffers that live across iterations.
#[derive(Debug, Clone)]
pub struct TextureLoss<R> {
    tower: Tower<R>,
    /// The texture's statistics and the levels' shares in the loss.
    wanted: Vec<(Statistics<R>, R)>,
}

impl<R: Real> TextureLoss<R> {
    /// For pictures of `width` x `height` pixels. What is too small for even the finest level has no loss.
    pub fn new(texture: &Texture, width: usize, height: usize) -> Self {
        let tower = Tower::new(width, height, texture.finest, texture.levels());
        let levels = texture.levels.iter().zip(texture.shares(tower.levels.len()));
        let wanted = levels.map(|(level, share)| (level.statistics.map(R::from_f64), R::from_f64(share)));
        TextureLoss { wanted: wanted.collect(), tower }
    }

    /// `weight` times the mean over levels, by their shares, of the statistics' distance from the texture's, and its gradient to
    /// `coverage`, one value a pixel. `weights`, 0 to 1, says how much each pixel counts. Without any there is no loss.
    pub fn evaluate(&mut self, coverage: &[R], weights: &[R], weight: R) -> (R, &[R]) {
        self.tower.climb(coverage, weights);
        self.tower.floors.iter_mut().for_each(|floor| floor.d_picture.fill(R::zero()));
        let mut loss = R::zero();
        for (l, (wanted, share)) in self.wanted.iter().enumerate() {
            let Some(found) = self.tower.survey(l) else { continue };
            let (distance, gradient) = found.distance(wanted);
            let share = weight * *share;
            loss = loss + share * distance;
            let level = &mut self.tower.levels[l];
            level.survey.pull_back(&gradient.map(|value| share * value), &mut level.d_maps);
            let [here, above] = &mut self.tower.floors[self.tower.finest + l..][..2] else { continue };
            level.features.backward(&level.d_maps, &mut here.d_picture);
            let d_ink = above.d_picture.iter_mut().zip(&level.d_maps[DIRECTIONS]);
            d_ink.for_each(|(d, &ink)| *d = *d + ink);
        }
        for f in (1..self.tower.floors.len()).rev() {
            let (below, above) = self.tower.floors.split_at_mut(f);
            let (below, above) = (&mut below[f - 1], &above[0]);
            spread(&above.d_picture, above.width, &mut below.d_picture, below.width);
        }
        (loss, self.gradient())
    }

    /// As last evaluated.
    fn gradient(&self) -> &[R] {
        &self.tower.floors[0].d_picture
    }

    /// Whether it is for pictures of that width and so many pixels.
    fn fits(&self, width: usize, pixels: usize) -> bool {
        let floor = &self.tower.floors[0];
        (floor.width, floor.picture.len()) == (width, pixels)
    }
}

/// All views' textures against one, each by its view's weight.
#[derive(Debug, Clone)]
pub struct TextureGuidance {
    texture: Arc<Texture>,
    /// One a view.
    losses: Vec<(TextureLoss<f32>, f32)>,
}

impl TextureGuidance {
    /// Asks for that texture.
    pub fn new(texture: Arc<Texture>) -> TextureGuidance {
        TextureGuidance { texture, losses: Vec::new() }
    }

    /// [`Guidance::guide`], done when it returns.
    pub fn guide_now(&mut self, views: &mut [Rendered]) -> f32 {
        let TextureGuidance { texture, losses } = self;
        let fits =
            |((loss, _), view): (&(TextureLoss<f32>, f32), &Rendered)| loss.fits(view.width, view.coverage.len());
        if losses.len() != views.len() || !losses.iter().zip(&*views).all(fits) {
            let new = |view: &Rendered| (TextureLoss::new(texture, view.width, view.height), 0.0);
            *losses = views.iter().map(new).collect();
        }
        let shown = &*views;
        parallel::each_mut(losses, 2, |v, (loss, value)| {
            let Rendered { coverage, counts, weight, .. } = &shown[v];
            *value = loss.evaluate(coverage, counts, *weight).0;
        });
        for ((loss, _), view) in losses.iter().zip(&mut *views) {
            view.gradient.copy_from_slice(loss.gradient());
        }
        losses.iter().map(|(_, value)| value).sum()
    }
}

impl Guidance for TextureGuidance {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, Result<f32>> {
        Work::Done(Ok(self.guide_now(views)))
    }
}

/// Means of 2 x 2 pixels; an odd last row or column is left out.
pub fn average<R: Real>(from: &[R], from_width: usize, to: &mut [R], width: usize) {
    let quarter = R::from_f64(0.25);
    for (y, out) in to.chunks_exact_mut(width.max(1)).enumerate() {
        let (upper, lower) = from[2 * y * from_width..(2 * y + 2) * from_width].split_at(from_width);
        for ((out, u), l) in out.iter_mut().zip(upper.chunks_exact(2)).zip(lower.chunks_exact(2)) {
            *out = quarter * ((u[0] + u[1]) + (l[0] + l[1]));
        }
    }
}

/// `to += averageᵀ from`.
fn spread<R: Real>(from: &[R], from_width: usize, to: &mut [R], width: usize) {
    let quarter = R::from_f64(0.25);
    for (y, row) in from.chunks_exact(from_width.max(1)).enumerate() {
        for out in to[2 * y * width..(2 * y + 2) * width].chunks_exact_mut(width) {
            for (pair, &value) in out.chunks_exact_mut(2).zip(row) {
                pair[0] = pair[0] + quarter * value;
                pair[1] = pair[1] + quarter * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{TextureOptions, crop_weights};
    use super::*;
    use crate::rng::Rng;
    use crate::view::{Image, View};

    fn random(width: usize, height: usize, stream: u64) -> Image {
        let mut rng = Rng::new(5, stream);
        Image { width, height, data: (0..width * height).map(|_| rng.unit() as f32).collect() }
    }

    fn wide(image: &Image) -> Vec<f64> {
        image.data.iter().map(|&value| f64::from(value)).collect()
    }

    /// Size of the picture, first level, levels.
    const CASES: [(usize, usize, usize, usize); 3] = [(50, 57, 0, 2), (60, 53, 1, 3), (24, 24, 0, 1)];

    #[test]
    fn gradients_agree_with_central_differences() {
        for (width, height, finest, levels) in CASES {
            let options = TextureOptions { finest, levels, ..TextureOptions::default() };
            let texture = Texture::of("style", &random(96, 128, 1).blurred(0.8), &options).unwrap();
            let (picture, mask) = (random(width, height, 2), random(width, height, 3));
            let weights = wide(&crop_weights(&mask, 2, width * 2 / 3, &mut Rng::new(4, 0)));
            let mut picture = wide(&picture.blurred(0.7));
            let mut loss = TextureLoss::<f64>::new(&texture, width, height);
            let gradient = loss.evaluate(&picture, &weights, 2.0).1.to_vec();
            let mut rng = Rng::new(6, 0);
            let (mut worst, mut scale) = (0.0f64, 0.0f64);
            for _ in 0..150 {
                let i = rng.below(picture.len());
                let (h, before) = (1e-4, picture[i]);
                picture[i] = before + h;
                let above = loss.evaluate(&picture, &weights, 2.0).0;
                picture[i] = before - h;
                let below = loss.evaluate(&picture, &weights, 2.0).0;
                picture[i] = before;
                worst = worst.max(((above - below) / (2.0 * h) - gradient[i]).abs());
                scale = scale.max(gradient[i].abs());
            }
            assert!(scale > 1e-4 && worst < 1e-6 * scale, "{width} x {height}: {worst:e} of {scale:e}");
            // Sibling: the same measure rejects the gradient under other weights.
            let other = loss.evaluate(&picture, &wide(&mask), 2.0).1;
            let off = other.iter().zip(&gradient).fold(0.0f64, |a, (o, g)| a.max((o - g).abs()));
            assert!(off > 1e-3 * scale);
        }
    }

    #[test]
    fn single_precision_is_enough() {
        let texture = Texture::of("style", &random(128, 128, 1).blurred(1.0), &TextureOptions::default()).unwrap();
        let picture = random(128, 96, 2).blurred(1.5);
        let mut single = TextureLoss::<f32>::new(&texture, 128, 96);
        let mut double = TextureLoss::<f64>::new(&texture, 128, 96);
        let ones = vec![1.0; picture.data.len()];
        let (loss, gradient) = single.evaluate(&picture.data, &ones, 1.0);
        let (exact, exact_gradient) = double.evaluate(&wide(&picture), &vec![1.0; ones.len()], 1.0);
        assert!((f64::from(loss) - exact).abs() < 1e-4 * exact, "{loss} and {exact}");
        let squares = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        let off = squares(&mut gradient.iter().zip(exact_gradient).map(|(&g, e)| f64::from(g) - e));
        assert!(off < 1e-6 * squares(&mut exact_gradient.iter().copied()), "{off:e}");
    }

    #[test]
    fn nothing_to_look_at_has_no_loss() {
        let texture = Texture::of("style", &random(128, 128, 1), &TextureOptions::default()).unwrap();
        let picture = random(96, 96, 2);
        let (none, all) = (vec![0.0; picture.data.len()], vec![1.0; picture.data.len()]);
        let mut loss = TextureLoss::<f32>::new(&texture, 96, 96);
        let (value, gradient) = loss.evaluate(&picture.data, &none, 1.0);
        assert!(value == 0.0 && gradient.iter().all(|&d| d == 0.0));
        // Blank and full pictures have a loss that is a number.
        for even in [0.0, 1.0] {
            let (value, gradient) = loss.evaluate(&vec![even; all.len()], &all, 1.0);
            assert!(value.is_finite() && gradient.iter().all(|d| d.is_finite()), "{value}");
        }
        for (width, height) in [(0, 0), (1, 1), (3, 200), (47, 47)] {
            let picture = random(width, height, 2).data;
            let mut loss = TextureLoss::<f32>::new(&texture, width, height);
            let (value, gradient) = loss.evaluate(&picture, &vec![1.0; picture.len()], 1.0);
            assert!(value == 0.0 && gradient.len() == picture.len(), "{width} x {height}");
        }
    }

    #[test]
    fn guidance_looks_at_each_view_by_its_weight_and_size() {
        let texture = Texture::of("style", &random(96, 96, 1), &TextureOptions::default()).unwrap();
        let mut guidance = TextureGuidance::new(Arc::new(texture.clone()));
        let [front, side, _] = View::canonical(2.2, 64).map(|view| view.camera());
        for (width, height) in [(64, 64), (80, 64)] {
            let mut views = [Rendered::new(front, width, height, 0.5), Rendered::new(side, 64, height, 2.0)];
            for (v, view) in views.iter_mut().enumerate() {
                view.coverage = random(view.width, height, 2 + v as u64).data;
                view.clear_gradient();
            }
            let guided = guidance.guide_now(&mut views);
            let mut sum = 0.0;
            for Rendered { width, height, coverage, counts, weight, gradient, .. } in &views {
                let mut loss = TextureLoss::<f32>::new(&texture, *width, *height);
                let (value, d) = loss.evaluate(coverage, counts, *weight);
                sum += value;
                assert!(value > 0.0 && d == gradient);
            }
            assert_eq!(guided, sum);
        }
    }
}
