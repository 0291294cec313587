//! What bending a wire costs: Euler's elastica ∫κ² ds, a hinge on bends too tight for a hand, and even speed along it.

use crate::wire::{Nodes, Real};

/// Weights and lengths of one iteration; the weights are 0 where a term is off. World units.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Elastic<R> {
    /// Weight of bending, ∫ ln(1 + ρ²κ²)/ρ² ds: κ² for bends far wider than `cusp_radius` ρ, and nearly flat for tighter
    /// ones, so that no cusp outweighs the rest of the wire.
    pub bending: R,
    /// ρ, above 0 where the wire is to be elastic at all.
    pub cusp_radius: R,
    /// Weight of the hinge r ∫ o²/(1 + o) ds on bends tighter than a radius r, o = max(0, rκ - 1).
    pub tightness: R,
    /// The least r.
    pub least_radius: R,
    /// r in local diameters, where that is more.
    pub least_diameters: R,
    /// Weight of ∫ (|C'|/v - 1)² v dt: control points stay evenly spaced along the wire.
    pub evenness: R,
    /// v, above 0 where the wire is to be elastic at all: world units a knot unit.
    pub speed: R,
}

impl<R: Real> Elastic<R> {
    /// Whether any term is on.
    pub fn is_on(&self) -> bool {
        [self.bending, self.tightness, self.evenness].iter().any(|&weight| weight > R::zero())
    }
}

/// The three terms: bending, tightness, evenness.
pub type ElasticTerms<R> = [R; 3];

/// The speed below which curvature is taken for less than it is, as a share of the mean speed: a curve that stands still
/// has no curvature.
pub const STANDSTILL: f64 = 0.1;

