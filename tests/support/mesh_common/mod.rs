//! Writers of small mesh files.

#![allow(dead_code)]

use std::fmt::Write;

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    Obj,
    StlBinary,
    StlText,
    PlyText,
    PlyBinary,
    PlyBig,
    Glb,
    Gltf,
    ThreeMf,
}

impl Kind {
    pub const ALL: [Kind; 9] = [
        Kind::Obj,
        Kind::StlBinary,
        Kind::StlText,
        Kind::PlyText,
        Kind::PlyBinary,
        Kind::PlyBig,
        Kind::Glb,
        Kind::Gltf,
        Kind::ThreeMf,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Kind::Obj => "mesh.obj",
            Kind::StlBinary | Kind::StlText => "mesh.STL",
            Kind::PlyText | Kind::PlyBinary | Kind::PlyBig => "mesh.ply",
            Kind::Glb => "mesh.glb",
            Kind::Gltf => "mesh.gltf",
            Kind::ThreeMf => "mesh.3mf",
        }
    }
}

pub fn written(kind: Kind, positions: &[[f64; 3]], triangles: &[[u32; 3]]) -> Vec<u8> {
    let corners = |t: &[u32; 3]| t.map(|i| positions[i as usize].map(|c| c as f32));
    let mut text = String::new();
    match kind {
        Kind::Obj => {
            for [x, y, z] in positions {
                writeln!(text, "v {x} {y} {z}").unwrap();
            }
            for [a, b, c] in triangles {
                writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
            }
        }
        Kind::StlBinary => {
            let mut bytes = b"solid but binary".to_vec();
            bytes.resize(80, b' ');
            bytes.extend((triangles.len() as u32).to_le_bytes());
            for triangle in triangles {
                bytes.extend([0; 12]);
                bytes.extend(corners(triangle).iter().flatten().flat_map(|c| c.to_le_bytes()));
                bytes.extend([0; 2]);
            }
            return bytes;
        }
        Kind::StlText => {
            text += "solid a mesh\n";
            for triangle in triangles {
                text += "  facet normal 0 0 0\n    outer loop\n";
                for [x, y, z] in corners(triangle) {
                    writeln!(text, "      vertex {x:e} {y:e} {z:e}").unwrap();
                }
                text += "    endloop\n  endfacet\n";
            }
            text += "endsolid a mesh\n";
        }
        Kind::PlyText | Kind::PlyBinary | Kind::PlyBig => {
            let format = ["ascii", "binary_little_endian", "binary_big_endian"]
                [usize::from(kind != Kind::PlyText) + usize::from(kind == Kind::PlyBig)];
            write!(
                text,
                "ply\nformat {format} 1.0\ncomment made by hand\nelement vertex {}\nproperty float x\nproperty float y\n\
                 property float z\nproperty uchar red\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
                positions.len(),
                triangles.len()
            )
            .unwrap();
            if kind == Kind::PlyText {
                for [x, y, z] in positions {
                    writeln!(text, "{x} {y} {z} 200").unwrap();
                }
                for [a, b, c] in triangles {
                    writeln!(text, "3 {a} {b} {c}").unwrap();
                }
            } else {
                let order = |word: u32| if kind == Kind::PlyBig { word.to_be_bytes() } else { word.to_le_bytes() };
                let mut bytes = text.into_bytes();
                for point in positions {
                    bytes.extend(point.iter().flat_map(|&c| order((c as f32).to_bits())));
                    bytes.push(200);
                }
                for triangle in triangles {
                    bytes.push(3);
                    bytes.extend(triangle.iter().flat_map(|&i| order(i)));
                }
                return bytes;
            }
        }
        Kind::Glb | Kind::Gltf => {
            let mut data: Vec<u8> = positions.iter().flatten().flat_map(|&c| (c as f32).to_le_bytes()).collect();
            let start = data.len();
            data.extend(triangles.iter().flatten().flat_map(|i| i.to_le_bytes()));
            let uri = match kind {
                Kind::Gltf => format!(r#","uri":"data:application/octet-stream;base64,{}""#, base64(&data)),
                _ => String::new(),
            };
            let json = format!(
                r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
                "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1}}]}}],
                "accessors":[{{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}},
                {{"bufferView":1,"componentType":5125,"count":{},"type":"SCALAR"}}],
                "bufferViews":[{{"buffer":0,"byteLength":{start}}},
                {{"buffer":0,"byteOffset":{start},"byteLength":{}}}],
                "buffers":[{{"byteLength":{}{uri}}}]}}"#,
                positions.len(),
                3 * triangles.len(),
                data.len() - start,
                data.len()
            );
            return if kind == Kind::Gltf { json.into_bytes() } else { glb(&json, &data) };
        }
        Kind::ThreeMf => {
            for [x, y, z] in positions {
                write!(text, r#"<vertex x="{x}" y="{y}" z="{z}"/>"#).unwrap();
            }
            text += "</vertices><triangles>";
            for [a, b, c] in triangles {
                write!(text, r#"<triangle v1="{a}" v2="{b}" v3="{c}"/>"#).unwrap();
            }
            let object = format!(r#"<object id="1"><mesh><vertices>{text}</triangles></mesh></object>"#);
            return three_mf(&object, r#"<item objectid="1" transform="0 2 0 -2 0 0 0 0 2 9 9 9"/>"#);
        }
    }
    text.into_bytes()
}

/// A 3MF of these objects and this build.
pub fn three_mf(objects: &str, build: &str) -> Vec<u8> {
    let model = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
        <model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
        xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06">
        <resources>{objects}</resources><build>{build}</build></model>"#
    );
    zip(&[("_rels/.rels", RELATIONS.as_bytes()), ("3D/part.model", model.as_bytes())])
}

pub const RELATIONS: &str = r#"<?xml version="1.0"?><Relationships xmlns="x"><Relationship Id="a" Target="/3D/part.model"
    Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>"#;

/// A zip archive of files that are not packed.
pub fn zip(files: &[(&str, &[u8])]) -> Vec<u8> {
    archive(0, false, &files.iter().map(|&(path, data)| (path, data, data.len())).collect::<Vec<_>>())
}

/// A zip archive of files that lie in it as they are after `method`, with the lengths they had before. A long one has all
/// its numbers where large ones would be (Zip64).
pub fn archive(method: u16, long: bool, files: &[(&str, &[u8], usize)]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    let word = |number: usize| (number as u32).to_le_bytes();
    let half = |number: usize| (number as u16).to_le_bytes();
    let double = |number: usize| (number as u64).to_le_bytes();
    const ELSEWHERE: usize = u32::MAX as usize;
    for &(path, data, length) in files {
        let place = bytes.len();
        // Version, flags, method, time, date, sum, lengths, length of the path, of more.
        let about = |packed: usize, length: usize, more: usize| {
            let (lengths, names) = ([word(packed), word(length)].concat(), [half(path.len()), half(more)].concat());
            [&half(45)[..], &half(0), &method.to_le_bytes(), &[0; 8], &lengths, &names].concat()
        };
        bytes.extend(
            [b"PK\x03\x04", &about(data.len(), length, 4)[..], path.as_bytes(), b"\x99\x99\0\0", data].concat(),
        );
        let (about, place, more) = if long {
            let more = [&half(1)[..], &half(24), &double(length), &double(data.len()), &double(place)].concat();
            (about(ELSEWHERE, ELSEWHERE, more.len()), ELSEWHERE, more)
        } else {
            (about(data.len(), length, 0), place, Vec::new())
        };
        let entry = [b"PK\x01\x02", &half(45)[..], &about, &[0; 10], &word(place), path.as_bytes(), &more];
        directory.extend(entry.concat());
    }
    let (count, place) = (files.len(), bytes.len());
    bytes.extend(&directory);
    let end = bytes.len();
    if long {
        let counts = [double(count), double(count), double(directory.len()), double(place)].concat();
        bytes.extend([b"PK\x06\x06", &double(44)[..], &half(45), &half(45), &[0; 8], &counts].concat());
        bytes.extend([b"PK\x06\x07", &word(0)[..], &double(end), &word(1)].concat());
    }
    let (count, size, place) = if long {
        (half(0xffff), word(ELSEWHERE), word(ELSEWHERE))
    } else {
        (half(count), word(directory.len()), word(place))
    };
    bytes.extend([b"PK\x05\x06\0\0\0\0", &count[..], &count, &size, &place, &[3, 0], b"end"].concat());
    bytes
}

pub fn glb(json: &str, data: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().div_ceil(4) * 4, b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((12 + 8 + json.len() as u32 + 8 + data.len() as u32).to_le_bytes());
    bytes.extend((json.len() as u32).to_le_bytes());
    bytes.extend(b"JSON");
    bytes.extend(json);
    bytes.extend((data.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(data);
    bytes
}

/// A tetrahedron as a strip (mesh 0, 16-bit indices) and as a fan with its base (mesh 1).
pub fn tetrahedra(nodes: &str) -> String {
    let corners: [[f32; 3]; 4] = [[1.0, 1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0], [-1.0, -1.0, 1.0]];
    let mut data: Vec<u8> = corners.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
    data.extend([0u16, 2, 1, 3, 0, 2].iter().flat_map(|i| i.to_le_bytes()));
    data.extend([0u8, 2, 1, 3, 2, 1, 2, 3]);
    format!(
        r#"{{"scenes":[{{"nodes":[0]}}],"nodes":{nodes},
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"mode":5}}]}},
        {{"primitives":[{{"attributes":{{"POSITION":0}},"indices":2,"mode":6}},
        {{"attributes":{{"POSITION":0}},"indices":3}},{{"attributes":{{"POSITION":0}},"mode":1}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},
        {{"bufferView":0,"byteOffset":48,"componentType":5123,"count":6,"type":"SCALAR"}},
        {{"bufferView":0,"byteOffset":60,"componentType":5121,"count":5,"type":"SCALAR"}},
        {{"bufferView":0,"byteOffset":65,"componentType":5121,"count":3,"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteLength":68}}],
        "buffers":[{{"byteLength":68,"uri":"data:;base64,{}"}}]}}"#,
        base64(&data)
    )
}

pub fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let word = chunk.iter().fold(0u32, |word, &byte| word << 8 | u32::from(byte)) << (8 * (3 - chunk.len()));
        for k in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * k) & 63) as usize];
            text.push(if k <= chunk.len() { char::from(letter) } else { '=' });
        }
    }
    text
}
