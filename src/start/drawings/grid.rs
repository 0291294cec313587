//! The voxel grid over the object's box, and which picture pixel each voxel lands on in each view.

use crate::error::{Error, Result};
use crate::sorting::sort_by;
use crate::view::{Projection, Target, View};
use glam::DVec3;

/// No pixel: the voxel lies outside that view's picture, or in the spare layer.
pub const OFF_PICTURE: u32 = u32::MAX;

/// Voxels over the object's box, one spare layer all round (never entered, so that neighbours need no bounds check).
#[derive(Debug, Clone)]
pub struct Grid {
    /// Voxels along x, y, z, the spare layer included; x runs fastest.
    pub size: [usize; 3],
    /// Side of a voxel, world units.
    pub spacing_world: f64,
    /// Each view's plane size in pixels, about one voxel a pixel.
    pub plane_size: Vec<[usize; 2]>,
    /// For each view, each voxel's pixel in that view's plane, or [`OFF_PICTURE`].
    pub pixel: Vec<Vec<u32>>,
}

impl Grid {
    /// A grid over the box of `half_extents_world` with `across` voxels along the tallest picture's height.
    ///
    /// # Errors
    /// As [`Grid::size`].
    pub fn new(targets: &[Target], half_extents_world: [f64; 3], across: usize) -> Result<Grid> {
        let size = Grid::size(targets, half_extents_world, across)?;
        let spacing_world = spacing_world(targets, across);
        let plane_size = targets
            .iter()
            .map(|target| {
                let height = (height_world(&target.view) / spacing_world).round().max(2.0);
                let aspect = target.view.width_px as f64 / target.view.height_px as f64;
                [(height * aspect).round().max(2.0) as usize, height as usize]
            })
            .collect::<Vec<_>>();
        let mut grid = Grid { size, spacing_world, plane_size, pixel: Vec::new() };
        grid.pixel = (0..targets.len()).map(|v| grid.pixels_of(&targets[v].view, grid.plane_size[v])).collect();
        Ok(grid)
    }

    /// Voxels along x, y, z of such a grid, the spare layer included.
    ///
    /// # Errors
    /// If there are fewer than two views or the box is not a box.
    pub fn size(targets: &[Target], half_extents_world: [f64; 3], across: usize) -> Result<[usize; 3]> {
        if targets.len() < 2 {
            return Err(Error::Pictures {
                problem: format!("{} drawing, but an object needs two or three views", targets.len()),
                remedy: "add another drawing".into(),
            });
        }
        if half_extents_world.iter().any(|&half| !(half.is_finite() && half > 0.0 && half <= 4.0)) || across < 8 {
            return Err(Error::Pictures {
                problem: format!("the object's box {half_extents_world:?} cannot be divided into {across} voxels"),
                remedy: "use a box with positive sides and at least 8 voxels".into(),
            });
        }
        let spacing_world = spacing_world(targets, across);
        // An even number of voxels keeps their centres on the pixel centres of centred pictures.
        Ok(half_extents_world.map(|half| 2 * ((half / spacing_world).ceil() as usize).max(1) + 2))
    }

    /// Number of voxels, the spare layer included.
    pub fn voxels(&self) -> usize {
        self.size.iter().product()
    }

    /// World position of a voxel's centre.
    pub fn position(&self, voxel: usize) -> [f64; 3] {
        let [nx, ny, _] = self.size;
        let index = [voxel % nx, voxel / nx % ny, voxel / (nx * ny)];
        std::array::from_fn(|c| (index[c] as f64 - (self.size[c] - 1) as f64 / 2.0) * self.spacing_world)
    }

    /// The voxel in which a point of the world lies; `None` outside and in the spare layer.
    pub fn voxel(&self, position: [f64; 3]) -> Option<usize> {
        let mut index = [0; 3];
        for c in 0..3 {
            let at = (position[c] / self.spacing_world + (self.size[c] - 1) as f64 / 2.0).round();
            if !(at >= 1.0 && at <= self.size[c] as f64 - 2.0) {
                return None;
            }
            index[c] = at as usize;
        }
        Some((index[2] * self.size[1] + index[1]) * self.size[0] + index[0])
    }

