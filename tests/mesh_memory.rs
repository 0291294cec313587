//! What reading a mesh takes is bounded by what the file holds, not by what it claims; and it ends soon.

#[path = "support/mesh_common/mod.rs"]
mod mesh_common;

use mesh_common::{RELATIONS, archive, glb, three_mf, zip};
use std::alloc::{GlobalAlloc, Layout, System};
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};
use wire4d::model::read_mesh;

struct Counting;

static NOW: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: the system's allocator does the work; the rest is counting.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let now = NOW.fetch_add(layout.size(), Ordering::Relaxed) + layout.size();
        MOST.fetch_max(now, Ordering::Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        NOW.fetch_sub(layout.size(), Ordering::Relaxed);
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(place, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A scene whose only mesh is four corners at place 0 of the buffer, a fan over them, and what `more` adds.
fn scene(node: &str, primitive: &str, accessors: &str, more: &str) -> Vec<u8> {
    let data: Vec<u8> =
        [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0].iter().flat_map(|c| c.to_le_bytes()).collect();
    let json = format!(
        r#"{{"nodes":[{{"mesh":0{node}}}],"meshes":[{{"primitives":[{{"mode":6,"attributes":{{"POSITION":0}}{primitive}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}}{accessors}],
        "bufferViews":[{{"buffer":0,"byteLength":48}}],"buffers":[{{"byteLength":48}}]{more}}}"#
    );
    glb(&json, &data)
}

#[test]
fn claims_cost_nothing() {
    const MANY: &str = "4000000000";
    let instanced = |count: &str| {
        scene(
            r#","extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":1}}}"#,
            "",
            &format!(r#",{{"componentType":5126,"count":{count},"type":"VEC3"}}"#),
            "",
        )
    };
    let zeros = |count: &str| {
        scene("", r#","indices":1"#, &format!(r#",{{"componentType":5125,"count":{count},"type":"SCALAR"}}"#), "")
    };
    let targets = r#"{"POSITION":0},"#.repeat(5000);
    let morphed = format!(r#","targets":[{}]"#, targets.trim_end_matches(','));
    let weights = format!(r#","weights":[{}]"#, vec!["1"; 5000].join(","));
    let component = |id: usize| format!(r#"<component objectid="{id}"/>"#).repeat(10);
    let mut doubling = String::from(
        r#"<object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
        <vertex x="0" y="1" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>"#,
    );
    for id in 2..40 {
        write!(doubling, r#"<object id="{id}"><components>{}</components></object>"#, component(id - 1)).unwrap();
    }
    let empty = doubling.replace("<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>", "");
    let circle = r#"<object id="1"><components><component objectid="1"/></components></object>"#;
    let build = |id: usize| format!(r#"<item objectid="{id}"/>"#);
    let wide = {
        let vertices = r#"<vertex x="0" y="0" z="0"/>"#.repeat(20_000);
        format!(
            r#"<object id="1"><mesh><vertices>{vertices}</vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>
            <object id="2"><components>{}</components></object>"#,
            r#"<component objectid="1"/>"#.repeat(20_000)
        )
    };
    let binary =
        |header: &str| [b"ply\nformat binary_little_endian 1.0\n", header.as_bytes(), b"end_header\n\0\0"].concat();
    let corners = "property float x\nproperty float y\nproperty float z\n";
    let cases: Vec<(&str, Vec<u8>, &str)> = vec![
        ("instances.glb", instanced(MANY), "accessor 1 is not there whole"),
        ("indices.glb", zeros(MANY), "3999999998 triangles"),
        ("zeros.glb", zeros("100000"), "accessor 1 is not there whole"),
        ("targets.glb", scene(&weights, &morphed, "", ""), "so many morph targets"),
        ("skin.glb", scene(r#","skin":0"#, "", "", r#","skins":[{"joints":[7]}]"#), "joints that are not there"),
        ("doubling.3mf", three_mf(&doubling, &build(39)), "without end"),
        ("empty.3mf", three_mf(&empty, &build(39)), "without end"),
        ("circle.3mf", three_mf(circle, &build(1)), "without end"),
        ("wide.3mf", three_mf(&wide, &build(2)), "no area"),
        ("nothing.3mf", three_mf(&doubling, ""), "builds nothing"),
        ("missing.3mf", three_mf(&doubling, &build(99)), "object 99, which is not there"),
        (
            "part.3mf",
            three_mf(&doubling, r#"<item objectid="1" p:path="/3D/no.model"/>"#),
            "without its part 3D/no.model",
        ),
        ("none.3mf", zip(&[("[Content_Types].xml", b"<x/>")]), "a 3MF file without a model"),
        ("lost.3mf", zip(&[("_rels/.rels", RELATIONS.as_bytes())]), "without its part 3D/part.model"),
        ("scene.usdz", zip(&[("scene.usdc", b"PXR-USDC")]), "a USDZ file"),
        ("texts.zip", zip(&[("a.txt", b"hello")]), "a zip archive, not a mesh"),
        ("face.ply", binary(&format!("element vertex 9\n{corners}element face {MANY}\n")), "4000000000 triangles"),
        ("vertex.ply", binary(&format!("element vertex 1500000\n{corners}")), "ends after 0 of 1500000 times vertex"),
        ("list.ply", binary("element face 1\nproperty list ushort double vertex_indices\n"), "has no triangles"),
        (
            "lists.ply",
            binary("element face 1\nproperty list uint double vertex_indices\n"),
            "ends after 0 of 1 times face",
        ),
    ];
    let bomb = miniz_oxide::deflate::compress_to_vec(&vec![b' '; 300_000_000], 1);
    let bomb = archive(8, false, &[("3D/3dmodel.model", &bomb, 300)]);
    // What the largest mesh takes while it is read.
    let cases = cases.into_iter().map(|(name, bytes, problem)| (name, 60_000_000, bytes, problem));
    let bomb = ("bomb.3mf", 300_000_000, bomb, "unpacks to more than 100 MB");
    let small = miniz_oxide::deflate::compress_to_vec(&vec![b' '; 50_000_000], 9);
    let small = archive(8, false, &[("3D/3dmodel.model", &small, 300)]);
    let small = ("small.3mf", 60_000_000, small, "unpacks to more than 10 MB");
    for (name, allowed, bytes, problem) in cases.chain([bomb, small]) {
        MOST.store(NOW.load(Ordering::Relaxed), Ordering::Relaxed);
        let before = NOW.load(Ordering::Relaxed);
        let start = std::time::Instant::now();
        let result = read_mesh(name, &bytes, None);
        let most = MOST.load(Ordering::Relaxed) - before;
        let words = result.map_or_else(|error| error.to_string(), |read| format!("read: {:?}", read.notes));
        assert!(words.contains(problem), "{name}: {words} should say {problem}");
        assert!(start.elapsed().as_secs_f64() < 3.0, "{name} took {:?}", start.elapsed());
        assert!(most < allowed, "{name}: {most} bytes for {}", bytes.len());
    }
}
