//! Photographs to wires, with figures of each step: the twelve scenes of known truth, or those of a list.
//! `cargo bench --bench photographs -- FOLDER [LIST.json] [NAME=VALUE]...`
//!
//! A list is `[{"name": "cup", "file": "cup.jpg", "box": [left, top, right, bottom]}]`, the box in pixels of the file.
//! `NAME=VALUE` are settings of `wire4d stroke`. For each photograph, `FOLDER/NAME` gets photo.png, mask.png, lines.png,
//! wire.json and figures.json; of one that is refused, photo.png and why, in figures.json.

mod measure;
#[path = "../../tests/support/photo_judge/mod.rs"]
mod photo_judge;
#[path = "../../tests/support/scenes/mod.rs"]
mod scenes;

use measure::Subject;
use photo_judge::{box_round, picture};
use scenes::{photograph, twelve};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use wire4d::picture::read_picture;
use wire4d::settings::Task;
use wire4d::tasks::stroke::Given;

/// Margin of a box that somebody drags, as a share of the object's sides.
const MARGIN: f32 = 0.12;

/// A line of a list.
#[derive(Deserialize)]
struct Listed {
    name: String,
    file: PathBuf,
    #[serde(rename = "box")]
    bounds: [f64; 4],
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Cargo adds --bench.
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with("--")).collect();
    let (pairs, paths): (Vec<&str>, Vec<&str>) = words.iter().map(String::as_str).partition(|word| word.contains('='));
    let pairs: Vec<(&str, &str)> = pairs.iter().filter_map(|pair| pair.split_once('=')).collect();
    let settings = Task::Stroke.settings(pairs.clone())?;
    let others = pairs.into_iter().filter(|(name, _)| *name != "preset");
    let fast = Task::Stroke.settings(others.chain([("preset", "fast")]).collect::<Vec<_>>())?;
    let [folder, list @ ..] = &paths[..] else {
        println!("nothing is measured: say in which folder the results go");
        return Ok(());
    };
    let measure = |subject: Subject| -> Result<(), Box<dyn std::error::Error>> {
        let out = Path::new(folder).join(&subject.name);
        match measure::run(&subject, &settings, &fast, &out) {
            Ok(figures) => println!("{figures}"),
            Err(error) => {
                println!("{}: no wire: {error}", subject.name);
                measure::refused(&subject, &*error, &out)?;
            }
        }
        Ok(())
    };
    match list {
        [] => twelve().iter().try_for_each(|scene| {
            let taken = photograph(scene);
            let bounds = box_round(&taken.mask, MARGIN).map(f64::from);
            let given = Given { bounds: Some(bounds), ..Given::picture(picture(&taken)) };
            measure(Subject { name: taken.name.replace(' ', "-"), given, truth: Some(taken) })
        }),
        [list, ..] => {
            let listed: Vec<Listed> = serde_json::from_str(&std::fs::read_to_string(list)?)?;
            listed.into_iter().try_for_each(|Listed { name, file, bounds }| {
                let given = Given { bounds: Some(bounds), ..Given::picture(read_picture(&file)?) };
                measure(Subject { name, given, truth: None })
            })
        }
    }
}
