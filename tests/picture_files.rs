//! Picture files in and out: formats, orientation, limits, and bytes that are no picture.
#![cfg(feature = "cli")]

use image::{DynamicImage, GrayImage, ImageEncoder, ImageFormat, Luma, RgbaImage};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::{fs, io::Cursor, path::Path};
use wire4d::picture::{self, GreyDepth, Ink, Picture, Polarity};
use wire4d::view::Image;

const WIDTH: u32 = 60;
const HEIGHT: u32 = 40;

/// A black L on white, no symmetry: upright stroke on the left, foot at the bottom.
fn letter() -> GrayImage {
    GrayImage::from_fn(WIDTH, HEIGHT, |x, y| {
        let ink = (10..18).contains(&x) && (5..35).contains(&y) || (10..40).contains(&x) && (28..35).contains(&y);
        Luma([if ink { 0 } else { 255 }])
    })
}

fn encoded(image: &DynamicImage, format: ImageFormat) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, format).unwrap();
    bytes.into_inner()
}

fn ink(bytes: &[u8]) -> Image {
    let picture = picture::decode_picture("letter", bytes).unwrap();
    picture::ink(&picture, Polarity::Auto).unwrap().0
}

/// Mean absolute difference from the L.
fn difference(found: &Image) -> f32 {
    assert_eq!((found.width, found.height), (WIDTH as usize, HEIGHT as usize));
    let letter = letter();
    let each =
        found.data.iter().zip(letter.pixels()).map(|(value, grey)| (value - (1.0 - f32::from(grey[0]) / 255.0)).abs());
    each.sum::<f32>() / found.data.len() as f32
}

/// An EXIF segment that says `orientation` and nothing else, put after the JPEG's first marker.
fn with_exif(jpeg: &[u8], orientation: u8) -> Vec<u8> {
    let mut exif = b"Exif\0\0MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0".to_vec();
    exif.extend([orientation, 0, 0, 0, 0, 0, 0]);
    let mut bytes = jpeg[..2].to_vec();
    bytes.extend([0xff, 0xe1, 0, exif.len() as u8 + 2]);
    bytes.extend(exif);
    bytes.extend(&jpeg[2..]);
    bytes
}

fn jpeg(image: GrayImage) -> Vec<u8> {
    let mut bytes = Vec::new();
    let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, 95);
    encoder.write_image(&image, image.width(), image.height(), image::ExtendedColorType::L8).unwrap();
    bytes
}

#[test]
fn every_format_gives_the_same_ink() {
    let grey = DynamicImage::from(letter());
    assert!(difference(&ink(&encoded(&grey, ImageFormat::Png))) < 1e-6);
    assert!(difference(&ink(&encoded(&grey.to_luma16().into(), ImageFormat::Png))) < 1e-6, "16 bits");
    assert!(difference(&ink(&encoded(&grey.to_rgb16().into(), ImageFormat::Png))) < 1e-6, "16 bits, colour");
    assert!(difference(&ink(&encoded(&grey.to_rgba8().into(), ImageFormat::WebP))) < 1e-6);
    let lossy = difference(&ink(&jpeg(letter())));
    assert!(lossy < 0.01, "{lossy}");
    let alpha = RgbaImage::from_fn(WIDTH, HEIGHT, |x, y| image::Rgba([20, 20, 20, 255 - letter().get_pixel(x, y)[0]]));
    assert!(difference(&ink(&encoded(&alpha.into(), ImageFormat::Png))) < 1e-6, "alpha alone");
    let negative = GrayImage::from_fn(WIDTH, HEIGHT, |x, y| Luma([255 - letter().get_pixel(x, y)[0]]));
    assert!(difference(&ink(&encoded(&negative.into(), ImageFormat::Png))) < 1e-6, "light on dark");
}

