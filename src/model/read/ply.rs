//! PLY, in words or binary of either order: elements `vertex` (x, y, z) and `face` (a list of corners).

use super::{MAX_TRIANGLES, Soup, check_count, damaged};
use crate::{Error, Result};
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};
use std::io::Read;

/// One element: a corner or a face, whatever is told first.
#[derive(Default)]
struct Element {
    point: [f64; 3],
    corners: Vec<u32>,
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Element::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == name);
        match (axis, name) {
            (Some(axis), _) => self.point[axis] = number(&property).unwrap_or(f64::NAN),
            (None, "vertex_indices" | "vertex_index") => self.corners = indices(property),
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }
}

fn number(property: &Property) -> Option<f64> {
    Some(match *property {
        Property::Char(x) => x.into(),
        Property::UChar(x) => x.into(),
        Property::Short(x) => x.into(),
        Property::UShort(x) => x.into(),
        Property::Int(x) => x.into(),
        Property::UInt(x) => x.into(),
        Property::Float(x) => x.into(),
        Property::Double(x) => x,
        _ => return None,
    })
}

fn indices(property: Property) -> Vec<u32> {
    // Below zero is as far out of range as can be.
    fn all<T: TryInto<u32>>(list: Vec<T>) -> Vec<u32> {
        list.into_iter().map(|x| x.try_into().unwrap_or(u32::MAX)).collect()
    }
    match property {
        Property::ListChar(list) => all(list),
        Property::ListUChar(list) => all(list),
        Property::ListShort(list) => all(list),
        Property::ListUShort(list) => all(list),
        Property::ListInt(list) => all(list),
        Property::ListUInt(list) => list,
        _ => Vec::new(),
    }
}

pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    // The reader's first line says where; it goes on over several.
    let broken = |problem: &dyn std::fmt::Display| {
        let words = problem.to_string();
        damaged(name, format!("cannot be read ({})", words.lines().next().unwrap_or_default().trim_end_matches('.')))
    };
    let parser = Parser::<Element>::new();
    // The reader takes UTF-8 alone, but comments and names of programs come in any letters.
    let end = bytes.windows(10).position(|word| word == b"end_header").unwrap_or(0);
    let (header, rest) = bytes.split_at(end);
    let header: Vec<u8> = header.iter().map(|byte| if byte.is_ascii() { *byte } else { b'?' }).collect();
    let mut reader = Reader::new(header.chain(rest));
    let header = parser.read_header(&mut reader).map_err(|problem| broken(&problem))?;
    let mut soup = Soup::default();
    for (kind, element) in &header.elements {
        if kind == "face" {
            check_count(name, element.count)?;
        }
        // Each takes a byte at least; more are not there, and an element without properties would be read for ever.
        if element.count > bytes.len() || element.properties.is_empty() && element.count > 0 {
            return Err(damaged(name, format!("is too short for {} times {kind}", element.count)));
        }
    }
    for (kind, definition) in &header.elements {
        // As many corners as triangles without a common one have, and no mesh has more of anything else.
        if definition.count > 3 * MAX_TRIANGLES {
            let problem = format!("has {} times {kind}, more than {MAX_TRIANGLES} triangles need", definition.count);
            return Err(Error::input(name, problem, "reduce it in a modelling program (decimate, simplify)"));
        }
        let elements =
            parser.read_payload_for_element(&mut reader, definition, &header).map_err(|problem| broken(&problem))?;
        match kind.as_str() {
            "vertex" => soup.positions = elements.iter().map(|element| element.point).collect(),
            "face" => {
                for element in elements {
                    check_count(name, soup.triangles.len() + element.corners.len().saturating_sub(2))?;
                    soup.add_polygon(&element.corners);
                }
            }
            _ => {}
        }
    }
    if soup.triangles.is_empty() && !soup.positions.is_empty() {
        return Err(Error::input(name, "holds points without faces", "make a surface of them in a modelling program"));
    }
    Ok(soup)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_elements_than_a_mesh_needs_are_refused() {
        for kind in ["junk", "vertex"] {
            let mut bytes = format!(
                "ply\nformat binary_little_endian 1.0\nelement {kind} 1500001\nproperty char x\nelement face 0\n\
                 property list uchar int vertex_indices\nend_header\n"
            )
            .into_bytes();
            bytes.resize(bytes.len() + 1_500_001, 0);
            let error = read("a.ply", &bytes).unwrap_err().to_string();
            assert!(error.contains(&format!("1500001 times {kind}, more than 500000 triangles need")), "{error}");
        }
    }

    #[test]
    fn a_comment_may_have_any_letters() {
        let words = b"ply\nformat ascii 1.0\ncomment caf\xe9\nelement vertex 3\nproperty float x\nproperty float y\n\
                      property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
                      0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        assert_eq!(read("a.ply", words).unwrap().triangles, [[0, 1, 2]]);
    }
}
