//! Text encoders from text-v1 files, and CLIP's tokenizer. Source of the tokens: `tools/guidance/guidance/tokens.py`.

use crate::graph::{Graph, Port};
use crate::sidecar::{Kind, Sidecar, json, size_fault, unit};
use serde::Deserialize;
use std::collections::HashMap;
use std::path::Path;
use wire4d_core::{Error, Result};

/// A text-v1 file with its tokenizer, checked and ready to run.
pub struct TextEncoder {
    graph: Graph,
    embed: usize,
    tokenizer: Tokenizer,
}

/// What its sidecar says.
#[derive(Deserialize)]
struct Own {
    /// Tokens of a prompt.
    context: usize,
    embed: usize,
    /// The tokenizer's file.
    #[serde(default)]
    tokenizer: Option<String>,
}

impl Kind for Own {
    const NAME: &str = "text-v1";

    fn fault(&self) -> Option<String> {
        size_fault("context", self.context, 1024).or_else(|| size_fault("embed", self.embed, 16_384))
    }
}

impl TextEncoder {
    /// Opens `file` with the sidecar and the tokenizer beside it.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is missing, damaged or of another kind, [`Error::Guidance`] for one that is not
    /// computed rightly here.
    pub fn open(file: &Path) -> Result<TextEncoder> {
        let (Sidecar { selftest, own, .. }, bytes) = Sidecar::<Own>::with_file(file)?;
        let name = file.display().to_string();
        let remedy = "export the text encoder again, with its tokenizer";
        // A name alone: a sidecar must not point anywhere else.
        let beside = own.tokenizer.as_deref().filter(|name| Path::new(name).file_name() == Some(name.as_ref()));
        let Some(beside) = beside else { return Err(Error::input(name, "has no tokenizer beside it", remedy)) };
        let path = file.with_file_name(beside);
        let tokenizer = Tokenizer::new(json(&path, remedy)?, own.context)
            .ok_or_else(|| Error::input(path.display().to_string(), "is no tokenizer of this text encoder", remedy))?;
        let mut ids = Port::new("ids", [None, Some(own.context)]);
        ids.is_integer = true;
        let embedding = Port::new("embedding", [None, Some(own.embed)]);
        let graph = Graph::open(&name, &bytes, vec![ids], vec![embedding])?;
        selftest.check(&graph)?;
        Ok(TextEncoder { graph, embed: own.embed, tokenizer })
    }

    /// Numbers a vector.
    pub fn embed(&self) -> usize {
        self.embed
    }

    /// The unit vector of words.
    ///
    /// # Errors
    /// [`Error::Setting`] for words without a letter, [`Error::Guidance`] where the encoder fails.
    pub fn vector(&self, words: &str) -> Result<Vec<f32>> {
        let ids = self.tokenizer.ids(words);
        let ids = ids.ok_or_else(|| Error::setting(format!("{words:?}"), "has no words", "say what should be seen"))?;
        Ok(unit(&self.graph.run(vec![ids.into()], 1)?.remove(0)))
    }
}

/// `NAME.tokenizer.json`.
#[derive(Deserialize)]
struct TokenizerFile {
    kind: String,
    context: usize,
    pad: i32,
    merges: Vec<String>,
}

/// Byte pairs, lower case, padded to a fixed length (Radford et al. 2021). Letters are what Unicode calls alphabetic, which
/// differs from CLIP's in some marks of Indic scripts; HTML is taken as it is.
struct Tokenizer {
    context: usize,
    pad: i32,
    ids: HashMap<String, i32>,
    ranks: HashMap<(String, String), usize>,
    letters: Vec<char>,
}

/// What marks a word's end.
const END: &str = "</w>";

