//! Pictures of ink beside each other, dark on white.

use crate::Result;
use crate::picture::save_lines;
use image::{GrayImage, Luma, imageops};
use std::path::{Path, PathBuf};

/// Side of one picture and the gap round it, px.
const CELL: u32 = 200;
const GAP: u32 = 10;

/// Rows of pictures, a wire each.
#[derive(Default)]
pub struct Sheet(Vec<Vec<GrayImage>>);

impl Sheet {
    /// Adds what one wire shows.
    pub fn add(&mut self, pictures: &[PathBuf]) -> Result {
        let cell = |path: &PathBuf| -> Result<GrayImage> {
            let mut ink = image::open(path).map_err(|error| format!("{}: {error}", path.display()))?.to_luma8();
            imageops::invert(&mut ink);
            Ok(imageops::resize(&ink, CELL, CELL, imageops::FilterType::CatmullRom))
        };
        self.0.push(pictures.iter().map(cell).collect::<Result<_>>()?);
        Ok(())
    }

    /// Writes all of them, so many wires a row.
    pub fn save(&self, path: &Path, wires: usize) -> Result {
        let across = (wires * self.0.first().map_or(1, Vec::len)) as u32;
        let cells: Vec<&GrayImage> = self.0.iter().flatten().collect();
        let rows = (cells.len() as u32).div_ceil(across);
        let mut sheet = GrayImage::from_pixel(across * (CELL + GAP) + GAP, rows * (CELL + GAP) + GAP, Luma([255]));
        for (k, cell) in (0u32..).zip(cells) {
            let place = |index: u32| i64::from(GAP + index * (CELL + GAP));
            imageops::replace(&mut sheet, cell, place(k % across), place(k / across));
        }
        save_lines(sheet, path)
    }
}