    /// Whether a voxel belongs to the spare outer layer.
    pub fn is_spare(&self, voxel: usize) -> bool {
        let [nx, ny, nz] = self.size;
        let (x, y, z) = (voxel % nx, voxel / nx % ny, voxel / (nx * ny));
        x == 0 || y == 0 || z == 0 || x == nx - 1 || y == ny - 1 || z == nz - 1
    }

    /// The 26 neighbours as index offsets with their distance in voxels, nearest first.
    pub fn neighbours(&self) -> Vec<(isize, f32)> {
        let [nx, ny, _] = self.size.map(|n| n as isize);
        let mut offsets = Vec::with_capacity(26);
        for dz in -1..=1isize {
            for dy in -1..=1isize {
                for dx in -1..=1isize {
                    let squared = dx * dx + dy * dy + dz * dz;
                    if squared > 0 {
                        offsets.push(((dz * ny + dy) * nx + dx, (squared as f32).sqrt()));
                    }
                }
            }
        }
        sort_by(&mut offsets, |a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
        offsets
    }

    fn pixels_of(&self, view: &View, [width, height]: [usize; 2]) -> Vec<u32> {
        let camera = view.with_size(width, height).camera::<f64>();
        (0..self.voxels())
            .map(|voxel| {
                if self.is_spare(voxel) {
                    return OFF_PICTURE;
                }
                let [x, y, z] = self.position(voxel);
                let [x_px, y_px, _] = camera.project(&[x, y, z, 0.0]);
                let inside = x_px >= 0.0 && y_px >= 0.0 && x_px < width as f64 && y_px < height as f64;
                if inside { y_px as u32 * width as u32 + x_px as u32 } else { OFF_PICTURE }
            })
            .collect()
    }
}

/// Side of a voxel where `across` of them make the tallest picture's height.
fn spacing_world(targets: &[Target], across: usize) -> f64 {
    targets.iter().map(|target| height_world(&target.view)).fold(0.0, f64::max) / across as f64
}

/// World units from the picture's lower to its upper border, at the looked-at point for a perspective view.
pub fn height_world(view: &View) -> f64 {
    match view.projection {
        Projection::Orthographic { height_world } => height_world,
        Projection::Perspective { fov_y_rad } => {
            2.0 * DVec3::from(view.eye).distance(DVec3::from(view.target)) * (fov_y_rad / 2.0).tan()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Image;

    fn targets(size_px: usize) -> Vec<Target> {
        View::canonical(1.4, size_px)
            .into_iter()
            .map(|view| Target { view, ink: Image::new(size_px, size_px) })
            .collect()
    }

    #[test]
    fn canonical_voxels_land_on_pixel_centres() {
        let targets = targets(128);
        let grid = Grid::new(&targets, [0.5, 0.4, 0.3], 64).unwrap();
        for (v, target) in targets.iter().enumerate() {
            let [width, height] = grid.plane_size[v];
            assert_eq!([width, height], [64, 64]);
            let camera = target.view.with_size(width, height).camera::<f64>();
            for voxel in (0..grid.voxels()).step_by(977).filter(|&voxel| !grid.is_spare(voxel)) {
                let [x, y, z] = grid.position(voxel);
                let [x_px, y_px, _] = camera.project(&[x, y, z, 0.0]);
                assert!((x_px.fract() - 0.5).abs() < 1e-9 && (y_px.fract() - 0.5).abs() < 1e-9);
                assert_eq!(grid.pixel[v][voxel], y_px as u32 * 64 + x_px as u32);
                assert_eq!(grid.voxel([x, y, z]), Some(voxel));
            }
        }
    }

    #[test]
    fn one_view_or_no_box_is_refused() {
        let targets = targets(64);
        assert!(matches!(Grid::new(&targets[..1], [0.5; 3], 64), Err(Error::Pictures { .. })));
        assert!(matches!(Grid::new(&targets, [0.5, f64::NAN, 0.5], 64), Err(Error::Pictures { .. })));
    }
}
