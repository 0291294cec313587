//! The JSON beside an ONNX file: what a program must know before it opens the file. Anybody may have written it.

use crate::selftest::SelfTest;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::fs;
use std::io::Read;
use std::path::Path;
use wire4d_core::{Error, Result};

/// Bytes of the largest JSON that is read: some ten thousand words with their vectors.
pub const MOST_JSON_BYTES: u64 = 128 << 20;

/// What every sidecar says, and what one of its kind says besides.
#[derive(Debug, Clone)]
pub struct Sidecar<K> {
    /// What a person should know.
    pub facts: Facts,
    /// What the network should answer.
    pub selftest: SelfTest,
    /// The rest.
    pub own: K,
}

/// What a sidecar of one kind says.
pub trait Kind: DeserializeOwned {
    /// Its name.
    const NAME: &str;

    /// Says which of its numbers no network has: what claims that is damaged.
    fn fault(&self) -> Option<String>;
}

/// What a person should know of a network.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Facts {
    /// What it is called.
    pub name: String,
    /// Whose weights these are.
    #[serde(default)]
    pub origin: String,
    /// Under which licence.
    #[serde(default)]
    pub licence: String,
    /// The file's SHA-256, lower-case hexadecimal.
    pub sha256: String,
}

#[derive(Deserialize)]
struct Named {
    kind: String,
}

#[derive(Deserialize)]
struct Common {
    #[serde(flatten)]
    facts: Facts,
    bytes: u64,
    selftest: SelfTest,
}

impl<K: Kind> Sidecar<K> {
    /// Reads the sidecar of the ONNX file `file`, and that file, which must be the one meant.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is missing or a picture, for a sidecar that is none or is of another kind, for sizes
    /// beyond all reason, and for a file that is not the one the sidecar was written for.
    pub fn with_file(file: &Path) -> Result<(Sidecar<K>, Vec<u8>)> {
        if is_picture(file) {
            let problem = "is a picture, and a network is asked for here";
            let remedy = format!("give a {} file, NAME.onnx with NAME.json beside it", K::NAME);
            return Err(Error::input(file.display().to_string(), problem, remedy));
        }
        let path = file.with_extension("json");
        let name = path.display().to_string();
        let again = "take the .json that was written beside the .onnx";
        let text = read(&path, MOST_JSON_BYTES, again)?;
        let Named { kind } = parsed(&path, &text, again)?;
        if kind != K::NAME {
            let problem = format!("is the sidecar of a {kind} file, and a {} file is needed", K::NAME);
            return Err(Error::input(name, problem, "give another file"));
        }
        let Common { facts, bytes, selftest } = parsed(&path, &text, again)?;
        let own: K = parsed(&path, &text, again)?;
        if let Some(problem) = own.fault() {
            return Err(Error::input(name, problem, again));
        }
        let remedy = format!("give a {} file, NAME.onnx with NAME.json beside it", K::NAME);
        let onnx = read(file, bytes, &remedy)?;
        check_sum(file, &onnx, &facts.sha256)?;
        Ok((Sidecar { facts, selftest, own }, onnx))
    }
}

/// Says so if a size of a network, by name, is none up to `most`.
pub fn size_fault(name: &str, size: usize, most: usize) -> Option<String> {
    (!(1..=most).contains(&size)).then(|| format!("says a {name} of {size}"))
}

/// Whether a file begins as PNG, JPEG, GIF or WebP do.
fn is_picture(file: &Path) -> bool {
    let mut begin = [0; 12];
    let read = fs::File::open(file).and_then(|mut file| file.read_exact(&mut begin));
    let is_webp = begin.starts_with(b"RIFF") && begin.ends_with(b"WEBP");
    read.is_ok()
        && (is_webp || [&b"\x89PNG"[..], b"\xff\xd8\xff", b"GIF8"].iter().any(|magic| begin.starts_with(magic)))
}

/// Whether these can be a direction in a space of `embed` dimensions.
pub fn is_vector(numbers: &[f32], embed: usize) -> bool {
    let length: f32 = numbers.iter().map(|value| value * value).sum();
    numbers.len() == embed && length.is_finite() && length > 0.0
}

/// `numbers` over their length.
pub fn unit(numbers: &[f32]) -> Vec<f32> {
    let length = crate::noise::length(numbers);
    numbers.iter().map(|&value| (f64::from(value) / length) as f32).collect()
}

/// What a JSON file of at most [`MOST_JSON_BYTES`] holds. `remedy` says where to get a better one.
pub fn json<T: DeserializeOwned>(path: &Path, remedy: &str) -> Result<T> {
    parsed(path, &read(path, MOST_JSON_BYTES, remedy)?, remedy)
}

fn parsed<T: DeserializeOwned>(path: &Path, text: &[u8], remedy: &str) -> Result<T> {
    serde_json::from_slice(text).map_err(|error| {
        Error::input(path.display().to_string(), format!("does not say what it should ({error})"), remedy)
    })
}

/// A file's bytes, if they are at most `most`.
pub fn read(path: &Path, most: u64, remedy: &str) -> Result<Vec<u8>> {
    let name = || path.display().to_string();
    let fault = |error: std::io::Error| Error::input(name(), format!("cannot be read ({error})"), remedy);
    let length = fs::metadata(path).map_err(fault)?.len();
    if length > most {
        let problem = format!("has {length} bytes and should have at most {most}");
        return Err(Error::input(name(), problem, "it is damaged, or belongs to another sidecar: fetch both again"));
    }
    fs::read(path).map_err(fault)
}

/// Whether `bytes` of the file `path` have this SHA-256.
pub fn check_sum(path: &Path, bytes: &[u8], sha256: &str) -> Result<()> {
    let found = sha256_of(bytes);
    if found == sha256 {
        return Ok(());
    }
    let problem =
        format!("its SHA-256 is {found}, and its sidecar says {}", sha256.chars().take(64).collect::<String>());
    let remedy = "it is damaged, or belongs to another sidecar: fetch both again";
    Err(Error::input(path.display().to_string(), problem, remedy))
}

/// The SHA-256 of `bytes`, lower-case hexadecimal.
pub fn sha256_of(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}
