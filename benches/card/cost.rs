//! Bytes and arithmetic of each stage, from a scene's counts. Bytes are those that shaders ask for, most of which caches
//! serve; arithmetic is counted by hand in the shaders' text. Both are estimates, the tracing stages' good to a factor
//! of two: how many hiders an edge meets is taken from how crowded the cells are.

use wire4d::objective::level_sizes;
use wire4d::optimize::Scene;

const CELL_PX: f32 = 8.0;
/// Values of the largest level of a pyramid that is left to one workgroup.
const COARSE: usize = 4096;

/// Sizes in bytes, as `shaders/layout.wgsl` has them.
const VEC4: f64 = 16.0;
const JOINT: f64 = 56.0;
const SHAPE: f64 = 112.0;
/// A row or entry of a banded map, and a sample's two links.
const ROW: f64 = 20.0;
const TERM: f64 = 8.0;
const LINKS: f64 = 8.0;

/// What the stages' work grows with.
pub struct Counts {
    points: f64,
    samples: f64,
    views: f64,
    /// Samples of all views.
    nodes: f64,
    pixels: f64,
    /// Values of the pyramids' coarser levels: those made a pass each, and those left to one workgroup.
    fine: f64,
    coarse: f64,
    /// Entries of cells.
    entries: f64,
    /// Pairs of an edge and a polygon that may hide it.
    pairs: f64,
    /// Pixels that sides of pieces run through, hidden or not.
    crossings: f64,
}

impl Counts {
    pub fn new(scene: &Scene, vertices: &[[f32; 4]], entries: usize) -> Counts {
        let samples = scene.sampling.rows().len();
        let (mut crowds, mut crossings, mut pixels, mut fine, mut coarse) = (0.0, 0.0, 0, 0, 0);
        for (view, vertices) in scene.views.iter().zip(vertices.chunks_exact(samples)) {
            let (width, height) = (view.target.width, view.target.height);
            pixels += width * height;
            for size in level_sizes(width, height).iter().skip(1).map(|(width, height)| width * height) {
                *if size > COARSE { &mut fine } else { &mut coarse } += size;
            }
            let columns = width.div_ceil(CELL_PX as usize);
            let mut crowd = vec![0.0f64; columns * height.div_ceil(CELL_PX as usize)];
            for [x, y, ..] in vertices {
                if (0.0..width as f32).contains(x) && (0.0..height as f32).contains(y) {
                    crowd[(y / CELL_PX) as usize * columns + (x / CELL_PX) as usize] += 1.0;
                }
            }
            crowds += crowd.iter().map(|count| count * count).sum::<f64>();
            let step = |pair: &[[f32; 4]]| (pair[1][0] - pair[0][0]).abs() + (pair[1][1] - pair[0][1]).abs();
            crossings += vertices.windows(2).map(|pair| 1.0 + f64::from(step(pair))).sum::<f64>();
        }
        let nodes = (samples * scene.views.len()) as f64;
        Counts {
            points: scene.sampling.columns() as f64,
            samples: samples as f64,
            views: scene.views.len() as f64,
            nodes,
            pixels: pixels as f64,
            fine: fine as f64,
            coarse: coarse as f64,
            entries: entries as f64,
            // Two sides a node, each against all entries of a cell: a polygon is in several.
            pairs: 2.0 * crowds * (entries as f64 / nodes).max(1.0),
            crossings: 2.0 * crossings,
        }
    }

    /// Bytes and floating-point operations of a stage.
    pub fn cost(&self, stage: &str) -> (f64, f64) {
        let Counts { points, samples, views, nodes, pixels, fine, coarse, entries, pairs, crossings } = *self;
        // An entry and a box for each pair; for one in four the rest of the shape.
        let search = (pairs * (8.0 + VEC4 + 0.25 * SHAPE), pairs * (8.0 + 0.25 * 70.0));
        let edges = (nodes * (2.0 * VEC4 + 2.0 * JOINT + SHAPE), nodes * 100.0);
        match stage {
            "sample" => (samples * (ROW + 5.0 * VEC4), samples * 32.0),
            "project" => (nodes * (2.0 * VEC4 + LINKS), nodes * 20.0),
            "join_pieces" => (nodes * (3.0 * VEC4 + LINKS + JOINT), nodes * 120.0),
            "shape_nodes" => (nodes * (2.0 * VEC4 + 2.0 * JOINT + SHAPE), nodes * 80.0),
            "fill_cells" => (nodes * 2.0 * VEC4 + entries * 16.0, nodes * 20.0),
            "trace" => (edges.0 + search.0 + crossings * 12.0, edges.1 + search.1 + crossings * 25.0),
            "finish_rows" => (pixels * 16.0, pixels * 12.0),
            "compare" => (pixels * 12.0 + fine * 20.0, pixels * 4.0 + fine * 8.0),
            "compare_coarse" => (coarse * 32.0, coarse * 11.0),
            "compare_vjp" => (pixels * 12.0 + fine * 12.0, (pixels + fine) * 3.0),
            // Edges with more than one visible interval are looked up again: not counted.
            "pull_back" => (edges.0 + crossings * 4.0 + nodes * 3.0 * VEC4, edges.1 + crossings * 30.0),
            "gather_pulls" => (nodes * (4.0 * VEC4 + 4.0), nodes * 8.0),
            "project_vjp" => (nodes * VEC4 + samples * 2.0 * VEC4, nodes * 30.0),
            // Each sample belongs to four points; the length's gradient looks at its two neighbours.
            "sample_transpose" => {
                (4.0 * samples * (TERM + 4.0 * VEC4 + LINKS) + points * 2.0 * VEC4, 4.0 * samples * 40.0)
            }
            "jerk_gradient" => (points * (4.0 * (TERM + ROW + 4.0 * VEC4) + 2.0 * VEC4), points * 170.0),
            "add_terms" => (samples * (LINKS + 2.0 * VEC4) + points * (ROW + 4.0 * VEC4) + views * 4.0, samples * 10.0),
            "adam" => (points * 7.0 * VEC4, points * 60.0),
            _ => (0.0, 0.0),
        }
    }
}
