//! Picture files in and out: formats, orientation, limits, and bytes that are no picture.
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
    let rgb = DynamicImage::from(grey.to_rgb8());
    for format in [ImageFormat::Gif, ImageFormat::Bmp, ImageFormat::Tiff] {
        assert!(difference(&ink(&encoded(&rgb, format))) < 1e-6, "{format:?}");
    }
    assert!(difference(&ink(&encoded(&grey.to_luma16().into(), ImageFormat::Tiff))) < 1e-6, "TIFF of 16 bits");
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
    assert!(refuse(b"<svg xmlns='http://www.w3.org/2000/svg'/>").contains("shows nothing"));
    assert!(refuse(b"GIF89a\x01\0\x01\0\0\0\0;").contains("damaged or cut off"));
    assert!(refuse(b"solid key\nfacet normal 0 0 1").contains("PNG, JPEG, WebP, GIF, BMP, TIFF or SVG"));
    for (bytes, words) in [
        (&b"\0\0\0\x18ftypheic\0\0\0\0mif1heic"[..], ["HEIC", "JPEG"]),
        (b"\0\0\0\x20ftypavif\0\0\0\0", ["AVIF", "page"]),
        (b"\0\0\0\x20ftypisom\0\0\0\0", ["a film", "still picture"]),
        (b"%PDF-1.7\n", ["PDF", "export"]),
        (b"8BPS\0\x01", ["Photoshop", "PNG"]),
        (b"PK\x03\x04\x14\0", ["archive", "unpack"]),
        (b"<!DOCTYPE html><html>", ["web page", "picture"]),
    ] {
        let text = refuse(bytes);
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    }
}

/// The letter as an SVG of its own size, drawn large.
const LETTER_SVG: &str = "<?xml version='1.0'?><!-- a letter -->
<svg xmlns='http://www.w3.org/2000/svg' width='60' height='40'><path d='M10 5h8v23h22v7h-30z'/></svg>";

#[test]
fn an_svg_is_drawn_without_fonts_and_other_files() {
    let found = ink(LETTER_SVG.as_bytes());
    assert_eq!((found.width, found.height), (1024, 683));
    assert!(difference(&found.resized(60, 40)) < 0.01, "{}", difference(&found.resized(60, 40)));
    let read = |text: &str| picture::decode_picture("letter.svg", text.as_bytes());
    let words = "<text x='1' y='30'>words</text></svg>";
    let noted = read(&LETTER_SVG.replace("</svg>", words)).unwrap();
    assert!(noted.notes()[0].contains("convert text to paths"), "{:?}", noted.notes());
    let only_words = read(&format!("<svg xmlns='http://www.w3.org/2000/svg'>{words}")).unwrap_err().to_string();
    assert!(only_words.contains("convert its text to paths"), "{only_words}");
    let outside = LETTER_SVG.replace("</svg>", "<image href='tests/strokes/ball.png' width='60' height='40'/></svg>");
    assert_eq!(ink(outside.as_bytes()), found, "no other file is opened");
    assert!(read("<svg xmlns='http://www.w3.org/2000/svg'><path d=").unwrap_err().is_bad_input());
}

#[test]
fn what_follows_a_jpeg_does_not_matter_and_what_lacks_does() {
    let whole = jpeg(letter());
    let with = |more: &[u8]| picture::decode_picture("letter.jpg", &[&whole, more].concat()).unwrap();
    let plain = with(b"");
    assert_eq!(with(b"\0\0\0\x18ftypmp42 a film \xff\xda that is none"), plain);
    assert_eq!(with(&whole), plain);
    let unended = &whole[..whole.len() - 2];
    assert_eq!(picture::decode_picture("letter.jpg", unended).unwrap(), plain);
    for lost in [24, 60, 200] {
        let cut = picture::decode_picture("letter.jpg", &whole[..whole.len() - lost]).unwrap_err().to_string();
        assert!(cut.contains("cut off"), "{lost}: {cut}");
    }
}

