//! The visible outline of a range of nodes: the sides and drawn end lines of their pieces, their vertex polygons.

use super::cells::{Cells, Near, overlap};
use super::extremes::{least, most};
use super::hidden::{Edge, visible_parts};
use super::joints::{Joint, Kind};
use super::pieces::{NONE, Node, Piece};
use super::shapes::{Circles, NegatedBox, Shapes, hull, polygon_order, quad_order};
use super::walk::{Stretch, SubEdge, clip, walk};

/// Consecutive pieces look up their hiders together as long as their boxes fit in this many pixels.
const GROUP_PX: f32 = 4.0;
/// Edges of larger pieces (in pixels) look up their hiders stretch by stretch.
pub(super) const STRETCH_PX: f32 = 16.0;
/// Shorter edges (in pixels) are nothing.
pub(super) const SHORTEST_EDGE_PX: f32 = 1e-6;

/// Everything a pass knows before its outline, shared by all chunks.
pub(super) struct Scene<'a> {
    pub width: usize,
    pub height: usize,
    pub nodes: &'a [Node],
    pub pieces: &'a [Piece],
    pub joints: &'a [Joint],
    pub shapes: &'a Shapes,
    pub circles: &'a Circles,
    pub cells: &'a Cells,
}

/// A run of sub-edges with one outward normal: the visible part of one edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    /// The edge moves with this node and, by `u`, with the next.
    pub node: u32,
    pub normal: [f32; 2],
    /// How far the edge moves out when the radius grows.
    pub radius_weight: f32,
    /// Change of `u` along the outline, per pixel; 0 where the edge moves with its node alone.
    pub u_per_px: f32,
    /// End of its sub-edges; they begin where the run before ends.
    pub end: u32,
}

/// The visible outline of one chunk of nodes, with buffers that live across passes.
#[derive(Debug, Default)]
pub(super) struct Outline {
    pub runs: Vec<Run>,
    pub sub_edges: Vec<SubEdge>,
    /// Adjoint of the start and end disc of each of the chunk's pieces.
    pub d_pieces: Vec<[[f32; 3]; 2]>,
    near: Near,
    /// The box of the piece in hand, if `near` holds what touches it; else each edge looks for itself.
    near_box: Option<NegatedBox>,
    /// What touches that box, without `skipped`.
    candidates: Vec<u32>,
    skipped: Option<[u32; 3]>,
    hidden: Vec<[f32; 2]>,
    visible: Vec<[f32; 2]>,
}

/// An edge to trace, and how it moves, see [`Run`]; `u` at its start and end.
#[derive(Clone, Copy)]
struct Moving {
    edge: Edge,
    /// Orders of the hiders that do not apply: its own polygon and neighbours it shares an end point with.
    skip: [u32; 3],
    node: usize,
    normal: [f32; 2],
    radius_weight: f32,
    u: [f32; 2],
}

impl Outline {
    /// Traces nodes `range` and the pieces that begin there.
    pub fn trace(&mut self, scene: &Scene, range: std::ops::Range<usize>) {
        self.runs.clear();
        self.sub_edges.clear();
        let picture = [0.0, 0.0, -(scene.width as f32), -(scene.height as f32)];
        let boxes = &scene.shapes.boxes;
        let bounds = |k: usize| hull(boxes[polygon_order(k) as usize], boxes[quad_order(k) as usize]);
        let extent = |b: NegatedBox| most(-b[2] - b[0], -b[3] - b[1]);
        let mut grouped = range.start;
        for k in range.clone() {
            let own = bounds(k);
            if !overlap(own, picture) {
                continue;
            }
            let near = extent(own) <= 2.0 * STRETCH_PX;
            if near && k >= grouped {
                let mut group = own;
                grouped = k + 1;
                while grouped < range.end {
                    let larger = hull(group, bounds(grouped));
                    if extent(larger) > GROUP_PX {
                        break;
                    }
                    (group, grouped) = (larger, grouped + 1);
                }
                scene.cells.gather(group, &mut self.near);
            }
            self.near_box = near.then_some(own);
            self.skipped = None;
            self.trace_polygon(scene, k);
            if scene.pieces[k].has_sides {
                self.trace_end_lines(scene, k);
                self.trace_sides(scene, k);
            }
        }
    }

