//! Cheapest paths through the voxels from many sources at once, with a bucket queue (Denardo & Fox 1979): buckets no
//! wider than the cheapest step make every entry of the lowest bucket final, so no heap is needed.

/// No parent: a source, or a voxel not reached.
pub const NO_PARENT: u32 = u32::MAX;

/// Working memory and result of one search; reused from search to search.
#[derive(Debug, Default)]
pub struct Shortest {
    /// Cost of the cheapest path from a source; infinite where not reached.
    pub distance: Vec<f32>,
    /// The voxel before this one on that path, or [`NO_PARENT`].
    pub parent: Vec<u32>,
    /// Reached voxels, each after its parent.
    pub order: Vec<u32>,
    buckets: Vec<Vec<u32>>,
    settled: Vec<bool>,
}

impl Shortest {
    /// Searches from `sources` up to distance `limit`. A step costs its length times the mean cost of its two voxels;
    /// `cost` is infinite where nothing may go (at least in the grid's outer layer) and else at least `least_cost` > 0.
    pub fn search(&mut self, neighbours: &[(isize, f32)], cost: &[f32], least_cost: f32, sources: &[u32], limit: f32) {
        let count = cost.len();
        self.distance.clear();
        self.distance.resize(count, f32::INFINITY);
        self.parent.clear();
        self.parent.resize(count, NO_PARENT);
        self.settled.clear();
        self.settled.resize(count, false);
        self.order.clear();
        let dearest = cost.iter().copied().filter(|c| c.is_finite()).fold(least_cost, f32::max);
        let longest = neighbours.iter().map(|n| n.1).fold(1.0, f32::max);
        // One bucket more than the longest step spans, and one for rounding: the ring never overtakes itself.
        let ring = (dearest * longest / least_cost) as usize + 3;
        if self.buckets.len() < ring {
            self.buckets.resize(ring, Vec::new());
        }
        let ring = self.buckets.len();
        let per_cost = 1.0 / least_cost;
        for &source in sources {
            if cost[source as usize].is_finite() {
                self.distance[source as usize] = 0.0;
                self.buckets[0].push(source);
            }
        }
        let mut waiting = self.buckets[0].len();
        let mut turn = 0;
        while waiting > 0 {
            let slot = turn % ring;
            while let Some(voxel) = self.buckets[slot].pop() {
                waiting -= 1;
                let v = voxel as usize;
                if self.settled[v] {
                    continue;
                }
                self.settled[v] = true;
                self.order.push(voxel);
                let (here, half_cost) = (self.distance[v], 0.5 * cost[v]);
                for &(offset, length) in neighbours {
                    let w = v.wrapping_add_signed(offset);
                    let there = here + length * (half_cost + 0.5 * cost[w]);
                    if there < self.distance[w] && there <= limit {
                        self.distance[w] = there;
                        self.parent[w] = voxel;
                        self.buckets[(there * per_cost) as usize % ring].push(w as u32);
                        waiting += 1;
                    }
                }
            }
            turn += 1;
        }
    }

    /// The cheapest path that ends in `voxel`, from there back to its source.
    pub fn path_back(&self, voxel: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(voxel), |&v| Some(self.parent[v as usize]).filter(|&p| p != NO_PARENT))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn distances_satisfy_bellman() {
        let (n, least) = (14usize, 0.03f32);
        let mut rng = Rng::new(5, 0);
        let mut cost: Vec<f32> = (0..n * n * n).map(|_| rng.range(0.03, 6.0) as f32).collect();
        let border = |i: usize| i == 0 || i == n - 1;
        for v in 0..cost.len() {
            if border(v % n) || border(v / n % n) || border(v / (n * n)) {
                cost[v] = f32::INFINITY;
            }
        }
        let mut neighbours = Vec::new();
        for d in 0..27isize {
            let (x, y, z) = (d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1);
            if d != 13 {
                neighbours.push(((z * n as isize + y) * n as isize + x, ((x * x + y * y + z * z) as f32).sqrt()));
            }
        }
        let sources = [(5 * n * n + 5 * n + 5) as u32, (8 * n * n + 9 * n + 3) as u32];
        let mut shortest = Shortest::default();
        for limit in [4.0, f32::MAX] {
            shortest.search(&neighbours, &cost, least, &sources, limit);
            for v in (0..cost.len()).filter(|&v| cost[v].is_finite() && !sources.contains(&(v as u32))) {
                let best = neighbours
                    .iter()
                    .map(|&(o, l)| {
                        let w = v.wrapping_add_signed(o);
                        shortest.distance[w] + l * 0.5 * (cost[v] + cost[w])
                    })
                    .filter(|d| d.is_finite())
                    .fold(f32::INFINITY, f32::min);
                let found = shortest.distance[v];
                assert!(
                    (best - found).abs() < 1e-4 || (found.is_infinite() && best > limit * 0.999),
                    "{v}: {found} against {best}"
                );
            }
            let reached = shortest.distance.iter().filter(|d| d.is_finite()).count();
            assert_eq!(reached, shortest.order.len());
        }
    }
}
