//! What a picture's alpha says: nothing, where a drawing was cut out, or the drawing itself.

use super::Picture;
use super::colour::{apart, luma, mean};

/// A picture of which a smaller share is transparent is opaque: stray pixels, rounded corners of a window.
const LEAST_TRANSPARENT: f64 = 0.01;
/// What is this opaque, of the most opaque there is, shows its colour unmixed.
const SOLID: f32 = 0.9;
/// Where a smaller share of what is seen is solid, or within the solid away from its edges, there is too little to go by.
const LEAST_SOLID: f64 = 0.1;
/// Lumas within this range are one shade.
const ONE_SHADE: f32 = 0.25;
/// As light as paper.
const WHITE: f32 = 0.9;
/// Colours at least this far from white paper are drawn on it.
const COLOURED: f32 = 0.12;

/// A picture that is transparent in part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutOut {
    /// The one colour of all that is seen, encoded, if there is but one: then alpha is the drawing.
    pub shade: Option<[f32; 3]>,
}

impl Picture {
    /// Whether something was cut out: it is transparent in part.
    pub fn is_cut_out(&self) -> bool {
        CutOut::of(self).is_some()
    }
}

impl CutOut {
    /// `None` for an opaque picture.
    pub fn of(picture: &Picture) -> Option<CutOut> {
        let pixels = picture.rgba();
        let count = pixels.len() / 4;
        let alpha = |i: usize| f32::from(pixels[4 * i + 3]) / 255.0;
        let transparent = (0..count).filter(|&i| alpha(i) < 0.5).count();
        if (transparent as f64) < LEAST_TRANSPARENT * count as f64 {
            return None;
        }
        // Colours of half-transparent pixels are not to be trusted: programs mix them with what was behind.
        let most = (0..count).map(alpha).fold(0.0, f32::max);
        let visible: Vec<usize> = (0..count).filter(|&i| alpha(i) > 0.5 * most).collect();
        let enough = |some: &Vec<usize>| some.len() as f64 >= LEAST_SOLID * visible.len() as f64;
        let (width, height) = (picture.width(), picture.height());
        let inner = |i: usize| {
            let (x, y) = (i % width, i / width);
            let beside = [i.wrapping_sub(1), i + 1, i.wrapping_sub(width), i + width];
            let there = [x > 0, x + 1 < width, y > 0, y + 1 < height];
            (0..4).all(|k| !there[k] || alpha(beside[k]) >= SOLID * most)
        };
        let choose = |from: &[usize], chosen: &dyn Fn(usize) -> bool| -> Vec<usize> {
            from.iter().copied().filter(|&i| chosen(i)).collect()
        };
        let mut core = choose(&visible, &|i| alpha(i) == most);
        if !enough(&core) {
            core = choose(&visible, &|i| alpha(i) >= SOLID * most);
        }
        let within = choose(&core, &inner);
        if enough(&within) {
            core = within;
        }
        let colours: Vec<[f32; 3]> =
            core.iter().map(|&i| [0, 1, 2].map(|c| f32::from(pixels[4 * i + c]) / 255.0)).collect();
        let lumas = || colours.iter().map(|&colour| luma(colour));
        let range = lumas().fold(0.0, f32::max) - lumas().fold(1.0, f32::min);
        let on_white = lumas().filter(|&luma| luma > WHITE).count() * 2 > colours.len()
            && colours.iter().any(|&colour| apart(colour, [1.0; 3]) > COLOURED);
        let one = most > 0.0 && range < ONE_SHADE && !on_white;
        Some(CutOut { shade: one.then(|| mean(colours.iter().copied())) })
    }
}
