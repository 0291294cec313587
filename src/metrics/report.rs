//! What `report.json` holds, field for field. Tasks fill it; `wire4d metrics` prints [`ResultReport`].

use super::{PictureMatch, ShapeMetrics, SurfaceReport, length_over_lines, match_pictures, shape};
use crate::picture::{Ground, Picture, Polarity};
use crate::sculpture::{Sculpture, render};
use crate::view::Image;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Longer side, in pixels, of the pictures that figures in pixels are about.
pub const REPORT_SIZE_PX: usize = 256;

/// A whole `report.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// `multiview`, `stroke` or `fill`.
    pub task: String,
    /// Seed of the run.
    pub seed: u64,
    /// `cpu` or `gpu`.
    pub backend: String,
    /// The device's own name.
    pub device: String,
    /// Every setting by name.
    pub settings: Map<String, Value>,
    /// Whether a person stopped the run before its end.
    pub stopped: bool,
    /// Where the time went.
    pub time: TimeReport,
    /// What came out.
    pub result: ResultReport,
    /// How the drawings were arranged.
    pub arrangement: Vec<ArrangementReport>,
    /// How the pictures were read; whoever read them fills it in.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reading: Vec<ReadingReport>,
    /// What else guided the fit; whoever had it guided fills it in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub guidance: Option<GuidanceReport>,
    /// A diffusion model that guided it, likewise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distillation: Option<DistillationReport>,
    /// What happened on the way.
    pub events: Vec<EventReport>,
}

/// Wall-clock times.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct TimeReport {
    /// From input to result.
    pub total_s: f64,
    /// Finding the first wire.
    pub start_s: f64,
    /// Fitting it.
    pub optimize_s: f64,
    /// Iterations done.
    pub iterations: usize,
    /// Mean time of one.
    pub ms_per_iteration: f64,
}

/// Which drawing went where.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ArrangementReport {
    /// Name of the view.
    pub view: String,
    /// The drawing it shows, as the person knows it.
    pub source: String,
    /// Whether it was mirrored left to right.
    pub mirrored: bool,
    /// Quarter turns counter-clockwise, 0 to 3.
    pub quarter_turns: u8,
}

/// What was taken for ink and for ground in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReadingReport {
    /// The picture, as the person knows it.
    pub source: String,
    /// `dark` or `light`: the ink against its ground.
    pub ink: String,
    /// Mean colours of ink and of what is none, `#rrggbb`, or `transparent`.
    pub colours: [String; 2],
    /// Share of the picture that is ink, 0 to 1.
    pub share: f64,
    /// Which is the ground and why, in a sentence.
    pub because: String,
    /// What was done to the picture before, in sentences.
    pub notes: Vec<String>,
}

impl ReadingReport {
    /// How `picture` was read as `ink` on `ground`.
    pub fn new(picture: &Picture, ink: &Image, ground: &Ground) -> ReadingReport {
        let mean = |of: &dyn Fn(f32) -> bool| {
            let (mut sums, mut count) = ([0u64; 3], 0u64);
            for (pixel, _) in picture.rgba().chunks_exact(4).zip(&ink.data).filter(|(p, ink)| p[3] == 255 && of(**ink))
            {
                (0..3).for_each(|c| sums[c] += u64::from(pixel[c]));
                count += 1;
            }
            let [r, g, b] = sums.map(|sum| (sum + count / 2) / count.max(1));
            if count > 0 { format!("#{r:02x}{g:02x}{b:02x}") } else { "transparent".into() }
        };
        ReadingReport {
            source: picture.name().to_owned(),
            ink: if ground.polarity == Polarity::LightInk { "light" } else { "dark" }.into(),
            colours: [mean(&|ink| ink > 0.9), mean(&|ink| ink < 0.1)],
            share: ink.data.iter().map(|&value| f64::from(value)).sum::<f64>() / ink.data.len() as f64,
            because: ground.words(),
            notes: picture.notes(),
        }
    }
}

