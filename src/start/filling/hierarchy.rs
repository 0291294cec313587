//! A surface's vertices merged in pairs, again and again: what is smooth on a coarse level starts the finer one.

use super::refined::RefinedMesh;
use crate::sorting::sort_by;
use glam::DVec3;

/// Vertices whose normals are this far apart (cosine) are not merged.
const LEAST_AGREEMENT: f64 = 0.3;

/// Vertices and their neighbours.
#[derive(Debug, Clone, Default)]
pub struct Level {
    pub points: Vec<DVec3>,
    pub normals: Vec<DVec3>,
    /// How many vertices of the finest level each stands for.
    pub sizes: Vec<f64>,
    /// Neighbours of `v` and how strongly they are tied: `ties[starts[v]..starts[v + 1]]`.
    pub ties: Vec<(u32, f64)>,
    pub starts: Vec<u32>,
    /// The vertex of the next coarser level.
    pub parents: Vec<u32>,
}

impl Level {
    pub fn ties_of(&self, vertex: usize) -> &[(u32, f64)] {
        &self.ties[self.starts[vertex] as usize..self.starts[vertex + 1] as usize]
    }

    /// From ties in both directions.
    fn new(points: Vec<DVec3>, normals: Vec<DVec3>, sizes: Vec<f64>, mut pairs: Vec<(u32, u32, f64)>) -> Level {
        pairs.sort_unstable_by_key(|&(a, b, _)| (a, b));
        let mut ties: Vec<(u32, f64)> = Vec::with_capacity(pairs.len());
        let mut starts = vec![0; points.len() + 1];
        for group in pairs.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
            starts[group[0].0 as usize + 1] += 1;
            ties.push((group[0].1, group.iter().map(|tie| tie.2).sum()));
        }
        for v in 0..points.len() {
            starts[v + 1] += starts[v];
        }
        Level { points, normals, sizes, ties, starts, parents: Vec::new() }
    }

    /// Merges each vertex with the free neighbour that agrees most and is small; names the parents.
    fn coarsened(&mut self) -> Level {
        let count = self.points.len();
        let mut wishes: Vec<(f64, u32, u32)> = Vec::with_capacity(self.ties.len() / 2);
        for a in 0..count {
            for &(b, weight) in self.ties_of(a) {
                let agreement = self.normals[a].dot(self.normals[b as usize]);
                if (a as u32) < b && agreement > LEAST_AGREEMENT {
                    let (small, large) = (self.sizes[a], self.sizes[b as usize]);
                    wishes.push((agreement * weight / (small * large), a as u32, b));
                }
            }
        }
        sort_by(&mut wishes, |x, y| y.0.total_cmp(&x.0).then((x.1, x.2).cmp(&(y.1, y.2))));
        const FREE: u32 = u32::MAX;
        let mut parents = vec![FREE; count];
        let (mut points, mut normals, mut sizes) = (Vec::new(), Vec::new(), Vec::new());
        for &(_, a, b) in &wishes {
            let (i, j) = (a as usize, b as usize);
            if parents[i] == FREE && parents[j] == FREE {
                (parents[i], parents[j]) = (points.len() as u32, points.len() as u32);
                let (m, n) = (self.sizes[i], self.sizes[j]);
                // A point of the surface, not the mean: distances between means inside a curved part are too short.
                let stays = if n > m { j } else { i };
                points.push(self.points[stays]);
                normals.push(self.normals[stays]);
                sizes.push(m + n);
            }
        }
        for v in 0..count {
            if parents[v] == FREE {
                parents[v] = points.len() as u32;
                points.push(self.points[v]);
                normals.push(self.normals[v]);
                sizes.push(self.sizes[v]);
            }
        }
        let mut pairs = Vec::with_capacity(self.ties.len());
        for a in 0..count {
            for &(b, weight) in self.ties_of(a) {
                if parents[a] != parents[b as usize] {
                    pairs.push((parents[a], parents[b as usize], weight));
                }
            }
        }
        self.parents = parents;
        Level::new(points, normals, sizes, pairs)
    }
}

/// The levels, finest first. A level shrinks by a tenth at least.
pub fn levels(surface: &RefinedMesh) -> Vec<Level> {
    let mut pairs = Vec::with_capacity(2 * surface.edges.len());
    for edge in &surface.edges {
        let [a, b] = edge.ends;
        pairs.extend([(a, b, 1.0), (b, a, 1.0)]);
    }
    let sizes = vec![1.0; surface.points.len()];
    let mut levels = vec![Level::new(surface.points.clone(), surface.normals.clone(), sizes, pairs)];
    loop {
        let finest = levels.len() - 1;
        let coarser = levels[finest].coarsened();
        if 10 * coarser.points.len() > 9 * levels[finest].points.len() {
            levels[finest].parents = Vec::new();
            return levels;
        }
        levels.push(coarser);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Shape;

    #[test]
    fn levels_shrink_to_a_handful_and_stay_tied() {
        let surface = RefinedMesh::new(&Shape::Vase.mesh(), 0.06).unwrap();
        let levels = levels(&surface);
        assert!(levels.len() > 8 && levels[levels.len() - 1].points.len() < 200);
        for pair in levels.windows(2) {
            let (fine, coarse) = (&pair[0], &pair[1]);
            assert!(10 * coarse.points.len() <= 9 * fine.points.len());
            assert!(fine.parents.iter().all(|&p| (p as usize) < coarse.points.len()));
            assert_eq!(coarse.sizes.iter().sum::<f64>(), surface.points.len() as f64);
            for v in 0..coarse.points.len() {
                for &(other, weight) in coarse.ties_of(v) {
                    assert!(other as usize != v);
                    assert!(coarse.ties_of(other as usize).contains(&(v as u32, weight)), "ties go both ways");
                }
            }
        }
    }
}
