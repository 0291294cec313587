//! `cargo xtask photos`: photographs to wires, twelve rendered ones of known truth and ten real ones.

mod real;
mod sheet;
mod table;
mod unnamed;

use crate::Result;
use crate::shell::{command, root, run as run_command, say};
use std::path::{Path, PathBuf};

/// For the list of verbs.
pub const HELP: &str = "photographs of known truth and real ones to wires: tables, sheets and pictures without names";

/// Options: `scenes` or `real` (both by default), then settings of `wire4d stroke` as NAME=VALUE. Everything goes into
/// out/photos, since nothing of real photographs is kept here.
pub fn run(arguments: &[String]) -> Result {
    let (settings, sets): (Vec<&String>, Vec<&String>) = arguments.iter().partition(|word| word.contains('='));
    if let Some(unknown) = sets.iter().find(|set| !["scenes", "real"].contains(&set.as_str())) {
        return Err(format!("there is no set `{unknown}`; say `scenes` or `real`, and settings as NAME=VALUE").into());
    }
    let wanted = |set: &str| sets.is_empty() || sets.iter().any(|word| *word == set);
    let out = root().join("out/photos");
    if wanted("scenes") {
        show("scenes", 'a', &measured("scenes", None, &settings, &out)?, &out)?;
    }
    if wanted("real") {
        match real::fetched(&root().join("target/photos")) {
            Ok(list) => show("real", 'b', &measured("real", Some(&list), &settings, &out)?, &out)?,
            Err(error) if sets.is_empty() => say(format!("NOT SHOWN: the real photographs, since {error}")),
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// Makes the wires of a set, and says where each one's files lie.
fn measured(set: &str, list: Option<&Path>, settings: &[&String], out: &Path) -> Result<Vec<PathBuf>> {
    let folder = out.join(set);
    // Nothing that an earlier run left may be taken for this one's.
    let _ = std::fs::remove_dir_all(&folder);
    let mut bench = command("cargo");
    bench.args(["bench", "--bench", "photographs", "--"]).arg(&folder).args(list).args(settings);
    run_command(&mut bench)?;
    let mut made: Vec<PathBuf> = std::fs::read_dir(&folder)?.flatten().map(|entry| entry.path()).collect();
    made.sort();
    Ok(made)
}

fn show(set: &str, letter: char, made: &[PathBuf], out: &Path) -> Result {
    let table = table::markdown(made)?;
    println!("{table}");
    std::fs::write(out.join(format!("{set}.md")), table)?;
    sheet::save(made, &out.join(format!("{set}.png")))?;
    unnamed::save(made, letter, out)?;
    say(format!("the sheet is {}", out.join(format!("{set}.png")).display()));
    Ok(())
}