    /// Sums up what an adjoint picture does to the pieces of `range`, which must be what was traced last.
    pub fn pull_back(&mut self, d_coverage: &[f32], range: std::ops::Range<usize>) {
        self.d_pieces.clear();
        self.d_pieces.resize(range.len(), [[0.0; 3]; 2]);
        let mut first = 0;
        for run in &self.runs {
            let (mut sum, mut moment) = (0.0f32, 0.0f32);
            for edge in &self.sub_edges[first..run.end as usize] {
                let weight = d_coverage[edge.pixel as usize] * edge.length_px;
                sum += weight;
                moment += weight * edge.u;
            }
            first = run.end as usize;
            let [start, end] = &mut self.d_pieces[run.node as usize - range.start];
            let speed = [run.normal[0], run.normal[1], run.radius_weight];
            for c in 0..3 {
                start[c] += (sum - moment) * speed[c];
                end[c] += moment * speed[c];
            }
        }
    }

    /// The length of border `x = 0` the strokes cover, row by row in integer steps, added to `sums`.
    pub fn trace_left_border(&mut self, scene: &Scene, sums: &mut [i32]) {
        sums.fill(0);
        self.sub_edges.clear();
        let height = scene.height as f32;
        let mut y = 0.0;
        while y < height {
            let step = (height - y).min(8.0);
            let edge = Edge { origin: [0.0; 2], start: [0.0, y], step: [0.0, step], order: NONE };
            let query = [0.0, y, 0.0, -y - step];
            scene.cells.gather(query, &mut self.near);
            self.near.select(query, [NONE; 3], &mut self.candidates);
            if !self.candidates.is_empty() {
                let (hidden, visible) = (&mut self.hidden, &mut self.visible);
                visible_parts(&edge, scene.shapes, scene.circles, &mut self.candidates, hidden, visible);
            } else {
                self.visible.clear();
                self.visible.push([0.0, 1.0]);
            }
            // What is hidden lies between the visible parts.
            let mut from = 0.0;
            for i in 0..=self.visible.len() {
                let [to, next] = self.visible.get(i).copied().unwrap_or([1.0, 1.0]);
                if to > from {
                    let part = edge.part(from, to);
                    let stretch = Stretch { start: part.place(), step: part.step, u: [0.0; 2] };
                    walk(1, scene.height, &stretch, &mut self.sub_edges);
                }
                from = next;
            }
            y += step;
        }
        for edge in &self.sub_edges {
            sums[edge.pixel as usize] += edge.area;
        }
        self.sub_edges.clear();
    }

    fn trace_sides(&mut self, scene: &Scene, k: usize) {
        let (node, piece) = (&scene.nodes[k], &scene.pieces[k]);
        let (start, end) = (&scene.joints[k], &scene.joints[node.next as usize]);
        let origin = node.center;
        let next = scene.nodes[node.next as usize].center;
        let per_px = 1.0 / (piece.length * piece.cosine);
        for (i, side) in [1.0f32, -1.0].into_iter().enumerate() {
            let order = quad_order(k);
            let neighbour = |joint: &Joint, piece: u32| if joint.shared[i] { quad_order(piece as usize) } else { NONE };
            let skip = [order, neighbour(start, node.previous), neighbour(end, node.next)];
            let [x, y] = end.before[i];
            let (mut from, mut to) = (start.after[i], [next[0] - origin[0] + x, next[1] - origin[1] + y]);
            let mut u = [-start.extension[i] * per_px, 1.0 + end.extension[i] * per_px];
            if i == 1 {
                // Counter-clockwise round the piece: this side runs backwards.
                (from, to) = (to, from);
                u.swap(0, 1);
            }
            let edge = Edge { origin, start: from, step: [to[0] - from[0], to[1] - from[1]], order };
            self.trace_edge(scene, &Moving { edge, skip, node: k, normal: piece.normal(side), radius_weight: 1.0, u });
        }
    }

