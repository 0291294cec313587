//! Structures that shaders share, as `shaders/layout.wgsl` lays them out. A test compares every member's place.

use bytemuck::{Pod, Zeroable};
use std::mem::{offset_of, size_of};

/// The most views of one scene.
pub const MOST_VIEWS: usize = 64;
/// The most levels of one pyramid.
pub const MOST_LEVELS: usize = 16;
/// Regular polygons by number of sides.
pub const RINGS: usize = 35;

/// The numbers of one iteration.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
pub struct Step {
    pub rates: [f32; 4],
    pub width_bounds: [f32; 2],
    pub level_ratio: f32,
    pub jerk_position: f32,
    pub jerk_width: f32,
    pub length: f32,
    pub beta1: f32,
    pub beta2: f32,
    pub correction1: f32,
    pub correction2: f32,
    pub epsilon: f32,
    pub per_point: u32,
    pub row: u32,
    pub loss_scale: f32,
    pub gradient_share: f32,
    pub surface: f32,
    pub texture: f32,
    pub bending: f32,
    pub cusp_radius: f32,
    pub tightness: f32,
    pub least_radius: f32,
    pub least_diameters: f32,
    pub evenness: f32,
    pub even_speed: f32,
    pub standstill: f32,
    pub clearance: f32,
    pub clearance_diameters: f32,
    pub least_clearance: f32,
    pub mean_speed: f32,
    pub keeps_last: u32,
    pub padding: [u32; 2],
}

/// A view's camera, and where its share of each buffer begins.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
pub struct View {
    pub right: [f32; 4],
    pub down: [f32; 4],
    pub forward: [f32; 4],
    pub centre_px: [f32; 2],
    pub scale: f32,
    pub perspective: u32,
    pub width: u32,
    pub height: u32,
    pub first_pixel: u32,
    pub first_row: u32,
    pub first_cell: u32,
    pub columns: u32,
    pub rows: u32,
    pub levels: u32,
    pub weight: f32,
    pub first_partial: u32,
    pub partials: u32,
    pub fine_levels: u32,
    pub steepness: f32,
    pub bias_world: f32,
    pub padding: [u32; 2],
}

/// Counts, regular polygons and views.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct Scene {
    pub points: u32,
    pub samples: u32,
    pub views: u32,
    pub spans: u32,
    pub pixels: u32,
    pub cells: u32,
    pub entries: u32,
    pub gaussian: u32,
    pub surface_partial: u32,
    pub planes: u32,
    pub texture_partial: u32,
    pub texture_levels: u32,
    pub node_partial: u32,
    pub nodes: u32,
    pub padding: [u32; 2],
    pub rings: [[f32; 4]; RINGS],
    pub view: [View; MOST_VIEWS],
}

impl Scene {
    /// Numbers in the `cells` buffer before its lists: how long those get, and a head a cell.
    pub fn cells_head(&self) -> usize {
        1 + 2 * MOST_VIEWS + self.cells as usize
    }
}

/// A row of a banded map.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct Row {
    pub first: u32,
    pub weights: [f32; 4],
}

/// An entry of a transposed map.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub struct Term {
    pub row: u32,
    pub weight: f32,
}

/// One level of one view's pyramid.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
pub struct Level {
    pub offset: u32,
    pub width: u32,
    pub height: u32,
    pub first_partial: u32,
}

/// One level of one view's texture.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
pub struct TextureLevel {
    pub width: u32,
    pub height: u32,
    pub halvings: u32,
    pub share: f32,
    pub picture: u32,
    pub maps: u32,
    pub d_maps: u32,
    pub jets: u32,
    pub d_picture: u32,
    pub numbers: u32,
    pub weights: u32,
    pub wanted: u32,
    pub inverse_weight: f32,
    pub inverse_pairs: [f32; 5],
}

/// A place where integrals along the curve are taken.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
pub struct Node {
    pub place: [f32; 4],
    pub first_derivative: [f32; 4],
    pub second_derivative: [f32; 4],
    pub first: u32,
    pub step: f32,
    pub padding: [u32; 2],
}

/// Bytes of a `Joint` as shaders lay it out. The processor never reads one.
pub const JOINT_BYTES: u64 = 56;
/// Bytes of a `Shape`, likewise.
pub const SHAPE_BYTES: u64 = 112;

/// A structure's name and size in shaders, and its members with their offsets.
pub type Layout = (&'static str, usize, &'static [(&'static str, usize)]);

macro_rules! layouts {
    ($($name:ident { $($member:ident),* $(,)? })*) => {
        /// What shaders must agree with: each structure's size and its members' offsets, in bytes. For the test that reads
        /// them.
        pub const SHADER_LAYOUTS: &[Layout] = &[
            $((stringify!($name), size_of::<$name>(), &[$((stringify!($member), offset_of!($name, $member))),*]),)*
            ("Joint", JOINT_BYTES as usize, &[]),
            ("Shape", SHAPE_BYTES as usize, &[]),
        ];
    };
}
layouts! {
    Step {
        rates, width_bounds, level_ratio, jerk_position, jerk_width, length, beta1, beta2, correction1, correction2,
        epsilon, per_point, row, loss_scale, gradient_share, surface, texture, bending, cusp_radius, tightness, least_radius,
        least_diameters, evenness, even_speed, standstill, clearance, clearance_diameters, least_clearance, mean_speed,
        keeps_last,
    }
    View {
        right, down, forward, centre_px, scale, perspective, width, height, first_pixel, first_row, first_cell, columns,
        rows, levels, weight, first_partial, partials, fine_levels, steepness, bias_world,
    }
    Scene {
        points, samples, views, spans, pixels, cells, entries, gaussian, surface_partial, planes, texture_partial,
        texture_levels, node_partial, nodes, rings, view,
    }
    Row { first, weights }
    Term { row, weight }
    Level { offset, width, height, first_partial }
    Node { place, first_derivative, second_derivative, first, step }
    TextureLevel {
        width, height, halvings, share, picture, maps, d_maps, jets, d_picture, numbers, weights, wanted, inverse_weight,
        inverse_pairs,
    }
}
