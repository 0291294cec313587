//! Exact points of the curve as a linear map: what fitting and drawing use.

use super::{LinearMap, Real, Row, Span, Stroke, Wire, basis};

impl Wire {
    /// The map from control points to exact points of the curve, `samples_per_span` (at least 1) at equal parameter
    /// steps in each of [`Wire::spans`], and the strokes they form. The end of an open stroke is one sample more.
    ///
    /// With `sag_shift` each sample is moved by `-h²/12 C''`, h the parameter step, against the sag of chords, so that
    /// chords between samples average to the curve; it stays linear in the control points. Where steps of unequal length
    /// meet, `h²` is `h₁² - h₁h₂ + h₂²`, which balances both chords together, at most four times the smaller square.
    /// Open ends and corners (repeated knots, hence the joints of a chain) are not shifted. Shifted widths can fall a
    /// little below zero where the wire's own width nearly does.
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

    /// Parameters of the samples of [`Wire::sampling_map`], in the same order. In a bag the last of one segment equals the
    /// first of the next.
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

/// The `h²` of the sag shift between steps `a` and `b`. A chord over h loses `h³ f''/12` of area, half of it for each
/// end to make up, and moving the joint of two chords by x gives back `(a + b) x / 2`. The limit keeps weights bounded
/// where a tiny span meets a long one.
fn shift_step_squared(a: f64, b: f64) -> f64 {
    let least = a.min(b);
    (a * a - a * b + b * b).min(4.0 * least * least)
}

#[cfg(test)]
mod tests {
    use super::super::Form;
    use super::super::test_wires::{all_wires, distance, new_knots, random_wire};
    use super::*;
    use crate::few_cases::few_cases;
    use crate::rng::Rng;

    fn samples(wire: &Wire, map: &LinearMap<f64>) -> Vec<[f64; 4]> {
        let mut samples = Vec::new();
        map.apply(wire.control_points(), &mut samples);
        samples
    }

