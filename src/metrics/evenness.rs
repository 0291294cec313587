//! How evenly a closed curve covers a mesh.

use crate::error::Result;
use crate::mesh::Mesh;
use crate::start::filling::{Node, RefinedMesh, SAME_SIDE, Strands, foot, samples};
use glam::DVec3;

/// Places of the surface that are asked how far the curve is.
const SAMPLES: f64 = 20_000.0;
/// Strands nearer than this along the curve are the same strand, in spacings.
const SAME_STRAND: f64 = 3.0;
/// Bins of the histogram, a tenth of a spacing each; the last holds all beyond.
const BINS: usize = 21;

/// Figures of a closed curve on a mesh. Distances are in spacings, between places on the same side of the surface.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Evenness {
    /// From places spread evenly over the surface to the curve; a quarter is the ideal for parallel strands.
    pub mean: f64,
    /// The median of these.
    pub median: f64,
    /// 99 of 100 places are nearer than this.
    pub p99: f64,
    /// The farthest place.
    pub worst: f64,
    /// Area of the mesh over length of the curve, over the spacing; 1 if the curve is as long as it should be.
    pub spacing_ratio: f64,
    /// Length of the curve, world units.
    pub length_world: f64,
    /// Share of the curve's length by its distance to the nearest other strand: bin `k` from `k / 10` to `(k + 1) / 10`,
    /// the last from 2 on.
    pub strands: Vec<f64>,
    /// Share of the length that is nearer than half a spacing to another strand.
    pub crowded: f64,
    /// Pairs of segments that cross on the same side of the surface.
    pub crossings: usize,
}

impl Evenness {
    /// Measures the closed polyline `points` against `mesh` and the spacing it was made for.
    ///
    /// # Errors
    /// [`crate::Error::Setting`] if the spacing is too fine to be measured on this mesh.
    pub fn measure(mesh: &Mesh, points: &[[f64; 3]], spacing_world: f64) -> Result<Evenness> {
        let surface = RefinedMesh::new(mesh, spacing_world / 2.0)?;
        let strands = Strands::new(&[laid_on(&surface, points, spacing_world)]);
        let area = surface.area();
        let mut distances = distances(&surface, &strands, spacing_world, area);
        distances.sort_unstable_by(f64::total_cmp);
        let at = |share: f64| distances.get((share * (distances.len() as f64 - 1.0)) as usize).map_or(0.0, |d| *d);
        let (histogram, length_world) = strand_histogram(&strands, spacing_world);
        Ok(Evenness {
            mean: distances.iter().sum::<f64>() / distances.len().max(1) as f64,
            median: at(0.5),
            p99: at(0.99),
            worst: at(1.0),
            spacing_ratio: if length_world > 0.0 { area / length_world / spacing_world } else { 0.0 },
            length_world,
            crowded: histogram[..5].iter().sum(),
            strands: histogram,
            crossings: strands.crossings(spacing_world).len(),
        })
    }
}

/// The polyline in steps of at most an eighth of the spacing, each node with the nearest triangle.
fn laid_on(surface: &RefinedMesh, points: &[[f64; 3]], spacing: f64) -> Vec<Node> {
    let centre = |t: u32| surface.corners(t).iter().sum::<DVec3>() / 3.0;
    let triangles = 0..surface.triangles.len() as u32;
    let grid = crate::start::filling::Grid::new(triangles.map(centre), spacing);
    let hint = |point: DVec3| {
        // Edges are at most half a spacing long: so far is the nearest triangle's middle at most from its nearest point.
        let nearest = [0.1, 0.6, 1.5, 6.0, 100.0].iter().find_map(|reach| {
            let mut best = (f64::INFINITY, 0);
            grid.near(point, reach * spacing, |t, _| {
                let away = surface.distance_squared(point, t);
                if (away, t) < best {
                    best = (away, t);
                }
            });
            (best.0.sqrt() < (reach - 0.3).max(0.02) * spacing).then_some(best.1)
        });
        nearest.unwrap_or(0)
    };
    let mut nodes = Vec::new();
    for (i, &a) in points.iter().enumerate() {
        let (a, b) = (DVec3::from(a), DVec3::from(points[(i + 1) % points.len()]));
        let pieces = (a.distance(b) / (spacing / 8.0)).ceil().clamp(1.0, 1e5);
        for k in 0..pieces as usize {
            let point = a.lerp(b, k as f64 / pieces);
            let triangle = hint(point);
            nodes.push(Node { point, ..Node::on(surface, point, triangle) });
        }
    }
    nodes
}

