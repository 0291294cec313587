//! The exact rasteriser: its stages in order, on one thread or several, to the same bits.

use super::Raster;
use super::cells::Cells;
use super::joints::{self, Joint};
use super::outline::{Outline, Scene};
use super::pieces::{self, NONE, Node, Piece};
use super::rows;
use super::shapes::{Circles, Shapes};
use super::walk::SubEdge;
use crate::parallel;
use crate::wire::Stroke;
use std::ops::Range;

/// Nodes a chunk. Chunks are what threads share out; their number depends on the strokes alone.
const CHUNK: usize = 128;
/// Fewer chunks are not worth waking threads for.
const LEAST_PARALLEL_CHUNKS: usize = 4;
/// Nor are fewer pixels, or tasks of fewer rows.
#[cfg(feature = "threads")]
const LEAST_PARALLEL_PIXELS: usize = 1 << 16;
#[cfg(feature = "threads")]
const ROWS_A_TASK: usize = 32;

/// Exact box-filtered coverage of tapered round strokes, and its exact adjoint.
///
/// The union of the strokes is drawn as the union of convex polygons (a quad a piece, a regular polygon at hard
/// joints and ends, within 0.01 px of the disc). Forward: the visible outline of that union, cut at pixel borders, gives
/// each pixel's area by Green's theorem. Backward: the derivative of a pixel's area is the integral over the same
/// cut outline of its normal speed. No samples, no randomness; bit-equal for any number of threads.
///
/// ```
/// use wire4d_core::raster::{ExactRaster, Raster};
/// use wire4d_core::wire::Stroke;
///
/// let mut raster = ExactRaster::new();
/// // A stroke 4 px wide from (8, 16) to (24, 16) in a picture of 32 x 32.
/// let vertices = [[8.0, 16.0, 2.0], [24.0, 16.0, 2.0]];
/// let coverage = raster.forward(32, 32, &vertices, &[Stroke { start: 0, count: 2, closed: false }]);
/// let area: f32 = coverage.iter().sum();
/// assert!((area - (16.0 * 4.0 + std::f32::consts::PI * 4.0)).abs() < 0.2);
/// // How the area changes with x, y and radius of each vertex: pulling the end to the right by 1 px adds 4 px² of ink.
/// let mut d_vertices = Vec::new();
/// raster.backward(&vec![1.0; 32 * 32], &mut d_vertices);
/// assert!((d_vertices[1][0] - 4.0).abs() < 0.05 && d_vertices[1][1].abs() < 0.05);
/// ```
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
    /// The chunks whose outline was traced.
    traced: Range<usize>,
}

/// A part of the strokes, in shares of [`Part::WHOLE`]. What parts add up to is the whole, bit for bit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Where it begins.
    pub from: u32,
    /// Where the next one begins.
    pub to: u32,
}

impl Part {
    /// Where the last part ends.
    pub const WHOLE: u32 = 1 << 10;
    /// All of it.
    pub const ALL: Part = Part { from: 0, to: Part::WHOLE };

    fn of(self, count: usize) -> Range<usize> {
        let at = |share: u32| count * share.min(Part::WHOLE) as usize / Part::WHOLE as usize;
        at(self.from.min(self.to))..at(self.to)
    }
}

/// Everything that chunks share of a pass, while their outlines are written to.
macro_rules! scene {
    ($raster:expr) => {
        Scene {
            width: $raster.width,
            height: $raster.height,
            nodes: &$raster.nodes,
            pieces: &$raster.pieces,
            joints: &$raster.joints,
            shapes: &$raster.shapes,
            circles: &$raster.circles,
            cells: &$raster.cells,
        }
    };
}

impl ExactRaster {
    /// With empty buffers, which grow on the first call.
    pub fn new() -> Self {
        Self::default()
    }

