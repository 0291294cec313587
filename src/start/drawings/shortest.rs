//! Cheapest paths through the voxels from many sources at once, with a bucket queue (Denardo & Fox 1979): buckets no
//! wider than the cheapest step make every entry of the lowest bucket final, so no heap is needed.

/// No parent: a source, or a voxel not reached.
pub const NO_PARENT: u32 = u32::MAX;

/// Working memory and result of one search; reused from search to search, so that a search costs what it reaches.
#[derive(Debug)]
pub struct Shortest {
    /// The voxel before this one on that path, or [`NO_PARENT`]; only where reached.
    pub parent: Vec<u32>,
    /// Reached voxels, each after its parent.
    pub order: Vec<u32>,
    buckets: Vec<Vec<u32>>,
    settled: Vec<bool>,
    /// What a step looks at, side by side.
    cells: Vec<Cell>,
    priced: Vec<u32>,
    per_cost: f32,
    /// The bucket to be settled next, counted from the first, and entries that wait in all of them.
    turn: usize,
    waiting: usize,
}

/// A voxel in a search.
#[derive(Debug, Clone, Copy)]
struct Cell {
    /// Cost of the cheapest path from a source; infinite where not reached.
    distance: f32,
    /// Price of a step on the voxel; NaN where not asked for yet.
    price: f32,
}

const UNTOUCHED: Cell = Cell { distance: f32::INFINITY, price: f32::NAN };

impl Shortest {
    /// For grids of `voxels` voxels.
    pub fn new(voxels: usize) -> Shortest {
        Shortest {
            parent: vec![NO_PARENT; voxels],
            order: Vec::new(),
            buckets: Vec::new(),
            settled: vec![false; voxels],
            cells: vec![UNTOUCHED; voxels],
            priced: Vec::new(),
            per_cost: 1.0,
            turn: 0,
            waiting: 0,
        }
    }

    /// Searches from `sources` up to distance `limit`. A step costs its length times the mean price of its two voxels;
    /// `price_of` is infinite where nothing may go (at least in the grid's outer layer) and else within `prices`, the
    /// least of which is above 0.
    pub fn search(
        &mut self,
        neighbours: &[(isize, f32)],
        price_of: impl Fn(usize) -> f32,
        prices: [f32; 2],
        sources: &[u32],
        limit: f32,
    ) {
        self.search_until(neighbours, price_of, prices, sources, limit, |_| false);
    }

    /// [`Shortest::search`] that ends with the first voxel of which `enough` says so: it is told each voxel whose
    /// cheapest path is known, nearly in the order of their distances.
    pub fn search_until(
        &mut self,
        neighbours: &[(isize, f32)],
        price_of: impl Fn(usize) -> f32,
        prices: [f32; 2],
        sources: &[u32],
        limit: f32,
        enough: impl FnMut(u32) -> bool,
    ) {
        self.begin(neighbours, &price_of, prices, sources);
        self.advance(neighbours, price_of, [limit; 2], enough);
    }

    /// Begins a search that [`Shortest::extend`] takes as far as it is wanted.
    pub fn begin(
        &mut self,
        neighbours: &[(isize, f32)],
        price_of: impl Fn(usize) -> f32,
        prices: [f32; 2],
        sources: &[u32],
    ) {
        for &voxel in &self.priced {
            let v = voxel as usize;
            (self.cells[v], self.settled[v]) = (UNTOUCHED, false);
        }
        self.priced.clear();
        self.order.clear();
        self.buckets.iter_mut().for_each(Vec::clear);
        let longest = neighbours.iter().map(|n| n.1).fold(1.0, f32::max);
        // One bucket more than the longest step spans, and one for rounding: the ring never overtakes itself. A power of two,
        // since a division at each entry would be felt.
        let ring = ((prices[1] * longest / prices[0]) as usize + 3).next_power_of_two();
        self.buckets.resize(ring.max(self.buckets.len()), Vec::new());
        self.per_cost = 1.0 / prices[0];
        for &source in sources {
            let s = source as usize;
            if self.cells[s].price.is_nan() {
                self.cells[s] = Cell { distance: 0.0, price: price_of(s) };
                self.priced.push(source);
                self.parent[s] = NO_PARENT;
                self.buckets[0].push(source);
            }
        }
        self.waiting = self.buckets[0].len();
        self.turn = 0;
    }

    /// Goes on to all within `limit`, and some a little beyond it: in the same order, and by the same ways, as if it had gone
    /// that far at once.
    pub fn extend(&mut self, neighbours: &[(isize, f32)], price_of: impl Fn(usize) -> f32, limit: f32) {
        self.advance(neighbours, price_of, [limit, f32::INFINITY], |_| false);
    }

