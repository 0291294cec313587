//! The least cut between object and ground on a grid of pixels, each joined to its eight neighbours.
//!
//! Augmenting paths from two search trees that are kept between paths (Boykov and Kolmogorov 2004). Between two cuts only
//! the terminals may change; what flows through the grid stays and is built on (Kohli and Torr 2007).

use std::collections::VecDeque;

/// What a pixel's way to a terminal begins with, besides the numbers of directions.
const TERMINAL: u8 = 8;
const ORPHAN: u8 = 9;
const FREE: u8 = 10;

/// A grid with capacities. Sums of capacities at a pixel must stay within an `i32`.
pub struct GridFlow {
    width: usize,
    /// Columns with one pixel of border on either side.
    stride: usize,
    /// From one pixel to the next, by direction; the opposite direction differs in the lowest bit.
    steps: [isize; 8],
    /// What a pixel can still send to each neighbour.
    residual: Vec<[i32; 8]>,
    /// What a pixel still gets from the source, or (below 0) can still send to the sink.
    excess: Vec<i32>,
    /// The terminals' difference as it was set.
    wanted: Vec<i32>,
    in_sink: Vec<bool>,
    parent: Vec<u8>,
    /// When a pixel's distance to its terminal was last known, and that distance in steps.
    stamp: Vec<u32>,
    distance: Vec<u32>,
    active: VecDeque<u32>,
    is_active: Vec<bool>,
    orphans: VecDeque<u32>,
    time: u32,
}

/// Columns and rows to the neighbour in each direction.
pub const NEIGHBOURS: [[isize; 2]; 8] = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [-1, -1], [-1, 1], [1, -1]];

impl GridFlow {
    /// Without any capacity.
    pub fn new(width: usize, height: usize) -> GridFlow {
        let stride = width + 2;
        let count = stride * (height + 2);
        GridFlow {
            width,
            stride,
            steps: NEIGHBOURS.map(|[x, y]| x + y * stride as isize),
            residual: vec![[0; 8]; count],
            excess: vec![0; count],
            wanted: vec![0; count],
            in_sink: vec![false; count],
            parent: vec![FREE; count],
            stamp: vec![0; count],
            distance: vec![0; count],
            active: VecDeque::new(),
            is_active: vec![false; count],
            orphans: VecDeque::new(),
            time: 0,
        }
    }

    fn place(&self, pixel: usize) -> usize {
        (pixel / self.width + 1) * self.stride + pixel % self.width + 1
    }

    fn step(&self, at: usize, direction: usize) -> usize {
        at.wrapping_add_signed(self.steps[direction])
    }

    /// What it costs to part `pixel` from its neighbour in `direction` ([`NEIGHBOURS`]), whichever side either falls on.
    /// To be set before the first cut; the neighbour must be within the grid.
    pub fn set_between(&mut self, pixel: usize, direction: usize, cost: i32) {
        let at = self.place(pixel);
        let next = self.step(at, direction);
        self.residual[at][direction] = cost;
        self.residual[next][direction ^ 1] = cost;
    }

    /// How much more it costs that `pixel` is ground than that it is object; below 0 for less.
    pub fn set_terminal(&mut self, pixel: usize, cost: i32) {
        let at = self.place(pixel);
        self.excess[at] += cost - self.wanted[at];
        self.wanted[at] = cost;
    }

    /// Whether `pixel` fell to the object: it can be reached from the source, or at least not from the sink if it costs
    /// nothing either way.
    pub fn is_object(&self, pixel: usize) -> bool {
        let at = self.place(pixel);
        self.parent[at] != FREE && !self.in_sink[at]
    }

    /// Finds the least cut for the terminals as they are.
    pub fn cut(&mut self) {
        self.begin();
        let mut current = None;
        loop {
            let at = match current.take().filter(|&at: &usize| self.parent[at] != FREE) {
                Some(at) => at,
                None => match self.next_active() {
                    Some(at) => at,
                    None => break,
                },
            };
            self.time += 1;
            if let Some((source_side, direction)) = self.grow(at) {
                self.is_active[at] = true;
                current = Some(at);
                self.augment(source_side, direction);
                while let Some(orphan) = self.orphans.pop_front() {
                    self.adopt(orphan as usize);
                }
                self.is_active[at] = false;
            }
        }
    }

