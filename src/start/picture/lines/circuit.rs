//! The shortest closed walk over all edges of a graph, nearly (the Chinese postman's problem): edges are walked twice only
//! between places where an odd number of them meet.

use crate::geometry::DisjointSets;
use crate::sorting::sort_by;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Steps back over which a walk's direction is taken.
const DIRECTION_STEPS: usize = 6;

/// A closed walk over all `edges` of a connected graph, each at least once and at most twice, as straight on as possible:
/// the nodes it meets, the first again at the end. `places` are the nodes' places; an edge is as long as its ends are
/// apart. Nodes that node 0's part of the graph does not hold are left out.
pub fn circuit(places: &[[f64; 2]], edges: &[[usize; 2]]) -> Vec<usize> {
    let Some(first) = edges.first() else { return places.first().map_or(Vec::new(), |_| vec![0]) };
    let graph = Graph::new(places, edges);
    let again = graph.walked_twice().into_iter().enumerate().filter(|(_, twice)| *twice).map(|(k, _)| edges[k]);
    let steps: Vec<[usize; 2]> = edges.iter().copied().chain(again).collect();
    euler(places, &steps, first[0])
}

struct Graph<'a> {
    edges: &'a [[usize; 2]],
    lengths: Vec<f64>,
    /// For each node its edges.
    at: Vec<Vec<usize>>,
}

