//! What guides a run: what `--guide`, `--denoise` and their like say, and what comes of it.

mod distilling;
mod networks;
mod words;

use clap::ArgMatches;
use distilling::Distilling;
use networks::Guiding;
use std::path::{Path, PathBuf};
use wire4d::Result;
use wire4d::metrics::{DistillationReport, GuidanceReport, NetworkReport};
use wire4d::tasks::Run;
use wire4d::view::ViewSpec;
use wire4d_guidance::{Facts, TextEncoder, WordTable};
use words::Wording;

/// All that guides a run; nothing at all in most.
pub struct Guides {
    wording: Wording,
    guiding: Option<Guiding>,
    distilling: Option<Distilling>,
}

/// What came of it.
#[derive(Default)]
pub struct Guided {
    pub guidance: Option<GuidanceReport>,
    pub distillation: Option<DistillationReport>,
}

impl Guides {
    /// Opens all files and looks all words up: what is wrong with them shows before anything is made.
    pub fn new(matches: &ArgMatches) -> Result<Guides> {
        let wording = Wording::new(matches.get_many::<String>("words").into_iter().flatten());
        let guiding = Guiding::new(matches, &wording)?;
        Ok(Guides { guiding, distilling: Distilling::new(matches, &wording)?, wording })
    }

    /// The views that words name, whether they have a picture or not; the front where they name none and there is no picture.
    pub fn views(&self, has_pictures: bool) -> Result<Vec<ViewSpec>> {
        match &self.wording.views()[..] {
            [] if !has_pictures && !self.wording.is_empty() => Ok(vec![ViewSpec::Named("front".into())]),
            names => names.iter().map(|name| name.parse()).collect(),
        }
    }

    /// Has it guide `run`, which is at its beginning.
    ///
    /// # Errors
    /// [`wire4d::Error::Setting`] for words of a view that is not there.
    pub fn guide(&self, run: &mut Run) -> Result<()> {
        self.wording.check(run)?;
        self.guiding.iter().try_for_each(|guiding| guiding.guide(run, &self.wording))?;
        self.distilling.iter().try_for_each(|distilling| distilling.guide(run, &self.wording))
    }

    /// What came of it.
    pub fn report(&self, run: &Run) -> Result<Guided> {
        let guidance = self.guiding.as_ref().map(|guiding| guiding.report(run, &self.wording)).transpose()?;
        let distillation = self.distilling.as_ref().map(|distilling| distilling.report(run, &self.wording));
        Ok(Guided { guidance, distillation })
    }
}

impl Guided {
    /// Why the run went on without some of it.
    pub fn troubles(&self) -> impl Iterator<Item = &String> {
        let guidance = self.guidance.iter().filter_map(|report| report.trouble.as_ref());
        guidance.chain(self.distillation.iter().filter_map(|report| report.trouble.as_ref()))
    }
}

/// Why what a session knows by this name no longer guides, if so.
fn trouble(run: &Run, name: &str) -> Option<String> {
    let troubles = run.session().guidance_troubles();
    troubles.into_iter().find(|(named, _)| named == name).map(|(_, error)| error.to_string())
}

/// What a report says of a network.
fn named(facts: &Facts) -> NetworkReport {
    let Facts { name, origin, licence, sha256 } = facts.clone();
    NetworkReport { name, origin, licence, sha256 }
}

/// What else knows words for the network of `file`: `--word-table`, or the table beside it, and `--text`.
fn vocabulary(matches: &ArgMatches, file: &Path) -> Result<(Option<WordTable>, Option<TextEncoder>)> {
    let given = |name: &str| matches.get_one::<PathBuf>(name).cloned();
    let beside = || Some(file.with_file_name("words.json")).filter(|path| path.is_file());
    let table = given("word-table").or_else(beside).map(|path| WordTable::open(&path)).transpose()?;
    Ok((table, given("text").map(|path| TextEncoder::open(&path)).transpose()?))
}
