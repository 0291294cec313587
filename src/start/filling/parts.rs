//! Lines that no join on the surface reaches, joined by two links side by side through space.

use super::strand::{Node, Strand, Strands};

/// Nodes among which the nearest pairs of lines are looked for: their square is the work.
const MOST_NODES: usize = 4_000;

/// One closed line through all of `lines`, linked where they are nearest as a spanning tree (Prim).
pub fn joined(lines: &[Strand], spacing: f64) -> Vec<Node> {
    let mut strands = Strands::new(lines);
    let stride = strands.nodes.len() / MOST_NODES + 1;
    let mut firsts = vec![0; lines.len()];
    for k in 1..lines.len() {
        firsts[k] = firsts[k - 1] + lines[k - 1].len();
    }
    // Every line's first node and every so many after it; per line not joined yet its nearest pair with the joined ones.
    let some = |line: usize| (firsts[line]..firsts[line] + lines[line].len()).step_by(stride);
    let mut nearest = vec![(f64::INFINITY, 0, 0); lines.len()];
    let mut linked = vec![false; strands.nodes.len()];
    let mut waiting: Vec<usize> = (1..lines.len()).collect();
    let mut latest = 0;
    while !waiting.is_empty() {
        for &line in &waiting {
            for b in some(line) {
                for a in some(latest) {
                    let apart = strands.nodes[a].point.distance_squared(strands.nodes[b].point);
                    if apart < nearest[line].0 {
                        nearest[line] = (apart, a, b);
                    }
                }
            }
        }
        let place = |i: &usize| nearest[waiting[*i]].0;
        let at = (0..waiting.len()).min_by(|i, j| place(i).total_cmp(&place(j))).unwrap_or(0);
        latest = waiting.swap_remove(at);
        let (_, a, b) = nearest[latest];
        link(&mut strands, a as u32, b as u32, &mut linked, spacing);
    }
    strands.walked(&vec![false; strands.nodes.len()]).into_iter().next().unwrap_or_default()
}

/// Opens the segments behind `a` and beside `b` and joins their ends.
fn link(strands: &mut Strands, mut a: u32, b: u32, linked: &mut [bool], spacing: f64) {
    // Not where a link leaves already, if there is another place near.
    for _ in 0..(4.0 / spacing) as usize {
        let next = strands.next[a as usize];
        if !linked[a as usize] && !linked[next as usize] {
            break;
        }
        a = next;
    }
    let beyond = strands.next[a as usize];
    let apart = |i: u32| strands.nodes[i as usize].point.distance_squared(strands.nodes[beyond as usize].point);
    let (ahead, behind) = (strands.next[b as usize], strands.previous[b as usize]);
    let is_ahead = apart(ahead) < apart(behind);
    let last = if is_ahead { ahead } else { behind };
    strands.join([a, beyond], [b, last], is_ahead);
    for i in [a, beyond, b, last] {
        linked[i as usize] = true;
    }
}

#[cfg(test)]
mod tests {
    use super::super::refined::RefinedMesh;
    use super::super::strand::length;
    use super::super::testing::{circle, sheet};
    use super::*;

    #[test]
    fn far_rings_are_linked_at_their_nearest_points() {
        let surface = RefinedMesh::new(&sheet(30), 0.05).unwrap();
        let rings = [[-0.35, -0.3], [0.35, -0.3], [0.0, 0.3]].map(|centre| circle(&surface, centre, 0.1));
        let line = joined(&rings, 0.05);
        assert_eq!(line.len(), 600);
        let rings_alone: f64 = rings.iter().map(|ring| length(ring)).sum();
        let links = 2.0 * (0.6f64.hypot(0.35) - 0.2) + 2.0 * (0.6f64.hypot(0.35) - 0.2).min(0.5);
        assert!((length(&line) - rings_alone - links).abs() < 0.05, "{} more", length(&line) - rings_alone);
        assert_eq!(joined(&rings[..1], 0.05), rings[0]);
        assert!(joined(&[], 0.05).is_empty());
    }
}
