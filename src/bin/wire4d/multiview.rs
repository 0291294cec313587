//! `wire4d multiview`: pictures in, a folder with the wire, its views and the report out.

use crate::{args, folder::Folder};
use clap::ArgMatches;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;
use wire4d::export::{ExportOptions, Format, export};
use wire4d::metrics::{Report, TimeReport};
use wire4d::settings::Settings;
use wire4d::tasks::multiview::{self, Drawing, Run};
use wire4d::view::{GreyDepth, Image, ViewSpec, encode_png, parse_placed_picture, read_picture};
use wire4d::{Error, Result, sculpture};

/// Iterations between two looks at the clock and at Ctrl-C.
const SLICE: usize = 16;

pub fn run(matches: &ArgMatches) -> Result<()> {
    let settings = args::settings(matches)?;
    let drawings = drawings(matches, &settings)?;
    let out = args::path(matches, "out");
    let folder = Folder::claim(out, matches.get_flag("overwrite"))?;
    let stop = Arc::new(AtomicBool::new(false));
    let seen = Arc::clone(&stop);
    let partial = folder.partial().to_owned();
    // Ctrl-C stops the run and keeps what there is; a second one ends the program. Without a handler the first does.
    let _ = ctrlc::set_handler(move || {
        if seen.swap(true, Ordering::Relaxed) {
            let _ = std::fs::remove_dir_all(&partial);
            std::process::exit(130);
        }
    });
    let quiet = matches.get_flag("quiet");
    let bar = progress_bar(quiet);
    // Also where no bar is drawn: in a script or a log.
    let say = |note: &str| {
        if bar.is_hidden() && !quiet {
            eprintln!("{note}");
        }
        bar.println(note);
    };

    let begin = Instant::now();
    bar.set_message("Arranging the drawings");
    let plan = multiview::plan(&drawings, &settings)?;
    for note in plan.notes() {
        say(&note);
    }
    if plan.coverable.iter().any(|view| view.share < 1.0) {
        bar.println("NAME-missing.png will show the lines that no object can show");
    }
    bar.set_message(format!("Finding a first wire ({:.0}% of the ink can be shown)", 100.0 * plan.mean_coverable()));
    let mut run = Run::start(plan, &settings, &mut |share| {
        bar.set_position((share * 100.0) as u64);
        !stop.load(Ordering::Relaxed)
    })?;
    let start_s = begin.elapsed().as_secs_f64();

    bar.set_length(run.session().total() as u64);
    bar.set_message("Fitting");
    while !run.session().is_done() && !stop.load(Ordering::Relaxed) {
        run.step(SLICE);
        bar.set_position(run.session().iteration() as u64);
    }
    if let Some(trouble) = run.session().engine_trouble() {
        say(&format!("went on on the processor: {trouble}"));
    }
    bar.set_message("Measuring");
    let total_s = begin.elapsed().as_secs_f64();
    let (optimize_s, iterations) = (total_s - start_s, run.session().iteration());
    let ms_per_iteration = 1000.0 * optimize_s / iterations.max(1) as f64;
    let time = TimeReport { total_s, start_s, optimize_s, iterations, ms_per_iteration };
    let report = run.report(time, !run.session().is_done());
    save(&folder, &run, &report)?;
    bar.finish_and_clear();
    folder.finish()?;
    println!("{}", out.join("report.json").display());
    Ok(())
}

fn save(folder: &Folder, run: &Run, report: &Report) -> Result<()> {
    let made = run.sculpture();
    folder.write("wire.json", made.to_json().as_bytes())?;
    folder.write("wire.glb", &export(&made, Format::Glb, None, &ExportOptions::default())?)?;
    folder.write("loss.csv", run.loss_csv().as_bytes())?;
    let bent = run.bent();
    for (index, target) in run.plan().arrangement.targets.iter().enumerate() {
        let name = &target.view.name;
        let save = |suffix: &str, picture: &Image, depth| {
            let file = format!("{name}{suffix}.png");
            folder.write(&file, &encode_png(&file, picture, depth)?)
        };
        save("", &sculpture::render(&made.wire, &target.view), GreyDepth::Bits16)?;
        save("-target", &target.ink, GreyDepth::Bits8)?;
        let coverable = &run.plan().coverable[index];
        if coverable.share < 1.0 {
            save("-missing", &coverable.missing, GreyDepth::Bits8)?;
        }
        if let Some(bent) = &bent {
            save("-bent", &bent[index].0, GreyDepth::Bits8)?;
        }
    }
    let text = serde_json::to_string_pretty(report)
        .map_err(|error| Error::output("report.json", error.to_string(), "report this, it should not happen"))?;
    folder.write("report.json", text.as_bytes())
}

/// The pictures as drawings: front, side and top first, then those with directions.
fn drawings(matches: &ArgMatches, settings: &Settings) -> Result<Vec<Drawing>> {
    let pictures = matches.get_many::<PathBuf>("pictures").into_iter().flatten();
    let mut drawings = pictures.map(|path| drawing(path, None, settings)).collect::<Result<Vec<_>>>()?;
    for text in matches.get_many::<String>("view").into_iter().flatten() {
        let (path, spec) = parse_placed_picture(text)?;
        drawings.push(drawing(Path::new(&path), Some(spec), settings)?);
    }
    Ok(drawings)
}

fn drawing(path: &Path, direction: Option<ViewSpec>, settings: &Settings) -> Result<Drawing> {
    let picture = read_picture(path)?;
    if let Some([width, height]) = picture.shrunk_from() {
        eprintln!("{}: {width} x {height} px is more than is needed, scaled down", path.display());
    }
    Drawing::new(&picture, direction, settings)
}

fn progress_bar(quiet: bool) -> ProgressBar {
    // Indicatif draws on standard error and only if it is a terminal.
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(100) };
    if let Ok(style) = ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} {eta}") {
        bar.set_style(style);
    }
    bar
}
