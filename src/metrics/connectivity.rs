//! Which parts of a wire touch, and what it would take to join the rest.

use super::pieces::{Piece, PieceTree};
use crate::geometry::DisjointSets;
use crate::sorting::sort_by;

/// Number of components of `parts` (polylines of `[x, y, z, width]`) after joining those whose tubes touch, and the weight
/// of the minimum spanning tree that joins the components by the nearest points of their centre lines.
pub fn connectivity(parts: &[Vec<[f64; 4]>]) -> (usize, f64) {
    if parts.len() < 2 {
        return (parts.len(), 0.0);
    }
    let mut groups = DisjointSets::new(parts.len());
    let mut tree = PieceTree::new(pieces(parts));
    join_touching(&mut tree, &mut groups);
    let components = groups.count();
    (components, join_nearest(&mut tree, &mut groups, parts.len()))
}

fn pieces(parts: &[Vec<[f64; 4]>]) -> Vec<Piece> {
    let of_part = |(group, points): (usize, &Vec<[f64; 4]>)| {
        let last = points.len().saturating_sub(1);
        // A part of one point is a piece from it to itself.
        let ends = (0..last.max(1)).map(|i| (points[i], points[(i + 1).min(last)])).collect::<Vec<_>>();
        ends.into_iter().map(move |(start, end)| Piece::new(start, end, group))
    };
    parts.iter().enumerate().flat_map(of_part).collect()
}

fn join_touching(tree: &mut PieceTree, groups: &mut DisjointSets) {
    let mut relabel_at = groups.count() / 2;
    for i in 0..tree.pieces().len() {
        let piece = tree.pieces()[i];
        tree.for_each_touching(&piece, |other| {
            groups.join(piece.group, other);
        });
        if groups.count() == 1 {
            break;
        }
        if groups.count() <= relabel_at {
            tree.relabel(|group| groups.root(group));
            relabel_at = groups.count() / 2;
        }
    }
}

/// Borůvka's algorithm: every component finds its nearest neighbour, all those links are made, and so on.
fn join_nearest(tree: &mut PieceTree, groups: &mut DisjointSets, parts: usize) -> f64 {
    let mut cost = 0.0;
    while groups.count() > 1 {
        tree.relabel(|group| groups.root(group));
        let mut links: Vec<Option<Link>> = vec![None; parts];
        for i in 0..tree.pieces().len() {
            let piece = tree.pieces()[i];
            let limit = links[piece.group].map_or(f64::INFINITY, |link| link.distance);
            if let Some((distance, other)) = tree.nearest_of_another_group(&piece, limit) {
                links[piece.group] = Some(Link { distance, ends: (piece.group, other) });
            }
        }
        // By length, so that the tree does not depend on which component asked first; loops are refused.
        let mut links: Vec<Link> = links.into_iter().flatten().collect();
        sort_by(&mut links, |a, b| a.distance.total_cmp(&b.distance).then(a.ends.cmp(&b.ends)));
        let before = groups.count();
        for Link { distance, ends: (a, b) } in links {
            if groups.join(a, b) {
                cost += distance;
            }
        }
        if groups.count() == before {
            break;
        }
    }
    cost
}

#[derive(Clone, Copy)]
struct Link {
    distance: f64,
    ends: (usize, usize),
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn line(from: [f64; 3], to: [f64; 3], width: f64) -> Vec<[f64; 4]> {
        (0..5)
            .map(|i| {
                let s = i as f64 / 4.0;
                let at = |c: usize| from[c] + (to[c] - from[c]) * s;
                [at(0), at(1), at(2), width]
            })
            .collect()
    }

    #[test]
    fn touching_is_by_the_sum_of_radii() {
        let apart = |gap: f64| {
            connectivity(&[line([0.0; 3], [1.0, 0.0, 0.0], 0.1), line([0.3, gap, -1.0], [0.3, gap, 1.0], 0.2)])
        };
        assert_eq!(apart(0.1499), (1, 0.0));
        let (components, cost) = apart(0.1501);
        assert_eq!(components, 2);
        assert!((cost - 0.1501).abs() < 1e-12, "between centre lines");
        assert_eq!(connectivity(&[]), (0, 0.0));
        assert_eq!(connectivity(&[vec![[0.0; 4]]]), (1, 0.0));
    }

    #[test]
    fn the_tree_is_the_least() {
        // Four points on a line: the tree is the line, not a star.
        let dots: Vec<_> = [0.0, 1.0, 3.0, 3.5].iter().map(|&x| vec![[x, 0.0, 0.0, 0.0]]).collect();
        let (components, cost) = connectivity(&dots);
        assert_eq!(components, 4);
        assert!((cost - 3.5).abs() < 1e-12);
    }

    /// Against Prim's algorithm and all pairs.
    #[test]
    fn agrees_with_brute_force() {
        let mut rng = Rng::new(11, 3);
        for round in 0..20 {
            let parts: Vec<_> = (0..30)
                .map(|_| {
                    let mut end = rng.in_ball(0.2);
                    let start = rng.in_ball(1.0);
                    (0..3).for_each(|c| end[c] += start[c]);
                    line(start, end, rng.range(0.0, 0.3))
                })
                .collect();
            let pieces = pieces(&parts);
            let mut groups = DisjointSets::new(parts.len());
            let mut distances = vec![vec![f64::INFINITY; parts.len()]; parts.len()];
            for a in &pieces {
                for b in &pieces {
                    let near = a.nearest(b);
                    if near.distance <= near.radii {
                        groups.join(a.group, b.group);
                    }
                    let least = &mut distances[a.group][b.group];
                    *least = least.min(near.distance);
                }
            }
            let components = groups.count();
            let mut expected = 0.0;
            while groups.count() > 1 {
                let root = groups.root(0);
                let mut best = (f64::INFINITY, 0);
                for a in 0..parts.len() {
                    for b in 0..parts.len() {
                        if groups.root(a) == root && groups.root(b) != root && distances[a][b] < best.0 {
                            best = (distances[a][b], b);
                        }
                    }
                }
                expected += best.0;
                groups.join(0, best.1);
            }
            let (found, cost) = connectivity(&parts);
            assert_eq!(found, components, "round {round}");
            assert!((cost - expected).abs() < 1e-9, "round {round}: {cost} {expected}");
            assert!(components > 1 && components < 30, "the test has something to do");
        }
    }
}
