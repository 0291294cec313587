//! Replays are small, come back as they were, and survive everything.

use crate::export_support as wires;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use wire4d::Error;
use wire4d::export::replay::{MAX_BYTES, MAX_WIRES, decode, encode};
use wire4d::wire::Wire;

/// A wire that comes to rest: much moves at first. Now and then it gets more control points.
fn run(count: usize, wires: usize) -> Vec<(u32, Wire)> {
    let at = |k: usize| {
        let far = 0.3 * (-(k as f64) / 8.0).exp();
        let wire = wires::smooth(5, count + count / 10 * (3 * k / wires));
        let swing = |i: usize, c: usize| far * (i as f64 * 0.21 + c as f64).sin();
        let points = wire.control_points().iter().enumerate();
        let points = points.map(|(i, p)| [p[0] + swing(i, 0), p[1] + swing(i, 1), p[2] + swing(i, 2), p[3]]);
        (10 * k as u32, Wire::open_uniform(points.collect()).unwrap())
    };
    (0..wires).map(at).collect()
}

fn most_apart(one: &Wire, other: &Wire) -> f64 {
    let pairs = one.control_points().iter().zip(other.control_points());
    pairs.flat_map(|(p, q)| (0..4).map(move |c| (p[c] - q[c]).abs())).fold(0.0, f64::max)
}

#[test]
fn wires_come_back_nearly_where_they_were() {
    let given = run(300, 60);
    let bytes = encode(&given);
    assert_eq!(encode(&given), bytes, "the same each time");
    assert!((500..20_000).contains(&bytes.len()), "{} bytes", bytes.len());
    let shown = decode(&bytes).unwrap();
    assert!((20..=MAX_WIRES).contains(&shown.len()), "{}", shown.len());
    assert_eq!((shown[0].0, shown[shown.len() - 1].0), (0, given[59].0), "from the first to the last");
    for (iteration, wire) in &shown {
        let (_, before) = given.iter().find(|(known, _)| known == iteration).unwrap();
        assert_eq!((wire.closed(), wire.knots()), (before.closed(), before.knots()));
        // Half a step, in single precision.
        assert!(most_apart(wire, before) < 0.0023, "{iteration}");
    }
    let early = shown.iter().filter(|(iteration, _)| *iteration < 300).count();
    assert!(early > shown.len() / 2, "more where more moves: {early} of {}", shown.len());
}

#[test]
fn long_wires_get_coarser_or_fewer() {
    for count in [1400, 6000] {
        let bytes = encode(&run(count, 50));
        assert!(!bytes.is_empty() && bytes.len() <= MAX_BYTES, "{count}: {} bytes", bytes.len());
        let shown = decode(&bytes).unwrap();
        assert!(shown.len() >= 6, "{count}: {}", shown.len());
    }
    assert!(encode(&run(30, 1)).is_empty() && encode(&[]).is_empty(), "nothing to play");
}

#[test]
fn every_truncation_and_every_flipped_bit_is_noticed() {
    let bytes = encode(&run(20, 8));
    for cut in 0..bytes.len() {
        refused(&bytes[..cut]);
        for bit in 0..8 {
            let mut flipped = bytes.clone();
            flipped[cut] ^= 1 << bit;
            refused(&flipped);
        }
    }
    refused(&vec![1; MAX_BYTES + 1]);
}

fn refused(bytes: &[u8]) {
    let error = decode(bytes).unwrap_err();
    assert!(matches!(error, Error::ShareCode { .. }), "{error:?}");
}

fn sealed(mut body: Vec<u8>) -> Vec<u8> {
    body.extend(crc32fast::hash(&body).to_le_bytes());
    body
}

#[test]
fn newer_ones_say_so() {
    assert!(decode(&sealed(vec![9, 1, 2])).unwrap_err().to_string().contains("newer"));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: RngSeed::Fixed(6), failure_persistence: None, ..ProptestConfig::default() })]

    /// With the checksum set right, so that what is inside is really read.
    #[test]
    fn forged_ones_are_survived(at in any::<prop::sample::Index>(), byte in any::<u8>(), cut in any::<bool>(), noise in prop::collection::vec(any::<u8>(), 0..300)) {
        let bytes = encode(&run(12, 6));
        let mut body = bytes[..bytes.len() - 4].to_vec();
        let at = 1 + at.index(body.len() - 1);
        body[at] = byte;
        if cut {
            body.truncate(at + 1);
        }
        for body in [body, [vec![1], noise].concat()] {
            for (_, wire) in decode(&sealed(body)).unwrap_or_default() {
                prop_assert!(wire.control_points().iter().flatten().all(|c| c.is_finite()));
            }
        }
    }
}
