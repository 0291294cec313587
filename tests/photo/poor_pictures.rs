//! Pictures in which there is little to cut out: they end in a cut or in words that say what to do.

use crate::judge::PHOTOS;
use crate::photo_judge::box_round;
use crate::scenes::SIDE;
use wire4d::Error;
use wire4d::picture::cut::{Cut, Cutter, Hints};
use wire4d::picture::{Photo, Picture, find_object};
use wire4d::view::Image;

fn made(name: &str, width: usize, height: usize, pixel: impl Fn(usize, usize) -> [u8; 3]) -> Photo {
    let rgba = (0..width * height).flat_map(|i| {
        let [r, g, b] = pixel(i % width, i / width);
        [r, g, b, 255]
    });
    Photo::of(&Picture::new(name, width, height, rgba.collect()).unwrap())
}

fn hash(x: usize, y: usize) -> u32 {
    let h = (x as u32).wrapping_mul(2_654_435_761) ^ (y as u32).wrapping_mul(2_246_822_519);
    (h ^ h >> 15).wrapping_mul(2_246_822_519)
}

fn boxed(bounds: [f32; 4]) -> Hints {
    Hints { bounds: Some(bounds), ..Hints::default() }
}

/// Without a hint, with a box inside, and with one round everything.
fn ways(photo: &Photo) -> [Hints; 3] {
    let [w, h] = [photo.width as f32, photo.height as f32];
    [Hints::default(), boxed([0.2 * w, 0.2 * h, 0.8 * w, 0.8 * h]), boxed([0.0, 0.0, w, h])]
}

#[test]
fn pictures_without_an_object_say_so() {
    let flat = |value: u8| made("photo", 128, 128, |_, _| [value; 3]);
    for (photo, problem) in [(flat(3), "dark"), (flat(200), "one colour")] {
        for hints in ways(&photo) {
            let error = Cutter::new(photo.clone()).cut(&hints).unwrap_err();
            assert!(matches!(&error, Error::Picture { .. }) && error.to_string().contains(problem), "{error}");
        }
    }
}

#[test]
fn texture_and_blur_are_told_with_every_hint() {
    let grass = made("grass", 128, 128, |x, y| {
        let h = hash(x, y);
        [(h >> 24) as u8 / 2, 60 + (h >> 25) as u8, 20]
    });
    let blur = made("blur", 128, 128, |x, y| [80 + (x / 2) as u8, 80 + (y / 3) as u8, 90]);
    for (photo, word) in [(grass, "texture"), (blur, "blurred")] {
        for hints in ways(&photo) {
            match Cutter::new(photo.clone()).cut(&hints) {
                Ok(cut) => assert!(cut.notes.iter().any(|note| note.contains(word)), "{word}: {:?}", cut.notes),
                Err(error) => assert!(matches!(error, Error::Picture { .. }), "{error}"),
            }
        }
    }
}

#[test]
fn the_smallest_and_the_narrowest_pictures_do_not_stop_anything() {
    for (width, height) in [(1, 1), (2, 1), (3, 3), (4, 3000), (3000, 4), (5, 512)] {
        let photo = made("narrow", width, height, |x, y| [(hash(x, y) >> 24) as u8, (40 * x) as u8, 90]);
        for hints in ways(&photo) {
            match Cutter::new(photo.clone()).cut(&hints) {
                Ok(cut) => assert_eq!((cut.mask.width, cut.mask.height), (photo.width, photo.height)),
                Err(Error::Picture { .. } | Error::Setting { .. }) => {}
                Err(error) => panic!("{width} x {height}: {error}"),
            }
        }
    }
}

