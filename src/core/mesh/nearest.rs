//! The nearest point of a mesh, by a tree of boxes.

use super::Mesh;
use crate::geometry::nearest_on_triangle;
use glam::DVec3;

/// A mesh's nearest point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// The nearest point, world units.
    pub point: [f64; 3],
    /// How far that is, world units.
    pub distance: f64,
    /// The triangle it lies on; the lowest of several.
    pub triangle: usize,
    /// That triangle's outward unit normal.
    pub normal: [f64; 3],
}

/// Triangles a leaf holds at most.
const LEAF: usize = 4;

/// Inner: children are the next node and `link`. Leaf: triangles `link..link + count` of the tree's order.
#[derive(Debug, Clone, Copy)]
struct Node {
    low: DVec3,
    high: DVec3,
    link: u32,
    count: u32,
}

impl Node {
    /// Squared distance from the point to the box.
    fn distance_squared(&self, point: DVec3) -> f64 {
        (self.low - point).max(point - self.high).max(DVec3::ZERO).length_squared()
    }
}

/// A triangle as the search wants it.
#[derive(Debug, Clone, Copy)]
struct Leaf {
    corner: DVec3,
    edges: [DVec3; 2],
    triangle: u32,
}

/// A tree of boxes over a mesh's triangles. Built in n log n, asked in about log n.
#[derive(Debug, Clone)]
pub struct Nearest {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

impl Nearest {
    /// The tree for a mesh.
    pub fn new(mesh: &Mesh) -> Nearest {
        let mut leaves: Vec<Leaf> = (0..mesh.triangles().len())
            .map(|i| {
                let [a, b, c] = mesh.corners(i);
                Leaf { corner: a, edges: [b - a, c - a], triangle: i as u32 }
            })
            .collect();
        let mut nodes = Vec::with_capacity(2 * leaves.len() / LEAF + 2);
        split(&mut leaves, 0, &mut nodes);
        Nearest { nodes, leaves }
    }

    /// The mesh's point nearest to `point` (finite, world units).
    pub fn nearest(&self, point: &[f64; 3]) -> Hit {
        let asked = DVec3::from(*point);
        let mut best = (f64::INFINITY, u32::MAX, asked, 0);
        // A balanced tree over u32 triangles is at most 32 deep.
        let mut waiting = [(0u32, 0.0); 40];
        let mut held = 1;
        while held > 0 {
            held -= 1;
            let (mut at, distance) = waiting[held];
            if distance > best.0 {
                continue;
            }
            while self.nodes[at as usize].count == 0 {
                let (left, right) = (at + 1, self.nodes[at as usize].link);
                let to_left = self.nodes[left as usize].distance_squared(asked);
                let to_right = self.nodes[right as usize].distance_squared(asked);
                let (near, far, far_distance) =
                    if to_left <= to_right { (left, right, to_right) } else { (right, left, to_left) };
                if far_distance <= best.0 {
                    waiting[held] = (far, far_distance);
                    held += 1;
                }
                at = near;
            }
            let node = &self.nodes[at as usize];
            for (i, leaf) in self.leaves.iter().enumerate().skip(node.link as usize).take(node.count as usize) {
                let (_, offset) = nearest_on_triangle(asked - leaf.corner, leaf.edges);
                let found = leaf.corner + offset;
                let distance = found.distance_squared(asked);
                if distance < best.0 || distance == best.0 && leaf.triangle < best.1 {
                    best = (distance, leaf.triangle, found, i);
                }
            }
        }
        let [along, across] = self.leaves[best.3].edges;
        Hit {
            point: best.2.to_array(),
            distance: best.0.sqrt(),
            triangle: best.1 as usize,
            normal: along.cross(across).try_normalize().unwrap_or(DVec3::Y).to_array(),
        }
    }
}

/// Builds the tree over `leaves`, which start at `start` in the whole order: halves along the longest axis.
fn split(leaves: &mut [Leaf], start: usize, nodes: &mut Vec<Node>) {
    let at = nodes.len();
    let corners = |leaf: &Leaf| [leaf.corner, leaf.corner + leaf.edges[0], leaf.corner + leaf.edges[1]];
    let (low, high) = leaves
        .iter()
        .flat_map(corners)
        .fold((DVec3::MAX, DVec3::MIN), |(low, high), corner| (low.min(corner), high.max(corner)));
    // Corners are sums of rounded edges: a hair of room keeps a tie from being pruned.
    let room = DVec3::splat(1e-12);
    nodes.push(Node { low: low - room, high: high + room, link: start as u32, count: leaves.len() as u32 });
    if leaves.len() <= LEAF {
        return;
    }
    let middle = |leaf: &Leaf| 3.0 * leaf.corner + leaf.edges[0] + leaf.edges[1];
    let (first, last) = leaves.iter().map(middle).fold((DVec3::MAX, DVec3::MIN), |(l, h), m| (l.min(m), h.max(m)));
    let size = last - first;
    let axis = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
    let half = leaves.len() / 2;
    leaves.select_nth_unstable_by(half, |a, b| {
        middle(a)[axis].total_cmp(&middle(b)[axis]).then(a.triangle.cmp(&b.triangle))
    });
    let (left, right) = leaves.split_at_mut(half);
    nodes[at].count = 0;
    split(left, start, nodes);
    nodes[at].link = nodes.len() as u32;
    split(right, start + half, nodes);
}

#[cfg(test)]
mod tests {
    use super::super::Shape;
    use super::*;
    use crate::rng::Rng;

    #[test]
    fn agrees_with_asking_every_triangle() {
        let mesh = Shape::Creature.mesh();
        let tree = Nearest::new(&mesh);
        let mut rng = Rng::new(1, 5);
        for _ in 0..60 {
            let point = rng.in_ball(1.4);
            let asked = DVec3::from(point);
            let hit = tree.nearest(&point);
            let brute = (0..mesh.triangles().len())
                .map(|i| {
                    let [a, b, c] = mesh.corners(i);
                    (a + nearest_on_triangle(asked - a, [b - a, c - a]).1).distance(asked)
                })
                .fold(f64::INFINITY, f64::min);
            assert!((hit.distance - brute).abs() < 1e-12, "{} {brute}", hit.distance);
            assert!((DVec3::from(hit.point).distance(asked) - hit.distance).abs() < 1e-12);
            assert_eq!(hit.normal, mesh.triangle_normal(hit.triangle));
        }
    }

    #[test]
    fn the_lowest_of_equally_near_triangles_answers() {
        let mesh = Shape::Sphere.mesh();
        let tree = Nearest::new(&mesh);
        for corner in (0..mesh.positions().len()).step_by(97) {
            let out = mesh.positions()[corner].map(|c| 1.5 * c);
            let lowest = mesh.triangles().iter().position(|t| t.contains(&(corner as u32))).unwrap();
            assert_eq!(tree.nearest(&out).triangle, lowest);
        }
    }
}
