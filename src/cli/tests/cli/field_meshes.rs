//! Mesh files of the kinds that people have: each comes to its shape, or a sentence says what it is.

use std::path::{Path, PathBuf};
use std::process::Command;
use wire4d::mesh::Mesh;
use wire4d::model::{Up, read_mesh};

fn file(path: &str) -> PathBuf {
    crate::repository().join("tests/field").join(path)
}

/// Width, height and depth.
fn extents(points: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|c| {
        let all = || points.iter().map(|p| p[c]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    })
}

/// Whether two boxes have the same shape, within a share.
fn alike(found: [f64; 3], right: [f64; 3], within: f64) -> bool {
    let longest = |box_: [f64; 3]| box_.into_iter().fold(0.0, f64::max);
    (0..3).all(|c| (found[c] / longest(found) - right[c] / longest(right)).abs() < within)
}

struct Right {
    path: &'static str,
    extents: [f64; 3],
    triangles: usize,
    parts: usize,
}

const fn right(path: &'static str, extents: [f64; 3], triangles: usize, parts: usize) -> Right {
    Right { path, extents, triangles, parts }
}

const BALL: [f64; 3] = [1.0; 3];
const TORUS: [f64; 3] = [2.7, 2.7, 0.7];
/// y is up, as for whoever wrote them; where z is, they are laid so.
const RIGHT: &[Right] = &[
    right("glb-skinned/standing-man.glb", [40.0, 180.0, 20.0], 192, 1),
    right("glb-skinned/egg-by-morph.glb", [1.0, 3.0, 1.0], 80, 1),
    right("glb-instancing/five-balls.glb", [4.9, 0.9, 0.9], 400, 5),
    right("glb-instancing/five-balls-optional.glb", [4.9, 0.9, 0.9], 400, 5),
    right("glb-sparse/drop.glb", [2.0, 3.0, 2.0], 80, 1),
    right("glb-sparse/ball-no-view.glb", BALL, 80, 1),
    right("glb-sparse/quantised-egg.glb", [3.0, 1.0, 1.0], 80, 1),
    right("stl-end-loop/ball.stl", BALL, 80, 1),
    right("stl-end-loop/ball-good.stl", BALL, 80, 1),
    right("stl-end-loop/ball-comma.stl", BALL, 80, 1),
    right("stl-end-loop/ball-doubled.stl", BALL, 80, 1),
    right("stl-end-loop/ball-end-solid.stl", BALL, 80, 1),
    right("stl-end-loop/ball-endsolidName.stl", BALL, 80, 1),
    right("stl-count-zero/ball.stl", BALL, 80, 1),
    right("stl-count-zero/ball-count-0.stl", BALL, 80, 1),
    right("stl-count-zero/ball-count-ffffffff.stl", BALL, 80, 1),
    right("stl-z-up/pawn.stl", [2.0, 2.9, 2.0], 512, 1),
    right("ply-nan-quality/quality-fine.ply", BALL, 80, 1),
    right("ply-nan-quality/quality-nan.ply", BALL, 80, 1),
    right("ply-nan-quality/quality-NaN.ply", BALL, 80, 1),
    right("ply-tristrips/vase.ply", [1.5, 2.0, 1.5], 288, 1),
    right("ply-tristrips/vase-as-faces.ply", [1.5, 2.0, 1.5], 288, 1),
    right("ply-headers/blank-lines.ply", BALL, 80, 1),
    right("ply-headers/crlf.ply", BALL, 80, 1),
    right("ply-headers/crlf-binary.ply", BALL, 80, 1),
    right("ply-headers/float32-uint8.ply", BALL, 80, 1),
    right("ply-headers/float64.ply", BALL, 80, 1),
    right("ply-headers/obj-info.ply", BALL, 80, 1),
    right("ply-headers/tabs-leading.ply", BALL, 80, 1),
    right("ply-headers/wedge-uv.ply", BALL, 80, 1),
    right("obj-negative-interleaved/boxes.obj", [5.0, 1.5, 1.0], 36, 3),
    right("obj-negative-interleaved/torus-bom-tabs.obj", TORUS, 576, 1),
    right("obj-negative-interleaved/torus-comma.obj", TORUS, 576, 1),
    right("foreign-meshes/ball.3mf", BALL, 80, 1),
    right("foreign-meshes/3dmodel.model", BALL, 80, 1),
];

