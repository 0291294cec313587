//! The JSON beside an ONNX file: what a program must know before it opens the file. Anybody may have written it.

use crate::selftest::SelfTest;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::fs;
use std::path::Path;
use wire4d_core::{Error, Result};

/// Bytes of the largest JSON that is read: some ten thousand words with their vectors.
pub const MOST_JSON_BYTES: u64 = 128 << 20;

/// What a sidecar says, as far as it is asked.
#[derive(Debug, Clone, Deserialize)]
pub struct Sidecar {
    /// `guidance-v1` or `text-v1`.
    pub kind: String,
    /// What the network is called.
    pub name: String,
    /// Side of a picture in pixels; of guidance-v1.
    #[serde(default)]
    pub size: usize,
    /// Tokens of a prompt; of text-v1.
    #[serde(default)]
    pub context: usize,
    /// Numbers of an embedding.
    pub embed: usize,
    /// Whose weights these are.
    #[serde(default)]
    pub origin: String,
    /// Under which licence.
    #[serde(default)]
    pub licence: String,
    /// Size of the ONNX file.
    pub bytes: u64,
    /// Its SHA-256, lower-case hexadecimal.
    pub sha256: String,
    /// What it should answer.
    pub selftest: SelfTest,
    /// Words with their vectors.
    #[serde(default)]
    pub embeddings: Vec<Embedding>,
    /// The tokenizer's file; of text-v1.
    #[serde(default)]
    pub tokenizer: Option<String>,
}

/// Words and their vector.
#[derive(Debug, Clone, Deserialize)]
pub struct Embedding {
    /// The words.
    pub prompt: String,
    /// As many numbers as an embedding has.
    pub vector: Vec<f32>,
}

/// Sizes no network here has: what claims more is damaged.
const MOST_SIZE: usize = 1024;
const MOST_EMBED: usize = 16_384;

impl Sidecar {
    /// Reads the sidecar of the ONNX file `file`, and that file, which must be of `kind` and the one meant.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is missing, for a sidecar that is none or is of another kind, for sizes beyond all
    /// reason, and for a file that is not the one the sidecar was written for.
    pub fn with_file(file: &Path, kind: &str) -> Result<(Sidecar, Vec<u8>)> {
        let path = file.with_extension("json");
        let name = path.display().to_string();
        let again = "take the .json that was written beside the .onnx";
        let sidecar: Sidecar = json(&path, again)?;
        if sidecar.kind != kind {
            let problem = format!("is the sidecar of a {} file, and a {kind} file is needed", sidecar.kind);
            return Err(Error::input(name, problem, "give another file"));
        }
        let needed = if kind == "text-v1" { sidecar.context } else { sidecar.size };
        if !(1..=MOST_SIZE).contains(&needed) || !(1..=MOST_EMBED).contains(&sidecar.embed) {
            let problem = format!("says a size of {needed} and embeddings of {} numbers", sidecar.embed);
            return Err(Error::input(name, problem, again));
        }
        if let Some(odd) = sidecar.embeddings.iter().find(|entry| !is_vector(&entry.vector, sidecar.embed)) {
            let problem = format!("what it has for {:?} is no vector of {} numbers", odd.prompt, sidecar.embed);
            return Err(Error::input(name, problem, "export it again with vectors of this network's own text encoder"));
        }
        let bytes = read(file, sidecar.bytes, "give a guidance file, NAME.onnx with NAME.json beside it")?;
        check_sum(file, &bytes, &sidecar.sha256)?;
        Ok((sidecar, bytes))
    }
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
pub fn json<T: for<'a> Deserialize<'a>>(path: &Path, remedy: &str) -> Result<T> {
    let bytes = read(path, MOST_JSON_BYTES, remedy)?;
    serde_json::from_slice(&bytes).map_err(|error| {
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
