//! Files of other kinds, by the name a person knows them by and with what to do.

/// What is read.
pub(super) const SAVE_AS: &str = "give a mesh as OBJ, STL, PLY, 3MF, GLB or glTF";
const EXPORT: &str = "open it in the program that made it and export it as GLB, OBJ or STL";
const CAD: &str = "open it in a CAD program or a slicer and export it as 3MF or STL";
const UNPACK: &str = "unpack it and give the mesh inside";

/// What is wrong, and what to do about it.
pub(super) type Foreign = (&'static str, &'static str);

/// By the first bytes, after blanks.
pub(super) fn by_beginning(bytes: &[u8]) -> Option<Foreign> {
    const BEGINNINGS: &[(&[u8], Foreign)] = &[
        (b"ISO-10303-21", ("is a STEP file: curved surfaces and no triangles", CAD)),
        (b"Kaydara FBX", ("is an FBX file, which is not read here", EXPORT)),
        (b"; FBX", ("is an FBX file, which is not read here", EXPORT)),
        (b"BLENDER", ("is a Blender project, not a mesh", "open it in Blender and export it as GLB, OBJ or STL")),
        (b"PXR-USDC", ("is a USD file, which is not read here", EXPORT)),
        (b"#usda", ("is a USD file, which is not read here", EXPORT)),
        (b"DRACO", ("is a Draco file, which is not read here", "convert it to PLY or OBJ with draco_decoder")),
        (b"#VRML", ("is a VRML file, which is not read here", EXPORT)),
        (b"#X3D", ("is an X3D file, which is not read here", EXPORT)),
        (b"# vtk DataFile", ("is a VTK file, which is not read here", EXPORT)),
        (b"# .PCD", ("is a cloud of points, not a mesh", "make a surface of it in a modelling program")),
        (b"3D Geometry File Format", ("is a Rhino file, which is not read here", EXPORT)),
        (b"AutoCAD Binary DXF", ("is a DXF drawing, which is not read here", CAD)),
        (b"AC10", ("is a DWG drawing, which is not read here", CAD)),
        (b"DBRep_DrawableShape", ("is a BREP file: curved surfaces and no triangles", CAD)),
        (b"CASCADE Topology", ("is a BREP file: curved surfaces and no triangles", CAD)),
        (b"OFF\n", ("is an OFF file, which is not read here", EXPORT)),
        (b"OFF\r", ("is an OFF file, which is not read here", EXPORT)),
        (b"xof ", ("is a DirectX file, which is not read here", EXPORT)),
        (b"\xd0\xcf\x11\xe0", ("is a file of an office, CAD or 3D program, not a mesh", EXPORT)),
        (b"\x1f\x8b", ("is packed with gzip", UNPACK)),
        (b"\x28\xb5\x2f\xfd", ("is packed with zstd, as Blender projects are", UNPACK)),
        (b"7z\xbc\xaf", ("is a 7z archive", UNPACK)),
        (b"Rar!", ("is a RAR archive", UNPACK)),
        (b"\x89PNG", ("is a PNG picture, not a mesh", SAVE_AS)),
        (b"\xff\xd8\xff", ("is a JPEG picture, not a mesh", SAVE_AS)),
        (b"RIFF", ("is a picture or a recording, not a mesh", SAVE_AS)),
        (b"%PDF", ("is a PDF document, not a mesh", SAVE_AS)),
        (b"\xff\xfe", ("is text in UTF-16, which no mesh is", "save it as plain text or UTF-8")),
        (b"\xfe\xff", ("is text in UTF-16, which no mesh is", "save it as plain text or UTF-8")),
        (b"version https://git-lfs", ("only says where the mesh is kept (Git LFS)", "fetch it with git lfs pull")),
    ];
    BEGINNINGS.iter().find(|(beginning, _)| bytes.starts_with(beginning)).map(|&(_, foreign)| foreign)
}

/// What begins with `<`, by the element that it is.
pub(super) fn by_markup(text: &[u8]) -> Option<Foreign> {
    const ROOTS: &[(&str, Foreign)] = &[
        ("<collada", ("is a COLLADA file, which is not read here", EXPORT)),
        ("<x3d", ("is an X3D file, which is not read here", EXPORT)),
        ("<amf", ("is an AMF file, which is not read here", CAD)),
        ("<svg", ("is an SVG drawing, not a mesh", SAVE_AS)),
        ("<!doctype html", ("is a web page, not a mesh", "download the file itself")),
        ("<html", ("is a web page, not a mesh", "download the file itself")),
    ];
    if !text.starts_with(b"<") {
        return None;
    }
    let beginning = String::from_utf8_lossy(&text[..text.len().min(4000)]).to_ascii_lowercase();
    let found = ROOTS.iter().filter_map(|(root, foreign)| Some((beginning.find(root)?, *foreign)));
    Some(
        found.min_by_key(|&(at, _)| at).map_or(("is XML of another kind, not a mesh", SAVE_AS), |(_, foreign)| foreign),
    )
}

/// What nothing in the bytes tells, by the ending of the name.
pub(super) fn by_ending(extension: &str) -> Foreign {
    match extension {
        "iges" | "igs" => ("is an IGES file: curved surfaces and no triangles", CAD),
        "dxf" => ("is a DXF drawing, which is not read here", CAD),
        "3ds" => ("is a 3DS file, which is not read here", EXPORT),
        "skp" => ("is a SketchUp file, which is not read here", EXPORT),
        "f3d" => ("is a Fusion file, which is not read here", CAD),
        "x_t" | "x_b" => ("is a Parasolid file: curved surfaces and no triangles", CAD),
        "scad" => ("is an OpenSCAD program, not a mesh", "render it in OpenSCAD and export it as 3MF or STL"),
        "gcode" => ("is a printer's G-code, not a mesh", "give the mesh that it was sliced from"),
        "bin" => ("is not a mesh that can be read", "if it came with a glTF, export that as GLB, with all data inside"),
        _ => ("is not a mesh that can be read", SAVE_AS),
    }
}
