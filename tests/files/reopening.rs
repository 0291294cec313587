//! Files that carry a wire open again, whatever happened to them on the way.

use crate::export_support as wires;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::LazyLock;
use wire4d::Error;
use wire4d::export::{ExportOptions, Format, Opened, export, in_png, open_file, share_code};
use wire4d::sculpture::{Carried, MadeWith, Sculpture, Silhouette};

/// What would be markup, if anybody took it for that.
const HOSTILE: &str = "</metadata><script>alert(1)</script>&lt;\"'\u{0}\u{fffe}]]>🦊";
/// What a file may grow by.
const MOST_MORE: usize = 60_000;

fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [kind, data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &body, &crc32fast::hash(&body).to_be_bytes()].concat()
}

/// A grey picture of that size, with `pixels` for what is packed in it.
fn grey(width: u32, height: u32, pixels: &[u8]) -> Vec<u8> {
    let heading = [&width.to_be_bytes()[..], &height.to_be_bytes(), &[8, 0, 0, 0, 0]].concat();
    [b"\x89PNG\r\n\x1a\n".to_vec(), chunk(b"IHDR", &heading), chunk(b"IDAT", pixels), chunk(b"IEND", &[])].concat()
}

fn silhouette(view: &str, label: &str, pixels: &[u8]) -> Silhouette {
    Silhouette { view: view.into(), label: label.into(), png: grey(256, 200, pixels) }
}

fn sculpture(carried: Carried) -> Sculpture {
    let settings = serde_json::json!({ "preset": "fast", "iterations": 40, "title": HOSTILE });
    let serde_json::Value::Object(settings) = settings else { unreachable!() };
    let made_with = MadeWith { task: "multiview".into(), seed: 7, settings, wire4d: "9.9.9".into() };
    let mut sculpture = Sculpture { made_with, carried, ..wires::sculpture(wires::helix()) };
    sculpture.views[1].name = "mine-2".into();
    sculpture
}

fn full() -> Carried {
    Carried {
        drawings: vec![silhouette("front", HOSTILE, &[1; 900]), silhouette(HOSTILE, "star", &[2; 1200])],
        given: BTreeMap::from([("shape".into(), "vase".into()), (HOSTILE.into(), HOSTILE.into())]),
        replay: (0..9000).map(|i| (i * i) as u8).collect(),
    }
}

fn picture() -> Vec<u8> {
    grey(64, 64, &[3; 5000])
}

/// A file of each kind that carries a sculpture, by its name.
fn files(sculpture: &Sculpture) -> Vec<(&'static str, Vec<u8>)> {
    let options = ExportOptions::default();
    let written = |format| export(sculpture, format, Some(&sculpture.views[0]), None, &options).unwrap();
    vec![
        ("it.wire.json", written(Format::WireJson)),
        ("it.svg", written(Format::Svg)),
        ("it.lines.svg", written(Format::Lines)),
        ("it.glb", written(Format::Glb)),
        ("it.png", in_png(&picture(), sculpture).unwrap()),
    ]
}

fn problem(name: &str, bytes: &[u8]) -> String {
    let error = open_file(name, bytes).unwrap_err();
    let line = error.to_string();
    assert!(matches!(error, Error::Wire { .. }) && line.starts_with(name) && !line.contains('\n'), "{line}");
    line
}

fn assert_same(name: &str, before: &Sculpture, opened: &Opened) {
    let Opened { sculpture: after, code, notes } = opened;
    assert!(notes.is_empty(), "{name}: {notes:?}");
    assert_eq!((&after.views, &after.made_with), (&before.views, &before.made_with), "{name}");
    assert_eq!(after.carried, before.carried, "{name}");
    assert_eq!(share_code(after), share_code(before), "{name}: the same wire");
    assert!(code.as_ref().is_none_or(|code| code == &share_code(before)), "{name}");
}

#[test]
fn what_was_carried_comes_back_from_every_kind_of_file() {
    for carried in [full(), Carried::default()] {
        let before = sculpture(carried);
        for (name, bytes) in files(&before) {
            assert_same(name, &before, &open_file(name, &bytes).unwrap());
            // The bytes tell what it is, not the name.
            assert_same(name, &before, &open_file("download (3)", &bytes).unwrap());
        }
    }
    assert_eq!(open_file("x", sculpture(full()).to_json().as_bytes()).unwrap().sculpture, sculpture(full()), "exactly");
}

