//! STL: triangles one by one, as 50 bytes after a header of 84, or in words.

use super::obj::parsed;
use super::{Soup, check_count, damaged};
use crate::Result;

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

fn said(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..HEADER)?;
    Some(u32::from_le_bytes([count[0], count[1], count[2], count[3]]) as usize)
}

/// Whether the length is just what the header says; binary files, too, may begin with "solid".
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    said(bytes).is_some_and(|count| count > 0 && HEADER as u64 + TRIANGLE as u64 * count as u64 == bytes.len() as u64)
}

/// Whether it begins as the kind in words does, and goes on in words: a damaged binary file may begin so, too.
pub(super) fn is_text(text: &[u8]) -> bool {
    text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid") && !text.iter().take(1000).any(|&byte| byte == 0)
}

pub(super) fn read_binary(name: &str, bytes: &[u8]) -> Result<Soup> {
    let count = said(bytes).ok_or_else(|| damaged(name, "ends within its header"))?;
    check_count(name, count)?;
    let whole = (bytes.len() - HEADER) / TRIANGLE;
    if whole < count {
        return Err(damaged(name, format!("ends after {whole} of {count} triangles")));
    }
    let mut soup = Soup::default();
    for triangle in bytes[HEADER..].chunks_exact(TRIANGLE).take(count) {
        let mut numbers =
            triangle[12..48].chunks_exact(4).map(|b| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])));
        soup.add_triangle(|| std::array::from_fn(|_| numbers.next().unwrap_or(0.0)));
    }
    Ok(soup)
}

pub(super) fn read_text(name: &str, text: &[u8]) -> Result<Soup> {
    let mut soup = Soup::default();
    let (mut ended, mut naming) = (false, false);
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut rest = text;
    while let Some((word, begins_line)) = next_word(&mut rest) {
        let is = |what: &[u8]| word.eq_ignore_ascii_case(what);
        // A solid's name is any words to the end of the line; or to its first facet, if all is one line.
        naming = naming && !begins_line && !is(b"facet");
        if naming {
            continue;
        }
        if is(b"solid") || is(b"endsolid") || is(b"facet") {
            ended = is(b"endsolid");
            naming = !is(b"facet");
        } else if is(b"vertex") {
            let mut point = [0.0; 3];
            for c in &mut point {
                *c = next_word(&mut rest).and_then(|(word, _)| parsed(word)).ok_or_else(|| {
                    damaged(name, format!("corner {} is not three numbers", 3 * soup.triangles.len() + corners.len()))
                })?;
            }
            corners.push(point);
        } else if is(b"endloop") {
            if corners.len() != 3 {
                let problem = format!("facet {} has {} corners instead of three", soup.triangles.len(), corners.len());
                return Err(damaged(name, problem));
            }
            check_count(name, soup.triangles.len() + 1)?;
            let mut points = corners.drain(..);
            soup.add_triangle(|| points.next().unwrap_or_default());
        }
    }
    if !corners.is_empty() || !ended {
        return Err(damaged(name, format!("ends after facet {} without its last line", soup.triangles.len())));
    }
    Ok(soup)
}

/// The next word, and whether a new line begins before it.
fn next_word<'a>(rest: &mut &'a [u8]) -> Option<(&'a [u8], bool)> {
    let (space, words) = rest.split_at(rest.iter().position(|byte| !byte.is_ascii_whitespace())?);
    let (word, after) = words.split_at(words.iter().position(u8::is_ascii_whitespace).unwrap_or(words.len()));
    *rest = after;
    Some((word, space.iter().any(|byte| b"\n\r".contains(byte))))
}

impl Soup {
    /// Adds a triangle with corners of its own.
    fn add_triangle(&mut self, mut corner: impl FnMut() -> [f64; 3]) {
        let base = self.positions.len() as u32;
        self.positions.extend([corner(), corner(), corner()]);
        self.triangles.push([base, base + 1, base + 2]);
    }
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
        for name in ["my vertex model", "endsolid", "endloop vertex", "solid"] {
            assert_eq!(facets(&format!("solid {name}\r\n{FACET}endsolid {name}\n")).unwrap(), 1, "{name}");
        }
        let line = format!("solid a\n{FACET}endsolid a\nsolid b\n{FACET}endsolid b").replace('\n', " ");
        assert_eq!(facets(&line).unwrap(), 2, "all in one line");
    }
}
