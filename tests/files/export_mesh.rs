//! The tube is watertight, wound outward and free of NaN for every wire; its files hold the same mesh.

use crate::export_support;

use export_support as wires;
use glam::DVec3;
use std::collections::HashMap;
use wire4d::export::{TriangleMesh, TubeOptions, glb, obj, stl, tube};
use wire4d::sculpture::{Strand, strands};
use wire4d::wire::Form;

/// Every edge is used exactly once in each direction; `Err` names the first that is not.
fn watertight(mesh: &TriangleMesh) -> Result<(), String> {
    let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for edge in [(a, b), (b, c), (c, a)] {
            if edge.0 == edge.1 {
                return Err(format!("edge {edge:?} has no length"));
            }
            *edges.entry(edge).or_default() += 1;
        }
    }
    for (&(a, b), &count) in &edges {
        if count != 1 || edges.get(&(b, a)) != Some(&1) {
            return Err(format!("edge {:?} is used {count} times one way", (a, b)));
        }
    }
    Ok(())
}

fn euler_characteristic(mesh: &TriangleMesh) -> i64 {
    mesh.positions.len() as i64 - mesh.triangles.len() as i64 / 2
}

/// Volume enclosed, by the divergence theorem: positive when triangles are wound outward.
fn signed_volume(mesh: &TriangleMesh) -> f64 {
    let point = |i: u32| DVec3::from(mesh.positions[i as usize].map(f64::from));
    mesh.triangles.iter().map(|&[a, b, c]| point(a).dot(point(b).cross(point(c))) / 6.0).sum()
}

fn options() -> TubeOptions {
    TubeOptions::default()
}

#[test]
fn every_wire_makes_a_closed_solid() {
    for (name, wire) in wires::all() {
        let strands = strands(&wire, 16);
        let mesh = tube(&strands, &options());
        watertight(&mesh).unwrap_or_else(|problem| panic!("{name}: {problem}"));
        let spheres = strands.iter().filter(|strand| !strand.closed).count() as i64;
        let spheres = if name == "closed flat" { 0 } else { spheres };
        assert_eq!(euler_characteristic(&mesh), 2 * spheres, "{name}");
        assert!(signed_volume(&mesh) > 0.0, "{name}");
        assert!(mesh.positions.iter().flatten().all(|c| c.is_finite()), "{name}");
        for normal in &mesh.normals {
            let length = normal.iter().map(|c| c * c).sum::<f32>().sqrt();
            assert!((length - 1.0).abs() < 1e-5, "{name}: a normal of length {length}");
        }
    }
}

#[test]
fn the_checks_can_fail() {
    let mut mesh = tube(&strands(&wires::helix(), 16), &options());
    watertight(&mesh).unwrap();
    let removed = mesh.triangles.pop().unwrap();
    assert!(watertight(&mesh).is_err(), "a hole");
    mesh.triangles.push([removed[1], removed[0], removed[2]]);
    assert!(watertight(&mesh).is_err(), "a triangle turned over");
    let inside_out = mesh.triangles.iter().map(|&[a, b, c]| [b, a, c]).collect();
    assert!(signed_volume(&TriangleMesh { triangles: inside_out, ..mesh }) < 0.0);
}

/// A straight tube is a cylinder with two half balls, a point a ball: volumes and radii are known.
#[test]
fn volume_and_radius_are_those_of_the_solid() {
    let pi = std::f64::consts::PI;
    let fine = TubeOptions { sides: 64, ..options() };
    let straight = Strand { points: (0..10).map(|i| [0.1 * i as f64, 0.2, 0.3, 0.2]).collect(), closed: false };
    let volume = signed_volume(&tube(&[straight], &fine));
    let exact = pi * 0.01 * 0.9 + 4.0 / 3.0 * pi * 0.001;
    assert!((volume / exact - 1.0).abs() < 0.01, "{volume} {exact}");
    let ball = tube(&strands(&wires::point(), 16), &fine);
    let exact = 4.0 / 3.0 * pi * 0.05f64.powi(3);
    assert!((signed_volume(&ball) / exact - 1.0).abs() < 0.01);
    let torus = (0..200).map(|i| (pi * i as f64 / 100.0).sin_cos()).map(|(s, c)| [0.5 * c, 0.5 * s, 0.0, 0.2]);
    let torus = signed_volume(&tube(&[Strand { points: torus.collect(), closed: true }], &fine));
    let exact = 2.0 * pi * pi * 0.5 * 0.01;
    assert!((torus / exact - 1.0).abs() < 0.01, "{torus} {exact}");
    assert!((torus / (1.03 * exact) - 1.0).abs() > 0.01, "3% would be seen");
}

