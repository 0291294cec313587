//! What a sculpture takes along beside its wire, so that somebody can go on from it: what it was made of, and how it was
//! found. None of it is needed to show the wire: what is damaged or too large here is left out, and the file still opens.

use super::png::{Chunk, chunks};
use base64::Engine;
use base64::engine::general_purpose::{STANDARD, URL_SAFE_NO_PAD};
use serde::{Deserialize, Serialize};
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
        let fits = |carried: &Carried| serde_json::to_vec(carried).is_ok_and(|text| text.len() <= most);
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

    /// Reads its fields from those of a file. What is damaged or too large is left out, with a sentence about it.
    pub(crate) fn read(fields: CarriedIn, notes: &mut Vec<String>) -> Carried {
        let mut lost = |what: &str| notes.push(format!("{what} in the file cannot be read and was left out"));
        let mut carried = Carried::default();
        if let Some(drawings) = fields.drawings {
            let found = drawings.as_array().map_or(&[][..], |drawings| drawings);
            carried.drawings = found.iter().take(MAX_DRAWINGS).filter_map(silhouette).collect();
            if carried.drawings.len() < found.len().max(1) {
                lost("A drawing");
            }
        }
        if let Some(given) = fields.given {
            match serde_json::from_value::<BTreeMap<String, String>>(given) {
                Ok(given)
                    if given.len() <= MAX_PAIRS
                        && given.iter().all(|(name, value)| is_short(name) && is_short(value)) =>
                {
                    carried.given = given;
                }
                _ => lost("What it was made of"),
            }
        }
        if let Some(replay) = fields.replay {
            match replay.as_str().and_then(|text| decoded(text, MAX_REPLAY_BYTES, &URL_SAFE_NO_PAD)) {
                Some(replay) => carried.replay = replay,
                None => lost("How it was found"),
            }
        }
        carried
    }
}

/// [`Carried`] as a file has it, which may come from anywhere.
#[derive(Deserialize, Default)]
pub(crate) struct CarriedIn {
    #[serde(default)]
    drawings: Option<Value>,
    #[serde(default)]
    given: Option<Value>,
    #[serde(default)]
    replay: Option<Value>,
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
