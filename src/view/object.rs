//! The object in a picture, found without a model: by its alpha, or by what differs from the border's colours.

use super::picture::{otsu, quantile};
use super::{Image, Mask, Picture};
use crate::{Error, Result};

/// The object of one picture. All images have one size: the picture's, averaged down to at most [`OBJECT_PX`] a side.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// How much of each pixel is the object, 0 to 1. Holes through which the ground is seen are open.
    pub mask: Image,
    /// The object's body, 0 to 1: the mask, with its holes filled where the object is drawn in lines.
    pub body: Image,
    /// How much each pixel stands out in shade from its ground, 0 (like it) to 1 (black on white, white on black);
    /// 0 outside the mask.
    pub tone: Image,
    /// What makes the finding doubtful, in plain words.
    pub notes: Vec<String>,
}

/// Longest side of the pictures of an object: twice what is fitted.
pub const OBJECT_PX: usize = 512;

/// Least distance from the ground's colour, in Oklab units (black to white is 1), that can be told from noise.
const LEAST_DISTANCE: f32 = 0.04;
/// A border that differs this much from a smooth ground in a fifth of its pixels is busy.
const BUSY: f32 = 0.05;
/// Parts nearer to each other than this share of the picture's side are one object.
const JOINED_WITHIN: f32 = 0.04;
/// Parts of at least this share of the object, left out, are worth a word.
const WORTH_A_WORD: f64 = 0.15;
/// Holes and specks smaller than this share of the object are noise.
const SPECK: f64 = 5e-4;
/// Share of the border that an object may cover.
const MOST_BORDER: f64 = 0.75;
/// An object that covers less than this share of what its outline encloses is drawn in lines.
const LINE_SHARE: f64 = 0.4;
/// Fewest pixels of an object.
const FEWEST_PIXELS: usize = 12;

/// Finds the object of `picture`. A `mask` given by a person or a model (0 to 1, any size) says what it is; else the
/// alpha channel where it says anything; else whatever differs from the border's colours, which may change smoothly.
///
/// # Errors
/// [`Error::Picture`] if nothing stands out, or what does covers nearly the whole border.
pub fn find_object(picture: &Picture, mask: Option<&Image>) -> Result<Object> {
    let factor = picture.width().max(picture.height()).div_ceil(OBJECT_PX);
    let small = if factor > 1 { &picture.averaged(factor) } else { picture };
    let pixels = Pixels::new(small);
    let mut notes = Vec::new();
    let (whole, ground) = match mask {
        Some(mask) => (mask.resized(pixels.width, pixels.height), pixels.ground_under(mask)),
        None if pixels.alpha.iter().any(|&alpha| alpha < 0.5) => (pixels.alpha_image(), pixels.paper()),
        None => {
            let ground = pixels.ground();
            (pixels.standing_out(&ground, picture.name(), &mut notes)?, ground)
        }
    };
    let kept = chosen_part(&whole, picture.name(), mask.is_some(), &mut notes)?;
    let data = whole.data.iter().zip(&kept.data).map(|(&share, &kept)| if kept { share } else { 0.0 }).collect();
    let mask = Image { data, ..whole };
    let body = body(&mask);
    let tone = pixels.tone(&mask, &ground);
    Ok(Object { mask, body, tone, notes })
}

/// Colours as Oklab (Ottosson 2020), in which equal distances look equally different.
struct Pixels {
    width: usize,
    height: usize,
    lab: Vec<[f32; 3]>,
    alpha: Vec<f32>,
}

impl Pixels {
    fn new(picture: &Picture) -> Pixels {
        let each = || picture.rgba().chunks_exact(4);
        Pixels {
            width: picture.width(),
            height: picture.height(),
            lab: each().map(|p| oklab([p[0], p[1], p[2]])).collect(),
            alpha: each().map(|p| f32::from(p[3]) / 255.0).collect(),
        }
    }

    fn alpha_image(&self) -> Image {
        Image { width: self.width, height: self.height, data: self.alpha.clone() }
    }

    fn is_border(&self, i: usize) -> bool {
        let rim = (self.width.min(self.height) / 60).max(1);
        let (x, y) = (i % self.width, i / self.width);
        x < rim || y < rim || x + rim >= self.width || y + rim >= self.height
    }

    /// What transparent pictures are laid on: white, or black where all of the object is nearly white.
    fn paper(&self) -> Ground {
        let mut shades: Vec<f32> =
            self.lab.iter().zip(&self.alpha).filter(|(_, alpha)| **alpha >= 0.5).map(|(lab, _)| lab[0]).collect();
        let light = quantile(&mut shades, 0.1) > 0.85;
        Ground::even([if light { 0.0 } else { 1.0 }, 0.0, 0.0])
    }

