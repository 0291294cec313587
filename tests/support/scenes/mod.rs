//! Photographs of known truth: twelve scenes rendered from meshes, each with the mask and the lines that geometry says.
//!
//! They are what cutting out and drawing are measured on. The same on every machine but for a level or so of rounding.

mod noise;
mod render;
mod solids;
mod truth;
mod twelve;

use glam::DVec3;
use wire4d_core::mesh::Mesh;

pub use render::photograph;
pub use twelve::twelve;

/// Side of a photograph, px.
pub const SIDE: usize = 512;

/// A colour, linear light, 0 to 1, and which patch of paint a place belongs to: borders between patches are lines.
pub type Paint = Box<dyn Fn(DVec3) -> (DVec3, u32)>;

/// A body and what it is made of.
pub struct Part {
    pub mesh: Mesh,
    pub paint: Paint,
    /// Strength of highlights, 0 to 1.
    pub gloss: f64,
}

/// A far light.
pub struct Lamp {
    /// Towards it; any length.
    pub towards: DVec3,
    pub colour: DVec3,
    /// Radius of the shadows' soft borders, world units; 0 is hard.
    pub softness: f64,
}

/// What an object is photographed on: by place for the floor (y = 0) and the wall behind it.
pub struct Ground {
    pub colour: Box<dyn Fn(DVec3) -> DVec3>,
    /// Whether there is a floor that shadows fall on; else everything round the object is wall.
    pub floor: bool,
}

/// Everything in front of a camera.
pub struct Scene {
    pub name: &'static str,
    /// Stands on y = 0 where there is a floor.
    pub parts: Vec<Part>,
    pub ground: Ground,
    pub lamps: Vec<Lamp>,
    /// Light from everywhere.
    pub ambient: f64,
    /// Where the camera is, radians.
    pub azimuth_rad: f64,
    pub elevation_rad: f64,
    /// Share of the picture's side that the object's longer side fills.
    pub fill: f64,
    /// Where the object's middle is, share of the side from the picture's middle.
    pub shift: [f64; 2],
    /// Standard deviation of a sensor's noise, of 255 levels.
    pub noise: f64,
    pub seed: u64,
}

/// A photograph and the truth about it; all pictures [`SIDE`] px a side, rows from the top left.
pub struct Photograph {
    pub name: &'static str,
    /// Red, green, blue, encoded as sRGB.
    pub rgb: Vec<u8>,
    /// Where the object is.
    pub mask: Vec<bool>,
    /// Where one thing hides another: the outline, and what lies before other parts of the object.
    pub contours: Vec<bool>,
    /// Where the surface bends sharply, or parts meet.
    pub creases: Vec<bool>,
    /// Where paint changes.
    pub painted: Vec<bool>,
}
