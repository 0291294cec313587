//! Pictures as people bring them, and the ink in them.
//!
//! A [`Picture`] is decoded colour, wherever it came from. [`ink`] finds what is drawn: ground 0, ink 1, soft edges kept.

use super::Mask;
use super::colour::{apart, dominant, luma, mean};
use super::cutout::CutOut;
use super::sheet::{is_rim, sheet};
use super::spread::{otsu, quantile};
use crate::view::{Image, MAX_PICTURE_PX};
use crate::{Error, Result};

/// Most pixels a picture may have.
pub const MAX_PICTURE_PIXELS: usize = 50_000_000;

/// A decoded picture, 8 bits a channel, alpha not multiplied in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    name: String,
    width: usize,
    height: usize,
    rgba: Vec<u8>,
    /// Width and height before it was averaged down.
    given: [usize; 2],
    /// See [`Picture::is_measured`].
    measured: bool,
    notes: Vec<String>,
}

/// Which of two shades is the drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum Polarity {
    /// Guess: the border is ground.
    #[default]
    #[serde(rename = "auto")]
    Auto,
    /// Dark ink on light ground.
    #[serde(rename = "dark")]
    DarkInk,
    /// Light ink on dark ground.
    #[serde(rename = "light")]
    LightInk,
}

impl Picture {
    /// From rows of red, green, blue, alpha, top left first. Large pictures are averaged down to at most
    /// [`MAX_PICTURE_PX`] a side.
    ///
    /// # Errors
    /// [`Error::Picture`] if there are no pixels, too many, or not four bytes for each.
    pub fn new(name: impl Into<String>, width: usize, height: usize, rgba: Vec<u8>) -> Result<Picture> {
        let name = name.into();
        check_size(&name, width, height)?;
        if rgba.len() != width * height * 4 {
            let problem = format!("{} bytes of colour for {width} x {height} px", rgba.len());
            return Err(Error::picture(name, problem, "give four bytes a pixel"));
        }
        let given = [width, height];
        let picture = Picture { name, width, height, rgba, given, measured: false, notes: Vec::new() };
        let factor = width.max(height).div_ceil(MAX_PICTURE_PX);
        Ok(if factor > 1 { picture.averaged(factor) } else { picture })
    }

    /// The width and height it came with, if it was averaged down from a larger picture.
    pub fn shrunk_from(&self) -> Option<[usize; 2]> {
        (self.given != [self.width, self.height]).then_some(self.given)
    }

    /// With what is known of the file: its size, and whether its values may be a measure.
    #[must_use]
    pub fn as_given(self, given: [usize; 2], measured: bool) -> Picture {
        Picture { given, measured, ..self }
    }

    /// Whether it comes from values of 16 bits: as a depth picture it may tell distances.
    pub fn is_measured(&self) -> bool {
        self.measured
    }

    /// With a sentence on what was left out of it.
    #[must_use]
    pub fn noted(mut self, note: &str) -> Picture {
        self.notes.push(note.to_owned());
        self
    }

    /// What a person should know about how it was read, in plain words.
    pub fn notes(&self) -> Vec<String> {
        let shrunk = self
            .shrunk_from()
            .map(|[width, height]| format!("{}: {width} x {height} px is more than is needed, scaled down", self.name));
        shrunk.into_iter().chain(self.notes.iter().map(|note| format!("{}: {note}", self.name))).collect()
    }

    /// File or pad name as the person knows it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Red, green, blue, alpha, row by row.
    pub fn rgba(&self) -> &[u8] {
        &self.rgba
    }

