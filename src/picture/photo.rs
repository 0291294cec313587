//! A photograph as it is looked at: colours in which equal distances look equally different, at a working size.

use super::Picture;
use super::colour::oklab_of_light;
use crate::view::Image;

/// Longest side of a photograph as it is cut out and drawn, px.
pub const PHOTO_PX: usize = 512;

/// Colours of a photograph, at most [`PHOTO_PX`] a side.
#[derive(Debug, Clone, PartialEq)]
pub struct Photo {
    /// Name of the picture it was made from.
    pub name: String,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Lightness 0 to 100, and how red (or green) and yellow (or blue), about -60 to 60: Oklab (Ottosson 2020) times 100,
    /// hues times 2 more, which comes near to what people see as one step. Rows from the top left.
    pub lab: Vec<[f32; 3]>,
    /// Pixels of it a pixel of the picture.
    pub scale: f64,
}

impl Photo {
    /// Averaged down to the working size; what is transparent is laid on white.
    pub fn of(picture: &Picture) -> Photo {
        let (width, height) = (picture.width(), picture.height());
        let scale = (PHOTO_PX as f64 / width.max(height) as f64).min(1.0);
        let [small_width, small_height] = [width, height].map(|side| ((side as f64 * scale).round() as usize).max(1));
        let channel = |c: usize| {
            let value = |p: &[u8]| 1.0 + (f32::from(p[c]) / 255.0 - 1.0) * f32::from(p[3]) / 255.0;
            let image = Image { width, height, data: picture.rgba().chunks_exact(4).map(value).collect() };
            if scale < 1.0 { image.resized(small_width, small_height) } else { image }
        };
        let [red, green, blue] = [0, 1, 2].map(channel);
        let lab = (0..red.data.len()).map(|i| lab([red.data[i], green.data[i], blue.data[i]])).collect();
        Photo { name: picture.name().to_owned(), width: small_width, height: small_height, lab, scale }
    }

    /// One of the three channels.
    pub fn channel(&self, channel: usize) -> Image {
        Image { width: self.width, height: self.height, data: self.lab.iter().map(|lab| lab[channel]).collect() }
    }
}

/// From encoded values, 0 to 1.
fn lab(rgb: [f32; 3]) -> [f32; 3] {
    let [l, a, b] = oklab_of_light(rgb.map(light));
    [100.0 * l, 200.0 * a, 200.0 * b]
}

/// Light of a value encoded as sRGB, from a table with linear steps between.
fn light(value: f32) -> f32 {
    const STEPS: usize = 1024;
    static TABLE: std::sync::OnceLock<Vec<f32>> = std::sync::OnceLock::new();
    let exact = |i: usize| {
        let value = i as f32 / STEPS as f32;
        if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    };
    let table = TABLE.get_or_init(|| (0..=STEPS + 1).map(exact).collect());
    let at = value.clamp(0.0, 1.0) * STEPS as f32;
    let low = at as usize;
    table[low] + (at - low as f32) * (table[low + 1] - table[low])
}
