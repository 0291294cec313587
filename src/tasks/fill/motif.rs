//! A style's picture on a surface: its tone at a point, and which way its strokes run there.
//!
//! The picture is laid on from six sides (a box) and repeated, or once from the front. A picture whose borders do not meet
//! is mirrored from tile to tile, so that strokes go on across them.

use super::Style;
use crate::settings::{Motif as Laid, Settings};
use crate::view::{Image, StructureTensor};

/// Blurs of the gradient before it is squared and of the squares, as shares of the picture's side: a stroke's width and
/// the size of the neighbourhood that runs one way.
const FINE: f64 = 0.004;
const COARSE: f64 = 0.02;
/// Side to which pictures are scaled.
const SIDE_PX: usize = 384;
/// How sharply one side of the box gives way to the next.
const SHARPNESS: i32 = 12;

/// A style's picture, laid on.
pub(super) struct Motif {
    tone: Image,
    /// Cosine and sine of twice the angle at which strokes run, times how clearly they do, 0 to 1; x right, y down.
    along: [Image; 2],
    tiles: bool,
    laid: Laid,
    side_world: f64,
}

impl Motif {
    pub(super) fn new(style: &Style, settings: &Settings) -> Motif {
        // A picture that is not square keeps its aspect: as much of it as fits a square.
        let side = style.ink.width.min(style.ink.height) as f64;
        let [x, y] = [style.ink.width, style.ink.height].map(|whole| (whole as f64 - side) / 2.0);
        let tone = style.ink.window([x, y, x + side, y + side], SIDE_PX, SIDE_PX);
        let along = directions(&tone);
        Motif { tone, along, tiles: style.tiles, laid: settings.motif, side_world: settings.style_size }
    }

    /// Tone at a point of the surface, 0 (blank) to 1 (ink).
    pub(super) fn tone(&self, point: &[f64; 3], normal: &[f64; 3]) -> f64 {
        match self.laid {
            Laid::Off => 0.5,
            Laid::Front => f64::from(self.at(&self.tone, self.place([point[0], -point[1]], true))),
            Laid::Box => {
                let weights = normal.map(|c| c.abs().powi(SHARPNESS));
                let sum: f64 = weights.iter().sum();
                let tone = |axis: usize| {
                    let (uv, _) = face(axis, point, normal);
                    weights[axis] * f64::from(self.at(&self.tone, self.place(uv, false)))
                };
                (0..3).map(tone).sum::<f64>() / sum.max(1e-12)
            }
        }
    }

    /// Which way strokes run at a point of the surface, in the world, and how clearly, 0 to 1; `None` where they do not.
    pub(super) fn along(&self, point: &[f64; 3], normal: &[f64; 3]) -> Option<([f64; 3], f64)> {
        let front = self.laid == Laid::Front;
        let axis = if front { 2 } else { (0..3).max_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs()))? };
        let (uv, [right, down]) = face(axis, point, if front { &[0.0, 0.0, 1.0] } else { normal });
        let place = self.place(uv, front);
        let [cos, mut sin] = [0, 1].map(|k| f64::from(self.at(&self.along[k], place)));
        if !self.tiles && place.mirrored {
            sin = -sin;
        }
        let clear = cos.hypot(sin);
        if clear < 0.02 {
            return None;
        }
        let (sin, cos) = (0.5 * sin.atan2(cos)).sin_cos();
        Some((std::array::from_fn(|c| cos * right[c] + sin * down[c]), clear.min(1.0)))
    }

    /// Where in the picture a point of the plane lies.
    fn place(&self, uv: [f64; 2], once: bool) -> Place {
        let [u, v] = uv.map(|c| c / self.side_world + 0.5);
        let inside = |c: f64| (0.0..1.0).contains(&c);
        let blank = once && !(inside(u) && inside(v));
        if self.tiles {
            return Place { u: u - u.floor(), v: v - v.floor(), mirrored: false, blank };
        }
        let fold = |c: f64| {
            let within = c.rem_euclid(2.0);
            if within > 1.0 { (2.0 - within, true) } else { (within, false) }
        };
        let ((u, mirrored_u), (v, mirrored_v)) = (fold(u), fold(v));
        Place { u, v, mirrored: mirrored_u != mirrored_v, blank }
    }

    fn at(&self, image: &Image, place: Place) -> f32 {
        if place.blank {
            return 0.0;
        }
        image.sample((place.u * image.width as f64) as f32, (place.v * image.height as f64) as f32)
    }
}

#[derive(Clone, Copy)]
struct Place {
    u: f64,
    v: f64,
    mirrored: bool,
    blank: bool,
}

/// The side of the box across `axis` that looks at the surface: where the point lies on it (right and down), and both
/// directions in the world. Upright pictures stay upright all round; on top and below they are as seen from the front.
fn face(axis: usize, point: &[f64; 3], normal: &[f64; 3]) -> ([f64; 2], [[f64; 3]; 2]) {
    let sign = if normal[axis] < 0.0 { -1.0 } else { 1.0 };
    let [right, down] = match axis {
        0 => [[0.0, 0.0, -sign], [0.0, -1.0, 0.0]],
        1 => [[1.0, 0.0, 0.0], [0.0, 0.0, sign]],
        _ => [[sign, 0.0, 0.0], [0.0, -1.0, 0.0]],
    };
    let dot = |a: &[f64; 3]| (0..3).map(|c| a[c] * point[c]).sum::<f64>();
    ([dot(&right), dot(&down)], [right, down])
}

