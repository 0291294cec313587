//! The object in a picture, found without a model: by its alpha, or by what differs from the border's colours.
//!
//! A mask takes the place of the finding, whoever made it: a person's brush or a segmentation model.

mod ground;
mod looks;
mod parts;

use super::Picture;
use crate::Result;
use crate::picture::Ink;
use crate::view::Image;
use ground::Pixels;
use parts::filled;

pub use parts::{JOINED_WITHIN, Parts};

/// The object of one picture. All images have one size: the picture's, averaged down to at most [`OBJECT_PX`] a side.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// How much of each pixel is the object, 0 to 1. Holes through which the ground is seen are open.
    pub mask: Image,
    /// The object's body, 0 to 1: the mask, with its holes filled where the object is drawn in lines.
    pub body: Image,
    /// How dark each pixel is, 0 to 1; 0 outside the mask. Where the object is ink (drawn in lines, or of one shade and
    /// slender or white) that is how much it stands out from its ground, in whatever colour; else how dark it is in
    /// itself: a yellow ball stays light on any ground.
    pub tone: Image,
    /// All objects in the picture.
    pub parts: Parts,
    /// What makes the finding doubtful, in plain words.
    pub notes: Vec<String>,
}

/// What of an object is looked at first; pictures of its size.
#[derive(Debug, Clone, PartialEq)]
pub struct Attention {
    /// How much each pixel catches the eye, 0 to 1: how much its colour differs from what surrounds it in the object, at
    /// several scales (centre and surround; Itti, Koch and Niebur 1998). 0 all over where nothing does.
    pub saliency: Image,
    /// How clearly each pixel is a highlight, 0 to 1: how much lighter it is than what surrounds it in the object.
    pub highlight: Image,
}

/// Longest side of the pictures of an object: twice what is fitted.
pub const OBJECT_PX: usize = 512;

/// An object that covers less than this share of what its outline encloses is drawn in lines.
const LINE_SHARE: f64 = 0.4;

/// Finds the object of `picture`. A mask `given` by a person or a model (0 to 1, any size) says what it is; else the
/// alpha channel where it says anything; else whatever differs from the border's colours, which may change smoothly. Of
/// several it is number `object`, the largest is 1; of a mask all that is no crumb.
///
/// # Errors
/// [`crate::Error::Picture`] if nothing stands out, or what does covers nearly the whole border; [`crate::Error::Setting`] if there are
/// fewer objects than that.
pub fn find_object(picture: &Picture, given: Option<&Image>, object: usize) -> Result<Object> {
    ObjectFinder::new(picture).object(given, object)
}

/// Where an object is, without how it looks: see [`Object`].
#[derive(Debug, Clone, PartialEq)]
pub struct Outlined {
    /// How much of each pixel is the object, 0 to 1.
    pub mask: Image,
    /// All objects in the picture.
    pub parts: Parts,
    /// What makes the finding doubtful, in plain words.
    pub notes: Vec<String>,
}

/// Finds objects of one picture, again and again.
pub struct ObjectFinder {
    name: String,
    pixels: Pixels,
}

impl ObjectFinder {
    /// For one picture.
    pub fn new(picture: &Picture) -> ObjectFinder {
        let factor = picture.width().max(picture.height()).div_ceil(OBJECT_PX);
        let small = if factor > 1 { &picture.averaged(factor) } else { picture };
        ObjectFinder { name: picture.name().to_owned(), pixels: Pixels::new(small) }
    }

    /// See [`find_object`].
    ///
    /// # Errors
    /// As there.
    pub fn object(&self, given: Option<&Image>, object: usize) -> Result<Object> {
        let Outlined { mask, parts, notes } = self.outlined(given, object)?;
        let pixels = &self.pixels;
        let ground = match given {
            Some(mask) => pixels.ground_under(mask),
            None if pixels.is_cut_out => pixels.paper(),
            None => pixels.ground(),
        };
        let body = body(&mask);
        let tone = looks::tone(pixels, &mask, body != mask, &ground);
        Ok(Object { mask, body, tone, parts, notes })
    }

    /// What is looked at first of the object that `mask` says, one of this finder's.
    pub fn attention(&self, mask: &Image) -> Attention {
        let solid = mask.threshold(0.5);
        Attention {
            saliency: looks::saliency(&self.pixels, mask, &solid),
            highlight: looks::highlight(&self.pixels, mask, &solid),
        }
    }

