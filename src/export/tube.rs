//! The wire as a solid: a tube of varying radius swept along each strand, closed by round caps (or into a ring).
//!
//! Rings stand across the tangent and are carried along by rotation-minimising frames, the double reflection of Wang,
//! Jüttler, Zheng and Liu (2008). The surface is watertight and consistently wound by construction: every strand is one
//! grid of rings, closed by two poles (a sphere, V - E + F = 2) or into itself (a torus, V - E + F = 0).
//!
//! Where the wire turns sharper than its own radius (cusps, U-turns), ring planes must cross. Rings are then added that
//! turn about the corner in small steps, so that the outside is the ball a round wire shows there, and the surface that
//! folds over stays inside the wire. The radius is never reduced: that would pinch the wire at every U-turn. Strands
//! that pass through each other are not merged.

use super::TriangleMesh;
use crate::sculpture::Strand;
use glam::{DQuat, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// How finely [`tube`] meshes the wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TubeOptions {
    /// Vertices a ring; at least 3.
    pub sides: usize,
    /// Thinner parts are drawn this thick, so that the solid stays in one piece; world units.
    pub min_radius_world: f64,
    /// How far centre line and radius may be off between two rings; world units.
    pub tolerance_world: f64,
    /// The most the tangent may turn from one ring to the next; radians.
    pub max_turn_rad: f64,
}

impl Default for TubeOptions {
    fn default() -> Self {
        // 2e-4 is a fortieth of a pixel at 256; 20° keeps the narrowing at a bisected corner under 1.6%.
        TubeOptions { sides: 10, min_radius_world: 1e-3, tolerance_world: 2e-4, max_turn_rad: 20f64.to_radians() }
    }
}

/// One watertight tube for each strand, outward normals, triangles counter-clockwise seen from outside.
pub fn tube(strands: &[Strand], options: &TubeOptions) -> TriangleMesh {
    let mut mesh = TriangleMesh::default();
    let sides = options.sides.max(3);
    for strand in strands {
        let line = CentreLine::new(strand, options);
        if line.points.is_empty() {
            continue;
        }
        let rings = line.rings(options);
        sweep(&mut mesh, &rings, line.closed, sides);
    }
    mesh
}

/// Distinct points and radii, thinned to the tolerance.
struct CentreLine {
    points: Vec<DVec3>,
    radii: Vec<f64>,
    closed: bool,
}

/// Points nearer than this give no usable direction; world units.
const COINCIDENT_WORLD: f64 = 1e-7;
/// No ring is left out for longer than this many samples, which bounds the work of thinning.
const MAX_SKIP: usize = 64;

impl CentreLine {
    fn new(strand: &Strand, options: &TubeOptions) -> CentreLine {
        let mut line = CentreLine { points: Vec::new(), radii: Vec::new(), closed: strand.closed };
        for p in &strand.points {
            let radius = (p[3] / 2.0).max(options.min_radius_world);
            line.push(DVec3::new(p[0], p[1], p[2]), radius);
        }
        while line.closed && line.points.len() > 1 {
            let last = line.points.len() - 1;
            if line.points[0].distance(line.points[last]) > COINCIDENT_WORLD {
                break;
            }
            line.radii[0] = line.radii[0].max(line.radii[last]);
            line.points.pop();
            line.radii.pop();
        }
        line.closed &= line.points.len() >= 3;
        line.thin(options);
        line
    }

    fn push(&mut self, point: DVec3, radius: f64) {
        if let (Some(last), Some(last_radius)) = (self.points.last(), self.radii.last_mut())
            && last.distance(point) <= COINCIDENT_WORLD
        {
            *last_radius = last_radius.max(radius);
            return;
        }
        self.points.push(point);
        self.radii.push(radius);
    }

    /// Greedily leaves out samples that a straight cone between their neighbours stands for within the tolerance.
    fn thin(&mut self, options: &TubeOptions) {
        let count = self.points.len();
        if count < 3 {
            return;
        }
        let mut kept = vec![0];
        let mut from = 0;
        while from + 1 < count {
            let mut to = from + 1;
            while to + 1 < count && to + 1 - from <= MAX_SKIP && self.straight(from, to + 1, options) {
                to += 1;
            }
            kept.push(to);
            from = to;
        }
        if self.closed && kept.len() < 3 {
            kept = (0..count).collect();
        }
        self.points = kept.iter().map(|&i| self.points[i]).collect();
        self.radii = kept.iter().map(|&i| self.radii[i]).collect();
    }

