//! `wire4d multiview`: pictures in, a folder with the wire, its views and the report out.

use crate::guiding::{Guided, Guides};
use crate::likeness::Likeness;
use crate::making::{Making, made, save, save_picture};
use crate::{args, folder::Folder};
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use wire4d::metrics::{ReadingReport, Report};
use wire4d::picture::{GreyDepth, read_picture};
use wire4d::sculpture::Carried;
use wire4d::settings::{Settings, Task};
use wire4d::start::Coverable;
use wire4d::tasks::Run;
use wire4d::tasks::multiview::{self, Drawing};
use wire4d::view::{Image, ViewSpec, parse_placed_picture};
use wire4d::{Result, sculpture};

pub fn run(matches: &ArgMatches) -> Result<()> {
    let settings = args::settings(matches, Task::Multiview)?;
    let guides = Guides::new(matches)?;
    let likeness = Likeness::new(matches)?;
    let (drawings, reading): (Vec<_>, Vec<_>) = drawings(matches, &settings)?.into_iter().unzip();
    let out = args::path(matches, "out");
    let folder = Folder::claim(out, matches.get_flag("overwrite"))?;
    let making = Making::new(&folder, matches.get_flag("quiet"));
    let bar = &making.bar;
    bar.set_message("Arranging the drawings");
    making.say_how_read(&reading);
    let plan = multiview::plan_with(&drawings, &guides.views(!drawings.is_empty())?, &settings)?;
    for note in plan.notes() {
        making.say(&note);
    }
    if plan.coverable.iter().any(|view| view.share < 1.0) {
        bar.println("NAME-missing.png will show the lines that no object can show");
    }
    bar.set_message(match drawings.len() {
        0 => "Laying a first wire".into(),
        _ => format!("Finding a first wire ({:.0}% of the ink can be shown)", 100.0 * plan.mean_coverable()),
    });
    let coverable = plan.coverable.clone();
    let mut run = Run::start(plan, &mut |share| {
        bar.set_position((share * 100.0) as u64);
        !making.is_stopped()
    })?;
    let (time, Guided { guidance, distillation }) = making.fit(&mut run, &guides)?;
    let mut report = Report { reading, guidance, distillation, ..run.report(time, !run.session().is_done()) };
    likeness.iter().for_each(|likeness| likeness.measure(&mut report, &run));
    save(&folder, &made(&run, &report, Carried::default())?, &report, &run.loss_csv())?;
    save_pictures(&folder, &run, &coverable)?;
    bar.finish_and_clear();
    folder.finish()?;
    println!("{}", out.join("report.json").display());
    Ok(())
}

fn save_pictures(folder: &Folder, run: &Run, coverable: &[Coverable]) -> Result<()> {
    let made = run.sculpture();
    let bent = run.bent();
    for (index, target) in run.targets().iter().enumerate() {
        let name = &target.view.name;
        let save = |suffix: &str, picture: &Image, depth| save_picture(folder, name, suffix, picture, depth);
        save("", &sculpture::render(&made.wire, &target.view), GreyDepth::Bits16)?;
        let Some(coverable) = coverable.get(index) else { continue };
        save("-target", &target.ink, GreyDepth::Bits8)?;
        if coverable.share < 1.0 {
            save("-missing", &coverable.missing, GreyDepth::Bits8)?;
        }
        if let Some(bent) = &bent {
            save("-bent", &bent[index].0, GreyDepth::Bits8)?;
        }
    }
    Ok(())
}

/// The pictures as drawings: front, side and top first, then those with directions.
fn drawings(matches: &ArgMatches, settings: &Settings) -> Result<Vec<(Drawing, ReadingReport)>> {
    let pictures = matches.get_many::<PathBuf>("pictures").into_iter().flatten();
    let mut drawings = pictures.map(|path| drawing(path, None, settings)).collect::<Result<Vec<_>>>()?;
    for text in matches.get_many::<String>("view").into_iter().flatten() {
        let (path, spec) = parse_placed_picture(text)?;
        drawings.push(drawing(Path::new(&path), Some(spec), settings)?);
    }
    Ok(drawings)
}

fn drawing(path: &Path, direction: Option<ViewSpec>, settings: &Settings) -> Result<(Drawing, ReadingReport)> {
    let picture = read_picture(path)?;
    let (drawing, ground) = Drawing::new(&picture, direction, settings)?;
    let reading = ReadingReport::new(&picture, &drawing.ink, &ground);
    Ok((drawing, reading))
}
