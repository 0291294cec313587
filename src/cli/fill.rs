//! `wire4d fill`: a mesh in, a folder with the wire that covers it, its views and the report out.

use crate::guiding::{Guided, Guides};
use crate::likeness::Likeness;
use crate::making::{Making, made, save, save_picture, silhouette};
use crate::{args, folder::Folder};
use clap::ArgMatches;
use std::path::Path;
use wire4d::files::read_at_most;
use wire4d::mesh::Shape;
use wire4d::metrics::{ReadingReport, Report};
use wire4d::model::{MAX_MESH_BYTES, Mended, Up, read_mesh};
use wire4d::picture::{GreyDepth, Pattern, Polarity, ink, read_picture};
use wire4d::sculpture::Carried;
use wire4d::settings::Task;
use wire4d::tasks::Run;
use wire4d::tasks::fill::{self, Given, Style};
use wire4d::{Error, Result};

pub fn run(matches: &ArgMatches) -> Result<()> {
    let settings = args::settings(matches, Task::Fill)?;
    let guides = Guides::new(matches)?;
    let likeness = Likeness::new(matches)?;
    let (given, reading) = given(matches)?;
    let carried = carried(matches, &given)?;
    let out = args::path(matches, "out");
    let folder = Folder::claim(out, matches.get_flag("overwrite"))?;
    let making = Making::new(&folder, matches.get_flag("quiet"));
    making.bar.set_message("Covering the surface");
    making.say_how_read(&reading);
    let plan = fill::plan(&given, &settings, &mut |share| {
        making.bar.set_position((100.0 * share) as u64);
        !making.is_stopped()
    })?;
    let Some(plan) = plan else { return Err(Error::output(out.display().to_string(), "stopped", "run it again")) };
    plan.notes().iter().for_each(|note| making.say(note));
    let mut run = Run::start(plan, &mut |_| true)?;
    let (time, Guided { guidance, distillation }) = making.fit(&mut run, &guides)?;
    let mut report = Report { reading, guidance, distillation, ..run.report(time, !run.session().is_done()) };
    likeness.iter().for_each(|likeness| likeness.measure(&mut report, &run));

    let made = made(&run, &report, carried)?;
    save(&folder, &made, &report, &run.loss_csv())?;
    for (index, target) in run.targets().iter().enumerate() {
        let name = &target.view.name;
        save_picture(&folder, name, "", &run.draw(&made.wire, index), GreyDepth::Bits16)?;
        save_picture(&folder, name, "-target", &target.ink, GreyDepth::Bits8)?;
    }
    making.bar.finish_and_clear();
    folder.finish()?;
    println!("{}", out.join("report.json").display());
    Ok(())
}

fn given(matches: &ArgMatches) -> Result<(Given, Vec<ReadingReport>)> {
    let mut given = solid(args::path(matches, "mesh"), args::up(matches))?;
    let style = matches.get_one::<std::path::PathBuf>("style").map(|path| style(path)).transpose()?;
    let (style, reading) = style.unzip();
    given.style = style;
    Ok((given, reading.flatten().into_iter().collect()))
}

/// What names the shape and the style where they are built in; a style's picture goes along as it is.
fn carried(matches: &ArgMatches, given: &Given) -> Result<Carried> {
    let mut carried = Carried::default();
    let shape = args::path(matches, "mesh");
    if let Some(shape) = Shape::named(&shape.to_string_lossy()).filter(|_| !shape.exists()) {
        carried.given.insert("shape".into(), shape.name().into());
    }
    match &given.style {
        Some(Style { name, tiles: true, .. }) => _ = carried.given.insert("style".into(), name.clone()),
        Some(Style { name, ink, .. }) => carried.drawings.push(silhouette("style", name, ink)?),
        None => {}
    }
    Ok(carried)
}

/// A built-in shape by its word, unless a file is called so; else a mesh's file, in which `up` is up. It has no style yet.
pub fn solid(path: &Path, up: Option<Up>) -> Result<Given> {
    let name = path.display().to_string();
    match Shape::named(&name).filter(|_| !path.exists()) {
        Some(_) if up.is_some() => Err(Error::setting("--up", "is for files: y is up in shapes", "leave it out")),
        Some(shape) => Ok(Given::shape(shape)),
        None if is_word(path) => {
            let words = Shape::ALL.map(Shape::name).join(", ");
            Err(Error::input(name, "is neither a file nor a shape", format!("give a mesh or {words}")))
        }
        None => {
            let Mended { mesh, notes, .. } = open_mesh(&name, path, up)?;
            Ok(Given::mesh(&name, mesh, notes))
        }
    }
}

fn open_mesh(name: &str, path: &Path, up: Option<Up>) -> Result<Mended> {
    match read_at_most(path, MAX_MESH_BYTES) {
        Ok(Some(bytes)) => read_mesh(name, &bytes, up),
        Ok(None) => Err(Error::input(name, "has more than 200 MB", "save it with fewer triangles")),
        Err(problem) => Err(Error::input(name, format!("cannot be read ({problem})"), "check the file's name")),
    }
}

/// Whether a person meant something built in rather than a file.
fn is_word(path: &Path) -> bool {
    !path.exists() && path.extension().is_none()
}

/// A built-in pattern by its word, unless a file is called so; else a picture's file.
fn style(path: &Path) -> Result<(Style, Option<ReadingReport>)> {
    let name = path.display().to_string();
    if let Some(pattern) = Pattern::named(&name).filter(|_| !path.exists()) {
        return Ok((Style::pattern(pattern), None));
    }
    if is_word(path) {
        let words = Pattern::ALL.map(Pattern::name).join(", ");
        return Err(Error::picture(name, "is neither a file nor a pattern", format!("give a picture or {words}")));
    }
    let picture = read_picture(path)?;
    let (ink, ground) = ink(&picture, Polarity::Auto)?;
    let reading = ReadingReport::new(&picture, &ink, &ground);
    Ok((Style { name, ink, tiles: false }, Some(reading)))
}
