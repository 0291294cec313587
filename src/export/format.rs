//! Which file a name's ending asks for, and the one function that writes any of them.

use super::{SvgOptions, TubeOptions, bend_csv, capsule, glb, lines, obj, stl, svg, tube};
use crate::mesh::Mesh;
use crate::sculpture::{Sculpture, Strand, strands};
use crate::view::{Occluder, View};
use crate::{Error, Result};

/// A file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// glTF 2.0, binary: a solid with material.
    Glb,
    /// Binary STL in millimetres: a solid for printing.
    Stl,
    /// Wavefront OBJ: a solid.
    Obj,
    /// A view's centre lines in millimetres, as SVG.
    Lines,
    /// A view's outlines.
    Svg,
    /// A bend list in millimetres.
    BendCsv,
    /// The sculpture itself.
    WireJson,
}

impl Format {
    /// All of them with their endings.
    pub const ALL: [(Format, &'static str); 7] = [
        (Format::Glb, "glb"),
        (Format::Stl, "stl"),
        (Format::Obj, "obj"),
        (Format::Lines, "lines.svg"),
        (Format::Svg, "svg"),
        (Format::BendCsv, "bend.csv"),
        (Format::WireJson, "wire.json"),
    ];

    /// Whether it shows one view of the wire.
    pub fn draws_a_view(self) -> bool {
        matches!(self, Format::Svg | Format::Lines)
    }

    /// Whether it is as large as [`ExportOptions::object_size_mm`] says.
    pub fn has_a_size(self) -> bool {
        matches!(self, Format::Stl | Format::BendCsv | Format::Lines)
    }

    /// By the ending of a file's name or path, upper or lower case. `wire.json` may be the whole name.
    ///
    /// # Errors
    /// [`Error::Setting`] that lists the endings there are.
    pub fn from_path(path: &str) -> Result<Format> {
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default().to_ascii_lowercase();
        let fits = |ending: &str| {
            name.strip_suffix(ending)
                .is_some_and(|stem| stem.ends_with('.') || (stem.is_empty() && ending.contains('.')))
        };
        Format::ALL.iter().find(|(_, ending)| fits(ending)).map(|&(format, _)| format).ok_or_else(|| {
            let endings = Format::ALL.map(|(_, ending)| format!(".{ending}")).join(", ");
            Error::setting("--to", format!("{path:?} has no ending of a known format"), format!("use one of {endings}"))
        })
    }
}

/// Choices that formats share. Lengths in millimetres are of the made object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExportOptions {
    /// The longest side of the object, wire included, for STL and bend lists; that of the drawing for centre lines.
    pub object_size_mm: f64,
    /// No printed wire is thinner; its radius.
    pub min_radius_mm: f64,
    /// How far a bend list's polyline may leave the wire.
    pub bend_tolerance_mm: f64,
    /// How the solid is meshed. `min_radius_world` does not apply to STL, which has its own.
    pub tube: TubeOptions,
    /// How a view is drawn.
    pub svg: SvgOptions,
}

impl Default for ExportOptions {
    fn default() -> Self {
        ExportOptions {
            object_size_mm: 100.0,
            min_radius_mm: 0.6,
            bend_tolerance_mm: 0.5,
            tube: TubeOptions::default(),
            svg: SvgOptions::default(),
        }
    }
}

impl ExportOptions {
    /// Whether all lengths can be used.
    ///
    /// # Errors
    /// [`Error::Setting`] for one that cannot.
    pub fn check(&self) -> Result<()> {
        let lengths = [
            ("size in mm", self.object_size_mm, 0.1..=1e5),
            ("min_radius_mm", self.min_radius_mm, 0.0..=1e3),
            ("bend_tolerance_mm", self.bend_tolerance_mm, 1e-3..=1e3),
        ];
        for (name, length, range) in lengths {
            if !range.contains(&length) {
                let remedy = format!("use {} to {} mm", range.start(), range.end());
                return Err(Error::setting(name, format!("{length} is out of range"), remedy));
            }
        }
        Ok(())
    }
}

/// Samples a knot span before the tube is thinned.
const SAMPLES_PER_SPAN: usize = 32;