impl Tokenizer {
    /// None for another kind, another length, or merges that are not two parts each.
    fn new(file: TokenizerFile, context: usize) -> Option<Tokenizer> {
        if file.kind != "clip-bpe" || file.context != context || context < 3 {
            return None;
        }
        let merges = file.merges.iter().map(|merge| {
            let (a, b) = merge.split_once(' ')?;
            Some((a.to_owned(), b.to_owned()))
        });
        let merges: Vec<_> = merges.collect::<Option<_>>()?;
        // A printable character for each byte: those of Latin-1 are themselves, the rest follow from U+0100.
        let is_shown = |byte: &u8| matches!(byte, 33..=126 | 161..=172 | 174..=255);
        let mut others = (256..).filter_map(char::from_u32);
        let letters: Vec<char> = (0..=255)
            .map(|byte| if is_shown(&byte) { char::from(byte) } else { others.next().unwrap_or(' ') })
            .collect();
        let in_order = (0..=255u8).filter(is_shown).chain((0..=255).filter(|byte| !is_shown(byte)));
        let singles: Vec<String> = in_order.map(|byte| letters[usize::from(byte)].to_string()).collect();
        let ends = singles.iter().map(|single| format!("{single}{END}"));
        let words = singles.iter().cloned().chain(ends).chain(merges.iter().map(|(a, b)| format!("{a}{b}")));
        let ids = words.zip(0..).collect();
        let ranks = merges.into_iter().zip(0..).collect();
        Some(Tokenizer { context, pad: file.pad, ids, ranks, letters })
    }

    /// Start, the text's tokens, end, padding; what is too long loses its last tokens. None for a text without any.
    fn ids(&self, text: &str) -> Option<Vec<i32>> {
        let start = 512 + i32::try_from(self.ranks.len()).ok()?;
        let mut ids = vec![start];
        for piece in pieces(&text.to_lowercase()) {
            ids.extend(self.merged(&piece).iter().filter_map(|part| self.ids.get(part)));
        }
        if ids.len() == 1 {
            return None;
        }
        ids.truncate(self.context - 1);
        ids.push(start + 1);
        ids.resize(self.context, self.pad);
        Some(ids)
    }

    /// A piece's parts, after the merge that comes first in the list was made wherever it can be, again and again.
    fn merged(&self, piece: &str) -> Vec<String> {
        let mut parts: Vec<String> = piece.bytes().map(|byte| self.letters[usize::from(byte)].to_string()).collect();
        if let Some(last) = parts.last_mut() {
            last.push_str(END);
        }
        let rank = |pair: &[String]| self.ranks.get(&(pair[0].clone(), pair[1].clone())).copied();
        while let Some(best) = parts.windows(2).filter_map(rank).min() {
            let mut joined: Vec<String> = Vec::new();
            let mut rest = &parts[..];
            while let [first, others @ ..] = rest {
                let both = rest.len() > 1 && rank(&rest[..2]) == Some(best);
                joined.push(if both { format!("{first}{}", others[0]) } else { first.clone() });
                rest = if both { &others[1..] } else { others };
            }
            parts = joined;
        }
        parts
    }
}