    /// The ground round a mask that was given.
    fn ground_under(&self, mask: &Image) -> Ground {
        let mask = mask.resized(self.width, self.height);
        let outside: Vec<usize> = (0..self.lab.len()).filter(|&i| mask.data[i] < 0.1 && self.alpha[i] > 0.5).collect();
        if outside.is_empty() { self.paper() } else { Ground::fit(self, &outside) }
    }

    fn ground(&self) -> Ground {
        let border: Vec<usize> = (0..self.lab.len()).filter(|&i| self.is_border(i)).collect();
        Ground::fit(self, &border)
    }

    /// How much of each pixel stands out from the ground.
    fn standing_out(&self, ground: &Ground, name: &str, notes: &mut Vec<String>) -> Result<Image> {
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

    /// How much each pixel's shade differs from its ground's, of all it could differ.
    fn tone(&self, mask: &Image, ground: &Ground) -> Image {
        let mut lightness: Vec<f32> =
            (0..self.lab.len()).filter(|&i| mask.data[i] > 0.5).map(|i| ground.at(self, i)[0]).collect();
        let light = quantile(&mut lightness, 0.5) > 0.5;
        let tone = |i: usize| {
            let (shade, ground) = (self.lab[i][0], ground.at(self, i)[0].clamp(0.0, 1.0));
            // A ground of middle grey leaves room on one side only: count from the far end.
            let tone =
                if light { (ground - shade) / ground.max(0.5) } else { (shade - ground) / (1.0 - ground).max(0.5) };
            tone.clamp(0.0, 1.0) * mask.data[i]
        };
        Image { width: self.width, height: self.height, data: (0..self.lab.len()).map(tone).collect() }
    }
}

/// The ground's colour, a + b x + c y + d x y over the picture, x and y from -1 to 1: gradients are no object.
struct Ground([[f32; 4]; 3]);

impl Ground {
    fn even(lab: [f32; 3]) -> Ground {
        Ground(lab.map(|value| [value, 0.0, 0.0, 0.0]))
    }

