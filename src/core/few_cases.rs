//! How properties are tested in every crate.

/// Few cases from a fixed seed: quick, and the same on every machine.
pub fn few_cases() -> proptest::test_runner::Config {
    proptest::test_runner::Config {
        cases: 24,
        rng_seed: proptest::test_runner::RngSeed::Fixed(4),
        failure_persistence: None,
        ..Default::default()
    }
}
