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
