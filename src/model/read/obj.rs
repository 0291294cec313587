//! Wavefront OBJ: `v x y z` and `f a b c …`, where a corner is `index/texture/normal`; negative indices count back.

use super::{Soup, check_count, damaged};
use crate::Result;

fn lines(text: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    text.split(|&byte| byte == b'\n' || byte == b'\r').enumerate().map(|(i, line)| (i + 1, line.trim_ascii()))
}

fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// Whether a line near the beginning says so.
pub(super) fn is_obj(text: &[u8]) -> bool {
    lines(text).take(10_000).any(|(_, line)| {
        [&b"v "[..], b"v\t", b"vn ", b"vt ", b"f ", b"o ", b"g ", b"mtllib ", b"usemtl "]
            .iter()
            .any(|w| line.starts_with(w))
            && std::str::from_utf8(line).is_ok_and(|line| !line.contains('\0'))
    })
}

pub(super) fn read(name: &str, text: &[u8]) -> Result<Soup> {
    let mut soup = Soup::default();
    let mut polygon = Vec::new();
    for (number, line) in lines(text) {
        let mut words = words(line);
        match words.next() {
            Some(b"v") => {
                let mut point = [0.0; 3];
                for c in &mut point {
                    *c = words
                        .next()
                        .and_then(parsed::<f64>)
                        .ok_or_else(|| damaged(name, format!("line {number} is no corner of three numbers")))?;
                }
                soup.positions.push(point);
            }
            Some(b"f") => {
                polygon.clear();
                for word in words {
                    let index = word.split(|&byte| byte == b'/').next().and_then(parsed::<i64>).unwrap_or(0);
                    let count = soup.positions.len() as i64;
                    let index = if index < 0 { count + index } else { index - 1 };
                    // Corners may follow later: mending checks the upper end.
                    let index = u32::try_from(index)
                        .map_err(|_| damaged(name, format!("line {number} names a corner that is not there")))?;
                    polygon.push(index);
                }
                check_count(name, soup.triangles.len() + polygon.len().saturating_sub(2))?;
                soup.add_polygon(&polygon);
            }
            _ => {}
        }
    }
    Ok(soup)
}

pub(super) fn parsed<T: std::str::FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