    fn begin(&mut self) {
        self.active.clear();
        self.orphans.clear();
        self.time = 0;
        self.stamp.fill(0);
        for at in 0..self.excess.len() {
            let has_terminal = self.excess[at] != 0;
            self.parent[at] = if has_terminal { TERMINAL } else { FREE };
            self.in_sink[at] = self.excess[at] < 0;
            self.distance[at] = 1;
            self.is_active[at] = has_terminal;
            if has_terminal {
                self.active.push_back(at as u32);
            }
        }
    }

    fn activate(&mut self, at: usize) {
        if !std::mem::replace(&mut self.is_active[at], true) {
            self.active.push_back(at as u32);
        }
    }

    fn next_active(&mut self) -> Option<usize> {
        while let Some(at) = self.active.pop_front() {
            let at = at as usize;
            self.is_active[at] = false;
            if self.parent[at] != FREE {
                return Some(at);
            }
        }
        None
    }

    /// What can still flow between `at` and its neighbour, away from the source or towards the sink.
    fn open(&self, at: usize, next: usize, direction: usize, in_sink: bool) -> i32 {
        if in_sink { self.residual[next][direction ^ 1] } else { self.residual[at][direction] }
    }

    /// Grows a tree from `at`; the link between both trees, from the source's side, if it meets the other one.
    fn grow(&mut self, at: usize) -> Option<(usize, usize)> {
        let in_sink = self.in_sink[at];
        for direction in 0..8 {
            let next = self.step(at, direction);
            if self.open(at, next, direction, in_sink) <= 0 {
                continue;
            }
            if self.parent[next] == FREE {
                self.in_sink[next] = in_sink;
                self.parent[next] = (direction ^ 1) as u8;
                self.stamp[next] = self.stamp[at];
                self.distance[next] = self.distance[at] + 1;
                self.activate(next);
            } else if self.in_sink[next] != in_sink {
                return Some(if in_sink { (next, direction ^ 1) } else { (at, direction) });
            } else if self.stamp[next] <= self.stamp[at] && self.distance[next] > self.distance[at] {
                // A shorter way to the terminal.
                self.parent[next] = (direction ^ 1) as u8;
                self.stamp[next] = self.stamp[at];
                self.distance[next] = self.distance[at] + 1;
            }
        }
        None
    }

    /// Sends as much as goes along the path through a link between both trees.
    fn augment(&mut self, source_side: usize, direction: usize) {
        let sink_side = self.step(source_side, direction);
        let mut most = self.residual[source_side][direction];
        for (end, in_sink) in [(source_side, false), (sink_side, true)] {
            let mut at = end;
            while self.parent[at] != TERMINAL {
                let up = self.parent[at] as usize;
                let parent = self.step(at, up);
                most = most.min(if in_sink { self.residual[at][up] } else { self.residual[parent][up ^ 1] });
                at = parent;
            }
            most = most.min(self.excess[at].abs());
        }
        self.residual[source_side][direction] -= most;
        self.residual[sink_side][direction ^ 1] += most;
        for (end, in_sink) in [(source_side, false), (sink_side, true)] {
            let mut at = end;
            while self.parent[at] != TERMINAL {
                let up = self.parent[at] as usize;
                let parent = self.step(at, up);
                let (from, to, way) = if in_sink { (at, parent, up) } else { (parent, at, up ^ 1) };
                self.residual[from][way] -= most;
                self.residual[to][way ^ 1] += most;
                if self.residual[from][way] == 0 {
                    self.orphan(at, true);
                }
                at = parent;
            }
            self.excess[at] += if in_sink { most } else { -most };
            if self.excess[at] == 0 {
                self.orphan(at, true);
            }
        }
    }

    fn orphan(&mut self, at: usize, first: bool) {
        self.parent[at] = ORPHAN;
        if first { self.orphans.push_front(at as u32) } else { self.orphans.push_back(at as u32) }
    }

