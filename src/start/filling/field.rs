//! A smooth field of line directions on a surface: which way the curve runs, up to its sign.

use super::Guide;
use super::hierarchy::Level;
use crate::rng::Rng;
use glam::DVec3;

/// Rounds of averaging on each level.
const ROUNDS: usize = 12;
/// Levels up to this size are solved from several random starts, of which the smoothest goes on.
const TRIAL_SIZE: usize = 600;
const TRIALS: usize = 8;
/// How far a direction is turned with the surface between neighbours, 0 to 1.
const TURNING: f64 = 0.8;

/// Unit tangents at the vertices of the finest level, each up to its sign.
pub fn line_field(levels: &[Level], guide: &Guide, seed: u64) -> Vec<DVec3> {
    let wishes = wishes(levels, guide);
    let few = levels.iter().position(|level| level.points.len() <= TRIAL_SIZE).unwrap_or(levels.len() - 1);
    let mut best: Option<(f64, Vec<DVec3>)> = None;
    for trial in 0..TRIALS as u64 {
        let mut rng = Rng::new(seed, 2 * trial + 1);
        let coarsest = &levels[levels.len() - 1];
        let start = coarsest.normals.iter().map(|&normal| tangent(DVec3::from(rng.in_ball(1.0)), normal)).collect();
        let found = descend(levels, &wishes, levels.len() - 1, few, start);
        let roughness = roughness(&levels[few], &wishes[few], &found);
        if best.as_ref().is_none_or(|best| roughness < best.0) {
            best = Some((roughness, found));
        }
    }
    let start = best.map(|best| best.1).unwrap_or_default();
    if few == 0 { start } else { descend(levels, &wishes, few - 1, 0, prolonged(&levels[few - 1], &start)) }
}

/// Smooths on the levels from `from` down to `to`, beginning with `field` on level `from`.
fn descend(levels: &[Level], wishes: &[Vec<DVec3>], from: usize, to: usize, mut field: Vec<DVec3>) -> Vec<DVec3> {
    for depth in (to..=from).rev() {
        if depth < from {
            field = prolonged(&levels[depth], &field);
        }
        for _ in 0..ROUNDS {
            smooth(&levels[depth], &wishes[depth], &mut field);
        }
    }
    field
}

fn prolonged(level: &Level, coarse: &[DVec3]) -> Vec<DVec3> {
    level.parents.iter().zip(&level.normals).map(|(&p, &normal)| tangent(coarse[p as usize], normal)).collect()
}

/// One Gauss-Seidel round.
fn smooth(level: &Level, wishes: &[DVec3], field: &mut [DVec3]) {
    for v in 0..field.len() {
        let own = field[v];
        let mut sum = aligned(wishes[v], own);
        for &(other, weight) in level.ties_of(v) {
            sum += weight * aligned(carried(field[other as usize], level, other as usize, v), own);
        }
        field[v] = tangent_or(sum, level.normals[v], own);
    }
}

/// A direction at `from` as it counts at `to`: for the most part turned with the surface, so that curved surfaces do not
/// force defects, for the rest as it is in space, so that lines rather follow what is long in the shape.
fn carried(direction: DVec3, level: &Level, from: usize, to: usize) -> DVec3 {
    let (m, n) = (level.normals[from], level.normals[to]);
    direction - (m + n) * (TURNING * n.dot(direction) / (1.0 + m.dot(n)).max(0.1))
}

/// Sum over ties of the squared sine between directions, and of what is wished and not kept.
fn roughness(level: &Level, wishes: &[DVec3], field: &[DVec3]) -> f64 {
    let mut sum = 0.0;
    for v in 0..field.len() {
        sum += wishes[v].length() - wishes[v].dot(field[v]).abs();
        for &(other, weight) in level.ties_of(v) {
            let there = carried(field[other as usize], level, other as usize, v);
            sum += weight * (1.0 - field[v].dot(there).powi(2));
        }
    }
    sum
}