#[test]
fn exif_orientation_is_applied() {
    // 6: the camera was turned; the file's rows are the picture's columns.
    let stored = image::imageops::rotate270(&letter());
    let turned = difference(&ink(&with_exif(&jpeg(stored), 6)));
    assert!(turned < 0.02, "{turned}");
    let mirrored = difference(&ink(&with_exif(&jpeg(image::imageops::flip_horizontal(&letter())), 2)));
    assert!(mirrored < 0.02, "{mirrored}");
    // Sibling: without the tag the picture is the mirrored one.
    assert!(difference(&ink(&jpeg(image::imageops::flip_horizontal(&letter())))) > 0.05);
}

#[test]
fn damaged_and_foreign_files_are_refused_in_words() {
    let grey = DynamicImage::from(letter());
    let refuse = |bytes: &[u8]| {
        let error = picture::decode_picture("cat.png", bytes).unwrap_err();
        assert!(error.is_bad_input());
        let text = error.to_string();
        assert!(text.starts_with("cat.png: ") && text.contains("; ") && !text.contains('\n'), "{text}");
        text
    };
    let whole = [
        encoded(&grey, ImageFormat::Png),
        encoded(&grey.to_rgba8().into(), ImageFormat::WebP),
        jpeg(letter()),
        with_exif(&jpeg(letter()), 3),
    ];
    for bytes in &whole {
        for share in [4, 6, 9] {
            refuse(&bytes[..bytes.len() * share / 10]);
        }
    }
    assert!(refuse(b"").contains("empty"));
    assert!(refuse(b"<svg xmlns='http://www.w3.org/2000/svg'/>").contains("PNG, JPEG or WebP"));
    assert!(refuse(b"GIF89a\x01\0\x01\0\0\0\0;").contains("PNG, JPEG or WebP"));
}

#[test]
fn a_huge_picture_is_refused_before_memory_is_taken() {
    // Header and end of a 20,000 x 20,000 PNG: its 1.2 GB of pixels are never asked for.
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = b"IHDR".to_vec();
    header.extend(20_000u32.to_be_bytes());
    header.extend(20_000u32.to_be_bytes());
    header.extend([8, 2, 0, 0, 0]);
    for chunk in [&header[..], b"IDAT\x78\x9c\x03\0\0\0\0\x01", b"IEND"] {
        bytes.extend((chunk.len() as u32 - 4).to_be_bytes());
        bytes.extend(chunk);
        bytes.extend(crc32fast::hash(chunk).to_be_bytes());
    }
    let error = picture::decode_picture("huge.png", &bytes).unwrap_err().to_string();
    assert!(error.contains("20000 x 20000 px") && error.contains("scale it down"), "{error}");
    // Sibling: the same bytes with a small size get past that check.
    let error = picture::decode_picture("small.png", &encoded(&letter().into(), ImageFormat::Png));
    assert!(error.is_ok());
}

#[test]
fn files_that_are_missing_or_folders_are_named() {
    let missing = picture::read_picture(Path::new("no/such/cat.png")).unwrap_err();
    assert!(missing.is_bad_input() && missing.to_string().starts_with("no/such/cat.png: cannot be read"), "{missing}");
    let folder = tempfile::tempdir().unwrap();
    assert!(picture::read_picture(folder.path()).unwrap_err().to_string().contains("is a folder"));
}

#[test]
fn grey_files_come_back_as_they_went() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("coverage.png");
    let coverage = Image { width: 4, height: 2, data: vec![0.0, 0.25, 0.5, 1.0, 1e-5, 0.123_45, 7.0, -1.0] };
    picture::write_png(&path, &coverage, GreyDepth::Bits16).unwrap();
    let DynamicImage::ImageLuma16(read) = image::open(&path).unwrap() else { panic!("16-bit grey") };
    for (level, value) in read.as_raw().iter().zip(&coverage.data) {
        assert!((f32::from(*level) / 65_535.0 - value.clamp(0.0, 1.0)).abs() < 8e-6);
    }
    picture::write_png(&path, &coverage, GreyDepth::Bits8).unwrap();
    let DynamicImage::ImageLuma8(read) = image::open(&path).unwrap() else { panic!("8-bit grey") };
    assert_eq!(read.as_raw()[..4], [0, 64, 128, 255]);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary files are left");
    let error = picture::write_png(&folder.path().join("a/b.png"), &coverage, GreyDepth::Bits8).unwrap_err();
    assert!(error.is_bad_input(), "a folder that does not exist is a bad option");
    assert!(picture::write_png(&path, &Image::default(), GreyDepth::Bits16).is_err());
    assert!(picture::encode_png("x", &Image { width: 3, height: 3, data: vec![] }, GreyDepth::Bits8).is_err());
}

