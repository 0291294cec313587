//! The cheapest way to pair up an even number of things: Edmonds' blossom algorithm (1965) with dual prices, in O(n³)
//! as Gabow (1974) and Lawler (1976) arrange it.

/// No node.
const NONE: usize = usize::MAX;

/// Pairs up `count` things (an even number) so that the sum of `cost` over the pairs is least: each one's mate. Costs are
/// symmetric; their size is at most 2^60 / `count`.
pub fn cheapest_pairs(count: usize, cost: impl Fn(usize, usize) -> i64) -> Vec<usize> {
    debug_assert!(count.is_multiple_of(2));
    let mut blossoms = Blossoms::new(count, cost);
    // Each phase mates two more.
    while blossoms.augmented() {}
    blossoms.mate.truncate(count);
    blossoms.mate
}

/// How an alternating tree reaches a node.
#[derive(Clone, Copy, PartialEq)]
enum Label {
    Free,
    /// After an even number of steps from an unmated root: it may be mated anew.
    Outer,
    /// After an odd number.
    Inner,
}

/// Vertices 0..count and, above, blossoms: odd rings of nodes that act as one.
struct Blossoms {
    count: usize,
    /// Room for nodes.
    room: usize,
    /// Twice the cost, so that half a slack is whole.
    cost: Vec<i64>,
    /// Prices: a pair of vertices costs no less than the mean of both; blossoms' are what they add for pairs across.
    dual: Vec<i64>,
    /// The vertex a node is mated to.
    mate: Vec<usize>,
    /// Between two nodes the pair of vertices with the least slack, one in each.
    link: Vec<[u32; 2]>,
    /// The outermost blossom that holds a node; `NONE` for blossoms not in use.
    top: Vec<usize>,
    /// For an inner node the outer vertex that reached it.
    reached_from: Vec<usize>,
    label: Vec<Label>,
    /// The outer vertex with the least slack to a node.
    nearest: Vec<usize>,
    /// A blossom's nodes round the ring, its base first.
    petals: Vec<Vec<usize>>,
    /// Which petal of a blossom holds a vertex.
    petal_of: Vec<usize>,
    /// When a node was met on the way to a root.
    met: Vec<usize>,
    turn: usize,
    /// Outer vertices to look from.
    queue: std::collections::VecDeque<usize>,
}

impl Blossoms {
    fn new(count: usize, cost: impl Fn(usize, usize) -> i64) -> Blossoms {
        let room = count + count / 2;
        let mut doubled = vec![0; count * count];
        let mut link = vec![[0, 0]; room * room];
        let mut dual = vec![0; room];
        for a in 0..count {
            for b in 0..count {
                doubled[a * count + b] = 2 * cost(a, b);
                link[a * room + b] = [a as u32, b as u32];
            }
            dual[a] = (0..count).filter(|&b| b != a).map(|b| doubled[a * count + b]).min().unwrap_or(0);
        }
        let mut top: Vec<usize> = (0..room).collect();
        top[count..].fill(NONE);
        let mut petal_of = vec![NONE; room * count];
        (0..count).for_each(|v| petal_of[v * count + v] = v);
        Blossoms {
            count,
            room,
            cost: doubled,
            dual,
            mate: vec![NONE; room],
            link,
            top,
            reached_from: vec![NONE; room],
            label: vec![Label::Free; room],
            nearest: vec![NONE; room],
            petals: vec![Vec::new(); room],
            petal_of,
            met: vec![0; room],
            turn: 0,
            queue: std::collections::VecDeque::new(),
        }
    }

    fn link(&self, a: usize, b: usize) -> [usize; 2] {
        self.link[a * self.room + b].map(|vertex| vertex as usize)
    }

    fn slack(&self, [a, b]: [usize; 2]) -> i64 {
        2 * self.cost[a * self.count + b] - self.dual[a] - self.dual[b]
    }

    /// Nodes that no blossom holds.
    fn tops(&self) -> impl Iterator<Item = usize> {
        (0..self.room).filter(|&x| self.top[x] == x)
    }