impl<'a> Graph<'a> {
    fn new(places: &[[f64; 2]], edges: &'a [[usize; 2]]) -> Graph<'a> {
        let mut at = vec![Vec::new(); places.len()];
        for (k, edge) in edges.iter().enumerate() {
            edge.iter().for_each(|&node| at[node].push(k));
        }
        let lengths = edges.iter().map(|&[a, b]| apart(places[a], places[b])).collect();
        Graph { edges, lengths, at }
    }

    fn across(&self, edge: usize, node: usize) -> usize {
        let [a, b] = self.edges[edge];
        if a == node { b } else { a }
    }

    /// Edges to walk twice so that an even number of steps meets everywhere: along a shortest tree through all nodes where
    /// an odd number of edges meets, those with an odd number of such nodes beyond them.
    fn walked_twice(&self) -> Vec<bool> {
        let odd: Vec<usize> = (0..self.at.len()).filter(|&node| self.at[node].len() % 2 == 1).collect();
        // The nearest odd node of each node, and the edge towards it (Dijkstra 1959).
        let mut price = vec![f64::INFINITY; self.at.len()];
        let mut owner = vec![usize::MAX; self.at.len()];
        let mut towards = vec![usize::MAX; self.at.len()];
        let mut queue = BinaryHeap::new();
        for (k, &node) in odd.iter().enumerate() {
            (price[node], owner[node]) = (0.0, k);
            queue.push(Reverse((0u64, node)));
        }
        while let Some(Reverse((bits, node))) = queue.pop() {
            if f64::from_bits(bits) > price[node] {
                continue;
            }
            for &edge in &self.at[node] {
                let (next, to) = (self.across(edge, node), price[node] + self.lengths[edge]);
                if to < price[next] {
                    (price[next], owner[next], towards[next]) = (to, owner[node], edge);
                    // Positive floats order as their bits do.
                    queue.push(Reverse((to.to_bits(), next)));
                }
            }
        }
        // The shortest tree over the odd nodes (Kruskal 1956) from edges between the regions of two of them (Mehlhorn 1988).
        let mut bridges: Vec<usize> = (0..self.edges.len())
            .filter(|&k| {
                let [a, b] = self.edges[k].map(|node| owner[node]);
                a != b && a != usize::MAX && b != usize::MAX
            })
            .collect();
        let through = |k: usize| self.edges[k].iter().map(|&node| price[node]).sum::<f64>() + self.lengths[k];
        sort_by(&mut bridges, |&a, &b| through(a).total_cmp(&through(b)).then(a.cmp(&b)));
        let mut regions = DisjointSets::new(odd.len());
        let mut tree: Vec<Vec<(usize, usize)>> = vec![Vec::new(); odd.len()];
        for k in bridges {
            let [a, b] = self.edges[k].map(|node| owner[node]);
            if regions.join(a, b) {
                tree[a].push((b, k));
                tree[b].push((a, k));
            }
        }
        let mut twice = vec![false; self.edges.len()];
        let mut met = vec![false; odd.len()];
        for start in 0..odd.len() {
            if std::mem::replace(&mut met[start], true) {
                continue;
            }
            let mut order = vec![(start, usize::MAX, usize::MAX)];
            let mut next = 0;
            while let Some(&(k, _, _)) = order.get(next) {
                next += 1;
                for &(other, bridge) in &tree[k] {
                    if !std::mem::replace(&mut met[other], true) {
                        order.push((other, k, bridge));
                    }
                }
            }
            let mut beyond = vec![true; odd.len()];
            for &(k, parent, bridge) in order.iter().skip(1).rev() {
                if !beyond[k] {
                    continue;
                }
                beyond[parent] = !beyond[parent];
                twice[bridge] = !twice[bridge];
                for mut node in self.edges[bridge] {
                    while towards[node] != usize::MAX {
                        twice[towards[node]] = !twice[towards[node]];
                        node = self.across(towards[node], node);
                    }
                }
            }
        }
        twice
    }
}

/// A closed walk over all steps, each once; an even number of them meets at every node (Hierholzer 1873).
fn euler(places: &[[f64; 2]], steps: &[[usize; 2]], start: usize) -> Vec<usize> {
    let mut at = vec![Vec::new(); places.len()];
    for (k, step) in steps.iter().enumerate() {
        step.iter().for_each(|&node| at[node].push(k));
    }
    let mut used = vec![false; steps.len()];
    let mut trail = vec![start];
    let mut walk = Vec::with_capacity(steps.len() + 1);
    while let Some(&node) = trail.last() {
        let from = places[trail[trail.len().saturating_sub(DIRECTION_STEPS)]];
        let across = |step: usize| if steps[step][0] == node { steps[step][1] } else { steps[step][0] };
        let straight = |step: usize| {
            let (here, to) = (places[node], places[across(step)]);
            let [[ax, ay], [bx, by]] = [[here[0] - from[0], here[1] - from[1]], [to[0] - here[0], to[1] - here[1]]];
            (ax * bx + ay * by) / bx.hypot(by).max(1e-9)
        };
        at[node].retain(|&step| !used[step]);
        match at[node].iter().copied().max_by(|&a, &b| straight(a).total_cmp(&straight(b)).then(b.cmp(&a))) {
            Some(step) => {
                used[step] = true;
                trail.push(across(step));
            }
            None => {
                walk.push(node);
                trail.pop();
            }
        }
    }
    walk
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use std::collections::HashMap;

    /// How often each edge is walked; fails if a step is no edge.
    fn walked(walk: &[usize], edges: &[[usize; 2]]) -> Vec<usize> {
        let index: HashMap<[usize; 2], usize> =
            edges.iter().enumerate().flat_map(|(k, &[a, b])| [([a, b], k), ([b, a], k)]).collect();
        let mut times = vec![0; edges.len()];
        walk.windows(2).for_each(|pair| times[index[&[pair[0], pair[1]]]] += 1);
        times
    }

    #[test]
    fn rings_are_walked_once_and_links_twice() {
        // Two rings of 40 nodes with a link of 3 edges between them.
        let ring = |k: usize, r: f64| {
            let angle = k as f64 / 40.0 * std::f64::consts::TAU;
            [r * angle.cos(), r * angle.sin()]
        };
        let mut places: Vec<_> = (0..40).map(|k| ring(k, 20.0)).chain((0..40).map(|k| ring(k, 10.0))).collect();
        places.extend([[17.0, 0.0], [13.0, 0.0]]);
        let mut edges: Vec<_> = (0..80).map(|k| [k, if k % 40 == 39 { k - 39 } else { k + 1 }]).collect();
        edges.extend([[0, 80], [80, 81], [81, 40]]);
        let times = walked(&circuit(&places, &edges), &edges);
        assert!(times[..80].iter().all(|&n| n == 1) && times[80..].iter().all(|&n| n == 2), "{times:?}");
    }

    #[test]
    fn every_edge_of_a_random_graph_is_walked_once_or_twice_and_the_walk_closes() {
        let mut rng = Rng::new(5, 0);
        for _ in 0..30 {
            let count = 2 + rng.below(40);
            let places: Vec<_> = (0..count).map(|_| [rng.range(0.0, 9.0), rng.range(0.0, 9.0)]).collect();
            let mut edges: Vec<_> = (1..count).map(|k| [rng.below(k), k]).collect();
            for _ in 0..rng.below(30) {
                let (a, b) = (rng.below(count), rng.below(count));
                if a != b && !edges.contains(&[a, b]) && !edges.contains(&[b, a]) {
                    edges.push([a, b]);
                }
            }
            let walk = circuit(&places, &edges);
            assert_eq!(walk.first(), walk.last());
            assert!(walked(&walk, &edges).iter().all(|n| (1..=2).contains(n)));
        }
        assert_eq!(circuit(&[[0.0; 2]], &[]), [0]);
        assert!(circuit(&[], &[]).is_empty());
    }
}
