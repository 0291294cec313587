//! 3MF: a zip archive of XML models. A model lists objects, each a mesh or others put together, and says which of them to
//! build where; objects may be kept in models of their own (the production extension, which slicers use).

use super::decimals::Decimals;
use super::foreign::{self, SAVE_AS};
use super::soup::Kept;
use super::zip::Archive;
use super::{Soup, check_count, damaged};
use crate::{Error, Result};
use glam::{DMat4, DVec3};
use quick_xml::events::{BytesStart, Event};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// What may be required without changing any shape, by a part of its namespace; but for the production extension, which
/// is read.
const UNDERSTOOD: [&str; 3] = ["/production/", "/material/", "/trianglesets/"];
/// Most times that objects may be placed: few files place many, but those that place others over and over never end.
const MOST_PLACED: usize = 100_000;
/// How deep objects may be put together.
const DEEPEST: usize = 100;

/// One XML part of the archive.
#[derive(Default)]
struct Model {
    objects: BTreeMap<u32, Object>,
    build: Vec<Item>,
}

/// A mesh, or others put together.
#[derive(Default)]
struct Object {
    mesh: Soup,
    parts: Vec<Item>,
    /// Modifiers of slicers and the like are not part of the shape.
    is_other: bool,
}

/// An object in its place.
struct Item {
    /// The model it is in, if that is another.
    path: Option<String>,
    object: u32,
    place: DMat4,
}

/// Whether it is the XML alone, taken out of its archive.
pub(super) fn is_model(text: &[u8]) -> bool {
    let beginning = &text[..text.len().min(2000)];
    text.starts_with(b"<") && beginning.windows(15).any(|window| window == b"3dmanufacturing")
}

pub(super) fn read_model(name: &str, xml: &[u8]) -> Result<Soup> {
    let model = model(name, xml)?;
    assemble(name, &BTreeMap::from([(String::new(), model)]), "")
}

pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    let mut archive = Archive::open(bytes).ok_or_else(|| damaged(name, "is a zip archive without its end"))?;
    let Some(root) = root(name, &mut archive)? else { return Err(not_a_model(name, &archive)) };
    let mut models = BTreeMap::new();
    let mut waiting = vec![root.clone()];
    while let Some(path) = waiting.pop() {
        if models.contains_key(&path) {
            continue;
        }
        let xml = unpack(name, &mut archive, &path)?;
        let xml = xml.ok_or_else(|| damaged(name, format!("is a 3MF file without its part {path}")))?;
        let model = model(name, &xml)?;
        let parts = model.objects.values().flat_map(|object| &object.parts);
        waiting.extend(parts.chain(&model.build).filter_map(|item| item.path.clone()));
        models.insert(path, model);
    }
    assemble(name, &models, &root)
}

fn unpack<'a>(name: &str, archive: &mut Archive<'a>, path: &str) -> Result<Option<Cow<'a, [u8]>>> {
    archive.read(path).map_err(|problem| Error::input(name, problem, "save it again, or as STL"))
}

/// The path of the model that says what to build: as the archive's relations say, else where it mostly is.
fn root(name: &str, archive: &mut Archive) -> Result<Option<String>> {
    if let Some(relations) = unpack(name, archive, "_rels/.rels")? {
        let mut found = None;
        elements(name, &relations, |element| {
            let is_model = attribute(element, "Type").is_some_and(|kind| kind.ends_with("/3dmodel"));
            if is_model && found.is_none() {
                found = attribute(element, "Target").map(|path| part(&path));
            }
            Ok(())
        })?;
        if found.is_some() {
            return Ok(found);
        }
    }
    let models = || archive.paths().filter(|path| path.to_ascii_lowercase().ends_with(".model"));
    Ok(models().find(|path| path.eq_ignore_ascii_case("3D/3dmodel.model")).or(models().next()).map(part))
}

/// A path as it is compared.
fn part(path: &str) -> String {
    path.trim_start_matches('/').to_owned()
}