#[test]
fn the_test_drawings_are_read() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawings");
    let mut sets: Vec<_> =
        fs::read_dir(root).unwrap().map(|set| set.unwrap().path()).filter(|set| set.is_dir()).collect();
    sets.sort();
    let mut counts = (0, 0);
    for set in &sets {
        let mut views = 0;
        for name in ["front", "side", "top"] {
            let file = set.join(name).with_extension("png");
            if !file.exists() {
                continue;
            }
            views += 1;
            assert!(fs::metadata(&file).unwrap().len() < 12_000, "{}", file.display());
            let picture = picture::read_picture(&file).unwrap();
            let (image, ground) = picture::ink(&picture, Polarity::Auto).unwrap();
            let light = set.ends_with("t10-thin-letters");
            assert_eq!(ground.polarity == Polarity::LightInk, light, "{}", file.display());
            let share = image.data.iter().sum::<f32>() / image.data.len() as f32;
            assert!((0.01..0.55).contains(&share), "{}: {share} of it is ink", file.display());
            assert!(image.threshold(0.9).count() > 100, "{}: ink is ink", file.display());
            assert_eq!(image.at(0, 0), 0.0, "{}: ground is ground", file.display());
        }
        if views == 3 { counts.0 += 1 } else { counts.1 += 1 }
    }
    assert_eq!(counts, (10, 5), "triples and pairs");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, rng_seed: RngSeed::Fixed(4), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_never_panic(start in 0usize..5, bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let starts: [&[u8]; 5] = [b"", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff\xe0", b"RIFF\x40\0\0\0WEBPVP8L", b"RIFF\x40\0\0\0WEBPVP8 "];
        let mut all = starts[start].to_vec();
        all.extend(bytes);
        if let Ok(picture) = picture::decode_picture("random", &all) {
            let _ = picture::ink(&picture, Polarity::Auto);
        }
    }

    #[test]
    fn damaged_pictures_never_panic(
        format in 0usize..3, changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let grey = DynamicImage::from(letter());
        let mut bytes = match format {
            0 => encoded(&grey, ImageFormat::Png),
            1 => encoded(&grey.to_rgba8().into(), ImageFormat::WebP),
            _ => with_exif(&jpeg(letter()), 5),
        };
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Ok(picture) = picture::decode_picture("damaged", &bytes) {
            let _ = picture::ink(&picture, Polarity::Auto);
        }
    }

    #[test]
    fn any_pixels_give_ink_or_words(
        width in 1usize..24, height in 1usize..24, seed in any::<u64>(), levels in 1u8..=255, light in any::<bool>(),
    ) {
        let mut rng = wire4d::rng::Rng::new(seed, 0);
        let rgba = (0..width * height * 4).map(|_| (rng.next_u32() >> 24) as u8 / levels * levels).collect();
        let picture = Picture::new("noise", width, height, rgba).unwrap();
        let polarity = if light { Polarity::LightInk } else { Polarity::Auto };
        match picture::ink(&picture, polarity) {
            Ok((image, _)) => prop_assert!(image.data.iter().all(|value| (0.0..=1.0).contains(value))),
            Err(error) => prop_assert!(error.to_string().starts_with("noise: ")),
        }
    }
}
