//! The closed lines on which a function at the vertices of a surface is zero.

use super::refined::{NONE, RefinedMesh};
use super::strand::{Node, Strand};
use crate::geometry::DisjointSets;

/// Lines between vertices where `values` are positive and where not. Every line is closed if no positive vertex lies on
/// the rim; the others are left out.
pub fn zero_lines(surface: &RefinedMesh, values: &[f64]) -> Vec<Strand> {
    let positive = |v: u32| values[v as usize] > 0.0;
    let is_cut = |edge: u32| {
        let [a, b] = surface.edges[edge as usize].ends;
        positive(a) != positive(b)
    };
    let mut seen = vec![false; surface.edges.len()];
    let mut lines = Vec::new();
    for start in 0..surface.edges.len() as u32 {
        if seen[start as usize] || !is_cut(start) {
            continue;
        }
        // A triangle has two cut edges or none, so the way on is never in doubt.
        let (mut line, mut edge, mut face) = (Vec::new(), start, surface.edges[start as usize].faces[0]);
        let closed = loop {
            seen[edge as usize] = true;
            let [a, b] = surface.edges[edge as usize].ends;
            let (va, vb) = (values[a as usize], values[b as usize]);
            let t = if va == vb { 0.5 } else { (va / (va - vb)).clamp(0.02, 0.98) };
            let (a, b) = (a as usize, b as usize);
            line.push(Node {
                point: surface.points[a].lerp(surface.points[b], t),
                normal: surface.normals[a].lerp(surface.normals[b], t).normalize_or(surface.normals[a]),
                triangle: face,
            });
            let Some(&on) = surface.edges_of[face as usize].iter().find(|&&e| e != edge && is_cut(e)) else {
                break false;
            };
            let faces = surface.edges[on as usize].faces;
            let beyond = if faces[0] == face { faces[1] } else { faces[0] };
            if on == start {
                break true;
            }
            if beyond == NONE || seen[on as usize] {
                break false;
            }
            (edge, face) = (on, beyond);
        };
        if closed && line.len() >= 3 {
            lines.push(line);
        }
    }
    lines
}

/// Gives every part on which none or all of the values are positive a line that goes round it: parts with a rim half way
/// in from it (`rim` holds distances to it), others where half the range of the values lies.
pub fn cross_zero(surface: &RefinedMesh, values: &mut [f64], rim: &[f64]) {
    let everywhere = ranges(surface, values);
    let alike = |v: usize| {
        let (low, high) = everywhere[surface.part_of[v] as usize];
        low > 0.0 || high <= 0.0
    };
    let levels: Vec<f64> = (0..values.len()).map(|v| if rim[v].is_finite() { rim[v] } else { values[v] }).collect();
    let ranges = ranges(surface, &levels);
    for v in (0..values.len()).filter(|&v| alike(v)) {
        let (low, high) = ranges[surface.part_of[v] as usize];
        values[v] = levels[v] - 0.5 * (low + high);
    }
}

/// Least and greatest value on every part.
fn ranges(surface: &RefinedMesh, values: &[f64]) -> Vec<(f64, f64)> {
    let mut ranges = vec![(f64::INFINITY, f64::NEG_INFINITY); surface.parts];
    for (&value, &part) in values.iter().zip(&surface.part_of) {
        let range = &mut ranges[part as usize];
        *range = (range.0.min(value), range.1.max(value));
    }
    ranges
}

/// Turns the sign of regions in which no value goes beyond `least`: there lines would run closer than they should.
pub fn without_slivers(surface: &RefinedMesh, values: &mut [f64], least: f64) {
    for sign in [1.0, -1.0] {
        let mut regions = DisjointSets::new(values.len());
        let is_in = |v: u32, values: &[f64]| (values[v as usize] > 0.0) == (sign > 0.0);
        for edge in &surface.edges {
            if edge.ends.iter().all(|&v| is_in(v, values)) {
                regions.join(edge.ends[0] as usize, edge.ends[1] as usize);
            }
        }
        let mut peaks = vec![0.0f64; values.len()];
        for v in 0..values.len() {
            let region = regions.root(v);
            peaks[region] = peaks[region].max(sign * values[v]);
        }
        for v in 0..values.len() as u32 {
            if is_in(v, values) && peaks[regions.root(v as usize)] < least {
                values[v as usize] *= -0.1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::strand::length;
    use super::super::testing::sheet;
    use super::*;
    use crate::mesh::Shape;
    use std::f64::consts::PI;

    #[test]
    fn the_equator_of_a_sphere_is_one_line() {
        let surface = RefinedMesh::new(&Shape::Sphere.mesh(), 0.05).unwrap();
        let values: Vec<f64> = surface.points.iter().map(|p| p.y + 0.3 * p.x).collect();
        let lines = zero_lines(&surface, &values);
        assert_eq!(lines.len(), 1);
        assert!((length(&lines[0]) - 2.0 * PI).abs() < 0.01);
        for node in &lines[0] {
            assert!((node.point.y + 0.3 * node.point.x).abs() < 0.01);
            assert!(surface.distance_squared(node.point, node.triangle) < 1e-20);
        }
    }

    #[test]
    fn lines_that_leave_by_the_rim_are_left_out() {
        let surface = RefinedMesh::new(&sheet(10), 0.1).unwrap();
        let open: Vec<f64> = surface.points.iter().map(|p| p.x - 0.011).collect();
        assert!(zero_lines(&surface, &open).is_empty());
        let closed: Vec<f64> = surface.points.iter().map(|p| 0.3 - p.length()).collect();
        assert_eq!(zero_lines(&surface, &closed).len(), 1);
    }

    #[test]
    fn slivers_go_and_bands_stay() {
        let surface = RefinedMesh::new(&sheet(50), 0.02).unwrap();
        let bands = |height: f64| surface.points.iter().map(|p| height - (20.0 * p.length() - 6.0).powi(2)).collect();
        for (height, left) in [(0.4, 0), (2.0, 2)] {
            let mut values: Vec<f64> = bands(height);
            without_slivers(&surface, &mut values, 0.5);
            assert_eq!(zero_lines(&surface, &values).len(), left, "a ring of height {height}");
        }
    }

    #[test]
    fn every_part_gets_a_line() {
        for surface in
            [RefinedMesh::new(&sheet(30), 0.05), RefinedMesh::new(&Shape::Torus.mesh(), 0.05)].map(|s| s.unwrap())
        {
            let mut values: Vec<f64> = surface.points.iter().map(|p| 3.0 + p.x).collect();
            cross_zero(&surface, &mut values, &surface.rim_distances());
            assert!(!zero_lines(&surface, &values).is_empty());
        }
    }
}