#[test]
fn files_grow_by_60_kb_at_most_and_the_replay_stays_behind_first() {
    let bare: BTreeMap<_, _> = files(&sculpture(Carried::default())).into_iter().collect();
    let drawn = || vec![silhouette("front", "a", &[5; 9000])];
    let large = sculpture(Carried { drawings: drawn(), replay: vec![7; 39_000], ..Carried::default() });
    let huge = sculpture(Carried { drawings: vec![silhouette("front", "a", &[5; 60_000]); 3], ..full() });
    for (name, bytes) in files(&large).into_iter().chain(files(&huge)) {
        assert!(bytes.len() < bare[name].len() + MOST_MORE, "{name}: {}", bytes.len());
        let opened = open_file(name, &bytes).unwrap();
        assert!(opened.notes.is_empty() && opened.sculpture.carried.replay.is_empty(), "{name}");
        assert_eq!(opened.sculpture.views, large.views);
    }
    let [(_, json), ..] = &files(&large)[..] else { unreachable!() };
    assert_eq!(open_file("x", json).unwrap().sculpture.carried.drawings, drawn());
}

#[test]
fn nothing_of_it_is_markup() {
    let (full, bare) = (files(&sculpture(full())), files(&sculpture(Carried::default())));
    let mut seen = 0;
    for ((name, bytes), (_, bare)) in full.iter().zip(&bare).filter(|((name, _), _)| name.ends_with("svg")) {
        let text = std::str::from_utf8(bytes).unwrap();
        let count = |text: &str| text.matches(['<', '>', '&']).count();
        assert_eq!(count(text), count(std::str::from_utf8(bare).unwrap()), "{name}");
        assert!(text.is_ascii() && !text.contains("script>"), "{name}");
        seen += 1;
    }
    assert_eq!(seen, 2);
}

#[test]
fn an_svg_that_escapes_quotes_still_opens() {
    let before = sculpture(full());
    let svg = String::from_utf8(files(&before).remove(1).1).unwrap();
    let (head, rest) = svg.split_once("id=\"wire4d\">").unwrap();
    let (capsule, tail) = rest.split_once("</metadata>").unwrap();
    let again = format!("{head}id=\"wire4d\">{}</metadata>{tail}", capsule.replace('"', "&quot;"));
    assert_same("again", &before, &open_file("again", again.as_bytes()).unwrap());
}

#[test]
fn files_of_others_hold_no_wire() {
    let options = ExportOptions::default();
    let stl = export(&sculpture(full()), Format::Stl, None, None, &options).unwrap();
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"><metadata>wire4d</metadata></svg>";
    let scene = br#"{"asset":{"version":"2.0"},"extras":{"wire4d":{"version":"0.1.0","seed":3}}}    "#;
    let mut glb = [b"glTF\x02\0\0\0", &(20 + scene.len() as u32).to_le_bytes()[..]].concat();
    glb.extend([&(scene.len() as u32).to_le_bytes()[..], b"JSON", scene].concat());
    let others =
        [picture(), svg.into(), b"<!doctype html><p>404".to_vec(), glb, stl, b"v 0 0 0\n".to_vec(), vec![0xff; 99]];
    for bytes in others {
        let words = problem("theirs", &bytes);
        assert!(words.contains("holds no wire") && words.contains("saved it again"), "{words}");
    }
    assert!(problem("none", b"").contains("empty"));
    assert!(problem("other.json", b"{\"format\":\"gltf\"}").contains("format"));
    assert!(in_png(b"GIF89a", &sculpture(full())).is_err());
}

#[test]
fn a_newer_version_says_so() {
    let newer = |bytes: &[u8]| -> Vec<u8> {
        let at = bytes.windows(11).position(|window| window == b"\"version\":1").unwrap();
        let mut bytes = bytes.to_vec();
        bytes[at + 10] = b'2';
        bytes
    };
    for (name, bytes) in files(&sculpture(full())) {
        let bytes = match name {
            // With the checksum that a newer program would write.
            "it.png" => {
                let length = u32::from_be_bytes(bytes[33..37].try_into().unwrap()) as usize;
                let text = newer(&bytes[41..41 + length]);
                [&bytes[..33], &chunk(b"iTXt", &text), &bytes[45 + length..]].concat()
            }
            _ => newer(&bytes),
        };
        assert!(problem(name, &bytes).contains("update Wire4D"), "{name}");
    }
}

