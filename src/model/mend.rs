//! From any triangles to a mesh fit to be covered, with a word on what had to be mended.

use super::sides::{OPEN, drop_doubles, link, orient, separate, thin_out};
use super::weld::weld;
use crate::mesh::{Mesh, fit_unit_ball};
use crate::read::{Soup, Up};
use crate::{Error, Result};
use glam::DVec3;

/// Parts with less than this share of the area are dropped.
const SPECK: f64 = 1e-5;

/// A mesh as it was read, made fit to be covered.
#[derive(Debug, Clone, PartialEq)]
pub struct Mended {
    /// The mesh: in the unit ball and touching it; at most two triangles at an edge, one fan of triangles at a corner;
    /// every part of it turned the same way and outward; no triangle twice, none without an area, no corner unused.
    pub mesh: Mesh,
    /// What was mended, a plain sentence each.
    pub notes: Vec<String>,
    /// How many parts hang together by edges.
    pub parts: usize,
    /// Edges with one triangle only: 0 if the mesh is closed.
    pub open_edges: usize,
    /// The axis of the file that was taken for up; it is y here.
    pub up: Up,
}

/// Mends what `name` holds, in which `up` was up.
///
/// # Errors
/// [`Error::Input`] as [`Mesh::new`], and for triangles that all together have no area.
pub(super) fn mend(name: &str, soup: Soup, up: Up) -> Result<Mended> {
    let (mut positions, mut triangles) = Mesh::new(name, soup.positions, soup.triangles)?.into_parts();
    let mut notes = soup.notes;
    let flat = || Err(Error::input(name, "its triangles have no area", "give a mesh with a surface"));
    if !into_unit_box(&mut positions, &triangles) {
        return flat();
    }
    let places = |t: &[u32; 3]| t.map(|corner| DVec3::from(positions[corner as usize]));
    let cross = |t: &[u32; 3]| {
        let [a, b, c] = places(t);
        (b - a).cross(c - a)
    };
    // However small, some triangle is no line by its own measure.
    let has_area = triangles.iter().any(|t| {
        let [a, b, c] = places(t);
        cross(t).length() > 1e-6 * a.distance_squared(b).max(a.distance_squared(c))
    });
    let before = positions.len();
    let welded = weld(&positions);
    for triangle in &mut triangles {
        *triangle = triangle.map(|corner| welded[corner as usize]);
    }
    let kept = welded.iter().enumerate().filter(|&(i, &to)| i == to as usize).count();
    note(
        &mut notes,
        before - kept,
        "corner was welded to another in the same place",
        "corners were welded to others in the same place",
    );

    let area = |t: &[u32; 3]| 0.5 * cross(t).length();
    let before = triangles.len();
    triangles.retain(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && area(t) > 1e-15);
    note(
        &mut notes,
        before - triangles.len(),
        "triangle without an area was dropped",
        "triangles without an area were dropped",
    );
    let before = triangles.len();
    drop_doubles(&mut triangles);
    note(&mut notes, before - triangles.len(), "duplicate triangle was dropped", "duplicate triangles were dropped");

    let (mut links, cut) = link(&triangles);
    note(&mut notes, cut, "edge with more than two triangles was cut", "edges with more than two triangles were cut");
    let (part, flipped) = orient(&mut triangles, &mut links);
    let parts = part.iter().max().map_or(0, |&most| most as usize + 1);
    let (mut areas, mut middles) = (vec![0.0; parts], vec![DVec3::ZERO; parts]);
    for (t, &part) in triangles.iter().zip(&part) {
        areas[part as usize] += area(t);
        middles[part as usize] += area(t) / 3.0 * t.iter().map(|&c| DVec3::from(positions[c as usize])).sum::<DVec3>();
    }
    let total: f64 = areas.iter().sum();
    if total.is_nan() || total <= 1e-12 {
        if has_area {
            let problem = "has only parts that are too small for how far apart they lie";
            return Err(Error::input(name, problem, "remove those that lie far away or bring them together"));
        }
        return flat();
    }
    // Six times the volume as seen from each part's middle: below zero if most of it faces inward.
    let mut volumes = vec![0.0; parts];
    for (t, &part) in triangles.iter().zip(&part) {
        let middle = middles[part as usize] / areas[part as usize].max(f64::MIN_POSITIVE);
        volumes[part as usize] += cross(t).dot(DVec3::from(positions[t[0] as usize]) - middle);
    }
    let mut turned = 0;
    for i in 0..triangles.len() {
        let inward = volumes[part[i] as usize] < 0.0;
        if inward {
            triangles[i].swap(1, 2);
            links[i].swap(0, 2);
        }
        turned += usize::from(inward != flipped[i]);
    }
    note(&mut notes, turned, "triangle was turned to face outward", "triangles were turned to face outward");

    let specks = areas.iter().filter(|&&area| area < SPECK * total).count();
    note(&mut notes, specks, "speck was dropped", "specks were dropped");
    let keep: Vec<bool> = part.iter().map(|&part| areas[part as usize] >= SPECK * total).collect();
    let (mut positions, mut split) = separate(&positions, &mut triangles, &links, &keep);
    let mut kept = keep.iter();
    triangles.retain(|_| *kept.next().unwrap_or(&false));
    // A surface that runs into itself may pass the same edge twice even so.
    let mut dropped = 0;
    let (parts, open_edges) = loop {
        let thinned = thin_out(&mut triangles);
        dropped += thinned;
        let (mut links, _) = link(&triangles);
        let (part, _) = orient(&mut triangles, &mut links);
        let (separated, added) = separate(&positions, &mut triangles, &links, &vec![true; part.len()]);
        (positions, split) = (separated, split + added);
        if thinned == 0 {
            let open = links.iter().flatten().filter(|&&link| link == OPEN).count();
            break (part.iter().max().map_or(0, |&most| most as usize + 1), open);
        }
    };
    let what = "dropped where a surface runs into itself";
    note(&mut notes, dropped, &format!("triangle was {what}"), &format!("triangles were {what}"));
    note(
        &mut notes,
        split,
        "corner was split where surfaces only touch",
        "corners were split where surfaces only touch",
    );
    note(
        &mut notes,
        open_edges,
        "edge is open: the mesh has a hole",
        "edges are open: the mesh has holes or is a sheet",
    );
    if parts > 1 {
        notes.push(format!("{parts} parts do not hang together"));
    }
    fit_unit_ball(&mut positions);
    Ok(Mended { mesh: Mesh::new(name, positions, triangles)?, notes, parts, open_edges, up })
}

