//! The surface of many round cones joined: marching tetrahedra over their exact distance.
//!
//! Cutting thousands of overlapping tubes out of each other triangle by triangle takes minutes, and worse where a wire
//! crosses itself often. Here the work is bounded by the surface alone. Cells of a cubic lattice are split into six
//! tetrahedra along their diagonal (Kuhn), the same way in every cell, so that faces match; what separates the corners
//! inside from those outside is then closed and two-manifold whatever the values are (Doi and Koide, 1991): the tetrahedra
//! round a cut edge give one ring of triangles. Only lattice points near the surface are looked at.

use crate::mesh::Mesh;
use crate::strands::Cone;
use glam::{DVec3, IVec3};
use std::collections::{BTreeMap, HashMap};

/// Cells along a block's side.
const SIDE: i32 = 8;
/// Lattice points from which values count, in cells: more than a cell's diagonal.
const BAND: f64 = 1.8;
/// A vertex keeps this share of its edge from either end, so that no triangle is a speck.
const MARGIN: f64 = 0.06;
/// Steps that find where an edge enters the solid.
const STEPS: usize = 4;

struct Block {
    values: Box<[f32; (SIDE * SIDE * SIDE) as usize]>,
    cones: Vec<u32>,
}

/// The surface of their union. Triangles are about `cell_mm` across.
pub fn surface(cones: &[Cone], cell_mm: f64) -> Mesh {
    let blocks = blocks(cones, cell_mm);
    let mut mesh = Mesh::default();
    let mut vertices: HashMap<(IVec3, u8), u32> = HashMap::new();
    for (&[x, y, z], block) in &blocks {
        let first = IVec3::new(x, y, z) * SIDE;
        let values = with_border(&blocks, [x, y, z]);
        let distance =
            |place: DVec3| block.cones.iter().map(|&i| cones[i as usize].distance(place)).fold(f64::INFINITY, f64::min);
        for cell in (0..SIDE * SIDE * SIDE).map(of_index) {
            let corner = |bits: u8| values[border_index(cell + offset(bits))];
            let inside = (0..8).filter(|&bits| corner(bits) < 0.0).count();
            if inside == 0 || inside == 8 {
                continue;
            }
            let mut vertex = |from: u8, to: u8| {
                let (from, to) = (from.min(to), from.max(to));
                let start = first + cell + offset(from);
                *vertices.entry((start, to ^ from)).or_insert_with(|| {
                    let ends = [start, first + cell + offset(to)].map(|p| p.as_dvec3() * cell_mm);
                    let share = crossing(distance, ends, [corner(from), corner(to)].map(f64::from));
                    mesh.positions.push(ends[0].lerp(ends[1], share).as_vec3().to_array());
                    mesh.positions.len() as u32 - 1
                })
            };
            for tetrahedron in TETRAHEDRA {
                for triangle in cut(tetrahedron, |bits| corner(bits) < 0.0).into_iter().flatten() {
                    let triangle = triangle.map(|(from, to)| vertex(from, to));
                    mesh.triangles.push(triangle);
                }
            }
        }
    }
    mesh
}

/// The blocks that the surface may pass, with their values and the cones that matter there.
fn blocks(cones: &[Cone], cell_mm: f64) -> BTreeMap<[i32; 3], Block> {
    let mut blocks = BTreeMap::new();
    for (i, cone) in cones.iter().enumerate() {
        let [low, high] = cone.bounds();
        // A cell more, for edges that leave a block.
        let reach = (BAND + 1.0) * cell_mm;
        let low = ((low - reach) / cell_mm).floor().as_ivec3();
        let high = ((high + reach) / cell_mm).ceil().as_ivec3();
        let side = IVec3::splat(SIDE);
        let [first, last] = [low.div_euclid(side), high.div_euclid(side)];
        for at in lattice(first, last) {
            // A block apart from the cone is not made.
            let middle = (at * SIDE).as_dvec3() + DVec3::splat(0.5 * f64::from(SIDE));
            let half_diagonal = 0.5 * f64::from(SIDE) * 3f64.sqrt();
            if cone.distance(middle * cell_mm) > half_diagonal * cell_mm + reach {
                continue;
            }
            let block = blocks.entry(at.to_array()).or_insert_with(|| Block {
                values: Box::new([f32::INFINITY; (SIDE * SIDE * SIDE) as usize]),
                cones: Vec::new(),
            });
            block.cones.push(i as u32);
            let origin = at * SIDE;
            for p in lattice(low.max(origin) - origin, high.min(origin + SIDE - 1) - origin) {
                let value = &mut block.values[index(p)];
                *value = value.min(cone.distance((origin + p).as_dvec3() * cell_mm) as f32);
            }
        }
    }
    blocks
}

