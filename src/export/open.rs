//! Back from files that carry a wire: wire.json, and the pictures and models that Wire4D makes. The bytes say what it is.

use super::capsule::{KEYWORD, PNG_PLAIN, SVG_ENDS};
use super::open_share_code;
use crate::sculpture::{Carried, MAX_FILE_BYTES, MadeWith, Sculpture, check_heading, png};
use crate::{Error, Result};
use serde_json::Value;

/// Largest file that is opened: a picture of any size that a page makes.
pub const MAX_CARRIER_BYTES: usize = 64 << 20;

/// A wire from a file.
#[derive(Debug, Clone, PartialEq)]
pub struct Opened {
    /// The wire, exactly as it was from a wire.json, to within a share code's precision from anything else.
    pub sculpture: Sculpture,
    /// The share code that the file has in place of the wire itself; none in a wire.json.
    pub code: Option<String>,
    /// What could not be read of what it was made of, a sentence each.
    pub notes: Vec<String>,
}

/// Opens a wire.json, or a PNG, SVG or GLB that carries a wire; `name` is what the person calls the file.
///
/// # Errors
/// [`Error::Wire`] for a file that carries none, is damaged, or from a newer version.
///
/// # Examples
/// ```
/// use wire4d::export::{ExportOptions, Format, export, open_file};
/// # use wire4d::sculpture::{Carried, MadeWith, Sculpture};
/// # use wire4d::wire::Wire;
///
/// # fn main() -> wire4d::Result<()> {
/// # let square = [[1.0, 0.0, 0.0, 0.1], [0.0, 1.0, 0.0, 0.1], [-1.0, 0.0, 0.5, 0.1], [0.0, -1.0, 0.0, 0.1]];
/// # let wire = Wire::closed_uniform(square.to_vec())?;
/// # let made_with = MadeWith { seed: 7, ..MadeWith::default() };
/// # let made = Sculpture { wire, views: Vec::new(), made_with, carried: Carried::default() };
/// let drawing = export(&made, Format::Svg, None, None, &ExportOptions::default())?;
/// assert_eq!(open_file("ring.svg", &drawing)?.sculpture.made_with.seed, 7);
/// # Ok(())
/// # }
/// ```
pub fn open_file(name: &str, bytes: &[u8]) -> Result<Opened> {
    if bytes.is_empty() {
        return Err(Error::wire(name, "is empty", "choose another file"));
    }
    if bytes.len() > MAX_CARRIER_BYTES {
        let problem = format!("{} MB are more than a file with a wire has", bytes.len() >> 20);
        return Err(Error::wire(name, problem, "use a smaller picture or model"));
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let found = match text {
        [b'{' | b'[', ..] => {
            let mut notes = Vec::new();
            let sculpture = Sculpture::read_json(name, text, &mut notes)?;
            return Ok(Opened { sculpture, code: None, notes });
        }
        [b'<', ..] => in_svg(text),
        [b'g', b'l', b'T', b'F', ..] => in_glb(text),
        _ if bytes.starts_with(png::SIGNATURE) => in_png(bytes),
        _ => Ok(None),
    };
    match found {
        Ok(Some(capsule)) => opened(name, &capsule),
        Ok(None) => {
            let problem =
                "holds no wire: it was not made by Wire4D, or another program saved it again and left the wire out";
            Err(Error::wire(name, problem, "open the file as Wire4D saved it"))
        }
        Err(Damaged) => Err(damaged(name)),
    }
}

/// Something before the wire, or the wire, is not as it was written.
struct Damaged;

fn damaged(name: &str) -> Error {
    Error::wire(name, "is damaged or cut off", "save or download it again")
}

type Found = Result<Option<Value>, Damaged>;

fn parsed(capsule: &[u8]) -> Found {
    serde_json::from_slice(capsule).map(Some).map_err(|_| Damaged)
}

fn in_png(bytes: &[u8]) -> Found {
    for chunk in png::chunks(bytes) {
        let (kind, data) = chunk.ok_or(Damaged)?;
        let Some(text) = data.strip_prefix(KEYWORD.as_bytes()).filter(|_| kind == b"iTXt") else { continue };
        if let Some(text) = text.strip_prefix(PNG_PLAIN) {
            return parsed(text);
        }
    }
    Ok(None)
}

fn in_svg(bytes: &[u8]) -> Found {
    let text = String::from_utf8_lossy(bytes);
    let [begin, end] = SVG_ENDS;
    let Some((_, rest)) = text.split_once(begin) else { return Ok(None) };
    let (capsule, _) = rest.split_once(end).ok_or(Damaged)?;
    // As it is written nothing is escaped; who saves it again may escape quotes.
    let marks = [("&quot;", "\""), ("&apos;", "'"), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")];
    parsed(marks.iter().fold(capsule.to_owned(), |text, (mark, c)| text.replace(mark, c)).as_bytes())
}

fn in_glb(bytes: &[u8]) -> Found {
    let word = |at: usize| bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes);
    let length = word(12).ok_or(Damaged)? as usize;
    if length > MAX_FILE_BYTES || bytes.get(16..20) != Some(b"JSON") {
        return Err(Damaged);
    }
    let text = bytes.get(20..20 + length).ok_or(Damaged)?;
    let scene = parsed(text)?.unwrap_or_default();
    let places = [&scene["extras"][KEYWORD], &scene["asset"]["extras"][KEYWORD]];
    // Before there were capsules there were other words about the making.
    Ok(places.into_iter().find(|fields| fields.get("code").is_some()).cloned())
}

fn opened(name: &str, capsule: &Value) -> Result<Opened> {
    check_heading(name, &capsule["format"], &capsule["version"])?;
    let code = capsule["code"].as_str().ok_or_else(|| damaged(name))?;
    let wire = open_share_code(code).map_err(|error| match error {
        Error::ShareCode { problem, remedy } if remedy.starts_with("update") => Error::wire(name, problem, remedy),
        _ => damaged(name),
    })?;
    // Task and seed are the code's, which has a checksum.
    let made_with = &capsule["made_with"];
    let settings = made_with["settings"].as_object().cloned().unwrap_or_default();
    let wire4d = made_with["wire4d"].as_str().unwrap_or_default().to_owned();
    let made_with = MadeWith { settings, wire4d, ..wire.made_with };
    let mut notes = Vec::new();
    let carried = Carried::read([&capsule["drawings"], &capsule["given"], &capsule["replay"]], &mut notes);
    Ok(Opened { sculpture: Sculpture { made_with, carried, ..wire }, code: Some(code.to_owned()), notes })
}