/// The terms over all nodes, given the curve's `place`s, `first` and `second` derivatives there. **Adds** the gradient to
/// `d_place` (its width alone), `d_first` and `d_second`.
pub fn elastic_and_gradient<R: Real>(
    nodes: &Nodes<R>,
    [place, first, second]: [&[[R; 4]]; 3],
    elastic: &Elastic<R>,
    d_place: &mut [[R; 4]],
    d_first: &mut [[R; 4]],
    d_second: &mut [[R; 4]],
) -> ElasticTerms<R> {
    let (zero, one) = (R::zero(), R::one());
    let two = one + one;
    let dot = |a: [R; 3], b: [R; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let standstill = R::from_f64(STANDSTILL) * elastic.speed;
    let cusp_squared = elastic.cusp_radius * elastic.cusp_radius;
    let mut terms = [zero; 3];
    for i in 0..nodes.len() {
        let ([ax, ay, az, _], [bx, by, bz, _], step) = (first[i], second[i], nodes.steps[i]);
        let speed = (dot([ax, ay, az], [ax, ay, az]) + standstill * standstill).sqrt();
        let tangent = [ax, ay, az].map(|c| c / speed);
        let turn = [bx, by, bz].map(|c| c / (speed * speed));
        let along = dot(tangent, turn);
        let turn_squared = dot(turn, turn);
        let curvature_squared = (turn_squared - along * along).max(zero);
        let length = speed * step;

        let saturated = (cusp_squared * curvature_squared).ln_1p() / cusp_squared;
        let mut density = elastic.bending * saturated;
        let mut d_square = elastic.bending * length / (one + cusp_squared * curvature_squared);
        terms[0] = terms[0] + density * length;

        let width = place[i][3];
        let by_width = elastic.least_diameters * width;
        let radius = by_width.max(elastic.least_radius);
        let curvature = curvature_squared.sqrt();
        let over = radius * curvature - one;
        if over > zero {
            let hinge = over * over / (one + over);
            let slope = (over * over + two * over) / ((one + over) * (one + over));
            let tight = elastic.tightness * radius * hinge;
            density = density + tight;
            terms[1] = terms[1] + tight * length;
            d_square = d_square + elastic.tightness * length * radius * radius * slope / (two * curvature);
            if by_width > elastic.least_radius {
                let d_radius = elastic.tightness * length * (hinge + radius * curvature * slope);
                d_place[i][3] = d_place[i][3] + d_radius * elastic.least_diameters;
            }
        }

        let uneven = speed / elastic.speed - one;
        terms[2] = terms[2] + elastic.evenness * uneven * uneven * elastic.speed * step;
        let d_speed = (density + two * elastic.evenness * uneven) * step;
        let (d_turn, d_tangent) = (two * d_square / (speed * speed), two * d_square / speed);
        let three = two + one;
        for c in 0..3 {
            let d_a =
                d_tangent * (turn_squared * tangent[c] - along * turn[c] - three * curvature_squared * tangent[c]);
            d_first[i][c] = d_first[i][c] + d_a + d_speed * tangent[c];
            d_second[i][c] = d_second[i][c] + d_turn * (turn[c] - along * tangent[c]);
        }
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rng::Rng;
    use crate::wire::Wire;

    fn circle(radius: f64, width: f64) -> Wire {
        let points = (0..64).map(|i| f64::from(i) * std::f64::consts::TAU / 64.0);
        Wire::closed_uniform(points.map(|a| [radius * a.cos(), radius * a.sin(), 0.1, width]).collect()).unwrap()
    }

    fn terms(wire: &Wire, elastic: &Elastic<f64>) -> (ElasticTerms<f64>, Vec<[f64; 4]>) {
        let nodes = wire.nodes::<f64>(3);
        let maps = [&nodes.place, &nodes.first, &nodes.second];
        let values = maps.map(|map| {
            let mut values = Vec::new();
            map.apply(wire.control_points(), &mut values);
            values
        });
        let mut d = [0; 3].map(|_| vec![[0.0; 4]; nodes.len()]);
        let [d_place, d_first, d_second] = &mut d;
        let [place, first, second] = &values;
        let terms = elastic_and_gradient(&nodes, [place, first, second], elastic, d_place, d_first, d_second);
        let mut d_points = vec![[0.0; 4]; wire.control_points().len()];
        maps.iter().zip(&d).for_each(|(map, d)| map.apply_transpose(d, &mut d_points));
        (terms, d_points)
    }

    #[test]
    fn a_circle_costs_what_the_formulas_say() {
        let wire = circle(0.5, 0.1);
        let length = wire.length(1e-9);
        let elastic = Elastic {
            bending: 0.7,
            cusp_radius: 1e-4,
            tightness: 0.3,
            least_radius: 0.2,
            least_diameters: 10.0,
            evenness: 2.0,
            speed: length / 64.0,
        };
        let ([bending, tightness, evenness], _) = terms(&wire, &elastic);
        assert!((bending / (0.7 * 4.0 * length) - 1.0).abs() < 0.03, "κ = 2 but for the standstill: {bending}");
        // r = 1 by the width, o = 1.
        assert!((tightness / (0.3 * 0.5 * length) - 1.0).abs() < 0.05, "{tightness}");
        assert!(evenness < 1e-3, "{evenness}");
        let wide = Elastic { least_diameters: 4.0, ..elastic };
        assert_eq!(terms(&wire, &wide).0[1], 0.0, "a bend wide enough costs nothing");
        let sharp = Elastic { cusp_radius: 1.0, ..elastic };
        assert!(terms(&wire, &sharp).0[0] < 0.5 * bending, "bends tighter than the cusp radius saturate");
    }

    #[test]
    fn gradients_agree_with_central_differences() {
        for seed in 0..4 {
            let mut rng = Rng::new(seed, 5);
            let points = (0..14).map(|_| {
                let [x, y, z] = rng.in_ball(1.0);
                [x, y, z, rng.range(0.05, 0.2)]
            });
            let wire = Wire::uniform(Default::default(), seed % 2 == 0, points.collect()).unwrap();
            for (bending, tightness, evenness) in [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.4, 0.2, 0.3)] {
                let elastic = Elastic {
                    bending,
                    cusp_radius: 0.2,
                    tightness,
                    least_radius: 0.15,
                    least_diameters: 1.5,
                    evenness,
                    speed: 0.8,
                };
                let (_, gradient) = terms(&wire, &elastic);
                let (mut off, mut size) = (0.0, 0.0);
                for i in 0..14 {
                    for c in 0..4 {
                        let at = |h: f64| {
                            let mut points = wire.control_points().to_vec();
                            points[i][c] += h;
                            let mut moved = wire.clone();
                            moved.set_control_points(&points).unwrap();
                            terms(&moved, &elastic).0.iter().sum::<f64>()
                        };
                        let numeric = (at(1e-6) - at(-1e-6)) / 2e-6;
                        off += (numeric - gradient[i][c]).powi(2);
                        size += numeric.powi(2);
                    }
                }
                assert!(size > 0.0 && off < 1e-8 * size, "seed {seed}: {:.1e} of {size:.1e}", off.sqrt());
            }
        }
    }

    #[test]
    fn a_straight_line_a_cusp_and_a_standstill_give_finite_gradients() {
        let elastic = Elastic {
            bending: 1.0,
            cusp_radius: 0.01,
            tightness: 1.0,
            least_radius: 0.02,
            least_diameters: 1.5,
            evenness: 1.0,
            speed: 0.03,
        };
        let line =
            |step: f64| Wire::open_uniform((0..8).map(|i| [f64::from(i) * step, 0.0, 0.0, 0.02]).collect()).unwrap();
        let there_and_back: Vec<_> = (0..9).map(|i: i32| [f64::from((4 - i).abs()) * 0.1, 0.0, 0.0, 0.02]).collect();
        for wire in [line(0.1), line(0.0), Wire::open_uniform(there_and_back).unwrap()] {
            let (terms, gradient) = terms(&wire, &elastic);
            assert!(terms.iter().chain(gradient.iter().flatten()).all(|value| value.is_finite()), "{terms:?}");
        }
    }
}
