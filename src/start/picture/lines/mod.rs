//! What a wire can draw of a picture: lines. A wire is there or not, so shades become the widths of lines that fill the
//! object; its outline, strong inner edges, rims of highlights and strokes too thin for that get a line of their own.
//!
//! The same lines are the picture's target and, walked, the first wire: there on the solid's front, and some of them on its
//! back. What is on the back lies behind ink, so that the front does not show it.

mod circuit;
mod sections;
mod shades;
mod strokes;
mod walk;

pub use strokes::Stroke;

use super::envelope::{FAR, lower_envelope};
use crate::picture::{Ink, Mask};
use crate::view::Image;
use shades::{edges, held_back, highlights, stretched};

/// What of an object is drawn: square pictures of one size, values 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Layers {
    /// The object.
    pub mask: Image,
    /// How dark each pixel is.
    pub tone: Image,
    /// How much each pixel catches the eye.
    pub saliency: Image,
    /// How clearly each pixel is a highlight.
    pub highlight: Image,
    /// It is a line drawing, so all of it faces the viewer.
    pub all_seen: bool,
}

/// Which way the lines run that fill an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hatching {
    /// Slices, or contours where the object winds like a ring or a letter.
    Auto,
    /// Along its outline, one inside the other.
    Contours,
    /// Across it: each goes round the solid like the edge of a slice.
    Slices,
}

/// Which lines, lengths in pixels of a 256 px picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOptions {
    /// Which way the lines that fill areas run.
    pub hatching: Hatching,
    /// From line to line where areas are filled.
    pub spacing_px: f64,
    /// Width of the outline and of inner edges.
    pub outline_px: f64,
    /// How readily inner edges are drawn: 0 not at all, 1 the clear ones, more the faint ones too.
    pub edges: f64,
    /// How much darker parts get wider lines: 0 not at all, 1 from hair lines to filled.
    pub tone: f64,
    /// How readily parts that catch the eye get closer lines and the rest sparser ones, 0 to 1.
    pub saliency: f64,
    /// How readily highlights stay blank, 0 (matte) to 1.
    pub gloss: f64,
    /// Narrowest and widest line.
    pub width_px: [f64; 2],
}

/// Lines one pixel wide, each with its half width.
#[derive(Debug, Clone)]
pub struct Lines {
    side: usize,
    on: Mask,
    /// Lines where the solid's front meets its back.
    rim: Mask,
    /// Lines that are on the back too, the rim with them.
    back: Mask,
    /// Thin lines round the solid that are not drawn but walked, on front and back.
    sections: Mask,
    /// Half width at each pixel of a line, pixels of this picture.
    half_width_px: Vec<f32>,
    /// Where ink may be, and the object.
    mask: Image,
    object: Image,
    /// What share of ink each pixel's shade asks for.
    shade: Image,
}

/// Share of the full width in the lightest parts.
const LIGHTEST: f64 = 0.12;
/// The same everywhere, where the tone does not count.
const EVEN: f64 = 0.4;
/// Lines farther apart than this do not get wider to fill what is between them, px at 256: they are an abstraction.
const WIDEST_FILLING_PX: f64 = 13.0;
/// An object winds, like a ring or a letter, if laid out straight it would be this many times as long as it is.
const WINDING: f32 = 1.75;
/// Saliency, times its setting, from which lines are twice as close.
const SALIENT: f32 = 0.4;
/// What is less salient than this gets lines half as close where the setting is 1.
const DULL: f32 = 0.15;

