//! Share codes are short, true to the picture, and survive everything.

use crate::export_support;

use export_support as wires;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use wire4d::Error;
use wire4d::export::{open_link, open_share_code, share_code};
use wire4d::sculpture::{Sculpture, strands};
use wire4d::view::View;
use wire4d::wire::{Form, Wire};

/// How far anything moved, in pixels at 512: centre line plus radius, over all views and 16 samples a span.
fn moved_px(before: &Sculpture, after: &Sculpture) -> f64 {
    let mut worst = 0.0f64;
    let [a, b] = [before, after].map(|sculpture| strands(&sculpture.wire, 16));
    assert_eq!(a.len(), b.len());
    for view in &before.views {
        let longer = view.width_px.max(view.height_px);
        let camera = view.with_size(view.width_px * 512 / longer, view.height_px * 512 / longer).camera::<f64>();
        for (p, q) in a.iter().flat_map(|s| &s.points).zip(b.iter().flat_map(|s| &s.points)) {
            let ([x, y, r], [u, v, s]) = (camera.project(p), camera.project(q));
            worst = worst.max((x - u).hypot(y - v) + (r - s).abs());
        }
    }
    worst
}

fn check(name: &str, sculpture: &Sculpture) -> String {
    let code = share_code(sculpture);
    assert!(code.bytes().all(|c| c.is_ascii_alphanumeric() || c == b'-' || c == b'_'), "{name}");
    let opened = open_share_code(&code).unwrap_or_else(|error| panic!("{name}: {error}"));
    let moved = moved_px(sculpture, &opened);
    assert!(moved <= 0.3, "{name}: moved {moved} px");
    assert_eq!(opened.views, sculpture.views, "{name}");
    assert_eq!(opened.made_with.seed, sculpture.made_with.seed);
    assert_eq!(opened.made_with.task, sculpture.made_with.task);
    assert_eq!((opened.wire.form(), opened.wire.closed()), (sculpture.wire.form(), sculpture.wire.closed()));
    if sculpture.views == View::canonical(2.2, 256) {
        assert_eq!(share_code(&opened), code, "{name}: sharing again changes nothing");
    }
    code
}

#[test]
fn every_wire_survives() {
    for (name, wire) in wires::all() {
        check(name, &wires::sculpture(wire.clone()));
        check(name, &Sculpture { views: vec![wires::perspective()], ..wires::sculpture(wire.clone()) });
        check(name, &Sculpture { views: vec![], ..wires::sculpture(wire) });
    }
}

#[test]
fn the_error_measure_can_fail() {
    let sculpture = wires::sculpture(wires::helix());
    let mut points = sculpture.wire.control_points().to_vec();
    points[30][1] += 0.004;
    let other = Sculpture { wire: Wire::open_uniform(points).unwrap(), ..sculpture.clone() };
    assert!(moved_px(&sculpture, &other) > 0.3);
}

#[test]
fn codes_are_short() {
    let length = |wire: Wire| check("short", &wires::sculpture(wire)).len();
    let mut lengths = vec![];
    for seed in 0..5 {
        for (most, wire) in [
            (2000, wires::random(seed, 220)),
            (1100, wires::smooth(seed, 220)),
            (1400, wires::refined(&wires::smooth(seed, 160), seed, 6)),
            (5000, wires::smooth(seed, 1000)),
        ] {
            let (count, length) = (wire.control_points().len(), length(wire));
            lengths.push((count, length));
            assert!(length <= most, "{count} control points take {length} characters");
        }
    }
    println!("{lengths:?}");
}

#[test]
fn rough_wires_on_any_knots_in_any_three_views_fit() {
    // The worst of everything at once: random points, random knots, views with nothing round about them.
    let mut rng = wire4d::rng::Rng::new(3, 3);
    let points = wires::random(9, 220).control_points().to_vec();
    let mut knots = vec![0.0; 4];
    for _ in 0..217 {
        knots.push(knots[knots.len() - 1] + rng.range(0.3, 1.0));
    }
    knots.extend([knots[knots.len() - 1]; 3]);
    let wire = Wire::new(Form::Spline, false, knots, points).unwrap();
    let views = (0..3).map(|i| View::orthographic("view", 0.1 + i as f64, 0.2, 2.2, 256)).collect();
    let code = check("rough", &Sculpture { views, ..wires::sculpture(wire) });
    println!("{}", code.len());
    assert!(code.len() <= 2400, "{}", code.len());
}

#[test]
fn knots_made_by_halving_come_back_exactly() {
    let wire = wires::refined(&wires::smooth(1, 60), 4, 8);
    let opened = open_share_code(&share_code(&wires::sculpture(wire.clone()))).unwrap();
    assert_eq!(opened.wire.knots(), wire.knots());
}

#[test]
fn links_and_spaces_are_understood() {
    let code = share_code(&wires::sculpture(wires::helix()));
    let plain = open_share_code(&code).unwrap();
    for text in
        [format!("  {code}\n"), format!("https://example.org/wire/#{code}"), format!("http://localhost/#wire={code}")]
    {
        assert_eq!(open_link(&text).unwrap(), plain);
    }
}