/// One of the twelve in the middle of black bars, above and below.
fn framed(k: usize, bar: usize) -> (Photo, Vec<bool>) {
    let taken = &PHOTOS[k].0;
    let photo = made("frame", SIDE, SIDE + 2 * bar, |x, y| match y.checked_sub(bar).filter(|&y| y < SIDE) {
        Some(y) => [0, 1, 2].map(|c| taken.rgb[3 * (y * SIDE + x) + c]),
        // As after lossy compression.
        None => [(hash(x, y) >> 30) as u8; 3],
    });
    let shrunk = |i: usize| {
        let [x, y] = [i % photo.width, i / photo.width].map(|v| ((v as f64 + 0.5) / photo.scale) as usize);
        y.checked_sub(bar).is_some_and(|y| y < SIDE && taken.mask[y * SIDE + x.min(SIDE - 1)])
    };
    let truth = (0..photo.width * photo.height).map(shrunk).collect();
    (photo, truth)
}

#[test]
fn black_bars_of_a_film_are_no_object() {
    let overlap = |truth: &[bool], cut: &Cut| {
        let count = |keep: &dyn Fn(bool, bool) -> bool| {
            truth.iter().zip(&cut.mask.data).filter(|(t, f)| keep(**t, **f > 0.5)).count()
        };
        count(&|a, b| a && b) as f64 / count(&|a, b| a || b) as f64
    };
    for k in [0, 2, 5] {
        let (photo, truth) = framed(k, 80);
        let bar = (80.0 * photo.scale) as usize;
        for hints in ways(&photo) {
            let cut = Cutter::new(photo.clone()).cut(&hints).unwrap();
            let rows = || (0..bar - 1).chain(photo.height - bar + 1..photo.height);
            assert!(rows().all(|y| cut.mask.data[y * photo.width..][..photo.width].iter().all(|&v| v < 0.5)));
        }
        let [left, top, right, bottom] = box_round(&PHOTOS[k].0.mask, 0.12).map(f64::from);
        let scaled = [left, top + 80.0, right, bottom + 80.0].map(|v| (v * photo.scale) as f32);
        let found = overlap(&truth, &Cutter::new(photo.clone()).cut(&boxed(scaled)).unwrap());
        println!("{:20} between bars {found:.3}", PHOTOS[k].0.name);
        assert!(found >= 0.9);
        let error = Cutter::new(photo).cut(&boxed([20.0, 2.0, 90.0, 20.0])).unwrap_err();
        assert!(error.to_string().contains("black bar"), "{error}");
    }
}

/// One of the twelve, cut down to its object: what is outside a box is not known then.
#[test]
fn a_box_round_all_of_a_picture_means_what_fills_it() {
    for k in [0, 4, 5, 9] {
        let taken = &PHOTOS[k].0;
        let [left, top, right, bottom] = box_round(&taken.mask, 0.0).map(|v| v as usize);
        let (width, height) = (right - left, bottom - top);
        let photo =
            made("close", width, height, |x, y| [0, 1, 2].map(|c| taken.rgb[3 * ((y + top) * SIDE + x + left) + c]));
        let truth: Vec<bool> =
            (0..width * height).map(|i| taken.mask[(i / width + top) * SIDE + i % width + left]).collect();
        let cut = Cutter::new(photo).cut(&boxed([0.0, 0.0, width as f32, height as f32])).unwrap();
        let share = |keep: &dyn Fn(bool, bool) -> bool| {
            truth.iter().zip(&cut.mask.data).filter(|(t, f)| keep(**t, **f > 0.5)).count() as f64
        };
        let found = share(&|a, b| a && b) / share(&|a, b| a || b);
        println!("{:20} filling the picture {found:.3}", taken.name);
        assert!(found >= 0.8);
    }
}

#[test]
fn an_empty_mask_asks_for_more() {
    let taken = &PHOTOS[5].0;
    let rgba = taken.rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    let picture = Picture::new("mug", SIDE, SIDE, rgba).unwrap();
    let error = find_object(&picture, Some(&Image::new(SIDE, SIDE)), 1).unwrap_err();
    assert!(matches!(&error, Error::Picture { .. }) && error.to_string().contains("paint"), "{error}");
}