/// Which way a picture's strokes run: the smaller eigenvector of its structure tensor, as twice its angle.
fn directions(tone: &Image) -> [Image; 2] {
    let side = tone.width as f64;
    let smooth = tone.blurred(FINE * side);
    let (width, height) = (tone.width, tone.height);
    let StructureTensor { xx, xy, yy } = StructureTensor::new([width, height], COARSE * side, |x, y| {
        // Across the border the picture is taken to be repeated.
        let at = |x: usize, y: usize| smooth.at(x % width, y % height);
        let dx = at(x + 1, y) - at(x + width - 1, y);
        let dy = at(x, y + 1) - at(x, y + height - 1);
        [[dx, dy].map(f64::from)]
    });
    let strongest = xx.data.iter().zip(&yy.data).map(|(a, b)| a + b).fold(0.0, f32::max).max(1e-12);
    let mut along = [(); 2].map(|()| Image::new(width, height));
    for i in 0..width * height {
        let (difference, product, sum) = (xx.data[i] - yy.data[i], 2.0 * xy.data[i], xx.data[i] + yy.data[i]);
        let coherence = difference.hypot(product);
        // Strokes run across the gradient: half a turn of twice the angle. Faint strokes count less.
        let clear = (coherence / sum.max(1e-12)) * (sum / (0.05 * strongest)).min(1.0);
        let scale = -clear / coherence.max(1e-12);
        along[0].data[i] = scale * difference;
        along[1].data[i] = scale * product;
    }
    along
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::{Preset, Task};

    fn striped(angle: f64, tiles: bool) -> Style {
        let mut ink = Image::new(200, 200);
        let (sin, cos) = angle.sin_cos();
        for (i, value) in ink.data.iter_mut().enumerate() {
            let [x, y] = [(i % 200) as f64, (i / 200) as f64];
            *value = (0.5 + 0.5 * (0.5 * (y * cos - x * sin)).sin()) as f32;
        }
        Style { name: "stripes".into(), ink, tiles }
    }

    fn motif(style: &Style, laid: Laid) -> Motif {
        Motif::new(style, &Settings { motif: laid, style_size: 0.8, ..Task::Fill.preset(Preset::Best) })
    }

    #[test]
    fn strokes_run_on_the_surface_as_in_the_picture() {
        let angle = 0.4f64;
        for laid in [Laid::Box, Laid::Front] {
            let motif = motif(&striped(angle, true), laid);
            let ([x, y, z], clear) = motif.along(&[0.05, 0.1, 0.9], &[0.1, 0.1, 0.99]).unwrap();
            // The picture's y points down.
            let wanted = [angle.cos(), -angle.sin(), 0.0];
            let cosine = x * wanted[0] + y * wanted[1] + z * wanted[2];
            assert!(cosine.abs() > 0.99 && clear > 0.8, "{cosine} {clear}");
        }
    }

    #[test]
    fn all_sides_of_the_box_show_the_picture_upright_and_unmirrored() {
        let style = Style { ink: Image { width: 2, height: 2, data: vec![1.0, 0.0, 0.0, 0.0] }, ..striped(0.0, true) };
        let motif = motif(&style, Laid::Box);
        // The upper left quarter as seen by somebody who looks at that side.
        for (point, normal) in [
            ([-0.2, 0.2, 1.0], [0.0, 0.0, 1.0]),
            ([0.2, 0.2, -1.0], [0.0, 0.0, -1.0]),
            ([1.0, 0.2, 0.2], [1.0, 0.0, 0.0]),
            ([-1.0, 0.2, -0.2], [-1.0, 0.0, 0.0]),
            ([-0.2, 1.0, -0.2], [0.0, 1.0, 0.0]),
        ] {
            let there = motif.tone(&point, &normal);
            let elsewhere = motif.tone(&point.map(|c| if c.abs() < 1.0 { -c } else { c }), &normal);
            assert!(there > 0.8 && elsewhere < 0.2, "{normal:?}: {there} {elsewhere}");
        }
    }

    #[test]
    fn pictures_that_do_not_tile_go_on_across_borders() {
        let motif = motif(&striped(0.7, false), Laid::Box);
        let tone = |x: f64| motif.tone(&[x, 0.11, 0.9], &[0.0, 0.0, 1.0]);
        for border in [-0.4, 0.4, 1.2] {
            assert!((tone(border - 1e-3) - tone(border + 1e-3)).abs() < 0.05, "at {border}");
        }
        assert_eq!(self::motif(&striped(0.0, true), Laid::Off).tone(&[0.3, 0.2, 0.9], &[0.0, 0.0, 1.0]), 0.5);
        assert_eq!(self::motif(&striped(0.0, true), Laid::Front).tone(&[0.9, 0.0, 0.1], &[1.0, 0.0, 0.0]), 0.0);
    }
}
