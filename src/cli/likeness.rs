//! A learned yardstick of a report: how alike views and pictures are to a network that `--perceptual` names.

use clap::ArgMatches;
use std::path::PathBuf;
use wire4d::Result;
use wire4d::metrics::perceptual::Perceptual;
use wire4d::metrics::{Report, perceive};
use wire4d::objective::likeness;
use wire4d::optimize::wait;
use wire4d::sculpture;
use wire4d::tasks::Run;
use wire4d::view::Image;
use wire4d_guidance::OnnxNetwork;

/// One minus the cosine of what a network sees in both pictures, 0 to 2; with EfficientNet-Lite0's features of several depths
/// (`tools/guidance`) that is a distance much like LPIPS.
pub struct Likeness(OnnxNetwork);

impl Likeness {
    /// The network of `--perceptual`, if there is one.
    pub fn new(matches: &ArgMatches) -> Result<Option<Likeness>> {
        matches.get_one::<PathBuf>("perceptual").map(|file| OnnxNetwork::open(file).map(Likeness)).transpose()
    }

    /// Adds this yardstick's figure to each view that has a picture.
    pub fn measure(&self, report: &mut Report, run: &Run) {
        let made = run.sculpture();
        for target in run.targets() {
            let Some(view) = report.result.views.iter_mut().find(|view| view.name == target.view.name) else {
                continue;
            };
            let render = |width, height| sculpture::render(&made.wire, &target.view.with_size(width, height));
            let scores = perceive(&target.ink, &[self], render);
            // JSON has no word for what is no number.
            view.perceptual.extend(scores.into_iter().filter(|(_, score)| score.is_finite()));
        }
    }
}

impl Perceptual for Likeness {
    fn name(&self) -> &'static str {
        "feature_distance"
    }

    fn best(&self) -> f64 {
        0.0
    }

    /// No number where the network fails on these pictures.
    fn score(&self, rendered: &Image, target: &Image) -> f64 {
        let mut network = self.0.clone();
        let found = wait(likeness(&mut network, rendered, target));
        found.map_or(f64::NAN, |cos| 1.0 - f64::from(cos))
    }
}
