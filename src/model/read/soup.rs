//! Triangles as read, before anything is mended.

/// Corners and the triangles between them.
#[derive(Debug, Default)]
pub(crate) struct Soup {
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// What was odd about the file, a plain sentence each.
    pub(crate) notes: Vec<String>,
}

/// For [`Soup::add_named`] alone: one more than the place in the soup of each corner of a list, as of its last use.
#[derive(Debug, Default)]
pub(super) struct Kept(Vec<u32>);

impl Soup {
    /// Adds a triangle with corners of its own.
    pub(super) fn add_triangle(&mut self, corners: [[f64; 3]; 3]) {
        let base = self.positions.len() as u32;
        self.positions.extend(corners);
        self.triangles.push([base, base + 1, base + 2]);
    }

    /// Adds triangles over a list of `count` corners, with those corners that they name: many may share one list. `corner`
    /// says where one lies. False if one is named that is not there.
    pub(super) fn add_named(
        &mut self,
        kept: &mut Kept,
        count: usize,
        triangles: impl Iterator<Item = [usize; 3]>,
        corner: impl Fn(usize) -> [f64; 3],
    ) -> bool {
        let Kept(kept) = kept;
        kept.resize(kept.len().max(count), 0);
        let base = self.positions.len();
        for triangle in triangles {
            if triangle.iter().any(|&index| index >= count) {
                return false;
            }
            self.triangles.push(triangle.map(|index| {
                if kept[index] as usize <= base {
                    self.positions.push(corner(index));
                    kept[index] = self.positions.len() as u32;
                }
                kept[index] - 1
            }));
        }
        true
    }
}
