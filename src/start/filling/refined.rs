//! A mesh cut where it is not a surface, refined until a line every spacing can be told on it.

use super::SPACINGS_WORLD;
use crate::error::{Error, Result};
use crate::geometry::{DisjointSets, nearest_on_triangle};
use crate::mesh::Mesh;
use glam::DVec3;

/// No triangle on that side, no such vertex.
pub const NONE: u32 = u32::MAX;
/// Triangles a refined mesh may have: half a gigabyte with everything that hangs on them.
const MOST_TRIANGLES: usize = 2_500_000;
/// Triangles that refinement makes for every square of half a spacing.
const TRIANGLES_A_SQUARE: f64 = 5.0;

/// An edge, its two ends and the one or two triangles beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    pub ends: [u32; 2],
    pub faces: [u32; 2],
}

impl Edge {
    pub fn is_rim(&self) -> bool {
        self.faces[1] == NONE
    }
}

/// Triangles of which at most two meet at an edge.
#[derive(Debug, Clone, Default)]
pub struct RefinedMesh {
    pub points: Vec<DVec3>,
    /// Unit normals, averaged round each vertex by area.
    pub normals: Vec<DVec3>,
    pub triangles: Vec<[u32; 3]>,
    pub edges: Vec<Edge>,
    /// Edges of each triangle; edge `k` runs from corner `k` to the next.
    pub edges_of: Vec<[u32; 3]>,
    /// Triangles round each vertex: those of vertex `v` are `fans[fan_starts[v]..fan_starts[v + 1]]`.
    fans: Vec<u32>,
    fan_starts: Vec<u32>,
    /// The connected part each vertex belongs to.
    pub part_of: Vec<u32>,
    pub parts: usize,
}

impl RefinedMesh {
    /// As [`RefinedMesh::named`], of a mesh without a name.
    ///
    /// # Errors
    /// As [`RefinedMesh::named`].
    pub fn new(mesh: &Mesh, longest: f64) -> Result<RefinedMesh> {
        RefinedMesh::named("mesh", mesh, longest)
    }