#[test]
fn each_comes_to_its_shape() {
    let mut wrong = Vec::new();
    for Right { path, extents: right, triangles, parts } in RIGHT {
        let bytes = std::fs::read(file(path)).unwrap();
        let read = match read_mesh(path, &bytes, None) {
            Ok(read) => read,
            Err(error) => {
                wrong.push(error.to_string());
                continue;
            }
        };
        let found = (read.mesh.triangles().len(), read.parts, read.open_edges);
        let size = extents(read.mesh.positions());
        if found != (*triangles, *parts, 0) || !alike(size, *right, 0.01) {
            wrong.push(format!("{path}: {found:?}, {size:?}, {:?}", read.notes));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_command_line_covers_what_was_read() {
    let folder = tempfile::tempdir().unwrap();
    let fill = |path: &Path, more: &[&str]| {
        let out = folder.path().join("out");
        let quick = [
            "--curve-spacing",
            "0.2",
            "--size",
            "64",
            "--iterations",
            "1",
            "--overwrite",
            "--quiet",
            "--backend",
            "cpu",
        ];
        let output = Command::new(env!("CARGO_BIN_EXE_wire4d"))
            .arg("fill")
            .arg(path)
            .arg("--out")
            .arg(&out)
            .args(quick)
            .args(more)
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let wire: serde_json::Value = serde_json::from_slice(&std::fs::read(out.join("wire.json")).unwrap()).unwrap();
        let points: Vec<[f64; 4]> = serde_json::from_value(wire["control_points"].clone()).unwrap();
        extents(&points.iter().map(|&[x, y, z, _]| [x, y, z]).collect::<Vec<_>>())
    };
    for Right { path, extents, .. } in RIGHT {
        let kinds = ["man", "five-balls.glb", "drop", "ball-comma", "count-0", "pawn", "vase.ply", "boxes", "3mf"];
        if kinds.iter().any(|kind| path.contains(kind)) {
            let found = fill(&file(path), &[]);
            assert!(alike(found, *extents, 0.12), "{path}: {found:?} should be {extents:?}");
        }
    }
    // The same pawn lies where somebody says that y is up in its file.
    let [x, y, z] = fill(&file("stl-z-up/pawn.stl"), &["--up", "y"]);
    assert!(z > 1.3 * x && z > 1.3 * y, "{x} {y} {z}");
    let [x, y, z] = fill(&file("stl-z-up/pawn.stl"), &["--up", "z"]);
    assert!(y > 1.3 * x && y > 1.3 * z, "{x} {y} {z}");

    // What is exported for printing has its up along z, and stands when it is read again.
    let made = folder.path().join("out/wire.json");
    for (ending, up) in [("stl", Up::Z), ("glb", Up::Y), ("obj", Up::Y)] {
        let to = folder.path().join(format!("again.{ending}"));
        let status = Command::new(env!("CARGO_BIN_EXE_wire4d"))
            .arg("export")
            .arg(&made)
            .arg("--to")
            .arg(&to)
            .stdout(std::process::Stdio::null())
            .status()
            .unwrap();
        assert!(status.success());
        let bytes = std::fs::read(&to).unwrap();
        let upright = |up: Option<Up>| {
            let read = read_mesh("again", &bytes, up).unwrap();
            let [x, y, z] = extents(read.mesh.positions());
            (read.up, y > 1.3 * x && y > 1.3 * z)
        };
        assert_eq!(upright(None), (up, true), "{ending}");
        let other = if up == Up::Y { Up::Z } else { Up::Y };
        assert_eq!(upright(Some(other)), (other, false), "{ending}");
    }
}

#[test]
fn what_cannot_be_read_is_named() {
    let step = std::fs::read(file("foreign-meshes/part.step")).unwrap();
    let utf16: Vec<u8> = "\u{feff}v 0 0 0".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let cases: [(&str, &[u8], &str, &str); 22] = [
        ("part.step", &step, "STEP file", "export it as 3MF or STL"),
        ("part.stp", b"\n ISO-10303-21;\n", "STEP file", "export it as 3MF or STL"),
        ("a.fbx", b"Kaydara FBX Binary  \0\x1a\0", "FBX file", "export it as GLB"),
        ("a.fbx", b"; FBX 7.3.0 project file\n", "FBX file", "export it as GLB"),
        ("a.blend", b"BLENDER-v300", "Blender project", "export it as GLB"),
        ("a.blend", b"\x28\xb5\x2f\xfd\0\0", "Blender", "unpack it"),
        ("a.drc", b"DRACO\x02\x02", "Draco file", "draco_decoder"),
        ("a.usdc", b"PXR-USDC\0", "USD file", "export it as GLB"),
        ("a.dae", b"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">", "COLLADA", "export it as GLB"),
        ("a.x3d", b"<?xml version=\"1.0\"?><!DOCTYPE X3D PUBLIC \"\"><X3D>", "X3D", "export it as GLB"),
        ("a.amf", b"<?xml version=\"1.0\"?><amf unit=\"inch\">", "AMF", "export it as 3MF or STL"),
        ("a.wrl", b"#VRML V2.0 utf8\n", "VRML", "export it as GLB"),
        ("a.igs", b"                                S      1\n", "IGES", "export it as 3MF or STL"),
        ("a.3ds", b"MM\0\0\0\0", "3DS file", "export it as GLB"),
        ("a.scad", b"cube([1,2,3]);", "OpenSCAD", "export it as 3MF or STL"),
        ("a.sldprt", b"\xd0\xcf\x11\xe0\xa1\xb1", "CAD", "export it as GLB"),
        ("a.obj", &utf16, "UTF-16", "UTF-8"),
        ("a.stl", b"version https://git-lfs.github.com/spec/v1\noid", "Git LFS", "git lfs pull"),
        ("a.stl", b"<!DOCTYPE html><html>", "web page", "download the file itself"),
        ("a.xml", b"<?xml version=\"1.0\"?><note/>", "XML of another kind", "3MF"),
        ("a.7z", b"7z\xbc\xaf\x27\x1c", "7z archive", "unpack it"),
        ("a.stl", b"solid\nfacet\nouter loop\nvertex 1.5 1,5 0\n", "decimal commas", "decimal points"),
    ];
    for (name, bytes, problem, remedy) in cases {
        let error = read_mesh(name, bytes, None).expect_err(name).to_string();
        assert!(error.contains(problem) && error.contains(remedy), "{error} should say {problem}; {remedy}");
        assert!(!error.contains("damaged"), "{error}");
    }
}

#[test]
fn the_checks_can_fail() {
    assert!(alike([1.0, 2.0, 1.0], [50.0, 100.0, 50.2], 0.01));
    assert!(!alike([1.0, 2.0, 1.0], [50.0, 50.0, 100.0], 0.01));
    let two = Mesh::new("x", vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 3.0, 0.0]], vec![[0, 1, 2]]).unwrap();
    assert_eq!(extents(two.positions()), [1.0, 3.0, 0.0]);
}