impl Lines {
    /// The lines of an object.
    pub fn draw(layers: &Layers, options: &LineOptions) -> Lines {
        let Layers { mask, saliency, .. } = layers;
        let side = mask.width;
        let scale = side as f32 / 256.0;
        let px = |at_256: f64| at_256 as f32 * scale;
        let (spacing, outline) = (px(options.spacing_px), px(options.outline_px));
        let solid = mask.threshold(0.5);
        let depth: Vec<f32> = solid.inverted().distance_px().data.iter().map(|d| (d - 0.5).max(0.0)).collect();
        let tone = stretched(&layers.tone, &solid, 0.25 * f64::from(spacing));

        // Strokes too thin for two outlines and something in between get their middle line.
        let filling = spacing.min(px(WIDEST_FILLING_PX));
        let thinnest = outline + 0.25 * filling;
        let core = Mask { data: depth.iter().map(|&d| d >= thinnest).collect(), ..solid };
        let to_core = core.distance_px().data;
        let fat: Vec<bool> = to_core.iter().map(|&d| d < thinnest + 1.0).collect();
        let within = |i: usize| fat[i] && depth[i] >= 0.5 * outline;

        let contours = match options.hatching {
            Hatching::Auto => winds(&solid, &depth),
            hatching => hatching == Hatching::Contours,
        };
        // Filling lines are where a field steps from one whole number to the next: odd ones everywhere, even ones where the
        // lines are twice as close, every other odd one not where they are half as close.
        let top = solid.bounding_box().map_or(0, |part| part.top);
        let step = |i: usize| {
            let along = if contours { depth[i] - outline } else { (i / side) as f32 - top as f32 };
            if within(i) { 1 + (along.max(0.0) / (0.5 * spacing)) as usize } else { 0 }
        };
        let mut rim = Mask::new(side, side);
        let mut fill = vec![0usize; side * side];
        for i in (0..side * side).filter(|&i| within(i)) {
            rim.data[i] = sides(i, side).any(|n| !within(n));
            let before = match contours {
                true => sides(i, side).map(step).min().unwrap_or(0),
                false => i.checked_sub(side).map_or(0, step),
            };
            if before > 0 && step(i) > before {
                fill[i] = step(i) - 1;
            }
        }
        let closeness = |i: usize| {
            let [wish, dull] =
                [options.saliency as f32 * saliency.data[i], options.saliency as f32 * (1.0 - saliency.data[i])];
            if wish > SALIENT {
                0.5
            } else if dull > 1.0 - DULL {
                2.0
            } else {
                1.0
            }
        };
        let filled = |i: usize, closeness: f32| match fill[i] {
            0 => false,
            k if k % 2 == 0 => closeness < 1.0,
            k if k % 4 == 3 => closeness < 2.0,
            _ => true,
        };
        let mut on = Mask { data: (0..side * side).map(|i| rim.data[i] || filled(i, 1.0)).collect(), ..solid };
        let covered = on.distance_px().data;
        // Between sparse lines nothing is filled, so nothing there is left over.
        let left_over = |i: usize| contours && spacing <= filling && covered[i] > 0.5 * spacing + 1.0;
        let bare = |i: usize| solid.data[i] && (!fat[i] || left_over(i));
        let middle = Mask { data: (0..side * side).map(bare).collect(), ..solid }.thin();
        let edges = edges(&tone, &depth, scale, options);
        let blank = highlights(&layers.highlight, &depth, scale, options);

        let [least, most] = options.width_px.map(|width| 0.5 * px(width));
        let mut shade = Image::new(side, side);
        for i in (0..side * side).filter(|&i| !blank.inside.data[i]) {
            let toned = LIGHTEST + (1.0 - LIGHTEST) * f64::from(tone.data[i]);
            shade.data[i] = ((1.0 - options.tone) * EVEN + options.tone * toned) as f32 * mask.data[i];
        }
        let filling_half = |i: usize| {
            let filling = (closeness(i) * spacing).min(px(WIDEST_FILLING_PX));
            0.5 * filling * shade.data[i] + if shade.data[i] > 0.9 { 0.5 } else { 0.0 }
        };
        let ground = |i: usize| if solid.data[i] { filling_half(i) } else { 0.75 * outline };
        let filling_half = held_back((0..side * side).map(ground).collect(), side);
        let mut half_width_px = vec![0.0; side * side];
        let mut back = rim.clone();
        for i in 0..side * side {
            let drawn = edges.data[i] || blank.rim.data[i];
            let wanted = if drawn || rim.data[i] {
                0.5 * outline
            } else if middle.data[i] {
                // A drawn stroke is as wide as it is, as far as its shade allows.
                (depth[i] + 0.5).min((0.5 * filling).max(thinnest)) * shade.data[i].max(0.6)
            } else {
                filling_half[i]
            };
            let hatched =
                (middle.data[i] || filled(i, closeness(i))) && !blank.inside.data[i] && wanted >= 0.35 * least;
            on.data[i] = drawn || rim.data[i] || hatched;
            back.data[i] |= hatched && fill[i] % 4 == 1;
            half_width_px[i] = if on.data[i] { wanted.clamp(least, most) } else { 0.0 };
        }
        if layers.all_seen {
            back = Mask::new(side, side);
        }
        let sections = Mask::new(side, side);
        let (mask, object) = (mask.clone(), mask.clone());
        Lines { side, on, rim, back, sections, half_width_px, mask, object, shade }
    }

