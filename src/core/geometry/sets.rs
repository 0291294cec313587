//! What hangs together.

/// Disjoint sets of the numbers below a count (union-find with halved paths, Tarjan & van Leeuwen 1984). Each is known by
/// its least number, so that results do not depend on the order of joining.
#[derive(Debug, Clone)]
pub struct DisjointSets {
    parents: Vec<u32>,
    sets: usize,
}

impl DisjointSets {
    /// Each of `count` numbers on its own.
    pub fn new(count: usize) -> DisjointSets {
        DisjointSets { parents: (0..count as u32).collect(), sets: count }
    }

    /// How many sets there are.
    pub fn count(&self) -> usize {
        self.sets
    }

    /// The least number of the set that `i` is in.
    pub fn root(&mut self, mut i: usize) -> usize {
        while self.parents[i] as usize != i {
            self.parents[i] = self.parents[self.parents[i] as usize];
            i = self.parents[i] as usize;
        }
        i
    }

    /// Makes one set of those that `a` and `b` are in; whether they were two.
    pub fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.parents[a.max(b)] = a.min(b) as u32;
        self.sets -= usize::from(a != b);
        a != b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn sets_are_those_of_a_flood_whatever_the_order() {
        let mut rng = Rng::new(3, 0);
        let mut one = |most: usize| (rng.unit() * most as f64) as usize;
        let pairs: Vec<[usize; 2]> = (0..40).map(|_| [one(60), one(60)]).collect();
        // Labels spread until nothing changes.
        let mut least: Vec<usize> = (0..60).collect();
        for _ in 0..60 {
            for &[a, b] in &pairs {
                let low = least[a].min(least[b]);
                (least[a], least[b]) = (low, low);
            }
        }
        for backwards in [false, true] {
            let mut sets = DisjointSets::new(60);
            let in_order: Vec<[usize; 2]> =
                if backwards { pairs.iter().rev().copied().collect() } else { pairs.clone() };
            let joined = in_order.iter().filter(|&&[a, b]| sets.join(a, b)).count();
            assert_eq!((0..60).map(|i| sets.root(i)).collect::<Vec<_>>(), least);
            assert_eq!(sets.count(), 60 - joined);
        }
        let roots = least.iter().enumerate().filter(|&(i, &low)| i == low).count();
        assert!((2..60).contains(&roots), "neither all apart nor all together: {roots}");
    }
}
