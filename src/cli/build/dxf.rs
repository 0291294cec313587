//! A bend list as a DXF drawing: its straight stretches and arcs in space, in millimetres.

use dxf::entities::{Arc, Entity, EntityType, Line};
use dxf::enums::{AcadVersion, Units};
use dxf::{Drawing, Point, Vector};
use glam::DVec3;
use wire4d_fabrication::{BendList, Piece};

/// The file, of the version of AutoCAD 2000.
pub fn drawing(bends: &BendList) -> Vec<u8> {
    let mut drawing = Drawing::new();
    drawing.header.version = AcadVersion::R2000;
    drawing.header.default_drawing_units = Units::Millimeters;
    for piece in bends.pieces() {
        drawing.add_entity(Entity::new(match piece {
            Piece::Straight { from, to } => EntityType::Line(Line::new(point(from), point(to))),
            Piece::Arc { from, centre, axis, angle_rad } => EntityType::Arc(arc(from, centre, axis, angle_rad)),
        }));
    }
    let mut bytes = Vec::new();
    drawing.save(&mut bytes).expect("memory takes everything");
    bytes
}

fn arc(from: DVec3, centre: DVec3, axis: DVec3, angle_rad: f64) -> Arc {
    let [x, y] = plane(axis);
    let begins = from - centre;
    let start = begins.dot(y).atan2(begins.dot(x)).to_degrees().rem_euclid(360.0);
    let own = DVec3::new(centre.dot(x), centre.dot(y), centre.dot(axis));
    let mut arc = Arc::new(point(own), begins.length(), start, (start + angle_rad.to_degrees()).rem_euclid(360.0));
    arc.normal = Vector::new(axis.x, axis.y, axis.z);
    arc
}

/// The x and y directions of a plane with this normal (DXF reference, arbitrary axis algorithm).
fn plane(normal: DVec3) -> [DVec3; 2] {
    let near_z = normal.x.abs() < 1.0 / 64.0 && normal.y.abs() < 1.0 / 64.0;
    let x = if near_z { DVec3::Y } else { DVec3::Z }.cross(normal).normalize();
    [x, normal.cross(x)]
}

fn point(p: DVec3) -> Point {
    Point::new(p.x, p.y, p.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_begin_and_end_where_the_wire_does() {
        let axes =
            [DVec3::Z, -DVec3::Z, DVec3::X, DVec3::new(0.48, 0.6, 0.64), DVec3::new(0.005, 0.0, -1.0).normalize()];
        for axis in axes {
            let centre = DVec3::new(3.0, -5.0, 7.0);
            let piece = Piece::Arc { from: centre + 4.0 * axis.any_orthonormal_vector(), centre, axis, angle_rad: 2.5 };
            let Piece::Arc { from, .. } = piece else { unreachable!() };
            let written = arc(from, centre, axis, 2.5);
            let [x, y] = plane(axis);
            let at = |degrees: f64| {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let own = DVec3::new(written.center.x, written.center.y, written.center.z);
                (own.x + written.radius * cos) * x + (own.y + written.radius * sin) * y + own.z * axis
            };
            assert!(at(written.start_angle).distance(from) < 1e-9);
            assert!(at(written.end_angle).distance(piece.at(1.0)) < 1e-9);
        }
    }
}
