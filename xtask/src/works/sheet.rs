//! Wires on a contact sheet: each in its room, then from the front, the side, above, and turned by two angles.

use super::poster;
use crate::{Result, picture, tube};
use image::{DynamicImage, GrayImage, RgbImage, imageops};
use std::path::Path;
use wire4d_core::view::ViewSpec;
use wire4d_core::wire::Wire;

const ROOM: [u32; 2] = [216, 180];
const CELL: u32 = 90;
const GAP: u32 = 4;
const COLUMNS: usize = 3;
/// In the order of a block's small pictures, three above three.
const VIEWS: [&str; 6] = ["front", "side", "top", "35,15", "60,15", "-45,20"];
const HEIGHT_WORLD: f64 = 2.0;

/// Draws and writes the sheet.
pub fn save(wires: &[Wire], path: &Path) -> Result {
    let block = [ROOM[0] + 3 * CELL + GAP, ROOM[1]];
    let rows = wires.len().div_ceil(COLUMNS) as u32;
    let columns = COLUMNS.min(wires.len().max(1)) as u32;
    let mut sheet =
        RgbImage::from_pixel(columns * (block[0] + GAP), rows * (block[1] + GAP), image::Rgb([255, 255, 255]));
    for (k, wire) in wires.iter().enumerate() {
        let (x, y) = ((k % COLUMNS) as u32 * (block[0] + GAP), (k / COLUMNS) as u32 * (block[1] + GAP));
        let room = poster::draw(wire, ROOM.map(|side| side as usize), &poster::LIGHT);
        imageops::replace(&mut sheet, &room, x.into(), y.into());
        for (n, view) in VIEWS.iter().enumerate() {
            let view = view.parse::<ViewSpec>()?.resolve(&[], HEIGHT_WORLD, CELL as usize)?;
            let small: GrayImage = tube::draw(wire, &view);
            let small = DynamicImage::ImageLuma8(small).to_rgb8();
            let (column, row) = (n as u32 % 3, n as u32 / 3);
            imageops::replace(&mut sheet, &small, (x + ROOM[0] + column * CELL).into(), (y + row * CELL).into());
        }
    }
    // Sixteen steps a colour are enough for a sheet and a quarter of the bytes.
    sheet.pixels_mut().for_each(|pixel| pixel.0 = pixel.0.map(|c| ((u16::from(c) + 8) / 17 * 17) as u8));
    picture::save(&sheet.into(), path)
}