    fn is_blossom(&self, x: usize) -> bool {
        x >= self.count
    }

    /// Mates two more vertices; false if all are.
    fn augmented(&mut self) -> bool {
        self.label.fill(Label::Free);
        self.nearest.fill(NONE);
        self.queue.clear();
        for x in 0..self.room {
            if self.top[x] == x && self.mate[x] == NONE {
                self.reached_from[x] = NONE;
                self.label[x] = Label::Outer;
                self.enqueue(x);
            }
        }
        if self.queue.is_empty() {
            return false;
        }
        loop {
            while let Some(u) = self.queue.pop_front() {
                if self.label[self.top[u]] == Label::Inner {
                    continue;
                }
                for v in 0..self.count {
                    if self.top[u] == self.top[v] {
                        continue;
                    }
                    if self.slack([u, v]) == 0 {
                        if self.grow([u, v]) {
                            return true;
                        }
                    } else {
                        self.offer(u, self.top[v]);
                    }
                }
            }
            self.change_prices();
            for x in 0..self.room {
                let near = self.nearest[x];
                if self.top[x] == x && near != NONE && self.top[near] != x {
                    let link = self.link(near, x);
                    if self.slack(link) == 0 && self.grow(link) {
                        return true;
                    }
                }
            }
            for b in self.count..self.room {
                if self.top[b] == b && self.label[b] == Label::Inner && self.dual[b] == 0 {
                    self.expand(b);
                }
            }
        }
    }

    /// Raises the prices of outer nodes and lowers those of inner ones until another pair costs just its prices.
    fn change_prices(&mut self) {
        let mut change = i64::MAX;
        for x in self.tops() {
            if self.is_blossom(x) && self.label[x] == Label::Inner {
                change = change.min(self.dual[x] / 2);
            }
            if self.nearest[x] != NONE {
                let slack = self.slack(self.link(self.nearest[x], x));
                match self.label[x] {
                    Label::Free => change = change.min(slack),
                    Label::Outer => change = change.min(slack / 2),
                    Label::Inner => {}
                }
            }
        }
        for u in 0..self.count {
            match self.label[self.top[u]] {
                Label::Outer => self.dual[u] += change,
                Label::Inner => self.dual[u] -= change,
                Label::Free => {}
            }
        }
        for b in self.count..self.room {
            if self.top[b] == b {
                match self.label[b] {
                    Label::Outer => self.dual[b] += 2 * change,
                    Label::Inner => self.dual[b] -= 2 * change,
                    Label::Free => {}
                }
            }
        }
    }

    /// Takes a pair without slack into the trees, its first vertex outer; true if that mated two more.
    fn grow(&mut self, [u, v]: [usize; 2]) -> bool {
        let (a, b) = (self.top[u], self.top[v]);
        match self.label[b] {
            Label::Free => {
                self.reached_from[b] = u;
                self.label[b] = Label::Inner;
                let next = self.top[self.mate[b]];
                (self.nearest[b], self.nearest[next]) = (NONE, NONE);
                self.label[next] = Label::Outer;
                self.enqueue(next);
                false
            }
            Label::Outer => match self.common(a, b) {
                Some(base) => {
                    self.shrink(a, base, b);
                    false
                }
                None => {
                    self.flip(a, b);
                    self.flip(b, a);
                    true
                }
            },
            Label::Inner => false,
        }
    }

    fn enqueue(&mut self, x: usize) {
        if self.is_blossom(x) {
            for i in 0..self.petals[x].len() {
                self.enqueue(self.petals[x][i]);
            }
        } else {
            self.queue.push_back(x);
        }
    }

    fn offer(&mut self, u: usize, x: usize) {
        let near = self.nearest[x];
        if near == NONE || self.slack(self.link(u, x)) < self.slack(self.link(near, x)) {
            self.nearest[x] = u;
        }
    }

    fn find_nearest(&mut self, x: usize) {
        self.nearest[x] = NONE;
        for u in 0..self.count {
            if self.top[u] != x && self.label[self.top[u]] == Label::Outer {
                self.offer(u, x);
            }
        }
    }

