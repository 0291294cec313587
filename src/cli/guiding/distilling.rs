//! `--denoise`: a diffusion model that knows words, or new views of a picture, pulls the views, by score distillation.

use super::words::{Wording, fitted};
use super::{named, trouble, vocabulary};
use clap::ArgMatches;
use std::path::PathBuf;
use wire4d::metrics::{AskedReport, DistillationReport};
use wire4d::objective::{Annealing, Denoiser, Distilled, Encoder, Look, Prompts};
use wire4d::tasks::Run;
use wire4d::{Error, Result};
use wire4d_guidance::{Contexts, OnnxDenoiser, OnnxEncoder, OnnxPoses};

/// By this name the session knows it.
const NAME: &str = "--denoise";
/// How much of the difference between words and none counts: the paper's for latents, and what trials of the small denoiser
/// took for pixels.
const SCALES: [f32; 2] = [100.0, 50.0];
/// The same for new views of a picture: the paper's.
const SCALE_OF_VIEWS: f32 = 3.0;

/// What a model is asked for.
enum Asked {
    /// Words.
    Words(Box<Contexts>),
    /// What the first view's picture shows, seen from where the others are.
    Views(OnnxPoses),
}

/// A diffusion model, and how it is asked.
pub struct Distilling {
    denoiser: OnnxDenoiser,
    encoder: Option<OnnxEncoder>,
    asked: Asked,
    annealing: Annealing,
    scale: f32,
    weight: f32,
}

impl Distilling {
    /// None without `--denoise`.
    pub fn new(matches: &ArgMatches, wording: &Wording) -> Result<Option<Distilling>> {
        let Some(file) = matches.get_one::<PathBuf>("denoise") else { return Ok(None) };
        let number = |name: &str| {
            let value = matches.get_one::<f32>(name).copied();
            match value.filter(|value| !(0.0..=1e6).contains(value)) {
                None => Ok(value),
                Some(odd) => {
                    let remedy = "give a number from 0 to 1000000";
                    Err(Error::setting(format!("--{name}"), format!("{odd} is out of range"), remedy))
                }
            }
        };
        let (scale, weight) = (number("denoise-scale")?, number("denoise-weight")?);
        let denoiser = OnnxDenoiser::open(file)?;
        let [channels, rows, columns] = denoiser.shape();
        let encoder = matches.get_one::<PathBuf>("encode").map(|file| OnnxEncoder::open(file)).transpose()?;
        match &encoder {
            None if rows != columns || ![1, 3].contains(&channels) => {
                let problem = format!("sees latents of {channels} x {rows} x {columns}, not pictures");
                return Err(Error::input(file.display().to_string(), problem, "give its encoder too, as --encode"));
            }
            Some(encoder) if encoder.latent() != denoiser.shape() => {
                let problem =
                    format!("makes latents of {:?}, and the model sees {:?}", encoder.latent(), denoiser.shape());
                return Err(Error::input(&encoder.facts().name, problem, "give the encoder of the same model"));
            }
            _ => {}
        }
        let contexts = matches.get_one::<PathBuf>("contexts");
        // Only one task has a single picture.
        let asked = match (matches.try_get_one::<PathBuf>("pose").ok().flatten(), contexts) {
            (Some(pose), _) => Asked::Views(OnnxPoses::open(pose, &denoiser)?),
            (None, Some(contexts)) => Asked::Words(Contexts::open(&denoiser, contexts)?.into()),
            (None, None) => {
                let (table, text) = vocabulary(matches, file)?;
                Asked::Words(Contexts::of_words(&denoiser, table, text)?.into())
            }
        };
        if let Asked::Words(contexts) = &asked {
            if wording.is_empty() {
                return Err(Error::setting(
                    "--denoise",
                    "is asked for nothing",
                    "give --words, or --pose for new views",
                ));
            }
            wording.iter().try_for_each(|words| contexts.prompt(words).map(|_| ()))?;
        }
        if matches!(asked, Asked::Views(_)) && encoder.is_none() {
            let problem = "sees latents, and nothing makes them";
            return Err(Error::input(file.display().to_string(), problem, "give its encoder too, as --encode"));
        }
        let annealing = match matches.get_one::<String>("denoise-times").map(String::as_str) {
            Some("dreamtime") => Annealing::DREAM_TIME,
            _ if encoder.is_none() => Annealing::OF_PIXELS,
            _ => Annealing::FALLING,
        };
        let usual = match asked {
            Asked::Words(_) => SCALES[usize::from(encoder.is_none())],
            Asked::Views(_) => SCALE_OF_VIEWS,
        };
        let scale = scale.unwrap_or(usual);
        Ok(Some(Distilling { denoiser, encoder, asked, annealing, scale, weight: weight.unwrap_or(0.0) }))
    }

    /// Has the model guide `run`.
    pub fn guide(&self, run: &mut Run, wording: &Wording) -> Result<()> {
        let prompts: Box<dyn Prompts> = match (&self.asked, &self.encoder) {
            (Asked::Words(contexts), _) => {
                let prompt = |view: &&str| wording.of(view).map(|words| contexts.prompt(words)).transpose();
                Box::new(fitted(run).iter().map(prompt).collect::<Result<Vec<_>>>()?)
            }
            (Asked::Views(poses), Some(encoder)) => {
                let front = &run.targets()[0];
                Box::new(poses.of(&front.ink, front.view.camera(), encoder)?)
            }
            (Asked::Views(_), None) => return Ok(()),
        };
        let distilled = Distilled {
            denoiser: Box::new(self.denoiser.clone()),
            encoder: self.encoder.clone().map(|encoder| Box::new(encoder) as Box<dyn Encoder>),
            diffusion: self.denoiser.diffusion().clone(),
            annealing: self.annealing,
            // Each look costs two runs of an encoder.
            look: if self.encoder.is_some() { Look::Whole } else { Look::WORDS },
            prompts,
            scale: self.scale,
            clamp: f32::INFINITY,
            seed: run.settings().seed,
        };
        run.guide_by(NAME, self.weight, Box::new(distilled));
        Ok(())
    }

    /// What was asked of which model. What came of it, only something else can tell.
    pub fn report(&self, run: &Run, wording: &Wording) -> DistillationReport {
        let asked = |view: &String| {
            let words = wording.of(view).filter(|_| matches!(self.asked, Asked::Words(_)))?;
            Some(AskedReport { view: view.clone(), words: words.to_owned() })
        };
        DistillationReport {
            denoiser: named(self.denoiser.facts()),
            encoder: self.encoder.as_ref().map(|encoder| named(encoder.facts())),
            pose: match &self.asked {
                Asked::Words(_) => None,
                Asked::Views(poses) => Some(named(poses.facts())),
            },
            weight: self.weight,
            scale: self.scale,
            times: if self.annealing == Annealing::DREAM_TIME { "dreamtime" } else { "falling" }.into(),
            views: run.targets().iter().filter_map(|target| asked(&target.view.name)).collect(),
            trouble: trouble(run, NAME),
        }
    }
}
