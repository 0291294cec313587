//! Words to vectors: a network's own, a table of many, or a text encoder.

use crate::network::OnnxNetwork;
use crate::sidecar::{check_sum, json, read, unit};
use crate::text::TextEncoder;
use serde::Deserialize;
use std::path::Path;
use wire4d_core::objective::Network;
use wire4d_core::{Error, Result};

/// Words a table may have, and numbers a vector.
const MOST: usize = 1 << 20;

/// A table of words beside a network, in place of a text encoder: `NAME.json` says kind, embed, words and the SHA-256 of
/// `NAME.bin`, which holds a row of signed bytes for each word. Only a row's direction counts; a scale for each row, float32,
/// may follow.
#[derive(Debug, Clone, PartialEq)]
pub struct WordTable {
    embed: usize,
    words: Vec<String>,
    rows: Vec<i8>,
}

#[derive(Deserialize)]
struct TableFile {
    kind: String,
    embed: usize,
    sha256: String,
    words: Vec<String>,
}

impl WordTable {
    /// Reads `file`, a `NAME.json`, and the `NAME.bin` beside it.
    ///
    /// # Errors
    /// [`Error::Input`] for files that are missing, damaged or no table.
    pub fn open(file: &Path) -> Result<WordTable> {
        let remedy = "give a word table, NAME.json with NAME.bin beside it";
        let TableFile { kind, embed, sha256, words } = json(file, remedy)?;
        let fault = |problem: String| Error::input(file.display().to_string(), problem, remedy);
        if kind != "word-table-v1" {
            return Err(fault(format!("is of kind {kind}, and a word-table-v1 is needed")));
        }
        let count = words.len();
        if !(1..=MOST).contains(&count) || !(1..=MOST).contains(&embed) {
            return Err(fault(format!("has {count} words of {embed} numbers")));
        }
        let bin = file.with_extension("bin");
        let (plain, scaled) = (count * embed, count * (embed + 4));
        let bytes = read(&bin, scaled as u64, remedy)?;
        check_sum(&bin, &bytes, &sha256)?;
        if bytes.len() != plain && bytes.len() != scaled {
            return Err(fault(format!("has {count} words of {embed} numbers, and its .bin {} bytes", bytes.len())));
        }
        let rows: Vec<i8> = bytes[..plain].iter().map(|&byte| byte as i8).collect();
        match rows.chunks(embed).position(|row| row.iter().all(|&value| value == 0)) {
            Some(at) => Err(fault(format!("has no vector for {:?}", words[at]))),
            None => Ok(WordTable { embed, words, rows }),
        }
    }

    /// Numbers a vector.
    pub fn embed(&self) -> usize {
        self.embed
    }

    /// The unit vector of words, however they are spaced and capitalised.
    pub fn vector(&self, words: &str) -> Option<Vec<f32>> {
        let wanted = plain(words);
        let at = self.words.iter().position(|known| plain(known) == wanted)?;
        let row: Vec<f32> = self.rows[at * self.embed..][..self.embed].iter().map(|&value| f32::from(value)).collect();
        Some(unit(&row))
    }
}

/// All that knows words for one network.
pub struct Dictionary {
    own: Vec<(String, Vec<f32>)>,
    table: Option<WordTable>,
    encoder: Option<TextEncoder>,
}

impl Dictionary {
    /// What came with a network first, then a table, then an encoder.
    ///
    /// # Errors
    /// [`Error::Input`] where table or encoder give vectors of another size than the network's.
    pub fn new(network: &OnnxNetwork, table: Option<WordTable>, encoder: Option<TextEncoder>) -> Result<Dictionary> {
        Dictionary::of(&network.facts().name, network.words().to_vec(), network.embed(), table, encoder)
    }

    /// For what is called `name` and takes vectors of `embed` numbers: `own` first, which may be of any length.
    pub(crate) fn of(
        name: &str,
        own: Vec<(String, Vec<f32>)>,
        embed: usize,
        table: Option<WordTable>,
        encoder: Option<TextEncoder>,
    ) -> Result<Dictionary> {
        let given = [("the word table", table.as_ref().map(WordTable::embed))];
        let given = given.into_iter().chain([("the text encoder", encoder.as_ref().map(TextEncoder::embed))]);
        for (source, found) in given {
            if let Some(found) = found.filter(|&found| found != embed) {
                let problem = format!("has vectors of {found} numbers, and those of {name} have {embed}");
                return Err(Error::input(source, problem, "give the one that belongs to the network"));
            }
        }
        Ok(Dictionary { own, table, encoder })
    }

