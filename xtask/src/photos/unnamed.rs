//! Pictures of wires that tell nothing about their subjects, for somebody to name who was not told.

use super::sheet::{has_wire, seen};
use crate::{Result, picture};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use wire4d_core::rng::Rng;

/// Side of a picture, px.
const SIDE: u32 = 400;
/// The order is the same each time, and not that of the table.
const SEED: u64 = 0x0077_686f;

/// Writes each wire from the front and turned, in one shuffled order: `LETTER01.png` and so on into `out/unnamed`, and what
/// they show into `out/key-LETTER.md`.
pub fn save(made: &[PathBuf], letter: char, out: &Path) -> Result {
    let folder = out.join("unnamed");
    std::fs::create_dir_all(&folder)?;
    for old in std::fs::read_dir(&folder)?.flatten() {
        if old.file_name().to_string_lossy().starts_with(letter) {
            std::fs::remove_file(old.path())?;
        }
    }
    let sides = [("front", None), ("turned by 35 degrees", Some("35,0"))];
    let mut pictures: Vec<_> =
        made.iter().filter(|folder| has_wire(folder)).flat_map(|wire| sides.map(|side| (wire, side))).collect();
    shuffle(&mut pictures);
    let mut key = String::from("| picture | wire | seen from |\n|---|---|---|\n");
    for (k, (wire, (words, from))) in pictures.into_iter().enumerate() {
        let file = format!("{letter}{:02}.png", k + 1);
        picture::save_lines(seen(wire, from, SIDE)?, &folder.join(&file))?;
        let name = wire.file_name().unwrap_or_default().to_string_lossy();
        writeln!(key, "| {file} | {name} | {words} |")?;
    }
    Ok(std::fs::write(out.join(format!("key-{letter}.md")), key)?)
}

/// Fisher and Yates's.
fn shuffle<T>(items: &mut [T]) {
    let mut rng = Rng::new(SEED, 0);
    for last in (1..items.len()).rev() {
        items.swap(last, (rng.unit() * (last + 1) as f64) as usize);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shuffle_keeps_all_and_is_the_same_each_time() {
        let shuffled = || {
            let mut order: Vec<usize> = (0..24).collect();
            shuffle(&mut order);
            order
        };
        let mut order = shuffled();
        assert_eq!(order, shuffled());
        assert_ne!(order, (0..24).collect::<Vec<_>>());
        order.sort_unstable();
        assert_eq!(order, (0..24).collect::<Vec<_>>());
    }
}
