//! What a test of a mesh needs, written apart from what makes meshes.

use std::collections::{BTreeMap, HashMap};
use wire4d_core::rng::Rng;
use wire4d_core::wire::Wire;
use wire4d_printing::Mesh;

/// A smooth wire through random places.
pub fn random_wire(seed: u64, closed: bool, count: usize) -> Wire {
    let mut rng = Rng::new(seed, 5);
    let points = (0..count).map(|_| rng.in_ball(1.0)).map(|[x, y, z]| [x, y, z, 0.02]).collect();
    if closed { Wire::closed_uniform(points).unwrap() } else { Wire::open_uniform(points).unwrap() }
}

/// What is known of a closed surface.
#[derive(Debug)]
pub struct Shape {
    /// Vertices less edges plus triangles.
    pub euler: i64,
    /// How many pieces it has.
    pub pieces: usize,
}

/// Fails where an edge is not that of exactly two triangles, once in each direction, or the surface is inside out. Corners
/// are known by their place alone, as in an STL file.
pub fn checked(mesh: &Mesh) -> Shape {
    let mut ids: HashMap<[u32; 3], usize> = HashMap::new();
    let places: Vec<usize> = mesh
        .positions
        .iter()
        .map(|p| {
            assert!(p.iter().all(|c| c.is_finite()));
            let next = ids.len();
            *ids.entry(p.map(|c| (c + 0.0).to_bits())).or_insert(next)
        })
        .collect();
    let mut edges: HashMap<[usize; 2], usize> = HashMap::new();
    let mut root: Vec<usize> = (0..ids.len()).collect();
    let mut used = vec![false; ids.len()];
    fn top(root: &mut [usize], mut i: usize) -> usize {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        i
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|i| places[i as usize]);
        assert!(a != b && b != c && c != a, "a triangle without area");
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *edges.entry([from, to]).or_default() += 1;
            used[from] = true;
            let [p, q] = [top(&mut root, from), top(&mut root, to)];
            root[p] = q;
        }
    }
    for (&[from, to], &count) in &edges {
        assert_eq!(count, 1, "an edge of two triangles in the same direction");
        assert!(edges.contains_key(&[to, from]), "an edge of one triangle");
    }
    assert!(mesh.volume_mm3() > 0.0, "inside out");
    let vertices = used.iter().filter(|&&used| used).count();
    Shape {
        euler: vertices as i64 - edges.len() as i64 / 2 + mesh.triangles.len() as i64,
        pieces: (0..root.len()).filter(|&i| used[i] && root[i] == i).count(),
    }
}

/// The volume of capsules along the wire, mm³, by `throws` random places in the cells about it.
pub fn in_capsules(wire: &Wire, size_mm: f64, radius_mm: f64, throws: usize, rng: &mut Rng) -> f64 {
    let (from, to) = wire.domain();
    let count = 4000;
    let places: Vec<[f64; 4]> =
        (0..=count).map(|i| wire.evaluate(from + (to - from) * f64::from(i) / f64::from(count))).collect();
    let side = |c: usize| {
        let each = places.iter().map(move |p| p[c]);
        each.clone().fold(f64::NEG_INFINITY, f64::max) - each.fold(f64::INFINITY, f64::min)
    };
    let scale = size_mm / [0, 1, 2].map(side).into_iter().fold(0.0, f64::max);
    let mut cells: BTreeMap<[i64; 3], Vec<[f64; 3]>> = BTreeMap::new();
    for p in &places {
        let p = [p[0], p[1], p[2]].map(|c| c * scale);
        let [x, y, z] = p.map(|c| (c / radius_mm).floor() as i64);
        for at in (0..27).map(|i| [x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1]) {
            cells.entry(at).or_default().push(p);
        }
    }
    let cells: Vec<_> = cells.into_iter().collect();
    let hits = (0..throws).filter(|_| {
        let (at, places) = &cells[rng.below(cells.len())];
        let p = at.map(|c| (c as f64 + rng.range(0.0, 1.0)) * radius_mm);
        places.iter().any(|q| (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>() < radius_mm * radius_mm)
    });
    hits.count() as f64 / throws as f64 * cells.len() as f64 * radius_mm.powi(3)
}
