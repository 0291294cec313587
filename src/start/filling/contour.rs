//! The closed lines on which a function at the vertices of a surface is zero.

use super::strand::{Node, Strand};
use super::surface::{NONE, Surface};

/// Lines between vertices where `values` are positive and where not. Every line is closed if no positive vertex lies on
/// the rim; the others are left out.
pub fn zero_lines(surface: &Surface, values: &[f64]) -> Vec<Strand> {
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
            let Some(&on) = surface.edges_of[face as usize].iter().find(|&&e| e != edge && is_cut(e)) else { break false };
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