/// Contractions, runs of letters, single digits, and runs of anything else that is no space.
fn pieces(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let contraction = ["'s", "'t", "'re", "'ve", "'m", "'ll", "'d"].iter().find(|end| rest.starts_with(**end));
        let run = |is: fn(char) -> bool| rest.find(|c| !is(c)).unwrap_or(rest.len());
        let length = match contraction {
            Some(end) => end.len(),
            None if first.is_alphabetic() => run(char::is_alphabetic),
            None if first.is_numeric() || first.is_whitespace() => first.len_utf8(),
            None => run(|c| !c.is_alphabetic() && !c.is_numeric() && !c.is_whitespace()),
        };
        let piece;
        (piece, rest) = rest.split_at(length);
        if !first.is_whitespace() {
            found.push(piece.to_owned());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing;

    fn tokenizer() -> Tokenizer {
        let merges = ["c a", "ca t</w>", "t h", "th e</w>", "l l"].map(str::to_owned).into();
        Tokenizer::new(TokenizerFile { kind: "clip-bpe".into(), context: 8, pad: 0, merges }, 8).unwrap()
    }

    #[test]
    fn texts_are_cut_as_clips() {
        assert_eq!(pieces("it's 42 cats!? don't"), ["it", "'s", "4", "2", "cats", "!?", "don", "'t"]);
        assert_eq!(pieces("  über\tal"), ["über", "al"]);
        assert!(pieces(" \n").is_empty());
    }

    #[test]
    fn tokens_are_those_of_the_python_side() {
        // `Tokenizer(file_of([("c", "a"), ("ca", "t</w>"), ("t", "h"), ("th", "e</w>"), ("l", "l")], 8))` there.
        let ids = |text| tokenizer().ids(text);
        assert_eq!(ids("The  CAT"), Some(vec![517, 515, 513, 518, 0, 0, 0, 0]));
        assert_eq!(ids("cats"), Some(vec![517, 512, 83, 338, 518, 0, 0, 0]));
        assert_eq!(ids("é 7"), Some(vec![517, 127, 358, 278, 518, 0, 0, 0]));
        assert_eq!(ids("the the the the the the the the"), Some(vec![517, 515, 515, 515, 515, 515, 515, 518]));
        assert_eq!(ids(" "), None);
    }

    #[test]
    fn a_text_encoder_is_opened_and_embeds_words() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
        let onnx = testing::text_encoder();
        std::fs::write(folder.path().join("t.onnx"), &onnx).unwrap();
        let facts = |tokenizer: &str, values: [f64; 2]| {
            let case = serde_json::json!({ "name": "words", "inputs": { "ids": { "fill": "count", "first": 1 } },
                "outputs": { "embedding": { "values": values } } });
            let tolerance = serde_json::json!({ "relative": 0.01, "absolute": 0.001, "cosine": 0.9995 });
            let selftest = serde_json::json!({ "batch": 1, "tolerance": tolerance, "cases": [case] });
            serde_json::json!({ "kind": "text-v1", "name": "t", "context": 8, "embed": 2, "bytes": onnx.len(),
                "sha256": testing::sha256(&onnx), "tokenizer": tokenizer, "selftest": selftest })
            .to_string()
        };
        write("t.tokenizer.json", r#"{"kind": "clip-bpe", "context": 8, "pad": 0, "merges": ["c a"]}"#.into());
        let length = |ids: f64| (ids * ids + 512.0 * 512.0).sqrt();
        write("t.json", facts("t.tokenizer.json", [36.0 / length(36.0), 512.0 / length(36.0)]));
        let encoder = TextEncoder::open(&folder.path().join("t.onnx")).unwrap();
        // Start, the letter at a word's end, end.
        let vector = encoder.vector("a").unwrap();
        let ids = f64::from(513 + 256 + 64 + 514);
        assert!((f64::from(vector[0]) - ids / length(ids)).abs() < 1e-6, "{vector:?}");
        assert!(encoder.vector(" ").unwrap_err().is_bad_input());
        let opened = |text: String| {
            write("t.json", text);
            TextEncoder::open(&folder.path().join("t.onnx")).map(|_| ()).unwrap_err().to_string()
        };
        assert!(opened(facts("../t.tokenizer.json", [0.0, 1.0])).contains("no tokenizer"));
        assert!(opened(facts("t.tokenizer.json", [0.5, 0.5])).contains("not computed rightly"));
    }

    #[test]
    fn other_tokenizers_are_refused() {
        let file = |kind: &str, context, merge: &str| TokenizerFile {
            kind: kind.into(),
            context,
            pad: 0,
            merges: vec![merge.into()],
        };
        assert!(Tokenizer::new(file("clip-bpe", 8, "a b"), 8).is_some());
        assert!(Tokenizer::new(file("unigram", 8, "a b"), 8).is_none());
        assert!(Tokenizer::new(file("clip-bpe", 77, "a b"), 8).is_none());
        assert!(Tokenizer::new(file("clip-bpe", 8, "ab"), 8).is_none());
    }
}