    /// Finds an orphan another way to its terminal, the shortest, or sets it and what hangs from it free.
    fn adopt(&mut self, at: usize) {
        let in_sink = self.in_sink[at];
        let mut best = (u32::MAX, FREE);
        for direction in 0..8 {
            let next = self.step(at, direction);
            // Towards the source, away from the sink: the reverse of growing.
            let open = if in_sink { self.residual[at][direction] } else { self.residual[next][direction ^ 1] };
            if open <= 0 || self.in_sink[next] != in_sink || self.parent[next] == FREE {
                continue;
            }
            if let Some(distance) = self.distance_to_terminal(next) {
                if distance < best.0 {
                    best = (distance, direction as u8);
                }
                self.mark(next, distance);
            }
        }
        self.parent[at] = best.1;
        if best.1 != FREE {
            self.stamp[at] = self.time;
            self.distance[at] = best.0 + 1;
            return;
        }
        for direction in 0..8 {
            let next = self.step(at, direction);
            if self.in_sink[next] != in_sink || self.parent[next] == FREE {
                continue;
            }
            let open = if in_sink { self.residual[at][direction] } else { self.residual[next][direction ^ 1] };
            if open > 0 {
                self.activate(next);
            }
            if self.parent[next] < TERMINAL && self.parent[next] as usize == direction ^ 1 {
                self.orphan(next, false);
            }
        }
    }

    /// Steps to the terminal, if the way there is whole.
    fn distance_to_terminal(&self, from: usize) -> Option<u32> {
        let (mut at, mut steps) = (from, 0);
        loop {
            if self.stamp[at] == self.time {
                return Some(steps + self.distance[at]);
            }
            match self.parent[at] {
                TERMINAL => return Some(steps + 1),
                ORPHAN | FREE => return None,
                up => at = self.step(at, up as usize),
            }
            steps += 1;
        }
    }

