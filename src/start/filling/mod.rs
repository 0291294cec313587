//! One closed curve that covers a mesh evenly.
//!
//! Stripes along a smooth field of directions give closed lines a spacing apart; lines side by side are joined until one
//! is left, and that one is evened out on the surface.

mod contour;
mod dots;
mod field;
mod guide;
mod hierarchy;
mod parts;
mod phase;
mod refined;
mod relax;
mod stitch;
mod strand;
mod stripes;
#[cfg(test)]
mod testing;

use super::Path;
use crate::error::{Error, Result};
use crate::mesh::Mesh;

pub use guide::{Guide, Wish};
pub(crate) use refined::RefinedMesh;
pub(crate) use relax::{Sample, samples};
pub(crate) use strand::{Grid, Node, SAME_SIDE, Strands, foot};

/// Spacings that [`fill`] takes, world units.
pub const SPACINGS_WORLD: std::ops::RangeInclusive<f64> = 0.02..=0.2;

/// Where the curve comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Parallel lines, stitched into one.
    #[default]
    Stripes,
    /// A short tour through places spread over the surface. Takes no guide.
    Tour,
}

/// How to fill a mesh.
#[derive(Debug)]
pub struct FillOptions {
    /// What the person calls the mesh.
    pub name: String,
    /// Distance between neighbouring strands, world units, in [`SPACINGS_WORLD`].
    pub spacing_world: f64,
    /// Width of the curve, world units.
    pub width_world: f64,
    /// Which way the strands run.
    pub guide: Guide,
    /// Where the curve comes from; a tour covers what no stripe fits on.
    pub method: Method,
    /// Seeds all that is random.
    pub seed: u64,
    /// Rounds of evening out.
    pub rounds: usize,
}

impl Default for FillOptions {
    fn default() -> Self {
        FillOptions {
            name: "mesh".into(),
            spacing_world: 0.06,
            width_world: 0.01,
            guide: Guide::Smooth,
            method: Method::Stripes,
            seed: 0,
            rounds: 10,
        }
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
/// [`Error::Setting`] for `curve_spacing` out of range or too fine for the mesh, and [`Error::Input`] if the mesh is too
/// fine for any spacing, or no part of it is large enough to hold a closed line.
pub fn fill(mesh: &Mesh, options: &FillOptions, progress: &mut dyn FnMut(f32) -> bool) -> Result<Option<Filling>> {
    let spacing = options.spacing_world;
    if !SPACINGS_WORLD.contains(&spacing) {
        let (low, high) = (SPACINGS_WORLD.start(), SPACINGS_WORLD.end());
        let remedy = format!("use {low} to {high}");
        return Err(Error::setting("curve_spacing", format!("{spacing} is out of range"), remedy));
    }
    let surface = RefinedMesh::named(&options.name, mesh, spacing / 2.0)?;
    if !progress(0.1) {
        return Ok(None);
    }
    let mut lines = Vec::new();
    if options.method == Method::Stripes {
        let levels = hierarchy::levels(&surface);
        let field = field::line_field(&levels, &options.guide, options.seed);
        if !progress(0.25) {
            return Ok(None);
        }
        lines = stripes::stripes(&surface, &levels, &field, spacing, options.seed);
    }
    if lines.is_empty() {
        lines = dots::tours(&surface, spacing, options.seed);
    }
    let mut covered: Vec<u32> = lines.iter().map(|line| surface.part(line[0].triangle)).collect();
    covered.sort_unstable();
    covered.dedup();
    if covered.is_empty() {
        // A mesh is as large as fits: only what lies far off makes its parts small.
        let join = "join the parts that touch, or leave out what lies far from the rest";
        let lower = if spacing > *SPACINGS_WORLD.start() { "lower curve_spacing, " } else { "" };
        return Err(Error::input(&options.name, "has no part large enough to hold a line", format!("{lower}{join}")));
    }
    let stitching = &mut |share: f64| progress(0.35 + 0.05 * share as f32);
    let Some(lines) = stitch::stitched(&surface, &lines, spacing, stitching) else { return Ok(None) };
    let relaxing = &mut |share: f64| progress(0.4 + 0.6 * share as f32);
    let Some(lines) = relax::relaxed(&surface, &lines, spacing, options.rounds, relaxing) else { return Ok(None) };
    let line = parts::joined(&lines, spacing);
    let mut notes = Vec::new();
    match surface.parts - covered.len() {
        0 => {}
        1 => notes.push("one part is too small for the spacing and left out".to_owned()),
        n => notes.push(format!("{n} parts are too small for the spacing and left out")),
    }
    if lines.len() > 1 {
        notes.push(format!("{} parts are joined by links through space", lines.len()));
    }
    let node = |node: &strand::Node| [node.point.x, node.point.y, node.point.z, options.width_world];
    let path = Path { points: line.iter().map(node).collect(), closed: true };
    let normals = line.iter().map(|node| node.normal.to_array()).collect();
    Ok(Some(Filling { path, normals, notes }))
}
