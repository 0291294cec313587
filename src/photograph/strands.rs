//! The wire as what rays meet: a row of cones, in a bounding-volume hierarchy.

use crate::cone::{Cone, Entry};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::cwbvh::{CwBvh, bvh2_to_cwbvh::bvh2_to_cwbvh};
use obvhs::ploc::PlocBuilder;
use obvhs::ray::{Ray, RayHit};
use wire4d_core::wire::Wire;

/// Every cone of a wire.
pub struct Strands {
    cones: Vec<Cone>,
    tree: CwBvh,
}

impl Strands {
    /// `samples_per_span` cones a span of the wire.
    pub fn new(wire: &Wire, samples_per_span: usize) -> Strands {
        let (map, strokes) = wire.sampling_map::<f64>(samples_per_span, false);
        let mut samples = Vec::new();
        map.apply(wire.control_points(), &mut samples);
        let place = |i: usize| Vec3A::from_array([0, 1, 2].map(|c| samples[i][c] as f32));
        let radius = |i: usize| (0.5 * samples[i][3]).max(0.0) as f32;
        let cone = |i: usize, j: usize| Cone { ends: [place(i), place(j)], radii: [radius(i), radius(j)] };
        let each = strokes.iter().flat_map(|stroke| {
            let last = stroke.start + stroke.count - 1;
            let closing = stroke.closed.then_some((last, stroke.start));
            (stroke.start..last).map(|i| (i, i + 1)).chain(closing)
        });
        Strands::of(
            each.map(|(i, j)| cone(i, j)).filter(|cone| cone.radii.iter().any(|&radius| radius > 0.0)).collect(),
        )
    }

    fn of(cones: Vec<Cone>) -> Strands {
        let boxes: Vec<Aabb> = cones.iter().map(Cone::bounds).map(|[low, high]| Aabb::new(low, high)).collect();
        let BvhBuildParams {
            ploc_search_distance,
            sort_precision,
            search_depth_threshold,
            reinsertion_batch_ratio,
            ..
        } = BvhBuildParams::medium_build();
        let order = (0..boxes.len() as u32).collect();
        let mut tree = PlocBuilder::with_capacity(boxes.len()).build(
            ploc_search_distance,
            &boxes,
            order,
            sort_precision,
            search_depth_threshold,
        );
        ReinsertionOptimizer::default().run(&mut tree, reinsertion_batch_ratio, None);
        Strands { cones, tree: bvh2_to_cwbvh(&tree, 3, true, false) }
    }

    /// The lowest and the highest corner of a box round all of it; the middle where there is nothing.
    pub fn bounds(&self) -> [Vec3A; 2] {
        let boxes = self.cones.iter().map(Cone::bounds);
        boxes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or([Vec3A::ZERO; 2])
    }

    /// Where a ray of direction `along` (length 1) first enters the wire, nearer than `most`.
    pub fn entry(&self, origin: Vec3A, along: Vec3A, most: f32) -> Option<Entry> {
        let mut first = None;
        let mut hit = RayHit::none();
        self.tree.ray_traverse(Ray::new(origin, along, 0.0, most), &mut hit, |ray, id| {
            match self.cone(id).entry(origin, along).filter(|entry| entry.distance < ray.tmax) {
                Some(entry) => {
                    first = Some(entry);
                    entry.distance
                }
                None => f32::INFINITY,
            }
        });
        first
    }

    /// Whether the wire lies across a ray before `most`.
    pub fn blocks(&self, origin: Vec3A, along: Vec3A, most: f32) -> bool {
        !self.tree.ray_traverse_miss(Ray::new(origin, along, 0.0, most), |_, id| {
            self.cone(id).entry(origin, along).map_or(f32::INFINITY, |entry| entry.distance)
        })
    }

    /// By its place in the tree.
    fn cone(&self, id: usize) -> &Cone {
        &self.cones[self.tree.primitive_indices[id] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wire4d_core::rng::Rng;

    #[test]
    fn the_tree_finds_what_looking_at_every_cone_finds() {
        let mut rng = Rng::new(11, 2);
        let mut place = |size: f64| Vec3A::from_array(rng.in_ball(size).map(|c| c as f32));
        let cones: Vec<Cone> = (0..300)
            .map(|i| {
                let at = place(1.0);
                Cone { ends: [at, at + place(0.1)], radii: [0.01 + 0.0001 * i as f32, 0.02] }
            })
            .collect();
        let strands = Strands::of(cones.clone());
        let mut hits = 0;
        for _ in 0..3000 {
            let origin = 3.0 * place(1.0).normalize();
            let along = (place(1.0) - origin).normalize();
            let each = cones.iter().filter_map(|cone| cone.entry(origin, along));
            let nearest = each.map(|entry| entry.distance).fold(f32::INFINITY, f32::min);
            let found = strands.entry(origin, along, f32::INFINITY);
            assert_eq!(found.map_or(f32::INFINITY, |entry| entry.distance), nearest);
            assert_eq!(strands.blocks(origin, along, f32::INFINITY), nearest.is_finite());
            assert!(!strands.blocks(origin, along, nearest) && strands.entry(origin, along, nearest).is_none());
            hits += usize::from(nearest.is_finite());
        }
        assert!(hits > 500, "{hits}");
    }
}
