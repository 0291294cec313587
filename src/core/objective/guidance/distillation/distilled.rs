//! The guidance itself: noise a view, ask the model, and pull by what it would take away beyond the noise.
//!
//! The gradient to what the model sees, x, is `w(t) (eps_hat - eps)` with `eps_hat = u + g (c - u)`: score distillation
//! (Poole et al. 2022, eq. 3) with classifier-free guidance (Ho and Salimans 2022). It is no gradient of a loss; the number that is
//! told beside it is half its square, as in the paper's code.

use super::{Annealing, Diffusion};
use crate::objective::{Guidance, Look, Progress, Rendered};
use crate::rng::Rng;
use crate::view::Camera;
use crate::work::Work;
use crate::{Error, Result};

/// A diffusion model, forward only: the contract eps-v1 of `tools/guidance`.
pub trait Denoiser: Send {
    /// Channels, rows and columns of what it sees: latents, or pixels from -1 to 1, of one channel or of three.
    fn shape(&self) -> [usize; 3];

    /// The noise that it sees in each of n rows `x_t`, `[n, C, h, w]`, at one time for all, each in its context, `[n, …]`.
    ///
    /// # Errors
    /// [`Error::Guidance`] for whatever keeps it from answering.
    fn run<'a>(&'a mut self, x_t: &'a [f32], t: usize, contexts: &'a [f32]) -> Work<'a, Result<Vec<f32>>>;
}

/// What makes latents of pictures, and gradients to them back: the contract vjp-v1 of `tools/guidance`.
pub trait Encoder: Send {
    /// Side of its pictures, px.
    fn size(&self) -> usize;

    /// The latent of `image` (`[3, S, S]`, sRGB 0 to 1), and the gradient to the image for the gradient `cotangent` to the latent.
    ///
    /// # Errors
    /// [`Error::Guidance`] for whatever keeps it from answering.
    fn run<'a>(&'a mut self, image: &'a [f32], cotangent: &'a [f32]) -> Work<'a, Result<Latent>>;
}

/// What an [`Encoder`] answers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Latent {
    /// The latent.
    pub latent: Vec<f32>,
    /// `[3, S, S]`.
    pub gradient: Vec<f32>,
}

/// What a view is to show, as the model was told words or views: its context with them and without.
#[derive(Debug, Clone, PartialEq)]
pub struct Prompt {
    /// What is asked for.
    pub context: Vec<f32>,
    /// The same of nothing: empty words.
    pub nothing: Vec<f32>,
}

/// Says what views are to show.
pub trait Prompts: Send {
    /// Of the view of this index, as `camera` sees it now; nothing for a view that is left alone.
    ///
    /// # Errors
    /// [`Error::Guidance`] for whatever keeps it from answering.
    fn of<'a>(&'a mut self, view: usize, camera: &'a Camera<f32>) -> Work<'a, Result<Option<Prompt>>>;
}

/// One for each view, wherever that is seen from: words.
impl Prompts for Vec<Option<Prompt>> {
    fn of<'a>(&'a mut self, view: usize, _: &'a Camera<f32>) -> Work<'a, Result<Option<Prompt>>> {
        Work::Done(Ok(self.get(view).cloned().flatten()))
    }
}

/// A [`Guidance`] by a diffusion model.
pub struct Distilled {
    /// The model.
    pub denoiser: Box<dyn Denoiser>,
    /// What its latents are made by; none where it sees pixels.
    pub encoder: Option<Box<dyn Encoder>>,
    /// How noise grows.
    pub diffusion: Diffusion,
    /// How the time falls.
    pub annealing: Annealing,
    /// What it is shown of a view: all of it, or several views of it, so that no single raster decides.
    pub look: Look,
    /// What each view is to show.
    pub prompts: Box<dyn Prompts>,
    /// How much of the difference between asked for and nothing counts: 100 for words, 3 for views of a thing.
    pub scale: f32,
    /// The longest gradient to a number that the model sees, before weights; infinite for any.
    pub clamp: f32,
    /// Of times and noise.
    pub seed: u64,
}