/// The bytes of a file. Drawings show `view`, or the first of the sculpture's views, or the front, without what lies behind
/// `solid`; the other formats have the whole wire alone.
///
/// # Errors
/// [`Error::Setting`] for options out of range.
///
/// # Examples
/// ```
/// use wire4d::export::{ExportOptions, Format, export, open_share_code, share_code};
/// use wire4d::sculpture::{Carried, MadeWith, Sculpture};
/// use wire4d::wire::Wire;
///
/// # fn main() -> wire4d::Result<()> {
/// let square = [[1.0, 0.0, 0.0, 0.1], [0.0, 1.0, 0.0, 0.1], [-1.0, 0.0, 0.5, 0.1], [0.0, -1.0, 0.0, 0.1]];
/// let wire = Wire::closed_uniform(square.to_vec())?;
/// let made = Sculpture { wire, views: Vec::new(), made_with: MadeWith::default(), carried: Carried::default() };
/// let glb = export(&made, Format::from_path("ring.glb")?, None, None, &ExportOptions::default())?;
/// assert!(glb.starts_with(b"glTF"));
/// // A link carries it to within a fraction of a pixel.
/// let opened = open_share_code(&share_code(&made))?;
/// assert_eq!(opened.wire.control_points().len(), 4);
/// # Ok(())
/// # }
/// ```
pub fn export(
    sculpture: &Sculpture,
    format: Format,
    view: Option<&View>,
    solid: Option<&Mesh>,
    options: &ExportOptions,
) -> Result<Vec<u8>> {
    options.check()?;
    let strands = strands(&sculpture.wire, SAMPLES_PER_SPAN);
    Ok(match format {
        Format::Glb => glb(&tube(&strands, &options.tube), &capsule::in_glb(sculpture)),
        Format::Obj => obj(&tube(&strands, &options.tube)).into_bytes(),
        Format::Stl => {
            let (mm_per_world, min_radius_world) = scale(&strands, options.object_size_mm, options.min_radius_mm);
            stl(&tube(&strands, &TubeOptions { min_radius_world, ..options.tube }).scaled(mm_per_world))
        }
        Format::Svg | Format::Lines => {
            let [front, ..] = View::canonical(2.2, 256);
            let view = view.or(sculpture.views.first()).unwrap_or(&front);
            let occluder = solid.map(|solid| hiding(sculpture, solid, view));
            let text = match format {
                Format::Lines => lines(&sculpture.wire, view, occluder.as_ref(), options.object_size_mm),
                _ => svg(&sculpture.wire, view, occluder.as_ref(), &options.svg),
            };
            capsule::in_svg(&text, sculpture).into_bytes()
        }
        Format::BendCsv => {
            let (mm_per_world, _) = scale(&strands, options.object_size_mm, 0.0);
            bend_csv(&strands, mm_per_world, options.bend_tolerance_mm).into_bytes()
        }
        Format::WireJson => sculpture.to_json().into_bytes(),
    })
}

/// Depths of a solid along a drawing's longer side: strands end close to the solid's own outline.
const DEPTHS: f64 = 1024.0;
/// Of the solid's edge in drawings, per world unit: sharper than a fit has use for, or strands would end in long hairs.
const STEEPNESS: f32 = 300.0;

fn hiding(sculpture: &Sculpture, solid: &Mesh, view: &View) -> Occluder {
    let finer = DEPTHS / view.width_px.max(view.height_px) as f64;
    let [width, height] = [view.width_px, view.height_px].map(|px| (px as f64 * finer).round().max(1.0) as usize);
    Occluder { steepness: STEEPNESS, ..sculpture.hidden_by(solid, &view.with_size(width, height)) }
}

/// Millimetres a world unit so that the longest side is `size_mm`, and `min_radius_mm` in world units. A wire thickened
/// to the least radius is larger, which is allowed for.
fn scale(strands: &[Strand], size_mm: f64, min_radius_mm: f64) -> (f64, f64) {
    let side = |min_radius_world: f64| {
        let extent = |c: usize| {
            let ends = strands.iter().flat_map(|strand| &strand.points).map(|p| {
                let radius = (p[3] / 2.0).max(min_radius_world);
                (p[c] - radius, p[c] + radius)
            });
            let (low, high) =
                ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (a, b)| (low.min(a), high.max(b)));
            high - low
        };
        (0..3).map(extent).fold(0.0, f64::max)
    };
    let bare = side(0.0).max(1e-9);
    let mut mm_per_world = size_mm / bare;
    // The size depends on the floor and the floor, in world units, on the size: each step halves what is left.
    for _ in 0..20 {
        let thick = side((min_radius_mm / mm_per_world).min(bare)).max(1e-9);
        mm_per_world = 0.5 * (mm_per_world + size_mm / thick);
    }
    (mm_per_world, min_radius_mm / mm_per_world)
}