    fn straight(&self, from: usize, to: usize, options: &TubeOptions) -> bool {
        let (start, along) = (self.points[from], self.points[to] - self.points[from]);
        let squared = along.length_squared();
        if squared <= COINCIDENT_WORLD * COINCIDENT_WORLD {
            return false;
        }
        let mut last_s = 0.0;
        (from + 1..to).all(|i| {
            let s = (self.points[i] - start).dot(along) / squared;
            let ahead = s > last_s && s < 1.0;
            last_s = s;
            let off_axis = (start + along * s).distance(self.points[i]);
            let off_radius = (self.radii[from] + (self.radii[to] - self.radii[from]) * s - self.radii[i]).abs();
            ahead && off_axis.max(off_radius) <= options.tolerance_world
        })
    }

    /// Rings with their frames. Closed lines get the twist that is left over spread along their length.
    fn rings(&self, options: &TubeOptions) -> Vec<Ring> {
        let count = self.points.len();
        if count == 1 {
            let [centre, radius] = [self.points[0], DVec3::splat(self.radii[0])];
            return vec![Ring { centre, tangent: DVec3::Z, normal: DVec3::X, radius: radius.x, slope: 0.0, s: 0.0 }];
        }
        let segments = if self.closed { count } else { count - 1 };
        let direction = |i: usize| (self.points[(i + 1) % count] - self.points[i]).normalize();
        let length = |i: usize| self.points[(i + 1) % count].distance(self.points[i]);
        let grade = |i: usize| (self.radii[(i + 1) % count] - self.radii[i]) / length(i);
        let mut rings: Vec<Ring> = Vec::with_capacity(count + 16);
        let mut s = 0.0;
        for i in 0..count {
            let (before, after) = match (self.closed, i) {
                (true, _) => ((i + segments - 1) % segments, i),
                (false, 0) => (0, 0),
                (false, _) => (i - 1, i.min(segments - 1)),
            };
            let slope = (grade(before) + grade(after)) / 2.0;
            for tangent in corner(direction(before), direction(after), options.max_turn_rad) {
                let ring =
                    Ring { centre: self.points[i], tangent, normal: DVec3::ZERO, radius: self.radii[i], slope, s };
                rings.push(ring);
            }
            if i < segments {
                s += length(i);
            }
        }
        rings[0].normal = rings[0].tangent.any_orthonormal_vector();
        for k in 1..rings.len() {
            rings[k].normal = transport(&rings[k - 1], &rings[k]);
        }
        if self.closed {
            let last = rings.len() - 1;
            let (first, carried) = (rings[0], transport(&rings[last], &rings[0]));
            let twist = carried.cross(first.normal).dot(first.tangent).atan2(carried.dot(first.normal));
            for ring in &mut rings {
                ring.normal = DQuat::from_axis_angle(ring.tangent, twist * ring.s / s) * ring.normal;
            }
        }
        rings
    }
}

/// A circle across the wire.
#[derive(Debug, Clone, Copy)]
struct Ring {
    centre: DVec3,
    tangent: DVec3,
    /// Unit, square to the tangent: where the ring's angle is 0.
    normal: DVec3,
    radius: f64,
    /// Change of radius along the wire, for the shading normal.
    slope: f64,
    /// Arc length from the start.
    s: f64,
}

/// Tangents of the rings at a corner: the bisector, or small steps from `before` to `after` where it is sharp.
fn corner(before: DVec3, after: DVec3, max_turn_rad: f64) -> Vec<DVec3> {
    let turn = before.angle_between(after);
    if turn <= max_turn_rad {
        return vec![(before + after).normalize()];
    }
    let axis = before.cross(after).try_normalize().unwrap_or_else(|| before.any_orthonormal_vector());
    let steps = (turn / max_turn_rad).ceil() as usize;
    (0..=steps)
        .map(|k| DQuat::from_axis_angle(axis, turn * k as f64 / steps as f64) * before)
        .map(DVec3::normalize)
        .collect()
}