    /// Notes along the way how far each pixel is, so that nobody asks again.
    fn mark(&mut self, from: usize, mut distance: u32) {
        let mut at = from;
        while self.stamp[at] != self.time {
            self.stamp[at] = self.time;
            self.distance[at] = distance;
            match self.parent[at] {
                up if up < TERMINAL => at = self.step(at, up as usize),
                _ => break,
            }
            distance -= 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    /// A grid's costs as plain lists: (pixel, direction, cost) and terminals.
    struct Costs {
        width: usize,
        height: usize,
        between: Vec<(usize, usize, i32)>,
        terminals: Vec<i32>,
    }

    impl Costs {
        fn random(width: usize, height: usize, rng: &mut Rng) -> Costs {
            let mut between = Vec::new();
            for pixel in 0..width * height {
                for direction in [0, 2, 4, 6] {
                    if neighbour(width, height, pixel, direction).is_some() && rng.unit() < 0.9 {
                        between.push((pixel, direction, rng.below(20) as i32));
                    }
                }
            }
            let mut costs = Costs { width, height, between, terminals: vec![0; width * height] };
            costs.draw_terminals(rng);
            costs
        }

        fn draw_terminals(&mut self, rng: &mut Rng) {
            let draw = |rng: &mut Rng| if rng.unit() < 0.5 { rng.below(81) as i32 - 40 } else { 0 };
            self.terminals.iter_mut().for_each(|terminal| *terminal = draw(rng));
        }

        fn flow(&self) -> GridFlow {
            let mut flow = GridFlow::new(self.width, self.height);
            self.between.iter().for_each(|&(pixel, direction, cost)| flow.set_between(pixel, direction, cost));
            self.give_terminals(&mut flow);
            flow
        }

        fn give_terminals(&self, flow: &mut GridFlow) {
            self.terminals.iter().enumerate().for_each(|(pixel, &cost)| flow.set_terminal(pixel, cost));
        }

        /// What a labelling costs.
        fn of(&self, is_object: impl Fn(usize) -> bool) -> i64 {
            let parted = |&&(pixel, direction, _): &&(usize, usize, i32)| {
                is_object(pixel) != is_object(neighbour(self.width, self.height, pixel, direction).unwrap())
            };
            let apart: i64 = self.between.iter().filter(parted).map(|&(.., cost)| i64::from(cost)).sum();
            let terminal =
                |(pixel, &cost): (usize, &i32)| i64::from(if is_object(pixel) { -cost } else { cost }.max(0));
            apart + self.terminals.iter().enumerate().map(terminal).sum::<i64>()
        }

        /// The greatest flow by shortest paths (Edmonds and Karp 1972), slow and simple.
        fn greatest_flow(&self) -> i64 {
            let count = self.width * self.height;
            let (source, sink) = (count, count + 1);
            let mut capacity = vec![vec![0i64; count + 2]; count + 2];
            for &(pixel, direction, cost) in &self.between {
                let next = neighbour(self.width, self.height, pixel, direction).unwrap();
                capacity[pixel][next] += i64::from(cost);
                capacity[next][pixel] += i64::from(cost);
            }
            for (pixel, &cost) in self.terminals.iter().enumerate() {
                capacity[source][pixel] = i64::from(cost.max(0));
                capacity[pixel][sink] = i64::from((-cost).max(0));
            }
            let mut total = 0;
            loop {
                let mut from = vec![usize::MAX; count + 2];
                from[source] = source;
                let mut queue = VecDeque::from([source]);
                while let Some(at) = queue.pop_front() {
                    for next in 0..count + 2 {
                        if capacity[at][next] > 0 && from[next] == usize::MAX {
                            from[next] = at;
                            queue.push_back(next);
                        }
                    }
                }
                if from[sink] == usize::MAX {
                    return total;
                }
                let mut path = vec![sink];
                while path[path.len() - 1] != source {
                    path.push(from[path[path.len() - 1]]);
                }
                let most = path.windows(2).map(|w| capacity[w[1]][w[0]]).min().unwrap();
                for w in path.windows(2) {
                    capacity[w[1]][w[0]] -= most;
                    capacity[w[0]][w[1]] += most;
                }
                total += most;
            }
        }
    }

    fn neighbour(width: usize, height: usize, pixel: usize, direction: usize) -> Option<usize> {
        let [dx, dy] = NEIGHBOURS[direction];
        let x = (pixel % width).checked_add_signed(dx).filter(|&x| x < width)?;
        let y = (pixel / width).checked_add_signed(dy).filter(|&y| y < height)?;
        Some(y * width + x)
    }

    #[test]
    fn cuts_cost_what_the_greatest_flow_is_also_after_terminals_changed() {
        let mut rng = Rng::new(4, 0);
        for round in 0..60 {
            let (width, height) = (1 + rng.below(7), 1 + rng.below(7));
            let mut costs = Costs::random(width, height, &mut rng);
            let mut flow = costs.flow();
            for again in 0..3 {
                flow.cut();
                let cut = costs.of(|pixel| flow.is_object(pixel));
                assert_eq!(cut, costs.greatest_flow(), "round {round}, cut {again}, {width} x {height}");
                costs.draw_terminals(&mut rng);
                costs.give_terminals(&mut flow);
            }
        }
    }

    #[test]
    fn no_labelling_of_a_small_grid_costs_less() {
        let mut rng = Rng::new(8, 0);
        for _ in 0..20 {
            let costs = Costs::random(4, 3, &mut rng);
            let mut flow = costs.flow();
            flow.cut();
            let least = (0..1u32 << 12).map(|labels| costs.of(|pixel| labels >> pixel & 1 == 1)).min().unwrap();
            assert_eq!(costs.of(|pixel| flow.is_object(pixel)), least);
        }
    }

    #[test]
    fn a_wide_grid_is_cut_along_its_weakest_ring() {
        let side = 60;
        let mut flow = GridFlow::new(side, side);
        let radius = |pixel: usize| ((pixel % side) as f64 - 29.5).hypot((pixel / side) as f64 - 29.5);
        for pixel in 0..side * side {
            for direction in [0, 2, 4, 6] {
                if let Some(next) = neighbour(side, side, pixel, direction) {
                    let edge = (radius(pixel) < 20.0) != (radius(next) < 20.0);
                    flow.set_between(pixel, direction, if edge { 1 } else { 50 });
                }
            }
            flow.set_terminal(
                pixel,
                if radius(pixel) < 2.0 {
                    5000
                } else if radius(pixel) > 28.0 {
                    -5000
                } else {
                    0
                },
            );
        }
        flow.cut();
        assert!((0..side * side).all(|pixel| flow.is_object(pixel) == (radius(pixel) < 20.0)));
    }
}
