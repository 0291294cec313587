//! How wide a wire may get, in the world.

use crate::optimize::WidthBounds;
use crate::picture::Ink;
use crate::settings::{Settings, Width};
use crate::view::Target;

/// A wire of constant width as a share of the strokes it draws: two strands side by side still pass for one stroke, and a
/// single one does not look thin beside it.
const STROKE_SHARE: f64 = 0.75;

/// The bounds that the settings ask for; `px` is a pixel of a 256 px picture in the world. A wire of constant width follows
/// the strokes of the `targets` where the settings leave a range.
pub(super) fn width_bounds(targets: &[Target], px: f64, settings: &Settings) -> WidthBounds {
    let Settings { min_width, max_width, .. } = *settings;
    let [min, max] = match settings.width {
        Width::Varying => [min_width, max_width],
        Width::Constant => [(STROKE_SHARE * stroke_px(targets)).clamp(min_width, max_width); 2],
    };
    WidthBounds { min_world: min * px, max_world: max * px }
}

/// Mean width of the strokes, px of a 256 px picture: ink over the length of its middle lines.
fn stroke_px(targets: &[Target]) -> f64 {
    let (mut ink, mut middle) = (0.0, 0.0);
    for target in targets {
        let scale = 256.0 / target.ink.width.max(target.ink.height) as f64;
        ink += scale * target.ink.data.iter().map(|&ink| f64::from(ink)).sum::<f64>();
        middle += target.ink.threshold(0.5).thin().count() as f64;
    }
    ink / middle.max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Image, View};

    #[test]
    fn a_constant_wire_follows_the_strokes_within_its_bounds() {
        let mut ink = Image::new(256, 256);
        (0..200).for_each(|x| (100..104).for_each(|y| ink.data[256 * y + x + 20] = 1.0));
        let view = View::canonical(2.56, 256)[0].clone();
        let targets = [Target { view, ink }];
        let bounds = |settings: Settings| {
            let WidthBounds { min_world, max_world } = width_bounds(&targets, 0.01, &settings);
            [min_world, max_world]
        };
        let constant = Settings { width: Width::Constant, ..Settings::default() };
        let [min, max] = bounds(constant.clone());
        assert!(min == max && (min - 0.03).abs() < 0.002, "three quarters of 4 px: {min}");
        assert_eq!(bounds(Settings { max_width: 2.0, ..constant }), [0.02; 2]);
        assert_eq!(bounds(Settings { min_width: 1.0, max_width: 5.0, ..Settings::default() }), [0.01, 0.05]);
    }
}
