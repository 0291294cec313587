//! An arrow between rooms never points upward.

use std::path::{Path, PathBuf};

/// Lowest first; rooms on one line may not use each other unless an earlier one is used by a later one.
const ORDER: &[&str] = &[
    "error",
    "parallel",
    "rng",
    "sorting",
    "work",
    "wire",
    "view",
    "geometry",
    "segment",
    "mesh",
    "raster",
    "objective",
    "optimize",
    "files",
    "picture",
    "start",
    "gpu",
    "sculpture",
    "metrics",
    "export",
    "settings",
    "tasks",
    // Crates beside all of these: they use the core alone, and of them only the command line knows them.
    "model",
    "guidance",
    "photograph",
    "fabrication",
    "printing",
];

fn level(room: &str) -> Option<usize> {
    ORDER.iter().position(|&name| name == room)
}

/// Every `crate::room` a source text names, in order of appearance.
fn rooms_named(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("crate::") {
        let rest = &text[at + "crate::".len()..];
        let names: Vec<&str> = match rest.strip_prefix('{') {
            // `use crate::{a::X, b}`: names at the first level only.
            Some(list) => {
                let mut depth = 1;
                let end = list
                    .char_indices()
                    .find(|&(_, c)| {
                        depth += i32::from(c == '{') - i32::from(c == '}');
                        depth == 0
                    })
                    .map_or(list.len(), |(i, _)| i);
                let mut depth = 0;
                list[..end]
                    .split(|c| {
                        depth += i32::from(c == '{') - i32::from(c == '}');
                        c == ',' && depth == 0
                    })
                    .collect()
            }
            None => vec![rest],
        };
        for name in names {
            found.push(name.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
        }
    }
    found
}

/// The text without the items that only tests have: those may look anywhere.
fn without_tests(text: &str) -> String {
    let mut parts = text.split("#[cfg(test)]");
    let mut kept = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        // An item ends with its semicolon, or with the brace that closes its body.
        let mut depth = 0;
        let mut previous = ' ';
        let end = part.char_indices().find(|&(_, c)| {
            // Not in '{'.
            let counts = previous != '\'';
            previous = c;
            depth += i32::from(c == '{' && counts) - i32::from(c == '}' && counts);
            depth == 0 && (c == ';' || (c == '}' && counts))
        });
        kept.push_str(end.map_or("", |(at, c)| &part[at + c.len_utf8()..]));
    }
    kept
}

/// The upward arrows of one file.
fn upward(room: &str, text: &str) -> Vec<String> {
    let text = &without_tests(text);
    let here = level(room).unwrap_or(usize::MAX);
    rooms_named(text)
        .into_iter()
        .filter(|name| level(name).is_some_and(|there| there > here))
        .map(|name| format!("{room} uses {name}"))
        .collect()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn no_arrow_points_upward() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&src, &mut files);
    assert!(files.len() > 20, "the sources were not found");
    let mut wrong = Vec::new();
    for file in files {
        let inside = file.strip_prefix(&src).unwrap();
        // The crate below is a folder of rooms, the one for meshes is a room.
        let inside = inside.strip_prefix("core").unwrap_or(inside);
        let first = inside.components().next().unwrap().as_os_str().to_string_lossy();
        let room = first.trim_end_matches(".rs");
        // The shells see the library from outside.
        if matches!(room, "lib" | "cli" | "web" | "few_cases") {
            continue;
        }
        assert!(level(room).is_some(), "{room} has no place in the order of rooms");
        wrong.extend(upward(room, &std::fs::read_to_string(&file).unwrap()));
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn the_check_sees_an_upward_arrow() {
    assert_eq!(upward("wire", "use crate::{Error, tasks::multiview, view::{View, Image}};").len(), 2);
    assert_eq!(upward("wire", "let x = crate::raster::ExactRaster::new();").len(), 1);
    assert_eq!(upward("tasks", "use crate::model::read_mesh;").len(), 1);
    assert!(upward("tasks", "use crate::{Error, start::tree, wire::Wire};").is_empty());
    let between = "#[cfg(test)]\nuse crate::tasks::Run;\nuse crate::export::Run;\n#[cfg(test)]\nmod tests { fn a() { b('{'); crate::tasks::c() } }";
    assert_eq!(upward("wire", between), ["wire uses export"]);
    assert_eq!(upward("wire", &format!("{between}\nfn d() {{ crate::gpu::e(); }}")).len(), 2);
}
