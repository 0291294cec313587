//! Losses that look at what the views show, beside the comparison with their targets: texture statistics, a network that
//! knows words or pictures, whatever anybody writes.
//!
//! ```
//! use wire4d_core::objective::{Guidance, Progress, Rendered};
//! use wire4d_core::optimize::{Problem, Recipe, Session, Work};
//! use wire4d_core::view::{Image, Target, View};
//! use wire4d_core::wire::Wire;
//!
//! /// Wants as much ink in the left half of each view as it is told.
//! struct Left(f32);
//!
//! impl Guidance for Left {
//!     fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, wire4d_core::Result<f32>> {
//!         let mut loss = 0.0;
//!         for view in views {
//!             let is_left = |pixel: usize| pixel % view.width < view.width / 2;
//!             let half = (view.width / 2 * view.height) as f32;
//!             let left = |(pixel, ink): (usize, &f32)| if is_left(pixel) { *ink } else { 0.0 };
//!             let off = view.coverage.iter().enumerate().map(left).sum::<f32>() / half - self.0;
//!             loss += off * off;
//!             (0..view.gradient.len()).filter(|&pixel| is_left(pixel)).for_each(|pixel| view.gradient[pixel] = 2.0 * off / half);
//!         }
//!         Work::Done(Ok(loss))
//!     }
//! }
//!
//! # fn main() -> wire4d_core::Result<()> {
//! let [view, ..] = View::canonical(2.2, 32);
//! let wire = Wire::open_uniform((0..6).map(|i| [0.3 * f64::from(i) - 0.7, 0.0, 0.0, 0.1]).collect())?;
//! let mut recipe = Recipe::best();
//! recipe.set_iterations(60, 0.5);
//! let target = Target { view, ink: Image::new(32, 32) };
//! let mut problem = Problem::for_drawings(wire, vec![target], recipe);
//! problem.view_weights = vec![0.0];
//! let mut session = Session::new(problem)?;
//! session.guide_by("left", 10.0, Box::new(Left(0.06)));
//! session.step(usize::MAX);
//! let shown = session.coverage(0);
//! let half = shown.width / 2;
//! let left: f32 = shown.data.chunks(shown.width).flat_map(|row| &row[..half]).sum();
//! let share = left / (half * shown.height) as f32;
//! assert!((share - 0.06).abs() < 0.006, "{share}");
//! # Ok(())
//! # }
//! ```

mod distillation;
mod guides;
mod learned;
mod network;
mod patches;

pub use distillation::{Annealing, Denoiser, Diffusion, Distilled, Encoder, Latent, Prompt, Prompts, relative_pose};
pub use guides::Guides;
pub use learned::{Aim, Learned, Member, PICTURE_WEIGHT, WORDS_WEIGHT};
pub use network::{Answer, Batch, Network, embedding, likeness, similarity};
pub use patches::{Look, Patch};

use crate::Result;
use crate::view::{Camera, Image};
use crate::work::Work;

/// One view as an iteration draws it, and what pulls at it. All pictures have one value a pixel, row by row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Rendered {
    /// From where it is seen: world to pixels.
    pub camera: Camera<f32>,
    /// Pixels a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// The view's weight in the loss of pictures, from 0.
    pub weight: f32,
    /// The wire's ink, 0 to 1.
    pub coverage: Vec<f32>,
    /// How much each pixel counts for textures, 0 to 1.
    pub counts: Vec<f32>,
    /// For a [`Guidance`] to write its gradient to the coverage into; zero before it is asked.
    pub gradient: Vec<f32>,
    /// The gradient of the whole loss to the coverage so far.
    pub d_coverage: Vec<f32>,
}

impl Rendered {
    /// A blank view of `width` x `height` pixels of which every pixel counts.
    pub fn new(camera: Camera<f32>, width: usize, height: usize, weight: f32) -> Rendered {
        let pixels = width * height;
        Rendered {
            camera,
            width,
            height,
            weight,
            coverage: vec![0.0; pixels],
            counts: vec![1.0; pixels],
            gradient: Vec::new(),
            d_coverage: vec![0.0; pixels],
        }
    }

    /// The view's weight in what guides: its own, or 1 where that is 0. Such a view is compared with nothing, and guided alone.
    pub fn guided_weight(&self) -> f32 {
        if self.weight > 0.0 { self.weight } else { 1.0 }
    }

    /// Pixels count as `mask` says, or all of them.
    pub fn count(&mut self, mask: Option<&Image>) {
        match mask {
            Some(mask) => self.counts.clone_from(&mask.data),
            None => self.counts.fill(1.0),
        }
    }

    /// Nothing pulls yet.
    pub(crate) fn clear_gradient(&mut self) {
        self.gradient.clear();
        self.gradient.resize(self.coverage.len(), 0.0);
    }

    /// `weight` times the guidance's gradient joins the loss's.
    pub(crate) fn pull(&mut self, weight: f32) {
        self.d_coverage.iter_mut().zip(&self.gradient).for_each(|(sum, &d)| *sum += weight * d);
    }
}

/// How far a fit is: what schedules and random choices of a guidance go by, so that a resumed fit makes the same ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Iterations done before.
    pub iteration: usize,
    /// Iterations in all.
    pub iterations: usize,
}

impl Progress {
    /// From 0 at the first iteration to 1 after the last.
    pub fn share(&self) -> f64 {
        self.iteration as f64 / self.iterations.max(1) as f64
    }
}

/// A loss on what the views show together.
///
/// Between drawing and the adjoint of drawing an engine asks for it, with all views at once. To be repeatable it may depend
/// on the views, on [`Progress`] and on a seed of its own; not on how often it was asked.
pub trait Guidance: Send {
    /// The loss of `views`; its gradient to each one's coverage goes to [`Rendered::gradient`].
    ///
    /// # Errors
    /// Whatever keeps it from answering, as [`crate::Error::Guidance`]: the fit goes on without it.
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], progress: Progress) -> Work<'a, Result<f32>>;
}
