//! Guidances for tests.
#![allow(dead_code)] // not every test program uses all of it

use wire4d::objective::{Guidance, MultiscaleMse, Progress, Pyramid, Rendered};
use wire4d::optimize::Work;
use wire4d::view::Image;
use wire4d::{Error, Result};

/// Compares each view with a picture as the fit itself does: by this, an engine's own loss is known twice.
pub struct Compares {
    pub wanted: Vec<Image>,
    pub pyramid: Pyramid,
    pub level_ratio: f32,
}

impl Guidance for Compares {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], _: Progress) -> Work<'a, Result<f32>> {
        Work::later(async move {
            let mut sum = 0.0;
            for (view, wanted) in views.iter_mut().zip(&self.wanted) {
                let mut mse = MultiscaleMse::new(self.pyramid, view.width, view.height);
                let (loss, gradient) = mse.evaluate(&view.coverage, &wanted.data, self.level_ratio, view.weight);
                view.gradient.copy_from_slice(gradient);
                sum += loss;
            }
            Ok(sum)
        })
    }
}

/// Wants ink where noise of this iteration says so, and fails when it is told to.
pub struct Noise {
    pub fails_at: usize,
}

impl Guidance for Noise {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], progress: Progress) -> Work<'a, Result<f32>> {
        Work::later(async move {
            if progress.iteration >= self.fails_at {
                return Err(Error::guidance("", "it was switched off in the middle", "the wire goes on without it"));
            }
            let mut rng = wire4d::rng::Rng::new(7, progress.iteration as u64);
            let mut loss = 0.0;
            for view in views.iter_mut() {
                let scale = 1.0 / view.coverage.len() as f32;
                for (gradient, ink) in view.gradient.iter_mut().zip(&view.coverage) {
                    *gradient = scale * (rng.unit() as f32 - 0.5);
                    loss += *gradient * ink;
                }
            }
            Ok(loss)
        })
    }
}
