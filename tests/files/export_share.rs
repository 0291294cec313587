//! Share codes are short, true to the picture, and survive everything.

use crate::export_support;

use export_support as wires;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use wire4d::Error;
use wire4d::export::{open_link, open_share_code, share_code, simplified_code};
use wire4d::sculpture::{Sculpture, strands};
use wire4d::view::View;
use wire4d::wire::{Form, Wire};

/// How far the curve moved, in pixels at 512, as it is seen: from each of 16 samples a span, the way to the other curve
/// nearby and what the radius differs by there; the most of all views, there and back.
fn moved_px(before: &Sculpture, after: &Sculpture) -> f64 {
    let mut worst = 0.0f64;
    let [a, b] = [before, after].map(|sculpture| strands(&sculpture.wire, 16));
    assert_eq!(a.len(), b.len());
    for view in &before.views {
        let longer = view.width_px.max(view.height_px);
        let camera = view.with_size(view.width_px * 512 / longer, view.height_px * 512 / longer).camera::<f64>();
        for (a, b) in a.iter().zip(&b) {
            let [a, b] =
                [a, b].map(|strand| strand.points.iter().map(|point| camera.project(point)).collect::<Vec<_>>());
            worst = worst.max(strayed_px(&a, &b)).max(strayed_px(&b, &a));
        }
    }
    worst
}

fn strayed_px(from: &[[f64; 3]], to: &[[f64; 3]]) -> f64 {
    let apart = |p: &[f64; 3], a: &[f64; 3], b: &[f64; 3]| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let share = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy).max(1e-300);
        let share = share.clamp(0.0, 1.0);
        (p[0] - a[0] - share * dx).hypot(p[1] - a[1] - share * dy) + (p[2] - a[2] - share * (b[2] - a[2])).abs()
    };
    let nearest = |(i, p): (usize, &[f64; 3])| {
        let near = &to[i.saturating_sub(16)..(i + 17).min(to.len())];
        near.windows(2).map(|pair| apart(p, &pair[0], &pair[1])).fold(f64::INFINITY, f64::min)
    };
    from.iter().enumerate().map(nearest).fold(0.0, f64::max)
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
    points[30][1] += 0.006;
    let other = Sculpture { wire: Wire::open_uniform(points).unwrap(), ..sculpture.clone() };
    assert!(moved_px(&sculpture, &other) > 0.3);
}

