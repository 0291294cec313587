//! Drawings for the tests of this room.

use crate::view::{Image, Target, View};

/// Picture height in world units used by these tests.
pub const HEIGHT_WORLD: f64 = 1.375;

/// A 128 px picture of the points (x, y) in 0..1 for which `inked` holds.
pub fn picture(inked: impl Fn(f64, f64) -> bool) -> Image {
    let mut image = Image::new(128, 128);
    for (i, value) in image.data.iter_mut().enumerate() {
        let (x, y) = ((i % 128) as f64 + 0.5, (i / 128) as f64 + 0.5);
        *value = f32::from(inked(x / 128.0, y / 128.0));
    }
    image
}

/// Drawings as front, side and top.
pub fn targets(drawings: Vec<Image>) -> Vec<Target> {
    let views = View::canonical(HEIGHT_WORLD, 128);
    drawings.into_iter().zip(views).map(|(ink, view)| Target { view, ink }).collect()
}

/// An H, an O and a cross.
pub fn letters() -> Vec<Target> {
    let within = |x: f64, y: f64| (0.1..0.9).contains(&x) && (0.1..0.9).contains(&y);
    let h = picture(|x, y| within(x, y) && ((x - 0.5).abs() > 0.33 || (y - 0.5).abs() < 0.035));
    let o = picture(|x, y| ((x - 0.5).hypot(y - 0.5) - 0.365).abs() < 0.035);
    let cross = picture(|x, y| within(x, y) && ((x - y).abs() < 0.05 || (x + y - 1.0).abs() < 0.05));
    targets(vec![h, o, cross])
}
