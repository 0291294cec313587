//! A picture's colours, its ground and what stands out from it.

use super::super::Picture;
use super::super::ink::{otsu, quantile};
use crate::picture::Ink;
use crate::view::Image;
use crate::{Error, Result};

/// Least distance from the ground's colour, in Oklab units (black to white is 1), that can be told from noise.
const LEAST_DISTANCE: f32 = 0.04;
/// A border that differs this much from a smooth ground in a fifth of its pixels is busy.
const BUSY: f32 = 0.05;

/// Colours as Oklab (Ottosson 2020), in which equal distances look equally different.
pub struct Pixels {
    pub width: usize,
    pub height: usize,
    pub lab: Vec<[f32; 3]>,
    pub alpha: Vec<f32>,
}

impl Pixels {
    pub fn new(picture: &Picture) -> Pixels {
        let each = || picture.rgba().chunks_exact(4);
        Pixels {
            width: picture.width(),
            height: picture.height(),
            lab: each().map(|p| oklab([p[0], p[1], p[2]])).collect(),
            alpha: each().map(|p| f32::from(p[3]) / 255.0).collect(),
        }
    }

    pub fn alpha_image(&self) -> Image {
        Image { width: self.width, height: self.height, data: self.alpha.clone() }
    }

    fn is_border(&self, i: usize) -> bool {
        let rim = (self.width.min(self.height) / 60).max(1);
        let (x, y) = (i % self.width, i / self.width);
        x < rim || y < rim || x + rim >= self.width || y + rim >= self.height
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
        let border: Vec<usize> = (0..self.lab.len()).filter(|&i| self.is_border(i)).collect();
        Ground::fit(self, &border)
    }

    /// How much of each pixel stands out from the ground.
    pub fn standing_out(&self, ground: &Ground, name: &str, notes: &mut Vec<String>) -> Result<Image> {
        let (width, height) = (self.width, self.height);
        let data: Vec<f32> = (0..self.lab.len()).map(|i| distance(self.lab[i], ground.at(self, i))).collect();
        let mut border: Vec<f32> = (0..data.len()).filter(|&i| self.is_border(i)).map(|i| data[i]).collect();
        let (usual, busy) = (quantile(&mut border, 0.5), quantile(&mut border, 0.8));
        let highest = data.iter().fold(0.0f32, |high, &d| high.max(d));
        // The ground's own unevenness is no object.
        let least = LEAST_DISTANCE.max(2.2 * usual).max(1.3 * busy);
        if highest <= LEAST_DISTANCE || highest <= least {
            let remedy = "use a picture whose object stands out from its ground, cut it out, or paint a mask";
            return Err(Error::picture(name, "shows no object: nothing differs from the border", remedy));
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

pub fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>().sqrt()
}

fn oklab(rgb: [u8; 3]) -> [f32; 3] {
    let [r, g, b] = rgb.map(|byte| {
        let value = f32::from(byte) / 255.0;
        if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    });
    let l = (0.412_221_46 * r + 0.536_332_55 * g + 0.051_445_995 * b).cbrt();
    let m = (0.211_903_5 * r + 0.680_699_5 * g + 0.107_396_96 * b).cbrt();
    let s = (0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b).cbrt();
    [
        0.210_454_26 * l + 0.793_617_8 * m - 0.004_072_047 * s,
        1.977_998_5 * l - 2.428_592_2 * m + 0.450_593_7 * s,
        0.025_904_037 * l + 0.782_771_77 * m - 0.808_675_77 * s,
    ]
}
