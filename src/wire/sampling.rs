//! Exact points of the curve as a linear map: what fitting and drawing use.

use super::{LinearMap, Real, Row, Span, Stroke, Wire, basis};

impl Wire {
    /// The map from control points to exact points of the curve, `samples_per_span` (at least 1) at equal parameter
    /// steps in each of [`Wire::spans`], and the strokes they form. The end of an open stroke is one sample more.
    ///
    /// With `sag_shift` each sample is moved by `-h²/12 C''`, h the parameter step, against the sag of chords, so that
    /// chords between samples average to the curve; it stays linear in the control points. Where steps of unequal length
    /// meet, `h²` is `h₁² - h₁h₂ + h₂²`, which balances both chords together, at most four times the smaller square.
    /// Open ends and corners (repeated knots, hence the joints of a chain) are not shifted.
    pub fn sampling_map<R: Real>(&self, samples_per_span: usize, sag_shift: bool) -> (LinearMap<R>, Vec<Stroke>) {
        let samples = samples_per_span.max(1);
        self.sample_spans(&self.spans().map(|span| (span, samples)).collect::<Vec<_>>(), sag_shift)
    }

    /// [`Wire::sampling_map`] with a number of samples for each span (0 counts as 1).
    ///
    /// # Panics
    /// If there is not one number a span.
    pub fn sampling_map_per_span<R: Real>(
        &self,
        samples_per_span: &[usize],
        sag_shift: bool,
    ) -> (LinearMap<R>, Vec<Stroke>) {
        assert_eq!(samples_per_span.len(), self.spans().count(), "one number of samples a span");
        let spans: Vec<_> = self.spans().zip(samples_per_span.iter().map(|&samples| samples.max(1))).collect();
        self.sample_spans(&spans, sag_shift)
    }

    /// Parameters of the samples of [`Wire::sampling_map`], in the same order.
    pub fn sample_parameters(&self, samples_per_span: usize) -> Vec<f64> {
        let samples = samples_per_span.max(1);
        let mut parameters = Vec::new();
        for span in self.spans() {
            parameters.extend((0..samples).map(|j| span.at(j as f64 / samples as f64)));
            if self.ends_stroke(&span) {
                parameters.push(span.end);
            }
        }
        parameters
    }

    fn sample_spans<R: Real>(&self, spans: &[(Span, usize)], sag_shift: bool) -> (LinearMap<R>, Vec<Stroke>) {
        let total = spans.iter().map(|(_, samples)| samples + 1).sum();
        let mut rows = Vec::with_capacity(total);
        let mut strokes = Vec::new();
        let mut stroke_start = 0;
        let step = |&(span, samples): &(Span, usize)| span.width() / samples as f64;
        // The step before the next sample; `None` where nothing joins it from before.
        let mut step_before = spans.last().filter(|_| self.closed).map(step);
        for entry @ (span, samples) in spans {
            let step_after = step(entry);
            for j in 0..*samples {
                let t = span.at(j as f64 / *samples as f64);
                let mut weights = basis::point(&self.knots, span.knot(), t);
                let corner = j == 0 && self.knots[span.knot() - 1] == self.knots[span.knot()];
                if let (true, false, Some(before)) = (sag_shift, corner, step_before) {
                    let bend = basis::derivative(&self.knots, span.knot(), t, 2);
                    let shift = shift_step_squared(before, step_after) / 12.0;
                    for (weight, bend) in weights.iter_mut().zip(bend) {
                        *weight -= shift * bend;
                    }
                }
                rows.push(Row::from_f64(span.first, &weights));
                step_before = Some(step_after);
            }
            if self.ends_stroke(span) {
                rows.push(Row::from_f64(span.first, &basis::point(&self.knots, span.knot(), span.end)));
                strokes.push(Stroke { start: stroke_start, count: rows.len() - stroke_start, closed: false });
                stroke_start = rows.len();
                step_before = None;
            }
        }
        if self.closed {
            strokes.push(Stroke { start: 0, count: rows.len(), closed: true });
        }
        (LinearMap::new(self.control_points.len(), rows), strokes)
    }

    /// Whether nothing joins the end of `span`: the end of an open wire or of a bag's segment.
    fn ends_stroke(&self, span: &Span) -> bool {
        // Four equal knots from the span's end on.
        self.knots[span.knot() + 1] == self.knots[span.knot() + 4]
    }
}

/// The `h²` of the sag shift between steps `a` and `b`. Two chords lose `(a³ + b³) f''/12` of area and moving their
/// joint by x gives back `(a + b) x`. The limit keeps weights bounded where a tiny span meets a long one.
fn shift_step_squared(a: f64, b: f64) -> f64 {
    let least = a.min(b);
    (a * a - a * b + b * b).min(4.0 * least * least)
}