fn lattice(low: IVec3, high: IVec3) -> impl Iterator<Item = IVec3> {
    (low.z..=high.z)
        .flat_map(move |z| (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| IVec3::new(x, y, z))))
}

fn index(p: IVec3) -> usize {
    ((p.z * SIDE + p.y) * SIDE + p.x) as usize
}

fn of_index(i: i32) -> IVec3 {
    IVec3::new(i % SIDE, i / SIDE % SIDE, i / (SIDE * SIDE))
}

fn border_index(p: IVec3) -> usize {
    ((p.z * (SIDE + 1) + p.y) * (SIDE + 1) + p.x) as usize
}

/// A block's values and those that follow it on three sides; far outside where there is no block.
fn with_border(blocks: &BTreeMap<[i32; 3], Block>, at: [i32; 3]) -> Vec<f32> {
    let neighbours: [Option<&Block>; 8] =
        std::array::from_fn(|bits| blocks.get(&(IVec3::from(at) + offset(bits as u8)).to_array()));
    lattice(IVec3::ZERO, IVec3::splat(SIDE))
        .map(|p| {
            let over = p / SIDE;
            let bits = over.x | over.y << 1 | over.z << 2;
            neighbours[bits as usize].map_or(f32::INFINITY, |block| block.values[index(p % SIDE)])
        })
        .collect()
}

/// A cell's corner by its bits: 1 along x, 2 along y, 4 along z.
fn offset(bits: u8) -> IVec3 {
    IVec3::new(i32::from(bits & 1), i32::from(bits >> 1 & 1), i32::from(bits >> 2))
}

/// A cell's tetrahedra, each a way from corner 0 to corner 7 along the axes; all of positive volume.
const TETRAHEDRA: [[u8; 4]; 6] = [[0, 1, 3, 7], [0, 5, 1, 7], [0, 2, 6, 7], [0, 3, 2, 7], [0, 4, 5, 7], [0, 6, 4, 7]];

/// The edges whose crossings are a triangle's corners.
type Cut = [(u8, u8); 3];

/// What separates the corners inside from those outside, seen from outside.
fn cut(tetrahedron: [u8; 4], inside: impl Fn(u8) -> bool) -> [Option<Cut>; 2] {
    let count = tetrahedron.iter().filter(|&&corner| inside(corner)).count();
    // Even permutations that bring one corner, or a pair of corners, to the front.
    const ONE_FIRST: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 0, 3, 2], [2, 3, 0, 1], [3, 2, 1, 0]];
    const PAIR_FIRST: [[usize; 4]; 6] =
        [[0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 2, 0], [2, 3, 0, 1]];
    let front = |orders: &[[usize; 4]], fits: &dyn Fn([u8; 4]) -> bool| {
        orders.iter().map(|order| order.map(|i| tetrahedron[i])).find(|&corners| fits(corners))
    };
    match count {
        1 => front(&ONE_FIRST, &|c| inside(c[0])).map(|[a, b, c, d]| [Some([(a, b), (a, c), (a, d)]), None]),
        3 => front(&ONE_FIRST, &|c| !inside(c[0])).map(|[a, b, c, d]| [Some([(a, b), (a, d), (a, c)]), None]),
        2 => front(&PAIR_FIRST, &|c| inside(c[0]) && inside(c[1])).map(|[a, b, c, d]| {
            let [p, q, r, s] = [(a, c), (a, d), (b, d), (b, c)];
            [Some([p, q, r]), Some([p, r, s])]
        }),
        _ => None,
    }
    .unwrap_or_default()
}

/// Where an edge enters the solid, as a share of it: the false position, with Illinois' halving.
fn crossing(distance: impl Fn(DVec3) -> f64, ends: [DVec3; 2], values: [f64; 2]) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    let [mut at_low, mut at_high] = values;
    let mut share = 0.5;
    let mut side = 0;
    for step in 0..STEPS {
        share = low + (high - low) * at_low / (at_low - at_high);
        if step + 1 == STEPS {
            break;
        }
        let value = distance(ends[0].lerp(ends[1], share));
        if (value < 0.0) == (at_low < 0.0) {
            [low, at_low] = [share, value];
            if side == 1 {
                at_high *= 0.5;
            }
            side = 1;
        } else {
            [high, at_high] = [share, value];
            if side == 2 {
                at_low *= 0.5;
            }
            side = 2;
        }
    }
    // A far end outside every block has no finite value, and never a crossing.
    if share.is_finite() { share.clamp(MARGIN, 1.0 - MARGIN) } else { 0.5 }
}
