//! Exact conversion to Bézier pieces, whole spans or finer: the linear map `M_dense`.

use super::{LinearMap, Real, Row, Wire, basis};

impl Wire {
    /// The map from control points to the Bézier control points of each span, four rows a span, exact.
    pub fn bezier_map<R: Real>(&self) -> LinearMap<R> {
        self.pieces(self.spans().map(|span| (span, 1)))
    }

    /// The map from control points to Bézier control points, `pieces_per_span[i]` equal pieces (by parameter) of the
    /// i-th of [`Wire::spans`] (0 counts as 1), four rows a piece, exact.
    ///
    /// # Panics
    /// If there is not one number a span.
    pub fn subdivision_map<R: Real>(&self, pieces_per_span: &[usize]) -> LinearMap<R> {
        assert_eq!(pieces_per_span.len(), self.spans().count(), "one number of pieces a span");
        self.pieces(self.spans().zip(pieces_per_span.iter().copied()))
    }

    fn pieces<R: Real>(&self, spans: impl Iterator<Item = (super::Span, usize)>) -> LinearMap<R> {
        let mut rows = Vec::new();
        for (span, pieces) in spans {
            let pieces = pieces.max(1);
            for piece in 0..pieces {
                let start = span.at(piece as f64 / pieces as f64);
                let end = span.at((piece + 1) as f64 / pieces as f64);
                let points = basis::bezier(&self.knots, span.knot(), start, end);
                rows.extend(points.iter().map(|weights| Row::from_f64(span.first, weights)));
            }
        }
        LinearMap::new(self.control_points.len(), rows)
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::{all_wires, distance};
    use super::*;
    use crate::few_cases::few_cases;

    /// de Casteljau's corner cutting, independent of the blossom.
    fn de_casteljau(points: &[[f64; 4]], s: f64) -> [f64; 4] {
        let mut points = points.to_vec();
        while points.len() > 1 {
            points = points.windows(2).map(|p| [0, 1, 2, 3].map(|c| (1.0 - s) * p[0][c] + s * p[1][c])).collect();
        }
        points[0]
    }

    /// Largest distance between the wire and its Bézier pieces.
    fn error(wire: &Wire, pieces: &[usize], beziers: &[[f64; 4]]) -> f64 {
        let ranges = wire.spans().zip(pieces).flat_map(|(span, &pieces)| {
            let n = pieces as f64;
            (0..pieces).map(move |i| (span.at(i as f64 / n), span.at((i + 1) as f64 / n)))
        });
        let mut error: f64 = 0.0;
        for ((start, end), points) in ranges.zip(beziers.chunks(4)) {
            // Not at the very end, where a bag jumps.
            for s in [0.0, 0.2, 0.5, 0.8, 0.999] {
                let t = start + s * (end - start);
                error = error.max(distance(&wire.evaluate(t), &de_casteljau(points, s)));
            }
        }
        error
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn pieces_are_the_curve(seed in 0u64..1000) {
            for wire in all_wires(seed) {
                let whole = vec![1; wire.spans().count()];
                let fine: Vec<usize> = (0..whole.len()).map(|i| 1 + (i + seed as usize) % 5).collect();
                for (map, pieces) in [(wire.bezier_map::<f64>(), &whole), (wire.subdivision_map::<f64>(&fine), &fine)] {
                    proptest::prop_assert_eq!(map.rows().len(), 4 * pieces.iter().sum::<usize>());
                    let mut beziers = Vec::new();
                    map.apply(wire.control_points(), &mut beziers);
                    proptest::prop_assert!(error(&wire, pieces, &beziers) < 1e-12);
                    beziers[1][2] += 1e-6;
                    proptest::prop_assert!(error(&wire, pieces, &beziers) > 1e-8, "one moved point is noticed");
                }
            }
        }
    }

    #[test]
    fn halving_is_de_casteljau() {
        for wire in all_wires(3) {
            let (mut whole, mut halves) = (Vec::new(), Vec::new());
            wire.bezier_map::<f64>().apply(wire.control_points(), &mut whole);
            wire.subdivision_map::<f64>(&vec![2; wire.spans().count()]).apply(wire.control_points(), &mut halves);
            for (z, halves) in whole.chunks(4).zip(halves.chunks(8)) {
                let left = [&z[..1], &z[..2], &z[..3], z].map(|points| de_casteljau(points, 0.5));
                let right = [z, &z[1..], &z[2..], &z[3..]].map(|points| de_casteljau(points, 0.5));
                for (expected, point) in left.iter().chain(&right).zip(halves) {
                    assert!(distance(expected, point) < 1e-13);
                }
                assert!(distance(&left[1], &halves[2]) > 1e-6, "neighbours differ");
            }
        }
    }

    #[test]
    fn clamped_ends_have_their_known_rows() {
        let wire = Wire::open_uniform(vec![[0.0; 4]; 8]).unwrap();
        let map = wire.bezier_map::<f64>();
        let expected =
            [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.5, 0.5, 0.0], [0.0, 0.25, 7.0 / 12.0, 1.0 / 6.0]];
        for (row, expected) in map.rows().iter().zip(expected) {
            assert_eq!(row.first, 0);
            assert!(distance(&row.weights, &expected) < 1e-15);
        }
    }
}
