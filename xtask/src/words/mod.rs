//! `cargo xtask words`: wires that words pull, nothing drawn, and what another network takes them for.

mod judge;
mod sheet;

use crate::shell::{command, root, run as run_command, say};
use crate::{Result, elegance};
use judge::Judge;
use serde_json::Value;
use sheet::Sheet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Stdio;

/// For the list of verbs.
pub const HELP: &str =
    "pulls wires by words and ranks what they show: twenty from the front, or `three` words from three sides";

/// Where the networks lie.
const WEIGHTS: &str = "tools/iconnet/weights";
/// Words for one view: strands as wide as the lines that the networks know.
const ONE: &[&str] =
    &["--size=128", "--iterations=200", "--guide-weight=0.6", "--width=constant", "--min-width=5", "--max-width=5"];
/// For three views as the paper: points spread in a ball, those that vanish start again, and the wire is refined; kept smooth.
const THREE: &[&str] = &[
    "--size=128",
    "--iterations=300",
    "--guide-weight=0.6",
    "--start=ball",
    "--control-points=100",
    "--min-width=0",
    "--max-width=6",
    "--reinit",
    "--refine",
    "--new-point=random",
];
/// Wires of three words, for front, side and top.
const TRIPLES: [[&str; 3]; 3] =
    [["deciduous tree", "money bag", "ufo"], ["telephone", "water pistol", "baby"], ["fish", "cat", "umbrella"]];
const VIEWS: [&str; 3] = ["front", "side", "top"];
/// Where wires of three words are also seen from, azimuth and elevation in degrees.
const TURNED: [&str; 2] = ["35,15", "60,15"];

struct Options {
    three: bool,
    denoise: Option<String>,
    alone: bool,
    only: Vec<String>,
    extra: Vec<String>,
}

/// One wire's run.
struct Made {
    out: PathBuf,
    /// A word a view.
    words: Vec<String>,
    report: Value,
}

/// Options: `three`; `--denoise FILE` has a diffusion model guide too, and `--alone` it alone; `--only WORD` (repeatable; three of them
/// with `three`); after `--` anything for `wire4d multiview`. With `--only` or anything after `--` sheet and table go into out/words.
pub fn run(arguments: &[String]) -> Result {
    let options = Options::read(arguments)?;
    run_command(command("cargo").args(["build", "--release", "--bin", "wire4d"]))?;
    run_command(command("cargo").args(["build", "-p", "wire4d-guidance", "--example", "embed"]))?;
    let judge = Judge::open(&root().join(WEIGHTS))?;
    let wanted = options.wanted(&judge)?;
    let mut table = format!(
        "| word | view | rank of {} | cosine | the judge's first | s |{}\n|---|---|---|---|---|---|{}\n",
        judge.count(),
        elegance::headings(),
        elegance::rule()
    );
    let (mut ranks, mut sheet) = (Vec::new(), Sheet::default());
    for words in wanted {
        let made = Made::run(words, &options)?;
        let pictures = made.pictures()?;
        for (view, (word, seen)) in made.words.iter().zip(judge.see(&pictures[..made.words.len()])?).enumerate() {
            let (rank, first) = judge.rank(&seen, word)?;
            let line = made.line(view, rank, &first);
            say(&line);
            writeln!(table, "{line}")?;
            ranks.push(rank);
        }
        sheet.add(&pictures)?;
    }
    writeln!(table, "\n{}", summary(&mut ranks))?;
    println!("{table}");
    let path = options.path();
    std::fs::create_dir_all(path.parent().unwrap_or(&path))?;
    std::fs::write(path.with_extension("md"), &table)?;
    sheet.save(&path, if options.three { 1 } else { 5 })?;
    say(format!("the sheet is {}", path.display()));
    Ok(())
}

/// How many ranks are good, and the middle one.
fn summary(ranks: &mut [usize]) -> String {
    ranks.sort_unstable();
    let within = |most: usize| ranks.iter().filter(|&&rank| rank <= most).count();
    let middle = ranks.get(ranks.len() / 2).copied().unwrap_or(0);
    let count = ranks.len();
    format!("rank <= 10: {}, <= 50: {}, <= 100: {} of {count}; middle {middle}", within(10), within(50), within(100))
}