/// From samples of the surface to the curve, in spacings.
fn distances(surface: &RefinedMesh, strands: &Strands, spacing: f64, area: f64) -> Vec<f64> {
    let grid = strands.grid(spacing);
    let all = samples(surface, area.sqrt(), SAMPLES);
    let distance = |sample: &crate::start::filling::Sample| {
        [0.8, 2.0, 8.0, 1000.0].iter().find_map(|reach| {
            let mut best = f64::INFINITY;
            grid.near(sample.point, (reach + 0.15) * spacing, |i, _| {
                if strands.nodes[i as usize].normal.dot(sample.normal) > SAME_SIDE {
                    best = best.min(segment_distance(strands, i, sample.point));
                }
            });
            (best <= reach * spacing).then_some(best / spacing)
        })
    };
    all.iter().filter_map(distance).collect()
}

fn segment_distance(strands: &Strands, i: u32, point: DVec3) -> f64 {
    let (a, b) = (strands.nodes[i as usize].point, strands.nodes[strands.next[i as usize] as usize].point);
    a.lerp(b, foot(point, a, b)).distance(point)
}

/// Share of the length by the distance to the nearest other strand, and the length.
fn strand_histogram(strands: &Strands, spacing: f64) -> (Vec<f64>, f64) {
    let count = strands.nodes.len();
    let mut along = vec![0.0; count + 1];
    for i in 0..count {
        along[i + 1] = along[i] + strands.nodes[i].point.distance(strands.nodes[(i + 1) % count].point);
    }
    let whole = along[count];
    let grid = strands.grid(spacing);
    let mut histogram = vec![0.0; BINS];
    for (i, node) in strands.nodes.iter().enumerate() {
        let mut best = f64::INFINITY;
        grid.near(node.point, 2.2 * spacing, |j, _| {
            let apart = (along[i] - along[j as usize]).abs();
            let other = apart.min(whole - apart) > SAME_STRAND * spacing;
            if other && strands.nodes[j as usize].normal.dot(node.normal) > SAME_SIDE {
                best = best.min(segment_distance(strands, j, node.point));
            }
        });
        let bin = ((best / spacing * 10.0) as usize).min(BINS - 1);
        histogram[bin] += if whole > 0.0 { (along[i + 1] - along[i]) / whole } else { 0.0 };
    }
    (histogram, whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square with side 1 and a line that goes to and fro `every` so much over all of it.
    fn serpentine(every: f64) -> (Mesh, Vec<[f64; 3]>) {
        let corners = vec![[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [-0.5, 0.5, 0.0]];
        let rows = (1.0 / every).round() as usize;
        let point = |k: usize| {
            let x = if k.div_ceil(2).is_multiple_of(2) { -0.5 } else { 0.5 };
            [x, -0.5 + every * ((k / 2) as f64 + 0.5), 0.0]
        };
        let mesh = Mesh::new("square", corners, vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        (mesh, (0..2 * rows).map(point).collect())
    }

    #[test]
    fn parallels_a_spacing_apart_are_the_ideal() {
        let (mesh, line) = serpentine(0.05);
        let evenness = Evenness::measure(&mesh, &line, 0.05).unwrap();
        assert!((evenness.mean - 0.25).abs() < 0.01 && evenness.worst < 0.51, "{evenness:?}");
        assert!((evenness.median - 0.25).abs() < 0.02 && (evenness.p99 - 0.495).abs() < 0.02);
        // The way back to the start along one side and the steps between rows come on top of 20 rows.
        assert!((evenness.length_world - 20.0 - 1.9).abs() < 0.2, "{evenness:?}");
        assert!(evenness.strands[9] + evenness.strands[10] > 0.8 && evenness.crowded < 0.1, "{evenness:?}");
        assert!((evenness.strands.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_wrong_shows() {
        let (mesh, line) = serpentine(0.05);
        let good = Evenness::measure(&mesh, &line, 0.05).unwrap();
        let crowded = Evenness::measure(&mesh, &line, 0.15).unwrap();
        assert!(crowded.crowded > 0.6 && crowded.spacing_ratio < 0.4, "{crowded:?}");
        let gappy = Evenness::measure(&mesh, &line[..30], 0.05).unwrap();
        assert!(gappy.worst > 2.0 && gappy.spacing_ratio > 1.15, "{gappy:?}");
        let mut crossing = line.clone();
        crossing[10] = [0.0, crossing[10][1] + 0.07, 0.0];
        let crossing = Evenness::measure(&mesh, &crossing, 0.05).unwrap();
        assert!(crossing.crossings > good.crossings, "{} and {}", crossing.crossings, good.crossings);
    }

    #[test]
    fn no_line_is_no_harm() {
        let (mesh, line) = serpentine(0.1);
        for line in [&line[..0], &line[..1], &line[..2]] {
            let evenness = Evenness::measure(&mesh, line, 0.1).unwrap();
            assert!(evenness.mean.is_finite() && evenness.spacing_ratio.is_finite() && evenness.crossings == 0);
        }
        assert!(Evenness::measure(&mesh, &line, 1e-6).is_err());
    }
}