fn note(notes: &mut Vec<String>, count: usize, one: &str, many: &str) {
    match count {
        0 => {}
        1 => notes.push(format!("1 {one}")),
        _ => notes.push(format!("{count} {many}")),
    }
}

/// Moves what the triangles use into the box from -1 to 1, whatever its size: squares neither overflow nor vanish.
/// False if it has no size.
fn into_unit_box(positions: &mut [[f64; 3]], triangles: &[[u32; 3]]) -> bool {
    let (mut low, mut high) = (DVec3::MAX, DVec3::MIN);
    for &corner in triangles.iter().flatten() {
        let point = DVec3::from(positions[corner as usize]);
        (low, high) = (low.min(point), high.max(point));
    }
    let (middle, half) = (0.5 * low + 0.5 * high, (0.5 * high - 0.5 * low).max_element());
    if half < 1e-300 {
        return false;
    }
    for point in positions {
        // What no triangle uses may lie anywhere.
        *point = ((DVec3::from(*point) - middle) / half).clamp(DVec3::splat(-1.0), DVec3::splat(1.0)).to_array();
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Shape;
    use crate::rng::Rng;

    fn mend(name: &str, soup: Soup) -> Result<Mended> {
        super::mend(name, soup, Up::Y)
    }

    fn soup(mesh: &Mesh) -> Soup {
        Soup { positions: mesh.positions().to_vec(), triangles: mesh.triangles().to_vec(), ..Soup::default() }
    }

    fn volume(mesh: &Mesh) -> f64 {
        (0..mesh.triangles().len()).map(|i| mesh.corners(i)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    fn two(first: Soup, second: Soup) -> Soup {
        let shift = first.positions.len() as u32;
        let triangles = second.triangles.iter().map(|t| t.map(|c| c + shift));
        Soup {
            positions: [first.positions, second.positions].concat(),
            triangles: first.triangles.into_iter().chain(triangles).collect(),
            ..Soup::default()
        }
    }

    #[test]
    fn a_sound_mesh_stays_as_it_is() {
        for shape in Shape::ALL {
            let mesh = shape.mesh();
            let mended = mend("x", soup(&mesh)).unwrap();
            assert_eq!((mended.parts, mended.open_edges, &mended.notes[..]), (1, 0, &[][..]), "{}", shape.name());
            assert_eq!(mended.mesh.triangles().len(), mesh.triangles().len());
            assert!((mended.mesh.area() / mesh.area() - 1.0).abs() < 2e-3);
        }
    }

    #[test]
    fn a_torn_turned_and_doubled_mesh_is_made_whole() {
        let mesh = Shape::Torus.mesh();
        let mut rng = Rng::new(9, 9);
        let mut torn = Soup::default();
        let mut turned = 0;
        for (i, t) in mesh.triangles().iter().enumerate() {
            let base = torn.positions.len() as u32;
            for &corner in t {
                torn.positions
                    .push(mesh.positions()[corner as usize].map(|c| 300.0 * (c + 1e-8 * rng.range(-1.0, 1.0)) - 80.0));
            }
            let turn = rng.unit() < 0.4;
            turned += usize::from(turn);
            torn.triangles.push(if turn { [base, base + 2, base + 1] } else { [base, base + 1, base + 2] });
            if i % 1000 == 0 {
                torn.triangles.push([base + 1, base, base + 2]);
                torn.triangles.push([base, base, base + 1]);
            }
        }
        let mended = mend("x", torn).unwrap();
        assert_eq!((mended.parts, mended.open_edges), (1, 0), "{:?}", mended.notes);
        assert_eq!(mended.mesh.triangles().len(), mesh.triangles().len());
        assert_eq!(mended.mesh.positions().len(), mesh.positions().len());
        assert!((volume(&mended.mesh) / volume(&mesh) - 1.0).abs() < 1e-3);
        let all = mended.notes.join("; ");
        for words in
            ["corners were welded", "11 duplicate triangles", "11 triangles without an area", "triangles were turned"]
        {
            assert!(all.contains(words), "{all}");
        }
        assert!(all.contains(&format!("{turned} triangles were turned")), "{turned}: {all}");
    }

    #[test]
    fn an_inside_out_mesh_faces_outward() {
        let mesh = Shape::Vase.mesh();
        let mut inward = soup(&mesh);
        inward.triangles.iter_mut().for_each(|t| t.swap(0, 1));
        let mended = mend("x", inward).unwrap();
        assert!(volume(&mended.mesh) > 0.1);
        assert!(mended.notes[0].contains("turned to face outward"), "{:?}", mended.notes);
    }

    #[test]
    fn surfaces_that_touch_come_apart() {
        // Two tetrahedra that share an edge, and a third that touches a corner.
        let positions = [
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [1.0, 0.0, 0.3],
            [1.0, 0.0, -0.3],
            [-1.0, 0.0, 0.3],
            [-1.0, 0.0, -0.3],
            [0.2, 2.0, 0.0],
            [-0.2, 2.0, 0.1],
            [0.0, 2.0, -0.2],
        ];
        let mut triangles = Vec::new();
        for [a, b, c, d] in [[0, 1, 2, 3], [0, 1, 4, 5], [1, 6, 7, 8]] {
            triangles.extend([[a, b, c], [a, c, d], [a, d, b], [b, d, c]]);
        }
        let mended = mend("x", Soup { positions: positions.to_vec(), triangles, ..Soup::default() }).unwrap();
        assert_eq!((mended.parts, mended.open_edges), (3, 0), "{:?}", mended.notes);
        assert_eq!(mended.mesh.positions().len(), 12);
        assert!(volume(&mended.mesh) > 0.0);
        let all = mended.notes.join("; ");
        assert!(all.contains("1 edge with more than two") && all.contains("3 parts do not"), "{all}");
    }

    #[test]
    fn sheets_specks_and_strips_that_cannot_be_turned() {
        // A Möbius strip: one joint is cut.
        let mut strip = Soup::default();
        let count = 60u32;
        for i in 0..count {
            let angle = std::f64::consts::TAU * f64::from(i) / f64::from(count);
            for side in [-0.3, 0.3] {
                let radius = 1.0 + side * (0.5 * angle).cos();
                strip.positions.push([radius * angle.cos(), side * (0.5 * angle).sin(), radius * angle.sin()]);
            }
            let (a, b) = (2 * i, 2 * i + 1);
            let (c, d) = if i + 1 < count { (a + 2, b + 2) } else { (1, 0) };
            strip.triangles.extend([[a, b, c], [b, d, c]]);
        }
        let mended = mend("x", strip).unwrap();
        assert_eq!((mended.parts, mended.open_edges), (1, 2 * count as usize + 2), "{:?}", mended.notes);

        let mut speck = soup(&Shape::Sphere.mesh());
        speck.positions.iter_mut().flatten().for_each(|c| *c = *c * 1e-4 + 0.5);
        let mended = mend("x", two(soup(&Shape::Sphere.mesh()), speck)).unwrap();
        assert_eq!(mended.parts, 1);
        assert_eq!(mended.notes, ["1 speck was dropped"]);
    }

    #[test]
    fn what_has_no_area_is_refused() {
        for positions in [vec![[1.0; 3]; 3], vec![[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]], vec![[1e308; 3]; 3]] {
            let error = mend("flat.obj", Soup { positions, triangles: vec![[0, 1, 2]], ..Soup::default() })
                .unwrap_err()
                .to_string();
            assert!(error.contains("flat.obj") && error.contains("no area"), "{error}");
        }
        // Thin ones may lie in any direction.
        let positions = vec![[0.3, 0.1, 0.7], [0.6, 0.2, 1.4], [0.9, 0.3, 2.1]];
        let error =
            mend("x", Soup { positions, triangles: vec![[0, 1, 2]], ..Soup::default() }).unwrap_err().to_string();
        assert!(error.contains("no area"), "{error}");
        // Huge and tiny ones are only scaled.
        for scale in [1e300, 1e-290] {
            let positions = vec![[-scale, 0.0, 0.0], [scale, 0.0, 0.0], [0.0, scale, 0.0]];
            let mended = mend("x", Soup { positions, triangles: vec![[0, 1, 2]], ..Soup::default() }).unwrap();
            assert!((mended.mesh.area() - 1.0).abs() < 0.01, "{}", mended.mesh.area());
        }
    }

    #[test]
    fn parts_far_apart_are_told_so() {
        let mut far = soup(&Shape::Sphere.mesh());
        far.positions.iter_mut().for_each(|p| p[0] += 1e7);
        let error = mend("far.obj", two(soup(&Shape::Sphere.mesh()), far)).unwrap_err().to_string();
        assert!(error.contains("far apart") && !error.contains("no area"), "{error}");
    }
}