impl Distilled {
    /// What the model sees of a picture, `[3, S, S]`.
    async fn seen(&mut self, image: &[f32]) -> Result<Vec<f32>> {
        let [channels, rows, columns] = self.denoiser.shape();
        match &mut self.encoder {
            None if rows != columns => Err(unfit(format!("it sees pictures of {rows} x {columns} px, no squares"))),
            None => pixels(image, channels)
                .ok_or_else(|| unfit(format!("it sees {channels} channels, and pixels have one or three"))),
            Some(encoder) => Ok(encoder.run(image, &vec![0.0; channels * rows * columns]).done().await?.latent),
        }
    }

    /// The gradient to the picture for the gradient to what the model sees of it.
    async fn pulled(&mut self, image: &[f32], d_seen: &[f32]) -> Result<Vec<f32>> {
        match &mut self.encoder {
            None => Ok(pixels_vjp(d_seen, image.len())),
            Some(encoder) => Ok(encoder.run(image, d_seen).done().await?.gradient),
        }
    }

    /// w(t) (eps_hat - eps) for each of what the model sees of view `index`, all of them asked at once.
    async fn residuals(
        &mut self,
        seen: &[Vec<f32>],
        prompt: &Prompt,
        progress: Progress,
        index: usize,
    ) -> Result<Vec<Vec<f32>>> {
        // One time for all views of an iteration, and noise of its own for each.
        let time = &mut Rng::new(self.seed, progress.iteration as u64);
        let t = self.annealing.time(&self.diffusion, progress.share(), time);
        let mut rng = Rng::new(self.seed ^ 0x6e6f_6973, (progress.iteration as u64) << 16 | index as u64);
        let seen = seen.concat();
        let noise: Vec<f32> = (0..seen.len()).map(|_| rng.normal() as f32).collect();
        let alpha_bar = self.diffusion.alpha_bar(t);
        let (picture, other) = (alpha_bar.sqrt() as f32, (1.0 - alpha_bar).sqrt() as f32);
        let x_t: Vec<f32> = seen.iter().zip(&noise).map(|(x, eps)| picture * x + other * eps).collect();
        let size = self.denoiser.shape().iter().product();
        let rows = seen.len() / size;
        let contexts = [prompt.nothing.repeat(rows), prompt.context.repeat(rows)].concat();
        let answers = self.denoiser.run(&x_t.repeat(2), t, &contexts).done().await?;
        if answers.len() != 2 * seen.len() {
            return Err(unfit(format!("it answered with {} numbers, not {}", answers.len(), 2 * seen.len())));
        }
        let (nothing, asked) = answers.split_at(seen.len());
        let weight = self.diffusion.weight(t) as f32;
        let (scale, most) = (self.scale, self.clamp);
        let pull = |((u, c), eps): ((&f32, &f32), &f32)| weight * (u + scale * (c - u) - eps).clamp(-most, most);
        let residuals: Vec<f32> = nothing.iter().zip(asked).zip(&noise).map(pull).collect();
        Ok(residuals.chunks_exact(size).map(<[f32]>::to_vec).collect())
    }
}

fn unfit(problem: String) -> Error {
    Error::guidance("", problem, "take a model of the contract eps-v1, with the encoder of its latents")
}

/// What a model of one or three channels sees of a picture `[3, S, S]` from 0 to 1: the mean of its channels, or each.
fn pixels(image: &[f32], channels: usize) -> Option<Vec<f32>> {
    match channels {
        1 => {
            let [red, green, blue] = [0, 1, 2].map(|channel| &image[channel * (image.len() / 3)..]);
            let grey = red.iter().zip(green).zip(blue).map(|((r, g), b)| (r + g + b) / 3.0);
            Some(grey.map(|value| 2.0 * value - 1.0).collect())
        }
        3 => Some(image.iter().map(|value| 2.0 * value - 1.0).collect()),
        _ => None,
    }
}

/// The adjoint of [`pixels`], for a picture of `count` numbers.
fn pixels_vjp(d_seen: &[f32], count: usize) -> Vec<f32> {
    let repeats = count / d_seen.len();
    d_seen.iter().map(|d| 2.0 / repeats as f32 * d).collect::<Vec<_>>().repeat(repeats)
}

