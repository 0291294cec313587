//! One walk along all lines on the solid they came from: each on its front, the sparser ones on its back, round the rim
//! from one to the other.

use super::circuit::circuit;
use super::{Lines, around};
use crate::picture::Mask;
use crate::start::drawings::trail::smooth;
use crate::start::{Path, Solid};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// What a link between lines costs on ground, times its length in the object.
const GROUND_PRICE: f32 = 6.0;
/// What a link on the back costs where it shows from the front, times its length behind ink.
const SHOWN_PRICE: f32 = 30.0;
/// Branches shorter than this are stairs of the pixels, px.
const STUB_PX: usize = 5;
/// Standard deviation of the smoothing along the walk, px at 256.
const SMOOTHING_PX: f64 = 1.5;

impl Lines {
    /// One closed walk along all lines on the solid they came from, each on its front and those of the back on its back.
    /// The rim, where both meet, is the only way from one to the other. From the front that shows the lines alone, from
    /// elsewhere the solid. The back and links between lines take `thin_world`, so that the front stands out from what is
    /// behind it.
    pub fn walk(&self, solid: &Solid, thin_world: f64) -> Path {
        let side = self.side;
        let inside = |i: usize| self.object.data[i] > 0.5;
        let walked = (0..self.on.data.len()).map(|i| self.on.data[i] || self.sections.data[i]).collect();
        let walked = Mask { data: walked, ..self.on };
        let front = joined(&walked, |i| if inside(i) { 1.0 } else { GROUND_PRICE });
        let ink = front.distance_px().data;
        let hidden = |i: usize| ink[i] < self.half_width_px[i].max(1.0);
        let back = joined(&self.back, |i| if hidden(i) { 1.0 } else { SHOWN_PRICE });
        let rim = Mask { data: (0..ink.len()).map(|i| self.rim.data[i] && front.data[i]).collect(), ..front };
        let nodes = Nodes::new(&front, &back, &rim);

        let world_per_px = solid.height_world() / side as f64;
        let point = |&node: &usize| {
            let (i, behind) = nodes.pixels[node];
            let centred = |p: usize| (p as f64 + 0.5 - 0.5 * side as f64) * world_per_px;
            let (x, y) = (centred(i % side), -centred(i / side));
            let full = 2.0 * world_per_px * f64::from(self.half_width_px[i]);
            let width = if behind || !self.on.data[i] { thin_world.min(full.max(world_per_px)) } else { full };
            let [rear, near] = solid.depths(x, y);
            // Round wire that touches the surface from inside.
            let inset = (0.5 * width).min(0.5 * (near - rear));
            let z = match (rim.data[i], behind) {
                (true, _) => 0.5 * (near + rear),
                (false, true) => rear + inset,
                (false, false) => near - inset,
            };
            [x, y, z, width]
        };
        let mut points: Vec<[f64; 4]> = circuit(&nodes.places, &nodes.edges).iter().map(point).collect();
        smooth(&mut points, SMOOTHING_PX * side as f64 / 256.0);
        Path { points, closed: false }
    }
}

/// Pixels of front and back with the steps between them; those of the rim are one.
struct Nodes {
    /// Each node's pixel and whether it lies behind.
    pixels: Vec<(usize, bool)>,
    places: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
}

impl Nodes {
    fn new(front: &Mask, back: &Mask, rim: &Mask) -> Nodes {
        let side = front.width;
        let mut nodes = Nodes { pixels: Vec::new(), places: Vec::new(), edges: Vec::new() };
        let mut known = vec![usize::MAX; front.data.len()];
        for (layer, behind) in [(front, false), (back, true)] {
            for i in 0..layer.data.len() {
                let shared = behind && rim.data[i];
                if layer.data[i] && !shared {
                    known[i] = nodes.pixels.len();
                    nodes.pixels.push((i, behind));
                    nodes.places.push([(i % side) as f64, (i / side) as f64]);
                } else if !shared {
                    known[i] = usize::MAX;
                }
            }
            for i in (0..layer.data.len()).filter(|&i| layer.data[i]) {
                for (n, length) in around(i, side).filter(|&(n, _)| n > i && layer.data[n]) {
                    // A diagonal is a step only where there is no way round the corner.
                    let corners = [i / side * side + n % side, n / side * side + i % side];
                    let new = length == 1.0 || !corners.iter().any(|&corner| layer.data[corner]);
                    if new && !(behind && rim.data[i] && rim.data[n]) {
                        nodes.edges.push([known[i], known[n]]);
                    }
                }
            }
        }
        nodes
    }
}

/// The lines with links that join them, each at its nearest place to those joined before (Prim 1957), and without stubs.
/// `price` is what a link costs at a pixel, times its length.
fn joined(on: &Mask, price: impl Fn(usize) -> f32) -> Mask {
    let side = on.width;
    let parts = on.components();
    let mut pixels: Vec<Vec<usize>> = vec![Vec::new(); parts.sizes.len()];
    for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
        pixels[part as usize - 1].push(i);
    }
    let largest = (0..pixels.len()).max_by_key(|&k| (pixels[k].len(), Reverse(k)));
    let mut joined = Mask::new(side, side);
    let mut cost = vec![f32::INFINITY; joined.data.len()];
    let mut parent = vec![0usize; joined.data.len()];
    let mut queue = BinaryHeap::new();
    let mut new: Vec<usize> = largest.map_or(Vec::new(), |k| pixels[k].clone());
    loop {
        for i in new.drain(..) {
            joined.data[i] = true;
            cost[i] = 0.0;
            queue.push((Reverse(0u32), Reverse(i)));
        }
        let Some((Reverse(bits), Reverse(i))) = queue.pop() else { break };
        if f32::from_bits(bits) > cost[i] {
            continue;
        }
        if on.data[i] && !joined.data[i] {
            let mut link = parent[i];
            while !joined.data[link] {
                new.push(link);
                link = parent[link];
            }
            new.extend(&pixels[parts.labels[i] as usize - 1]);
            continue;
        }
        for (n, length) in around(i, side) {
            let to = cost[i] + length * price(n);
            if to < cost[n] {
                cost[n] = to;
                parent[n] = i;
                // Positive floats order as their bits do.
                queue.push((Reverse(to.to_bits()), Reverse(n)));
            }
        }
    }
    let mut lines = joined.thin();
    cut_stubs(&mut lines);
    lines
}

/// Takes away short branches that end freely.
fn cut_stubs(lines: &mut Mask) {
    let side = lines.width;
    let beside = |lines: &Mask, i: usize| around(i, side).filter(|&(n, _)| lines.data[n]).map(|(n, _)| n).collect();
    for end in 0..lines.data.len() {
        let (mut branch, mut here) = (Vec::new(), end);
        while lines.data[here] && branch.len() < STUB_PX {
            let next: Vec<usize> = beside(lines, here);
            let onward: Vec<usize> = next.into_iter().filter(|n| !branch.contains(n)).collect();
            match onward[..] {
                [only] => {
                    branch.push(here);
                    here = only;
                }
                // A place where lines meet: the branch was short.
                [_, _, ..] if !branch.is_empty() => {
                    branch.iter().for_each(|&i| lines.data[i] = false);
                    break;
                }
                _ => break,
            }
        }
    }
}
