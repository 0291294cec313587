//! The wire as a thing that bends and takes room on a device: its nodes, and who may come too near whom.

use super::banded::Map;
use super::layout::Node;
use crate::objective::{MOST_NEIGHBOURS, Neighbours};
use crate::optimize::Scene;

/// What shaders know of a scene's nodes; empty without any.
#[derive(Debug, Default)]
pub(super) struct StrandUpload {
    pub nodes: Vec<Node>,
    /// Which nodes each control point has a part in, as [`lists`].
    pub point_nodes: Vec<u32>,
    /// Which nodes may come too near each node, likewise.
    pub neighbours: Vec<u32>,
}

impl StrandUpload {
    pub fn new(scene: &Scene) -> StrandUpload {
        let Some(nodes) = &scene.nodes else { return StrandUpload::default() };
        let [place, first, second] = [&nodes.place, &nodes.first, &nodes.second].map(|map| map.rows());
        let node = |i: usize| Node {
            place: place[i].weights,
            first_derivative: first[i].weights,
            second_derivative: second[i].weights,
            // All three are of one span, hence of the same control points.
            first: place[i].first,
            step: nodes.steps[i],
            ..Node::default()
        };
        let Map { starts, terms, .. } = Map::new(&nodes.place);
        let mut strand = StrandUpload {
            nodes: (0..nodes.len()).map(node).collect(),
            point_nodes: lists(&starts, terms.iter().map(|term| term.row)),
            neighbours: Vec::new(),
        };
        strand.set_neighbours(&scene.neighbours);
        strand
    }

    /// Takes over who may come too near whom; nobody where `neighbours` is not about as many nodes. What lists have in all
    /// beyond [`MOST_NEIGHBOURS`] a node is left out.
    pub fn set_neighbours(&mut self, neighbours: &Neighbours) {
        let count = self.nodes.len();
        let Neighbours { starts, others } = neighbours;
        let most = others.len().min(MOST_NEIGHBOURS * count);
        self.neighbours = if starts.len() == count + 1 {
            let starts: Vec<u32> = starts.iter().map(|&start| start.min(most as u32)).collect();
            lists(&starts, others[..most].iter().copied())
        } else {
            lists(&vec![0; count + 1], std::iter::empty())
        };
    }

    /// Entries that neighbours may take.
    pub fn room(&self) -> usize {
        (1 + MOST_NEIGHBOURS) * self.nodes.len() + 1
    }
}

/// Lists in one buffer: where each begins and the last one ends, then what is in them.
fn lists(starts: &[u32], items: impl Iterator<Item = u32>) -> Vec<u32> {
    let head = starts.len() as u32;
    starts.iter().map(|start| head + start).chain(items).collect()
}