    /// Squares of `factor` pixels made one, colours weighted by their alpha. Leftover columns and rows make smaller cells.
    pub(super) fn averaged(&self, factor: usize) -> Picture {
        let (width, height) = (self.width.div_ceil(factor), self.height.div_ceil(factor));
        let mut rgba = Vec::with_capacity(width * height * 4);
        for y in 0..height {
            for x in 0..width {
                let (mut sums, mut count) = ([0u64; 4], 0u64);
                for sy in y * factor..self.height.min((y + 1) * factor) {
                    for sx in x * factor..self.width.min((x + 1) * factor) {
                        let pixel = &self.rgba[(sy * self.width + sx) * 4..][..4];
                        let alpha = u64::from(pixel[3]);
                        for c in 0..3 {
                            sums[c] += u64::from(pixel[c]) * alpha;
                        }
                        sums[3] += alpha;
                        count += 1;
                    }
                }
                let alpha = sums[3].max(1);
                rgba.extend([0, 1, 2].map(|c| ((sums[c] + alpha / 2) / alpha) as u8));
                rgba.push(((sums[3] + count / 2) / count) as u8);
            }
        }
        Picture { width, height, rgba, name: self.name.clone(), notes: self.notes.clone(), ..*self }
    }
}

/// Whether a picture of this size is one at all.
fn check_size(name: &str, width: usize, height: usize) -> Result<()> {
    if width == 0 || height == 0 {
        return Err(Error::picture(name, "has no pixels", "choose another picture"));
    }
    if width.saturating_mul(height) > MAX_PICTURE_PIXELS {
        let problem = format!("{width} x {height} px is more than can be read");
        let remedy = format!("scale it down, {MAX_PICTURE_PX} px a side are plenty");
        return Err(Error::picture(name, problem, remedy));
    }
    Ok(())
}

/// Least difference of shade between ink and ground, of the full range.
const MIN_CONTRAST: f32 = 0.08;

/// Lumas that differ less than this may be of a coloured drawing whose colours differ this many times as much.
const PALE: f32 = 0.2;
const MORE_IN_COLOUR: f32 = 1.5;

/// Fewest pixels that make a drawing.
const MIN_INK_PIXELS: usize = 4;

/// Share of the picture that a dark and a light sheet on another ground cover.
const LEAST_SHEET: [f64; 2] = [0.5, 0.3];

/// What was taken for the ground of a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ground {
    /// Whether the ink is darker or lighter than it; never [`Polarity::Auto`].
    pub polarity: Polarity,
    /// Why.
    pub because: Because,
}

impl Ground {
    /// Which is the ground and why, in a sentence.
    pub fn words(&self) -> String {
        let shade = if self.polarity == Polarity::LightInk { "dark" } else { "light" };
        match self.because {
            Because::Transparent => "what is transparent is ground".into(),
            Because::Border => format!("the {shade} shade is ground: the border is of it"),
            Because::Most => format!("the {shade} colour is ground: most of the picture is of it"),
            Because::Sheet => format!("the {shade} sheet is ground, and what is round it was left out"),
            Because::Photograph => "it is a photograph: the lines of its object are drawn".into(),
            Because::Doubtful => {
                "it is a photograph: the lines of what stands out are drawn, and it is not clear that this is \
                                  what was meant; cut it out, or crop the picture to it"
                    .into()
            }
            Because::Said => format!("the {shade} shade is ground, as was asked for"),
        }
    }
}

/// Why something was taken for the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Because {
    /// It is transparent.
    Transparent,
    /// The border is of that shade.
    Border,
    /// Most of the picture is of that shade or colour.
    Most,
    /// It is a sheet with marks on it; what is round it is neither.
    Sheet,
    /// It is a photograph: everything but its object.
    Photograph,
    /// Likewise, and it is not clear what its object is.
    Doubtful,
    /// A person said which shade is ink.
    Said,
}