    /// The ink of the lines as a square picture of `size_px`, 0 to 1: the union of discs along them.
    pub fn ink(&self, size_px: usize) -> Image {
        let side = self.side;
        // Squared distance minus squared half width, the least over all lines: 0 on their borders.
        let mut power: Vec<f32> = self
            .half_width_px
            .iter()
            .zip(&self.on.data)
            .map(|(half, on)| if *on { -half * half } else { FAR })
            .collect();
        lower_envelope(&mut power, side);
        let ink = |i: usize| {
            let (x, y) = (i % side, i / side);
            let across = power[y * side + (x + 1).min(side - 1)] - power[y * side + x.saturating_sub(1)];
            let down = power[(y + 1).min(side - 1) * side + x] - power[y.saturating_sub(1) * side + x];
            // Divided by its slope, it is the distance to the border.
            let inside = -power[i] / (0.5 * across.hypot(down)).max(1.0);
            (inside + 0.5).clamp(0.0, 1.0) * self.mask.data[i]
        };
        let data = (0..self.mask.data.len()).map(ink).collect();
        Image { width: side, height: side, data }.resized(size_px, size_px)
    }

    /// The shades the lines stand for, as a square picture of `size_px`, 0 to 1: what a wire can meet only on average.
    pub fn grey(&self, size_px: usize) -> Image {
        self.shade.resized(size_px, size_px)
    }
}

/// Whether an object winds: how long it would be, laid out straight, against its longer side.
fn winds(solid: &Mask, depth: &[f32]) -> bool {
    let thickness = 2.0 * depth.iter().copied().fold(0.5, f32::max);
    let longer_side = solid.bounding_box().map_or(1, |part| part.width().max(part.height())) as f32;
    solid.count() as f32 / (thickness * longer_side) > WINDING
}

/// The pixels beside a pixel.
fn sides(i: usize, side: usize) -> impl Iterator<Item = usize> {
    around(i, side).filter(|&(_, length)| length == 1.0).map(|(n, _)| n)
}