    fn set_top(&mut self, x: usize, top: usize) {
        self.top[x] = top;
        if self.is_blossom(x) {
            for i in 0..self.petals[x].len() {
                self.set_top(self.petals[x][i], top);
            }
        }
    }

    /// The outer node one step further up the tree: over the mate to the node that reached it.
    fn above(&self, x: usize) -> Option<usize> {
        let mate = self.mate[x];
        (mate != NONE).then(|| self.top[self.reached_from[self.top[mate]]])
    }

    /// The first outer node on the ways of both to their roots.
    fn common(&mut self, a: usize, b: usize) -> Option<usize> {
        self.turn += 1;
        let mut ways = [Some(a), Some(b)];
        while ways != [None, None] {
            if let Some(x) = ways[0] {
                if self.met[x] == self.turn {
                    return Some(x);
                }
                self.met[x] = self.turn;
                ways[0] = self.above(x);
            }
            ways.swap(0, 1);
        }
        None
    }

    /// Makes the ring from `base` over `a` and `b` one node.
    fn shrink(&mut self, a: usize, base: usize, b: usize) {
        let new = (self.count..self.room).find(|&x| self.top[x] == NONE).unwrap_or(self.room - 1);
        let mut ring = vec![base];
        let side = |from: usize| {
            let mut nodes = Vec::new();
            let mut x = from;
            while x != base {
                let inner = self.top[self.mate[x]];
                nodes.extend([x, inner]);
                x = self.top[self.reached_from[inner]];
            }
            nodes
        };
        ring.extend(side(a).into_iter().rev());
        let back = side(b);
        for x in ring[1..].iter().chain(&back).copied().collect::<Vec<_>>() {
            if self.label[x] == Label::Inner {
                self.enqueue(x);
            }
        }
        ring.extend(back);
        self.dual[new] = 0;
        self.label[new] = Label::Outer;
        self.mate[new] = self.mate[base];
        self.petal_of[new * self.count..][..self.count].fill(NONE);
        for (i, &petal) in ring.iter().enumerate() {
            for x in 0..self.room {
                if self.top[x] == NONE {
                    continue;
                }
                let link = self.link(petal, x);
                if i == 0 || self.slack(link) < self.slack(self.link(new, x)) {
                    self.link[new * self.room + x] = link.map(|vertex| vertex as u32);
                    self.link[x * self.room + new] = [link[1] as u32, link[0] as u32];
                }
            }
            for v in 0..self.count {
                if self.petal_of[petal * self.count + v] != NONE {
                    self.petal_of[new * self.count + v] = petal;
                }
            }
        }
        self.petals[new] = ring;
        self.set_top(new, new);
        self.find_nearest(new);
    }

    /// Where `petal` lies in the ring of `b`, an even number of steps from its base: the ring is turned round if need be.
    fn even_place(&mut self, b: usize, petal: usize) -> usize {
        let ring = &mut self.petals[b];
        let place = ring.iter().position(|&x| x == petal).unwrap_or(0);
        if place % 2 == 1 {
            ring[1..].reverse();
            ring.len() - place
        } else {
            place
        }
    }

    /// Mates node `a` to node `b`.
    fn pair(&mut self, a: usize, b: usize) {
        let [u, v] = self.link(a, b);
        self.mate[a] = v;
        if self.is_blossom(a) {
            let petal = self.petal_of[a * self.count + u];
            let place = self.even_place(a, petal);
            for i in 0..place {
                self.pair(self.petals[a][i], self.petals[a][i ^ 1]);
            }
            self.pair(petal, b);
            self.petals[a].rotate_left(place);
        }
    }

    /// Mates outer node `a` to `b` and every other pair on its way to the root anew.
    fn flip(&mut self, mut a: usize, mut b: usize) {
        loop {
            let mate = self.mate[a];
            self.pair(a, b);
            if mate == NONE {
                return;
            }
            let inner = self.top[mate];
            let above = self.top[self.reached_from[inner]];
            self.pair(inner, above);
            (a, b) = (above, inner);
        }
    }

