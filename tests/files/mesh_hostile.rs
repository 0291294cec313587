//! Whatever the bytes, reading a mesh gives a sound mesh or an error, soon.

use crate::mesh_common;

use mesh_common::{Kind, written};
use wire4d::mesh::{Nearest, Shape};
use wire4d::model::read_mesh;

/// What a mended mesh promises.
fn check(name: &str, bytes: &[u8]) {
    let Ok(read) = read_mesh(name, bytes, None) else { return };
    let mesh = &read.mesh;
    let mut most: f64 = 0.0;
    for p in mesh.positions() {
        most = most.max(p.iter().map(|c| c * c).sum::<f64>().sqrt());
    }
    assert!((0.999..=1.0).contains(&most), "{most}");
    let mut edges = std::collections::HashMap::new();
    for t in mesh.triangles() {
        assert!(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
        for k in 0..3 {
            assert!(edges.insert((t[k], t[(k + 1) % 3]), ()).is_none(), "an edge is used once in a direction");
        }
    }
    let open = edges.keys().filter(|&&(a, b)| !edges.contains_key(&(b, a))).count();
    assert_eq!(open, read.open_edges);
    assert!(mesh.area() > 0.0 && read.parts > 0);
    assert!(Nearest::new(mesh).nearest(&[0.3, 0.1, 0.2]).distance.is_finite());
}

/// Files of the kinds that people have, with their names.
fn field() -> &'static [(String, Vec<u8>)] {
    static FILES: std::sync::OnceLock<Vec<(String, Vec<u8>)>> = std::sync::OnceLock::new();
    FILES.get_or_init(|| {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/field");
        let mut files = Vec::new();
        for kind in std::fs::read_dir(folder).unwrap().flatten().filter(|kind| kind.path().is_dir()) {
            for file in std::fs::read_dir(kind.path()).unwrap().flatten() {
                let name = file.file_name().to_string_lossy().into_owned();
                if [".glb", ".stl", ".ply", ".obj", ".3mf", ".model"].iter().any(|ending| name.ends_with(ending)) {
                    files.push((name, std::fs::read(file.path()).unwrap()));
                }
            }
        }
        assert!(files.len() > 30, "the files were not found");
        files.sort();
        files
    })
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config { cases: 600, failure_persistence: None, ..Default::default() })]
    #[test]
    fn changed_files(
        kind in 0..Kind::ALL.len(),
        changes in proptest::collection::vec((0.0..1.0f64, proptest::prelude::any::<u8>(), 0..4usize), 0..9),
        length in 0.0..1.4f64,
    ) {
        let mesh = Shape::Torus.mesh();
        let kind = Kind::ALL[kind];
        let used: Vec<[u32; 3]> = mesh.triangles()[..60].to_vec();
        let most = used.iter().flatten().max().unwrap() + 1;
        let mut bytes = written(kind, &mesh.positions()[..most as usize], &used);
        for (place, value, what) in changes {
            // Headers are short and matter most: half of the changes go there.
            let reach = if place < 0.5 { bytes.len().min(400) } else { bytes.len() };
            let at = ((place * 2.0 % 1.0) * reach as f64) as usize;
            match what {
                0 => bytes[at] = value,
                1 => bytes[at] = b"0123456789-.e \n"[value as usize % 15],
                2 => { bytes.remove(at); }
                _ => bytes.insert(at, value),
            }
        }
        bytes.truncate((length * bytes.len() as f64) as usize);
        check(kind.name(), &bytes);
    }

    #[test]
    fn changed_files_of_the_field(
        file in 0..1000usize,
        changes in proptest::collection::vec((0.0..1.0f64, proptest::prelude::any::<u8>(), 0..5usize), 0..9),
        length in 0.5..1.5f64,
    ) {
        let files = field();
        let (name, mut bytes) = files[file % files.len()].clone();
        for (place, value, what) in changes {
            // Where a glTF says what it holds.
            let reach = if place < 0.7 { bytes.len().min(1200) } else { bytes.len() };
            let at = ((place / 0.7 % 1.0) * reach as f64) as usize;
            match what {
                0 => bytes[at] = value,
                1 => bytes[at] = b"0123456789-.,e \n"[value as usize % 16],
                2 => { bytes.remove(at); }
                3 => bytes.insert(at, b'9'),
                _ => bytes.insert(at, value),
            }
        }
        bytes.truncate((length * bytes.len() as f64) as usize);
        check(&name, &bytes);
    }

    #[test]
    fn any_triangles(corners in proptest::collection::vec(0..9u32, 3..120), flat: bool) {
        let point = |i: u32| [f64::from(i % 3), f64::from(i / 3), if flat { 0.0 } else { f64::from(i * i % 5) }];
        let positions: Vec<[f64; 3]> = (0..9).map(point).collect();
        let triangles: Vec<[u32; 3]> = corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect();
        check("x.obj", &written(Kind::Obj, &positions, &triangles));
    }

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..300), start in 0..8usize) {
        let starts: [&[u8]; 8] = [b"", b"ply\nformat ascii 1.0\n", b"glTF\x02\0\0\0", b"{\"meshes\":[", b"solid ", b"v 1 2 3\nf ", b"PK\x03\x04", b"<model xmlns=\"3dmanufacturing\"><object id=\"1\"><"];
        for name in ["a.stl", "a"] {
            check(name, &[starts[start], &bytes].concat());
        }
    }
}
