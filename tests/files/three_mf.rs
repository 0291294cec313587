//! A 3MF is unpacked from any archive and put together as it says.

use crate::mesh_common;

use mesh_common::{RELATIONS, archive, three_mf, zip};
use wire4d::model::{Mended, read_mesh};

const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

/// A box of 1 x 2 x 3 along x, y and z, as the mesh of an object.
fn mesh() -> String {
    let corners = (0..8).map(|i| format!(r#"<vertex x="{}" y="{}" z="{}"/>"#, i & 1, (i >> 1 & 1) * 2, (i >> 2) * 3));
    let faces = [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
    let triangles = faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]);
    let triangles = triangles.map(|[a, b, c]| format!(r#"<triangle v1="{}" v2="{}" v3="{}"/>"#, a - 1, b - 1, c - 1));
    let (corners, triangles) = (corners.collect::<String>(), triangles.collect::<String>());
    format!("<mesh><vertices>{corners}</vertices><triangles>{triangles}</triangles></mesh>")
}

fn model(objects: &str, build: &str) -> String {
    format!(
        r#"<model xmlns="{CORE}" xmlns:p="{PRODUCTION}"><resources>{objects}</resources><build>{build}</build></model>"#
    )
}

/// Width, height and depth, the longest 1; y is up.
fn shape(read: &Mended) -> [f64; 3] {
    let size = [0, 1, 2].map(|c| {
        let all = || read.mesh.positions().iter().map(|p| p[c]);
        all().fold(f64::MIN, f64::max) - all().fold(f64::MAX, f64::min)
    });
    let longest = size.into_iter().fold(0.0, f64::max);
    size.map(|side| (100.0 * side / longest).round() / 100.0)
}

fn read(bytes: &[u8]) -> Mended {
    let read = read_mesh("a.3mf", bytes, None).unwrap();
    assert_eq!(read.open_edges, 0, "{:?}", read.notes);
    assert!(!read.notes.iter().any(|note| note.contains("outward")), "{:?}", read.notes);
    read
}

#[test]
fn objects_are_put_together() {
    let object = format!(r#"<object id="1">{}</object>"#, mesh());
    let built = |more: &str, build: &str| read(&three_mf(&format!("{object}{more}"), build));
    let one = built("", r#"<item objectid="1"/>"#);
    assert_eq!((one.parts, shape(&one)), (1, [0.33, 1.0, 0.67]), "z is up");
    // Two boxes, 9 apart along x, and as one object turned about z, x to y.
    let pair = r#"<object id="2"><components><component objectid="1"/>
        <component objectid="1" transform="1 0 0 0 1 0 0 0 1 9 0 0"/></components></object>"#;
    let two = built(pair, r#"<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 5 5 5"/>"#);
    assert_eq!((two.parts, shape(&two)), (2, [0.2, 0.3, 1.0]));
    // Mirrored and stretched; nothing is inside out.
    let mirrored = built("", r#"<item objectid="1" transform="-6 0 0 0 1 0 0 0 1 0 0 0"/>"#);
    assert_eq!((mirrored.parts, shape(&mirrored)), (1, [1.0, 0.5, 0.33]));
    // What is not built, and a slicer's modifiers, are not part of it.
    let modifier = format!(r#"<object id="3" type="other">{}</object>"#, mesh());
    let with = r#"<object id="4"><components><component objectid="3" transform="9 0 0 0 9 0 0 0 9 0 0 0"/>
        <component objectid="1"/></components></object>"#;
    assert_eq!(shape(&built(&format!("{modifier}{with}{pair}"), r#"<item objectid="4"/>"#)), shape(&one));
}

#[test]
fn objects_may_lie_in_models_of_their_own() {
    let part = model(&format!(r#"<object id="7">{}</object>"#, mesh()), "");
    let whole = r#"<object id="1"><components><component p:path="/3D/Objects/Part_7.model" objectid="7"/>
        <component p:path="/3D/Objects/Part_7.model" objectid="7" transform="1 0 0 0 1 0 0 0 1 0 0 9"/></components></object>"#;
    let whole = model(whole, r#"<item objectid="1"/>"#).replace("<model", r#"<model requiredextensions="p""#);
    let files = [
        ("3D/Objects/part_7.model", part.as_bytes()),
        ("_rels/.rels", RELATIONS.as_bytes()),
        ("3D/part.model", whole.as_bytes()),
    ];
    let read = read(&zip(&files));
    assert_eq!((read.parts, shape(&read)), (2, [0.08, 1.0, 0.17]));
}

#[test]
fn archives_and_texts_of_all_kinds() {
    let object = format!(r#"<object id="1">{}</object>"#, mesh());
    let plain = model(&object, r#"<item objectid="1"/>"#);
    let prefixed =
        plain.replace("</", "</m:").replace('<', "<m:").replace("<m:/m:", "</m:").replace("xmlns=", "xmlns:m=");
    // Corners of slices and the like are no corners.
    let sliced =
        plain.replace("</object>", r#"</object><s:vertices xmlns:s="slice"><s:vertex x="5" y="5"/></s:vertices>"#);
    let wide =
        |order: fn(u16) -> [u8; 2]| format!("\u{feff}{plain}").encode_utf16().flat_map(order).collect::<Vec<u8>>();
    let marked = format!("\u{feff}{plain}").into_bytes();
    let texts = [
        marked,
        plain.clone().into_bytes(),
        prefixed.into_bytes(),
        sliced.into_bytes(),
        wide(u16::to_le_bytes),
        wide(u16::to_be_bytes),
    ];
    for text in texts {
        let packed = miniz_oxide::deflate::compress_to_vec(&text, 6);
        for long in [false, true] {
            for bytes in [
                archive(0, long, &[("3D/3dmodel.model", &text, text.len())]),
                archive(8, long, &[("3D\\3DModel.model", &packed, text.len())]),
                archive(8, long, &[("other.txt", b"", 0), ("3D/some.model", &packed, 1)]),
            ] {
                assert_eq!(shape(&read(&bytes)), [0.33, 1.0, 0.67], "{long}");
            }
        }
    }
}

#[test]
fn what_is_wrong_is_said() {
    let good = model(&format!(r#"<object id="1">{}</object>"#, mesh()), r#"<item objectid="1"/>"#);
    let refused = |bytes: &[u8]| read_mesh("a.3mf", bytes, None).expect_err("it is wrong").to_string();
    for (what, instead, says) in [
        ("</build>", "", "cannot be read"),
        ("</build></model>", "", "ends early"),
        (r#"v1="0""#, r#"v1="99""#, "object 1 with a corner that is not there"),
        (r#"v1="0""#, "", "a triangle that says too little"),
        (r#"x="1""#, r#"x="one""#, "object 1 has a corner that is not three numbers"),
        (r#"objectid="1""#, "", "an item that says too little"),
        (r#"objectid="1""#, r#"objectid="1" transform="1 2 3""#, "says too little"),
        (
            "<model",
            r#"<model requiredextensions="b" xmlns:b="http://x/3dmanufacturing/beamlattice/2017/02""#,
            "beamlattice",
        ),
    ] {
        let error = refused(&zip(&[("3D/3dmodel.model", good.replacen(what, instead, 1).as_bytes())]));
        assert!(error.contains(says), "{instead}: {error}");
    }
    let zipped = zip(&[("3D/3dmodel.model", good.as_bytes())]);
    let mut locked = zipped.clone();
    let directory = locked.windows(4).position(|window| window == b"PK\x01\x02").unwrap();
    locked[directory + 8] = 1;
    assert!(refused(&locked).contains("encrypted"));
    let squeezed = archive(14, false, &[("3D/3dmodel.model", good.as_bytes(), 1)]);
    assert!(refused(&squeezed).contains("method 14"));
    let broken = archive(8, false, &[("3D/3dmodel.model", b"\xff\xff\xff", 1)]);
    assert!(refused(&broken).contains("only in part"));
    // But for the comment at its end and its length.
    for length in 0..zipped.len() - 5 {
        refused(&zipped[..length]);
    }
}
