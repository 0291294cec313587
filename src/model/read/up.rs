//! Which way is up.

/// The axis of a file that points up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Up {
    /// As in glTF, and most OBJ and PLY files.
    Y,
    /// As on the bed of a printer: most STL and 3MF files.
    Z,
}

impl Up {
    /// All of them.
    pub const ALL: [Up; 2] = [Up::Y, Up::Z];

    /// Its word, `y` or `z`.
    pub fn name(self) -> &'static str {
        match self {
            Up::Y => "y",
            Up::Z => "z",
        }
    }

    /// The one called so.
    pub fn named(word: &str) -> Option<Up> {
        Up::ALL.into_iter().find(|up| up.name() == word)
    }

    /// Turns points so that y is up; what looked along -y at whoever stood before it looks along z.
    pub(super) fn stand(self, positions: &mut [[f64; 3]]) {
        if self == Up::Z {
            positions.iter_mut().for_each(|[x, y, z]| [*x, *y, *z] = [*x, *z, -*y]);
        }
    }
}