/// Distance of every vertex from the polyline is the local radius, at most; and on smooth wires exactly that.
#[test]
fn the_surface_lies_at_the_radius() {
    for (name, wire) in wires::all() {
        let dense = strands(&wire, 64);
        let mesh = tube(&strands(&wire, 16), &options());
        let mut worst = 0.0f64;
        for p in &mesh.positions {
            let p = p.map(f64::from);
            let nearest = dense
                .iter()
                .flat_map(|strand| &strand.points)
                .map(|q| {
                    let d = (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>().sqrt();
                    d - (q[3] / 2.0).max(options().min_radius_world)
                })
                .fold(f64::INFINITY, f64::min);
            worst = worst.max(nearest);
        }
        assert!(worst < 3e-3, "{name}: the surface stands off by {worst}");
        if name == "helix" {
            let thick = TubeOptions { min_radius_world: 0.03, ..options() };
            let thick = tube(&strands(&wire, 16), &thick);
            assert!(signed_volume(&thick) > 1.5 * signed_volume(&mesh), "the floor makes it thicker");
        }
    }
}

#[test]
fn closed_frames_meet_without_a_twist() {
    let mesh = tube(&strands(&wires::trefoil(), 16), &options());
    let sides = options().sides;
    let rings: Vec<_> = mesh.positions.chunks(sides).collect();
    let distance = |a: [f32; 3], b: [f32; 3]| (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f32>();
    let nearest = |from: [f32; 3], ring: &[[f32; 3]]| {
        (0..sides).min_by(|&a, &b| distance(ring[a], from).total_cmp(&distance(ring[b], from))).unwrap()
    };
    for k in 0..rings.len() {
        let next = rings[(k + 1) % rings.len()];
        assert_eq!(nearest(rings[k][0], next), 0, "ring {k} of {} joins the next without a twist", rings.len());
        assert_ne!(nearest(rings[k][1], next), 0, "one side off is seen");
    }
}

#[test]
fn meshes_stay_small() {
    let mesh = tube(&strands(&wires::smooth(1, 1000), 16), &options());
    assert!(mesh.triangles.len() < 200_000, "{} triangles for 1,000 control points", mesh.triangles.len());
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn f32_at(bytes: &[u8], at: usize) -> f32 {
    f32::from_bits(u32_at(bytes, at))
}

#[test]
fn glb_is_structured_as_the_specification_says() {
    for (name, wire) in wires::all() {
        let mesh = tube(&strands(&wire, 16), &options());
        let file = glb(&mesh, &serde_json::json!({ "wire4d": { "seed": 7 } }));
        assert_eq!(&file[..4], b"glTF", "{name}");
        assert_eq!((u32_at(&file, 4), u32_at(&file, 8) as usize), (2, file.len()));
        let json_length = u32_at(&file, 12) as usize;
        assert_eq!((&file[16..20], json_length % 4), (&b"JSON"[..], 0));
        let json: serde_json::Value = serde_json::from_slice(&file[20..20 + json_length]).unwrap();
        let binary = 20 + json_length;
        assert_eq!(&file[binary + 4..binary + 8], b"BIN\0");
        let data = &file[binary + 8..];
        assert_eq!((u32_at(&file, binary) as usize, data.len() % 4), (data.len(), 0));
        assert_eq!(json["buffers"][0]["byteLength"], data.len());
        assert_eq!(json["extras"]["wire4d"]["made_with"]["seed"], 7);
        for (accessor, size) in [(0, 12), (1, 12), (2, 4)] {
            let view = &json["bufferViews"][accessor];
            assert_eq!(view["byteLength"], json["accessors"][accessor]["count"].as_u64().unwrap() * size);
        }
        let indices = &data[json["bufferViews"][2]["byteOffset"].as_u64().unwrap() as usize..];
        let vertices = json["accessors"][0]["count"].as_u64().unwrap() as u32;
        assert!((0..indices.len() / 4).all(|i| u32_at(indices, 4 * i) < vertices));
        for (i, bound, worst) in [(0, "min", f32::min as fn(f32, f32) -> f32), (2, "max", f32::max)] {
            let found = (0..vertices as usize).map(|v| f32_at(data, 12 * v + 4 * i)).reduce(worst).unwrap();
            assert_eq!(json["accessors"][0][bound][i].as_f64().unwrap() as f32, found, "{name}");
        }
    }
}

#[test]
fn stl_and_obj_hold_the_same_triangles() {
    let mesh = tube(&strands(&wires::trefoil(), 8), &options());
    let file = stl(&mesh.clone().scaled(50.0));
    assert!(!file.starts_with(b"solid"));
    assert_eq!(u32_at(&file, 80) as usize, mesh.triangles.len());
    assert_eq!(file.len(), 84 + 50 * mesh.triangles.len());
    for (k, triangle) in mesh.triangles.iter().enumerate() {
        for (corner, &vertex) in triangle.iter().enumerate() {
            // What is up in the world stands up on a printer's bed.
            let [x, y, z] = mesh.positions[vertex as usize];
            for (c, place) in [x, -z, y].into_iter().enumerate() {
                let value = f32_at(&file, 84 + 50 * k + 12 * (corner + 1) + 4 * c);
                assert!((value - 50.0 * place).abs() < 1e-4);
            }
        }
    }
    let text = obj(&mesh);
    let count = |prefix: &str| text.lines().filter(|line| line.starts_with(prefix)).count();
    assert_eq!(
        (count("v "), count("vn "), count("f ")),
        (mesh.positions.len(), mesh.normals.len(), mesh.triangles.len())
    );
}

#[test]
fn a_bag_is_many_solids() {
    let wire = wires::smooth(5, 40).to_form(Form::Bag).unwrap();
    assert_eq!(strands(&wire, 8).len(), 10);
}
