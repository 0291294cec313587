//! What a person asks of the direction of lines.

use glam::DVec3;

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
    /// What is asked for at a point with its unit normal.
    pub(super) fn wish(&self, point: [f64; 3], normal: [f64; 3]) -> Option<([f64; 3], f64)> {
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