#[test]
fn codes_are_short() {
    let length = |wire: Wire| check("short", &wires::sculpture(wire)).len();
    let mut lengths = vec![];
    for seed in 0..5 {
        for (most, wire) in [
            (1900, wires::random(seed, 220)),
            (850, wires::smooth(seed, 220)),
            (1250, wires::refined(&wires::smooth(seed, 160), seed, 6)),
            (3600, wires::smooth(seed, 1000)),
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

/// What is between the version and the checksum.
fn packed(code: &str) -> Vec<u8> {
    let mut bits = vec![];
    for c in code.bytes() {
        let value = match c {
            b'A'..=b'Z' => c - b'A',
            b'a'..=b'z' => c - b'a' + 26,
            b'0'..=b'9' => c - b'0' + 52,
            b'-' => 62,
            _ => 63,
        };
        bits.extend((0..6).rev().map(|k| value >> k & 1));
    }
    let bytes: Vec<u8> = bits.chunks_exact(8).map(|b| b.iter().fold(0, |v, bit| v << 1 | bit)).collect();
    bytes[1..bytes.len() - 4].to_vec()
}

/// Codes that were made once, and what they hold.
#[derive(serde::Deserialize)]
struct Fixture {
    name: String,
    code: String,
    closed: bool,
    seed: String,
    task: String,
    views: Vec<View>,
    points: usize,
}

/// Those of version 1 are `codes`, those of version 2 `codes-2`; the page's reader is held to the same.
fn fixtures(file: &str) -> Vec<Fixture> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/www/packages/wire-sculpture/src/testdata");
    serde_json::from_str(&std::fs::read_to_string(format!("{folder}/{file}.json")).unwrap()).unwrap()
}

#[test]
fn codes_of_every_version_open() {
    for file in ["codes", "codes-2"] {
        for Fixture { name, code, closed, seed, task, views, points } in fixtures(file) {
            let opened = open_share_code(&code).unwrap_or_else(|error| panic!("{file}, {name}: {error}"));
            assert_eq!(opened.wire.closed(), closed, "{file}, {name}");
            assert_eq!(opened.wire.control_points().len(), points, "{file}, {name}");
            assert_eq!((opened.made_with.seed.to_string(), opened.made_with.task), (seed, task), "{file}, {name}");
            assert_eq!(opened.views, views, "{file}, {name}");
        }
    }
}

#[test]
fn simplified_wires_fit_and_say_how_far_they_are_off() {
    let sculpture = wires::sculpture(wires::smooth(3, 1500));
    let whole = share_code(&sculpture).len();
    assert!(whole > 3500);
    let mut before = f64::INFINITY;
    for most in [1500, 2200, 3200] {
        let simplified = simplified_code(&sculpture, most).unwrap();
        assert!(
            simplified.code.len() <= most && simplified.code.len() * 10 > most * 8,
            "{most}: {}",
            simplified.code.len()
        );
        let opened = open_share_code(&simplified.code).unwrap();
        // Coarser steps alone may do; where they do not, there are fewer points.
        assert!(opened.wire.control_points().len() <= 1500);
        assert!(most > 1500 || opened.wire.control_points().len() < 1500);
        assert_eq!(opened.views, sculpture.views);
        // The more room, the nearer.
        assert!(simplified.mean_px < before && simplified.mean_px < simplified.most_px, "{simplified:?}");
        before = simplified.mean_px;
    }
    assert!(simplified_code(&sculpture, 60).is_none(), "nothing is that short");
    let roomy = simplified_code(&wires::sculpture(wires::smooth(3, 100)), 9000).unwrap();
    assert!(roomy.most_px < 2.5, "all its control points are there: {roomy:?}");
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
    assert!(problem(&sealed(3, &[1, 2, 3])).contains("update Wire4D"));
    assert!(problem(&sealed(0, &[1, 2, 3])).contains("damaged"));
    for version in [1, 2] {
        problem(&sealed(version, &[]));
        problem(&sealed(version, &[0; 40]));
        problem(&sealed(version, &[0xff; 40]));
        // 64 kB and no more; whatever it says, it is read or refused in no time.
        assert!(problem(&sealed(version, &vec![0xa5; 65 << 10])).contains("longer"));
        let started = std::time::Instant::now();
        for byte in [0x00, 0x5a, 0xff] {
            let _ = open_link(&sealed(version, &vec![byte; 63 << 10]));
        }
        assert!(started.elapsed().as_secs() < 30);
    }
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
        for version in [1, 2] {
            if let Ok(sculpture) = open_share_code(&sealed(version, &packed)) {
                prop_assert!(sculpture.wire.control_points().iter().flatten().all(|c| c.is_finite()));
            }
        }
    }

    /// As above, from a valid code with a byte changed.
    #[test]
    fn forged_codes_are_survived(seed in 0u64..20, at in any::<prop::sample::Index>(), byte in any::<u8>(), cut in any::<bool>()) {
        let code = share_code(&wires::sculpture(wires::smooth(seed, 30)));
        for (version, mut packed) in [(2, packed(&code)), (1, packed(&fixtures("codes")[5].code))] {
            prop_assert!(version == 1 || sealed(2, &packed) == code);
            let at = at.index(packed.len());
            packed[at] = byte;
            if cut {
                packed.truncate(at + 1);
            }
            if let Ok(sculpture) = open_share_code(&sealed(version, &packed)) {
                prop_assert!(sculpture.wire.control_points().iter().flatten().all(|c| c.is_finite()));
                prop_assert!(sculpture.views.iter().all(|view| view.check().is_ok()));
            }
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
