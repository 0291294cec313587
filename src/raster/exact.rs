//! The exact rasteriser: its stages in order, on one thread or several, to the same bits.

use super::Raster;
use super::cells::Cells;
use super::joints::{self, Joint};
use super::outline::{Outline, Scene};
use super::pieces::{self, NONE, Node, Piece};
use super::rows;
use super::shapes::{Circles, Shapes};
use super::walk::SubEdge;
use crate::wire::Stroke;

/// Nodes a chunk. Chunks are what threads share out; their number depends on the strokes alone.
const CHUNK: usize = 128;
/// Fewer chunks are not worth waking threads for.
const LEAST_PARALLEL_CHUNKS: usize = 4;

/// Exact box-filtered coverage of tapered round strokes, and its exact adjoint.
///
/// The union of the strokes is drawn as the union of convex polygons (a quad a piece, a regular polygon at hard
/// joints and ends, within 0.01 px of the disc). Forward: the visible outline of that union, cut at pixel borders, gives
/// each pixel's area by Green's theorem. Backward: the derivative of a pixel's area is the integral over the same
/// cut outline of its normal speed. No samples, no randomness; bit-equal for any number of threads.
#[derive(Debug, Default)]
pub struct ExactRaster {
    pub(super) width: usize,
    pub(super) height: usize,
    vertex_count: usize,
    circles: Circles,
    pub(super) nodes: Vec<Node>,
    pieces: Vec<Piece>,
    joints: Vec<Joint>,
    shapes: Shapes,
    cells: Cells,
    pub(super) outlines: Vec<Outline>,
    border: Outline,
    left: Vec<i32>,
    sums: Vec<i32>,
    coverage: Vec<f32>,
    /// Adjoint of each piece's start and end disc.
    d_pieces: Vec<[[f32; 3]; 2]>,
}

impl ExactRaster {
    /// With empty buffers, which grow on the first call.
    pub fn new() -> Self {
        Self::default()
    }

    /// Calls `visit(vertex, outward normal, sub-edges, u per px)` for each visible run of the last forward pass.
    pub(super) fn visit_outline(&self, mut visit: impl FnMut(usize, [f32; 2], &[SubEdge], f32)) {
        for outline in &self.outlines[..self.chunks()] {
            let mut first = 0;
            for run in &outline.runs {
                let sub_edges = &outline.sub_edges[first..run.end as usize];
                visit(self.nodes[run.node as usize].vertex as usize, run.normal, sub_edges, run.u_per_px);
                first = run.end as usize;
            }
        }
    }

    /// [`Raster::forward`] that calls `done` with a stage's name after each stage, for measuring.
    pub fn forward_watched(
        &mut self,
        width: usize,
        height: usize,
        vertices: &[[f32; 3]],
        strokes: &[Stroke],
        mut done: impl FnMut(&'static str),
    ) -> &[f32] {
        (self.width, self.height, self.vertex_count) = (width, height, vertices.len());
        self.coverage.resize(width * height, 0.0);
        // Sums are left clean by the last pass, whatever its size.
        self.sums.resize(width * height + 1, 0);
        self.left.resize(height, 0);
        if width == 0 || height == 0 {
            self.nodes.clear();
            return &self.coverage;
        }
        pieces::build(vertices, strokes, &mut self.nodes, &mut self.pieces);
        joints::build(&self.nodes, &self.pieces, &mut self.joints);
        self.shapes.build(&self.nodes, &self.pieces, &self.joints, &self.circles);
        done("pieces");
        self.cells.build(width, height, &self.nodes, &self.shapes);

        done("cells");
        let (chunks, count) = (self.chunks(), self.nodes.len());
        if self.outlines.len() < chunks {
            self.outlines.resize_with(chunks, Outline::default);
        }
        let scene = Scene {
            width,
            height,
            nodes: &self.nodes,
            pieces: &self.pieces,
            joints: &self.joints,
            shapes: &self.shapes,
            circles: &self.circles,
            cells: &self.cells,
        };
        let trace = |chunk: usize, outline: &mut Outline| {
            outline.trace(&scene, chunk * CHUNK..count.min((chunk + 1) * CHUNK));
        };
        for_each(&mut self.outlines[..chunks], LEAST_PARALLEL_CHUNKS, trace);
        self.border.trace_left_border(&scene, &mut self.left);
        for outline in &self.outlines[..chunks] {
            rows::add(&outline.sub_edges, &mut self.sums);
        }
        done("outline");
        for (y, row) in self.coverage.chunks_mut(width).enumerate() {
            rows::finish(&mut self.sums[y * width..(y + 1) * width], self.left[y], row);
        }
        self.sums[width * height] = 0;
        done("rows");
        &self.coverage
    }

    fn chunks(&self) -> usize {
        self.nodes.len().div_ceil(CHUNK)
    }
}

impl Raster for ExactRaster {
    fn forward(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke]) -> &[f32] {
        self.forward_watched(width, height, vertices, strokes, |_| {})
    }

    fn backward(&mut self, d_coverage: &[f32], d_vertices: &mut Vec<[f32; 3]>) {
        assert_eq!(d_coverage.len(), self.width * self.height, "one adjoint a pixel of the last forward pass");
        let chunks = self.chunks();
        self.d_pieces.clear();
        self.d_pieces.resize(self.nodes.len(), [[0.0; 3]; 2]);
        for outline in &self.outlines[..chunks] {
            let mut first = 0;
            for run in &outline.runs {
                let (mut sum, mut moment) = (0.0f32, 0.0f32);
                for edge in &outline.sub_edges[first..run.end as usize] {
                    let weight = d_coverage[edge.pixel as usize] * edge.length_px;
                    sum += weight;
                    moment += weight * edge.u;
                }
                first = run.end as usize;
                let [start, end] = &mut self.d_pieces[run.node as usize];
                let speed = [run.normal[0], run.normal[1], run.radius_weight];
                for c in 0..3 {
                    start[c] += (sum - moment) * speed[c];
                    end[c] += moment * speed[c];
                }
            }
        }
        d_vertices.clear();
        d_vertices.resize(self.vertex_count, [0.0; 3]);
        for (node, [start, end]) in self.nodes.iter().zip(&self.d_pieces) {
            let mut add = |vertex: u32, d: &[f32; 3]| {
                for c in 0..3 {
                    d_vertices[vertex as usize][c] += d[c];
                }
            };
            add(node.vertex, start);
            if node.next != NONE {
                add(self.nodes[node.next as usize].vertex, end);
            }
        }
    }
}

/// Runs `task` on every item with its index; on several threads where that is worth their waking up.
fn for_each<T: Send>(items: &mut [T], least_parallel: usize, task: impl Fn(usize, &mut T) + Send + Sync) {
    #[cfg(feature = "threads")]
    if items.len() >= least_parallel && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        items.par_iter_mut().enumerate().for_each(|(i, item)| task(i, item));
        return;
    }
    let _ = least_parallel;
    items.iter_mut().enumerate().for_each(|(i, item)| task(i, item));
}
