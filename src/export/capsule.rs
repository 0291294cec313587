//! What a picture or a model takes along so that it opens again: the wire as its share code, how it was made and what of. One
//! JSON text, the same in every kind of file: plain ASCII without a character of markup, whatever people call their drawings.

use super::share_code;
use crate::sculpture::{FORMAT, FORMAT_VERSION, MAX_CARRIED_BYTES, Sculpture, png};
use crate::{Error, Result};
use serde_json::{Value, json};

/// What it is called in each kind of file.
pub(super) const KEYWORD: &str = "wire4d";
/// How it begins in an SVG, and ends.
pub(super) const SVG_ENDS: [&str; 2] = ["<metadata id=\"wire4d\">", "</metadata>"];
/// What follows the keyword in a PNG's text: not compressed, of no language, with no other keyword.
pub(super) const PNG_PLAIN: &[u8] = b"\0\0\0\0\0";
/// What else is written round it.
const FRAME_BYTES: usize = 200;

fn capsule(sculpture: &Sculpture) -> String {
    let made_with = serde_json::to_string(&sculpture.made_with).expect("plain numbers and strings always serialise");
    let code = share_code(sculpture);
    let wire = format!(r#"{{"format":"{FORMAT}","version":{FORMAT_VERSION},"code":"{code}","made_with":{made_with}}}"#);
    let carried = sculpture.carried.within(MAX_CARRIED_BYTES.saturating_sub(FRAME_BYTES + wire.len()));
    plain(&carried.joined_to(&wire))
}

/// The same JSON with all that is not ASCII, or means something in markup, written as numbers: it only stands in strings.
fn plain(json: &str) -> String {
    let mut text = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            '<' | '>' | '&' | '\u{7f}'.. => {
                c.encode_utf16(&mut [0; 2]).iter().for_each(|unit| text += &format!("\\u{unit:04x}"))
            }
            _ => text.push(c),
        }
    }
    text
}

/// A PNG picture with it, as a text chunk behind the heading.
///
/// # Errors
/// [`Error::Picture`] for what is no PNG.
pub fn in_png(picture: &[u8], sculpture: &Sculpture) -> Result<Vec<u8>> {
    if !matches!(png::chunks(picture).next(), Some(Some((b"IHDR", _)))) {
        return Err(Error::picture("picture", "is no PNG", "take it again"));
    }
    let (heading, rest) = picture.split_at(png::AFTER_HEADING);
    let text = [KEYWORD.as_bytes(), PNG_PLAIN, capsule(sculpture).as_bytes()].concat();
    Ok([heading, &png::chunk(b"iTXt", &text), rest].concat())
}

/// An SVG drawing with it, as metadata.
pub(super) fn in_svg(drawing: &str, sculpture: &Sculpture) -> String {
    let [begin, end] = SVG_ENDS;
    drawing.replacen(">\n", &format!(">\n{begin}{}{end}\n", capsule(sculpture)), 1)
}

/// What a GLB has under `extras`: it, and what other programs may like to know without a share code's reader.
pub(super) fn in_glb(sculpture: &Sculpture) -> Value {
    let mut fields: Value = serde_json::from_str(&capsule(sculpture)).expect("what was just written");
    fields["views"] = sculpture.views.iter().map(|view| view.name.as_str()).collect();
    fields["control_points"] = sculpture.wire.control_points().len().into();
    fields["closed"] = sculpture.wire.closed().into();
    json!({ KEYWORD: fields })
}