    /// `mesh`, which the person calls `name`, with no edge longer than `longest`.
    ///
    /// # Errors
    /// If that takes too many triangles: [`Error::Setting`] for `curve_spacing` where a coarser one would do, else
    /// [`Error::Input`].
    pub fn named(name: &str, mesh: &Mesh, longest: f64) -> Result<RefinedMesh> {
        let points: Vec<DVec3> = mesh.positions().iter().map(|&p| DVec3::from(p)).collect();
        let whole = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
        let triangles: Vec<[u32; 3]> = mesh.triangles().iter().copied().filter(whole).collect();
        let mut surface = RefinedMesh { points, triangles, ..RefinedMesh::default() };
        let needed = surface.triangles.len() as f64 + TRIANGLES_A_SQUARE * surface.area() / (longest * longest);
        if needed > MOST_TRIANGLES as f64 {
            return Err(too_fine(name, longest * (needed / MOST_TRIANGLES as f64).sqrt()));
        }
        surface.pair_triangles();
        surface.cut();
        loop {
            surface.pair_triangles();
            if !surface.split_edges(longest) {
                break;
            }
            if surface.triangles.len() > MOST_TRIANGLES {
                return Err(too_fine(name, 2.0 * longest));
            }
        }
        surface.find_fans();
        surface.find_parts();
        surface.find_normals();
        Ok(surface)
    }

    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|v| self.points[v as usize])
    }

    /// Normal of a triangle, of length twice its area.
    pub fn area_normal(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        (b - a).cross(c - a)
    }

    /// The connected part a triangle belongs to.
    pub fn part(&self, triangle: u32) -> u32 {
        self.part_of[self.triangles[triangle as usize][0] as usize]
    }

    /// Area of each part.
    pub fn part_areas(&self) -> Vec<f64> {
        let mut areas = vec![0.0; self.parts];
        for t in 0..self.triangles.len() as u32 {
            areas[self.part(t) as usize] += 0.5 * self.area_normal(t).length();
        }
        areas
    }

    pub fn area(&self) -> f64 {
        (0..self.triangles.len() as u32).map(|t| 0.5 * self.area_normal(t).length()).sum()
    }

    pub fn fan(&self, vertex: u32) -> &[u32] {
        &self.fans[self.fan_starts[vertex as usize] as usize..self.fan_starts[vertex as usize + 1] as usize]
    }

    /// The vertices' normals, weighted by `at`.
    pub fn normal_at(&self, triangle: u32, at: [f64; 3]) -> DVec3 {
        let corners = self.triangles[triangle as usize];
        let sum: DVec3 = (0..3).map(|k| at[k] * self.normals[corners[k] as usize]).sum();
        sum.normalize_or(self.normals[corners[0] as usize])
    }

    /// From a point to a triangle.
    pub fn distance_squared(&self, point: DVec3, triangle: u32) -> f64 {
        nearest_in_triangle(point, self.corners(triangle)).1.distance_squared(point)
    }

    /// The nearest point of the surface that can be walked to from `triangle` with every step coming nearer:
    /// the triangle it is on, its weights there and the point.
    pub fn nearest_from(&self, point: DVec3, triangle: u32) -> (u32, [f64; 3], DVec3) {
        let found = |t: u32| {
            let (weights, on) = nearest_in_triangle(point, self.corners(t));
            (point.distance_squared(on), t, weights, on)
        };
        let mut best = found(triangle);
        loop {
            let (before, at) = (best.0, best.1);
            for &corner in &self.triangles[at as usize] {
                for &t in self.fan(corner) {
                    let candidate = found(t);
                    if candidate.0 < best.0 {
                        best = candidate;
                    }
                }
            }
            if best.0 >= before {
                return (best.1, best.2, best.3);
            }
        }
    }

    /// Distance of every vertex to the rim along edges; infinite where there is none.
    pub fn rim_distances(&self) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.points.len()];
        let rim = || self.edges.iter().filter(|edge| edge.is_rim());
        if rim().next().is_none() {
            return distances;
        }
        let mut queue = std::collections::BinaryHeap::new();
        // Distances are not negative, so their bits sort as they do.
        let key = |distance: f64, vertex: u32| std::cmp::Reverse((distance.to_bits(), vertex));
        for vertex in rim().flat_map(|edge| edge.ends) {
            distances[vertex as usize] = 0.0;
            queue.push(key(0.0, vertex));
        }
        while let Some(std::cmp::Reverse((bits, vertex))) = queue.pop() {
            let reached = f64::from_bits(bits);
            if reached > distances[vertex as usize] {
                continue;
            }
            for other in self.fan(vertex).iter().flat_map(|&t| self.triangles[t as usize]) {
                let there = reached + self.points[vertex as usize].distance(self.points[other as usize]);
                if there < distances[other as usize] {
                    distances[other as usize] = there;
                    queue.push(key(there, other));
                }
            }
        }
        distances
    }

    /// Finds the edges. Where more than two triangles meet, the flattest pairs stay together and the rest get a rim.
    fn pair_triangles(&mut self) {
        let mut sides: Vec<([u32; 2], u32, usize)> = Vec::with_capacity(3 * self.triangles.len());
        for (t, corners) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                sides.push(([a.min(b), a.max(b)], t as u32, k));
            }
        }
        sides.sort_unstable();
        self.edges = Vec::with_capacity(sides.len() / 2 + 1);
        self.edges_of = vec![[NONE; 3]; self.triangles.len()];
        for group in sides.chunk_by(|a, b| a.0 == b.0) {
            let mut left = group.to_vec();
            while !left.is_empty() {
                let (first, second) = self.flattest(&left);
                let edge = self.edges.len() as u32;
                let faces = [left[first].1, second.map_or(NONE, |j| left[j].1)];
                for side in std::iter::once(first).chain(second) {
                    self.edges_of[left[side].1 as usize][left[side].2] = edge;
                }
                self.edges.push(Edge { ends: left[0].0, faces });
                let mut place = 0;
                left.retain(|_| {
                    place += 1;
                    place - 1 != first && Some(place - 1) != second
                });
            }
        }
    }

    /// Of the triangles at one edge the two that lie flattest against each other, or the only one.
    fn flattest(&self, sides: &[([u32; 2], u32, usize)]) -> (usize, Option<usize>) {
        if sides.len() <= 2 {
            return (0, (sides.len() == 2).then_some(1));
        }
        // Away from the edge, in the plane of the triangle.
        let outward = |&(ends, t, k): &([u32; 2], u32, usize)| {
            let [a, b] = ends.map(|v| self.points[v as usize]);
            let apex = self.points[self.triangles[t as usize][(k + 2) % 3] as usize] - a;
            (apex - apex.project_onto_normalized((b - a).normalize_or(DVec3::X))).normalize_or_zero()
        };
        let mut best = (f64::INFINITY, 0, None);
        for i in 0..sides.len() {
            for j in i + 1..sides.len() {
                let fold = outward(&sides[i]).dot(outward(&sides[j]));
                if fold < best.0 {
                    best = (fold, i, Some(j));
                }
            }
        }
        (best.1, best.2)
    }

    /// Gives every fan of triangles that hang together by edges a vertex of its own.
    fn cut(&mut self) {
        let mut classes = DisjointSets::new(3 * self.triangles.len());
        for edge in self.edges.iter().filter(|edge| !edge.is_rim()) {
            for end in edge.ends {
                let corner = |face: u32| {
                    let place = self.triangles[face as usize].iter().position(|&v| v == end).unwrap_or(0);
                    3 * face as usize + place
                };
                classes.join(corner(edge.faces[0]), corner(edge.faces[1]));
            }
        }
        let mut vertex_of = vec![NONE; 3 * self.triangles.len()];
        let mut points = Vec::with_capacity(self.points.len());
        for t in 0..self.triangles.len() {
            for k in 0..3 {
                let class = classes.root(3 * t + k);
                if vertex_of[class] == NONE {
                    vertex_of[class] = points.len() as u32;
                    points.push(self.points[self.triangles[t][k] as usize]);
                }
                self.triangles[t][k] = vertex_of[class];
            }
        }
        self.points = points;
    }

    /// Halves every edge longer than `longest`; whether there were any.
    fn split_edges(&mut self, longest: f64) -> bool {
        let mut middle_of = vec![NONE; self.edges.len()];
        for (edge, middle) in self.edges.iter().zip(&mut middle_of) {
            let [a, b] = edge.ends.map(|v| self.points[v as usize]);
            if a.distance_squared(b) > longest * longest {
                *middle = self.points.len() as u32;
                self.points.push(0.5 * (a + b));
            }
        }
        let mut triangles = Vec::with_capacity(2 * self.triangles.len());
        for (corners, edges) in self.triangles.iter().zip(&self.edges_of) {
            let middles = edges.map(|edge| middle_of[edge as usize]);
            let whole = middles.iter().filter(|&&m| m == NONE).count();
            // Turned so that the odd edge out comes first.
            let odd = match whole {
                1 => middles.iter().position(|&m| m == NONE),
                2 => middles.iter().position(|&m| m != NONE),
                _ => None,
            }
            .unwrap_or(0);
            let ([a, b, c], [ab, bc, ca]) =
                ([0, 1, 2].map(|k| corners[(k + odd) % 3]), [0, 1, 2].map(|k| middles[(k + odd) % 3]));
            let point = |v: u32| self.points[v as usize];
            match whole {
                0 => triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]),
                1 if point(a).distance_squared(point(bc)) < point(b).distance_squared(point(ca)) => {
                    triangles.extend([[a, b, bc], [a, bc, ca], [ca, bc, c]]);
                }
                1 => triangles.extend([[a, b, ca], [b, bc, ca], [ca, bc, c]]),
                2 => triangles.extend([[a, ab, c], [ab, b, c]]),
                _ => triangles.push([a, b, c]),
            }
        }
        let split = triangles.len() > self.triangles.len();
        self.triangles = triangles;
        split
    }

    fn find_fans(&mut self) {
        self.fan_starts = vec![0; self.points.len() + 1];
        for &v in self.triangles.iter().flatten() {
            self.fan_starts[v as usize + 1] += 1;
        }
        for v in 0..self.points.len() {
            self.fan_starts[v + 1] += self.fan_starts[v];
        }
        let mut next = self.fan_starts.clone();
        self.fans = vec![0; 3 * self.triangles.len()];
        for (t, corners) in self.triangles.iter().enumerate() {
            for &v in corners {
                self.fans[next[v as usize] as usize] = t as u32;
                next[v as usize] += 1;
            }
        }
    }

    fn find_parts(&mut self) {
        let mut classes = DisjointSets::new(self.points.len());
        for edge in &self.edges {
            classes.join(edge.ends[0] as usize, edge.ends[1] as usize);
        }
        let mut name_of = vec![NONE; self.points.len()];
        self.part_of = vec![0; self.points.len()];
        self.parts = 0;
        for v in 0..self.points.len() {
            let class = classes.root(v);
            if name_of[class] == NONE {
                name_of[class] = self.parts as u32;
                self.parts += 1;
            }
            self.part_of[v] = name_of[class];
        }
    }

    fn find_normals(&mut self) {
        let mut sums = vec![DVec3::ZERO; self.points.len()];
        for (t, corners) in self.triangles.iter().enumerate() {
            let normal = self.area_normal(t as u32);
            for &v in corners {
                sums[v as usize] += normal;
            }
        }
        self.normals = sums.into_iter().map(|sum| sum.normalize_or(DVec3::Y)).collect();
    }
}

