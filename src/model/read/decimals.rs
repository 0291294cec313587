//! Numbers in words, as programs of all countries write them.

use super::damaged;
use crate::Error;

/// Reads numbers with a decimal point or a decimal comma: one file has the one or the other, or nobody could tell a
/// decimal comma from one between thousands.
#[derive(Debug, Default)]
pub(super) struct Decimals {
    point: bool,
    comma: bool,
}

/// Why a word is no number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    Word,
    Comma,
}

impl Decimals {
    /// A number; a comma after it only parts it from the next.
    pub(super) fn number(&mut self, word: &[u8]) -> Result<f64, Fault> {
        let word = word.strip_suffix(b",").unwrap_or(word);
        let commas = word.iter().filter(|&&byte| byte == b',').count();
        self.comma |= commas > 0;
        self.point |= word.contains(&b'.');
        if commas > 1 || self.comma && self.point {
            return Err(Fault::Comma);
        }
        let text = std::str::from_utf8(word).map_err(|_| Fault::Word)?;
        if commas == 0 { text.parse() } else { text.replace(',', ".").parse() }.map_err(|_| Fault::Word)
    }

    /// Three numbers, the next of `words`.
    pub(super) fn point<'a>(&mut self, mut words: impl Iterator<Item = &'a [u8]>) -> Result<[f64; 3], Fault> {
        let mut point = [0.0; 3];
        for c in &mut point {
            *c = self.number(words.next().ok_or(Fault::Word)?)?;
        }
        Ok(point)
    }
}

impl Fault {
    /// As an error about the corner at `place`.
    pub(super) fn at(self, name: &str, place: &str) -> Error {
        match self {
            Fault::Word => damaged(name, format!("{place} has a corner that is not three numbers")),
            Fault::Comma => {
                let problem = format!("{place} has decimal commas that can be read in more than one way");
                Error::input(name, problem, "save it with decimal points")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_or_commas_but_not_both() {
        let all = |words: &str| {
            let mut decimals = Decimals::default();
            words.split(' ').map(|word| decimals.number(word.as_bytes())).collect::<Result<Vec<f64>, Fault>>()
        };
        assert_eq!(all("1.5 -2 +3e-1").unwrap(), [1.5, -2.0, 0.3]);
        assert_eq!(all("1,5 -2 3,25e2 -,5").unwrap(), [1.5, -2.0, 325.0, -0.5]);
        assert_eq!(all("1.5, -2, 3").unwrap(), [1.5, -2.0, 3.0]);
        for mixed in ["1,5 2.5", "1.5 2,5", "1,234.5", "1,234,567", "1,2,3"] {
            assert_eq!(all(mixed).unwrap_err(), Fault::Comma, "{mixed}");
        }
        for word in ["", ",", "x", "1,x", "1.2.3", "0x10"] {
            assert_eq!(all(word).unwrap_err(), Fault::Word, "{word}");
        }
    }
}