/// How networks that know words guided the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GuidanceReport {
    /// The networks.
    pub networks: Vec<NetworkReport>,
    /// Weight of what they say, where the comparison of pictures weighs 1.
    pub weight: f32,
    /// What the views that have words were to show.
    pub views: Vec<WordsReport>,
    /// CLIP's score: mean of the views' `cos`; `None` where no view has words.
    pub mean_cos: Option<f32>,
    /// Mean cosine between what the sides show and what the front should, where they were to be like that.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub like_picture: Option<f32>,
    /// Why the fit went on without them, if it did.
    pub trouble: Option<String>,
}

/// A network that guided.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NetworkReport {
    /// What it is called.
    pub name: String,
    /// Whose weights these are.
    pub origin: String,
    /// Under which licence.
    pub licence: String,
    /// The file's SHA-256.
    pub sha256: String,
}

/// A view and its words.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WordsReport {
    /// Name of the view.
    pub view: String,
    /// What it was to show.
    pub words: String,
    /// Cosine between the words and the view, mean over networks, -1 to 1.
    pub cos: f32,
}

/// How a diffusion model guided the fit, by score distillation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DistillationReport {
    /// The model.
    pub denoiser: NetworkReport,
    /// What its latents were made by; `None` where it sees pixels.
    pub encoder: Option<NetworkReport>,
    /// What asked it for new views of the picture; `None` where words did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pose: Option<NetworkReport>,
    /// Weight of what it says, where the comparison of pictures weighs 1.
    pub weight: f32,
    /// How much of the difference between words and none counted.
    pub scale: f32,
    /// How the time fell: `falling` or `dreamtime`.
    pub times: String,
    /// What it was asked for.
    pub views: Vec<AskedReport>,
    /// Why the fit went on without it, if it did.
    pub trouble: Option<String>,
}

/// A view and what was asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AskedReport {
    /// Name of the view.
    pub view: String,
    /// The words.
    pub words: String,
}

/// Something that happened during the fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EventReport {
    /// When.
    pub iteration: usize,
    /// `reinit`, `refine`, …
    pub kind: String,
    /// How many control points it concerned.
    pub count: usize,
}

/// The `result` part: views, then the shape of the wire.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ResultReport {
    /// One entry a view.
    pub views: Vec<ViewReport>,
    /// Number of control points.
    pub control_points: usize,
    /// The wire's shape.
    #[serde(flatten)]
    pub shape: ShapeMetrics,
    /// Length of the wire over that of the middle lines of all targets, as bent; `None` without targets.
    #[serde(default)]
    pub length_over_lines: Option<f64>,
    /// How the wire covers a surface, where that was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceReport>,
}

/// How well one view matches its drawing, arranged but not bent. `null` where there is no drawing to compare with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ViewReport {
    /// Name of the view.
    pub name: String,
    /// Σ min / Σ max of rendering and target at the target's size.
    pub soft_iou: Option<f64>,
    /// Peak signal-to-noise ratio at the target's size.
    pub psnr_db: Option<f64>,
    /// Share of rendered ink within 2 px of target ink, at 256 px.
    pub precision_2px: Option<f64>,
    /// Share of target ink within 2 px of rendered ink, at 256 px.
    pub recall_2px: Option<f64>,
    /// Share of the target's ink that any object could show together with the other views.
    pub target_coverable: Option<f64>,
    /// The same against the bent target, where it was bent.
    pub bent: Option<BentReport>,
    /// By which factor the drawing was stretched to fit the box, 1 for not at all.
    pub stretch: f64,
    /// How alike rendering and target look, by yardstick ([`super::perceptual`]), at 256 px; a field each. Empty where
    /// there is no drawing to compare with.
    #[serde(flatten, deserialize_with = "numbers")]
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub perceptual: BTreeMap<String, f64>,
}

/// Only the fields that are numbers, so that a report with other fields can still be read.
fn numbers<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, f64>, D::Error> {
    Map::deserialize(deserializer).map(numbers_of)
}

