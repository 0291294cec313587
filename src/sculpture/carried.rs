//! What a sculpture takes along beside its wire, so that somebody can go on from it: what it was made of, and how it was
//! found. None of it is needed to show the wire: what is damaged or too large here is left out, and the file still opens.

use super::png::{Chunk, chunks};
use base64::Engine;
use base64::engine::general_purpose::{STANDARD, URL_SAFE_NO_PAD};
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// Most that a file grows by what it carries.
pub(crate) const MAX_CARRIED_BYTES: usize = 60_000;
/// Most drawings that are written and read.
pub const MAX_DRAWINGS: usize = 64;
/// Longest side of a drawing, px.
pub const MAX_DRAWING_PX: u32 = 256;
const MAX_DRAWING_BYTES: usize = 64 << 10;
const MAX_REPLAY_BYTES: usize = 40 << 10;
const MAX_PAIRS: usize = 16;
const MAX_TEXT_BYTES: usize = 256;

/// What a sculpture was made of and how it was found, as far as it is known.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Carried {
    /// What its views were to show, one a view at most; [`MAX_DRAWINGS`] at most.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drawings: Vec<Silhouette>,
    /// What names what was given beside drawings, such as a shape: 16 pairs at most, of at most 256 bytes each.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub given: BTreeMap<String, String>,
    /// The wires of the run, coded; 40 kB at most.
    #[serde(skip_serializing_if = "Vec::is_empty", serialize_with = "as_base64url")]
    pub replay: Vec<u8>,
}

/// What one view was to show.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Silhouette {
    /// The view's name.
    pub view: String,
    /// What the person called it: text, never markup.
    pub label: String,
    /// A PNG, 8-bit grey, ink black on white, at most [`MAX_DRAWING_PX`] a side and 64 kB.
    #[serde(serialize_with = "as_base64")]
    pub png: Vec<u8>,
}

impl Carried {
    /// As much of it as a file has room for, in bytes of its text: first the replay stays behind, then the drawings.
    pub(crate) fn within(&self, most: usize) -> Carried {
        let fits = |carried: &Carried| serde_json::to_string(carried).is_ok_and(|text| text.len() <= most);
        let mut carried = self.clone();
        carried.drawings.truncate(MAX_DRAWINGS);
        if !fits(&carried) {
            carried.replay.clear();
        }
        if !fits(&carried) {
            carried.drawings.clear();
        }
        if fits(&carried) { carried } else { Carried::default() }
    }

    /// The same JSON object with its fields at the end.
    pub(crate) fn joined_to(&self, object: &str) -> String {
        let own = serde_json::to_string(self).expect("plain strings always serialise");
        match (object.strip_suffix('}'), own.strip_prefix('{')) {
            (Some(others), Some(own)) if own != "}" => format!("{others},{own}"),
            _ => object.to_owned(),
        }
    }

    /// Reads its fields as a file has them, `Null` where it has none. What is damaged or too large is left out, with a sentence
    /// about it.
    pub(crate) fn read([drawings, given, replay]: [&Value; 3], notes: &mut Vec<String>) -> Carried {
        let mut lost = |what: &str| notes.push(format!("{what} in the file cannot be read and was left out"));
        let mut carried = Carried::default();
        if !drawings.is_null() {
            let found = drawings.as_array().map_or(&[][..], |drawings| drawings);
            carried.drawings = found.iter().take(MAX_DRAWINGS).filter_map(silhouette).collect();
            if carried.drawings.len() < found.len().max(1) {
                lost("A drawing");
            }
        }
        if !given.is_null() {
            match pairs(given) {
                Some(given) => carried.given = given,
                None => lost("What it was made of"),
            }
        }
        if !replay.is_null() {
            match replay.as_str().and_then(|text| decoded(text, MAX_REPLAY_BYTES, &URL_SAFE_NO_PAD)) {
                Some(replay) => carried.replay = replay,
                None => lost("How it was found"),
            }
        }
        carried
    }
}

fn pairs(given: &Value) -> Option<BTreeMap<String, String>> {
    let given = given.as_object().filter(|given| given.len() <= MAX_PAIRS)?;
    let mut pairs = BTreeMap::new();
    for (name, value) in given {
        let value = value.as_str().filter(|value| is_short(value) && is_short(name))?;
        // One by one: collecting them sorts, which takes 3 kB of a page's module.
        pairs.insert(name.clone(), value.to_owned());
    }
    Some(pairs)
}

fn silhouette(fields: &Value) -> Option<Silhouette> {
    let text = |name: &str| fields.get(name)?.as_str().filter(|text| is_short(text)).map(str::to_owned);
    let png = decoded(fields.get("png")?.as_str()?, MAX_DRAWING_BYTES, &STANDARD)?;
    is_drawing(&png).then_some(Silhouette { view: text("view")?, label: text("label")?, png })
}

fn is_short(text: &str) -> bool {
    text.len() <= MAX_TEXT_BYTES
}

/// Not even decoded where that would take more than `most` bytes.
fn decoded(text: &str, most: usize, alphabet: &impl Engine) -> Option<Vec<u8>> {
    (text.len() <= most.div_ceil(3) * 4)
        .then(|| alphabet.decode(text).ok())
        .flatten()
        .filter(|bytes| bytes.len() <= most)
}

/// Whether it is a whole grey PNG of 8 bits and a size that is allowed.
fn is_drawing(png: &[u8]) -> bool {
    let Some(chunks) = chunks(png).collect::<Option<Vec<_>>>() else { return false };
    let fits = |side: &[u8]| u32::from_be_bytes([side[0], side[1], side[2], side[3]]).wrapping_sub(1) < MAX_DRAWING_PX;
    let heading = |&(kind, data): &Chunk| {
        kind == b"IHDR" && data.len() == 13 && fits(data) && fits(&data[4..]) && data[8..10] == [8, 0]
    };
    chunks.first().is_some_and(heading) && chunks.last().is_some_and(|(kind, _)| kind == b"IEND")
}

fn as_base64<S: serde::Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&STANDARD.encode(bytes))
}

fn as_base64url<S: serde::Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&URL_SAFE_NO_PAD.encode(bytes))
}
