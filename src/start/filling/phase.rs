//! Stripes across a field of lines: a phase whose cosine is zero on a line every spacing.

use super::hierarchy::Level;
use crate::rng::Rng;
use glam::{DVec2, DVec3};

/// Rounds of averaging on each level.
const ROUNDS: usize = 40;

/// `cos` of the phase at the vertices of the finest level, for lines along `field` every `spacing`. The phase grows by a
/// turn in two spacings; it is known up to its sign, as the field is, and the cosine does not depend on that.
pub fn waves(levels: &[Level], field: &[DVec3], spacing: f64, seed: u64) -> Vec<f64> {
    let fields = across(levels, field);
    let turn = std::f64::consts::PI / spacing;
    let mut rng = Rng::new(seed, 77);
    let mut phases: Vec<DVec2> = Vec::new();
    for depth in (0..levels.len()).rev() {
        let (level, across) = (&levels[depth], &fields[depth]);
        phases = if depth + 1 == levels.len() {
            (0..across.len()).map(|_| DVec2::from_angle(rng.range(0.0, std::f64::consts::TAU))).collect()
        } else {
            let coarse = (&levels[depth + 1].points, &fields[depth + 1]);
            let from_parent = |v: usize| {
                let p = level.parents[v] as usize;
                carried(phases[p], step(coarse.1[p], across[v], level.points[v] - coarse.0[p], turn))
            };
            (0..across.len()).map(from_parent).collect()
        };
        smooth(level, across, turn, &mut phases);
    }
    phases.iter().map(|phase| phase.x).collect()
}

/// Across the lines, on every level.
fn across(levels: &[Level], field: &[DVec3]) -> Vec<Vec<DVec3>> {
    let mut fields = vec![(0..field.len()).map(|v| levels[0].normals[v].cross(field[v])).collect::<Vec<_>>()];
    for depth in 1..levels.len() {
        let level = &levels[depth];
        let mut sums = vec![DVec3::ZERO; level.points.len()];
        for (v, &parent) in levels[depth - 1].parents.iter().enumerate() {
            let sum = &mut sums[parent as usize];
            let direction = levels[depth - 1].sizes[v] * fields[depth - 1][v];
            *sum += if direction.dot(*sum) < 0.0 { -direction } else { direction };
        }
        let tangents = sums.iter().zip(&level.normals).map(|(&sum, &normal)| super::field::tangent(sum, normal));
        fields.push(tangents.collect());
    }
    fields
}

/// From a vertex whose phase grows along `from` to one where it grows along `to`, `edge` away: the turn as a unit number
/// and whether the phase changes its sign.
fn step(from: DVec3, to: DVec3, edge: DVec3, turn: f64) -> (DVec2, bool) {
    let flip = from.dot(to) < 0.0;
    let mean = 0.5 * (to + if flip { -from } else { from });
    // On an arc the chord times the half angle over its sine is the way along it; the mean is as long as its cosine.
    let cosine = mean.length().max(0.5);
    let arc = (1.0 + (1.0 - cosine * cosine) / 6.0) / cosine;
    (DVec2::from_angle(turn * arc * mean.dot(edge)), flip)
}

fn carried(phase: DVec2, (turn, flip): (DVec2, bool)) -> DVec2 {
    turn.rotate(if flip { DVec2::new(phase.x, -phase.y) } else { phase })
}

/// Gauss-Seidel rounds: every phase becomes the mean of what its neighbours expect of it.
fn smooth(level: &Level, across: &[DVec3], turn: f64, phases: &mut [DVec2]) {
    let mut steps = Vec::with_capacity(level.ties.len());
    for v in 0..across.len() {
        for &(other, weight) in level.ties_of(v) {
            let o = other as usize;
            let (by, flip) = step(across[o], across[v], level.points[v] - level.points[o], turn);
            steps.push((weight * by, flip));
        }
    }
    for _ in 0..ROUNDS {
        let mut at = 0;
        for v in 0..across.len() {
            let mut sum = DVec2::ZERO;
            for &(other, _) in level.ties_of(v) {
                sum += carried(phases[other as usize], steps[at]);
                at += 1;
            }
            phases[v] = sum.normalize_or(phases[v]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::contour::zero_lines;
    use super::super::hierarchy::levels;
    use super::super::refined::RefinedMesh;
    use super::super::strand::length;
    use super::super::testing::sheet;
    use super::*;
    use crate::mesh::Shape;

    #[test]
    fn on_a_flat_sheet_the_wave_is_a_plane_one() {
        let surface = RefinedMesh::new(&sheet(20), 0.02).unwrap();
        let levels = levels(&surface);
        let values = waves(&levels, &vec![DVec3::X; surface.points.len()], 0.05, 3);
        // cos(k y + p) for one p: its part along cos(k y) and sin(k y) has length 1.
        let k = std::f64::consts::PI / 0.05;
        let part = |wave: &dyn Fn(f64) -> f64| {
            let products = values.iter().zip(&surface.points).map(|(value, point)| value * wave(k * point.y));
            2.0 * products.sum::<f64>() / values.len() as f64
        };
        let found = part(&f64::cos).hypot(part(&f64::sin));
        assert!(found > 0.98, "{found}");
        let stretched = 1.2 * k;
        let off = |wave: &dyn Fn(f64) -> f64| {
            let products = values.iter().zip(&surface.points).map(|(value, point)| value * wave(stretched * point.y));
            2.0 * products.sum::<f64>() / values.len() as f64
        };
        assert!(off(&f64::cos).hypot(off(&f64::sin)) < 0.3, "another wave is told apart");
    }

    #[test]
    fn zero_lines_on_a_sphere_are_as_long_as_the_spacing_asks() {
        let surface = RefinedMesh::new(&Shape::Sphere.mesh(), 0.05).unwrap();
        let rings =
            surface.normals.iter().map(|n| super::super::field::tangent(n.cross(DVec3::Y), *n)).collect::<Vec<_>>();
        let values = waves(&levels(&surface), &rings, 0.1, 5);
        let lines = zero_lines(&surface, &values);
        let whole: f64 = lines.iter().map(|line| length(line)).sum();
        assert!((surface.area() / whole / 0.1 - 1.0).abs() < 0.03, "{}", surface.area() / whole);
    }
}