fn numbers_of(fields: Map<String, Value>) -> BTreeMap<String, f64> {
    let mut numbers = BTreeMap::new();
    numbers.extend(fields.into_iter().filter_map(|(name, value)| Some((name, value.as_f64()?))));
    numbers
}

/// How well one view matches its bent drawing, and how far bending moved the ink.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct BentReport {
    /// As [`ViewReport::soft_iou`].
    pub soft_iou: f64,
    /// As [`ViewReport::precision_2px`].
    pub precision_2px: f64,
    /// As [`ViewReport::recall_2px`].
    pub recall_2px: f64,
    /// How far ink moved on average, pixels at 256.
    pub mean_px: f64,
    /// How far ink moved at most, pixels at 256.
    pub max_px: f64,
}

impl ResultReport {
    /// Measures a sculpture against `targets`, one a view in the views' order (`None` or missing: not compared).
    pub fn measure(sculpture: &Sculpture, targets: &[Option<Image>]) -> ResultReport {
        ResultReport::measure_with(sculpture, targets, |view, [width, height]| {
            render(&sculpture.wire, &sculpture.views[view].with_size(width, height))
        })
    }

    /// [`ResultReport::measure`] where a view, by its index, shows at some width and height what `draw` says.
    pub fn measure_with(
        sculpture: &Sculpture,
        targets: &[Option<Image>],
        draw: impl Fn(usize, [usize; 2]) -> Image,
    ) -> ResultReport {
        let views = sculpture.views.iter().enumerate().map(|(i, view)| {
            let target = targets.get(i).and_then(Option::as_ref);
            let found = target.map(|target| match_pictures(target, |width, height| draw(i, [width, height])));
            ViewReport::new(&view.name, found)
        });
        let views = views.collect();
        let shape = shape(&sculpture.wire, &sculpture.views);
        let drawn = targets.iter().zip(&sculpture.views).filter_map(|(target, view)| Some((target.as_ref()?, view)));
        ResultReport {
            views,
            control_points: sculpture.wire.control_points().len(),
            length_over_lines: length_over_lines(shape.length, drawn),
            shape,
            surface: None,
        }
    }
}

impl ViewReport {
    /// With the figures found; neither bent nor stretched.
    pub fn new(name: &str, found: Option<PictureMatch>) -> ViewReport {
        ViewReport {
            name: name.to_owned(),
            soft_iou: found.as_ref().map(|f| f.soft_iou),
            psnr_db: found.as_ref().map(|f| f.psnr_db),
            precision_2px: found.as_ref().map(|f| f.precision_2px),
            recall_2px: found.as_ref().map(|f| f.recall_2px),
            target_coverable: None,
            bent: None,
            stretch: 1.0,
            perceptual: found.map(|f| f.perceptual).unwrap_or_default(),
        }
    }
}

impl BentReport {
    /// From the figures against the bent target and the displacement, pixels at 256.
    pub fn new(found: PictureMatch, mean_px: f64, max_px: f64) -> BentReport {
        let PictureMatch { soft_iou, precision_2px, recall_2px, .. } = found;
        BentReport { soft_iou, precision_2px, recall_2px, mean_px, max_px }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yardsticks_are_fields_of_a_view_and_others_are_passed_over() {
        let found = match_pictures(&Image::new(64, 64), Image::new);
        let view = ViewReport::new("front", Some(found));
        let mut json = serde_json::to_value(&view).unwrap();
        for (name, best) in [("ms_ssim", 1.0), ("edge_distance_px", 0.0), ("tone_match", 1.0)] {
            assert_eq!(json[name], best, "{name}");
        }
        json["words"] = "of a later version".into();
        assert_eq!(serde_json::from_value::<ViewReport>(json).unwrap(), view);
        let alone = serde_json::to_value(ViewReport::new("front", None)).unwrap();
        assert!(alone["soft_iou"].is_null() && alone.get("ms_ssim").is_none());
    }
}
