//! `wire4d stroke`: one picture in, a folder with the wire, its views and the report out.

use crate::guiding::{Guided, Guides};
use crate::likeness::Likeness;
use crate::making::{Making, made, save, save_picture};
use crate::{args, folder::Folder};
use clap::ArgMatches;
use std::path::{Path, PathBuf};
use wire4d::metrics::Report;
use wire4d::picture::cut::{SURE, Stroke};
use wire4d::picture::{GreyDepth, Picture, read_depth, read_picture};
use wire4d::sculpture::Carried;
use wire4d::settings::Task;
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{self, Given};
use wire4d::view::{Image, parse_placed_picture};
use wire4d::{Error, Result, sculpture};

pub fn run(matches: &ArgMatches) -> Result<()> {
    let settings = args::settings(matches, Task::Stroke)?;
    let guides = Guides::new(matches)?;
    let likeness = Likeness::new(matches)?;
    let given = given(matches)?;
    let out = args::path(matches, "out");
    let folder = Folder::claim(out, matches.get_flag("overwrite"))?;
    let making = Making::new(&folder, matches.get_flag("quiet"));
    making.bar.set_message("Finding the object");
    let pictures = std::iter::once(&given.picture).chain(&given.depth).chain(given.others.iter().map(|other| &other.0));
    pictures.flat_map(Picture::notes).for_each(|note| making.say(&note));
    let plan = stroke::plan(&given, &settings).map_err(by_option)?;
    plan.notes().iter().for_each(|note| making.say(note));
    if plan.sure < SURE && given.bounds.is_none() {
        making.say(
            "Say which thing it is with --box X,Y,W,H or --mark-object X,Y,X,Y, in pixels of the picture, or with --mask PICTURE",
        );
    }
    making.bar.set_message("Laying a first wire");
    let mask = plan.object.mask.clone();
    let mut run = Run::start(plan, &mut |_| true)?;
    let (time, Guided { guidance, distillation }) = making.fit(&mut run, &guides)?;
    let mut report = Report { guidance, distillation, ..run.report(time, !run.session().is_done()) };
    likeness.iter().for_each(|likeness| likeness.measure(&mut report, &run));

    let made = made(&run, &report, Carried::default())?;
    save(&folder, &made, &report, &run.loss_csv())?;
    for target in run.targets() {
        let name = &target.view.name;
        save_picture(&folder, name, "", &sculpture::render(&made.wire, &target.view), GreyDepth::Bits16)?;
        save_picture(&folder, name, "-target", &target.ink, GreyDepth::Bits8)?;
    }
    save_picture(&folder, "mask", "", &mask, GreyDepth::Bits8)?;
    making.bar.finish_and_clear();
    folder.finish()?;
    println!("{}", out.join("report.json").display());
    Ok(())
}

/// Left, top, right and bottom of `X,Y,W,H`.
fn bounds(text: &str) -> Result<[f64; 4]> {
    let numbers: Vec<f64> = text.split(',').filter_map(|number| number.trim().parse().ok()).collect();
    match numbers[..] {
        [x, y, width, height] if text.split(',').count() == 4 => Ok([x, y, x + width, y + height]),
        _ => {
            Err(Error::setting("box", format!("{text:?} is not four numbers"), "give X,Y,W,H in pixels of the picture"))
        }
    }
}

/// Half the width of a stroke, share of the picture's longer side.
const RADIUS: f32 = 0.005;

/// The strokes of an option that may be given again and again, each `X,Y,X,Y,…` in the file's own pixels; `scale` of
/// which are one of the picture's.
fn strokes(matches: &ArgMatches, option: &str, picture: &Picture, scale: f64) -> Result<Vec<Stroke>> {
    let refuse = |problem: String, remedy: &str| Err(Error::setting(option, problem, remedy));
    let (width, height) = (picture.width() as f32, picture.height() as f32);
    let stroke = |text: &String| {
        let numbers: Result<Vec<f64>, _> = text.split(',').map(|number| number.trim().parse()).collect();
        let Some(numbers) = numbers.ok().filter(|numbers| numbers.iter().all(|number: &f64| number.is_finite())) else {
            return refuse(
                format!("{text:?} is not numbers with commas between"),
                "give X,Y,X,Y in pixels of the picture",
            );
        };
        if numbers.len() % 2 == 1 {
            let problem = format!("{text:?} are {} numbers, and each place takes two", numbers.len());
            return refuse(problem, "give X,Y,X,Y in pixels of the picture");
        }
        let points: Vec<[f32; 2]> =
            numbers.chunks_exact(2).map(|place| [0, 1].map(|c: usize| (place[c] * scale) as f32)).collect();
        let is_inside = |&[x, y]: &[f32; 2]| (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
        if !points.iter().all(is_inside) {
            let [w, h] = [width, height].map(|side| (f64::from(side) / scale).round());
            return refuse(format!("{text:?} lies outside the picture"), &format!("stay within {w} x {h} pixels"));
        }
        Ok(Stroke { points, radius_px: RADIUS * width.max(height) })
    };
    matches.get_many::<String>(option).into_iter().flatten().map(stroke).collect()
}

/// Errors as they are called on the command line.
fn by_option(error: Error) -> Error {
    match error {
        Error::Setting { name, problem, remedy } if name == "strokes" => {
            Error::setting("mark-object and mark-ground", problem, remedy)
        }
        other => other,
    }
}

fn given(matches: &ArgMatches) -> Result<Given> {
    let optional = |name: &str| matches.get_one::<PathBuf>(name).map(|path| read_picture(path)).transpose();
    let mask = optional("mask")?.map(|mask| {
        let data = mask.rgba().chunks_exact(4).map(|p| f32::from(p[1]) / 255.0 * f32::from(p[3]) / 255.0);
        Image { width: mask.width(), height: mask.height(), data: data.collect() }
    });
    let others = matches.get_many::<String>("view").into_iter().flatten().map(|text| {
        let (path, seen_from) = parse_placed_picture(text)?;
        Ok((read_picture(Path::new(&path))?, seen_from))
    });
    let picture = read_picture(args::path(matches, "picture"))?;
    // People measure in the file's own pixels.
    let scale = picture.shrunk_from().map_or(1.0, |[width, _]| picture.width() as f64 / width as f64);
    let bounds = matches.get_one::<String>("box").map(|text| bounds(text)).transpose()?;
    Ok(Given {
        bounds: bounds.map(|bounds| bounds.map(|side| side * scale)),
        object: strokes(matches, "mark-object", &picture, scale)?,
        ground: strokes(matches, "mark-ground", &picture, scale)?,
        picture,
        mask,
        depth: matches.get_one::<PathBuf>("depth").map(|path| read_depth(path)).transpose()?,
        others: others.collect::<Result<_>>()?,
    })
}
