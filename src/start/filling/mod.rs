//! One closed curve that covers a mesh evenly.
//!
//! Stripes along a smooth field of directions give closed lines a spacing apart; lines side by side are joined until one
//! is left, and that one is evened out on the surface.

mod contour;
mod field;
mod hierarchy;
mod parts;
mod phase;
mod relax;
mod stitch;
mod strand;
mod surface;

use super::Path;
use crate::error::{Error, Result};
use crate::mesh::Mesh;

pub(crate) use relax::{Sample, samples};
pub(crate) use strand::{Grid, Node, SAME_SIDE, Strands, foot};
pub(crate) use surface::Surface;

/// Spacings that [`fill`] takes, world units.
pub const SPACINGS_WORLD: std::ops::RangeInclusive<f64> = 0.02..=0.2;

/// Where [`Guide::Custom`] wants lines at a point of the surface (world, with its unit normal): a direction, of which
/// the part along the surface counts and the sign does not, and its weight against smoothness (0 to 100; at 1 it counts
/// as much as all neighbours together). `None` where any direction is as good.
pub type Wish = dyn Fn(&[f64; 3], &[f64; 3]) -> Option<([f64; 3], f64)> + Send + Sync;

/// Which way the lines run.
#[derive(Default)]
pub enum Guide {
    /// Smoothly, along what is long in the shape.
    #[default]
    Smooth,
    /// Along a direction in the world, as far as the surface lets them.
    Along([f64; 3]),
    /// Across a direction in the world: for "up" like the rings of a potter's wheel.
    Across([f64; 3]),
    /// As a function asks for.
    Custom(Box<Wish>),
}

impl std::fmt::Debug for Guide {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            Guide::Smooth => write!(f, "Smooth"),
            Guide::Along(direction) => write!(f, "Along({direction:?})"),
            Guide::Across(direction) => write!(f, "Across({direction:?})"),
            Guide::Custom(_) => write!(f, "Custom"),
        }
    }
}

impl Guide {
    fn wish(&self, point: [f64; 3], normal: [f64; 3]) -> Option<([f64; 3], f64)> {
        use glam::DVec3;
        let n = DVec3::from(normal);
        // Where the direction stands on the surface it says nothing.
        let weighted = |direction: &[f64; 3], turn: &dyn Fn(DVec3) -> DVec3| {
            let flat = DVec3::from(*direction).normalize_or_zero().reject_from_normalized(n);
            Some((turn(flat).to_array(), flat.length_squared()))
        };
        match self {
            Guide::Smooth => None,
            Guide::Along(direction) => weighted(direction, &|flat| flat),
            Guide::Across(direction) => weighted(direction, &|flat| n.cross(flat)),
            Guide::Custom(wish) => wish(&point, &normal),
        }
    }
}

/// How to fill a mesh.
#[derive(Debug)]
pub struct FillOptions {
    /// Distance between neighbouring strands, world units, in [`SPACINGS_WORLD`].
    pub spacing_world: f64,
    /// Width of the curve, world units.
    pub width_world: f64,
    /// Which way the strands run.
    pub guide: Guide,
    /// Seeds all that is random.
    pub seed: u64,
    /// Rounds of evening out.
    pub rounds: usize,
}

impl Default for FillOptions {
    fn default() -> Self {
        FillOptions { spacing_world: 0.06, width_world: 0.01, guide: Guide::Smooth, seed: 0, rounds: 20 }
    }
}

/// A filled mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Filling {
    /// The one closed curve, nodes about every quarter of a spacing.
    pub path: Path,
    /// Unit normals of the surface at the curve's points.
    pub normals: Vec<[f64; 3]>,
    /// What a person should know, a sentence each.
    pub notes: Vec<String>,
}

/// Covers `mesh` by one closed curve. `progress` is told how much is done (0 to 1) and cancels by returning false: then
/// there is no result.
///
/// # Errors
/// [`Error::Setting`] for `curve_spacing` out of range or too fine for the mesh, and [`Error::Input`] if no part of the
/// mesh is large enough to hold a closed line.
pub fn fill(mesh: &Mesh, options: &FillOptions, progress: &mut dyn FnMut(f32) -> bool) -> Result<Option<Filling>> {
    let spacing = options.spacing_world;
    if !SPACINGS_WORLD.contains(&spacing) {
        let (low, high) = (SPACINGS_WORLD.start(), SPACINGS_WORLD.end());
        let remedy = format!("use {low} to {high}");
        return Err(Error::setting("curve_spacing", format!("{spacing} is out of range"), remedy));
    }
    let t = std::time::Instant::now();
    let log = |what: &str| eprintln!("  {:6.3} {what}", t.elapsed().as_secs_f64());
    let surface = Surface::new(mesh, spacing / 2.0)?;
    log(&format!("surface {} tri", surface.triangles.len()));
    let levels = hierarchy::levels(&surface);
    log(&format!("levels {:?}", levels.iter().map(|l| l.points.len()).collect::<Vec<_>>()));
    let field = field::line_field(&levels, &options.guide, options.seed);
    log("field");
    let period = spacing * PERIOD;
    let mut values = phase::stripes(&levels, &field, period, options.seed);
    for (value, distance) in values.iter_mut().zip(surface.rim_distances()) {
        *value = value.min((distance - spacing / 2.0) * std::f64::consts::PI / spacing);
    }
    log("phase");
    let lines = contour::zero_lines(&surface, &values);
    log(&format!("contour {} lines", lines.len()));
    let lines = stitch::stitched(&surface, lines, spacing);
    log(&format!("stitched {}", lines.len()));
    let told = &mut |share: f64| progress(0.3 + 0.7 * share as f32);
    let Some(lines) = relax::relaxed(&surface, lines, spacing, options.rounds, told) else { return Ok(None) };
    log("relaxed");
    let line = parts::joined(lines);
    let node = |node: &strand::Node| [node.point.x, node.point.y, node.point.z, options.width_world];
    let path = Path { points: line.iter().map(node).collect(), closed: true };
    let normals = line.iter().map(|node| node.normal.to_array()).collect();
    Ok(Some(Filling { path, normals, notes: Vec::new() }))
}

/// Stripes this much nearer than the spacing, so that area / length is the spacing in the end.
const PERIOD: f64 = 1.0;
