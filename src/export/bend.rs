//! A bend list, as for bending the wire by hand or machine: straight pieces and the bends between them.
//!
//! Row by row: go `length_mm` straight, turn the plane of bending by `rotation_deg` about the wire, bend by `bend_deg`.
//! The first point and the points' positions are there too, so that the list can be checked.

use crate::sculpture::Strand;
use glam::DVec3;
use std::fmt::Write;

/// Points nearer than this, millimetres, give no direction.
const COINCIDENT_MM: f64 = 1e-6;
/// Bends below this have no plane.
const STRAIGHT_RAD: f64 = 1e-6;

/// CSV with one row a point of the polyline that stays within `tolerance_mm` of each strand; widths are diameters.
/// `mm_per_world` sets the size. Strands follow each other with their number in the first column.
pub fn bend_csv(strands: &[Strand], mm_per_world: f64, tolerance_mm: f64) -> String {
    let mut text =
        String::from("strand,point,x_mm,y_mm,z_mm,width_mm,length_mm,rotation_deg,bend_deg,bend_radius_mm\n");
    for (number, strand) in strands.iter().enumerate() {
        let points = polyline(strand, mm_per_world, tolerance_mm);
        let mut last_axis: Option<DVec3> = None;
        for (i, &(point, width)) in points.iter().enumerate() {
            let before = i.checked_sub(1).map(|k| point - points[k].0);
            let after = points.get(i + 1).map(|next| next.0 - point);
            let (mut rotation, mut bend, mut radius) = (0.0, 0.0, f64::INFINITY);
            if let (Some(before), Some(after)) = (before, after) {
                bend = before.angle_between(after);
                if bend > STRAIGHT_RAD {
                    let axis = before.cross(after).try_normalize().unwrap_or_else(|| before.any_orthonormal_vector());
                    if let Some(last) = last_axis {
                        rotation = last.cross(axis).dot(before.normalize()).atan2(last.dot(axis));
                    }
                    last_axis = Some(axis);
                    // Of the arc that touches both pieces half-way to their nearer end.
                    radius = before.length().min(after.length()) / 2.0 / (bend / 2.0).tan();
                }
            }
            // Writing to a String cannot fail.
            let _ = write!(text, "{},{},{:.3},{:.3},{:.3},{width:.3},", number + 1, i + 1, point.x, point.y, point.z);
            let _ = write!(text, "{:.3},{:.2},", before.map_or(0.0, DVec3::length), rotation.to_degrees());
            let _ = match radius.is_finite() {
                true => writeln!(text, "{:.2},{radius:.3}", bend.to_degrees()),
                false => writeln!(text, "{:.2},", bend.to_degrees()),
            };
        }
    }
    text
}

/// Douglas and Peucker's polyline, in millimetres; closed strands come back to their first point.
fn polyline(strand: &Strand, mm_per_world: f64, tolerance_mm: f64) -> Vec<(DVec3, f64)> {
    let scaled = |p: &[f64; 4]| (DVec3::new(p[0], p[1], p[2]) * mm_per_world, p[3] * mm_per_world);
    let mut points: Vec<_> = strand.points.iter().map(scaled).collect();
    if strand.closed {
        points.extend(points.first().copied());
    }
    points.dedup_by(|a, b| a.0.distance(b.0) < COINCIDENT_MM);
    let mut kept = vec![false; points.len()];
    let last = points.len().saturating_sub(1);
    for end in [0, last] {
        if let Some(keep) = kept.get_mut(end) {
            *keep = true;
        }
    }
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let off = |i: usize| distance_to_segment(points[i].0, points[from].0, points[to].0);
        let farthest = (from + 1..to).max_by(|&a, &b| off(a).total_cmp(&off(b)));
        if let Some(middle) = farthest.filter(|&i| off(i) > tolerance_mm) {
            kept[middle] = true;
            open.extend([(from, middle), (middle, to)]);
        }
    }
    points.into_iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| point).collect()
}

fn distance_to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let squared = along.length_squared();
    let s = if squared > 0.0 { ((p - a).dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(a + along * s)
}
