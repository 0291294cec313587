//! How to fit, as pure data, with the presets. Lengths are in pixels of a 128 or 256 px picture (its larger side), so
//! that one recipe serves any camera and any size.

use super::{AdamOptions, Bending, Schedule, Smooth, TopologyEvent};
use crate::objective::Pyramid;
use crate::{Error, Result};

/// Which rasteriser a stage draws with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RasterKind {
    /// The distance band: cheap, its gradient approximate. For a first stage only.
    Band,
    /// Exact coverage with its exact gradient.
    #[default]
    Exact,
}

/// A run of iterations at one picture size.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Stage {
    /// How many.
    pub iterations: usize,
    /// Larger side of the pictures that are compared.
    pub size_px: usize,
    /// What draws.
    pub raster: RasterKind,
    /// Exact points on each span of the wire, joined by tapered strokes.
    pub samples_per_span: usize,
    /// Shares of the stage after which Adam's moments are zeroed.
    pub restarts: Vec<f64>,
}

/// How to fit: everything but the wire, the targets and the width's bounds.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Recipe {
    /// One after the other.
    pub stages: Vec<Stage>,
    /// How pictures are made coarser for the loss.
    pub pyramid: Pyramid,
    /// Weight of each coarser level relative to the finer one.
    pub level_ratio: Schedule,
    /// Adam's rate for positions, pixels of a 128 px picture.
    pub position_rate_px: Schedule,
    /// Adam's rate for widths (full diameter), pixels of a 128 px picture.
    pub width_rate_px: Schedule,
    /// Adam's constants.
    pub adam: AdamOptions,
    /// Weight of the jerk of positions, ∫|C‴|² dt over the knots with lengths in half picture sides.
    pub jerk_position: Schedule,
    /// Weight of the jerk of the width, likewise.
    pub jerk_width: Schedule,
    /// Weight of the wire's length in half picture sides.
    pub length: Schedule,
    /// Whether and how the wire is kept a wire; then the last one is the result, else the one with the lowest image loss.
    pub smooth: Option<Smooth>,
    /// Whether and how targets bend.
    pub bending: Option<Bending>,
    /// When the control points are edited.
    pub topology: Vec<TopologyEvent>,
}

impl Recipe {
    /// The best wire in about ten seconds: band at 128 px, then exact at 256 px.
    pub fn best() -> Recipe {
        Recipe {
            stages: vec![
                Stage {
                    iterations: 600,
                    size_px: 128,
                    raster: RasterKind::Band,
                    samples_per_span: 2,
                    restarts: vec![0.4, 0.8],
                },
                Stage {
                    iterations: 500,
                    size_px: 256,
                    raster: RasterKind::Exact,
                    samples_per_span: 2,
                    restarts: vec![1.0 / 3.0],
                },
            ],
            pyramid: Pyramid::AveragePool,
            level_ratio: Schedule::Constant(0.5),
            position_rate_px: Schedule::Cosine { from: 0.8, to: 0.025 },
            width_rate_px: Schedule::Cosine { from: 0.24, to: 0.012 },
            adam: AdamOptions::default(),
            jerk_position: Schedule::Geometric { from: 1e-3, to: 1e-4, until: 0.77 },
            jerk_width: Schedule::Geometric { from: 1e-3, to: 1e-4, until: 0.77 },
            length: Schedule::Constant(0.0),
            smooth: None,
            bending: None,
            topology: Vec::new(),
        }
    }

    /// The paper's settings as far as they are known: 900 iterations at one size, Gaussian pyramid, re-initialisation
    /// at 150 and 300, refinement at 600. Its rates and weights are not published: these are of the size its
    /// authors' published code uses.
    pub fn paper() -> Recipe {
        use super::{Moment, NewPoint, Refine, Reinit, TopologyEdit};
        let reinit = Reinit { new_point: NewPoint::RandomInVolume, ..Reinit::default() };
        let event = |iteration, edit| TopologyEvent { at: Moment::Iteration(iteration), edit };
        Recipe {
            stages: vec![Stage {
                iterations: 900,
                size_px: 256,
                raster: RasterKind::Exact,
                samples_per_span: 8,
                restarts: vec![],
            }],
            pyramid: Pyramid::Gaussian,
            level_ratio: Schedule::Constant(1.0),
            position_rate_px: Schedule::Cosine { from: 0.25, to: 0.025 },
            width_rate_px: Schedule::Constant(0.03),
            adam: AdamOptions { beta2: 0.999, ..AdamOptions::default() },
            jerk_position: Schedule::Constant(1e-3),
            jerk_width: Schedule::Constant(1e-3),
            topology: vec![
                event(150, TopologyEdit::Reinit(reinit.clone())),
                event(300, TopologyEdit::Reinit(reinit)),
                event(600, TopologyEdit::Refine(Refine::default())),
            ],
            ..Recipe::best()
        }
    }

    /// Iterations of all stages together.
    pub fn iterations(&self) -> usize {
        self.stages.iter().map(|stage| stage.iterations).sum()
    }

    /// Spreads `total` iterations over two stages, `coarse_share` (0 to 1) of them in the first; with one stage it gets
    /// them all, with more the later ones share what is left as they did before.
    pub fn set_iterations(&mut self, total: usize, coarse_share: f64) {
        let Some((first, rest)) = self.stages.split_first_mut() else { return };
        if rest.is_empty() {
            first.iterations = total;
            return;
        }
        first.iterations = ((total as f64 * coarse_share.clamp(0.0, 1.0)).round() as usize).min(total);
        let before: usize = rest.iter().map(|stage| stage.iterations).sum();
        let mut left = total - first.iterations;
        let share = left as f64 / before.max(1) as f64;
        let (last, middle) = rest.split_last_mut().expect("checked above");
        for stage in middle {
            stage.iterations = ((stage.iterations as f64 * share).round() as usize).min(left);
            left -= stage.iterations;
        }
        last.iterations = left;
    }

    /// Refuses values out of range, naming them.
    pub fn check(&self) -> Result<()> {
        let setting = |name: &str, problem: String, remedy: &str| Err(Error::setting(name, problem, remedy));
        if self.iterations() == 0 {
            return setting("iterations", "there is none in any stage".into(), "give at least 1");
        }
        for stage in &self.stages {
            if !(8..=4096).contains(&stage.size_px) {
                return setting("size", format!("{} px", stage.size_px), "give 8 to 4096 px");
            }
            if !(1..=64).contains(&stage.samples_per_span) {
                return setting("samples", format!("{} a span", stage.samples_per_span), "give 1 to 64");
            }
            if !stage.restarts.iter().all(|share| (0.0..=1.0).contains(share)) {
                return setting("restarts", format!("{:?}", stage.restarts), "give shares of the stage from 0 to 1");
            }
        }
        self.level_ratio.check("level weight")?;
        self.position_rate_px.check("position rate")?;
        self.width_rate_px.check("width rate")?;
        self.jerk_position.check("smoothness")?;
        self.jerk_width.check("smoothness of the width")?;
        self.length.check("length weight")?;
        self.adam.check()?;
        if let Some(smooth) = &self.smooth {
            smooth.check()?;
        }
        if let Some(bending) = &self.bending {
            bending.check()?;
        }
        self.topology.iter().try_for_each(TopologyEvent::check)
    }
}
