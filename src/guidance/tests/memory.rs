//! Running a network again and again takes no more memory: a program of its own, so that nothing else allocates beside it.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::Path;
use wire4d_core::objective::{Batch, Network};
use wire4d_core::work::wait;
use wire4d_guidance::OnnxNetwork;

/// Bytes that this program holds.
fn resident() -> i64 {
    let pages = fs::read_to_string("/proc/self/statm").unwrap();
    4096 * pages.split(' ').nth(1).unwrap().parse::<i64>().unwrap()
}

#[test]
fn memory_does_not_grow_from_run_to_run() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/guidance/vit-tiny.onnx");
    let mut network = OnnxNetwork::open(&file).unwrap();
    let mut unit = vec![0.0; network.embed()];
    unit[0] = 1.0;
    let images: Vec<f32> = (0..8 * 3 * 32 * 32).map(|i| (i % 97) as f32 / 97.0).collect();
    let (source, target) = (vec![0.0; 8 * unit.len()], unit.repeat(8));
    let batch = Batch { images: &images, source: &source, target: &target, weight: &[1.0; 8] };
    let mut run = |count| (0..count).for_each(|_| assert!(wait(network.run(batch).done()).is_ok()));
    run(16);
    let before = resident();
    run(256);
    // What a run answers alone is 100 kB.
    assert!(resident() - before < 8 << 20, "{} bytes more", resident() - before);
}
