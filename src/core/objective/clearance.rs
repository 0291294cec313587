//! Strands that are far apart along the wire keep a clearance in space: who is near whom, and the push between them.

use crate::wire::Real;

/// Lengths that say what is too near.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Clearance<R> {
    /// Weight of Σ (1 - distance/D)² h²/D over pairs of nodes nearer than D, h the length a node stands for; 0 is off.
    pub weight: R,
    /// D in mean diameters of the two strands.
    pub diameters: R,
    /// The least D, world units.
    pub least_world: R,
    /// h over the node's step: the mean speed, world units a knot unit.
    pub speed: R,
}

/// For each node the other nodes that may come too near before the next look. Symmetric.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Neighbours {
    /// Where each node's list begins in `others`, and where the last one ends.
    pub starts: Vec<u32>,
    /// The lists, each in ascending order.
    pub others: Vec<u32>,
}

/// The most neighbours a node keeps, the nearest ones: strands packed round it on all sides have fewer.
pub const MOST_NEIGHBOURS: usize = 32;

impl Neighbours {
    /// No neighbours for `count` nodes.
    pub fn none(count: usize) -> Neighbours {
        Neighbours { starts: vec![0; count + 1], others: Vec::new() }
    }

    /// The neighbours of node `i`.
    pub fn of(&self, i: usize) -> &[u32] {
        &self.others[self.starts[i] as usize..self.starts[i + 1] as usize]
    }

    /// Pairs of nodes within D plus `slack_world` of each other and at least `one_strand` D apart along the wire, by a grid of
    /// cells that no pair can skip. `lengths` are the arc lengths that nodes stand for. From π/2 on no round bend that is as
    /// wide as D pushes itself.
    pub fn find(
        places: &[[f32; 4]],
        lengths: &[f32],
        closed: bool,
        clearance: &Clearance<f32>,
        one_strand: f32,
        slack_world: f32,
    ) -> Neighbours {
        let count = places.len();
        let widest = places.iter().map(|place| place[3]).fold(0.0, f32::max);
        let reach = (clearance.diameters * widest).max(clearance.least_world) + slack_world;
        let usable = reach > 0.0 && reach.is_finite() && places.iter().flatten().all(|c| c.is_finite());
        if !usable {
            return Neighbours::none(count);
        }
        let mut along = Vec::with_capacity(count);
        let mut total = 0.0;
        for length in lengths {
            along.push(total + 0.5 * length);
            total += length;
        }
        let grid = Grid::new(places, reach);
        let mut found: Vec<(f32, u32)> = Vec::new();
        let mut nearest = Neighbours { starts: vec![0], others: Vec::new() };
        for (i, place) in places.iter().enumerate() {
            found.clear();
            grid.each_near(place, |j| {
                let other = &places[j as usize];
                let mut apart = (along[i] - along[j as usize]).abs();
                if closed {
                    apart = apart.min(total - apart);
                }
                let squared = (0..3).map(|c| (place[c] - other[c]).powi(2)).sum::<f32>();
                let least = least_distance(clearance, place[3], other[3]);
                if apart >= one_strand * least && squared < (least + slack_world).powi(2) {
                    keep_nearest(&mut found, (squared, j));
                }
            });
            let first = nearest.others.len();
            for &(_, j) in &found {
                let place = first + nearest.others[first..].partition_point(|&other| other < j);
                nearest.others.insert(place, j);
            }
            nearest.starts.push(nearest.others.len() as u32);
        }
        nearest.mutual()
    }

    /// Only those who have each other.
    fn mutual(&self) -> Neighbours {
        let mut mutual = Neighbours { starts: vec![0], others: Vec::with_capacity(self.others.len()) };
        for i in 0..self.starts.len() - 1 {
            let has_me = |&&j: &&u32| self.of(j as usize).binary_search(&(i as u32)).is_ok();
            mutual.others.extend(self.of(i).iter().filter(has_me));
            mutual.starts.push(mutual.others.len() as u32);
        }
        mutual
    }
}

/// Adds one to a short list, nearest first, that drops who is one too many. (Sorting would take more code than the rest.)
fn keep_nearest(found: &mut Vec<(f32, u32)>, (squared, j): (f32, u32)) {
    let place = found.partition_point(|&(other, k)| (other, k) < (squared, j));
    if place < MOST_NEIGHBOURS {
        found.insert(place, (squared, j));
        found.truncate(MOST_NEIGHBOURS);
    }
}

