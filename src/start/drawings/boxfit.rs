//! The object's box from the drawings' aspects: views that share an axis span the same interval along it.
//!
//! With sides w, h, d the front keeps its aspect a_f if w / h = a_f, the side if d / h = a_s, the top if w / d = a_t.
//! All three hold exactly when a_f = a_s a_t; else the leftover q = a_s a_t / a_f is shared: each view is stretched by
//! q^(1/3) and no choice of sides does better. Two views share one axis only and need no stretch.

/// A box and how each drawing fills its side of it.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxFit {
    /// Sides along x, y, z; the largest is 1.
    pub sides: [f64; 3],
    /// For each view (front, side, top): the factor by which the drawing is stretched along one axis relative to the
    /// other, at least 1.
    pub stretch: Vec<f64>,
    /// For each view: the share of the box's side that the drawing fills across and down, at most 1; below 1 where
    /// filling it would take more stretch than allowed.
    pub filled: Vec<[f64; 2]>,
}

/// Drawings slimmer than this would make a box without room for a wire; they get blank paper beside them instead.
const MOST_SLENDER: f64 = 8.0;

/// Fits the box to the aspects (width / height) of the front, the side and, if given, the top drawing.
pub fn fit_box(aspects: &[f64], max_stretch: f64) -> BoxFit {
    let usable: Vec<f64> = aspects.iter().map(|&aspect| usable(aspect)).collect();
    let share = match usable[..] {
        [front, side, top] => (side * top / front).cbrt(),
        _ => 1.0,
    };
    // Height 1: the front asks for w = a_f q^(1/3), the side for d = a_s q^(-1/3).
    let (w, d) = (usable[0] * share, usable.get(1).map_or(1.0, |side| side / share));
    let longest = w.max(d).max(1.0);
    let box_aspects = [w, d, w / d];
    let (stretch, filled) = aspects.iter().zip(box_aspects).map(|(&own, side)| fill(own, side, max_stretch)).unzip();
    BoxFit { sides: [w, 1.0, d].map(|side| side / longest), stretch, filled }
}

/// Fits the box to two drawings that share their width: the front's aspect and the top's. Neither is ever stretched.
pub fn fit_box_of_widths([front, top]: [f64; 2], max_stretch: f64) -> BoxFit {
    let [usable_front, usable_top] = [front, top].map(usable);
    // Width 1: the front is as high, the top as deep as its aspect says.
    let (h, d) = (1.0 / usable_front, 1.0 / usable_top);
    let longest = h.max(d).max(1.0);
    let (stretch, filled) =
        [(front, usable_front), (top, usable_top)].iter().map(|&(own, side)| fill(own, side, max_stretch)).unzip();
    BoxFit { sides: [1.0, h, d].map(|side| side / longest), stretch, filled }
}

/// An aspect that leaves a box room for a wire.
fn usable(aspect: f64) -> f64 {
    aspect.clamp(1.0 / MOST_SLENDER, MOST_SLENDER)
}

/// How a drawing of aspect `own` fills a side of aspect `side` when stretched by at most `max_stretch`.
fn fill(own: f64, side: f64, max_stretch: f64) -> (f64, [f64; 2]) {
    let wanted = side / own;
    let given = wanted.clamp(1.0 / max_stretch, max_stretch);
    let left = wanted / given;
    (given.max(1.0 / given), [(1.0 / left).min(1.0), left.min(1.0)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_views_never_need_stretch() {
        for (front, side) in [(1.0, 1.0), (0.3, 2.5), (4.0, 0.7), (7.9, 7.9)] {
            let fit = fit_box(&[front, side], 1.35);
            assert!(fit.stretch.iter().all(|s| (s - 1.0).abs() < 1e-12));
            assert!(fit.filled.iter().flatten().all(|f| (f - 1.0).abs() < 1e-12));
            assert!((fit.sides[0] / fit.sides[1] - front).abs() < 1e-12);
            assert!((fit.sides[2] / fit.sides[1] - side).abs() < 1e-12);
        }
    }

    #[test]
    fn three_views_share_the_leftover_evenly() {
        for aspects in [[1.0, 1.2, 0.9], [2.0, 0.5, 1.0], [0.7, 1.4, 2.2]] {
            let q: f64 = aspects[1] * aspects[2] / aspects[0];
            let even = q.cbrt().max(1.0 / q.cbrt());
            let fit = fit_box(&aspects, 10.0);
            assert!(fit.stretch.iter().all(|s| (s - even).abs() < 1e-12), "{fit:?}");
            assert!(fit.filled.iter().flatten().all(|f| (f - 1.0).abs() < 1e-12));
            // No other box has a smaller worst stretch.
            for (w, d) in [(0.9, 1.0), (1.1, 1.0), (1.0, 0.9), (1.0, 1.1), (1.05, 1.05)] {
                let (w, d) = (fit.sides[0] * w, fit.sides[2] * d);
                let h = fit.sides[1];
                let worst = [w / h / aspects[0], d / h / aspects[1], w / d / aspects[2]]
                    .map(|s| s.max(1.0 / s))
                    .into_iter()
                    .fold(0.0, f64::max);
                assert!(worst > even - 1e-12);
            }
        }
        let agreeing = fit_box(&[1.5 * 0.8, 1.5, 0.8], 1.35);
        assert!(agreeing.stretch.iter().all(|s| (s - 1.0).abs() < 1e-12));
    }

    #[test]
    fn more_stretch_than_allowed_leaves_paper() {
        let fit = fit_box(&[0.25, 1.0, 1.0], 1.35);
        for (s, [across, down]) in fit.stretch.iter().zip(&fit.filled) {
            assert!((s - 1.35).abs() < 1e-12 && across.min(*down) < 1.0 && across.max(*down) == 1.0);
        }
        let slender = fit_box(&[1e-3, 1.0], 1.35);
        assert!(slender.sides.iter().all(|side| *side >= 1.0 / MOST_SLENDER - 1e-12));
        assert!(slender.filled[0][0] < 0.1);
    }
}