    /// Takes an inner blossom apart whose price has come down to 0.
    fn expand(&mut self, b: usize) {
        for i in 0..self.petals[b].len() {
            self.set_top(self.petals[b][i], self.petals[b][i]);
        }
        let from = self.reached_from[b];
        let [_, entered] = self.link(from, b);
        let entry = self.petal_of[b * self.count + entered];
        let place = self.even_place(b, entry);
        let ring = std::mem::take(&mut self.petals[b]);
        self.top[b] = NONE;
        // The way through the ring that stays in the tree: from where it was entered to its base, in an even number of steps.
        for i in (0..place).step_by(2) {
            let (inner, outer) = (ring[i], ring[i + 1]);
            self.reached_from[inner] = self.link(outer, inner)[0];
            self.label[inner] = Label::Inner;
            self.label[outer] = Label::Outer;
            self.nearest[inner] = NONE;
            self.find_nearest(outer);
            self.enqueue(outer);
        }
        self.label[entry] = Label::Inner;
        self.reached_from[entry] = from;
        self.nearest[entry] = NONE;
        for &x in &ring[place + 1..] {
            self.label[x] = Label::Free;
            self.find_nearest(x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    fn least(left: &[usize], cost: &dyn Fn(usize, usize) -> i64) -> i64 {
        let Some((&first, rest)) = left.split_first() else { return 0 };
        (0..rest.len())
            .map(|k| {
                let others: Vec<usize> = rest.iter().copied().filter(|&x| x != rest[k]).collect();
                cost(first, rest[k]) + least(&others, cost)
            })
            .min()
            .unwrap_or(0)
    }

    fn total(mate: &[usize], cost: &dyn Fn(usize, usize) -> i64) -> i64 {
        mate.iter().enumerate().filter(|(a, b)| a < *b).map(|(a, &b)| cost(a, b)).sum()
    }

    #[test]
    fn pairs_are_the_cheapest() {
        let mut rng = Rng::new(3, 0);
        let mut blossoms = 0;
        for round in 0..3000 {
            let count = 2 * (1 + rng.below(5));
            // Few different costs make ties and rings, places in the plane make clusters.
            let most = [3, 10, 1000][round % 3];
            let places: Vec<[f64; 2]> = (0..count).map(|_| [rng.range(0.0, 50.0), rng.range(0.0, 50.0)]).collect();
            let table: Vec<i64> = (0..count * count).map(|_| rng.below(most) as i64).collect();
            let cost = |a: usize, b: usize| {
                if round % 2 == 0 {
                    table[a.min(b) * count + a.max(b)]
                } else {
                    ((places[a][0] - places[b][0]).hypot(places[a][1] - places[b][1]) * 8.0) as i64
                }
            };
            let mate = cheapest_pairs(count, cost);
            assert!((0..count).all(|a| mate[a] != a && mate[mate[a]] == a), "{mate:?}");
            let all: Vec<usize> = (0..count).collect();
            assert_eq!(total(&mate, &cost), least(&all, &cost), "round {round}: {mate:?}");
            let greedy: Vec<usize> = (0..count).map(|a| a ^ 1).collect();
            blossoms += usize::from(total(&greedy, &cost) > total(&mate, &cost));
        }
        assert!(blossoms > 1000, "any pairing would have passed");
        assert!(cheapest_pairs(0, |_, _| 0).is_empty());
    }

    #[test]
    fn no_exchange_improves_many_pairs() {
        let mut rng = Rng::new(8, 0);
        let places: Vec<[f64; 3]> = (0..200).map(|_| rng.in_ball(1000.0)).collect();
        let cost =
            |a: usize, b: usize| (0..3).map(|c| (places[a][c] - places[b][c]).powi(2)).sum::<f64>().sqrt() as i64;
        let mate = cheapest_pairs(200, cost);
        for a in 0..200 {
            for b in 0..200 {
                let (c, d) = (mate[a], mate[b]);
                assert!(a == b || b == c || cost(a, c) + cost(b, d) <= cost(a, b) + cost(c, d));
            }
        }
    }
}