    /// The unit vector of `words`.
    ///
    /// # Errors
    /// [`Error::Setting`] for words that nobody here knows, with some that are alike.
    pub fn vector(&self, words: &str) -> Result<Vec<f32>> {
        let wanted = plain(words);
        if let Some((_, vector)) = self.own.iter().find(|(known, _)| plain(known) == wanted) {
            return Ok(vector.clone());
        }
        if let Some(vector) = self.table.as_ref().and_then(|table| table.vector(words)) {
            return Ok(vector);
        }
        match &self.encoder {
            Some(encoder) => encoder.vector(words),
            None => Err(self.unknown(words, &wanted)),
        }
    }

    fn unknown(&self, words: &str, wanted: &str) -> Error {
        let own = self.own.iter().map(|(known, _)| known.as_str());
        let table = self.table.iter().flat_map(|table| table.words.iter().map(String::as_str));
        let mut alike: Vec<(usize, &str)> =
            own.chain(table).map(|known| (difference(wanted, &plain(known)), known)).collect();
        alike.sort();
        let alike: Vec<_> = alike.iter().take(5).map(|(_, known)| *known).collect();
        let remedy = match alike[..] {
            [] => "give a --word-table, or a text encoder as --text".to_owned(),
            _ => format!("say it in words it knows, such as {}; or give a text encoder as --text", alike.join(", ")),
        };
        Error::setting(format!("{words:?}"), "is not among the words that this network comes with", remedy)
    }
}

/// Words as they are compared.
fn plain(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Letters to add, to drop or to change to get from one to the other (Levenshtein 1966).
fn difference(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in b.iter().enumerate() {
            let changed = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::sha256;
    use std::fs;

    fn table(words: &[&str], bytes: &[u8], kind: &str) -> Result<WordTable> {
        let folder = tempfile::tempdir().unwrap();
        let facts =
            serde_json::json!({ "kind": kind, "embed": 2, "sha256": sha256(bytes), "words": words, "licence": "none" });
        fs::write(folder.path().join("words.json"), facts.to_string()).unwrap();
        fs::write(folder.path().join("words.bin"), bytes).unwrap();
        WordTable::open(&folder.path().join("words.json"))
    }

    fn own() -> Vec<(String, Vec<f32>)> {
        vec![("a Cat".to_owned(), vec![1.0, 0.0])]
    }

    #[test]
    fn words_are_looked_up_in_order_and_unknown_ones_answered_with_some_alike() {
        let rows: Vec<u8> = [127i8, 0, 3, -4].map(|value| value as u8).into();
        let both = table(&["dog", "black dog"], &rows, "word-table-v1").unwrap();
        let dictionary = Dictionary::of("net", own(), 2, Some(both), None).unwrap();
        assert_eq!(dictionary.vector("A  cat").unwrap(), [1.0, 0.0]);
        assert_eq!(dictionary.vector(" Black dog").unwrap(), [0.6, -0.8]);
        let unknown = dictionary.vector("log").unwrap_err();
        assert!(unknown.is_bad_input() && unknown.to_string().contains("such as dog, "), "{unknown}");
        let scaled = table(&["dog"], &[3, 4, 0, 0, 0, 64], "word-table-v1").unwrap();
        assert_eq!(scaled.vector("dog").unwrap(), [0.6, 0.8]);
        assert!(Dictionary::of("net", own(), 3, Some(scaled), None).is_err());
    }

    #[test]
    fn spoilt_tables_are_refused() {
        assert!(table(&["dog"], &[1, 2], "prompts-v1").unwrap_err().to_string().contains("prompts-v1"));
        assert!(table(&["dog"], &[1, 2, 3], "word-table-v1").unwrap_err().to_string().contains("3 bytes"));
        assert!(table(&["dog"], &[0, 0], "word-table-v1").unwrap_err().to_string().contains("\"dog\""));
        assert!(table(&["dog"], &[1; 9], "word-table-v1").unwrap_err().to_string().contains("at most 6"));
        assert!(table(&[], &[], "word-table-v1").is_err());
        assert!(WordTable::open(Path::new("none.json")).unwrap_err().to_string().contains("none.json"));
    }

    #[test]
    fn differences_are_counted() {
        assert_eq!((difference("kitten", "sitting"), difference("", "ab"), difference("same", "same")), (3, 2, 0));
    }
}
