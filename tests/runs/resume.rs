//! Runs kept as bytes: they go on bit for bit, other runs and damaged bytes are refused, and nothing panics.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use std::sync::LazyLock;
use wire4d::settings::{Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::multiview::{Drawing, plan};
use wire4d::{Error, Result};

const SIDE: usize = 64;

/// A ring, a cross and a square's outline, which do not quite agree.
fn drawings() -> Vec<Drawing> {
    type Distance = fn(f64, f64) -> f64;
    let inks: [(&str, Distance); 3] = [
        ("Front", |x, y| ((x.hypot(y)) - 22.0).abs()),
        ("Side", |x, y| (x - y).abs().min((x + y).abs()).max((x.abs() - 22.0).max(0.0) * 4.0)),
        ("Top", |x, y| (x.abs().max((1.2 * y).abs()) - 20.0).abs()),
    ];
    let byte = |ink: Distance, i: usize| {
        let (x, y) = ((i % SIDE) as f64 + 0.5 - 32.0, (i / SIDE) as f64 + 0.5 - 32.0);
        (255.0 * (2.5 - ink(x, y)).clamp(0.0, 1.0)) as u8
    };
    inks.iter()
        .map(|&(name, ink)| {
            let bytes: Vec<u8> = (0..SIDE * SIDE).map(|i| byte(ink, i)).collect();
            Drawing::from_ink(name, SIDE, SIDE, &bytes).unwrap()
        })
        .collect()
}

fn settings(more: &[(&str, &str)]) -> Settings {
    let small = [("preset", "fast"), ("size", "64"), ("grid", "32"), ("iterations", "40")];
    Task::Multiview.settings(small.iter().chain(more).copied().collect::<Vec<_>>()).unwrap()
}

fn started(settings: &Settings) -> Run {
    Run::start(plan(&drawings(), settings).unwrap(), &mut |_| true).unwrap()
}

fn resumed(settings: &Settings, bytes: &[u8]) -> Result<Run> {
    Run::resume(plan(&drawings(), settings).unwrap(), bytes, &mut |_| true)
}

fn assert_same(a: &Run, b: &Run) {
    assert_eq!(a.session().wire(), b.session().wire());
    assert_eq!(a.session().events(), b.session().events());
    assert_eq!(a.sculpture(), b.sculpture());
    assert_eq!(a.bent(), b.bent());
    assert_eq!(a.loss_csv(), b.loss_csv());
    assert_eq!(a.result(), b.result());
}

#[test]
fn a_resumed_run_ends_where_an_uninterrupted_one_does() {
    let refined: &[(&str, &str)] = &[("bend", "none"), ("refine", "on"), ("reinit", "on"), ("min-width", "0")];
    for more in [&[("bend", "little")], &[("bend", "free")], refined] {
        let settings = settings(more);
        let mut straight = started(&settings);
        straight.step(usize::MAX).unwrap();
        // Before anything, in either stage, after re-initialisation and refinement, and at the end.
        for cut in [0, 5, 32, 33, 40] {
            let mut first = started(&settings);
            first.step(cut).unwrap();
            let bytes = first.checkpoint();
            let mut second = resumed(&settings, &bytes).unwrap();
            assert_eq!(second.checkpoint(), bytes, "what is read is what was written");
            second.step(usize::MAX).unwrap();
            assert_same(&second, &straight);
        }
    }
}

/// Bytes of a run after 20 of 40 iterations.
static SAVED: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut run = started(&settings(&[]));
    run.step(20).unwrap();
    run.checkpoint()
});

#[test]
fn settings_that_keep_the_run_may_change_and_others_are_named() {
    for more in [("smoothness", "5"), ("iterations", "60"), ("max-width", "3"), ("position-rate", "0.1"), ("seed", "9")]
    {
        let settings = settings(&[more]);
        let mut run = resumed(&settings, &SAVED).unwrap();
        assert_eq!(run.session().iteration(), 20);
        run.step(usize::MAX).unwrap();
        assert!(run.session().is_done() && run.session().iteration() == settings.iterations);
    }
    let mut thin = resumed(&settings(&[("max-width", "1.5")]), &SAVED).unwrap();
    thin.step(usize::MAX).unwrap();
    let px = plan(&drawings(), thin.settings()).unwrap().arrangement.height_world / 256.0;
    let widest = thin.sculpture().wire.control_points().iter().map(|point| point[3]).fold(0.0, f64::max);
    assert!(widest <= 1.5001 * px, "the new bound holds, also for the best wire: {} px", widest / px);
    for (name, value) in [
        ("size", "80"),
        ("bend", "none"),
        ("bend", "free"),
        ("form", "chain"),
        ("iterations", "19"),
        ("min_stroke", "32"),
    ] {
        match resumed(&settings(&[(name, value)]), &SAVED).err() {
            Some(Error::Setting { name: found, .. }) => assert_eq!(found, name),
            other => panic!("{name} = {value}: {other:?}"),
        }
    }
}

#[test]
fn other_drawings_and_foreign_bytes_are_refused_in_a_sentence() {
    let settings = settings(&[]);
    let mut other = drawings();
    other[1].ink.data[33 * SIDE + 50] = 1.0;
    let sentence = |error: Option<Error>| {
        assert!(matches!(error, Some(Error::Input { .. })), "{error:?}");
        error.unwrap().to_string()
    };
    let plan = plan(&other, &settings).unwrap();
    let error = sentence(Run::resume(plan, &SAVED, &mut |_| true).err());
    assert!(error.contains("other drawings"), "{error}");
    for foreign in [&b""[..], b"W4R", b"\x89PNG\r\n\x1a\n and more", &[0; 64]] {
        assert!(sentence(resumed(&settings, foreign).err()).contains("none of a run"));
    }
    let mut newer = SAVED.clone();
    newer[3] += 1;
    assert!(sentence(resumed(&settings, &newer).err()).contains("version"));
}

fn is_refused(bytes: &[u8]) -> bool {
    matches!(resumed(&settings(&[]), bytes).err(), Some(Error::Input { .. }))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, rng_seed: RngSeed::Fixed(3), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damage_is_noticed(at in any::<prop::sample::Index>(), bit in 0u8..8, keep in any::<prop::sample::Index>()) {
        let mut flipped = SAVED.clone();
        let at = at.index(flipped.len());
        flipped[at] ^= 1 << bit;
        prop_assert!(is_refused(&flipped), "bit {bit} of byte {at}");
        let cut = &SAVED[..keep.index(SAVED.len())];
        prop_assert!(is_refused(cut), "{} bytes", cut.len());
    }

    /// Damage with a checksum that fits is refused or makes a run like any other.
    #[test]
    fn forged_bytes_are_survived(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4), heading in any::<bool>(),
        keep in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut forged = SAVED.clone();
        if let Some(keep) = keep {
            forged.truncate(8 + keep.index(forged.len() - 8));
        }
        for (at, byte) in edits {
            // Half of the time among the counters and lengths at the front.
            let end = if heading { forged.len().min(2000) } else { forged.len() };
            if end > 8 {
                forged[8 + at.index(end - 8)] = byte;
            }
        }
        let checksum = crc32fast::hash(&forged[8..]).to_le_bytes();
        forged[4..8].copy_from_slice(&checksum);
        if let Ok(mut run) = resumed(&settings(&[]), &forged) {
            run.step(3).unwrap();
            prop_assert!(run.sculpture().wire.control_points().iter().flatten().all(|c| c.is_finite()));
        }
    }
}
