//! The same shape in every format comes to the same mesh, and what is wrong with a file is said in words.

use crate::mesh_common;

use mesh_common::{Kind, tetrahedra, written};
use wire4d::mesh::Shape;
use wire4d::model::{MAX_TRIANGLES, Up, read_mesh};

#[test]
fn every_format_gives_the_same_mesh() {
    let mesh = Shape::Torus.mesh();
    for kind in Kind::ALL {
        let bytes = written(kind, mesh.positions(), mesh.triangles());
        // The content says what it is, whatever the name.
        for name in [kind.name(), "mesh.bin"] {
            let read = read_mesh(name, &bytes, None).unwrap_or_else(|error| panic!("{kind:?}: {error}"));
            assert_eq!((read.parts, read.open_edges), (1, 0), "{kind:?}: {:?}", read.notes);
            let z_up = matches!(kind, Kind::StlBinary | Kind::StlText | Kind::ThreeMf);
            assert_eq!(read.up, if z_up { Up::Z } else { Up::Y }, "{kind:?}");
            assert_eq!(read.mesh.triangles().len(), mesh.triangles().len(), "{kind:?}");
            assert_eq!(read.mesh.positions().len(), mesh.positions().len(), "{kind:?}");
            assert!((read.mesh.area() / mesh.area() - 1.0).abs() < 2e-3, "{kind:?}");
            assert!(read.notes.iter().all(|note| note.contains("welded")), "{kind:?}: {:?}", read.notes);
        }
    }
}

#[test]
fn polygons_strips_fans_and_nodes() {
    // A cube of quadrilaterals, with texture and normal indices, counted from the end.
    let mut cube = String::from("# a cube\r\nmtllib none.mtl\r\no cube\r\n");
    for i in 0..8 {
        cube += &format!("v {} {} {} 0.5 0.5 0.5\r\n", i & 1, i >> 1 & 1, i >> 2 & 1);
    }
    for face in [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]] {
        cube += &format!("f {}\r\n", face.map(|i| format!("{}/1/{i}", i - 9)).join(" "));
    }
    let read = read_mesh("cube.obj", cube.as_bytes(), None).unwrap();
    assert_eq!((read.mesh.triangles().len(), read.open_edges, read.notes.len()), (12, 0, 0), "{:?}", read.notes);
    // Its edge is 2 / sqrt 3 in the unit ball.
    assert!((read.mesh.area() - 8.0).abs() < 0.05, "{}", read.mesh.area());

    // The same tetrahedron as triangles, a strip and a fan; moved, turned, and mirrored by nodes.
    let nodes = r#"[{"children":[1,2]},{"mesh":0,"translation":[3,0,0],"rotation":[0,0.7071068,0,0.7071068]},{"mesh":1,"scale":[-1,1,1]}]"#;
    let read = read_mesh("two.gltf", tetrahedra(nodes).as_bytes(), None).unwrap();
    assert_eq!((read.parts, read.open_edges, read.mesh.triangles().len()), (2, 0, 8), "{:?}", read.notes);
    let all = read.notes.join("; ");
    assert!(all.contains("2 parts") && !all.contains("turned"), "a mirrored part is not inside out: {all}");
    let circle = r#"[{"children":[1],"mesh":0},{"children":[0]}]"#;
    assert_eq!(read_mesh("circle.gltf", tetrahedra(circle).as_bytes(), None).unwrap().parts, 1);
}

#[test]
fn half_a_million_triangles_are_read_and_more_are_not() {
    // A sheet of squares.
    let across = 500;
    let point = |i: usize| [(i % (across + 1)) as f64, (i / (across + 1)) as f64, ((i * 7) % 13) as f64 * 0.01];
    let positions: Vec<[f64; 3]> = (0..(across + 1) * (across + 1)).map(point).collect();
    let mut triangles = Vec::new();
    for i in 0..across * across {
        let at = (i / across * (across + 1) + i % across) as u32;
        let above = at + across as u32 + 1;
        triangles.extend([[at, at + 1, above], [at + 1, above + 1, above]]);
    }
    assert_eq!(triangles.len(), MAX_TRIANGLES);
    let bytes = written(Kind::StlBinary, &positions, &triangles);
    let start = std::time::Instant::now();
    let read = read_mesh("sheet.stl", &bytes, None).unwrap();
    println!("read and mended in {:?}", start.elapsed());
    assert_eq!((read.mesh.triangles().len(), read.parts, read.open_edges), (MAX_TRIANGLES, 1, 4 * across));
    triangles.push([0, 5, 9]);
    let error =
        read_mesh("sheet.stl", &written(Kind::StlBinary, &positions, &triangles), None).unwrap_err().to_string();
    assert!(error.contains("500001 triangles"), "{error}");
}

