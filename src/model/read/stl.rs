//! STL: triangles one by one, as 50 bytes after a header of 84, or in words.

use super::decimals::Decimals;
use super::{Soup, check_count, damaged};
use crate::Result;

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// How many triangles the header announces.
fn announced(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..HEADER)?;
    Some(u32::from_le_bytes([count[0], count[1], count[2], count[3]]) as usize)
}

/// How many are there, if the file ends just after the last of them.
fn there(bytes: &[u8]) -> Option<usize> {
    let rest = bytes.len().checked_sub(HEADER)?;
    (rest > 0 && rest % TRIANGLE == 0).then_some(rest / TRIANGLE)
}

/// Counts of programs that did not know it when they began to write.
fn is_unknown(count: usize) -> bool {
    count == 0 || count == u32::MAX as usize
}

/// Whether the length is just what the header says, or leaves to the length to say; binary files, too, may begin with
/// "solid".
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    there(bytes).is_some_and(|there| announced(bytes).is_some_and(|count| count == there || is_unknown(count)))
}

/// Whether it begins as the kind in words does, and goes on in words: a damaged binary file may begin so, too.
pub(super) fn is_text(text: &[u8]) -> bool {
    text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid") && !text.iter().take(1000).any(|&byte| byte == 0)
}

pub(super) fn read_binary(name: &str, bytes: &[u8]) -> Result<Soup> {
    let announced = announced(bytes).ok_or_else(|| damaged(name, "ends within its header"))?;
    let whole = (bytes.len() - HEADER) / TRIANGLE;
    // The length cannot be wrong, the header can.
    let count = there(bytes).filter(|&there| there > announced || is_unknown(announced)).unwrap_or(announced);
    if is_unknown(count) && whole > 0 {
        return Err(damaged(name, format!("announces {announced} triangles, and ends within the one after {whole}")));
    }
    if whole < count {
        return Err(damaged(name, format!("ends after {whole} of {count} triangles")));
    }
    check_count(name, count)?;
    let mut soup = Soup::default();
    for triangle in bytes[HEADER..].chunks_exact(TRIANGLE).take(count) {
        let mut numbers =
            triangle[12..48].chunks_exact(4).map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])));
        let mut corner = || std::array::from_fn(|_| numbers.next().unwrap_or(0.0));
        soup.add_triangle([corner(), corner(), corner()]);
    }
    if count != announced {
        soup.notes.push(format!("{announced} triangles were announced, {count} are there"));
    }
    Ok(soup)
}

/// A word that matters.
#[derive(PartialEq)]
enum Word {
    Solid,
    EndSolid,
    Facet,
    EndFacet,
    EndLoop,
    Vertex,
    Other,
}

pub(super) fn read_text(name: &str, text: &[u8]) -> Result<Soup> {
    let mut soup = Soup::default();
    let mut decimals = Decimals::default();
    let (mut ended, mut naming) = (false, false);
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut rest = text;
    while let Some((first, begins_line)) = next_word(&mut rest) {
        let word = word(first, &mut rest);
        // A solid's name is any words to the end of the line; or to its first facet, if all is one line.
        naming = naming && !begins_line && word != Word::Facet;
        if naming {
            continue;
        }
        let closes = matches!(word, Word::EndLoop | Word::EndFacet | Word::Facet | Word::EndSolid);
        if closes && !corners.is_empty() {
            let &[a, b, c] = &corners[..] else {
                let problem = format!("facet {} has {} corners instead of three", soup.triangles.len(), corners.len());
                return Err(damaged(name, problem));
            };
            check_count(name, soup.triangles.len() + 1)?;
            soup.add_triangle([a, b, c]);
            corners.clear();
        }
        match word {
            Word::Solid | Word::EndSolid | Word::Facet => {
                ended = word == Word::EndSolid;
                naming = word != Word::Facet;
            }
            Word::Vertex => {
                let words = std::iter::from_fn(|| next_word(&mut rest).map(|(word, _)| word));
                let point = decimals.point(words);
                corners.push(point.map_err(|fault| fault.at(name, &format!("facet {}", soup.triangles.len())))?);
            }
            _ => {}
        }
    }
    if !corners.is_empty() || !ended {
        return Err(damaged(name, format!("ends after facet {} without its last line", soup.triangles.len())));
    }
    Ok(soup)
}