/// What an e-mail program, a chat and a document made of a link.
#[test]
fn links_from_the_field_open() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/field/share-link");
    let read = |name: &str| std::fs::read_to_string(format!("{folder}/{name}.txt")).unwrap();
    let plain = open_link(&read("good")).unwrap();
    assert!(plain.wire.control_points().len() > 100);
    for name in ["angle-brackets", "as-readme-says", "full-stop", "html-mail", "wrapped-by-mail"] {
        assert_eq!(open_link(&read(name)).unwrap(), plain, "{name}");
    }
    let quoted = read("wrapped-by-mail").lines().map(|line| format!("> {line}\r\n")).collect::<String>();
    assert_eq!(open_link(&format!("{quoted}> \r\n> See you, Anna\r\n")).unwrap(), plain);
    let wrapped = read("wrapped-by-mail");
    let cut = &wrapped[..wrapped.len() / 2];
    assert!(problem(cut).contains("damaged or incomplete"));
}

fn problem(text: &str) -> String {
    let error = open_link(text).unwrap_err();
    assert!(matches!(error, Error::ShareCode { .. }), "{error:?}");
    let line = error.to_string();
    assert!(line.starts_with("share code: ") && !line.contains('\n') && line.len() < 300, "{line}");
    line
}

/// A valid envelope round anything.
fn sealed(version: u8, packed: &[u8]) -> String {
    const ALPHABET: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let mut bytes = vec![version];
    bytes.extend(packed);
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let bits: Vec<u8> = bytes.iter().flat_map(|byte| (0..8).rev().map(move |k| byte >> k & 1)).collect();
    let value = |chunk: &[u8]| (0..6).fold(0, |v, k| v << 1 | chunk.get(k).copied().unwrap_or(0));
    bits.chunks(6).map(|chunk| char::from(ALPHABET[value(chunk) as usize])).collect()
}

#[test]
fn bad_codes_get_a_plain_sentence() {
    let code = share_code(&wires::sculpture(wires::helix()));
    assert!(problem("").contains("empty"));
    assert!(problem("  \n").contains("empty"));
    assert!(problem("hello, world").contains("neither a link"));
    assert!(problem("https://example.org/#w=").contains("empty"));
    assert!(problem(&code[..code.len() - 1]).contains("damaged"));
    assert!(problem(&code[1..]).contains("damaged"));
    assert!(problem(&"A".repeat(2 << 20)).contains("longer"));
    assert!(problem(&sealed(2, &[1, 2, 3])).contains("update Wire4D"));
    assert!(problem(&sealed(0, &[1, 2, 3])).contains("damaged"));
    problem(&sealed(1, &[]));
    problem(&sealed(1, &[0; 40]));
    problem(&sealed(1, &[0xff; 40]));
    problem("é\u{0}\u{10ffff}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, rng_seed: RngSeed::Fixed(4), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_survived(text in ".{0,200}") {
        prop_assert!(open_share_code(&text).is_err() && open_link(&text).is_err());
    }

    /// The checksum is right, so the contents are really read: counts, numbers, views are all random.
    #[test]
    fn hostile_contents_are_survived(packed in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Ok(sculpture) = open_share_code(&sealed(1, &packed)) {
            prop_assert!(sculpture.wire.control_points().iter().flatten().all(|c| c.is_finite()));
        }
    }

    /// As above, from a valid code with a byte changed.
    #[test]
    fn forged_codes_are_survived(seed in 0u64..20, at in any::<prop::sample::Index>(), byte in any::<u8>()) {
        let code = share_code(&wires::sculpture(wires::smooth(seed, 30)));
        let mut bits = vec![];
        for c in code.bytes() {
            let value = match c {
                b'A'..=b'Z' => c - b'A', b'a'..=b'z' => c - b'a' + 26, b'0'..=b'9' => c - b'0' + 52, b'-' => 62, _ => 63,
            };
            bits.extend((0..6).rev().map(|k| value >> k & 1));
        }
        let bytes: Vec<u8> = bits.chunks_exact(8).map(|b| b.iter().fold(0, |v, bit| v << 1 | bit)).collect();
        let mut packed = bytes[1..bytes.len() - 4].to_vec();
        prop_assert!(sealed(1, &packed) == code);
        let at = at.index(packed.len());
        packed[at] = byte;
        if let Ok(sculpture) = open_share_code(&sealed(1, &packed)) {
            prop_assert!(sculpture.wire.control_points().iter().flatten().all(|c| c.is_finite()));
            prop_assert!(sculpture.views.iter().all(|view| view.check().is_ok()));
        }
    }

    #[test]
    fn every_changed_character_is_noticed(at in any::<prop::sample::Index>(), to in 0usize..64) {
        let code = share_code(&wires::sculpture(wires::helix()));
        let at = at.index(code.len());
        let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
        let mut changed = code.clone().into_bytes();
        changed[at] = letters[to];
        let changed = String::from_utf8(changed).unwrap();
        prop_assert_eq!(open_share_code(&changed).is_ok(), changed == code);
    }

    #[test]
    fn random_wires_round_trip(seed in any::<u64>(), count in 4usize..60, closed in any::<bool>()) {
        let points = wires::random(seed, count).control_points().to_vec();
        let wire = if closed { Wire::closed_uniform(points) } else { Wire::open_uniform(points) };
        check("random", &wires::sculpture(wire.unwrap()));
    }
}