impl Options {
    fn read(arguments: &[String]) -> Result<Options> {
        let mut options = Options { three: false, denoise: None, alone: false, only: Vec::new(), extra: Vec::new() };
        let mut rest = arguments.iter();
        while let Some(argument) = rest.next() {
            let mut value = || rest.next().cloned().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                "three" => options.three = true,
                "--alone" => options.alone = true,
                "--denoise" => options.denoise = Some(value()?),
                "--only" => options.only.push(value()?),
                "--" => options.extra.extend(rest.by_ref().cloned()),
                other => return Err(format!("unknown option {other}").into()),
            }
        }
        match options.alone && options.denoise.is_none() {
            true => Err("--alone needs a --denoise FILE".into()),
            false => Ok(options),
        }
    }

    /// The words of each wire.
    fn wanted(&self, judge: &Judge) -> Result<Vec<Vec<String>>> {
        let own = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
        Ok(match (self.three, &self.only[..]) {
            (true, []) => TRIPLES.iter().map(|words| own(words)).collect(),
            (true, [front, side, top]) => vec![own(&[front, side, top])],
            (true, _) => return Err("say three words, for front, side and top".into()),
            (false, []) => judge.asked().iter().map(|word| vec![word.clone()]).collect(),
            (false, only) => only.iter().map(|word| vec![word.clone()]).collect(),
        })
    }

    /// Where the sheet goes: into docs/gallery only if it is of what it says.
    fn path(&self) -> PathBuf {
        let whole = self.only.is_empty() && self.extra.is_empty();
        root().join(if whole { "docs/gallery" } else { "out/words" }).join(format!("{}.png", self.name()))
    }

    /// What sheet and folders are called.
    fn name(&self) -> String {
        let sides = if self.three { "-three" } else { "" };
        let by = match (&self.denoise, self.alone) {
            (None, _) => "",
            (Some(_), false) => "-denoised",
            (Some(_), true) => "-denoised-alone",
        };
        format!("word-wires{sides}{by}")
    }
}

impl Made {
    fn run(words: Vec<String>, options: &Options) -> Result<Made> {
        let out = root().join("out/words").join(options.name()).join(words.join("+").replace(' ', "-"));
        // Nothing that an earlier run left may be taken for this one's.
        let _ = std::fs::remove_dir_all(&out);
        std::fs::create_dir_all(out.parent().unwrap_or(&out))?;
        let mut wire4d = command("target/release/wire4d");
        wire4d.arg("multiview");
        let networks: &[&str] = if options.alone { &[] } else { &["iconnet-a.onnx", "iconnet-b.onnx"] };
        for network in networks {
            wire4d.arg("--guide").arg(root().join(WEIGHTS).join(network));
        }
        if let Some(file) = &options.denoise {
            wire4d.arg("--denoise").arg(file).arg("--word-table").arg(root().join(WEIGHTS).join("words.json"));
        }
        for (view, word) in VIEWS.iter().zip(&words) {
            wire4d.arg("--words").arg(format!("{view}={word}"));
        }
        wire4d.args(if options.three { THREE } else { ONE }).args(&options.extra);
        wire4d.args(["--backend", "cpu", "--quiet", "--out"]).arg(&out);
        run_command(wire4d.stdout(Stdio::null()))?;
        let report = serde_json::from_slice(&std::fs::read(out.join("report.json"))?)?;
        Ok(Made { out, words, report })
    }

    /// What it shows from its own views, then from others.
    fn pictures(&self) -> Result<Vec<PathBuf>> {
        let mut pictures: Vec<PathBuf> =
            VIEWS.iter().take(self.words.len()).map(|view| self.out.join(format!("{view}.png"))).collect();
        if self.words.len() > 1 {
            for view in TURNED {
                pictures.push(rendered(&self.out, view)?);
            }
        }
        Ok(pictures)
    }

    fn line(&self, view: usize, rank: usize, first: &str) -> String {
        let cos =
            self.report["guidance"]["views"][view]["cos"].as_f64().map_or("–".into(), |cos| format!("{cos:.2}"));
        let (word, side) = (&self.words[view], VIEWS[view]);
        let seconds = self.report["time"]["total_s"].as_f64().unwrap_or(f64::NAN);
        let figures = elegance::cells(&[&elegance::Figures::of(&self.report, &self.out)]);
        format!("| {word} | {side} | {rank} | {cos} | {first} | {seconds:.1} |{figures}")
    }
}

/// The picture of a folder's wire from another side.
fn rendered(out: &Path, view: &str) -> Result<PathBuf> {
    let path = out.join(format!("{view}.png"));
    let mut wire4d = command("target/release/wire4d");
    wire4d.arg("render").arg(out.join("wire.json")).args(["--view", view, "--size", "128", "--out"]).arg(&path);
    run_command(wire4d.stdout(Stdio::null()))?;
    Ok(path)
}
