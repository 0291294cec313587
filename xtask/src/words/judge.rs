//! The network that guided nothing: what it takes a picture for. See `tools/iconnet/iconnet/names.py`.

use crate::Result;
use crate::shell::command;
use serde_json::Value;
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// The judge with all names that it chooses from.
pub struct Judge {
    network: PathBuf,
    table: HashMap<String, Vec<f64>>,
    names: Vec<String>,
    asked: Vec<String>,
    /// The mean of what it sees in wires.
    usual: Vec<f64>,
    /// The names' rows, centred and made unit, and the centre.
    rows: Vec<Vec<f64>>,
    centre: Vec<f64>,
}

impl Judge {
    /// From the folder of the weights.
    pub fn open(folder: &Path) -> Result<Judge> {
        let read = |name: &str| -> Result<Value> { Ok(serde_json::from_slice(&std::fs::read(folder.join(name))?)?) };
        let (judge, table) = (read("judge.json")?, read("words.json")?);
        let list = |of: &Value| serde_json::from_value::<Vec<String>>(of.clone());
        let (names, asked, words) = (list(&judge["words"])?, list(&judge["asked"])?, list(&table["words"])?);
        let usual: Vec<f64> = serde_json::from_value(judge["usual"].clone())?;
        let bytes = std::fs::read(folder.join("words.bin"))?;
        let rows = bytes.chunks_exact(usual.len().max(1));
        let rows = rows.map(|row| unit(row.iter().map(|&byte| f64::from(byte as i8)).collect()));
        let table: HashMap<String, Vec<f64>> = words.into_iter().zip(rows).collect();
        let found = names.iter().map(|name| table.get(name).ok_or(format!("no word {name:?}")));
        let found = found.collect::<Result<Vec<_>, _>>()?;
        let mean = |k: usize| found.iter().map(|row| row[k]).sum::<f64>() / found.len() as f64;
        let centre: Vec<f64> = (0..usual.len()).map(mean).collect();
        let rows = found.iter().map(|row| unit(less(row, &centre))).collect();
        Ok(Judge { network: folder.join("iconnet-judge.onnx"), table, names, asked, usual, rows, centre })
    }

    /// How many names it chooses from.
    pub fn count(&self) -> usize {
        self.rows.len()
    }

    /// The words of the trials.
    pub fn asked(&self) -> &[String] {
        &self.asked
    }

    /// What it sees in pictures of ink.
    pub fn see(&self, pictures: &[PathBuf]) -> Result<Vec<Vec<f64>>> {
        let output = command("target/debug/examples/embed").arg(&self.network).args(pictures).output()?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned().into());
        }
        let lines = String::from_utf8(output.stdout)?;
        Ok(lines.lines().map(serde_json::from_str).collect::<Result<_, _>>()?)
    }

    /// The rank of a word for what it has seen, from 1, and the name that comes first.
    pub fn rank(&self, seen: &[f64], word: &str) -> Result<(usize, String)> {
        let seen = less(seen, &self.usual);
        let row = self.table.get(word).ok_or(format!("{word:?} is not in the word table"))?;
        let own = dot(&unit(less(row, &self.centre)), &seen);
        let scores: Vec<f64> = self.rows.iter().map(|row| dot(row, &seen)).collect();
        let above = self.names.iter().zip(&scores).filter(|(name, score)| *name != word && **score > own).count();
        let first = scores.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).map_or(0, |(first, _)| first);
        Ok((above + 1, self.names[first].clone()))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn less(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn unit(row: Vec<f64>) -> Vec<f64> {
    let length = dot(&row, &row).sqrt();
    row.into_iter().map(|value| value / length).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shell::root;

    #[test]
    fn what_looks_like_a_word_is_ranked_first_and_what_looks_like_none_last() {
        let judge = Judge::open(&root().join("tools/iconnet/weights")).unwrap();
        assert_eq!((judge.count(), judge.asked().len()), (1488, 20));
        for (at, word) in judge.names.iter().enumerate().step_by(100) {
            let seen = |sign: f64| {
                judge.rows[at].iter().zip(&judge.usual).map(|(row, usual)| usual + sign * row).collect::<Vec<_>>()
            };
            assert_eq!(judge.rank(&seen(0.3), word).unwrap(), (1, word.clone()));
            assert_eq!(judge.rank(&seen(-0.3), word).unwrap().0, judge.count());
        }
        assert!(judge.rank(&judge.usual, "no such word at all").is_err());
    }
}
