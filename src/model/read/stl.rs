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
    let mut ended = false;
    let mut corners: Vec<[f64; 3]> = Vec::new();
    let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    while let Some(word) = words.next() {
        ended = word.eq_ignore_ascii_case(b"endsolid") || ended;
        if word.eq_ignore_ascii_case(b"vertex") {
            let mut point = [0.0; 3];
            for c in &mut point {
                *c = words.next().and_then(parsed).ok_or_else(|| {
                    damaged(name, format!("corner {} is not three numbers", 3 * soup.triangles.len() + corners.len()))
                })?;
            }
            corners.push(point);
        } else if word.eq_ignore_ascii_case(b"endloop") {
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

impl Soup {
    /// Adds a triangle with corners of its own.
    fn add_triangle(&mut self, mut corner: impl FnMut() -> [f64; 3]) {
        let base = self.positions.len() as u32;
        self.positions.extend([corner(), corner(), corner()]);
        self.triangles.push([base, base + 1, base + 2]);
    }
}