    /// The end lines of soft joints. They move with their node; that they also turn is left out.
    fn trace_end_lines(&mut self, scene: &Scene, k: usize) {
        let next = scene.nodes[k].next as usize;
        let (start, end) = (&scene.joints[k], &scene.joints[next]);
        let lines =
            [(k, start.kind, start.after[1], start.after[0], 0.0), (next, end.kind, end.before[0], end.before[1], 1.0)];
        for (node, kind, from, to, u) in lines {
            if kind != Kind::Soft {
                continue;
            }
            let step = [to[0] - from[0], to[1] - from[1]];
            let length = (step[0] * step[0] + step[1] * step[1]).sqrt();
            let normal = [-step[1] / length, step[0] / length];
            let order = quad_order(k);
            let (edge, skip) =
                (Edge { origin: scene.nodes[node].center, start: from, step, order }, [order, NONE, NONE]);
            self.trace_edge(scene, &Moving { edge, skip, node: k, normal, radius_weight: 0.0, u: [u; 2] });
        }
    }

    fn trace_polygon(&mut self, scene: &Scene, k: usize) {
        let polygon = scene.shapes.polygons[k];
        if polygon.sides == 0 {
            return;
        }
        let order = polygon_order(k);
        let half = polygon.radius * (std::f32::consts::PI / polygon.sides as f32).tan();
        for &normal in scene.circles.normals(polygon.sides) {
            let [nx, ny] = normal;
            let start = [polygon.radius * nx - half * ny, polygon.radius * ny + half * nx];
            let edge = Edge { origin: polygon.center, start, step: [2.0 * half * ny, -2.0 * half * nx], order };
            let skip = [order, NONE, NONE];
            self.trace_edge(scene, &Moving { edge, skip, node: k, normal, radius_weight: 1.0, u: [0.0; 2] });
        }
    }

    /// Cuts an edge by the picture, by what hides it and by the pixels.
    fn trace_edge(&mut self, scene: &Scene, moving: &Moving) {
        let Moving { edge, skip, u, .. } = moving;
        let [dx, dy] = edge.step;
        if most(dx.abs(), dy.abs()) < SHORTEST_EDGE_PX {
            return;
        }
        let (width, height) = (scene.width as f32, scene.height as f32);
        let Some([from, to]) = clip(edge.place(), edge.step, width, height) else { return };
        let length = (dx * dx + dy * dy).sqrt();
        let parts = match self.near_box {
            Some(_) => 1,
            None => ((to - from) * length / STRETCH_PX).ceil().max(1.0) as usize,
        };
        let first = self.sub_edges.len();
        for i in 0..parts {
            let at = |i: usize| from + (to - from) * (i as f32 / parts as f32);
            let (low, high) = (at(i), at(i + 1));
            let part = edge.part(low, high);
            match self.near_box {
                Some(_) if self.skipped == Some(*skip) => {}
                Some(own) => {
                    self.near.select(own, *skip, &mut self.candidates);
                    self.skipped = Some(*skip);
                }
                None => {
                    let query = bounds(&part);
                    scene.cells.gather(query, &mut self.near);
                    self.near.select(query, *skip, &mut self.candidates);
                }
            }
            let (hidden, visible) = (&mut self.hidden, &mut self.visible);
            visible_parts(&part, scene.shapes, scene.circles, &mut self.candidates, hidden, visible);
            let u_at = |t: f32| u[0] + (u[1] - u[0]) * (low + (high - low) * t);
            for &[a, b] in &self.visible {
                let inside = |p: [f32; 2]| [p[0].clamp(0.0, width), p[1].clamp(0.0, height)];
                let seen = part.part(a, b);
                let [x, y] = seen.place();
                let start = inside([x, y]);
                let end = inside([x + seen.step[0], y + seen.step[1]]);
                let step = [end[0] - start[0], end[1] - start[1]];
                let stretch = Stretch { start, step, u: [u_at(a), u_at(b) - u_at(a)] };
                walk(scene.width, scene.height, &stretch, &mut self.sub_edges);
            }
        }
        if self.sub_edges.len() > first {
            self.runs.push(Run {
                node: moving.node as u32,
                normal: moving.normal,
                radius_weight: moving.radius_weight,
                u_per_px: (u[1] - u[0]) / length,
                end: self.sub_edges.len() as u32,
            });
        }
    }
}

fn bounds(edge: &Edge) -> NegatedBox {
    let ([x, y], [dx, dy]) = (edge.place(), edge.step);
    [least(x, x + dx), least(y, y + dy), -most(x, x + dx), -most(y, y + dy)]
}
