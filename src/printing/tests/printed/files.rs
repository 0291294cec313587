//! Files that slicers open.

use crate::support::checked;
use std::collections::HashMap;
use wire4d_printing::{Mesh, Part, stl, three_mf};

fn tetrahedron(size: f32) -> Mesh {
    let positions = vec![[1.0; 3], [1.0 + size, 1.0, 1.0], [1.0, 1.0 + size, 1.0], [1.0, 1.0, 1.0 + size]];
    Mesh { positions, triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] }
}

#[test]
fn stl_holds_every_triangle_as_it_is() {
    let mesh = tetrahedron(6.0);
    let file = stl(&mesh);
    assert_eq!(file.len(), 84 + 50 * 4);
    assert!(!file.starts_with(b"solid"), "that would announce a text file");
    let number = |at: usize| f32::from_le_bytes(file[at..at + 4].try_into().unwrap());
    let vector = |at: usize| [number(at), number(at + 4), number(at + 8)];
    let mut read = Mesh::default();
    for record in (84..file.len()).step_by(50) {
        let first = read.positions.len() as u32;
        read.positions.extend([12, 24, 36].map(|at| vector(record + at)));
        read.triangles.push([first, first + 1, first + 2]);
    }
    assert_eq!(checked(&read).euler, 2);
    assert_eq!(read.volume_mm3(), 36.0);
    assert_eq!(vector(84), [0.0, 0.0, -1.0], "normals look outward");
}

/// What a numbered attribute says, all through a text.
fn numbers(xml: &str, attribute: &str) -> Vec<f64> {
    let opening = format!(" {attribute}=\"");
    xml.split(&opening).skip(1).map(|rest| rest.split('"').next().unwrap().parse().unwrap()).collect()
}

#[test]
fn a_3mf_archive_has_its_parts_in_millimetres_side_by_side() {
    let parts = [6.0, 3.0].map(|size| Part { name: format!("a & {size}"), mesh: tetrahedron(size) });
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(three_mf(&parts))).unwrap();
    let files: HashMap<String, String> = (0..archive.len())
        .map(|i| {
            let mut file = archive.by_index(i).unwrap();
            (file.name().unwrap().into_owned(), std::io::read_to_string(&mut file).unwrap())
        })
        .collect();
    assert!(files["[Content_Types].xml"].contains("3dmanufacturing-3dmodel+xml"));
    assert!(files["_rels/.rels"].contains("Target=\"/3D/3dmodel.model\""));
    let model = &files["3D/3dmodel.model"];
    assert!(model.contains("unit=\"millimeter\"") && model.contains("name=\"a &amp; 6\""));
    assert_eq!(numbers(model, "objectid"), [1.0, 2.0]);
    assert_eq!(numbers(model, "x"), [1.0, 7.0, 1.0, 1.0, 1.0, 4.0, 1.0, 1.0]);
    assert_eq!(numbers(model, "v3"), [1.0, 3.0, 3.0, 2.0, 1.0, 3.0, 3.0, 2.0]);
    assert!(model.contains("1 0 0 0 1 0 0 0 1 -1 -1 -1\""), "the first stands in the corner");
    assert!(model.contains("1 0 0 0 1 0 0 0 1 15 -1 -1\""), "the second stands beside the first");
}