/// Points by cubic cells, in lists by a hash of the cell (Teschner et al. 2003).
struct Grid {
    side: f32,
    cells: Vec<[i32; 3]>,
    /// The first point of each list, and the one after each point.
    first: Vec<u32>,
    next: Vec<u32>,
}

/// No more points in a list.
const END: u32 = u32::MAX;

impl Grid {
    fn new(places: &[[f32; 4]], side: f32) -> Grid {
        let lists = places.len().next_power_of_two();
        let (first, next) = (vec![END; lists], vec![END; places.len()]);
        let mut grid = Grid { side, cells: Vec::with_capacity(places.len()), first, next };
        for (i, place) in places.iter().enumerate() {
            let cell = cell(place, side);
            let list = grid.list(cell);
            grid.cells.push(cell);
            grid.next[i] = std::mem::replace(&mut grid.first[list], i as u32);
        }
        grid
    }

    fn list(&self, [x, y, z]: [i32; 3]) -> usize {
        let mixed = x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
        mixed as u32 as usize & (self.first.len() - 1)
    }

    /// Calls `visit` with every point in the cells round `place`.
    fn each_near(&self, place: &[f32; 4], mut visit: impl FnMut(u32)) {
        let middle = cell(place, self.side);
        for near in 0..27 {
            let cell = [middle[0] + near / 9 - 1, middle[1] + near / 3 % 3 - 1, middle[2] + near % 3 - 1];
            let mut point = self.first[self.list(cell)];
            while point != END {
                if self.cells[point as usize] == cell {
                    visit(point);
                }
                point = self.next[point as usize];
            }
        }
    }
}

/// Casts saturate, well inside what neighbours of a cell need.
fn cell(place: &[f32; 4], side: f32) -> [i32; 3] {
    std::array::from_fn(|c| ((place[c] / side).floor() as i32).clamp(i32::MIN / 2, i32::MAX / 2))
}

fn least_distance<R: Real>(clearance: &Clearance<R>, width: R, other: R) -> R {
    let half = R::from_f64(0.5);
    (half * clearance.diameters * (width + other)).max(clearance.least_world)
}