/// Carries `from`'s normal to `to` by double reflection; by the smallest rotation where the rings share a centre.
fn transport(from: &Ring, to: &Ring) -> DVec3 {
    let v1 = to.centre - from.centre;
    let c1 = v1.length_squared();
    let carried = if c1 <= COINCIDENT_WORLD * COINCIDENT_WORLD {
        DQuat::from_rotation_arc(from.tangent, to.tangent) * from.normal
    } else {
        let reflect = |v: DVec3| v - v1 * (2.0 / c1 * v1.dot(v));
        let (normal, tangent) = (reflect(from.normal), reflect(from.tangent));
        let v2 = to.tangent - tangent;
        let c2 = v2.length_squared();
        if c2 <= f64::EPSILON { normal } else { normal - v2 * (2.0 / c2 * v2.dot(normal)) }
    };
    // Against drift: exactly square and of unit length.
    (carried - to.tangent * carried.dot(to.tangent))
        .try_normalize()
        .unwrap_or_else(|| to.tangent.any_orthonormal_vector())
}

/// Adds the rings' surface, with caps or closed into itself.
fn sweep(mesh: &mut TriangleMesh, rings: &[Ring], closed: bool, sides: usize) {
    let first = mesh.positions.len() as u32;
    let n = sides as u32;
    let (start, end) = (&rings[0], &rings[rings.len() - 1]);
    let cap_steps = sides.div_ceil(4).max(2);
    if !closed {
        for k in 1..cap_steps {
            add_latitude(mesh, start, -FRAC_PI_2 * (cap_steps - k) as f64 / cap_steps as f64, sides);
        }
    }
    for ring in rings {
        add_ring(mesh, ring, sides, |radial| (radial - ring.tangent * ring.slope).normalize());
    }
    if !closed {
        for k in 1..cap_steps {
            add_latitude(mesh, end, FRAC_PI_2 * k as f64 / cap_steps as f64, sides);
        }
    }
    let rows = (mesh.positions.len() as u32 - first) / n;
    for row in 0..if closed { rows } else { rows - 1 } {
        let (a, b) = (first + row * n, first + (row + 1) % rows * n);
        for j in 0..n {
            let next = (j + 1) % n;
            mesh.triangles.push([a + j, a + next, b + j]);
            mesh.triangles.push([a + next, b + next, b + j]);
        }
    }
    if !closed {
        let start_pole = mesh.add(start.centre - start.tangent * start.radius, -start.tangent);
        let end_pole = mesh.add(end.centre + end.tangent * end.radius, end.tangent);
        let last = first + (rows - 1) * n;
        for j in 0..n {
            let next = (j + 1) % n;
            mesh.triangles.push([start_pole, first + next, first + j]);
            mesh.triangles.push([last + j, last + next, end_pole]);
        }
    }
}

/// A circle of latitude of the ball at `ring`; latitude 0 is the ring itself, positive ahead.
fn add_latitude(mesh: &mut TriangleMesh, ring: &Ring, latitude_rad: f64, sides: usize) {
    let (sin, cos) = latitude_rad.sin_cos();
    let circle = Ring { centre: ring.centre + ring.tangent * (ring.radius * sin), radius: ring.radius * cos, ..*ring };
    add_ring(mesh, &circle, sides, |radial| (radial * cos + ring.tangent * sin).normalize());
}

fn add_ring(mesh: &mut TriangleMesh, ring: &Ring, sides: usize, normal: impl Fn(DVec3) -> DVec3) {
    let binormal = ring.tangent.cross(ring.normal);
    for j in 0..sides {
        // Half a step off, so that no vertex lies on the axis a flat wire's corners turn about.
        let (sin, cos) = (TAU * j as f64 / sides as f64 + PI / sides as f64).sin_cos();
        let radial = ring.normal * cos + binormal * sin;
        mesh.add(ring.centre + radial * ring.radius, normal(radial));
    }
}
