//! A sheet of photographs: each with its box, what was cut out with the lines drawn of it, and the wire from three sides.

use crate::{Result, picture, tube};
use image::imageops::{self, FilterType};
use image::{DynamicImage, GrayImage, Luma, Rgb, RgbImage};
use serde_json::Value;
use std::path::{Path, PathBuf};
use wire4d_core::view::{View, ViewSpec};
use wire4d_core::wire::Wire;

/// Side of one picture, the gap round it, and the wider one between columns.
const CELL: u32 = 200;
const GAP: u32 = 4;
const WIDE_GAP: u32 = 12;
/// Photographs beside each other, and pictures of each.
const COLUMNS: u32 = 2;
const PICTURES: u32 = 5;
const GROUND: Rgb<u8> = Rgb([200; 3]);
const BOX: Rgb<u8> = Rgb([255, 0, 160]);
/// Height of what is seen from a side: the unit ball with a margin, world units.
const HEIGHT_WORLD: f64 = 2.2;
/// How pale a photograph is under its lines, and what was not cut out: shares of white.
const PALE: f64 = 0.5;
const LEFT_OUT: f64 = 0.93;

/// Draws the photographs whose files lie in some folders.
pub fn save(made: &[PathBuf], path: &Path) -> Result {
    let across = PICTURES * (CELL + GAP);
    let rows = (made.len() as u32).div_ceil(COLUMNS);
    let mut sheet =
        RgbImage::from_pixel(COLUMNS * (across + WIDE_GAP) - WIDE_GAP + GAP, rows * (CELL + GAP) + GAP, GROUND);
    for (k, folder) in made.iter().enumerate() {
        // Down one column, then down the next, as the table runs.
        let (column, row) = (k as u32 / rows, k as u32 % rows);
        let mut cells = vec![photo(folder)?];
        if has_wire(folder) {
            cells.push(drawn(folder)?);
            for view in [None, Some("35,0"), Some("90,0")] {
                cells.push(DynamicImage::ImageLuma8(seen(folder, view, CELL)?).to_rgb8());
            }
        }
        for (p, cell) in cells.iter().enumerate() {
            let x = GAP + column * (across + WIDE_GAP) + p as u32 * (CELL + GAP);
            imageops::replace(&mut sheet, cell, i64::from(x), i64::from(GAP + row * (CELL + GAP)));
        }
    }
    picture::save(&DynamicImage::ImageRgb8(sheet), path)
}

/// Whether a wire was made; some photographs are refused.
pub fn has_wire(folder: &Path) -> bool {
    folder.join("wire.json").is_file()
}

/// A file of JSON.
pub fn read(path: &Path) -> Result<Value> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The wire from where it shows its lines, or from a side.
pub fn seen(folder: &Path, from: Option<&str>, side_px: u32) -> Result<GrayImage> {
    let made = read(&folder.join("wire.json"))?;
    let view = match from {
        None => serde_json::from_value::<View>(made["views"][0].clone())?,
        Some(side) => side.parse::<ViewSpec>()?.resolve(&[], HEIGHT_WORLD, side_px as usize)?,
    };
    let wire: Wire = serde_json::from_value(made)?;
    Ok(tube::draw(&wire, &view.with_size(side_px as usize, side_px as usize)))
}

fn opened(folder: &Path, name: &str) -> Result<DynamicImage> {
    let path = folder.join(name);
    image::open(&path).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// The photograph with its box.
fn photo(folder: &Path) -> Result<RgbImage> {
    let whole = opened(folder, "photo.png")?.to_rgb8();
    let scale = f64::from(CELL) / f64::from(whole.width().max(whole.height()));
    let [width, height] = [whole.width(), whole.height()].map(|side| ((f64::from(side) * scale) as u32).max(1));
    let mut small = imageops::resize(&whole, width, height, FilterType::Triangle);
    let bounds = read(&folder.join("figures.json"))?["box"].clone();
    let at = |k: usize, most: u32| (bounds[k].as_f64().unwrap_or(0.0) * scale).clamp(0.0, f64::from(most - 1)) as u32;
    if bounds.is_array() {
        let [left, top, right, bottom] = [at(0, width), at(1, height), at(2, width), at(3, height)];
        (left..=right).for_each(|x| [top, bottom].iter().for_each(|&y| small.put_pixel(x, y, BOX)));
        (top..=bottom).for_each(|y| [left, right].iter().for_each(|&x| small.put_pixel(x, y, BOX)));
    }
    let mut cell = RgbImage::from_pixel(CELL, CELL, Rgb([255; 3]));
    imageops::replace(&mut cell, &small, i64::from((CELL - width) / 2), i64::from((CELL - height) / 2));
    Ok(cell)
}

/// The photograph round the cut, pale, what was not cut out nearly white, and the lines over it.
fn drawn(folder: &Path) -> Result<RgbImage> {
    let lines = opened(folder, "lines.png")?.to_luma8();
    let (width, height) = lines.dimensions();
    let whole = imageops::resize(&opened(folder, "photo.png")?.to_rgb8(), width, height, FilterType::Triangle);
    let mask = imageops::resize(&opened(folder, "mask.png")?.to_luma8(), width, height, FilterType::Triangle);
    let share = |value: u8| f64::from(value) / 255.0;
    let both = RgbImage::from_fn(width, height, |x, y| {
        let pale = LEFT_OUT + (PALE - LEFT_OUT) * share(mask.get_pixel(x, y).0[0]);
        let line = share(lines.get_pixel(x, y).0[0]);
        Rgb(whole.get_pixel(x, y).0.map(|c| ((pale * 255.0 + (1.0 - pale) * f64::from(c)) * (1.0 - line)) as u8))
    });
    // A square round all that is cut out, or drawn where nothing is.
    let on = |picture: &GrayImage| {
        let mut frame = [u32::MAX, u32::MAX, 0, 0];
        for (x, y, Luma([value])) in picture.enumerate_pixels() {
            if *value > 127 {
                frame = [frame[0].min(x), frame[1].min(y), frame[2].max(x + 1), frame[3].max(y + 1)];
            }
        }
        frame
    };
    let [left, top, right, bottom] = on(&mask);
    let side = f64::from(right.saturating_sub(left).max(bottom.saturating_sub(top)).max(1)) * 1.16;
    let corner = |low: u32, high: u32| 0.5 * (f64::from(low) + f64::from(high)) - 0.5 * side;
    let mut square = RgbImage::from_pixel(side as u32, side as u32, Rgb([255; 3]));
    imageops::replace(&mut square, &both, -corner(left, right) as i64, -corner(top, bottom) as i64);
    Ok(imageops::resize(&square, CELL, CELL, FilterType::Triangle))
}
