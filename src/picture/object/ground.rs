//! A picture's colours, its ground and what stands out from it.

use super::super::Picture;
use super::super::colour::{distance, oklab};
use super::super::cutout::CutOut;
use super::super::sheet::{is_rim, sheet};
use super::super::spread::{otsu, quantile};
use crate::picture::{Ink, Mask};
use crate::view::Image;
use crate::{Error, Result};

/// Least distance from the ground's colour, in Oklab units (black to white is 1), that can be told from noise.
const LEAST_DISTANCE: f32 = 0.04;
/// Least share of the picture that a sheet covers: what is smaller is an object that stands out.
const LEAST_SHEET: f64 = 0.7;
/// A border that differs this much from a smooth ground in a fifth of its pixels is busy.
const BUSY: f32 = 0.05;

/// Colours as Oklab (Ottosson 2020), in which equal distances look equally different.
pub struct Pixels {
    pub width: usize,
    pub height: usize,
    pub lab: Vec<[f32; 3]>,
    pub alpha: Vec<f32>,
    /// Whether the picture is transparent in part.
    pub is_cut_out: bool,
    /// Where a sheet is that does not fill the picture.
    sheet: Option<Mask>,
}

impl Pixels {
    pub fn new(picture: &Picture) -> Pixels {
        let each = || picture.rgba().chunks_exact(4);
        let cut = CutOut::of(picture);
        // Where alpha is the drawing, its soft edges may have any colour.
        let shade = cut.and_then(|cut| cut.shade).map(|shade| shade.map(|value| (255.0 * value).round() as u8));
        let lab: Vec<[f32; 3]> =
            each().map(|p| oklab(shade.filter(|_| p[3] < 255).unwrap_or([p[0], p[1], p[2]]))).collect();
        let (width, height) = (picture.width(), picture.height());
        let lightness = || Image { width, height, data: lab.iter().map(|lab| lab[0].clamp(0.0, 1.0)).collect() };
        let sheet = if cut.is_some() { None } else { sheet(&lightness(), [LEAST_SHEET; 2]).map(|(sheet, _)| sheet) };
        let alpha = each().map(|p| if cut.is_some() { f32::from(p[3]) / 255.0 } else { 1.0 }).collect();
        Pixels { width, height, lab, alpha, is_cut_out: cut.is_some(), sheet }
    }

    pub fn alpha_image(&self) -> Image {
        Image { width: self.width, height: self.height, data: self.alpha.clone() }
    }

    /// Pixels where the ground ends: at the picture's border, or at the sheet's.
    fn border(&self) -> Vec<usize> {
        let rim = (self.width.min(self.height) / 60).max(1);
        let depth = self.sheet.as_ref().map(|sheet| sheet.inverted().distance_px().data);
        let is_border = |&i: &usize| {
            let outermost = is_rim(i, self.width, self.height, rim);
            depth.as_ref().map_or(outermost, |depth| depth[i] > 0.0 && (outermost || depth[i] <= rim as f32))
        };
        (0..self.lab.len()).filter(is_border).collect()
    }

    /// What transparent pictures are laid on: white, or black where all of the object is nearly white.
    pub fn paper(&self) -> Ground {
        let mut shades: Vec<f32> =
            self.lab.iter().zip(&self.alpha).filter(|(_, alpha)| **alpha >= 0.5).map(|(lab, _)| lab[0]).collect();
        let light = quantile(&mut shades, 0.1) > 0.85;
        Ground::even([if light { 0.0 } else { 1.0 }, 0.0, 0.0])
    }

    /// The ground round a mask that was given.
    pub fn ground_under(&self, mask: &Image) -> Ground {
        let mask = mask.resized(self.width, self.height);
        let outside: Vec<usize> = (0..self.lab.len()).filter(|&i| mask.data[i] < 0.1 && self.alpha[i] > 0.5).collect();
        if outside.is_empty() { self.paper() } else { Ground::fit(self, &outside) }
    }

    pub fn ground(&self) -> Ground {
        Ground::fit(self, &self.border())
    }

