//! What a person gives: a mesh, and a picture whose look the wire should take on.

use crate::mesh::{Mesh, Shape};
use crate::picture::Pattern;
use crate::view::Image;
use std::sync::Arc;

/// What a person gives.
#[derive(Debug, Clone)]
pub struct Given {
    /// The mesh as the person knows it.
    pub name: String,
    /// The surface.
    pub mesh: Arc<Mesh>,
    /// What was mended about it, in plain words.
    pub notes: Vec<String>,
    /// What it should look like.
    pub style: Option<Style>,
}

/// A picture whose look the wire should take on.
#[derive(Debug, Clone, PartialEq)]
pub struct Style {
    /// Its name as the person knows it.
    pub name: String,
    /// Ink, 0 (ground) to 1 (ink).
    pub ink: Image,
    /// Whether its borders meet when it is repeated.
    pub tiles: bool,
}

/// Side of a pattern's picture, px: the curve depends on it, so it is one for all.
const PATTERN_PX: usize = 512;

impl Style {
    /// A built-in pattern.
    pub fn pattern(pattern: Pattern) -> Style {
        Style { name: pattern.name().to_owned(), ink: pattern.picture(PATTERN_PX), tiles: true }
    }
}

impl Given {
    /// A mesh from a file, with what was mended about it.
    pub fn mesh(name: &str, mesh: Mesh, notes: Vec<String>) -> Given {
        Given { name: name.to_owned(), mesh: Arc::new(mesh), notes, style: None }
    }

    /// A built-in shape.
    pub fn shape(shape: Shape) -> Given {
        Given { name: shape.name().into(), mesh: Arc::new(shape.mesh()), notes: Vec::new(), style: None }
    }
}
