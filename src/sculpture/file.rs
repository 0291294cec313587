//! `wire.json`: the sculpture as text that other programs can read. Numbers survive to the last bit.

use super::carried::MAX_CARRIED_BYTES;
use super::{Carried, MadeWith, Sculpture};
use crate::view::View;
use crate::wire::{Form, Wire};
use crate::{Error, Result};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The name in `format`.
pub(crate) const FORMAT: &str = "wire4d";
/// The newest `version` this reads, and the one it writes.
pub const FORMAT_VERSION: u64 = 1;
/// No wire of 20,000 control points is longer; anything that is, is refused unread.
pub const MAX_FILE_BYTES: usize = 16 << 20;
const MAX_VIEWS: usize = 64;

#[derive(Serialize)]
struct FileOut<'a> {
    format: &'static str,
    version: u64,
    #[serde(skip_serializing_if = "is_spline")]
    form: Form,
    closed: bool,
    knots: &'a [f64],
    control_points: &'a [[f64; 4]],
    views: &'a [View],
    made_with: &'a MadeWith,
}

fn is_spline(form: &Form) -> bool {
    *form == Form::Spline
}

#[derive(Deserialize)]
struct Heading {
    #[serde(default)]
    format: Value,
    #[serde(default)]
    version: Value,
}

#[derive(Deserialize)]
struct FileIn {
    #[serde(default)]
    form: Form,
    closed: bool,
    knots: Vec<f64>,
    control_points: Vec<[f64; 4]>,
    #[serde(default)]
    views: Vec<View>,
    #[serde(default)]
    made_with: MadeWith,
    #[serde(default)]
    drawings: Value,
    #[serde(default)]
    given: Value,
    #[serde(default)]
    replay: Value,
}

impl Sculpture {
    /// The text of `wire.json`.
    pub fn to_json(&self) -> String {
        let file = FileOut {
            format: FORMAT,
            version: FORMAT_VERSION,
            form: self.wire.form(),
            closed: self.wire.closed(),
            knots: self.wire.knots(),
            control_points: self.wire.control_points(),
            views: &self.views,
            made_with: &self.made_with,
        };
        let text = serde_json::to_string(&file).expect("plain numbers and strings always serialise");
        let mut text = self.carried.within(MAX_CARRIED_BYTES).joined_to(&text);
        text.push('\n');
        text
    }

    /// Reads the bytes of a `wire.json`; `name` is what the person calls the file. What of [`Sculpture::carried`] is damaged or
    /// too large is left out.
    ///
    /// # Errors
    /// [`Error::Wire`] for what is too long, no JSON, another format, a newer version, or holds no valid wire or view.
    pub fn from_json(name: &str, bytes: &[u8]) -> Result<Sculpture> {
        Sculpture::read_json(name, bytes, &mut Vec::new())
    }

    /// [`Sculpture::from_json`] that says what it left out, a sentence each.
    pub(crate) fn read_json(name: &str, bytes: &[u8], notes: &mut Vec<String>) -> Result<Sculpture> {
        let bad = |problem: String, remedy: &str| Error::wire(name, problem, remedy);
        if bytes.len() > MAX_FILE_BYTES {
            let problem = format!("{} MB are more than any wire takes", bytes.len() >> 20);
            return Err(bad(problem, WRITTEN));
        }
        let Heading { format, version } = serde_json::from_slice(bytes)
            .map_err(|error| bad(format!("is not readable as JSON ({error})"), WRITTEN))?;
        check_heading(name, &format, &version)?;
        let file: FileIn = serde_json::from_slice(bytes)
            .map_err(|error| bad(format!("does not describe a wire ({error})"), WRITTEN))?;
        let wire = Wire::new(file.form, file.closed, file.knots, file.control_points).map_err(|error| match error {
            Error::Wire { problem, remedy, .. } => Error::wire(name, problem, remedy),
            other => other,
        })?;
        if file.views.len() > MAX_VIEWS {
            return Err(bad(format!("has {} views", file.views.len()), "use 64 at most"));
        }
        let carried = Carried::read([&file.drawings, &file.given, &file.replay], notes);
        Ok(Sculpture { wire, views: file.views, made_with: file.made_with, carried })
    }
}

const WRITTEN: &str = "use a wire.json that Wire4D wrote";

/// Whether a file's `format` and `version` say that it is of Wire4D, and of a version that is read here.
pub(crate) fn check_heading(name: &str, format: &Value, version: &Value) -> Result<()> {
    let bad = |problem: String, remedy: &str| Err(Error::wire(name, problem, remedy));
    if format.as_str() != Some(FORMAT) {
        return bad(format!("does not say \"format\": \"{FORMAT}\""), WRITTEN);
    }
    match version.as_u64() {
        Some(1..=FORMAT_VERSION) => Ok(()),
        Some(version) if version > FORMAT_VERSION => {
            bad(format!("has version {version}, newer than this program reads ({FORMAT_VERSION})"), "update Wire4D")
        }
        _ => bad("has no valid version".to_owned(), WRITTEN),
    }
}