/// The ink of a picture, 0 (ground) to 1 (ink), and its ground.
///
/// Transparent pixels are ground. If what is not transparent has one shade, its alpha is the drawing, whatever colour its
/// soft edges have; otherwise it is laid on white (dark ink, also what `Auto` means then) or on black (light ink). In opaque
/// pictures a marked [`sheet`] is ground, else the border's shade, else, where that is undecided, what most of the picture
/// is. Ink and ground of like luma are told apart by colour: along the line from the dominant colour to that of what stands
/// out. Shades are stretched from the paper's level, followed over the picture so that uneven light does no harm, to the
/// ink's; clean pictures keep their antialiasing as it is.
///
/// # Errors
/// [`Error::Picture`] if the picture is blank, fully inked or holds less ink than a stroke.
pub fn ink(picture: &Picture, polarity: Polarity) -> Result<(Image, Ground)> {
    let fail = |problem: &str, remedy: &str| Err(Error::picture(&picture.name, problem, remedy));
    let (width, height) = (picture.width, picture.height);
    let asked = polarity;
    let cut = CutOut::of(picture);
    let shade = cut.and_then(|cut| cut.shade);
    // Transparent pictures are laid on the ground that their ink does not have.
    let paper = f32::from(asked != Polarity::LightInk);
    let pixel = |p: &[u8]| {
        let alpha = if cut.is_some() { f32::from(p[3]) / 255.0 } else { 1.0 };
        [0, 1, 2].map(|c| paper + (f32::from(p[c]) / 255.0 - paper) * alpha)
    };
    let colours: Vec<[f32; 3]> = picture.rgba.chunks_exact(4).map(pixel).collect();
    let image = |data: Vec<f32>| Image { width, height, data };
    let lumas = || colours.iter().map(|&colour| luma(colour));
    let mut inside = None;
    let (polarity, because) = match (asked, shade) {
        (Polarity::Auto, Some(shade)) if luma(shade) > 0.5 => (Polarity::LightInk, Because::Transparent),
        (Polarity::Auto, _) if cut.is_some() => (Polarity::DarkInk, Because::Transparent),
        _ => {
            let of = |light: bool| if light { Polarity::DarkInk } else { Polarity::LightInk };
            let found = if cut.is_some() { None } else { sheet(&image(lumas().collect()), LEAST_SHEET) };
            match (asked, found) {
                (_, Some((mask, light))) if asked == Polarity::Auto || asked == of(light) => {
                    inside = Some(mask);
                    (of(light), Because::Sheet)
                }
                (Polarity::Auto, _) => guess_polarity(&lumas().collect::<Vec<_>>(), width, height),
                _ => (asked, Because::Said),
            }
        }
    };
    let mut ground = Ground { polarity, because };
    let mut found = image(match shade {
        Some(_) => picture.rgba.chunks_exact(4).map(|p| f32::from(p[3]) / 255.0).collect(),
        None if polarity == Polarity::LightInk => lumas().collect(),
        None => lumas().map(|luma| 1.0 - luma).collect(),
    });
    let mut contrast = stretch(&mut found, inside.as_ref());
    if shade.is_none() && contrast < PALE {
        let (strengths, natural) = coloured(&colours, asked);
        let mut other = image(strengths);
        let more = stretch(&mut other, None);
        if more > MORE_IN_COLOUR * contrast {
            (found, contrast) = (other, more);
            let because = if cut.is_some() { because } else { Because::Most };
            ground = Ground { polarity: natural, because };
        }
    }
    if contrast == 0.0 {
        // One shade: black is ink, unless light ink was asked for.
        let full = lumas().map(|luma| if asked == Polarity::LightInk { luma } else { 1.0 - luma }).sum::<f32>();
        if full > 0.5 * colours.len() as f32 {
            return fail("is inked all over", "use a drawing with ground around its ink");
        }
        return fail("is blank", "draw something, with more contrast if it is faint");
    }
    let inked = found.data.iter().filter(|&&value| value > 0.5).count();
    if inked < MIN_INK_PIXELS {
        let pixels = if inked == 1 { "one pixel".to_owned() } else { format!("{inked} pixels") };
        return fail(&format!("has only {pixels} of ink"), "draw at least a short line");
    }
    if inked as f64 > 0.985 * found.data.len() as f64 {
        return fail("is inked all over", "use a drawing with ground around its ink, or the other polarity");
    }
    Ok((found, ground))
}

/// How far each pixel is on the way from the dominant colour to that of what stands out from it, in units of the full range,
/// and which polarity that is; the other way round if the other one is `asked` for.
fn coloured(colours: &[[f32; 3]], asked: Polarity) -> (Vec<f32>, Polarity) {
    let ground = dominant(colours);
    let off = || colours.iter().map(|&colour| apart(colour, ground));
    let threshold = otsu(off());
    let ink = mean(colours.iter().copied().filter(|&colour| apart(colour, ground) > threshold));
    let natural = if luma(ink) < luma(ground) { Polarity::DarkInk } else { Polarity::LightInk };
    let (from, to, polarity) = match asked {
        Polarity::Auto => (ground, ink, natural),
        asked if asked == natural => (ground, ink, asked),
        asked => (ink, ground, asked),
    };
    let way = apart(from, to).max(1e-6);
    let along = |colour: [f32; 3]| (0..3).map(|c| (colour[c] - from[c]) * (to[c] - from[c])).sum::<f32>() / (3.0 * way);
    (colours.iter().map(|&colour| along(colour)).collect(), polarity)
}