/// The push's energy at `places`; **adds** its gradient to `d_place`. `steps` are the parts of the parameter that nodes
/// stand for. Strands that coincide push in no direction.
pub fn clearance_and_gradient<R: Real>(
    places: &[[R; 4]],
    steps: &[R],
    neighbours: &Neighbours,
    clearance: &Clearance<R>,
    d_place: &mut [[R; 4]],
) -> R {
    let (zero, one, half) = (R::zero(), R::one(), R::from_f64(0.5));
    let mut total = zero;
    for (i, place) in places.iter().enumerate() {
        let mut pull = [zero; 4];
        for &j in neighbours.of(i) {
            let other = &places[j as usize];
            let apart: [R; 3] = std::array::from_fn(|c| place[c] - other[c]);
            let distance = (apart[0] * apart[0] + apart[1] * apart[1] + apart[2] * apart[2]).sqrt();
            let least = least_distance(clearance, place[3], other[3]);
            if distance >= least {
                continue;
            }
            let near = one - distance / least;
            let share = clearance.weight * clearance.speed * clearance.speed * steps[i] * steps[j as usize] / least;
            // Each pair is seen from both its ends.
            total = total + half * share * near * near;
            if distance > zero {
                let push = -(share + share) * near / (least * distance);
                for c in 0..3 {
                    pull[c] = pull[c] + push * apart[c];
                }
            }
            if least > clearance.least_world {
                // Of near²/D by D, and of D by the width.
                let d_least = share * near * ((distance + distance) / least - near) / least;
                pull[3] = pull[3] + half * clearance.diameters * d_least;
            }
        }
        for c in 0..4 {
            d_place[i][c] = d_place[i][c] + pull[c];
        }
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;

    const CLEARANCE: Clearance<f64> = Clearance { weight: 0.7, diameters: 1.25, least_world: 0.05, speed: 0.3 };

    fn single(clearance: &Clearance<f64>) -> Clearance<f32> {
        Clearance {
            weight: clearance.weight as f32,
            diameters: clearance.diameters as f32,
            least_world: clearance.least_world as f32,
            speed: clearance.speed as f32,
        }
    }

    fn cloud(count: usize, seed: u64) -> Vec<[f64; 4]> {
        let mut rng = Rng::new(seed, 1);
        (0..count)
            .map(|_| {
                let [x, y, z] = rng.in_ball(0.2);
                [x, y, z, rng.range(0.02, 0.08)]
            })
            .collect()
    }

    fn find(places: &[[f64; 4]], closed: bool, one_strand: f32, slack: f32) -> Neighbours {
        let places: Vec<_> = places.iter().map(|place| place.map(|c| c as f32)).collect();
        let lengths = vec![0.01; places.len()];
        Neighbours::find(&places, &lengths, closed, &single(&CLEARANCE), one_strand, slack)
    }

    #[test]
    fn the_grid_finds_whom_all_pairs_find() {
        for (closed, count) in [(false, 40), (true, 40)] {
            let places = cloud(count, 2);
            let found = find(&places, closed, 1.03, 0.02);
            let mut pairs = 0;
            for i in 0..count {
                let near = |&j: &usize| {
                    let steps = i.abs_diff(j);
                    let steps = if closed { steps.min(count - steps) } else { steps };
                    let distance = (0..3).map(|c| (places[i][c] - places[j][c]).powi(2)).sum::<f64>().sqrt();
                    let least = (1.25 * 0.5 * (places[i][3] + places[j][3])).max(0.05);
                    steps as f64 * 0.01 >= 1.03 * least && distance < least + 0.02
                };
                let expected: Vec<u32> = (0..count).filter(near).map(|j| j as u32).collect();
                assert_eq!(found.of(i), expected, "node {i}");
                pairs += expected.len();
            }
            assert!(pairs > 20);
        }
    }

    #[test]
    fn crowds_keep_the_nearest_and_stay_symmetric() {
        let found = find(&cloud(400, 3), false, 0.0, 0.3);
        assert!((0..400).all(|i| found.of(i).len() <= MOST_NEIGHBOURS));
        assert!((0..400).all(|i| found.of(i).iter().all(|&j| found.of(j as usize).contains(&(i as u32)))));
        assert!(found.others.len() > 400);
    }

    #[test]
    fn gradients_agree_with_central_differences() {
        let places = cloud(40, 4);
        let neighbours = find(&places, false, 0.5, 0.02);
        let steps: Vec<f64> = (0..40).map(|i| 0.1 + 0.01 * f64::from(i)).collect();
        let energy = |places: &[[f64; 4]]| {
            clearance_and_gradient(places, &steps, &neighbours, &CLEARANCE, &mut vec![[0.0; 4]; places.len()])
        };
        let mut gradient = vec![[0.0; 4]; 40];
        assert!(clearance_and_gradient(&places, &steps, &neighbours, &CLEARANCE, &mut gradient) > 0.0);
        let (mut off, mut size) = (0.0, 0.0);
        for i in 0..40 {
            for c in 0..4 {
                let at = |h: f64| {
                    let mut moved = places.clone();
                    moved[i][c] += h;
                    energy(&moved)
                };
                let numeric = (at(1e-7) - at(-1e-7)) / 2e-7;
                off += (numeric - gradient[i][c]).powi(2);
                size += numeric.powi(2);
            }
        }
        assert!(size > 0.0 && off < 1e-9 * size, "{:.1e} of {:.1e}", off.sqrt(), size.sqrt());
    }

    #[test]
    fn coincident_and_broken_places_give_no_nan() {
        let mut places = vec![[0.1, 0.2, 0.3, 0.05]; 20];
        let neighbours = find(&places, false, 0.7, 0.01);
        assert!(!neighbours.others.is_empty());
        let mut gradient = vec![[0.0; 4]; 20];
        let energy = clearance_and_gradient(&places, &[0.1; 20], &neighbours, &CLEARANCE, &mut gradient);
        assert!(energy > 0.0 && gradient.iter().flatten().all(|c| c.is_finite()));
        places[3][1] = f64::NAN;
        assert_eq!(find(&places, false, 0.05, 0.01), Neighbours::none(20));
    }
}