    /// Settles the buckets up to a distance, and leaves out of them what is beyond another. Never inlined: it runs long, and
    /// an engine that compiles functions better only from call to call has to meet it anew.
    #[inline(never)]
    fn advance(
        &mut self,
        neighbours: &[(isize, f32)],
        price_of: impl Fn(usize) -> f32,
        [limit, beyond]: [f32; 2],
        mut enough: impl FnMut(u32) -> bool,
    ) {
        let in_ring = self.buckets.len() - 1;
        let (last, per_cost) = (self.bucket(limit), self.per_cost);
        while self.waiting > 0 && self.turn <= last {
            let slot = self.turn & in_ring;
            while let Some(voxel) = self.buckets[slot].pop() {
                self.waiting -= 1;
                let v = voxel as usize;
                if self.settled[v] {
                    continue;
                }
                self.settled[v] = true;
                self.order.push(voxel);
                if enough(voxel) {
                    return;
                }
                let (here, half_price) = (self.cells[v].distance, 0.5 * self.cells[v].price);
                for &(offset, length) in neighbours {
                    let w = v.wrapping_add_signed(offset);
                    let cell = &mut self.cells[w];
                    if cell.price.is_nan() {
                        cell.price = price_of(w);
                        self.priced.push(w as u32);
                    }
                    // Settled voxels are nearer.
                    let there = here + length * (half_price + 0.5 * cell.price);
                    if there < cell.distance && there <= beyond {
                        cell.distance = there;
                        self.parent[w] = voxel;
                        self.buckets[(there * per_cost) as usize & in_ring].push(w as u32);
                        self.waiting += 1;
                    }
                }
            }
            self.turn += 1;
        }
    }

    /// The reached voxels whose cheapest path costs at most `limit`, each after its parent.
    pub fn within(&self, limit: f32) -> impl Iterator<Item = u32> {
        let last = self.bucket(limit);
        let near = self.order.iter().copied().take_while(move |&voxel| self.bucket(self.distance(voxel)) <= last);
        near.filter(move |&voxel| self.distance(voxel) <= limit)
    }

    /// Which one in a row without end.
    fn bucket(&self, distance: f32) -> usize {
        (distance * self.per_cost) as usize
    }

    /// Cost of the cheapest path from a source to `voxel`; infinite where not reached.
    pub fn distance(&self, voxel: u32) -> f32 {
        self.cells[voxel as usize].distance
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

    const LEAST: f32 = 0.03;
    const SIDE: usize = 14;

    /// A cube of prices with a border that nothing crosses, steps to neighbours, and two sources.
    fn cube() -> (Vec<f32>, Vec<(isize, f32)>, [u32; 2]) {
        let n = SIDE;
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
        (cost, neighbours, [(5 * n * n + 5 * n + 5) as u32, (8 * n * n + 9 * n + 3) as u32])
    }

    #[test]
    fn distances_satisfy_bellman() {
        let (cost, neighbours, sources) = cube();
        let mut shortest = Shortest::new(cost.len());
        for limit in [4.0, f32::MAX] {
            shortest.search(&neighbours, |v| cost[v], [LEAST, 6.0], &sources, limit);
            for v in (0..cost.len()).filter(|&v| cost[v].is_finite() && !sources.contains(&(v as u32))) {
                let best = neighbours
                    .iter()
                    .map(|&(o, l)| {
                        let w = v.wrapping_add_signed(o);
                        shortest.distance(w as u32) + l * 0.5 * (cost[v] + cost[w])
                    })
                    .filter(|d| d.is_finite())
                    .fold(f32::INFINITY, f32::min);
                let found = shortest.distance(v as u32);
                assert!(
                    (best - found).abs() < 1e-4 || (found.is_infinite() && best > limit * 0.999),
                    "{v}: {found} against {best}"
                );
            }
            let reached = (0..cost.len() as u32).filter(|&v| shortest.distance(v).is_finite()).count();
            assert_eq!(reached, shortest.order.len());
        }
    }

    #[test]
    fn a_search_that_is_extended_finds_what_one_at_once_does() {
        let (cost, neighbours, sources) = cube();
        let found = |shortest: &Shortest, limit| -> Vec<(u32, u32, f32)> {
            shortest.within(limit).map(|v| (v, shortest.parent[v as usize], shortest.distance(v))).collect()
        };
        let (mut extended, mut fresh) = (Shortest::new(cost.len()), Shortest::new(cost.len()));
        extended.begin(&neighbours, |v| cost[v], [LEAST, 6.0], &sources);
        for limit in [6.0, 6.01, 9.0, 20.0] {
            extended.extend(&neighbours, |v| cost[v], limit);
            fresh.search(&neighbours, |v| cost[v], [LEAST, 6.0], &sources, limit);
            assert_eq!(found(&extended, limit), found(&fresh, f32::MAX));
            assert!(fresh.order.len() > 20);
        }
        fresh.search(&neighbours, |v| cost[v], [LEAST, 6.0], &sources, 8.0);
        assert_eq!(found(&extended, 8.0), found(&fresh, f32::MAX), "less than what was searched");
    }
}