    /// Where the object is.
    ///
    /// # Errors
    /// As [`find_object`].
    pub fn outlined(&self, mask: Option<&Image>, object: usize) -> Result<Outlined> {
        let ObjectFinder { name, pixels } = self;
        let mut notes = Vec::new();
        let whole = match mask {
            Some(mask) => mask.resized(pixels.width, pixels.height),
            None if pixels.is_cut_out => pixels.alpha_image(),
            None => pixels.standing_out(&pixels.ground(), name, &mut notes)?,
        };
        let object = if mask.is_some() { 1 } else { object };
        let (kept, parts) = parts::chosen_part(&whole, object, name, mask.is_some(), &mut notes)?;
        let data = whole.data.iter().zip(&kept.data).map(|(&share, &kept)| if kept { share } else { 0.0 }).collect();
        let mut mask = Image { data, ..whole };
        if body(&mask) == mask {
            looks::close_highlights(pixels, &mut mask);
        }
        Ok(Outlined { mask, parts, notes })
    }
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
        let found = find_object(&picture(ball), None, 1).unwrap();
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
            let found = find_object(&made, None, 1).unwrap();
            assert!(right(&found.mask, 25.0) > 0.99, "slope {slope}: {}", right(&found.mask, 25.0));
            assert!(found.notes.is_empty(), "{:?}", found.notes);
        }
        let colour = picture(|i| if radius(i) < 25.0 { [230, 60, 60, 255] } else { [60, 150, 60, 255] });
        assert!(right(&find_object(&colour, None, 1).unwrap().mask, 25.0) > 0.99, "colour tells too");
    }

    #[test]
    fn rings_stay_open_and_line_drawings_have_a_body() {
        let ring = |wide: f32| {
            let made = picture(|i| if (radius(i) - 25.0).abs() < wide { [0, 0, 0, 255] } else { [255; 4] });
            find_object(&made, None, 1).unwrap()
        };
        let fat = ring(10.0);
        assert!(fat.mask.at(48, 48) < 0.5 && fat.body.at(48, 48) < 0.5);
        let line = ring(1.5);
        assert!(line.mask.at(48, 48) < 0.5 && line.body.at(48, 48) > 0.5);
        assert!(line.tone.at(48, 48) == 0.0 && line.tone.at(23, 48) > 0.9);
    }

    #[test]
    fn light_things_on_dark_ground_are_light_and_light_ink_is_ink() {
        let on_navy = |on: &dyn Fn(usize) -> bool, colour: [u8; 4]| {
            find_object(&picture(|i| if on(i) { colour } else { [20, 22, 64, 255] }), None, 1).unwrap()
        };
        let yellow = [245, 217, 76, 255];
        let disc = on_navy(&|i| radius(i) < 25.0, yellow);
        assert!(right(&disc.mask, 25.0) > 0.99);
        assert!(disc.tone.at(48, 48) < 0.2, "a light thing is light: {}", disc.tone.at(48, 48));
        let logo = on_navy(&|i| radius(i) < 25.0, [255; 4]);
        assert!(logo.tone.at(48, 48) > 0.9, "a white shape is ink");
        let ring = on_navy(&|i| (radius(i) - 30.0).abs() < 6.0, yellow);
        assert!(ring.tone.at(18, 48) > 0.7, "so is a slender one: {}", ring.tone.at(18, 48));
        let drawing = on_navy(&|i| (radius(i) - 30.0).abs() < 1.5, yellow);
        assert!(drawing.tone.at(18, 48) > 0.7, "and a line drawing");
        let ball =
            find_object(&picture(|i| grey(if radius(i) < 25.0 { 250 - 4 * radius(i) as u8 } else { 20 })), None, 1);
        assert!(ball.unwrap().tone.at(48, 48) < 0.1, "a shaded white thing is no ink");
    }

    #[test]
    fn what_differs_from_what_surrounds_it_is_salient_and_light_spots_are_highlights() {
        let spot = |i: usize| ((i % SIDE) as f32 - 38.0).hypot((i / SIDE) as f32 - 40.0);
        let face = |spot_colour: [u8; 4]| {
            let pixel = |i: usize| match spot(i) {
                r if r < 5.0 => spot_colour,
                _ if radius(i) < 32.0 => [200, 60, 50, 255],
                _ => [200, 200, 200, 255],
            };
            let finder = ObjectFinder::new(&picture(pixel));
            finder.attention(&finder.object(None, 1).unwrap().mask)
        };
        for colour in [[60, 20, 20, 255], [120, 120, 40, 255], [255, 240, 235, 255]] {
            let found = face(colour);
            let [at, away] = [found.saliency.at(38, 40), found.saliency.at(62, 60)];
            assert!(at > 0.6 && away < 0.15, "{colour:?}: {at} {away}");
        }
        let plain = face([200, 60, 50, 255]);
        assert!(plain.saliency.data.iter().all(|&value| value < 0.3), "nothing catches the eye");
        let [shiny, dull] = [face([255, 240, 235, 255]), face([60, 20, 20, 255])].map(|found| found.highlight);
        assert!(shiny.at(38, 40) > 0.8 && shiny.at(62, 60) < 0.1 && dull.at(38, 40) == 0.0);
    }

    #[test]
    fn highlights_as_light_as_the_ground_are_no_holes_and_holes_are() {
        let spot = |i: usize| ((i % SIDE) as f32 - 38.0).hypot((i / SIDE) as f32 - 40.0);
        let made = |soft: bool| {
            let pixel = |i: usize| match spot(i) {
                r if r < 4.0 => grey(255),
                r if soft && r < 12.0 => grey((255.0 - 20.0 * (r - 4.0)) as u8),
                _ => grey(if radius(i) < 32.0 { 90 } else { 255 }),
            };
            find_object(&picture(pixel), None, 1).unwrap().mask
        };
        assert_eq!((made(true).at(38, 40), made(false).at(38, 40)), (1.0, 0.0));
        assert!(right(&made(true), 32.0) > 0.99);
    }

    #[test]
    fn busy_grounds_are_said() {
        let mut rng = Rng::new(9, 0);
        let busy = picture(|i| {
            let noise = 60 + rng.below(120) as u8;
            if radius(i) < 30.0 { [250, 10, 10, 255] } else { [noise, noise, noise, 255] }
        });
        let found = find_object(&busy, None, 1).unwrap();
        assert!(found.notes.iter().any(|note| note.contains("busy")), "{:?}", found.notes);
        assert!(right(&found.mask, 30.0) > 0.95, "{}", right(&found.mask, 30.0));
    }

    #[test]
    fn of_several_objects_a_person_chooses_one() {
        let three = picture(|i| {
            let on = |x: f32, y: f32, r: f32| ((i % SIDE) as f32 - x).hypot((i / SIDE) as f32 - y) < r;
            if on(25.0, 48.0, 18.0) || on(72.0, 30.0, 12.0) || on(72.0, 75.0, 8.0) { [0, 0, 0, 255] } else { [255; 4] }
        });
        for (object, [x, y]) in [(1, [25, 48]), (2, [72, 30]), (3, [72, 75])] {
            let found = find_object(&three, None, object).unwrap();
            assert!(found.notes.iter().any(|note| note.contains("objects stand out")), "{:?}", found.notes);
            assert!(found.mask.at(x, y) == 1.0, "{object}");
            assert_eq!(found.mask.threshold(0.5).components().sizes.len(), 1);
            assert_eq!((found.parts.chosen, found.parts.shares.len()), (object, 3));
            assert_eq!(found.parts.mask(object), found.mask.threshold(0.5));
            assert!(found.parts.shares.windows(2).all(|pair| pair[0] > pair[1]));
            assert_eq!(found.parts.labels[y * SIDE + x] as usize, object);
        }
        for object in [0, 4, usize::MAX] {
            let error = find_object(&three, None, object).unwrap_err();
            assert!(matches!(&error, crate::Error::Setting { name, .. } if name == "object"), "{error:?}");
            assert!(error.to_string().contains("3 objects in thing.png"), "{error}");
        }
        let mut other = Image::new(SIDE, SIDE);
        (0..SIDE * SIDE).filter(|i| i % SIDE > 55).for_each(|i| other.data[i] = f32::from(three.rgba()[4 * i] < 128));
        let chosen = find_object(&three, Some(&other), 1).unwrap();
        assert!(chosen.mask.at(25, 48) == 0.0 && chosen.mask.at(72, 30) == 1.0, "a mask chooses");
    }

    #[test]
    fn nothing_and_everything_are_refused_with_the_name_and_a_remedy() {
        let refused = |picture: Picture, mask: Option<&Image>, word: &str| {
            let error = find_object(&picture, mask, 1).unwrap_err().to_string();
            assert!(error.starts_with("thing.png") && error.contains(word) && error.contains(';'), "{error}");
        };
        refused(picture(|_| [200, 200, 200, 255]), None, "no object");
        refused(picture(|_| [200, 200, 200, 0]), None, "no object");
        refused(picture(|i| if i == 500 { [0, 0, 0, 255] } else { [255; 4] }), None, "no object");
        refused(picture(|i| [9, 9, 9, if radius(i) < 9.0 { 0 } else { 255 }]), None, "all round");
        refused(picture(|i| [9, 9, (i % 7) as u8, 0]), None, "no object");
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
            let finder = ObjectFinder::new(&picture);
            if let Ok(found) = finder.object(None, 1) {
                let Attention { saliency, highlight } = finder.attention(&found.mask);
                for image in [&found.mask, &found.body, &found.tone, &saliency, &highlight] {
                    assert_eq!((image.width, image.height), (width, height));
                    assert!(image.data.iter().all(|value| (0.0..=1.0).contains(value)));
                }
                assert!(found.mask.data.iter().zip(&found.body.data).all(|(mask, body)| mask <= body));
            }
        }
    }
}