/// Dark ink if most of the border is light, or, where the border is undecided, most of the picture.
fn guess_polarity(lumas: &[f32], width: usize, height: usize) -> (Polarity, Because) {
    let threshold = otsu(lumas.iter().copied());
    let light_share = |chosen: &dyn Fn(usize) -> bool| {
        let (mut light, mut all) = (0usize, 0usize);
        for i in (0..lumas.len()).filter(|&i| chosen(i)) {
            light += usize::from(lumas[i] > threshold);
            all += 1;
        }
        light as f64 / all as f64
    };
    let border = light_share(&|i| is_rim(i, width, height, (width.min(height) / 50).max(1)));
    let undecided = (0.35..=0.65).contains(&border);
    let light = if undecided { light_share(&|_| true) } else { border };
    let because = if undecided { Because::Most } else { Because::Border };
    (if light >= 0.5 { Polarity::DarkInk } else { Polarity::LightInk }, because)
}

/// Stretches strengths so that ground is 0 and ink 1; the contrast there was. 0, and nothing done, if they hardly differ.
/// What is not `inside` is no ink.
fn stretch(image: &mut Image, inside: Option<&Mask>) -> f32 {
    let within = |i: usize| inside.is_none_or(|inside| inside.data[i]);
    let threshold = otsu((0..image.data.len()).filter(|&i| within(i)).map(|i| image.data[i]));
    let ground = ground_level(image, threshold, &within);
    let mut strokes: Vec<f32> = Vec::new();
    let mut noise: Vec<f32> = Vec::new();
    for i in (0..image.data.len()).filter(|&i| within(i)) {
        let above = image.data[i] - ground.data[i];
        if image.data[i] > threshold { strokes.push(above) } else { noise.push(above.abs()) }
    }
    // Hair lines seldom fill a pixel, so ink is the upper end of what is drawn, not its middle.
    let contrast = quantile(&mut strokes, 0.8);
    if strokes.is_empty() || noise.is_empty() || contrast < MIN_CONTRAST {
        return 0.0;
    }
    // Three standard deviations of the paper's grain (1.48 median deviations each, were it Gaussian); 0 when clean.
    let grain = (3.0 * 1.4826 * quantile(&mut noise, 0.5)).min(0.3 * contrast);
    for (i, (value, ground)) in image.data.iter_mut().zip(&ground.data).enumerate() {
        let strength = ((*value - ground - grain) / (contrast - grain)).clamp(0.0, 1.0);
        *value = if within(i) { strength } else { 0.0 };
    }
    contrast
}

