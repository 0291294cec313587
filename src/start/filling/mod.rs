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
        FillOptions { spacing_world: 0.06, width_world: 0.01, guide: Guide::Smooth, seed: 0, rounds: 10 }
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
    let surface = Surface::new(mesh, spacing / 2.0)?;
    let (large, left_out) = large_parts(&surface, spacing)?;
    let mut told = |done: f32| progress(done);
    if !told(0.1) {
        return Ok(None);
    }
    let levels = hierarchy::levels(&surface);
    let field = field::line_field(&levels, &options.guide, options.seed);
    if !told(0.25) {
        return Ok(None);
    }
    let lines = lines(&surface, &large, &levels, &field, options);
    if lines.is_empty() {
        return Err(too_small());
    }
    let lines = stitch::stitched(&surface, &lines, spacing);
    let relaxing = &mut |share: f64| told(0.4 + 0.6 * share as f32);
    let Some(lines) = relax::relaxed(&surface, &lines, spacing, options.rounds, relaxing) else { return Ok(None) };
    let line = parts::joined(&lines, spacing);
    let mut notes = Vec::new();
    if left_out > 0 {
        let s = if left_out == 1 { " is" } else { "s are" };
        notes.push(format!("{left_out} part{s} too small for the spacing and left out"));
    }
    if lines.len() > 1 {
        notes.push(format!("{} parts are joined by links through space", lines.len()));
    }
    let node = |node: &strand::Node| [node.point.x, node.point.y, node.point.z, options.width_world];
    let path = Path { points: line.iter().map(node).collect(), closed: true };
    let normals = line.iter().map(|node| node.normal.to_array()).collect();
    Ok(Some(Filling { path, normals, notes }))
}

/// Whether each part is large enough to be covered, and how many are not.
fn large_parts(surface: &Surface, spacing: f64) -> Result<(Vec<bool>, usize)> {
    let is_large = |area: f64| area >= SMALLEST_PART * spacing * spacing;
    let large: Vec<bool> = surface.part_areas().into_iter().map(is_large).collect();
    let left_out = large.iter().filter(|&&large| !large).count();
    if left_out == large.len() { Err(too_small()) } else { Ok((large, left_out)) }
}

fn too_small() -> Error {
    Error::input("mesh", "has no part large enough to hold a line", "use a finer spacing or scale the mesh up")
}

/// Closed lines about a spacing apart on the parts that are `large`.
fn lines(
    surface: &Surface,
    large: &[bool],
    levels: &[hierarchy::Level],
    field: &[glam::DVec3],
    options: &FillOptions,
) -> Vec<strand::Strand> {
    let spacing = options.spacing_world;
    let rim = surface.rim_distances();
    let mut found: (f64, Vec<strand::Strand>) = (f64::INFINITY, Vec::new());
    let mut period = spacing;
    for _ in 0..PERIODS_TRIED {
        let mut values = phase::stripes(levels, field, period, options.seed);
        for (v, value) in values.iter_mut().enumerate() {
            // Along a rim the lines turn back half a spacing before it.
            *value = value.min((rim[v] - spacing / 2.0) * std::f64::consts::PI / spacing);
        }
        contour::without_slivers(surface, &mut values, LEAST_PEAK);
        contour::cross_zero(surface, &mut values, &rim);
        let mut lines = contour::zero_lines(surface, &values);
        lines.retain(|line| large[surface.part(line[0].triangle) as usize]);
        let length: f64 = lines.iter().map(|line| strand::length(line)).sum();
        let ratio = surface.area() / length.max(spacing) / spacing / STRIPE_RATIO;
        if (ratio - 1.0).abs() < found.0 {
            found = ((ratio - 1.0).abs(), lines);
        }
        if found.0 < 0.01 {
            break;
        }
        period = (period / ratio).clamp(0.7 * spacing, 1.3 * spacing);
    }
    found.1
}

/// Parts of less than this many square spacings are not covered.
const SMALLEST_PART: f64 = 0.5;
/// Stripes in which the phase's cosine stays within this are a third of a spacing wide at most, and left out.
const LEAST_PEAK: f64 = 0.5;
/// Periods of the stripes that are tried until their length is right.
const PERIODS_TRIED: usize = 3;
/// Area over length of the stripes, in spacings, such that it is 1 in the end: evening out shortens the curve.
const STRIPE_RATIO: f64 = 0.98;