    proptest::proptest! {
        #![proptest_config(few_cases())]
        #[test]
        fn samples_are_points_of_the_curve(seed in 0u64..1000, count in 0usize..9) {
            for wire in all_wires(seed) {
                let (map, strokes) = wire.sampling_map::<f64>(count, false);
                let samples = samples(&wire, &map);
                let parameters = wire.sample_parameters(count);
                proptest::prop_assert_eq!(samples.len(), parameters.len());
                for stroke in &strokes {
                    // The last sample of a bag's segment lies at a jump: the curve there is the next segment's.
                    let ends_at_jump = wire.form() == Form::Bag && stroke.start + stroke.count < samples.len();
                    let kept = stroke.count - usize::from(ends_at_jump);
                    for i in stroke.start..stroke.start + kept {
                        proptest::prop_assert!(distance(&samples[i], &wire.evaluate(parameters[i])) < 1e-13);
                        let beside = if i > 0 { parameters[i] - 0.01 } else { 0.01 };
                        proptest::prop_assert!(distance(&samples[i], &wire.evaluate(beside)) > 1e-9);
                    }
                }
            }
        }

        #[test]
        fn weights_sum_to_one_and_stay_bounded(seed in 0u64..1000, count in 1usize..9) {
            for wire in all_wires(seed) {
                for shift in [false, true] {
                    for row in wire.sampling_map::<f64>(count, shift).0.rows() {
                        proptest::prop_assert!((row.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
                        proptest::prop_assert!(row.weights.iter().all(|weight| weight.abs() < 4.0));
                    }
                }
            }
        }
    }

    #[test]
    fn strokes_follow_the_form() {
        let counts = |form, closed| {
            let wire = random_wire(form, closed, 17, 1);
            let (map, strokes) = wire.sampling_map::<f32>(4, true);
            (wire.spans().count(), map.rows().len(), strokes)
        };
        let (spans, samples, strokes) = counts(Form::Spline, false);
        assert_eq!(samples, 4 * spans + 1);
        assert_eq!(strokes, [Stroke { start: 0, count: samples, closed: false }]);
        let (spans, samples, strokes) = counts(Form::Chain, true);
        assert_eq!(samples, 4 * spans);
        assert_eq!(strokes, [Stroke { start: 0, count: samples, closed: true }]);
        let (spans, samples, strokes) = counts(Form::Bag, false);
        assert_eq!(samples, 5 * spans);
        let expected: Vec<_> = (0..spans).map(|i| Stroke { start: 5 * i, count: 5, closed: false }).collect();
        assert_eq!(strokes, expected);
    }

    /// Mean over all chords of how far they lie on the hollow side of the curve (signed), and of the distance itself.
    fn sag(wire: &Wire, counts: &[usize], shift: bool) -> (f64, f64) {
        let points = samples(wire, &wire.sampling_map_per_span::<f64>(counts, shift).0);
        let mut parameters: Vec<f64> = wire
            .spans()
            .zip(counts)
            .flat_map(|(span, &count)| (0..count).map(move |j| span.at(j as f64 / count as f64)))
            .collect();
        parameters.push(wire.domain().1);
        let (mut signed, mut absolute, mut count) = (0.0, 0.0, 0.0);
        for i in 0..parameters.len() - 1 {
            let next = (i + 1) % points.len();
            for j in 0..16 {
                let s = (f64::from(j) + 0.5) / 16.0;
                let t = (1.0 - s) * parameters[i] + s * parameters[i + 1];
                let (curve, bend) = (wire.evaluate(t), wire.derivative(t, 2));
                let size = (0..3).map(|c| bend[c] * bend[c]).sum::<f64>().sqrt();
                let off = [0, 1, 2].map(|c| (1.0 - s) * points[i][c] + s * points[next][c] - curve[c]);
                signed += (0..3).map(|c| off[c] * bend[c]).sum::<f64>() / size.max(1e-9);
                absolute += off.iter().map(|x| x * x).sum::<f64>().sqrt();
                count += 1.0;
            }
        }
        ((signed / count).abs(), absolute / count)
    }

    #[test]
    fn shifted_chords_average_to_the_curve() {
        for seed in 0..4 {
            let even = random_wire(Form::Spline, true, 30, seed);
            let uneven = random_wire(Form::Spline, true, 30, seed);
            let uneven = uneven.insert_knots(&new_knots(&uneven, 20, &mut Rng::new(seed, 8))).unwrap().0;
            let mixed: Vec<usize> = (0..uneven.spans().count()).map(|i| 8 + i * 5 % 4).collect();
            for (wire, counts) in [(&even, vec![8; even.spans().count()]), (&uneven, mixed)] {
                let ((plain, plain_distance), (shifted, shifted_distance)) =
                    (sag(wire, &counts, false), sag(wire, &counts, true));
                assert!(shifted < 0.1 * plain, "seed {seed}: {shifted} {plain}");
                assert!(shifted_distance < 0.7 * plain_distance, "{shifted_distance} {plain_distance}");
            }
        }
    }

    #[test]
    fn open_ends_and_corners_are_not_shifted() {
        for (wire, corners) in [
            (random_wire(Form::Spline, false, 12, 2), false),
            (random_wire(Form::Chain, false, 13, 2), true),
            (random_wire(Form::Bag, false, 12, 2), true),
        ] {
            let (plain, shifted) = (wire.sampling_map::<f64>(3, false).0, wire.sampling_map::<f64>(3, true).0);
            let moved: Vec<bool> =
                plain.rows().iter().zip(shifted.rows()).map(|(a, b)| distance(&a.weights, &b.weights) > 1e-9).collect();
            assert!(!moved[0] && !moved[moved.len() - 1] && moved[1]);
            assert_eq!(moved[3], !corners);
        }
    }

    #[test]
    fn a_tiny_span_beside_a_long_one_moves_nothing_far() {
        let wire = random_wire(Form::Spline, true, 12, 2);
        let first = wire.spans().next().unwrap();
        let wire = wire.insert_knots(&[first.start + 2e-5]).unwrap().0;
        for row in wire.sampling_map::<f64>(2, true).0.rows() {
            assert!(row.weights.iter().all(|weight| weight.abs() < 4.0), "{:?}", row.weights);
        }
    }
}
