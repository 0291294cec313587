//! The share code: a wire, its views and its seed in so few URL-safe characters that a link can carry them.
//!
//! Control points are rounded to a grid so fine that nothing moves by 0.3 px at 512 px in any of the views, guessed from
//! those before, and what the guess missed is range coded with learned probabilities. A code is base64url of
//! `[version][range-coded contents][CRC-32 of all before]`. Settings are not carried.
//!
//! Version 1 guessed each coordinate by itself; its codes still open.

mod contents;
mod grid;
mod guess;
mod pasted;
mod range;
pub mod replay;
mod series;
mod simplified;

pub use simplified::{Simplified, simplified_code};

use crate::sculpture::{Carried, MadeWith, Sculpture};
use crate::wire::Wire;
use crate::{Error, Result};
use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use contents::{Contents, KnotCode};
use grid::Rounded;
use range::{Decoder, Encoder};

/// First byte of a code; the checksum's place is the same in all versions.
const VERSION: u8 = 2;
/// Longer texts are refused unread: much may stand round a link.
const MAX_TEXT_CHARACTERS: usize = 1 << 20;
/// 64 kB; a wire of 20,000 control points needs less.
const MAX_CODE_CHARACTERS: usize = (64 << 10) * 4 / 3 + 2;
const MAX_TASK_BYTES: usize = 256;

/// Fineness of knots that are no halvings: 0.07% a step.
const STEPS_PER_OCTAVE: u64 = 512;

/// The share code of a sculpture: letters, digits, `-` and `_` only.
pub fn share_code(sculpture: &Sculpture) -> String {
    code_of(sculpture, grid::rounded(sculpture))
}

fn code_of(sculpture: &Sculpture, rounded: Rounded) -> String {
    let mut encoder = Encoder::new();
    // Writing meets no nonsense: the limits are those of valid wires and views.
    let written = contents(sculpture, rounded).transcode(&mut encoder, VERSION);
    debug_assert!(written.is_ok());
    let mut bytes = vec![VERSION];
    bytes.extend(encoder.finish());
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    URL_SAFE_NO_PAD.encode(&bytes)
}

/// The sculpture of a link or a share code in `text`, whatever e-mail, a chat or a document did to it.
///
/// # Errors
/// As [`open_share_code`].
pub fn open_link(text: &str) -> Result<Sculpture> {
    if text.len() > MAX_TEXT_CHARACTERS {
        return Err(too_long());
    }
    let codes = pasted::codes_in(text);
    let Some(first) = codes.first() else {
        return Err(if text.trim().is_empty() || text.trim_end().ends_with(['=', '#']) {
            bad("is empty", "copy the whole code or link")
        } else {
            bad("is neither a link to a wire nor a code", "copy the whole link, from https to its end")
        });
    };
    open_share_code(codes.iter().find(|code| body(code).is_some()).unwrap_or(first))
}

/// The sculpture of a share code.
///
/// # Errors
/// [`Error::ShareCode`] for anything that is damaged, foreign or newer than this program.
pub fn open_share_code(code: &str) -> Result<Sculpture> {
    let damaged = || bad("is damaged or incomplete", "copy the whole code or link again");
    if code.len() > MAX_CODE_CHARACTERS {
        return Err(too_long());
    }
    let body = body(code).ok_or_else(damaged)?;
    let (&version, packed) = body.split_first().ok_or_else(damaged)?;
    if version > VERSION {
        return Err(bad(&format!("has version {version}, newer than this program reads ({VERSION})"), "update Wire4D"));
    }
    if version == 0 {
        return Err(damaged());
    }
    let mut contents = Contents::default();
    contents.transcode(&mut Decoder::new(packed), version).map_err(|_| damaged())?;
    sculpture(contents).map_err(|error| match error {
        Error::Wire { problem, .. } => bad(&format!("holds no valid wire ({problem})"), "ask for a new code"),
        _ => damaged(),
    })
}

/// What is in a code, if its checksum is right.
fn body(code: &str) -> Option<Vec<u8>> {
    if code.len() > MAX_CODE_CHARACTERS {
        return None;
    }
    let mut bytes = URL_SAFE_NO_PAD.decode(code).ok()?;
    let (body, checksum) = bytes.split_last_chunk::<4>()?;
    let whole = crc32fast::hash(body) == u32::from_le_bytes(*checksum);
    bytes.truncate(bytes.len() - 4);
    whole.then_some(bytes)
}

fn too_long() -> Error {
    bad("is longer than any code", "copy only the code or the link")
}

fn bad(problem: &str, remedy: &str) -> Error {
    Error::ShareCode { problem: problem.to_owned(), remedy: remedy.to_owned() }
}

fn contents(sculpture: &Sculpture, Rounded { steps, points }: Rounded) -> Contents {
    let wire = &sculpture.wire;
    let mut task = sculpture.made_with.task.clone();
    while task.len() > MAX_TASK_BYTES {
        task.pop();
    }
    Contents {
        form: wire.form(),
        closed: wire.closed(),
        steps,
        control_points: points,
        knots: knot_code(wire),
        views: sculpture.views.clone(),
        task,
        seed: sculpture.made_with.seed,
    }
}

fn knot_code(wire: &Wire) -> KnotCode {
    let domain = &wire.knots()[3..wire.knots().len() - 3];
    let widths: Vec<f64> = domain.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let longest = widths.iter().copied().fold(0.0, f64::max);
    let halvings = |width: f64| (longest / width).log2();
    let whole = |x: f64| (x - x.round()).abs() < 1e-9 && x < 32.0;
    let per_octave =
        if widths.iter().all(|&width| width == 0.0 || whole(halvings(width))) { 1 } else { STEPS_PER_OCTAVE };
    let interval = |&width: &f64| match width > 0.0 {
        true => 1 + (halvings(width) * per_octave as f64).round() as i64,
        false => 0,
    };
    // In single precision: what opening sums up again differs in the last bits, and sharing that must give the same code.
    let longest = f64::from(longest as f32);
    KnotCode { start: domain[0], longest, per_octave, intervals: widths.iter().map(interval).collect() }
}

fn sculpture(contents: Contents) -> Result<Sculpture> {
    let Contents { form, closed, steps, control_points, knots, views, task, seed } = contents;
    let control_points = control_points.into_iter().map(|point| grid::point_from(point, steps)).collect();
    let wire = Wire::new(form, closed, knots_from(&knots, closed), control_points)?;
    for view in &views {
        view.check()?;
    }
    let made_with = MadeWith { task, seed, ..MadeWith::default() };
    Ok(Sculpture { wire, views, made_with, carried: Carried::default() })
}

fn knots_from(code: &KnotCode, closed: bool) -> Vec<f64> {
    let width = |&interval: &i64| match interval {
        0 => 0.0,
        _ => code.longest * (-((interval - 1) as f64) / code.per_octave as f64).exp2(),
    };
    let mut domain = vec![code.start];
    let mut sum = 0.0;
    for interval in &code.intervals {
        sum += width(interval);
        domain.push(code.start + sum);
    }
    let last = domain.len() - 1;
    let (start, end) = (domain[0], domain[last]);
    let beyond = |i: usize| if closed && last >= 3 { (domain[last - i] - sum, domain[i] + sum) } else { (start, end) };
    let before: Vec<f64> = (1..=3).rev().map(|i| beyond(i).0).collect();
    let after: Vec<f64> = (1..=3).map(|i| beyond(i).1).collect();
    [before, domain, after].concat()
}
