//! The wire as one solid.

use crate::body::Body;
use crate::contour;
use crate::mesh::Mesh;
use crate::plate::Plate;
use crate::strands::{Cone, Strands};
use wire4d_core::{Error, Result};

/// A printed wire is meshed with cells of this share of its thinnest radius…
const FINE_SHARE: f64 = 0.6;
/// …or up to this where it is very long.
const COARSE_SHARE: f64 = 0.9;
/// Triangles a square of a cell's side, found by counting.
const TRIANGLES_PER_CELL: f64 = 5.2;
/// More than this no slicer opens with ease: a file of 150 MB.
const MOST_TRIANGLES: f64 = 3e6;
/// Facets cut across a round wire; wire thicker by this share of (cell / radius)² has a round one's volume. Found by fitting.
const SAGGED: f64 = 0.039;

/// A wire to print.
#[derive(Debug, Clone, PartialEq)]
pub struct Print {
    /// One solid: strands that touch are joined.
    pub mesh: Mesh,
    /// The thinnest place of the wire, mm.
    pub least_thickness_mm: f64,
}

/// The wire, on a plate if one is wanted.
///
/// # Errors
/// [`Error::Setting`] for a wire so long and thin that no slicer opens it.
pub fn print(strands: &Strands, plate: Option<&Plate>) -> Result<Print> {
    let cell_mm = cell_mm(strands)?;
    let mut cones = strands.cones.clone();
    let posts = plate.map_or(Vec::new(), |plate| plate.posts(strands));
    cones.extend(&posts);
    let wire = contour::surface(&round(&cones, cell_mm), cell_mm);
    let mesh = match plate {
        Some(plate) => Body::union(vec![Body::of(&wire), plate.body(strands, &posts)]).mesh().on_the_bed(),
        None => wire.on_the_bed(),
    };
    Ok(Print { mesh, least_thickness_mm: strands.least_thickness_mm() })
}

/// As fine as the thinnest place asks for and a slicer bears.
pub(crate) fn cell_mm(strands: &Strands) -> Result<f64> {
    let bearable = (TRIANGLES_PER_CELL * strands.area_mm2() / MOST_TRIANGLES).sqrt();
    let radius = strands.least_radius_mm;
    if bearable > COARSE_SHARE * radius {
        return Err(Error::setting(
            "--wire-mm",
            format!("a wire of that length {:.1} mm thick is more than a slicer can open", 2.0 * radius),
            format!(
                "give a smaller --size-mm or a wire of {:.1} mm",
                (2.0 * bearable / COARSE_SHARE * 10.0).ceil() / 10.0
            ),
        ));
    }
    Ok(bearable.max(FINE_SHARE * radius))
}

/// The cones as thick as makes up for facets.
pub(crate) fn round(cones: &[Cone], cell_mm: f64) -> Vec<Cone> {
    let thicker = |radius: f64| radius * (1.0 + SAGGED * (cell_mm / radius).powi(2));
    cones.iter().map(|cone| Cone { radii: cone.radii.map(thicker), ..*cone }).collect()
}