/// The paper's level at each pixel: the median of what is below `threshold` in tiles of a sixteenth of the picture,
/// tiles full of ink or outside filled in from their neighbours, bilinear in between.
fn ground_level(image: &Image, threshold: f32, within: &dyn Fn(usize) -> bool) -> Image {
    let side = image.width.max(image.height).div_ceil(16);
    let (columns, rows) = (image.width.div_ceil(side), image.height.div_ceil(side));
    let mut below = Vec::new();
    let mut tiles: Vec<Option<f32>> = Vec::with_capacity(columns * rows);
    for tile in 0..columns * rows {
        let (left, top) = (tile % columns * side, tile / columns * side);
        let (right, bottom) = (image.width.min(left + side), image.height.min(top + side));
        below.clear();
        for y in top..bottom {
            let row = (y * image.width + left..y * image.width + right).filter(|&i| within(i));
            below.extend(row.map(|i| image.data[i]).filter(|&value| value <= threshold));
        }
        let enough = below.len() * 4 >= (right - left) * (bottom - top);
        tiles.push(enough.then(|| quantile(&mut below, 0.5)));
    }
    while tiles.iter().any(Option::is_none) {
        let known = tiles.clone();
        for (tile, level) in tiles.iter_mut().enumerate().filter(|(_, level)| level.is_none()) {
            let (x, y) = (tile % columns, tile / columns);
            let (mut sum, mut count) = (0.0, 0.0);
            for ny in y.saturating_sub(1)..rows.min(y + 2) {
                for nx in x.saturating_sub(1)..columns.min(x + 2) {
                    if let Some(near) = known[ny * columns + nx] {
                        sum += near;
                        count += 1.0;
                    }
                }
            }
            *level = (count > 0.0).then_some(sum / count);
        }
        if known.iter().all(Option::is_none) {
            tiles.fill(Some(0.0));
        }
    }
    let tiles = Image { width: columns, height: rows, data: tiles.into_iter().flatten().collect() };
    let mut level = Image::new(image.width, image.height);
    for (i, value) in level.data.iter_mut().enumerate() {
        let centre = |p: usize| (p as f32 + 0.5) / side as f32;
        *value = tiles.sample(centre(i % image.width), centre(i / image.width));
    }
    level
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    const SIDE: usize = 96;

    /// Exact coverage of a ring, 0 to 1, in a picture `SIDE` px square.
    fn ring(x: usize, y: usize) -> f32 {
        let (dx, dy) = (x as f32 + 0.5 - 48.0, y as f32 + 0.5 - 48.0);
        (3.5 - (dx.hypot(dy) - 30.0).abs()).clamp(0.0, 1.0)
    }

    fn picture(pixel: impl Fn(usize, usize) -> [u8; 4]) -> Picture {
        let rgba = (0..SIDE * SIDE).flat_map(|i| pixel(i % SIDE, i / SIDE)).collect();
        Picture::new("drawing.png", SIDE, SIDE, rgba).unwrap()
    }

    fn grey(level: f32) -> [u8; 4] {
        let byte = (level * 255.0).round() as u8;
        [byte, byte, byte, 255]
    }

    /// Mean absolute difference from the ring.
    fn difference(image: &Image) -> f32 {
        let each = image.data.iter().enumerate().map(|(i, value)| (value - ring(i % SIDE, i / SIDE)).abs());
        each.sum::<f32>() / (SIDE * SIDE) as f32
    }

    fn found(pixel: impl Fn(usize, usize) -> [u8; 4]) -> (f32, Polarity) {
        let (image, ground) = ink(&picture(pixel), Polarity::Auto).unwrap();
        assert!(image.data.iter().all(|value| (0.0..=1.0).contains(value)));
        (difference(&image), ground.polarity)
    }

    #[test]
    fn clean_pictures_keep_their_edges() {
        let (error, polarity) = found(|x, y| grey(1.0 - ring(x, y)));
        assert!(error < 2e-3 && polarity == Polarity::DarkInk, "{error}");
        let (error, polarity) = found(|x, y| grey(ring(x, y)));
        assert!(error < 2e-3 && polarity == Polarity::LightInk, "{error}");
        let (error, _) = found(|x, y| {
            let mix = |ink: f32| (255.0 + (ink - 255.0) * ring(x, y)).round() as u8;
            [mix(200.0), mix(30.0), mix(40.0), 255]
        });
        assert!(error < 3e-3, "coloured ink: {error}");
        // Sibling: a ring drawn a pixel further is told apart.
        let (error, _) = found(|x, y| grey(1.0 - ring((x + 1) % SIDE, y)));
        assert!(error > 0.02, "{error}");
    }

    #[test]
    fn the_polarity_can_be_given() {
        let dark = picture(|x, y| grey(1.0 - ring(x, y)));
        let (image, ground) = ink(&dark, Polarity::LightInk).unwrap();
        assert_eq!(ground.polarity, Polarity::LightInk);
        assert!((image.at(48, 48), image.at(18, 48)) == (1.0, 0.0), "the ground is now the ink");
    }

    #[test]
    fn transparent_is_ground() {
        let alpha = |x, y| (255.0 * ring(x, y)).round() as u8;
        let (error, polarity) = found(|x, y| [0, 0, 0, alpha(x, y)]);
        assert!(error < 2e-3 && polarity == Polarity::DarkInk, "alpha alone, black: {error}");
        let (error, polarity) = found(|x, y| [255, 255, 255, alpha(x, y)]);
        assert!(error < 2e-3 && polarity == Polarity::LightInk, "alpha alone, white: {error}");
        // Black lines with white between them, cut out in a disc: the white is no ink.
        let inside = |x: usize, y: usize| (x as f32 - 47.5).hypot(y as f32 - 47.5) < 40.0;
        let (error, polarity) = found(|x, y| {
            let [r, g, b, _] = grey(1.0 - ring(x, y));
            [r, g, b, if inside(x, y) { 255 } else { 0 }]
        });
        assert!(error < 2e-3 && polarity == Polarity::DarkInk, "cut out: {error}");
        // Hidden colour under alpha 0 does not matter.
        let (error, _) = found(|x, y| if ring(x, y) > 0.0 { [0, 0, 0, alpha(x, y)] } else { [90, 200, 7, 0] });
        assert!(error < 2e-3, "{error}");
    }

    #[test]
    fn ink_is_told_by_colour_where_lumas_are_alike() {
        let mixed = |ground: [u8; 3], drawn: [u8; 3], noise: f32| {
            let mut rng = Rng::new(7, 0);
            let rgba: Vec<u8> = (0..SIDE * SIDE)
                .flat_map(|i| {
                    let share = ring(i % SIDE, i / SIDE);
                    let grain = noise * (rng.unit() - 0.5) as f32;
                    let mix =
                        |c: usize| (f32::from(ground[c]) * (1.0 - share) + f32::from(drawn[c]) * share + grain).round();
                    [mix(0) as u8, mix(1) as u8, mix(2) as u8, 255]
                })
                .collect();
            ink(&Picture::new("drawing.png", SIDE, SIDE, rgba).unwrap(), Polarity::Auto).unwrap()
        };
        for (ground, colour, polarity) in [
            ([255, 255, 255], [255, 255, 0], Polarity::DarkInk),
            ([255, 255, 255], [140, 255, 255], Polarity::DarkInk),
            ([0, 0, 0], [0, 0, 255], Polarity::LightInk),
            ([180, 140, 100], [235, 120, 30], Polarity::DarkInk),
            ([210, 60, 50], [40, 130, 60], Polarity::LightInk),
        ] {
            let (image, found) = mixed(ground, colour, 0.0);
            assert!(difference(&image) < 4e-3, "{colour:?} on {ground:?}: {}", difference(&image));
            assert_eq!(found.polarity, polarity, "{colour:?} on {ground:?}");
            let (image, _) = mixed(ground, colour, 8.0);
            assert!(difference(&image) < 0.04, "{colour:?} on grainy {ground:?}: {}", difference(&image));
        }
    }

    #[test]
    fn the_other_of_two_colours_can_be_asked_for() {
        let yellow = picture(|x, y| [255, 255, (255.0 * (1.0 - ring(x, y))) as u8, 255]);
        let (dark, _) = ink(&yellow, Polarity::DarkInk).unwrap();
        let (light, ground) = ink(&yellow, Polarity::LightInk).unwrap();
        assert_eq!((dark.at(48, 48), dark.at(18, 48)), (0.0, 1.0));
        assert_eq!((light.at(48, 48), light.at(18, 48), ground.polarity), (1.0, 0.0, Polarity::LightInk));
    }

    #[test]
    fn a_sheet_on_a_desk_is_ground_and_the_desk_is_not() {
        // Corners of the sheet, clockwise: straight, askew, in perspective, on a corner.
        let sheets = [
            [[6.0, 9.0], [90.0, 9.0], [90.0, 88.0], [6.0, 88.0]],
            [[20.0, 4.0], [92.0, 16.0], [80.0, 93.0], [5.0, 80.0]],
            [[14.0, 8.0], [84.0, 8.0], [94.0, 90.0], [2.0, 90.0]],
            [[48.0, 3.0], [93.0, 48.0], [48.0, 93.0], [3.0, 48.0]],
        ];
        for corners in sheets {
            let on_paper = |x: usize, y: usize| {
                (0..4).all(|k: usize| {
                    let ([ax, ay], [bx, by]): ([f32; 2], [f32; 2]) = (corners[k], corners[(k + 1) % 4]);
                    (x as f32 + 0.5 - ax) * (ay - by) + (y as f32 + 0.5 - ay) * (bx - ax) > 0.0
                })
            };
            let line = |x: usize, y: usize| (((x as f32 - 48.0).hypot(y as f32 - 48.0)) - 18.0).abs() < 2.0;
            let shade = |x: usize, y: usize| match (on_paper(x, y), line(x, y)) {
                (false, _) => 0.15,
                (true, true) => 0.1,
                (true, false) => 0.75 + 0.002 * x as f32,
            };
            let (image, ground) = ink(&picture(|x, y| grey(shade(x, y))), Polarity::Auto).unwrap();
            assert_eq!((ground.because, ground.polarity), (Because::Sheet, Polarity::DarkInk), "{corners:?}");
            let wrong = (0..SIDE * SIDE).filter(|&i| (image.data[i] > 0.5) != line(i % SIDE, i / SIDE)).count();
            assert!(wrong < 12, "{corners:?}: {wrong} px wrong");
            if corners == sheets[3] {
                continue;
            }
            // Chalk on a board in a light frame, where the board is most of the picture.
            let (image, ground) = ink(&picture(|x, y| grey(0.9 - shade(x, y))), Polarity::Auto).unwrap();
            assert_eq!(ground.because, Because::Sheet, "{corners:?}");
            assert!(image.at(30, 48) > 0.9 && image.at(48, 48) == 0.0 && ground.polarity == Polarity::LightInk);
        }
    }

    #[test]
    fn solid_things_with_holes_on_plain_ground_are_no_sheets() {
        let round = |x: usize, y: usize, r: f32| (x as f32 - 47.5).hypot(y as f32 - 47.5) < r;
        let ring = picture(|x, y| grey(f32::from(!round(x, y, 46.0) || round(x, y, 10.0))));
        let square = picture(|x, y| grey(f32::from(x.min(y) < 10 || x.max(y) > 85)));
        let corner = picture(|x, y| grey(f32::from(x > 60 && y > 40 || x < 6 || y < 4)));
        for thing in [ring, square, corner] {
            let (_, ground) = ink(&thing, Polarity::Auto).unwrap();
            assert_ne!(ground.because, Because::Sheet);
        }
    }

    #[test]
    fn soft_edges_of_cut_out_ink_may_have_any_colour_and_stray_alpha_says_nothing() {
        let alpha = |x, y| (255.0 * ring(x, y)).round() as u8;
        for edge in [[0, 0, 0], [255, 0, 255]] {
            let (error, polarity) = found(|x, y| match alpha(x, y) {
                255 => [255, 255, 255, 255],
                alpha => [edge[0], edge[1], edge[2], alpha],
            });
            assert!(error < 2e-3 && polarity == Polarity::LightInk, "edge {edge:?}: {error}");
        }
        let (error, _) = found(|x, y| [alpha(x, y), alpha(x, y), alpha(x, y), alpha(x, y)]);
        assert!(error < 2e-3, "multiplied in: {error}");
        let (error, polarity) = found(|x, y| {
            let [r, g, b, _] = grey(1.0 - ring(x, y));
            [r, g, b, if y == 0 && x < 2 { 40 } else { 255 }]
        });
        assert!(error < 2e-3 && polarity == Polarity::DarkInk, "two stray pixels: {error}");
        // Yellow lines on white paper that was cut out are drawn on it.
        let inside = |x: usize, y: usize| (x as f32 - 47.5).hypot(y as f32 - 47.5) < 44.0;
        let (error, _) = found(|x, y| [255, 255, 255 - alpha(x, y), if inside(x, y) { 255 } else { 0 }]);
        assert!(error < 4e-3, "{error}");
    }

    #[test]
    fn scans_become_ink_and_ground() {
        let mut rng = Rng::new(4, 0);
        let noise: Vec<f32> = (0..SIDE * SIDE).map(|_| (rng.unit() - 0.5) as f32 * 0.06).collect();
        // Grey paper lit from the left, grey pencil, grain.
        let scan = |x: usize, y: usize| {
            let paper = 0.9 - 0.3 * x as f32 / SIDE as f32;
            grey(paper * (1.0 - 0.65 * ring(x, y)) + noise[y * SIDE + x])
        };
        let (error, polarity) = found(scan);
        assert!(error < 0.03 && polarity == Polarity::DarkInk, "{error}");
        let (image, _) = ink(&picture(scan), Polarity::Auto).unwrap();
        let stray = (0..SIDE * SIDE).filter(|&i| ring(i % SIDE, i / SIDE) == 0.0 && image.data[i] > 0.3).count();
        assert!(stray < 5, "{stray} px of paper taken for ink");
    }

    #[test]
    fn ink_on_the_border_and_solid_areas_are_borne() {
        // A solid half that touches three borders.
        let (image, ground) = ink(&picture(|x, _| grey(if x < 30 { 0.0 } else { 1.0 })), Polarity::Auto).unwrap();
        assert_eq!((ground.polarity, image.at(5, 50), image.at(60, 50)), (Polarity::DarkInk, 1.0, 0.0));
        // A solid disc of ink, 80% of the picture's width.
        let disc = |x: usize, y: usize| (x as f32 - 47.5).hypot(y as f32 - 47.5) < 38.0;
        let (image, _) = ink(&picture(|x, y| grey(if disc(x, y) { 0.2 } else { 0.9 })), Polarity::Auto).unwrap();
        assert!(image.at(48, 48) == 1.0 && image.at(2, 2) == 0.0);
    }

    #[test]
    fn pictures_with_nothing_to_draw_say_so() {
        let problem = |pixel: &dyn Fn(usize, usize) -> [u8; 4]| {
            let error = ink(&picture(pixel), Polarity::Auto).unwrap_err();
            assert!(error.is_bad_input());
            error.to_string()
        };
        assert!(problem(&|_, _| grey(1.0)).contains("drawing.png: is blank; draw something"));
        assert!(problem(&|_, _| grey(0.0)).contains("is inked all over"));
        assert!(problem(&|_, _| [0; 4]).contains("is blank"), "nothing but transparency");
        assert!(problem(&|x, y| grey(if (x, y) == (7, 9) { 0.0 } else { 1.0 })).contains("only one pixel of ink"));
        assert!(problem(&|x, y| grey(if y == 9 && x < 3 { 0.0 } else { 1.0 })).contains("only 3 pixels of ink"));
        let faint = |x, y| grey(1.0 - 0.03 * ring(x, y));
        assert!(problem(&faint).contains("is blank"));
        let all_but_one = |x, y| grey(if (x, y) == (7, 9) { 1.0 } else { 0.0 });
        assert!(problem(&all_but_one).contains("ink"));
    }

    #[test]
    fn sizes_are_checked_and_large_pictures_averaged() {
        assert!(Picture::new("a", 0, 5, vec![]).is_err());
        assert!(Picture::new("a", 2, 2, vec![0; 15]).unwrap_err().to_string().contains("15 bytes"));
        assert!(Picture::new("a", usize::MAX, 2, vec![]).unwrap_err().to_string().contains("scale it down"));
        assert!(Picture::new("a", 20_000, 20_000, vec![]).unwrap_err().to_string().contains("20000 x 20000"));
        let (width, height) = (4500, 10);
        let rgba = (0..width * height).flat_map(|i| [if i % 3 == 0 { 255 } else { 0 }, 10, 20, 255]).collect();
        let small = Picture::new("a", width, height, rgba).unwrap();
        assert_eq!((small.width(), small.height()), (1500, 4));
        assert_eq!(small.rgba()[..4], [85, 10, 20, 255]);
        let two = Picture::new("b", 2, 1, vec![200, 0, 0, 255, 0, 0, 0, 0]).unwrap();
        assert_eq!(two.averaged(2).rgba, [200, 0, 0, 128], "transparent black does not darken");
    }
}