fn not_a_model(name: &str, archive: &Archive) -> Error {
    let any = |ending: &str| archive.paths().any(|path| path.to_ascii_lowercase().ends_with(ending));
    if any(".usdc") || any(".usda") || any(".usd") {
        let (_, remedy) = foreign::by_beginning(b"#usda").unwrap_or(("", SAVE_AS));
        return Error::input(name, "is a USDZ file, which is not read here", remedy);
    }
    if any("[content_types].xml") && name.to_ascii_lowercase().ends_with(".3mf") {
        return Error::input(name, "is a 3MF file without a model", "save it again with its objects, or as STL");
    }
    Error::input(name, "is a zip archive, not a mesh", "unpack it and give the mesh inside")
}

/// Tells of every element of XML.
fn elements(name: &str, xml: &[u8], mut tell: impl FnMut(&BytesStart) -> Result<()>) -> Result<()> {
    let text = text(xml).ok_or_else(|| damaged(name, "holds XML with letters that are none"))?;
    let mut reader = quick_xml::Reader::from_str(&text);
    let mut open = 0usize;
    let mut any = false;
    loop {
        match reader.read_event() {
            Ok(Event::Start(element)) => {
                (open, any) = (open + 1, true);
                tell(&element)?;
            }
            Ok(Event::Empty(element)) => {
                any = true;
                tell(&element)?;
            }
            Ok(Event::End(_)) => open = open.saturating_sub(1),
            Ok(Event::Eof) if any && open == 0 => return Ok(()),
            Ok(Event::Eof) => return Err(damaged(name, "holds XML that ends early")),
            Err(problem) => return Err(damaged(name, format!("holds XML that cannot be read ({problem})"))),
            Ok(_) => {}
        }
    }
}

/// UTF-8, or UTF-16 with a mark of its order.
fn text(xml: &[u8]) -> Option<Cow<'_, str>> {
    let (words, low) = match xml {
        [0xff, 0xfe, words @ ..] => (words, 0),
        [0xfe, 0xff, words @ ..] => (words, 1),
        _ => return std::str::from_utf8(xml).ok().map(Cow::Borrowed),
    };
    let words = words.chunks_exact(2).map(|pair| u16::from_le_bytes([pair[low], pair[1 - low]]));
    char::decode_utf16(words).collect::<Result<String, _>>().ok().map(Cow::Owned)
}

/// An attribute by its name without a prefix.
fn attribute<'a>(element: &'a BytesStart, name: &str) -> Option<Cow<'a, str>> {
    let mut attributes = element.attributes();
    // Whether one is there twice is for others to find out.
    let found =
        attributes.with_checks(false).flatten().find(|attribute| attribute.key.local_name().as_ref() == name)?;
    Some(found.value)
}

