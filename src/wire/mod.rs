//! The 4D wire itself: control points (x, y, z, width), knots, and the linear maps from them.

mod linear_map;

pub use linear_map::{LinearMap, Real, Row};

/// How the control points make the curve. `Spline` is the wire; the other two are baselines to compare it with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Form {
    /// Cubic B-spline: C2 everywhere.
    #[default]
    Spline,
    /// Cubic Béziers that share end points: C0.
    Chain,
    /// Independent cubic Béziers.
    Bag,
}

/// One run of consecutive samples that are joined: `start..start + count`, and back to `start` if `closed`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stroke {
    /// Index of the first sample.
    pub start: usize,
    /// Number of samples.
    pub count: usize,
    /// Whether the last sample joins the first.
    pub closed: bool,
}

/// Control points in world units (x, y, z, width; width is the full diameter) with their knots.
#[derive(Debug, Clone, PartialEq)]
pub struct Wire {
    form: Form,
    closed: bool,
    knots: Vec<f64>,
    control_points: Vec<[f64; 4]>,
}

impl Wire {
    /// How the control points make the curve.
    pub fn form(&self) -> Form {
        self.form
    }
    /// Whether the curve is periodic.
    pub fn closed(&self) -> bool {
        self.closed
    }
    /// Open: n + 4 knots, clamped. Closed: n + 7, the curve runs from `knots[3]` to `knots[n + 3]`.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }
    /// `[x, y, z, width]` in world units.
    pub fn control_points(&self) -> &[[f64; 4]] {
        &self.control_points
    }
}