    /// Calls `visit(vertex, outward normal, sub-edges, u per px)` for each visible run of the last forward pass.
    pub(super) fn visit_outline(&self, mut visit: impl FnMut(usize, [f32; 2], &[SubEdge], f32)) {
        for outline in &self.outlines[self.traced.clone()] {
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
        self.trace(width, height, vertices, strokes, Part::ALL, &mut done);
        done("outline");
        self.finish();
        done("rows");
        &self.coverage
    }

    /// The first half of [`Raster::forward`], by a part of the strokes alone: its share of the picture lies in
    /// [`ExactRaster::sums`]. Who adds the other parts' can [`ExactRaster::finish`] it; [`Raster::backward`] is then about this part.
    pub fn trace_part(&mut self, width: usize, height: usize, vertices: &[[f32; 3]], strokes: &[Stroke], part: Part) {
        self.trace(width, height, vertices, strokes, part, &mut |_| {});
    }

    fn trace(
        &mut self,
        width: usize,
        height: usize,
        vertices: &[[f32; 3]],
        strokes: &[Stroke],
        part: Part,
        done: &mut dyn FnMut(&'static str),
    ) {
        (self.width, self.height, self.vertex_count) = (width, height, vertices.len());
        self.coverage.resize(width * height, 0.0);
        // Sums are left clean by the last pass, whatever its size.
        self.sums.resize(width * height + 1, 0);
        self.traced = 0..0;
        if width == 0 || height == 0 {
            self.nodes.clear();
            return;
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
        self.traced = part.of(chunks);
        let scene = scene!(self);
        let first = self.traced.start;
        let trace = |k: usize, outline: &mut Outline| outline.trace(&scene, nodes_of(first + k, count));
        parallel::each_mut(&mut self.outlines[self.traced.clone()], LEAST_PARALLEL_CHUNKS, trace);
        for outline in &self.outlines[self.traced.clone()] {
            rows::add(&outline.sub_edges, &mut self.sums);
        }
    }

    /// What the part that was traced adds to each pixel, for [`ExactRaster::add`] of another raster.
    pub fn sums(&self) -> &[i32] {
        &self.sums[..self.width * self.height]
    }

    /// Adds what another part of the same strokes has traced.
    ///
    /// # Panics
    /// If that was not for a picture of this size.
    pub fn add(&mut self, sums: &[i32]) {
        assert_eq!(sums.len(), self.width * self.height, "one sum a pixel");
        rows::add_sums(sums, &mut self.sums);
    }

    /// Forgets what was traced, for who does not [`ExactRaster::finish`].
    pub fn clear_sums(&mut self) {
        self.sums.fill(0);
    }

    /// The second half of [`Raster::forward`], once all parts are together.
    pub fn finish(&mut self) -> &[f32] {
        let (width, height) = (self.width, self.height);
        if width > 0 && height > 0 {
            self.left.resize(height, 0);
            let scene = scene!(self);
            self.border.trace_left_border(&scene, &mut self.left);
            finish_rows(width, &mut self.sums, &self.left, &mut self.coverage);
            self.sums[width * height] = 0;
        }
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
        let (first, count) = (self.traced.start, self.nodes.len());
        let outlines = &mut self.outlines[self.traced.clone()];
        let pull_back = |k: usize, outline: &mut Outline| outline.pull_back(d_coverage, nodes_of(first + k, count));
        parallel::each_mut(outlines, LEAST_PARALLEL_CHUNKS, pull_back);
        d_vertices.clear();
        d_vertices.resize(self.vertex_count, [0.0; 3]);
        let d_pieces = outlines.iter().flat_map(|outline| &outline.d_pieces);
        let nodes = self.nodes.iter().skip(nodes_of(first, count).start);
        for (node, [start, end]) in nodes.zip(d_pieces) {
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

/// The nodes of a chunk, of `count` in all.
fn nodes_of(chunk: usize, count: usize) -> std::ops::Range<usize> {
    chunk * CHUNK..count.min((chunk + 1) * CHUNK)
}

fn finish_rows(width: usize, sums: &mut [i32], left: &[i32], coverage: &mut [f32]) {
    let finish = |((sums, coverage), &left): ((&mut [i32], &mut [f32]), &i32)| rows::finish(sums, left, coverage);
    #[cfg(feature = "threads")]
    if coverage.len() >= LEAST_PARALLEL_PIXELS && rayon::current_num_threads() > 1 {
        use rayon::prelude::*;
        let rows = sums.par_chunks_exact_mut(width).zip(coverage.par_chunks_exact_mut(width)).zip(left);
        rows.with_min_len(ROWS_A_TASK).for_each(finish);
        return;
    }
    sums.chunks_exact_mut(width).zip(coverage.chunks_exact_mut(width)).zip(left).for_each(finish);
}
