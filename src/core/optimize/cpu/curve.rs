//! What is about the curve and does not look at views: its weighted losses and their gradients.

use super::super::engine::{FindNeighbours, Step};
use crate::objective::{
    Neighbours, clearance_and_gradient, elastic_and_gradient, length_and_gradient, surface_and_gradient,
};
use crate::wire::{Jerk, LinearMap, Nodes, Stroke};

/// The part of a scene that is about the curve, with its buffers.
pub(super) struct Curve {
    pub sampling: LinearMap<f32>,
    pub strokes: Vec<Stroke>,
    pub jerk: Jerk<f32>,
    pub planes: Vec<[f32; 4]>,
    pub strand: Option<Strand>,
    /// Gradient of length and surface to the samples.
    pub d_samples: Vec<[f32; 4]>,
}

/// Losses of the curve.
#[derive(Default)]
pub(super) struct Losses {
    pub jerk: f32,
    pub length: f32,
    pub surface: f32,
    /// Bending, tightness, evenness, clearance.
    pub strand: [f32; 4],
}

impl Curve {
    /// All but the sums that come after those of the views.
    pub fn look(&mut self, points: &[[f32; 4]], samples: &[[f32; 4]], step: &Step) -> Losses {
        let mut losses = Losses::default();
        if step.length > 0.0 || step.surface > 0.0 {
            self.d_samples.clear();
            self.d_samples.resize(samples.len(), [0.0; 4]);
            if step.length > 0.0 {
                losses.length = length_and_gradient(samples, &self.strokes, step.length, &mut self.d_samples);
            }
            losses.surface = surface_and_gradient(samples, &self.planes, step.surface, &mut self.d_samples);
        }
        if let Some(strand) = &mut self.strand {
            losses.strand = strand.look(points, step);
        }
        losses
    }

    /// Adds the gradients of what was looked at last, always in the same order.
    pub fn add_to(&self, points: &[[f32; 4]], step: &Step, losses: &mut Losses, d_points: &mut [[f32; 4]]) {
        if step.length > 0.0 || step.surface > 0.0 {
            self.sampling.apply_transpose(&self.d_samples, d_points);
        }
        losses.jerk = self.jerk.energy_and_gradient(points, step.jerk_position, step.jerk_width, d_points);
        if let Some(strand) = &self.strand {
            strand.add_to(step, d_points);
        }
    }
}

/// The wire as a thing that bends and takes room, with its buffers.
pub(super) struct Strand {
    nodes: Nodes<f32>,
    pub neighbours: Neighbours,
    /// Finds those to come, while others are still at their views.
    pub find: Option<FindNeighbours>,
    /// Place, first and second derivative at the nodes, and the gradients to them.
    values: [Vec<[f32; 4]>; 3],
    d_values: [Vec<[f32; 4]>; 3],
}

impl Strand {
    pub fn new(nodes: Nodes<f32>, neighbours: Neighbours) -> Strand {
        let neighbours = if neighbours.starts.is_empty() { Neighbours::none(nodes.len()) } else { neighbours };
        let zeros = || vec![[0.0; 4]; nodes.len()];
        Strand { values: [0; 3].map(|_| zeros()), d_values: [0; 3].map(|_| zeros()), nodes, neighbours, find: None }
    }

    /// Bending, tightness, evenness, clearance.
    fn look(&mut self, points: &[[f32; 4]], step: &Step) -> [f32; 4] {
        if !step.is_of_strand() {
            return [0.0; 4];
        }
        let Strand { nodes, neighbours, find, values, d_values } = self;
        if let Some(find) = find.take() {
            *neighbours = find();
        }
        let maps = [&nodes.place, &nodes.first, &nodes.second];
        maps.iter().zip(&mut *values).for_each(|(map, values)| map.apply(points, values));
        d_values.iter_mut().for_each(|d| d.fill([0.0; 4]));
        let [place, first, second] = &*values;
        let [d_place, d_first, d_second] = &mut *d_values;
        let [bending, tightness, evenness] = match step.elastic.is_on() {
            true => elastic_and_gradient(nodes, [place, first, second], &step.elastic, d_place, d_first, d_second),
            false => [0.0; 3],
        };
        let clearance = match step.clearance.weight > 0.0 {
            true => clearance_and_gradient(place, &nodes.steps, neighbours, &step.clearance, d_place),
            false => 0.0,
        };
        [bending, tightness, evenness, clearance]
    }

    /// Adds the gradient of what was looked at last.
    fn add_to(&self, step: &Step, d_points: &mut [[f32; 4]]) {
        if step.is_of_strand() {
            let maps = [&self.nodes.place, &self.nodes.first, &self.nodes.second];
            maps.iter().zip(&self.d_values).for_each(|(map, d)| map.apply_transpose(d, d_points));
        }
    }
}