#[test]
fn bad_files_are_refused_in_words() {
    let mesh = Shape::Sphere.mesh();
    let (positions, triangles) = (mesh.positions(), &mesh.triangles()[..40]);
    let good = |kind| written(kind, positions, triangles);
    let half = |kind| {
        let bytes = good(kind);
        bytes[..bytes.len() / 2].to_vec()
    };
    let with = |kind, point: [f64; 3]| {
        let mut positions = positions.to_vec();
        positions[triangles[3][1] as usize] = point;
        written(kind, &positions, triangles)
    };
    let mut header = vec![0; 84];
    header[80..84].copy_from_slice(&10_000_000_u32.to_le_bytes());
    let glb = |json: &str| mesh_common::glb(json, &[]);
    let mut cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("a.obj", vec![], "is empty"),
        ("a.obj", b"PK\x03\x04whatever".to_vec(), "zip archive without its end"),
        ("a.stl", b"\x1f\x8b\x08".to_vec(), "gzip"),
        ("a.glb", b"\x89PNG\r\n".to_vec(), "PNG"),
        ("a.obj", b"<!doctype html><p>not found".to_vec(), "web page"),
        ("a.obj", b"Dear reader,\nthis is a letter.\n".to_vec(), "not a mesh"),
        ("a.xyz", vec![0, 1, 2, 3, 255, 254], "not a mesh"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_vec(), "no triangles"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n".to_vec(), "line 3"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n".to_vec(), "names a corner"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n".to_vec(), "line 4"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n".to_vec(), "no area"),
        ("a.obj", b"v 0 0 0\nv 1 0 inf\nv 2 1 0\nf 1 2 3\n".to_vec(), "not finite"),
        ("a.stl", header, "10000000 triangles"),
        ("a.stl", half(Kind::StlBinary), "of 40 triangles"),
        ("a.stl", half(Kind::StlText), "damaged"),
        ("a.ply", half(Kind::PlyBinary), "ends after"),
        ("a.ply", half(Kind::PlyText), "ends after"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n".to_vec(), "without faces"),
("a.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty float x\nproperty float y\nproperty float z\nend_header\n".to_vec(), "18446744073709551615 corners"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement face 10000000\nproperty list uchar int vertex_indices\nend_header\n".to_vec(), "10000000 triangles"),
        ("a.glb", half(Kind::Glb), "ends early"),
        ("a.gltf", b"{\"asset\":{\"version\":\"2.0\"}}".to_vec(), "no triangles"),
        ("a.gltf", b"{\"asset\":".to_vec(), "no glTF"),
        ("a.gltf", b"{\"asset\":{\"version\":\"1.0\"},\"meshes\":{\"a\":{}}}".to_vec(), "glTF version 1 is not supported"),
        ("a.glb", glb(r#"{"extensionsRequired":["KHR_draco_mesh_compression"]}"#), "Draco compression is not supported"),
        ("a.glb", glb(r#"{"extensionsRequired":["EXT_meshopt_compression"]}"#), "meshopt compression is not supported"),
        ("a.glb", glb(r#"{"buffers":[{"byteLength":9,"uri":"mesh.bin"}]}"#), "data in another file (mesh.bin) is not supported"),
    ];
    for kind in [Kind::StlBinary, Kind::PlyText, Kind::PlyBinary, Kind::Glb, Kind::Gltf] {
        cases.push(("a", with(kind, [f64::NAN, 0.0, 0.0]), "not finite"));
        cases.push(("a", with(kind, [0.0, f64::INFINITY, 0.0]), "not finite"));
    }
    for (i, (name, bytes, problem)) in cases.into_iter().enumerate() {
        let error = read_mesh(name, &bytes, None).expect_err(problem);
        let words = error.to_string();
        assert!(words.starts_with(name) && words.contains(problem), "case {i}: {words} should say {problem}");
        assert!(
            error.is_bad_input() && words.contains("; ") && words.len() < 300 && !words.contains('\n'),
            "case {i}: {words}"
        );
    }
}
