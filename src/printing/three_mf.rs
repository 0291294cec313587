//! 3MF, core specification 1.3 of the 3MF Consortium: a zip archive of a model in XML and what says where it is.

use crate::mesh::{Mesh, Part};
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

const TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
"#;
const RELATIONSHIPS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="rel0" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
"#;
/// Between parts that stand side by side, mm.
const APART_MM: f32 = 10.0;

/// The file's bytes: every part an object of its name, side by side.
pub fn three_mf(parts: &[Part]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, text) in
        [("[Content_Types].xml", TYPES), ("_rels/.rels", RELATIONSHIPS), ("3D/3dmodel.model", &model(parts))]
    {
        archive.start_file(name, options).expect("names of ours, in memory");
        archive.write_all(text.as_bytes()).expect("written to memory");
    }
    archive.finish().expect("written to memory").into_inner()
}

fn model(parts: &[Part]) -> String {
    let mut xml = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n",
    );
    for (i, part) in parts.iter().enumerate() {
        let name = part.name.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
        writeln!(xml, "<object id=\"{}\" name=\"{name}\" type=\"model\"><mesh>", i + 1).expect("a string");
        write_mesh(&mut xml, &part.mesh);
        xml.push_str("</mesh></object>\n");
    }
    xml.push_str("</resources>\n<build>\n");
    let mut from = 0.0;
    for (i, part) in parts.iter().enumerate() {
        let [low, high] = part.mesh.bounds();
        // The core specification wants all of it where coordinates are positive.
        let [x, y, z] = [from - low[0], -low[1], -low[2]];
        writeln!(xml, "<item objectid=\"{}\" transform=\"1 0 0 0 1 0 0 0 1 {x} {y} {z}\"/>", i + 1).expect("a string");
        from += high[0] - low[0] + APART_MM;
    }
    xml.push_str("</build>\n</model>\n");
    xml
}

fn write_mesh(xml: &mut String, mesh: &Mesh) {
    xml.push_str("<vertices>\n");
    for [x, y, z] in &mesh.positions {
        writeln!(xml, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>").expect("a string");
    }
    xml.push_str("</vertices>\n<triangles>\n");
    for [a, b, c] in &mesh.triangles {
        writeln!(xml, "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"/>").expect("a string");
    }
    xml.push_str("</triangles>\n");
}