    /// Reweighted least squares: what lies far off (the object where it meets the border) loses its say.
    fn fit(pixels: &Pixels, places: &[usize]) -> Ground {
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

    fn at(&self, pixels: &Pixels, i: usize) -> [f32; 3] {
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

fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
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

/// The largest part with all that lies close to it, specks and pinholes removed.
fn chosen_part(whole: &Image, name: &str, given: bool, notes: &mut Vec<String>) -> Result<Mask> {
    let (width, height) = (whole.width, whole.height);
    let solid = whole.threshold(0.5);
    if solid.count() < FEWEST_PIXELS {
        let remedy =
            if given { "paint more of the object" } else { "use a picture with a larger object, or paint a mask" };
        return Err(Error::picture(name, format!("shows no object: {} pixels stand out", solid.count()), remedy));
    }
    let close = (JOINED_WITHIN * width.max(height) as f32).max(1.5) / 2.0;
    // What an outline encloses belongs to it.
    let near = Mask { data: filled(&solid).distance_px().data.iter().map(|&d| d <= close).collect(), ..solid };
    let groups = near.components();
    let mut inked = vec![0usize; groups.sizes.len()];
    for (&label, _) in groups.labels.iter().zip(&solid.data).filter(|(_, solid)| **solid) {
        inked[label as usize - 1] += 1;
    }
    let largest = (0..inked.len()).max_by_key(|&k| (inked[k], usize::MAX - k)).unwrap_or(0);
    let others = (0..inked.len()).filter(|&k| k != largest && inked[k] as f64 >= WORTH_A_WORD * inked[largest] as f64);
    let others = others.count();
    if others > 0 {
        notes.push(format!("{name}: {} objects stand out, the largest is taken; a mask chooses another", others + 1));
    }
    let border: Vec<usize> = (0..width * height).filter(|&i| on_rim(i, width, height)).collect();
    let covered = border.iter().filter(|&&i| solid.data[i] && groups.labels[i] as usize == largest + 1).count();
    if covered as f64 > MOST_BORDER * border.len() as f64 {
        let problem = "its object covers the border all round, so there is no ground to tell it from";
        let remedy = if given {
            "give a mask that is white on the object and black all round"
        } else {
            "use a picture with some ground all round, or paint a mask"
        };
        return Err(Error::picture(name, problem, remedy));
    }
    if covered > 0 {
        notes.push(format!("{name}: the object reaches the picture's border and is cut off there"));
    }
    let least = (SPECK * inked[largest] as f64).max(1.0) as usize;
    let parts = solid.components();
    let mut kept = Mask::new(width, height);
    for i in 0..kept.data.len() {
        let part = parts.labels[i] as usize;
        // Soft pixels beside the object are its edge.
        let in_group = groups.labels[i] as usize == largest + 1;
        kept.data[i] = in_group && (part == 0 || parts.sizes[part - 1] > least);
    }
    Ok(kept)
}

/// The mask, or what its outline encloses where it is drawn in lines.
fn body(mask: &Image) -> Image {
    let solid = mask.threshold(0.5);
    let filled = filled(&solid);
    if solid.count() as f64 >= LINE_SHARE * filled.count() as f64 {
        return mask.clone();
    }
    let data = mask.data.iter().zip(&filled.data).map(|(&share, &filled)| if filled { 1.0 } else { share });
    Image { data: data.collect(), ..*mask }
}

/// Whether a pixel is one of the outermost.
fn on_rim(i: usize, width: usize, height: usize) -> bool {
    let (x, y) = (i % width, i / width);
    x == 0 || y == 0 || x + 1 == width || y + 1 == height
}

/// The mask with everything that it encloses. Ground joins across sides only: lines that meet at corners are closed.
fn filled(mask: &Mask) -> Mask {
    let (width, height) = (mask.width, mask.height);
    let mut outside = vec![false; mask.data.len()];
    let mut front: Vec<usize> = (0..mask.data.len()).filter(|&i| on_rim(i, width, height)).collect();
    while let Some(i) = front.pop() {
        if mask.data[i] || std::mem::replace(&mut outside[i], true) {
            continue;
        }
        let (x, y) = (i % width, i / width);
        front.extend([(x > 0, i.wrapping_sub(1)), (x + 1 < width, i + 1)].iter().filter(|n| n.0).map(|n| n.1));
        front.extend([(y > 0, i.wrapping_sub(width)), (y + 1 < height, i + width)].iter().filter(|n| n.0).map(|n| n.1));
    }
    Mask { width, height, data: outside.iter().map(|outside| !outside).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    const SIDE: usize = 96;

    fn picture(pixel: impl FnMut(usize) -> [u8; 4]) -> Picture {
        Picture::new("thing.png", SIDE, SIDE, (0..SIDE * SIDE).flat_map(pixel).collect()).unwrap()
    }

    fn grey(shade: u8) -> [u8; 4] {
        [shade, shade, shade, 255]
    }

    fn radius(i: usize) -> f32 {
        ((i % SIDE) as f32 - 47.5).hypot((i / SIDE) as f32 - 47.5)
    }

    /// Share of pixels on which the mask is right about a disc.
    fn right(mask: &Image, disc: f32) -> f64 {
        let right = (0..SIDE * SIDE).filter(|&i| (mask.data[i] > 0.5) == (radius(i) < disc));
        right.count() as f64 / (SIDE * SIDE) as f64
    }

    #[test]
    fn alpha_says_what_the_object_is() {
        let ball = |i: usize| [(3 * (i % SIDE) / 2) as u8, 90, 60, if radius(i) < 30.0 { 255 } else { 0 }];
        let found = find_object(&picture(ball), None).unwrap();
        assert_eq!(right(&found.mask, 30.0), 1.0);
        assert!(found.notes.is_empty());
        assert!(found.tone.at(30, 48) > found.tone.at(66, 48) + 0.03, "the darker side asks for more");
    }

    #[test]
    fn flat_and_sloping_grounds_are_told_from_the_object() {
        let mut rng = Rng::new(2, 0);
        let mut noisy = |value: f32| (value + rng.range(-4.0, 4.0) as f32).clamp(0.0, 255.0) as u8;
        let ground = |i: usize, slope: f32| 150.0 + slope * ((i % SIDE) as f32 + 0.5 * (i / SIDE) as f32 - 70.0);
        for slope in [0.0, 0.9, -0.9] {
            let made = picture(|i| {
                let shade = if radius(i) < 25.0 { 40.0 } else { ground(i, slope) };
                [noisy(shade), noisy(shade), noisy(shade * 0.9), 255]
            });
            let found = find_object(&made, None).unwrap();
            assert!(right(&found.mask, 25.0) > 0.99, "slope {slope}: {}", right(&found.mask, 25.0));
            assert!(found.notes.is_empty(), "{:?}", found.notes);
        }
        let colour = picture(|i| if radius(i) < 25.0 { [230, 60, 60, 255] } else { [60, 150, 60, 255] });
        assert!(right(&find_object(&colour, None).unwrap().mask, 25.0) > 0.99, "colour tells too");
    }

    #[test]
    fn rings_stay_open_and_line_drawings_have_a_body() {
        let ring = |wide: f32| {
            let made = picture(|i| if (radius(i) - 25.0).abs() < wide { [0, 0, 0, 255] } else { [255; 4] });
            find_object(&made, None).unwrap()
        };
        let fat = ring(10.0);
        assert!(fat.mask.at(48, 48) < 0.5 && fat.body.at(48, 48) < 0.5);
        let line = ring(1.5);
        assert!(line.mask.at(48, 48) < 0.5 && line.body.at(48, 48) > 0.5);
        assert!(line.tone.at(48, 48) == 0.0 && line.tone.at(23, 48) > 0.9);
    }

    #[test]
    fn light_things_on_dark_ground_are_things() {
        let found = find_object(&picture(|i| grey(if radius(i) < 25.0 { 250 } else { 20 })), None);
        let found = found.unwrap();
        assert!(right(&found.mask, 25.0) > 0.99 && found.tone.at(48, 48) > 0.8);
    }

    #[test]
    fn busy_grounds_and_several_objects_are_said() {
        let mut rng = Rng::new(9, 0);
        let busy = picture(|i| {
            let noise = 60 + rng.below(120) as u8;
            if radius(i) < 30.0 { [250, 10, 10, 255] } else { [noise, noise, noise, 255] }
        });
        let found = find_object(&busy, None).unwrap();
        assert!(found.notes.iter().any(|note| note.contains("busy")), "{:?}", found.notes);
        assert!(right(&found.mask, 30.0) > 0.95, "{}", right(&found.mask, 30.0));
        let two = picture(|i| {
            let on = |x: f32, r: f32| ((i % SIDE) as f32 - x).hypot((i / SIDE) as f32 - 48.0) < r;
            if on(25.0, 18.0) || on(72.0, 12.0) { [0, 0, 0, 255] } else { [255; 4] }
        });
        let found = find_object(&two, None).unwrap();
        assert!(found.notes.iter().any(|note| note.contains("2 objects")), "{:?}", found.notes);
        assert!(found.mask.at(25, 48) == 1.0 && found.mask.at(72, 48) == 0.0);
        let mut other = Image::new(SIDE, SIDE);
        (0..SIDE * SIDE).filter(|i| i % SIDE > 55).for_each(|i| other.data[i] = f32::from(two.rgba()[4 * i] < 128));
        let chosen = find_object(&two, Some(&other)).unwrap();
        assert!(chosen.mask.at(25, 48) == 0.0 && chosen.mask.at(72, 48) == 1.0, "a mask chooses");
    }

    #[test]
    fn nothing_and_everything_are_refused_with_the_name_and_a_remedy() {
        let refused = |picture: Picture, mask: Option<&Image>, word: &str| {
            let error = find_object(&picture, mask).unwrap_err().to_string();
            assert!(error.starts_with("thing.png") && error.contains(word) && error.contains(';'), "{error}");
        };
        refused(picture(|_| [200, 200, 200, 255]), None, "no object");
        refused(picture(|_| [200, 200, 200, 0]), None, "no object");
        refused(picture(|i| if i == 500 { [0, 0, 0, 255] } else { [255; 4] }), None, "no object");
        refused(picture(|i| [9, 9, 9, if radius(i) < 9.0 { 0 } else { 255 }]), None, "all round");
        let full = Image { width: 2, height: 2, data: vec![1.0; 4] };
        refused(picture(|_| [0, 0, 0, 255]), Some(&full), "all round");
    }

    #[test]
    fn any_picture_gives_an_object_or_a_word() {
        let mut rng = Rng::new(1, 0);
        for _ in 0..60 {
            let (width, height) = (1 + rng.below(40), 1 + rng.below(40));
            let kind = rng.below(3);
            let rgba = (0..4 * width * height).map(|i| match kind {
                0 => rng.next_u32() as u8,
                1 if i % 4 == 3 => 255,
                _ => (rng.below(2) * 255) as u8,
            });
            let picture = Picture::new("any", width, height, rgba.collect()).unwrap();
            if let Ok(found) = find_object(&picture, None) {
                for image in [&found.mask, &found.body, &found.tone] {
                    assert_eq!((image.width, image.height), (width, height));
                    assert!(image.data.iter().all(|value| (0.0..=1.0).contains(value)));
                }
                assert!(found.mask.data.iter().zip(&found.body.data).all(|(mask, body)| mask <= body));
            }
        }
    }
}