/// The up to eight pixels round a pixel with their distances.
fn around(i: usize, side: usize) -> impl Iterator<Item = (usize, f32)> {
    let (x, y) = (i % side, i / side);
    (0..9).filter(|&k| k != 4).filter_map(move |k| {
        let (u, v) = ((x + k % 3).checked_sub(1)?, (y + k / 3).checked_sub(1)?);
        let length = if k % 2 == 1 { 1.0 } else { std::f32::consts::SQRT_2 };
        (u < side && v < side).then_some((v * side + u, length))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::soft_iou;
    use crate::start::{Path, Solid, SolidOptions};

    const OPTIONS: LineOptions = LineOptions {
        hatching: Hatching::Auto,
        spacing_px: 12.0,
        outline_px: 3.0,
        edges: 1.0,
        tone: 1.0,
        saliency: 0.0,
        gloss: 0.0,
        width_px: [1.0, 20.0],
    };
    const BOTH: [LineOptions; 2] = [
        LineOptions { hatching: Hatching::Contours, ..OPTIONS },
        LineOptions { hatching: Hatching::Slices, ..OPTIONS },
    ];

    fn picture(value: impl Fn(f32, f32) -> f32) -> Image {
        let mut image = Image::new(256, 256);
        for i in 0..256 * 256 {
            image.data[i] = value((i % 256) as f32 + 0.5 - 128.0, (i / 256) as f32 + 0.5 - 128.0);
        }
        image
    }

    fn disc(radius: f32) -> Image {
        picture(|x, y| f32::from(x.hypot(y) < radius))
    }

    fn layers(mask: &Image, tone: &Image) -> Layers {
        let nothing = Image::new(256, 256);
        let (mask, tone) = (mask.clone(), tone.clone());
        Layers { mask, tone, saliency: nothing.clone(), highlight: nothing, all_seen: false }
    }

    fn mean(image: &Image, on: impl Fn(f32, f32) -> bool) -> f32 {
        let on = picture(|x, y| f32::from(on(x, y)));
        let sum: f32 = image.data.iter().zip(&on.data).map(|(a, b)| a * b).sum();
        sum / on.data.iter().sum::<f32>()
    }

    #[test]
    fn darker_parts_get_more_ink_and_a_dark_shape_is_filled() {
        let mask = disc(100.0);
        let shaded = picture(|x, y| if x.hypot(y) < 100.0 { 0.5 + x / 220.0 } else { 0.0 });
        for options in BOTH {
            let halves = |options: &LineOptions| {
                let ink = Lines::draw(&layers(&mask, &shaded), options).ink(256);
                let half = |sign: f32| mean(&ink, move |x, y| sign * x > 30.0 && x.hypot(y) < 90.0);
                [half(1.0), half(-1.0)]
            };
            let [dark, light] = halves(&options);
            assert!(dark > 0.6 && light < 0.4, "{dark} {light}");
            let [dark, light] = halves(&LineOptions { tone: 0.0, ..options });
            assert!((dark - light).abs() < 0.1, "{dark} {light}");
            let full = Lines::draw(&layers(&mask, &mask), &options).ink(256);
            assert!(soft_iou(&full, &mask) > 0.93, "{}", soft_iou(&full, &mask));
            let pale = Image { data: mask.data.iter().map(|on| 0.12 * on).collect(), ..mask };
            let light = mean(&Lines::draw(&layers(&mask, &pale), &options).ink(256), |x, y| x.hypot(y) < 90.0);
            assert!(light < 0.35, "a light thing comes out light: {light}");
        }
    }

    #[test]
    fn edges_are_drawn_as_asked() {
        let mask = disc(110.0);
        let eye = picture(|x, y| if (x - 20.0).hypot(y) < 30.0 { 0.8 } else { 0.1 } * f32::from(x.hypot(y) < 110.0));
        let near_eye = |ink: &Image| mean(ink, |x, y| ((x - 20.0).hypot(y) - 30.0).abs() < 1.0);
        for options in BOTH {
            let wide = LineOptions { spacing_px: 60.0, tone: 0.0, ..options };
            let with = Lines::draw(&layers(&mask, &eye), &wide).ink(256);
            let without = Lines::draw(&layers(&mask, &eye), &LineOptions { edges: 0.0, ..wide }).ink(256);
            assert!(near_eye(&with) > 0.8 && near_eye(&without) < 0.5, "{} {}", near_eye(&with), near_eye(&without));
        }
    }

    /// Lines met on the way down through a disc about a place.
    fn lines_near(lines: &Lines, u: f32, v: f32) -> usize {
        let place = |i: usize| ((i % 256) as f32 - 127.5 - u).hypot((i / 256) as f32 - 127.5 - v);
        (0..256 * 256).filter(|&i| lines.on.data[i] && !lines.rim.data[i] && place(i) < 25.0).count()
    }

    #[test]
    fn what_catches_the_eye_gets_closer_and_finer_lines_and_the_rest_fewer() {
        let mask = disc(110.0);
        let even = Image { data: mask.data.iter().map(|on| 0.4 * on).collect(), ..mask };
        let mut layers = layers(&mask, &even);
        layers.saliency = picture(|x, y| f32::from((x - 50.0).hypot(y) < 30.0));
        for options in BOTH {
            let plain = Lines::draw(&layers, &options);
            let drawn = Lines::draw(&layers, &LineOptions { saliency: 1.0, ..options });
            let [near, far] = [50.0, -50.0].map(|u| [lines_near(&plain, u, 0.0), lines_near(&drawn, u, 0.0)]);
            assert!(near[1] as f64 > 1.6 * near[0] as f64, "closer: {near:?}");
            assert!((far[1] as f64) < 0.7 * far[0] as f64, "fewer: {far:?}");
            let widest = |lines: &Lines, u: f32| {
                let inner = |i: usize| ((i % 256) as f32 - 127.5 - u).hypot((i / 256) as f32 - 127.5) < 20.0;
                (0..256 * 256).filter(|&i| inner(i)).map(|i| lines.half_width_px[i]).fold(0.0, f32::max)
            };
            assert!(widest(&drawn, 50.0) < 0.7 * widest(&plain, 50.0), "finer");
        }
    }

    #[test]
    fn highlights_stay_blank_with_a_line_round_them_where_it_shines() {
        let mask = disc(110.0);
        let mut layers = layers(&mask, &mask);
        layers.highlight = picture(|x, y| (1.0 - (x + 30.0).hypot(y + 30.0) / 60.0).max(0.0));
        for options in BOTH {
            let shown = |gloss: f64| {
                let ink = Lines::draw(&layers, &LineOptions { gloss, ..options }).ink(256);
                let at =
                    |near: f32, far: f32| mean(&ink, move |x, y| (near..far).contains(&(x + 30.0).hypot(y + 30.0)));
                [at(0.0, 20.0), at(28.0, 32.0)]
            };
            let ([dull, _], [blank, rim]) = (shown(0.0), shown(0.5));
            assert!(dull > 0.9 && blank < 0.05 && rim > 0.6, "{dull} {blank} {rim}");
            assert!(shown(0.15)[0] > 0.5, "a little gloss leaves the clearest part alone blank");
        }
    }

    #[test]
    fn hatching_suits_the_shape() {
        let same = |mask: &Image, hatching: Hatching| {
            let drawn = |hatching| Lines::draw(&layers(mask, mask), &LineOptions { hatching, ..OPTIONS }).on;
            drawn(Hatching::Auto) == drawn(hatching)
        };
        let ring = picture(|x, y| f32::from((x.hypot(y) - 80.0).abs() < 20.0));
        assert!(same(&ring, Hatching::Contours) && !same(&ring, Hatching::Slices));
        assert!(same(&disc(100.0), Hatching::Slices) && !same(&disc(100.0), Hatching::Contours));
    }

    fn walked(mask: &Image, tone: &Image, options: &LineOptions) -> (Lines, Solid, Path) {
        let lines = Lines::draw(&layers(mask, tone), options);
        let solid = Solid::inflated("thing", mask, &SolidOptions::default()).unwrap();
        let path = lines.walk(&solid, 0.005);
        (lines, solid, path)
    }

    #[test]
    fn the_walk_is_one_line_over_all_lines_front_and_back() {
        let shapes = [
            disc(100.0),
            picture(|x, y| f32::from((x.hypot(y) - 70.0).abs() < 22.0)),
            picture(|x, y| f32::from((x.hypot(y) - 70.0).abs() < 2.0 || (x - 20.0).hypot(y) < 6.0)),
        ];
        for (mask, options) in shapes.iter().flat_map(|mask| BOTH.map(|options| (mask, options))) {
            let (lines, solid, path) = walked(mask, mask, &options);
            let px = solid.height_world() / 256.0;
            let mut met = Mask::new(256, 256);
            for point in &path.points {
                let [u, v] = [128.0 + point[0] / px, 128.0 - point[1] / px];
                met.data[v as usize * 256 + u as usize] = true;
            }
            let away = met.distance_px();
            let missed = (0..256 * 256).filter(|&i| lines.on.data[i] && away.data[i] > 4.0).count();
            assert!(missed as f64 <= 0.01 * lines.on.count() as f64, "{missed} of {} pixels missed", lines.on.count());
            let step = |pair: &[[f64; 4]]| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]);
            assert!(path.points.windows(2).all(|pair| step(pair) < 2.0 * px), "no jumps across");
        }
    }

    #[test]
    fn the_back_is_sparser_lies_behind_ink_and_is_reached_round_the_rim() {
        let mask = disc(100.0);
        let pale = Image { data: mask.data.iter().map(|on| 0.12 * on).collect(), ..mask };
        for options in BOTH {
            let (_, solid, path) = walked(&mask, &pale, &options);
            let px = solid.height_world() / 256.0;
            let pixel = |point: &[f64; 4]| (128.0 - point[1] / px) as usize * 256 + (128.0 + point[0] / px) as usize;
            let mut shown = Mask::new(256, 256);
            path.points.iter().filter(|point| point[2] > -0.1).for_each(|point| shown.data[pixel(point)] = true);
            let away = shown.distance_px();
            let behind: Vec<_> = path.points.iter().filter(|point| point[2] < -0.1).collect();
            let front = path.points.iter().filter(|point| point[2] > 0.1).count();
            let bare = behind.iter().filter(|point| away.data[pixel(point)] > 2.0).count();
            let behind = behind.len();
            assert!((0.2..0.75).contains(&(behind as f64 / front as f64)), "{behind} {front}");
            assert!(bare <= behind / 20, "{bare} of {behind} show from the front");
            // Through the middle of the ball there is no wire.
            let inner = |p: &[f64; 4]| p[0].hypot(p[1]) < 0.7 && p[2].abs() < 0.4;
            assert!(!path.points.iter().any(inner));
        }
    }
}
