//! Lines joined across gaps and junctions where one goes on as the other.

use super::line::{is_closed, length};
use crate::sorting::sort_by;

/// Rounds of joining; in the first only small gaps close.
const ROUNDS: usize = 3;
const FIRST: f32 = 0.4;
/// Greatest bend at a gap, as a cosine (40°).
const STRAIGHT: f32 = 0.766;
/// Points that a line's direction at its end is taken from.
const END: usize = 7;

/// An end of a line: which line, and whether its last point.
#[derive(Clone, Copy, PartialEq, Eq)]
struct End {
    line: usize,
    last: bool,
}

/// Joins ends at most `gap_px` apart, best continuations first.
pub fn joined(mut lines: Vec<Vec<[f32; 2]>>, gap_px: f32) -> Vec<Vec<[f32; 2]>> {
    for round in 0..ROUNDS {
        let gap = if round == 0 { FIRST * gap_px } else { gap_px };
        let ends: Vec<End> = (0..lines.len())
            .filter(|&line| !is_closed(&lines[line]))
            .flat_map(|line| [false, true].map(|last| End { line, last }))
            .collect();
        let places: Vec<([f32; 2], [f32; 2])> = ends.iter().map(|&end| place(&lines, end)).collect();
        let lengths: Vec<f32> = lines.iter().map(|line| length(line)).collect();
        let mut pairs = Vec::new();
        for a in 0..ends.len() {
            for b in a + 1..ends.len() {
                let (from, to) = (places[a].0, places[b].0);
                let v = [to[0] - from[0], to[1] - from[1]];
                let far = v[0].hypot(v[1]);
                if far > gap || ends[a].line == ends[b].line && lengths[ends[a].line] < 25.0 {
                    continue;
                }
                let dot = |p: [f32; 2], q: [f32; 2]| p[0] * q[0] + p[1] * q[1];
                let (along_a, along_b) = (places[a].1, places[b].1);
                let opposite = -dot(along_a, along_b);
                let [on_a, on_b] = if far > 3.0 { [dot(along_a, v) / far, -dot(along_b, v) / far] } else { [1.0, 1.0] };
                let shorter = lengths[ends[a].line].min(lengths[ends[b].line]);
                if opposite < STRAIGHT || on_a.min(on_b) < STRAIGHT || far > (0.8 * shorter).max(4.0) {
                    continue;
                }
                pairs.push((far + 8.0 * (1.0 - opposite) + 6.0 * (2.0 - on_a - on_b), a, b));
            }
        }
        sort_by(&mut pairs, |p, q| p.0.total_cmp(&q.0).then((p.1, p.2).cmp(&(q.1, q.2))));
        let mut partner = vec![None; 2 * lines.len()];
        let slot = |end: End| 2 * end.line + usize::from(end.last);
        let mut any = false;
        for (_, a, b) in pairs {
            let (a, b) = (ends[a], ends[b]);
            if partner[slot(a)].is_none() && partner[slot(b)].is_none() {
                partner[slot(a)] = Some(b);
                partner[slot(b)] = Some(a);
                any = true;
            }
        }
        if !any {
            break;
        }
        lines = linked(&lines, &partner);
    }
    lines
}

/// Where an end is and which way it points, outward.
fn place(lines: &[Vec<[f32; 2]>], end: End) -> ([f32; 2], [f32; 2]) {
    let line = &lines[end.line];
    let back = END.min(line.len() - 1);
    let (tip, before) =
        if end.last { (line[line.len() - 1], line[line.len() - 1 - back]) } else { (line[0], line[back]) };
    let v = [tip[0] - before[0], tip[1] - before[1]];
    let size = v[0].hypot(v[1]).max(1e-6);
    (tip, v.map(|c| c / size))
}

/// The lines in chains of partners.
fn linked(lines: &[Vec<[f32; 2]>], partner: &[Option<End>]) -> Vec<Vec<[f32; 2]>> {
    let mut done = vec![false; lines.len()];
    let mut out = Vec::new();
    for seed in 0..lines.len() {
        if done[seed] {
            continue;
        }
        // Back to where the chain begins, or once round.
        let mut first = End { line: seed, last: false };
        let mut round = false;
        while let Some(End { line, last }) = partner[2 * first.line + usize::from(first.last)] {
            first = End { line, last: !last };
            if line == seed {
                round = true;
                first = End { line: seed, last: false };
                break;
            }
        }
        let mut chain: Vec<[f32; 2]> = Vec::new();
        let mut entry = first;
        loop {
            done[entry.line] = true;
            if entry.last {
                chain.extend(lines[entry.line].iter().rev());
            } else {
                chain.extend(&lines[entry.line]);
            }
            let exit = End { line: entry.line, last: !entry.last };
            match partner[2 * exit.line + usize::from(exit.last)] {
                Some(next) if !done[next.line] => entry = next,
                _ => break,
            }
        }
        if round {
            chain.push(chain[0]);
        }
        out.push(chain);
    }
    out
}
