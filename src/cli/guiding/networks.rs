//! `--guide`: networks that know words and pictures pull the views.

use super::words::{Wording, fitted};
use super::{named, trouble, vocabulary};
use clap::ArgMatches;
use std::path::PathBuf;
use wire4d::metrics::{GuidanceReport, WordsReport};
use wire4d::objective::{Aim, Learned, Look, Member, embedding, similarity};
use wire4d::optimize::wait;
use wire4d::sculpture::render;
use wire4d::tasks::Run;
use wire4d::view::Image;
use wire4d::{Error, Result};
use wire4d_guidance::{Dictionary, OnnxNetwork};

/// By this name the session knows them.
const NAME: &str = "--guide";

/// The networks of a run, and how they look.
pub struct Guiding {
    networks: Vec<(OnnxNetwork, Dictionary)>,
    neutral: Option<String>,
    /// Whether views beside the first are to be like what that one shows.
    like_picture: bool,
    look: Look,
    weight: f32,
}

impl Guiding {
    /// None without `--guide`.
    pub fn new(matches: &ArgMatches, wording: &Wording) -> Result<Option<Guiding>> {
        let files: Vec<&PathBuf> = matches.get_many("guide").into_iter().flatten().collect();
        if files.is_empty() {
            return Ok(None);
        }
        let weight = matches.get_one("guide-weight").copied().unwrap_or(0.0);
        if !(0.0..=1e6).contains(&weight) {
            let remedy = "give a number from 0 to 1000000";
            return Err(Error::setting("--guide-weight", format!("{weight} is no weight"), remedy));
        }
        let look = match matches.get_one::<String>("guide-look").map(String::as_str) {
            Some("whole") => Look::Whole,
            Some("patches") => Look::Grid { cells: 4 },
            _ => Look::WORDS,
        };
        let open = |file: &&PathBuf| {
            let network = OnnxNetwork::open(file)?;
            let (table, text) = vocabulary(matches, file)?;
            let dictionary = Dictionary::new(&network, table, text)?;
            Ok((network, dictionary))
        };
        let networks = files.iter().map(open).collect::<Result<Vec<_>>>()?;
        // Where views change there is no first picture of each; and only one task has a single picture.
        let neutral = matches.try_get_one::<String>("neutral").ok().flatten().cloned();
        let like_picture = matches.try_get_one::<bool>("like-picture").ok().flatten() == Some(&true);
        for (_, dictionary) in &networks {
            for words in wording.iter().chain(neutral.as_deref()) {
                dictionary.vector(words)?;
            }
        }
        Ok(Some(Guiding { networks, neutral, like_picture, look, weight }))
    }

    /// Has the networks guide `run`.
    pub fn guide(&self, run: &mut Run, wording: &Wording) -> Result<()> {
        let views = fitted(run);
        if self.like_picture && views.len() < 2 {
            let remedy = "give --side-views of 1 or more";
            return Err(Error::setting("--like-picture", "there is no side that could be like it", remedy));
        }
        let made = run.sculpture();
        let mut members = Vec::new();
        for (network, dictionary) in &self.networks {
            let neutral = self.neutral.as_ref().map(|words| dictionary.vector(words)).transpose()?;
            let aim = |(view, name): (usize, &&str)| {
                if self.is_like_picture(view, name, wording) {
                    return Ok(Some(Aim::LikePicture(run.targets()[0].ink.clone())));
                }
                let Some(words) = wording.of(name) else { return Ok(None) };
                let words = dictionary.vector(words)?;
                Ok(Some(match &neutral {
                    None => Aim::Like(words),
                    Some(neutral) => {
                        let first = render(&made.wire, &run.session().problem().targets[view].view);
                        Aim::between(neutral, &words, first)?
                    }
                }))
            };
            let aims = views.iter().enumerate().map(aim).collect::<Result<_>>()?;
            members.push(Member::new(Box::new(network.clone()), aims)?);
        }
        let learned = Learned::new(members, self.look, run.settings().seed);
        run.guide_by(NAME, self.weight, Box::new(learned));
        Ok(())
    }

    /// A side without words of its own follows the picture, where that is asked for.
    fn is_like_picture(&self, view: usize, name: &str, wording: &Wording) -> bool {
        self.like_picture && view > 0 && wording.own(name).is_none()
    }

    /// How like its words, or the picture, each of the report's views came out.
    pub fn report(&self, run: &Run, wording: &Wording) -> Result<GuidanceReport> {
        let trouble = trouble(run, NAME);
        // Where a network failed before it may fail again: that is in the report already.
        let mean = |cos: &dyn Fn(&OnnxNetwork, &Dictionary) -> Result<f32>| {
            let mut sum = 0.0;
            for (network, dictionary) in &self.networks {
                match cos(network, dictionary) {
                    Err(_) if trouble.is_some() => {}
                    found => sum += found?,
                }
            }
            Ok::<f32, Error>(sum / self.networks.len() as f32)
        };
        let made = run.sculpture();
        let (mut views, mut sides) = (Vec::new(), Vec::new());
        for (index, target) in run.targets().iter().enumerate() {
            let name = &target.view.name;
            let shown = run.draw(&made.wire, index);
            if self.is_like_picture(index, name, wording) {
                sides.push(mean(&|network, _| likeness(network, &shown, &run.targets()[0].ink))?);
            } else if let Some(words) = wording.of(name) {
                let cos = mean(&|network, dictionary| {
                    wait(similarity(&mut network.clone(), &shown, &dictionary.vector(words)?))
                })?;
                views.push(WordsReport { view: name.clone(), words: words.to_owned(), cos });
            }
        }
        let mean_of = |all: &[f32]| (!all.is_empty()).then(|| all.iter().sum::<f32>() / all.len() as f32);
        Ok(GuidanceReport {
            networks: self.networks.iter().map(|(network, _)| named(network.facts())).collect(),
            weight: self.weight,
            mean_cos: mean_of(&views.iter().map(|view| view.cos).collect::<Vec<_>>()),
            like_picture: mean_of(&sides),
            views,
            trouble,
        })
    }
}

/// The cosine between what a network sees in two pictures of ink.
fn likeness(network: &OnnxNetwork, shown: &Image, picture: &Image) -> Result<f32> {
    let mut network = network.clone();
    let seen = wait(embedding(&mut network, picture))?;
    wait(similarity(&mut network, shown, &seen))
}
