//! A small animal: round parts that flow into each other, and the surface where their field is zero.

use super::{EDGE, Triangles};
use glam::{DVec3, IVec3};

/// A round bone: from and to with a radius at each end, and how softly it flows into what came before.
struct Bone {
    ends: [DVec3; 2],
    radii: [f64; 2],
    blend: f64,
}

/// Looks to +x, its feet at y = -0.62.
fn bones() -> Vec<Bone> {
    let mut bones = Vec::new();
    let mut add = |from: [f64; 3], to: [f64; 3], radii: [f64; 2], blend: f64| {
        bones.push(Bone { ends: [DVec3::from(from), DVec3::from(to)], radii, blend });
    };
    // Body, from the rump to the chest, and a neck.
    add([-0.38, -0.08, 0.0], [0.22, -0.06, 0.0], [0.33, 0.29], 0.1);
    add([0.25, 0.02, 0.0], [0.46, 0.28, 0.04], [0.21, 0.2], 0.12);
    // Head, snout and nose, turned a little towards the viewer.
    add([0.47, 0.38, 0.05], [0.55, 0.39, 0.08], [0.29, 0.28], 0.05);
    add([0.66, 0.29, 0.13], [0.86, 0.26, 0.21], [0.17, 0.14], 0.04);
    for side in [-1.0, 1.0] {
        // Ears.
        add(
            [0.44 - 0.03 * side, 0.55, 0.05 + 0.17 * side],
            [0.36 - 0.06 * side, 0.80, 0.05 + 0.29 * side],
            [0.14, 0.1],
            0.04,
        );
        // Legs: fore and hind, the hind with a thigh; feet point forward.
        add([0.27, -0.18, 0.19 * side], [0.30, -0.55, 0.21 * side], [0.15, 0.105], 0.08);
        add([0.30, -0.57, 0.21 * side], [0.39, -0.585, 0.22 * side], [0.1, 0.085], 0.04);
        add([-0.42, -0.16, 0.19 * side], [-0.40, -0.26, 0.23 * side], [0.2, 0.18], 0.08);
        add([-0.42, -0.28, 0.23 * side], [-0.46, -0.56, 0.23 * side], [0.14, 0.105], 0.06);
        add([-0.45, -0.57, 0.23 * side], [-0.35, -0.585, 0.24 * side], [0.1, 0.085], 0.04);
    }
    // A tail that curls up.
    let tail = [[-0.62, 0.06, 0.0], [-0.82, 0.2, 0.0], [-0.93, 0.42, -0.03], [-0.84, 0.63, -0.08], [-0.68, 0.68, -0.1]];
    let radii = [0.13, 0.11, 0.11, 0.12, 0.09];
    for i in 1..tail.len() {
        add(tail[i - 1], tail[i], [radii[i - 1], radii[i]], 0.06);
    }
    bones
}

/// Below zero inside. Distances are joined by the polynomial smooth minimum, which is the minimum but for a rounding
/// of `blend` where both are nearly equal.
fn field(bones: &[Bone], point: DVec3) -> f64 {
    bones.iter().fold(1e3, |nearest: f64, bone| {
        let along = bone.ends[1] - bone.ends[0];
        let share = ((point - bone.ends[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let radius = bone.radii[0] + share * (bone.radii[1] - bone.radii[0]);
        let distance = point.distance(bone.ends[0] + share * along) - radius;
        let overlap = (1.0 - (nearest - distance).abs() / (4.0 * bone.blend)).max(0.0);
        nearest.min(distance) - bone.blend * overlap * overlap
    })
}

/// The animal: surface nets (Gibson 1998) over a grid, then evened along the surface.
pub(super) fn creature() -> Triangles {
    let bones = bones();
    let at = |point: DVec3| field(&bones, point);
    let mut surface = nets(&at);
    for _ in 0..12 {
        even(&mut surface, &at);
    }
    surface
}

/// One corner in every cell that the surface crosses, four cells round a crossed grid edge joined by two triangles.
fn nets(field: &dyn Fn(DVec3) -> f64) -> Triangles {
    // Diagonals make the mean edge longer than the grid's.
    let step = 0.9 * EDGE;
    let across = (2.4 / step).ceil() as i32;
    let place = |cell: IVec3| step * (cell.as_dvec3() - 0.5 * f64::from(across));
    let index = |cell: IVec3| ((cell.z * across + cell.y) * across + cell.x) as usize;
    let cells =
        |to: i32| (0..to).flat_map(move |z| (0..to).flat_map(move |y| (0..to).map(move |x| IVec3::new(x, y, z))));
    let values: Vec<f64> = cells(across).map(|cell| field(place(cell))).collect();
    let mut surface = Triangles::default();
    let mut corner = vec![u32::MAX; values.len()];
    for cell in cells(across - 1) {
        let offsets = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| IVec3::new(i & 1, i >> 1 & 1, i >> 2 & 1));
        let inside = offsets.iter().filter(|&&o| values[index(cell + o)] < 0.0).count();
        if inside % 8 > 0 {
            // Anywhere in the cell will do: evening moves it onto the surface.
            corner[index(cell)] = surface.push(place(cell) + DVec3::splat(0.5 * step));
        }
    }
    let axes = [IVec3::X, IVec3::Y, IVec3::Z];
    for cell in cells(across - 1) {
        for axis in 0..3 {
            let (from, to) = (values[index(cell)] < 0.0, values[index(cell + axes[axis])] < 0.0);
            let (u, v) = (axes[(axis + 1) % 3], axes[(axis + 2) % 3]);
            if from == to || cell.dot(u) == 0 || cell.dot(v) == 0 {
                continue;
            }
            let [a, b, c, d] = [cell - u - v, cell - v, cell, cell - u].map(|around| corner[index(around)]);
            let quad = if from { [a, b, c, d] } else { [d, c, b, a] };
            surface.triangles.push([quad[0], quad[1], quad[2]]);
            surface.triangles.push([quad[0], quad[2], quad[3]]);
        }
    }
    surface
}

/// Moves every corner to the middle of its neighbours, then along the field's slope back to zero.
fn even(surface: &mut Triangles, field: &dyn Fn(DVec3) -> f64) {
    let mut sums = vec![(DVec3::ZERO, 0.0); surface.points.len()];
    for triangle in &surface.triangles {
        for k in 0..3 {
            let (a, b) = (triangle[k] as usize, triangle[(k + 1) % 3] as usize);
            sums[a].0 += surface.points[b];
            sums[a].1 += 1.0;
        }
    }
    const STEP: f64 = 1e-4;
    for (point, (sum, count)) in surface.points.iter_mut().zip(sums) {
        *point = point.lerp(sum / count, 0.5);
        let value = field(*point);
        let slope =
            DVec3::from([DVec3::X, DVec3::Y, DVec3::Z].map(|axis| (field(*point + STEP * axis) - value) / STEP));
        *point -= value * slope / slope.length_squared().max(0.25);
    }
}
