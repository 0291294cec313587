//! A style's picture as a texture: its statistics at the size at which views show it.

use super::given::Style;
use super::plan::world_per_px;
use crate::objective::{Texture, TextureOptions};
use crate::settings::{Motif, Settings};
use crate::view::Image;
use crate::{Error, Result};

/// Views, and a picture in them, in which any style's lines are large enough, px a side.
const LARGE_PX: usize = 512;
/// The longest side that a texture is taken from, px.
const MOST_PX: f64 = 4096.0;
/// Largest side of a style's picture on the surface, world units.
const LARGEST_WORLD: f64 = 4.0;

/// What views of these settings can show of a style; none where its lines are too small for that and its tones have to do.
///
/// # Errors
/// [`Error::Picture`] for a picture without lines, [`Error::Setting`] for `style_size` where there are no tones either.
pub(super) fn texture(style: &Style, settings: &Settings) -> Result<Option<Texture>> {
    let at = |side_world: f64| of_side(style, side_world / world_per_px(settings), settings.size);
    if let Ok(texture) = at(settings.style_size) {
        return Ok(Some(texture));
    }
    of_side(style, LARGE_PX as f64, LARGE_PX)?;
    if settings.motif != Motif::Off {
        return Ok(None);
    }
    let larger = (1..20).map(|k| (100.0 * settings.style_size * 1.25f64.powi(k)).ceil() / 100.0);
    let works = larger.take_while(|&side| side <= LARGEST_WORLD).find(|&side| at(side).is_ok());
    let what = works.map_or("give a picture of larger lines".to_owned(), |side| format!("use {side} or more"));
    let problem = format!("{} is too small for the style's texture to show", settings.style_size);
    Err(Error::setting("style_size", problem, format!("{what}, or motif box or front")))
}

/// The statistics of a style's picture whose shorter side is `side_px` in a view of `view_px`.
fn of_side(style: &Style, side_px: f64, view_px: usize) -> Result<Texture> {
    let sides = [style.ink.width as f64, style.ink.height as f64];
    let scale = side_px / sides[0].min(sides[1]);
    // The middle of a picture that is longer than any view.
    let [width, height] = sides.map(|side| side.min(MOST_PX / scale));
    let [x, y] = [(sides[0] - width) / 2.0, (sides[1] - height) / 2.0];
    let [across, down] = [width, height].map(|side| (side * scale).round() as usize);
    let shown: Image = style.ink.window([x, y, x + width, y + height], across, down);
    Texture::of(&style.name, &shown, &TextureOptions::for_view(view_px))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Pattern;
    use crate::settings::{Preset, Task};

    fn chequered(width: usize, height: usize, square: usize) -> Style {
        let ink = |i: usize| ((i % width / square + i / width / square) % 2) as f32;
        let ink = Image { width, height, data: (0..width * height).map(ink).collect() };
        Style { name: "squares.png".into(), ink, tiles: false }
    }

    fn settings(style_size: f64, motif: Motif) -> Settings {
        Settings { style_size, motif, size: 192, ..Task::Fill.preset(Preset::Best) }
    }

    #[test]
    fn pictures_of_any_shape_have_one_at_any_size_that_shows_it() {
        for style in [chequered(2000, 2000, 250), chequered(9000, 30, 10), chequered(8, 8, 1)] {
            for size in [0.7, 1.2, 4.0] {
                let sides = [style.ink.width, style.ink.height];
                assert!(texture(&style, &settings(size, Motif::Off)).unwrap().is_some(), "{sides:?} {size}");
            }
        }
    }

    #[test]
    fn what_is_too_small_leaves_its_tones_or_names_the_size_that_works() {
        let ink = Pattern::Petals.picture(512);
        let petals = Style { name: "petals".into(), ink, tiles: true };
        for style in [petals, chequered(2000, 2000, 250)] {
            for size in [0.1, 0.3] {
                assert_eq!(texture(&style, &settings(size, Motif::Box)), Ok(None));
                let Err(Error::Setting { name, remedy, .. }) = texture(&style, &settings(size, Motif::Off)) else {
                    panic!("{size} shows a texture")
                };
                assert_eq!(name, "style_size");
                let works = remedy.split(' ').nth(1).and_then(|word| word.parse().ok()).expect("a size that works");
                assert!(works > size && works < 1.2, "{works}");
                assert!(texture(&style, &settings(works, Motif::Off)).unwrap().is_some(), "{works}");
            }
        }
        let blank = Style { ink: Image::new(64, 64), ..chequered(64, 64, 8) };
        for (size, motif) in [(0.1, Motif::Box), (1.2, Motif::Off)] {
            assert!(matches!(texture(&blank, &settings(size, motif)), Err(Error::Picture { .. })));
        }
    }
}
