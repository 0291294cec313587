//! The terms of the loss: one for each view, and those that are about the curve or all views alike.

/// A term of the loss that is not one view's. A row of loss terms holds the total, one for each view, then these in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// The jerk of the spline.
    Jerk,
    /// Its length.
    Length,
    /// How far it is from the surface that holds it.
    Surface,
    /// How far the views' textures are from the style's.
    Texture,
    /// How much it bends.
    Bending,
    /// Bends tighter than allowed.
    Tightness,
    /// How unevenly control points are spaced.
    Evenness,
    /// Strands too near each other.
    Clearance,
    /// Whatever else guides: networks, functions of one's own.
    Guidance,
}

impl Term {
    /// All, in the order of a row.
    pub const ALL: [Term; 9] = [
        Term::Jerk,
        Term::Length,
        Term::Surface,
        Term::Texture,
        Term::Bending,
        Term::Tightness,
        Term::Evenness,
        Term::Clearance,
        Term::Guidance,
    ];

    /// Its name in `loss.csv`, and in capitals in shaders.
    pub fn name(self) -> &'static str {
        match self {
            Term::Jerk => "jerk",
            Term::Length => "length",
            Term::Surface => "surface",
            Term::Texture => "texture",
            Term::Bending => "bending",
            Term::Tightness => "tightness",
            Term::Evenness => "evenness",
            Term::Clearance => "clearance",
            Term::Guidance => "guidance",
        }
    }

    /// Where it lies in a row with so many views.
    pub fn at(self, views: usize) -> usize {
        1 + views + self as usize
    }
}

/// Entries of a row of loss terms with so many views.
pub fn term_count(views: usize) -> usize {
    1 + views + Term::ALL.len()
}

/// A row's views' terms.
pub(super) fn views_of(row: &[f32]) -> &[f32] {
    &row[1..row.len() - Term::ALL.len()]
}