/// What a word means; some programs write ends apart (`end loop`), others a name close to them (`endsolidName`).
fn word(first: &[u8], rest: &mut &[u8]) -> Word {
    let is = |what: &[u8]| first.eq_ignore_ascii_case(what);
    let ends = |what: &[u8], rest: &mut &[u8]| {
        let mut after = *rest;
        let same_line =
            next_word(&mut after).filter(|(word, begins_line)| !begins_line && word.eq_ignore_ascii_case(what));
        if same_line.is_some() {
            *rest = after;
        }
        same_line.is_some()
    };
    if is(b"end") {
        match () {
            () if ends(b"loop", rest) => Word::EndLoop,
            () if ends(b"facet", rest) => Word::EndFacet,
            () if ends(b"solid", rest) => Word::EndSolid,
            () => Word::Other,
        }
    } else if is(b"vertex") {
        Word::Vertex
    } else if is(b"facet") {
        Word::Facet
    } else if is(b"endloop") {
        Word::EndLoop
    } else if is(b"endfacet") {
        Word::EndFacet
    } else if is(b"solid") {
        Word::Solid
    } else if first.get(..8).is_some_and(|start| start.eq_ignore_ascii_case(b"endsolid")) {
        Word::EndSolid
    } else {
        Word::Other
    }
}

/// The next word, and whether a new line begins before it.
fn next_word<'a>(rest: &mut &'a [u8]) -> Option<(&'a [u8], bool)> {
    let (space, words) = rest.split_at(rest.iter().position(|byte| !byte.is_ascii_whitespace())?);
    let (word, after) = words.split_at(words.iter().position(u8::is_ascii_whitespace).unwrap_or(words.len()));
    *rest = after;
    Some((word, space.iter().any(|byte| b"\n\r".contains(byte))))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACET: &str = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

    fn facets(words: &str) -> Result<usize> {
        read_text("a.stl", words.as_bytes()).map(|soup| soup.triangles.len())
    }

    #[test]
    fn every_solid_has_an_end() {
        let one = format!("solid a\n{FACET}endsolid a\n");
        assert_eq!(facets(&format!("{one}{one}")).unwrap(), 2);
        for cut in [format!("{one}solid b\n{FACET}"), format!("{one}{FACET}"), format!("{one}solid b")] {
            let error = facets(&cut).unwrap_err().to_string();
            assert!(error.contains("without its last line"), "{error}");
        }
    }

    #[test]
    fn a_solid_may_have_any_name() {
        for name in ["my vertex model", "endsolid", "endloop vertex", "solid", "end solid", "end loop"] {
            assert_eq!(facets(&format!("solid {name}\r\n{FACET}endsolid {name}\n")).unwrap(), 1, "{name}");
        }
        let line = format!("solid a\n{FACET}endsolid a\nsolid b\n{FACET}endsolid b").replace('\n', " ");
        assert_eq!(facets(&line).unwrap(), 2, "all in one line");
    }

    #[test]
    fn ends_are_written_in_many_ways() {
        let one = format!("solid a\n{FACET}{FACET}endsolid a\n");
        for (what, instead) in [
            ("endloop", "end loop"),
            ("endfacet", "end facet"),
            ("endsolid", "end solid"),
            ("endsolid a", "endsolida"),
            ("endsolid a", "ENDSOLID"),
            ("solid a\nfacet", "solid a\nsolid b c\nfacet"),
            ("endsolid a", "endsolid b c\nendsolid a"),
            ("endloop\n", ""),
            ("endfacet\n", ""),
        ] {
            assert_eq!(facets(&one.replace(what, instead)).unwrap(), 2, "{instead}");
        }
        let error = facets(&one.replace("vertex 0 0 0\n", "")).unwrap_err().to_string();
        assert!(error.contains("facet 0 has 2 corners"), "{error}");
    }

    #[test]
    fn the_length_says_what_the_header_does_not() {
        let file = |announced: u32, bytes: usize| {
            let mut file = vec![b' '; 80];
            file.extend(announced.to_le_bytes());
            file.resize(HEADER + bytes, 1);
            file
        };
        for (announced, there, says) in [(3, 3, false), (0, 3, true), (u32::MAX, 3, true), (2, 3, true)] {
            let soup = read_binary("a.stl", &file(announced, there * TRIANGLE)).unwrap();
            assert_eq!((soup.triangles.len(), soup.notes.len()), (there, usize::from(says)), "{announced}");
        }
        // What is not whole triangles may be anything.
        assert_eq!(read_binary("a.stl", &file(2, 3 * TRIANGLE + 7)).unwrap().triangles.len(), 2);
        for (announced, bytes, problem) in [
            (0, 3 * TRIANGLE + 7, "announces 0 triangles, and ends within the one after 3"),
            (u32::MAX, 3 * TRIANGLE + 7, "announces 4294967295 triangles"),
            (4, 3 * TRIANGLE, "ends after 3 of 4 triangles"),
            (0x5000_0000, 3 * TRIANGLE, "ends after 3 of 1342177280 triangles"),
        ] {
            let error = read_binary("a.stl", &file(announced, bytes)).unwrap_err().to_string();
            assert!(error.contains(problem), "{error}");
        }
    }
}