/// What the guide asks for on every level: a direction as long as its weight against the neighbours'.
fn wishes(levels: &[Level], guide: &Guide) -> Vec<Vec<DVec3>> {
    let mut all: Vec<Vec<DVec3>> = Vec::with_capacity(levels.len());
    let finest = &levels[0];
    let wish = |v: usize| {
        let (point, normal) = (finest.points[v], finest.normals[v]);
        let Some((direction, weight)) = guide.wish(point.to_array(), normal.to_array()) else { return DVec3::ZERO };
        let direction = DVec3::from(direction);
        let flat = direction - normal * normal.dot(direction);
        let ties: f64 = finest.ties_of(v).iter().map(|tie| tie.1).sum();
        let wish = flat.normalize_or_zero() * weight.clamp(0.0, 100.0) * ties;
        if wish.is_finite() { wish } else { DVec3::ZERO }
    };
    all.push((0..finest.points.len()).map(wish).collect());
    for depth in 1..levels.len() {
        let mut coarse = vec![DVec3::ZERO; levels[depth].points.len()];
        for (&wish, &parent) in all[depth - 1].iter().zip(&levels[depth - 1].parents) {
            let sum = &mut coarse[parent as usize];
            *sum += aligned(wish, *sum);
        }
        all.push(coarse);
    }
    all
}

fn aligned(direction: DVec3, with: DVec3) -> DVec3 {
    if direction.dot(with) < 0.0 { -direction } else { direction }
}

/// The unit vector of `direction` laid into the plane across `normal`; any if it stands on it.
pub fn tangent(direction: DVec3, normal: DVec3) -> DVec3 {
    tangent_or(direction, normal, normal.any_orthonormal_vector())
}

fn tangent_or(direction: DVec3, normal: DVec3, otherwise: DVec3) -> DVec3 {
    let flat = direction - normal * normal.dot(direction);
    if flat.length_squared() > 1e-12 * direction.length_squared() { flat.normalize_or(otherwise) } else { otherwise }
}

#[cfg(test)]
mod tests {
    use super::super::hierarchy::levels;
    use super::super::refined::RefinedMesh;
    use super::*;
    use crate::mesh::Shape;

    fn alignment(guide: &Guide) -> f64 {
        let surface = RefinedMesh::new(&Shape::Vase.mesh(), 0.1).unwrap();
        let field = line_field(&levels(&surface), guide, 1);
        let up = |v: usize| DVec3::Y.reject_from_normalized(surface.normals[v]);
        let sum = |of: &dyn Fn(usize) -> f64| (0..field.len()).map(of).sum::<f64>();
        for (direction, normal) in field.iter().zip(&surface.normals) {
            assert!((direction.length() - 1.0).abs() < 1e-9 && direction.dot(*normal).abs() < 1e-6);
        }
        sum(&|v| field[v].dot(up(v)).abs()) / sum(&|v| up(v).length())
    }

    #[test]
    fn lines_follow_their_guide() {
        assert!(alignment(&Guide::Along([0.0, 2.0, 0.0])) > 0.9);
        assert!(alignment(&Guide::Across([0.0, 2.0, 0.0])) < 0.15);
        assert!(alignment(&Guide::Custom(Box::new(|_, _| Some(([0.0, 1.0, 0.0], 1.0))))) > 0.9);
        let broken = Guide::Custom(Box::new(|_, _| Some(([f64::NAN; 3], f64::INFINITY))));
        assert_eq!(alignment(&broken), alignment(&Guide::Smooth), "what is not a number is not a wish");
    }

    #[test]
    fn a_flat_sheet_gets_straight_lines() {
        let surface = RefinedMesh::new(&super::super::testing::sheet(20), 0.05).unwrap();
        let field = line_field(&levels(&surface), &Guide::Smooth, 4);
        assert!(field.iter().all(|direction| direction.dot(field[0]).abs() > 0.999));
    }
}