impl Guidance for Distilled {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], progress: Progress) -> Work<'a, Result<f32>> {
        Work::later(async move {
            let [_, rows, _] = self.denoiser.shape();
            let size = self.encoder.as_ref().map_or(rows, |encoder| encoder.size());
            let mut loss = 0.0;
            for (index, view) in views.iter_mut().enumerate() {
                let Some(prompt) = self.prompts.of(index, &view.camera).done().await? else { continue };
                let patches = self.look.patches(view.width, view.height, self.seed, progress.iteration, index);
                let (mut images, mut seen) = (Vec::new(), Vec::new());
                for patch in &patches {
                    let mut image = vec![0.0; 3 * size * size];
                    patch.draw(&view.coverage, view.width, size, &mut image);
                    seen.push(self.seen(&image).await?);
                    images.push(image);
                }
                let residuals = self.residuals(&seen, &prompt, progress, index).await?;
                for ((patch, image), residual) in patches.iter().zip(&images).zip(&residuals) {
                    // A mean, so that one weight serves pictures and latents of every size.
                    let share = view.guided_weight() / (patches.len() * residual.len()) as f32;
                    loss += 0.5 * share * residual.iter().map(|r| r * r).sum::<f32>();
                    let d_seen: Vec<f32> = residual.iter().map(|r| share * r).collect();
                    let d_image = self.pulled(image, &d_seen).await?;
                    patch.pull(&d_image, size, view.width, &mut view.gradient);
                }
            }
            Ok(loss)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::View;
    use crate::work::wait;

    const SIDE: usize = 8;

    /// The best denoiser there is for pictures that are `mean` plus independent noise of variance `spread`: its answer is
    /// known. The context's one number says how much of the mean there is.
    struct Gaussian {
        mean: Vec<f32>,
        spread: f64,
        diffusion: Diffusion,
    }

    impl Denoiser for Gaussian {
        fn shape(&self) -> [usize; 3] {
            [self.mean.len() / (SIDE * SIDE), SIDE, SIDE]
        }

        fn run<'a>(&'a mut self, x_t: &'a [f32], t: usize, contexts: &'a [f32]) -> Work<'a, Result<Vec<f32>>> {
            let alpha_bar = self.diffusion.alpha_bar(t);
            let noise = (1.0 - alpha_bar).sqrt();
            let share = noise / (alpha_bar * self.spread + 1.0 - alpha_bar);
            let rows = x_t.chunks(self.mean.len()).zip(contexts);
            let eps = rows.flat_map(|(row, context)| {
                row.iter().zip(&self.mean).map(move |(x, mean)| {
                    (share * (f64::from(*x) - alpha_bar.sqrt() * f64::from(context * mean))) as f32
                })
            });
            Work::Done(Ok(eps.collect()))
        }
    }

    /// Latents are pixels, twice as large.
    struct Twice;

    impl Encoder for Twice {
        fn size(&self) -> usize {
            SIDE
        }

        fn run<'a>(&'a mut self, image: &'a [f32], cotangent: &'a [f32]) -> Work<'a, Result<Latent>> {
            let latent = image.iter().map(|value| 2.0 * (2.0 * value - 1.0)).collect();
            Work::Done(Ok(Latent { latent, gradient: cotangent.iter().map(|d| 4.0 * d).collect() }))
        }
    }

    /// Ink in the left half.
    fn wanted(pixel: usize) -> f32 {
        if pixel % SIDE < SIDE / 2 { 0.8 } else { 0.1 }
    }

    fn distilled(scale: f32, latent: bool) -> Distilled {
        of_channels(3, scale, latent)
    }

    fn of_channels(channels: usize, scale: f32, latent: bool) -> Distilled {
        let diffusion = Diffusion::linear(1e-4, 0.02, 1000);
        let factor = if latent { 2.0 } else { 1.0 };
        let mean = (0..channels * SIDE * SIDE).map(|i| factor * (1.0 - 2.0 * wanted(i % (SIDE * SIDE)))).collect();
        Distilled {
            denoiser: Box::new(Gaussian { mean, spread: 0.05, diffusion: diffusion.clone() }),
            encoder: latent.then(|| Box::new(Twice) as Box<dyn Encoder>),
            diffusion,
            annealing: Annealing::FALLING,
            look: Look::Whole,
            prompts: Box::new(vec![Some(Prompt { context: vec![1.0], nothing: vec![0.0] }), None]),
            scale,
            clamp: f32::INFINITY,
            seed: 1,
        }
    }

    fn views() -> [Rendered; 2] {
        let [front, side, _] = View::canonical(2.2, SIDE).map(|view| view.camera());
        [Rendered::new(front, SIDE, SIDE, 1.0), Rendered::new(side, SIDE, SIDE, 1.0)]
    }

    /// Follows the pull for a while.
    fn followed(distilled: &mut Distilled) -> [Rendered; 2] {
        let mut views = views();
        views.iter_mut().for_each(|view| view.coverage.fill(0.4));
        for iteration in 0..800 {
            views.iter_mut().for_each(Rendered::clear_gradient);
            let loss = wait(distilled.guide(&mut views, Progress { iteration, iterations: 800 }).done()).unwrap();
            assert!(loss.is_finite());
            for view in &mut views {
                let rate = 2.0 * (1.0 - iteration as f32 / 800.0);
                view.coverage.iter_mut().zip(&view.gradient).for_each(|(ink, d)| *ink -= rate * d);
            }
        }
        views
    }

    #[test]
    fn views_become_what_the_model_knows_and_the_others_stay() {
        for (channels, latent) in [(3, false), (1, false), (3, true)] {
            let [front, side] = followed(&mut of_channels(channels, 1.0, latent));
            let off = front.coverage.iter().enumerate().map(|(pixel, ink)| (ink - wanted(pixel)).abs()).sum::<f32>();
            assert!(off / 64.0 < 0.08, "{}", off / 64.0);
            assert!(side.coverage.iter().all(|&ink| ink == 0.4));
        }
        // Without what was asked for it goes where nothing leads: the middle.
        let [front, _] = followed(&mut distilled(0.0, false));
        assert!(front.coverage.iter().all(|ink| (ink - 0.5).abs() < 0.2), "{:?}", front.coverage);
    }

    #[test]
    fn pixels_of_one_channel_and_of_three_are_pulled_by_the_transposed_map() {
        let mut rng = Rng::new(4, 0);
        let mut random = |count: usize| (0..count).map(|_| rng.range(-1.0, 1.0) as f32).collect::<Vec<_>>();
        let (image, step) = (random(3 * 16), random(3 * 16));
        let moved: Vec<f32> = image.iter().zip(&step).map(|(a, b)| a + b).collect();
        for channels in [1, 3] {
            let d_seen = random(channels * 16);
            let along = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
            // Affine, so that any step is as good as a small one.
            let seen = |image: &[f32]| along(&pixels(image, channels).unwrap(), &d_seen);
            let off = seen(&moved) - seen(&image) - along(&pixels_vjp(&d_seen, 3 * 16), &step);
            assert!(off.abs() < 1e-4, "{channels}: {off}");
        }
        assert_eq!(pixels(&[0.0, 1.0, 0.3, 1.0, 0.6, 1.0], 1), Some(vec![2.0 * 0.3 - 1.0, 1.0]));
        assert_eq!(pixels(&image, 4), None);
    }

    #[test]
    fn the_gradient_is_the_formula() {
        for channels in [1, 3] {
            the_gradient_is_the_formula_of(channels);
        }
    }

    fn the_gradient_is_the_formula_of(channels: usize) {
        let mut distilled = of_channels(channels, 7.5, false);
        let mut views = views();
        views.iter_mut().for_each(|view| view.coverage.fill(0.3));
        views.iter_mut().for_each(Rendered::clear_gradient);
        let progress = Progress { iteration: 3, iterations: 10 };
        wait(distilled.guide(&mut views, progress).done()).unwrap();
        // By hand, from the same time and noise.
        let t = Annealing::FALLING.time(&distilled.diffusion, 0.3, &mut Rng::new(1, 3));
        let mut rng = Rng::new(1 ^ 0x6e6f_6973, 3 << 16);
        let noise: Vec<f64> = (0..channels * SIDE * SIDE).map(|_| rng.normal()).collect();
        let (a, n) = (distilled.diffusion.alpha_bar(t), SIDE * SIDE);
        let share = (1.0 - a).sqrt() / (a * 0.05 + 1.0 - a);
        let pull = |i: usize| {
            let x_t = a.sqrt() * (1.0 - 2.0 * 0.3) + (1.0 - a).sqrt() * noise[i];
            let mean = 1.0 - 2.0 * f64::from(wanted(i % n));
            let (u, c) = (share * x_t, share * (x_t - a.sqrt() * mean));
            // Ink is 1 - picture, and pixels are seen from -1 to 1.
            -2.0 * (1.0 - a) * (u + 7.5 * (c - u) - noise[i]) / (channels * n) as f64
        };
        for pixel in 0..n {
            let by_hand: f64 = (0..channels).map(|channel| pull(pixel + channel * n)).sum();
            assert!((f64::from(views[0].gradient[pixel]) - by_hand).abs() < 1e-6, "{pixel}");
        }
        assert!(views[0].gradient.iter().any(|d| d.abs() > 1e-4));
    }

    #[test]
    fn several_looks_are_averaged_each_with_noise_of_its_own() {
        // Every look is at the whole, so that only noise tells them apart.
        let still = |count| Look::Affine { count, turn: 0.0, scale: 1.0, shift: 0.0 };
        let pull = |look: Look, seed: u64| {
            let mut distilled = Distilled { look, seed, ..distilled(3.0, false) };
            let mut views = views();
            views.iter_mut().for_each(|view| view.coverage.fill(0.3));
            views.iter_mut().for_each(Rendered::clear_gradient);
            wait(distilled.guide(&mut views, Progress { iteration: 3, iterations: 10 }).done()).unwrap();
            views[0].gradient.clone()
        };
        let near = |a: &[f32], b: &[f32]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6);
        assert!(near(&pull(still(1), 1), &pull(Look::Whole, 1)));
        let (one, many) = (pull(still(1), 1), pull(still(64), 1));
        assert!(!near(&one, &many));
        // Noise averages out, and the same of all seeds is left.
        let spread = |pulls: [Vec<f32>; 2]| {
            let [a, b] = pulls;
            a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f32>().sqrt()
        };
        let same_time = |count: usize| spread([pull(still(count), 1), pull(still(2 * count), 1)]);
        assert!(same_time(64) < 0.5 * same_time(1), "{} and {}", same_time(64), same_time(1));
    }

    #[test]
    fn pulls_are_clamped_and_wrong_answers_refused() {
        let mut clamped = Distilled { clamp: 0.01, ..distilled(100.0, false) };
        let mut views = views();
        views.iter_mut().for_each(Rendered::clear_gradient);
        wait(clamped.guide(&mut views, Progress { iteration: 1, iterations: 9 }).done()).unwrap();
        let most = 3.0 * 2.0 * 0.01 / (3 * SIDE * SIDE) as f32;
        assert!(views[0].gradient.iter().all(|d| d.abs() <= 1.0001 * most));

        struct Short;
        impl Denoiser for Short {
            fn shape(&self) -> [usize; 3] {
                [3, SIDE, SIDE]
            }
            fn run<'a>(&'a mut self, _: &'a [f32], _: usize, _: &'a [f32]) -> Work<'a, Result<Vec<f32>>> {
                Work::Done(Ok(vec![0.0; 5]))
            }
        }
        clamped.denoiser = Box::new(Short);
        let mut refused =
            |by: &mut Distilled| wait(by.guide(&mut views, Progress::default()).done()).unwrap_err().to_string();
        assert!(refused(&mut clamped).contains("5 numbers"));
        assert!(refused(&mut of_channels(4, 1.0, false)).contains("4 channels"));
    }
}
