//! What all verbs that make something share: Ctrl-C, the progress bar, the clock, and the folder's common files.

use crate::folder::Folder;
use crate::guiding::{Guided, Guides};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use wire4d::export::{ExportOptions, Format, export};
use wire4d::metrics::{ReadingReport, Report, TimeReport};
use wire4d::picture::{GreyDepth, encode_png};
use wire4d::sculpture::{Carried, MAX_DRAWING_PX, MAX_DRAWINGS, Sculpture, Silhouette};
use wire4d::tasks::Run;
use wire4d::view::Image;
use wire4d::{Error, Result};

/// Iterations between two looks at the clock and at Ctrl-C.
const SLICE: usize = 16;

/// A verb at work.
pub struct Making {
    pub bar: ProgressBar,
    quiet: bool,
    stop: Arc<AtomicBool>,
    begin: Instant,
}

impl Making {
    /// Ctrl-C stops the run and keeps what there is; a second one ends the program. Without a handler the first does.
    pub fn new(folder: &Folder, quiet: bool) -> Making {
        let partial = folder.partial().to_owned();
        let stop = stop_by_hand(move || drop(std::fs::remove_dir_all(&partial)));
        Making { bar: progress_bar(quiet), quiet, stop, begin: Instant::now() }
    }

    /// Says something also where no bar is drawn: in a script or a log.
    pub fn say(&self, note: &str) {
        if self.bar.is_hidden() && !self.quiet {
            eprintln!("{note}");
        }
        self.bar.println(note);
    }

    /// Says what was done to pictures, and what of them was left out.
    pub fn say_how_read(&self, reading: &[ReadingReport]) {
        for picture in reading {
            picture.notes.iter().for_each(|note| self.say(note));
            if picture.because.contains("left out") {
                self.say(&format!("{}: {}", picture.source, picture.because));
            }
        }
    }

    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Fits to the end, or until somebody stops it, and says where the time went and what came of what guides.
    pub fn fit(&self, run: &mut Run, guides: &Guides) -> Result<(TimeReport, Guided)> {
        guides.guide(run)?;
        let start_s = self.begin.elapsed().as_secs_f64();
        self.bar.set_length(run.session().total() as u64);
        self.bar.set_message("Fitting");
        while !run.session().is_done() && !self.is_stopped() {
            run.step(SLICE)?;
            self.bar.set_position(run.session().iteration() as u64);
        }
        if let Some(trouble) = run.session().engine_trouble() {
            self.say(&format!("went on on the processor: {trouble}"));
        }
        self.bar.set_message("Measuring");
        let total_s = self.begin.elapsed().as_secs_f64();
        let (optimize_s, iterations) = (total_s - start_s, run.session().iteration());
        let ms_per_iteration = 1000.0 * optimize_s / iterations.max(1) as f64;
        let time = TimeReport { total_s, start_s, optimize_s, iterations, ms_per_iteration };
        let guided = guides.report(run)?;
        for trouble in guided.troubles() {
            self.say(&format!("went on without what was to guide: {trouble}"));
        }
        Ok((time, guided))
    }
}

/// Is set by Ctrl-C; a second one ends the program after `clean`. Without a handler the first does.
pub fn stop_by_hand(clean: impl Fn() + Send + 'static) -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&stop);
    let _ = ctrlc::set_handler(move || {
        if seen.swap(true, Ordering::Relaxed) {
            clean();
            std::process::exit(130);
        }
    });
    stop
}

/// The best wire of a run with how it was found and what it was made of: the arranged pictures, and what else was `given`.
pub fn made(run: &Run, report: &Report, given: Carried) -> Result<Sculpture> {
    let mut carried = Carried { replay: run.replay(), ..given };
    for target in run.targets().iter().take(MAX_DRAWINGS) {
        let view = &target.view.name;
        if let Some(placed) = report.arrangement.iter().find(|placed| &placed.view == view) {
            carried.drawings.push(silhouette(view, &placed.source, &target.ink)?);
        }
    }
    Ok(Sculpture { carried, ..run.sculpture() })
}

/// Characters of what a person calls a picture.
const MOST_OF_A_NAME: usize = 60;
/// Steps between black and white in what a file carries of a drawing: more would only make files larger.
const SHADES: f32 = 15.0;

/// A picture as a wire's file carries it: its ink black on white, at most [`MAX_DRAWING_PX`] a side.
pub fn silhouette(view: &str, name: &str, ink: &Image) -> Result<Silhouette> {
    let shrink = ink.width.max(ink.height).div_ceil(MAX_DRAWING_PX as usize).max(1);
    let (width, height) = (ink.width.div_ceil(shrink), ink.height.div_ceil(shrink));
    let level = |i: usize| {
        let (columns, rows) = ((i % width) * shrink, (i / width) * shrink);
        let (right, bottom) = ((columns + shrink).min(ink.width), (rows + shrink).min(ink.height));
        let sum: f32 =
            (rows..bottom).map(|y| ink.data[y * ink.width + columns..y * ink.width + right].iter().sum::<f32>()).sum();
        let share = 1.0 - sum / ((right - columns) * (bottom - rows)) as f32;
        (share * SHADES).round() / SHADES
    };
    let shades = Image { width, height, data: (0..width * height).map(level).collect() };
    let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
    let label = stem.chars().take(MOST_OF_A_NAME).collect();
    Ok(Silhouette { view: view.to_owned(), label, png: encode_png(name, &shades, GreyDepth::Bits8)? })
}

/// The files of every run but its pictures.
pub fn save(folder: &Folder, made: &Sculpture, report: &Report, loss_csv: &str) -> Result<()> {
    folder.write("wire.json", made.to_json().as_bytes())?;
    folder.write("wire.glb", &export(made, Format::Glb, None, None, &ExportOptions::default())?)?;
    folder.write("loss.csv", loss_csv.as_bytes())?;
    let text = serde_json::to_string_pretty(report)
        .map_err(|error| Error::output("report.json", error.to_string(), "report this, it should not happen"))?;
    folder.write("report.json", text.as_bytes())
}

/// A picture of a view, `NAMESUFFIX.png`.
pub fn save_picture(folder: &Folder, name: &str, suffix: &str, picture: &Image, depth: GreyDepth) -> Result<()> {
    let file = format!("{name}{suffix}.png");
    folder.write(&file, &encode_png(&file, picture, depth)?)
}

pub fn progress_bar(quiet: bool) -> ProgressBar {
    // Indicatif draws on standard error and only if it is a terminal.
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(100) };
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}") {
        bar.set_style(style);
    }
    bar
}