#[test]
fn damaged_drawings_are_left_out_and_the_wire_opens() {
    let good = sculpture(full());
    let value = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut value: serde_json::Value = serde_json::from_str(&good.to_json()).unwrap();
        change(&mut value);
        open_file("it", value.to_string().as_bytes()).unwrap()
    };
    assert_same("unchanged", &good, &value(&|_| {}));
    let text = |bytes: &[u8]| -> serde_json::Value {
        let made = Sculpture {
            carried: Carried {
                drawings: vec![Silhouette { png: bytes.to_vec(), ..silhouette("a", "b", &[]) }],
                ..Carried::default()
            },
            ..good.clone()
        };
        serde_json::from_str::<serde_json::Value>(&made.to_json()).unwrap()["drawings"][0]["png"].clone()
    };
    let mut flipped = grey(8, 8, &[1; 40]);
    flipped[50] ^= 1;
    let whole = grey(8, 8, &[1; 40]);
    let colour = [&whole[..8], &chunk(b"IHDR", &[0, 0, 0, 8, 0, 0, 0, 8, 8, 2, 0, 0, 0]), &whole[33..]].concat();
    let bad =
        [grey(257, 8, &[1]), grey(8, 0, &[1]), flipped, whole[..whole.len() - 1].to_vec(), colour, b"GIF89a".to_vec()];
    for png in bad.map(|bytes| text(&bytes)).into_iter().chain(["?".into(), 3.into(), "A".repeat(200_000).into()]) {
        let Opened { sculpture, notes, .. } = value(&|value| value["drawings"][0]["png"] = png.clone());
        assert_eq!((sculpture.carried.drawings.len(), notes.len()), (1, 1), "{notes:?}");
        assert_eq!(sculpture.wire, good.wire);
    }
    assert_eq!(
        value(&|value| value["drawings"][0]["png"] = text(&whole)).notes,
        [] as [String; 0],
        "the sibling that must pass"
    );
    for (field, junk) in [
        ("drawings", 3.into()),
        ("given", serde_json::json!({ "a": 1 })),
        ("given", serde_json::json!({ "a": "x".repeat(9999) })),
        ("replay", "!".into()),
        ("replay", "A".repeat(60_000).into()),
    ] {
        let Opened { sculpture, notes, .. } = value(&|value| value[field] = junk.clone());
        assert_eq!((sculpture.wire == good.wire, notes.len()), (true, 1), "{field}: {notes:?}");
    }
    let many = value(&|value| value["drawings"] = vec![value["drawings"][0].clone(); 65].into());
    assert_eq!((many.sculpture.carried.drawings.len(), many.notes.len()), (64, 1));
}

/// Its name, its bytes, and where in them the capsule is.
type Placed = (&'static str, Vec<u8>, Range<usize>);

static FILES: LazyLock<Vec<Placed>> = LazyLock::new(|| {
    let carrying = files(&sculpture(full()));
    let place = |(name, bytes): (&'static str, Vec<u8>)| {
        let at = bytes.windows(9).position(|window| window == b"\"format\":").unwrap_or(0);
        let end = if name == "it.wire.json" { bytes.len() } else { at + 16_000 };
        (name, bytes, at..end)
    };
    carrying.into_iter().map(place).collect()
});

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, rng_seed: RngSeed::Fixed(18), ..ProptestConfig::default() })]

    /// Whatever byte is flipped, in the capsule or anywhere, there is the very wire or a sentence.
    #[test]
    fn flipped_bytes_are_told_or_harmless(file in 1usize..5, at in 0.0..1.0f64, inside in any::<bool>(), flip in 1u8..) {
        let (name, bytes, capsule) = &FILES[file];
        let region = if inside { capsule.clone() } else { 0..bytes.len() };
        let mut bytes = bytes.clone();
        let at = region.start + (at * (region.end.min(bytes.len()) - region.start) as f64) as usize;
        bytes[at] ^= flip;
        match open_file(name, &bytes) {
            Ok(Opened { sculpture: after, .. }) => {
                let before = sculpture(full());
                prop_assert_eq!(share_code(&after), share_code(&before));
                prop_assert_eq!((after.views, after.made_with.seed), (before.views, before.made_with.seed));
            }
            Err(error) => prop_assert!(error.to_string().starts_with(name), "{}", error),
        }
    }

    #[test]
    fn cut_off_files_are_told_or_whole(file in 0usize..5, share in 0.0..1.0f64) {
        let (name, bytes, _) = &FILES[file];
        match open_file(name, &bytes[..(share * bytes.len() as f64) as usize]) {
            Ok(opened) => assert_same(name, &sculpture(full()), &opened),
            Err(error) => prop_assert!(error.to_string().starts_with(name), "{}", error),
        }
    }

    #[test]
    fn any_bytes_are_survived(kind in 0usize..6, bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let heads: [&[u8]; 6] = [b"", b"\x89PNG\r\n\x1a\n", b"glTF\x02\0\0\0", b"<svg><metadata id=\"wire4d\">", b"{\"format\":\"wire4d\",\"version\":1", b"\x89PNG\r\n\x1a\n\xff\xff\xff\xff"];
        prop_assert!(open_file("x", &[heads[kind], &bytes].concat()).is_err());
    }
}
