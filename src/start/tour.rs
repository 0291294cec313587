//! A short tour through points: greedy nearest neighbour, then 2-opt and Or-opt over neighbour lists until neither
//! finds anything (Bentley 1992).

/// Points looked at round each point.
const NEIGHBOURS: usize = 10;
/// Longest segment that Or-opt moves.
const SEGMENT: usize = 3;
/// Gains smaller than this are rounding.
const LEAST_GAIN: f64 = 1e-12;

/// The order in which a short tour visits `points`; an open tour is the closed one without its longest step.
pub fn short_tour(points: &[[f64; 3]], closed: bool) -> Vec<u32> {
    let mut order = greedy_tour(points);
    if points.len() >= 5 {
        let near = nearest_lists(points);
        order = Tour::new(points, order).improved(&near);
    }
    if !closed && order.len() > 2 {
        let step = |i: usize| distance(points, order[i], order[(i + 1) % order.len()]);
        let longest = (0..order.len()).max_by(|&a, &b| step(a).total_cmp(&step(b))).unwrap_or(0);
        order.rotate_left((longest + 1) % points.len());
    }
    order
}

/// From point 0 always on to the nearest point not visited yet.
pub fn greedy_tour(points: &[[f64; 3]]) -> Vec<u32> {
    let mut left: Vec<u32> = (1..points.len() as u32).collect();
    let mut order: Vec<u32> = (0..points.len().min(1) as u32).collect();
    while let Some(&last) = order.last() {
        let nearest = (0..left.len())
            .min_by(|&a, &b| distance(points, last, left[a]).total_cmp(&distance(points, last, left[b])));
        match nearest {
            Some(i) => order.push(left.swap_remove(i)),
            None => break,
        }
    }
    order
}

/// Length of the closed tour.
pub fn tour_length(points: &[[f64; 3]], order: &[u32]) -> f64 {
    (0..order.len()).map(|i| distance(points, order[i], order[(i + 1) % order.len()])).sum()
}

fn distance(points: &[[f64; 3]], a: u32, b: u32) -> f64 {
    let (a, b) = (points[a as usize], points[b as usize]);
    (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt()
}

/// Each point's nearest points, nearest first.
fn nearest_lists(points: &[[f64; 3]]) -> Vec<Vec<u32>> {
    let count = NEIGHBOURS.min(points.len() - 1);
    let mut others: Vec<(f64, u32)> = Vec::with_capacity(points.len());
    (0..points.len() as u32)
        .map(|a| {
            others.clear();
            others.extend((0..points.len() as u32).filter(|&b| b != a).map(|b| (distance(points, a, b), b)));
            let order = |x: &(f64, u32), y: &(f64, u32)| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1));
            if count < others.len() {
                others.select_nth_unstable_by(count, order);
            }
            others.truncate(count);
            others.sort_unstable_by(order);
            others.iter().map(|other| other.1).collect()
        })
        .collect()
}

/// A closed tour as an array with the place of each point in it.
struct Tour<'a> {
    points: &'a [[f64; 3]],
    order: Vec<u32>,
    place: Vec<u32>,
}

impl<'a> Tour<'a> {
    fn new(points: &'a [[f64; 3]], order: Vec<u32>) -> Self {
        let mut place = vec![0; order.len()];
        for (i, &point) in order.iter().enumerate() {
            place[point as usize] = i as u32;
        }
        Tour { points, order, place }
    }

    fn improved(mut self, near: &[Vec<u32>]) -> Vec<u32> {
        // Points whose surroundings changed are looked at again.
        let mut queue: std::collections::VecDeque<u32> = self.order.iter().copied().collect();
        let mut queued = vec![true; self.order.len()];
        while let Some(point) = queue.pop_front() {
            queued[point as usize] = false;
            while let Some(touched) = self.improve_at(point, &near[point as usize]) {
                for other in touched {
                    if !queued[other as usize] {
                        queued[other as usize] = true;
                        queue.push_back(other);
                    }
                }
            }
        }
        self.order
    }

    /// Makes one move that shortens the tour at `a`; the points whose steps changed.
    fn improve_at(&mut self, a: u32, near: &[u32]) -> Option<[u32; 6]> {
        for forward in [true, false] {
            let b = self.after(a, forward);
            let old = self.distance(a, b);
            for &c in near {
                if self.distance(a, c) >= old {
                    break;
                }
                // 2-opt: steps a-b and c-d become a-c and b-d.
                let d = self.after(c, forward);
                let gain = old + self.distance(c, d) - self.distance(a, c) - self.distance(b, d);
                if c != b && d != a && gain > LEAST_GAIN {
                    self.exchange(a, b, c, d);
                    return Some([a, b, c, d, a, a]);
                }
            }
            if let Some(touched) = self.move_segment(a, forward, near) {
                return Some(touched);
            }
        }
        None
    }

