//! What a sculpture takes along beside its wire, so that somebody can go on from it: what it was made of, and how it was
//! found. None of it is needed to show the wire: what is damaged or too large here is left out, and the file still opens.

use base64::Engine;
use base64::engine::general_purpose::{STANDARD, URL_SAFE_NO_PAD};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

/// Most of each that is written and read.
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
    /// Reads its fields from those of a file. What is damaged or too large is left out, with a sentence about it.
    pub(super) fn read(fields: CarriedIn, notes: &mut Vec<String>) -> Carried {
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
pub(super) struct CarriedIn {
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

/// Whether the heading is that of a grey PNG of 8 bits and a size that is allowed.
fn is_drawing(png: &[u8]) -> bool {
    let side =
        |at: usize| png.get(at..at + 4).map(|bytes| u32::from_be_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    let fits = |side: Option<u32>| side.is_some_and(|side| (1..=MAX_DRAWING_PX).contains(&side));
    png.starts_with(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
        && fits(side(16))
        && fits(side(20))
        && png.get(24..26) == Some(&[8, 0])
}

fn as_base64<S: serde::Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&STANDARD.encode(bytes))
}

fn as_base64url<S: serde::Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&URL_SAFE_NO_PAD.encode(bytes))
}
