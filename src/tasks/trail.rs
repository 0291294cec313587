//! What a run remembers of itself for its replay: a wire now and then, often at first, when most happens.

use crate::wire::Wire;

/// Most wires that are remembered; a replay shows the most telling of them.
const MOST_WIRES: usize = 60;
/// Most control points of all of them together: some megabytes.
const MOST_POINTS: usize = 240_000;

/// The wires so far, with the numbers of their iterations.
#[derive(Default)]
pub(super) struct Trail(Vec<(u32, Wire)>);

impl Trail {
    /// Remembers the wire of an iteration, if one is due there.
    pub fn note(&mut self, iteration: usize, total: usize, wire: impl FnOnce() -> Wire) {
        let known = self.0.last().is_some_and(|(last, _)| *last as usize >= iteration);
        let points: usize = self.0.iter().map(|(_, wire)| wire.control_points().len()).sum();
        if !known
            && points < MOST_POINTS
            && (self.0.is_empty() || due_after(iteration.saturating_sub(1), total) == iteration)
        {
            self.0.push((iteration as u32, wire()));
        }
    }

    /// All of them, and the wire that the run came to.
    pub fn to(&self, iteration: usize, wire: Wire) -> Vec<(u32, Wire)> {
        let before = self.0.iter().filter(|(earlier, _)| (*earlier as usize) < iteration);
        before.cloned().chain([(iteration as u32, wire)]).collect()
    }
}

/// The iteration after the given one at which a wire is due: it depends on nothing else, so that a run leaves the same
/// trail however it is pulled.
pub(super) fn due_after(iteration: usize, total: usize) -> usize {
    // The square: four times as often after a quarter of the way.
    let due = |k: usize| total * k * k / (MOST_WIRES * MOST_WIRES);
    (0..MOST_WIRES).map(due).find(|&due| due > iteration).unwrap_or(total.max(iteration + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_the_same_however_a_run_is_pulled() {
        let wire =
            Wire::closed_uniform((0..5).map(|k| [f64::from(k), 0.0, f64::from(k * k % 3), 0.1]).collect()).unwrap();
        let pulled = |slice: usize| {
            let mut trail = Trail::default();
            let (mut at, total) = (0, 1000);
            while at < total {
                let mut left = slice.min(total - at);
                while left > 0 {
                    trail.note(at, total, || wire.clone());
                    let batch = left.min(due_after(at, total) - at);
                    at += batch;
                    left -= batch;
                }
            }
            trail.to(at, wire.clone()).into_iter().map(|(iteration, _)| iteration).collect::<Vec<_>>()
        };
        let whole = pulled(1000);
        assert_eq!((whole[0], whole[whole.len() - 1]), (0, 1000));
        assert!((40..=61).contains(&whole.len()) && whole.is_sorted_by(|a, b| a < b), "{whole:?}");
        assert!(whole[10] < 50, "often at first: {whole:?}");
        for slice in [1, 7, 64] {
            assert_eq!(pulled(slice), whole, "{slice} at a time");
        }
    }
}