    /// Or-opt: the segment of up to three points that begins with `first` goes next to one of its near points.
    fn move_segment(&mut self, first: u32, forward: bool, near: &[u32]) -> Option<[u32; 6]> {
        let before = self.after(first, !forward);
        let mut last = first;
        for length in 1..=SEGMENT.min(self.order.len() - 3) {
            if length > 1 {
                last = self.after(last, forward);
            }
            let behind = self.after(last, forward);
            let freed = self.distance(before, first) + self.distance(last, behind) - self.distance(before, behind);
            for &c in near {
                if self.distance(first, c) >= freed {
                    break;
                }
                let inside = self.steps(first, c, forward) < length;
                for towards in [true, false] {
                    // Between c and its next point on either side, `first` beside c.
                    let d = self.after(c, towards);
                    let inside = inside || self.steps(first, d, forward) < length;
                    let added = self.distance(c, first) + self.distance(last, d) - self.distance(c, d);
                    if inside || freed - added <= LEAST_GAIN {
                        continue;
                    }
                    // In the direction of travel the gap is p -> q, which lies behind the segment, for tours are round.
                    let (p, q) = if towards == forward { (c, d) } else { (d, c) };
                    if p != before {
                        self.exchange(before, first, p, q);
                    }
                    if p != last && behind != p {
                        self.exchange(before, p, behind, last);
                    } else if behind == p {
                        self.exchange(before, p, p, last);
                    }
                    if p == c {
                        // So far p is followed by `last`; turn the segment round.
                        self.exchange(p, last, first, q);
                    }
                    return Some([before, behind, first, last, c, d]);
                }
            }
        }
        None
    }

    fn distance(&self, a: u32, b: u32) -> f64 {
        distance(self.points, a, b)
    }

    fn after(&self, a: u32, forward: bool) -> u32 {
        let (i, n) = (self.place[a as usize] as usize, self.order.len());
        self.order[if forward { (i + 1) % n } else { (i + n - 1) % n }]
    }

    /// Steps from a on to b.
    fn steps(&self, a: u32, b: u32, forward: bool) -> usize {
        let (a, b, n) = (self.place[a as usize] as usize, self.place[b as usize] as usize, self.order.len());
        if forward { (b + n - a) % n } else { (a + n - b) % n }
    }

    /// Replaces steps a-b and c-d (in this order on the way, in either direction) by a-c and b-d.
    fn exchange(&mut self, a: u32, b: u32, c: u32, d: u32) {
        debug_assert!(self.after(a, true) == b && self.after(c, true) == d || self.after(b, true) == a);
        let _ = d;
        if self.after(a, true) == b { self.reverse(b, c) } else { self.reverse(c, b) }
    }

    /// Turns round the stretch from `from` on to `to`, or, which is the same tour, the rest if that is shorter.
    fn reverse(&mut self, from: u32, to: u32) {
        let n = self.order.len();
        let (mut i, mut j) = (self.place[from as usize] as usize, self.place[to as usize] as usize);
        let mut count = (j + n - i) % n + 1;
        if 2 * count > n {
            (i, j) = ((j + 1) % n, (i + n - 1) % n);
            count = n - count;
        }
        for _ in 0..count / 2 {
            self.order.swap(i, j);
            self.place[self.order[i] as usize] = i as u32;
            self.place[self.order[j] as usize] = j as u32;
            (i, j) = ((i + 1) % n, (j + n - 1) % n);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use crate::start::ball::ball_points;

    fn is_permutation(order: &[u32], count: usize) -> bool {
        let mut sorted = order.to_vec();
        sorted.sort_unstable();
        sorted == (0..count as u32).collect::<Vec<_>>()
    }

    #[test]
    fn tours_visit_every_point_once() {
        for count in [0, 1, 2, 3, 4, 5, 6, 7, 8, 60] {
            let points = ball_points(count, 0.8, count as u64);
            for closed in [false, true] {
                assert!(is_permutation(&short_tour(&points, closed), count), "{count} points");
            }
        }
        assert!(!is_permutation(&[0, 1, 1], 3));
    }

    #[test]
    fn every_move_shortens_the_tour_by_what_it_promised() {
        let points = ball_points(90, 0.8, 5);
        let near = nearest_lists(&points);
        let mut tour = Tour::new(&points, greedy_tour(&points));
        let mut length = tour_length(&points, &tour.order);
        let mut moves = 0;
        for round in 0..20 {
            for a in 0..90u32 {
                while tour.improve_at(a, &near[a as usize]).is_some() {
                    let now = tour_length(&points, &tour.order);
                    assert!(now < length, "round {round}, point {a}: {now} after {length}");
                    assert!(is_permutation(&tour.order, 90));
                    (length, moves) = (now, moves + 1);
                }
            }
        }
        assert!(moves > 10);
    }

    #[test]
    fn improvement_is_what_the_method_measured() {
        // 210 points in a ball of radius .8: 37.8 greedy and 35.0 with 2-opt, open; ours are closed, a step longer.
        let mut totals = [0.0; 2];
        for seed in 0..4 {
            let mut rng = Rng::new(seed, 9);
            let points: Vec<_> = (0..210).map(|_| rng.in_ball(0.8)).collect();
            totals[0] += tour_length(&points, &greedy_tour(&points)) / 4.0;
            totals[1] += tour_length(&points, &short_tour(&points, true)) / 4.0;
        }
        assert!(totals[0] > 36.0 && totals[1] < 0.92 * totals[0], "{totals:?}");
    }

    #[test]
    fn coincident_points_do_no_harm() {
        let mut points = vec![[0.1, 0.2, 0.3]; 40];
        points[7] = [0.5, 0.0, 0.0];
        assert!(is_permutation(&short_tour(&points, false), 40));
    }
}