fn model(name: &str, xml: &[u8]) -> Result<Model> {
    let mut model = Model::default();
    let mut prefix = None;
    let mut last = 0;
    let mut decimals = Decimals::default();
    let whole = |element: &BytesStart, name: &str| attribute(element, name)?.trim().parse::<u32>().ok();
    elements(name, xml, |element| {
        // What is no part of the core has another prefix than the first element.
        let own = element.name().prefix().map(|prefix| prefix.as_ref().to_owned());
        if *prefix.get_or_insert_with(|| own.clone()) != own {
            return Ok(());
        }
        let local = element.local_name();
        let broken = || {
            let article = if local.as_ref().starts_with(['i', 'o']) { "an" } else { "a" };
            damaged(name, format!("has {article} {} that says too little", local.as_ref()))
        };
        match local.as_ref() {
            "model" => check_required(name, element)?,
            "object" => {
                last = whole(element, "id").ok_or_else(broken)?;
                let is_other = attribute(element, "type").is_some_and(|kind| kind == "other");
                model.objects.insert(last, Object { is_other, ..Object::default() });
            }
            "vertex" => {
                let Some(Object { mesh, .. }) = model.objects.get_mut(&last) else { return Ok(()) };
                let point = ["x", "y", "z"].map(|axis| attribute(element, axis).unwrap_or_default());
                let point = decimals.point(point.iter().map(|word| word.trim().as_bytes()));
                mesh.positions.push(point.map_err(|fault| fault.at(name, &format!("object {last}")))?);
            }
            "triangle" => {
                let Some(Object { mesh, .. }) = model.objects.get_mut(&last) else { return Ok(()) };
                let [a, b, c] = ["v1", "v2", "v3"].map(|corner| whole(element, corner).ok_or_else(broken));
                mesh.triangles.push([a?, b?, c?]);
                check_count(name, mesh.triangles.len())?;
            }
            "component" | "item" => {
                let item = Item {
                    path: attribute(element, "path").map(|path| part(&path)),
                    object: whole(element, "objectid").ok_or_else(broken)?,
                    place: attribute(element, "transform")
                        .map_or(Some(DMat4::IDENTITY), |words| place(&words))
                        .ok_or_else(broken)?,
                };
                if local.as_ref() == "item" {
                    model.build.push(item);
                } else if let Some(object) = model.objects.get_mut(&last) {
                    object.parts.push(item);
                }
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(model)
}

/// Refuses a model that needs what is not understood here.
fn check_required(name: &str, element: &BytesStart) -> Result<()> {
    for prefix in attribute(element, "requiredextensions").unwrap_or_default().split_ascii_whitespace() {
        let mut attributes = element.attributes();
        let found = attributes
            .with_checks(false)
            .flatten()
            .find(|attribute| attribute.key.as_ref() == format!("xmlns:{prefix}"));
        let needed = found.map_or(prefix.to_owned(), |attribute| attribute.value.into_owned());
        if !UNDERSTOOD.iter().any(|understood| needed.contains(understood)) {
            let needed: String = needed.chars().take(100).collect();
            let problem = format!("needs the 3MF extension {needed}, which is not read here");
            return Err(Error::input(name, problem, "export it as a plain mesh, 3MF or STL"));
        }
    }
    Ok(())
}

/// Twelve numbers: where x, y and z go, and the origin.
fn place(words: &str) -> Option<DMat4> {
    let numbers: Option<Vec<f64>> = words.split_ascii_whitespace().map(|word| word.parse().ok()).collect();
    let numbers = numbers.filter(|numbers| numbers.len() == 12)?;
    let row = |i: usize| DVec3::from_slice(&numbers[3 * i..]);
    Some(DMat4::from_cols(row(0).extend(0.0), row(1).extend(0.0), row(2).extend(0.0), row(3).extend(1.0)))
}

/// All that is to be built, in its place.
fn assemble(name: &str, models: &BTreeMap<String, Model>, root: &str) -> Result<Soup> {
    let mut assembly = Assembly { name, models, soup: Soup::default(), kept: Kept::default(), placed: 0 };
    let build = models.get(root).map_or(&[][..], |model| &model.build);
    if build.is_empty() {
        return Err(Error::input(name, "is a 3MF file that builds nothing", "save it again with objects on its plate"));
    }
    for item in build {
        assembly.add(root, item, DMat4::IDENTITY, 0)?;
    }
    Ok(assembly.soup)
}

struct Assembly<'a> {
    name: &'a str,
    models: &'a BTreeMap<String, Model>,
    soup: Soup,
    kept: Kept,
    placed: usize,
}

impl Assembly<'_> {
    fn add(&mut self, here: &str, item: &Item, above: DMat4, depth: usize) -> Result<()> {
        self.placed += 1;
        if depth > DEEPEST || self.placed > MOST_PLACED {
            let problem = "puts objects together without end";
            return Err(Error::input(self.name, problem, "export it as one mesh, or as STL"));
        }
        let path = item.path.as_deref().unwrap_or(here);
        let missing = || damaged(self.name, format!("places object {}, which is not there", item.object));
        let object = self.models.get(path).and_then(|model| model.objects.get(&item.object)).ok_or_else(missing)?;
        if object.is_other {
            return Ok(());
        }
        let matrix = above * item.place;
        for part in &object.parts {
            self.add(path, part, matrix, depth + 1)?;
        }
        let Soup { positions, triangles, .. } = &object.mesh;
        if triangles.is_empty() {
            return Ok(());
        }
        check_count(self.name, self.soup.triangles.len() + triangles.len())?;
        // A reflection turns triangles inside out.
        let mirrored = matrix.determinant() < 0.0;
        let triangles = triangles.iter().map(|t| t.map(|corner| corner as usize));
        let triangles = triangles.map(|[a, b, c]| if mirrored { [a, c, b] } else { [a, b, c] });
        let corner = |index: usize| matrix.transform_point3(DVec3::from(positions[index])).to_array();
        if !self.soup.add_named(&mut self.kept, positions.len(), triangles, corner) {
            return Err(damaged(
                self.name,
                format!("has a triangle in object {} with a corner that is not there", item.object),
            ));
        }
        Ok(())
    }
}