    /// How much of each pixel stands out from the ground.
    pub fn standing_out(&self, ground: &Ground, name: &str, notes: &mut Vec<String>) -> Result<Image> {
        let (width, height) = (self.width, self.height);
        let within = |i: usize| self.sheet.as_ref().is_none_or(|sheet| sheet.data[i]);
        let off = |i: usize| if within(i) { distance(self.lab[i], ground.at(self, i)) } else { 0.0 };
        let data: Vec<f32> = (0..self.lab.len()).map(off).collect();
        let mut border: Vec<f32> = self.border().into_iter().map(|i| data[i]).collect();
        let (usual, busy) = (quantile(&mut border, 0.5), quantile(&mut border, 0.8));
        let highest = data.iter().fold(0.0f32, |high, &d| high.max(d));
        // The ground's own unevenness is no object.
        let least = LEAST_DISTANCE.max(2.2 * usual).max(1.3 * busy);
        if highest <= LEAST_DISTANCE || highest <= least {
            let remedy = "use a picture whose object stands out from its ground, cut it out, or paint a mask";
            return Err(Error::picture(name, "shows no object: nothing differs from the border", remedy));
        }
        if self.sheet.is_some() {
            notes.push(format!("{name}: a sheet on another ground was found, and what is round it was left out"));
        }
        if busy > BUSY {
            notes.push(format!("{name}: the ground is busy, so the object may be cut out badly; a mask helps"));
        }
        // What clearly stands out, and on a clean ground all that it is joined to and stands out at all: lit parts of a pale
        // thing.
        let clear = (otsu(data.iter().map(|d| d / highest)) * highest * 0.8).max(least);
        let threshold = if busy < LEAST_DISTANCE { least.max(0.25 * clear) } else { clear };
        let image = Image { width, height, data };
        let parts = image.threshold(threshold).components();
        let mut is_clear = vec![false; parts.sizes.len() + 1];
        parts.labels.iter().zip(&image.data).for_each(|(&part, &d)| is_clear[part as usize] |= part > 0 && d > clear);
        let on = |i: usize| is_clear[parts.labels[i] as usize];
        // Pixels on the object's edge are mixed of it and the ground: their distance is their share of the full one.
        let mut mask = Image::new(width, height);
        for i in 0..mask.data.len() {
            let (x, y) = (i % width, i / width);
            let (mut nearby, mut inner, mut beside) = (0.0f32, true, false);
            for v in y.saturating_sub(1)..height.min(y + 2) {
                for u in x.saturating_sub(1)..width.min(x + 2) {
                    let n = v * width + u;
                    nearby = nearby.max(image.data[n]);
                    inner &= on(n);
                    beside |= on(n);
                }
            }
            mask.data[i] = match (inner, beside) {
                (true, _) => 1.0,
                (false, true) => image.data[i] / nearby,
                (false, false) => 0.0,
            };
        }
        Ok(mask)
    }
}

/// The ground's colour, a + b x + c y + d x y over the picture, x and y from -1 to 1: gradients are no object.
pub struct Ground([[f32; 4]; 3]);

impl Ground {
    pub fn even(lab: [f32; 3]) -> Ground {
        Ground(lab.map(|value| [value, 0.0, 0.0, 0.0]))
    }

    /// Reweighted least squares: what lies far off (the object where it meets the border) loses its say.
    pub fn fit(pixels: &Pixels, places: &[usize]) -> Ground {
        let median = |c: usize| quantile(&mut places.iter().map(|&i| pixels.lab[i][c]).collect::<Vec<_>>(), 0.5);
        let mut ground = Ground::even([median(0), median(1), median(2)]);
        for _ in 0..8 {
            let off: Vec<f32> = places.iter().map(|&i| distance(pixels.lab[i], ground.at(pixels, i))).collect();
            let scale = quantile(&mut off.clone(), 0.5).max(0.01);
            let mut normal = [[0.0f64; 7]; 4];
            for (&i, off) in places.iter().zip(&off) {
                let weight = f64::from(1.0 / (1.0 + (off / scale).powi(2)));
                let basis = basis(pixels, i).map(f64::from);
                for row in 0..4 {
                    (0..4).for_each(|column| normal[row][column] += weight * basis[row] * basis[column]);
                    (0..3).for_each(|c| normal[row][4 + c] += weight * basis[row] * f64::from(pixels.lab[i][c]));
                }
            }
            // A picture one pixel wide leaves some terms open: keep them near 0.
            (0..4).for_each(|k| normal[k][k] += 1e-6 * normal[0][0].max(1.0));
            eliminate(&mut normal);
            ground = Ground([4, 5, 6].map(|c| [0, 1, 2, 3].map(|row| normal[row][c] as f32)));
        }
        ground
    }

    pub fn at(&self, pixels: &Pixels, i: usize) -> [f32; 3] {
        let basis = basis(pixels, i);
        self.0.map(|weights| weights.iter().zip(&basis).map(|(weight, basis)| weight * basis).sum())
    }
}

fn basis(pixels: &Pixels, i: usize) -> [f32; 4] {
    let place = |p: usize, size: usize| 2.0 * (p as f32 + 0.5) / size as f32 - 1.0;
    let (x, y) = (place(i % pixels.width, pixels.width), place(i / pixels.width, pixels.height));
    [1.0, x, y, x * y]
}

/// Solves the 4 x 4 system for its three right-hand sides in place; positive definite, so no pivoting.
fn eliminate(rows: &mut [[f64; 7]; 4]) {
    for k in 0..4 {
        let pivot = rows[k];
        rows[k] = pivot.map(|value| value / pivot[k]);
        for row in (0..4).filter(|&row| row != k) {
            let factor = rows[row][k];
            (0..7).for_each(|c| rows[row][c] -= factor * rows[k][c]);
        }
    }
}
