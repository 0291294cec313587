//! The other way to cover a mesh: places a little apart, and a short tour through those of each part. Less calm than
//! stripes, but it asks nothing of the mesh.

use super::refined::RefinedMesh;
use super::relax::{Sample, samples};
use super::stitch::resampled;
use super::strand::{Grid, Node, SAME_SIDE, Strand};
use crate::rng::Rng;
use crate::start::tour::short_tour;
use glam::DVec3;

/// Places to choose from for every square spacing.
const SAMPLES_A_SQUARE: f64 = 24.0;
/// How far apart chosen places are, in spacings: n places on an area A have a tour about 0.75 √(n A) long (Beardwood,
/// Halton and Hammersley 1959, with what 2-opt leaves), and chosen this far apart they are 0.7 A / r².
const APART: f64 = 0.63;
/// How far places are lifted off the surface for the tour, in spacings: the two sides of a thin wall are three apart.
const LIFT: f64 = 1.5;
/// Fewer places make no loop.
const FEWEST: usize = 4;

/// A closed tour on each part that is large enough for one.
pub fn tours(surface: &RefinedMesh, spacing: f64, seed: u64) -> Vec<Strand> {
    let mut of_parts = vec![Vec::new(); surface.parts];
    for sample in spread(&mut samples(surface, spacing, SAMPLES_A_SQUARE), APART * spacing, seed) {
        of_parts[surface.part(sample.triangle) as usize].push(sample);
    }
    let tours = of_parts.iter().filter(|samples| samples.len() >= FEWEST).map(|samples| {
        let lifted = |sample: &Sample| (sample.point + LIFT * spacing * sample.normal).to_array();
        let order = short_tour(&samples.iter().map(lifted).collect::<Vec<_>>(), true);
        let node = |&index: &u32| {
            let Sample { point, normal, triangle } = samples[index as usize];
            Node { point, normal, triangle }
        };
        resampled(surface, &order.iter().map(node).collect::<Vec<_>>(), spacing)
    });
    tours.collect()
}

/// Of `samples`, in random order, those that are `apart` from all taken before on the same side of the surface.
fn spread(samples: &mut [Sample], apart: f64, seed: u64) -> Vec<Sample> {
    let mut rng = Rng::new(seed, 0x646f_7473);
    for k in (1..samples.len()).rev() {
        samples.swap(k, (rng.unit() * (k + 1) as f64) as usize);
    }
    let grid = Grid::new(samples.iter().map(|sample| sample.point), apart);
    let mut taken = vec![false; samples.len()];
    for k in 0..samples.len() {
        let Sample { point, normal, .. } = samples[k];
        let same_side = |other: DVec3| normal.dot(other) > SAME_SIDE;
        let crowded = grid.nearest(point, apart, |i| taken[i as usize] && same_side(samples[i as usize].normal));
        taken[k] = crowded.is_none();
    }
    samples.iter().zip(&taken).filter(|&(_, &taken)| taken).map(|(sample, _)| *sample).collect()
}