/// Refuses a mesh of which no edge may be longer than wanted, only than `longest`.
fn too_fine(name: &str, longest: f64) -> Error {
    let works = (2.0 * longest * 1000.0).ceil() / 1000.0;
    if works > *SPACINGS_WORLD.end() {
        let problem = "has too many triangles, or too many long thin ones, to be covered";
        return Error::input(name, problem, "remesh or decimate it to fewer triangles of even size");
    }
    Error::setting("curve_spacing", "is too fine for this mesh", format!("use {works} or more"))
}

/// The nearest point of a triangle: its weights on the corners, and itself.
pub fn nearest_in_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> ([f64; 3], DVec3) {
    let ([v, w], offset) = nearest_on_triangle(p - a, [b - a, c - a]);
    ([1.0 - v - w, v, w], a + offset)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Shape;

    #[test]
    fn refining_keeps_the_surface() {
        for (shape, longest) in [(Shape::Sphere, 0.04), (Shape::Creature, 0.02), (Shape::Torus, 0.5)] {
            let mesh = shape.mesh();
            let surface = RefinedMesh::new(&mesh, longest).unwrap();
            assert!((surface.area() - mesh.area()).abs() < 1e-9 * mesh.area());
            assert_eq!(surface.parts, 1);
            for edge in &surface.edges {
                let [a, b] = edge.ends.map(|v| surface.points[v as usize]);
                assert!(a.distance(b) <= longest && !edge.is_rim(), "closed shapes stay closed");
            }
            assert!((surface.part_areas()[0] - surface.area()).abs() < 1e-9);
        }
    }

    #[test]
    fn three_sheets_at_an_edge_are_cut_apart() {
        let positions = vec![[0.0, 0.0, -0.5], [0.0, 0.0, 0.5], [0.5, 0.05, 0.0], [-0.5, 0.0, 0.0], [0.0, 0.5, 0.0]];
        let mesh = Mesh::new("fin", positions, vec![[0, 1, 2], [1, 0, 3], [0, 1, 4]]).unwrap();
        let surface = RefinedMesh::new(&mesh, 0.1).unwrap();
        assert_eq!(surface.parts, 2);
        let flat = surface.part_areas()[surface.part(0) as usize];
        assert!((flat - 0.25 - 0.5 * 0.5f64.hypot(0.05)).abs() < 1e-9, "the two flattest stay together: {flat}");
    }

    #[test]
    fn distances_to_the_rim_are_those_of_the_square() {
        let surface = RefinedMesh::new(&super::super::testing::sheet(20), 0.03).unwrap();
        for (point, distance) in surface.points.iter().zip(surface.rim_distances()) {
            let wanted = (0.5 - point.x.abs()).min(0.5 - point.y.abs());
            assert!(distance > wanted - 1e-9 && distance < 1.2 * wanted + 0.01, "{distance} not {wanted}");
        }
        let sphere = RefinedMesh::new(&Shape::Sphere.mesh(), 0.1).unwrap();
        assert!(sphere.rim_distances().iter().all(|distance| distance.is_infinite()));
    }

    #[test]
    fn what_is_too_fine_is_refused_with_what_works() {
        let refused = |factor: f64| {
            let large = super::super::testing::sheet(1).positions().iter().map(|p| p.map(|c| factor * c)).collect();
            let mesh = Mesh::new("large", large, vec![[0, 1, 3]]).unwrap();
            RefinedMesh::named("large.obj", &mesh, 0.03).unwrap_err().to_string()
        };
        let error = refused(50.0);
        assert!(error.starts_with("curve_spacing: is too fine"), "{error}");
        let works: f64 = error.split("use ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap();
        assert!(works > 0.06 && works <= 0.2, "{works}");
        assert!(refused(1e3).starts_with("large.obj: has too many triangles"), "no spacing that is allowed would do");
    }

    #[test]
    fn needles_without_end_are_the_meshs_fault() {
        let ends = (0..100_000u32).map(|k| f64::from(k) * 1e-6);
        let positions = ends.flat_map(|y| [[-1.0, y, 0.0], [1.0, y, 0.0], [1.0, y + 1e-7, 0.0]]).collect();
        let triangles = (0..100_000).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        let mesh = Mesh::new("needles", positions, triangles).unwrap();
        let error = RefinedMesh::named("needles.obj", &mesh, 0.075).unwrap_err().to_string();
        assert!(error.starts_with("needles.obj: ") && error.contains("long thin"), "{error}");
    }
}
