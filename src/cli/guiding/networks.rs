//! Networks that guide a run: what `--guide` and its like say, and what comes of it.

use crate::making::Making;
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use wire4d::metrics::{GuidanceReport, NetworkReport, WordsReport};
use wire4d::objective::{Aim, Learned, Look, Member, similarity};
use wire4d::optimize::wait;
use wire4d::tasks::Run;
use wire4d::{Error, Result};
use wire4d_guidance::{Dictionary, OnnxNetwork, TextEncoder, WordTable};

/// By this name the session knows them.
const NAME: &str = "--guide";

/// The networks of a run, and what each view is to show.
pub struct Guiding {
    networks: Vec<(OnnxNetwork, Dictionary)>,
    words: Vec<Words>,
    neutral: Option<String>,
    look: Look,
    weight: f32,
}

/// `--words`.
struct Words {
    /// The only view that they are for; all without.
    view: Option<String>,
    words: String,
}

impl Guiding {
    /// Opens all files and looks all words up: what is wrong with them shows before anything is made. None without networks.
    pub fn new(matches: &ArgMatches) -> Result<Option<Guiding>> {
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
        let table = matches.get_one::<PathBuf>("word-table").map(PathBuf::as_path);
        let text = matches.get_one::<PathBuf>("text").map(PathBuf::as_path);
        let networks = files.iter().map(|file| open(file, table, text)).collect::<Result<Vec<_>>>()?;
        let words = matches.get_many::<String>("words").into_iter().flatten().map(|text| Words::new(text)).collect();
        // Where views change there is no first picture of each.
        let neutral = matches.try_get_one::<String>("neutral").ok().flatten().cloned();
        let guiding = Guiding { networks, words, neutral, look, weight };
        for (_, dictionary) in &guiding.networks {
            for words in guiding.words.iter().map(|words| &words.words).chain(&guiding.neutral) {
                dictionary.vector(words)?;
            }
        }
        Ok(Some(guiding))
    }

    /// Has the networks guide `run`, which is at its beginning.
    ///
    /// # Errors
    /// [`Error::Setting`] for words of a view that is not there.
    pub fn guide(&self, run: &mut Run) -> Result<()> {
        let targets = &run.session().problem().targets;
        let names: Vec<&str> = targets.iter().map(|target| target.view.name.as_str()).collect();
        let stray = self.words.iter().filter_map(|words| words.view.as_deref()).find(|view| !names.contains(view));
        if let Some(stray) = stray {
            let problem = format!("there is no view {stray:?}");
            return Err(Error::setting("--words", problem, format!("its views are {}", names.join(", "))));
        }
        let made = run.sculpture();
        let mut members = Vec::new();
        for (network, dictionary) in &self.networks {
            let neutral = self.neutral.as_ref().map(|words| dictionary.vector(words)).transpose()?;
            let aim = |(view, name): (usize, &&str)| {
                let Some(words) = self.words(name) else { return Ok(None) };
                let words = dictionary.vector(words)?;
                Ok(Some(match &neutral {
                    None => Aim::Like(words),
                    Some(neutral) => Aim::between(neutral, &words, first_look(run, &made.wire, view))?,
                }))
            };
            let aims = names.iter().enumerate().map(aim).collect::<Result<_>>()?;
            members.push(Member::new(Box::new(network.clone()), aims)?);
        }
        let learned = Learned::new(members, self.look, run.settings().seed);
        run.guide_by(NAME, self.weight, Box::new(learned));
        Ok(())
    }

    /// How like its words each of the report's views came out. Says so where the run went on without the networks.
    pub fn report(&self, run: &Run, making: &Making) -> Result<GuidanceReport> {
        let trouble = run.session().guidance_troubles().into_iter().find(|(name, _)| name == NAME);
        let trouble = trouble.map(|(_, error)| error.to_string());
        if let Some(trouble) = &trouble {
            making.say(&format!("went on without what was to guide: {trouble}"));
        }
        let made = run.sculpture();
        let mut views = Vec::new();
        for (index, target) in run.targets().iter().enumerate() {
            let Some(words) = self.words(&target.view.name) else { continue };
            let picture = run.draw(&made.wire, index);
            let mut cos = 0.0;
            for (network, dictionary) in &self.networks {
                let vector = dictionary.vector(words)?;
                // Where it failed before it may fail again: that is in the report already.
                match wait(similarity(&mut network.clone(), &picture, &vector)) {
                    Err(_) if trouble.is_some() => {}
                    found => cos += found? / self.networks.len() as f32,
                }
            }
            views.push(WordsReport { view: target.view.name.clone(), words: words.to_owned(), cos });
        }
        let networks = self.networks.iter().map(|(network, _)| {
            let facts = network.facts().clone();
            NetworkReport { name: facts.name, origin: facts.origin, licence: facts.licence, sha256: facts.sha256 }
        });
        let mean_cos = views.iter().map(|view| view.cos).sum::<f32>() / views.len().max(1) as f32;
        Ok(GuidanceReport { networks: networks.collect(), weight: self.weight, views, mean_cos, trouble })
    }

    /// What a view is to show: its own words before those of all.
    fn words(&self, view: &str) -> Option<&str> {
        let own = self.words.iter().rev().find(|words| words.view.as_deref() == Some(view));
        let common = || self.words.iter().rev().find(|words| words.view.is_none());
        own.or_else(common).map(|words| words.words.as_str())
    }
}

impl Words {
    fn new(text: &str) -> Words {
        match text.split_once('=') {
            Some((view, words)) => Words { view: Some(view.trim().to_owned()), words: words.trim().to_owned() },
            None => Words { view: None, words: text.trim().to_owned() },
        }
    }
}

/// A network with all that knows words for it.
fn open(file: &Path, table: Option<&Path>, text: Option<&Path>) -> Result<(OnnxNetwork, Dictionary)> {
    let network = OnnxNetwork::open(file)?;
    let beside = file.with_file_name("words.json");
    let table = table.or_else(|| beside.is_file().then_some(beside.as_path()));
    let table = table.map(WordTable::open).transpose()?;
    let text = text.map(TextEncoder::open).transpose()?;
    let dictionary = Dictionary::new(&network, table, text)?;
    Ok((network, dictionary))
}

/// What a view of the fit shows of the first wire.
fn first_look(run: &Run, wire: &wire4d::wire::Wire, view: usize) -> wire4d::view::Image {
    wire4d::sculpture::render(wire, &run.session().problem().targets[view].view)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_views_own_words_come_before_those_of_all() {
        let words = ["a cat", "side = a dog", "front=a=b"].map(Words::new).into();
        let guiding = Guiding { networks: Vec::new(), words, neutral: None, look: Look::Whole, weight: 1.0 };
        let found = ["front", "side", "top"].map(|view| guiding.words(view));
        assert_eq!(found, [Some("a=b"), Some("a dog"), Some("a cat")]);
    }
}