#[test]
fn a_photo_of_more_than_fifty_megapixels_is_scaled_down_and_it_is_said() {
    let photo = GrayImage::from_fn(8160, 6144, |x, y| Luma([if x.abs_diff(y) < 400 { 30 } else { 220 }]));
    let picture = picture::decode_picture("photo.jpg", &with_exif(&jpeg(photo), 6)).unwrap();
    assert_eq!((picture.width(), picture.height()), (1536, 2040));
    assert_eq!(picture.shrunk_from(), Some([6144, 8160]));
    assert!(picture.notes()[0].contains("6144 x 8160 px") && picture.notes()[0].contains("scaled down"));
    let (image, _) = picture::ink(&picture, Polarity::Auto).unwrap();
    let share = image.data.iter().sum::<f32>() / image.data.len() as f32;
    assert!((share - 0.096).abs() < 0.004, "{share}");
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

/// Each picture under tests, its share of ink as it was read when ink was told by luma alone, and whether its ink is light.
const SHARES: [(&str, f32, bool); 50] = [
    ("drawings/p01-words/front", 0.4745, false),
    ("drawings/p01-words/side", 0.4620, false),
    ("drawings/p02-garden/front", 0.0961, false),
    ("drawings/p02-garden/side", 0.1174, false),
    ("drawings/p03-faces/front", 0.0621, false),
    ("drawings/p03-faces/side", 0.0383, false),
    ("drawings/p04-brush-glyphs/front", 0.1500, false),
    ("drawings/p04-brush-glyphs/side", 0.2154, false),
    ("drawings/p05-tools/front", 0.0622, false),
    ("drawings/p05-tools/side", 0.0713, false),
    ("drawings/t01-animals/front", 0.0955, false),
    ("drawings/t01-animals/side", 0.0848, false),
    ("drawings/t01-animals/top", 0.0901, false),
    ("drawings/t02-bold-letters/front", 0.3416, false),
    ("drawings/t02-bold-letters/side", 0.4480, false),
    ("drawings/t02-bold-letters/top", 0.3439, false),
    ("drawings/t03-vehicles/front", 0.1371, false),
    ("drawings/t03-vehicles/side", 0.2435, false),
    ("drawings/t03-vehicles/top", 0.1370, false),
    ("drawings/t04-serif-glyphs/front", 0.2872, false),
    ("drawings/t04-serif-glyphs/side", 0.3089, false),
    ("drawings/t04-serif-glyphs/top", 0.1796, false),
    ("drawings/t05-hair-lines/front", 0.0289, false),
    ("drawings/t05-hair-lines/side", 0.0336, false),
    ("drawings/t05-hair-lines/top", 0.0432, false),
    ("drawings/t06-icons/front", 0.2922, false),
    ("drawings/t06-icons/side", 0.2381, false),
    ("drawings/t06-icons/top", 0.2212, false),
    ("drawings/t07-outlines/front", 0.0428, false),
    ("drawings/t07-outlines/side", 0.0344, false),
    ("drawings/t07-outlines/top", 0.0363, false),
    ("drawings/t08-solids/front", 0.3273, false),
    ("drawings/t08-solids/side", 0.4434, false),
    ("drawings/t08-solids/top", 0.2148, false),
    ("drawings/t09-dense/front", 0.1585, false),
    ("drawings/t09-dense/side", 0.2667, false),
    ("drawings/t09-dense/top", 0.0929, false),
    ("drawings/t10-thin-letters/front", 0.1438, true),
    ("drawings/t10-thin-letters/side", 0.1104, true),
    ("drawings/t10-thin-letters/top", 0.1107, true),
    ("strokes/ball", 0.3014, false),
    ("strokes/cat", 0.3102, false),
    ("strokes/face", 0.0644, false),
    ("strokes/fish", 0.0675, false),
    ("strokes/glyph", 0.2066, false),
    ("strokes/mushroom", 0.1311, false),
    ("strokes/pear", 0.0912, false),
    ("strokes/star", 0.2248, true),
    ("strokes/torus", 0.3458, false),
    ("strokes/vase", 0.1408, false),
];

#[test]
fn what_is_told_by_luma_is_read_as_ever() {
    for (name, wanted, light) in SHARES {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/{name}.png"));
        let (image, ground) = picture::ink(&picture::read_picture(&file).unwrap(), Polarity::Auto).unwrap();
        let share = image.data.iter().sum::<f32>() / image.data.len() as f32;
        assert!((share - wanted).abs() < 1e-3, "{name}: {share} of it is ink, not {wanted}");
        assert_eq!(ground.polarity == Polarity::LightInk, light, "{name}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, rng_seed: RngSeed::Fixed(4), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_never_panic(start in 0usize..9, bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let starts: [&[u8]; 9] = [b"GIF89a", b"BM", b"II*\0", b"<svg ", b"", b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff\xe0", b"RIFF\x40\0\0\0WEBPVP8L", b"RIFF\x40\0\0\0WEBPVP8 "];
        let mut all = starts[start].to_vec();
        all.extend(bytes);
        if let Ok(picture) = picture::decode_picture("random", &all) {
            let _ = picture::ink(&picture, Polarity::Auto);
        }
    }

    #[test]
    fn damaged_pictures_never_panic(
        format in 0usize..7, changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let grey = DynamicImage::from(letter());
        let mut bytes = match format {
            0 => encoded(&grey, ImageFormat::Png),
            1 => encoded(&grey.to_rgba8().into(), ImageFormat::WebP),
            2 => encoded(&grey.to_rgb8().into(), ImageFormat::Gif),
            3 => encoded(&grey.to_rgb8().into(), ImageFormat::Bmp),
            4 => encoded(&grey.to_luma16().into(), ImageFormat::Tiff),
            5 => LETTER_SVG.as_bytes().to_vec(),
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
