//! Where integrals along the curve are taken: places with the curve's first two derivatives, as linear maps.

use super::{LinearMap, Real, Row, Wire, basis};

/// Midpoints of equal parts of every span: place, first and second derivative there as maps from the control points,
/// and how much of the parameter each stands for (midpoint rule).
#[derive(Debug, Clone, PartialEq)]
pub struct Nodes<R> {
    /// `[x, y, z, width]`.
    pub place: LinearMap<R>,
    /// Derivative of the same with respect to the parameter.
    pub first: LinearMap<R>,
    /// Second derivative.
    pub second: LinearMap<R>,
    /// Length of each node's part, knot units.
    pub steps: Vec<R>,
    /// Whether the last node is next to the first one.
    pub closed: bool,
}

impl Wire {
    /// `nodes_per_span` (at least 1) nodes in each of [`Wire::spans`], in order.
    pub fn nodes<R: Real>(&self, nodes_per_span: usize) -> Nodes<R> {
        let count = nodes_per_span.max(1);
        let mut rows = [0; 3].map(|_| Vec::with_capacity(count * self.control_points.len()));
        let mut steps = Vec::with_capacity(count * self.control_points.len());
        for span in self.spans() {
            for j in 0..count {
                let t = span.at((j as f64 + 0.5) / count as f64);
                for (order, rows) in rows.iter_mut().enumerate() {
                    rows.push(Row::from_f64(span.first, &basis::derivative(&self.knots, span.knot(), t, order)));
                }
                steps.push(R::from_f64(span.width() / count as f64));
            }
        }
        let [place, first, second] = rows.map(|rows| LinearMap::new(self.control_points.len(), rows));
        Nodes { place, first, second, steps, closed: self.closed }
    }
}

impl<R: Real> Nodes<R> {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether there is none: never, for a wire has a span.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Arc length that each node stands for, from the first derivatives there.
    pub fn lengths(&self, first: &[[R; 4]]) -> Vec<R> {
        let length = |([x, y, z, _], step): (&[R; 4], &R)| (*x * *x + *y * *y + *z * *z).sqrt() * *step;
        first.iter().zip(&self.steps).map(length).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_wires::{all_wires, distance};

    #[test]
    fn nodes_have_the_curves_derivatives_and_share_the_domain() {
        for wire in all_wires(3) {
            let nodes = wire.nodes::<f64>(3);
            let (start, end) = wire.domain();
            assert!((nodes.steps.iter().sum::<f64>() - (end - start)).abs() < 1e-9);
            assert_eq!(nodes.len(), 3 * wire.spans().count());
            for (order, map) in [&nodes.place, &nodes.first, &nodes.second].into_iter().enumerate() {
                let mut values = Vec::new();
                map.apply(wire.control_points(), &mut values);
                let mut nodes = values.iter();
                for span in wire.spans() {
                    for share in [0.5 / 3.0, 0.5, 2.5 / 3.0] {
                        let value = nodes.next().unwrap();
                        let expected = wire.derivative(span.at(share), order);
                        assert!(
                            distance(value, &expected) < 1e-9 * (1.0 + distance(value, &[0.0; 4])),
                            "order {order}"
                        );
                        assert!(distance(value, &wire.derivative(span.at(share) + 0.05, order)) > 0.0);
                    }
                }
            }
            let (fine, mut first) = (wire.nodes::<f64>(64), Vec::new());
            fine.first.apply(wire.control_points(), &mut first);
            let length: f64 = fine.lengths(&first).iter().sum();
            assert!((length - wire.length(1e-6)).abs() < 1e-2 * length);
        }
    }
}
