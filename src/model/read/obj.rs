//! Wavefront OBJ: `v x y z` and `f a b c …`, where a corner is `index/texture/normal`; negative indices count back.

use super::decimals::Decimals;
use super::{Soup, check_count, damaged};
use crate::Result;

/// A line without its comment.
fn bare(line: &[u8]) -> &[u8] {
    line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii()
}

/// The lines without comments, each with the number of its first; one that ends in a backslash goes on in the next.
fn lines(text: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    // Old files end their lines in a carriage return alone.
    let end = if text.contains(&b'\n') { b'\n' } else { b'\r' };
    let (mut rest, mut count) = (text, 0);
    std::iter::from_fn(move || {
        let (number, mut length) = (count + 1, 0);
        while length < rest.len() {
            let line = &rest[length..];
            let line = &line[..line.iter().position(|&byte| byte == end).map_or(line.len(), |at| at + 1)];
            length += line.len();
            count += 1;
            if !bare(line).ends_with(b"\\") {
                break;
            }
        }
        let (line, after) = rest.split_at(length);
        rest = after;
        (length > 0).then(|| (number, bare(line)))
    })
}

fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(|byte| byte.is_ascii_whitespace() || *byte == b'\\').filter(|word| !word.is_empty())
}

/// Whether a line near the beginning says so.
pub(super) fn is_obj(text: &[u8]) -> bool {
    lines(text).take(10_000).any(|(_, line)| {
        let first = words(line).next().unwrap_or_default();
        let known = [&b"v"[..], b"vn", b"vt", b"f", b"o", b"g", b"mtllib", b"usemtl"].contains(&first);
        known && line.len() > first.len() && std::str::from_utf8(line).is_ok_and(|line| !line.contains('\0'))
    })
}

pub(super) fn read(name: &str, text: &[u8]) -> Result<Soup> {
    let mut soup = Soup::default();
    let mut polygon = Vec::new();
    let mut decimals = Decimals::default();
    for (number, line) in lines(text) {
        let mut words = words(line);
        match words.next() {
            Some(b"v") => {
                let point = decimals.point(words).map_err(|fault| fault.at(name, &format!("line {number}")))?;
                soup.positions.push(point);
            }
            Some(b"f") => {
                polygon.clear();
                for word in words {
                    let word = word.split(|&byte| byte == b'/').next().unwrap_or_default();
                    let index = whole(word).ok_or_else(|| {
                        let word = String::from_utf8_lossy(&word[..word.len().min(30)]);
                        damaged(
                            name,
                            format!("line {number} names a corner by \"{word}\", which is not a whole number"),
                        )
                    })?;
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

fn whole(word: &[u8]) -> Option<i64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read_mesh;

    const CORNERS: &str = "v 0 0 0\nv 1 0 0 # right\nv 1 1 0\nv 0 1 0\n";

    fn triangles(words: &str) -> Vec<[u32; 3]> {
        read("a.obj", words.as_bytes()).unwrap().triangles
    }

    #[test]
    fn lines_go_on_and_end_in_comments() {
        let plain = triangles(&format!("{CORNERS}f 1 2 3 4\n"));
        assert_eq!(plain.len(), 2);
        for face in [
            "f 1 2 \\\n3 4",
            "f 1 2\\\n 3\\\n 4 # side",
            "f 1 2 3 4 # side",
            "f 1 2 3 4# 9 x",
            "# C:\\\nf 1 2 3 4\n",
            "f 1 2 3 4 \\",
        ] {
            assert_eq!(triangles(&format!("{CORNERS}{face}")), plain, "{face}");
            assert_eq!(triangles(&format!("{CORNERS}{face}\n").replace('\n', "\r\n")), plain, "{face}, with CRLF");
            assert_eq!(triangles(&format!("{CORNERS}{face}\n").replace('\n', "\r")), plain, "{face}, with CR");
        }
    }

    #[test]
    fn errors_name_the_line_and_what_is_wrong_with_it() {
        for (face, problem) in [
            ("f 1 2 x", "\"x\", which is not a whole number"),
            ("f 1 2 3.5", "\"3.5\", which is not a whole number"),
            ("f 1 2 0", "names a corner that is not there"),
            ("f 1 2 -9", "names a corner that is not there"),
            ("v 1 2", "a corner that is not three numbers"),
            ("v 1.5 2,5 3", "decimal commas that can be read in more than one way"),
        ] {
            for (start, line) in [("", 5), ("\n \n\n", 8), ("v 1 \\\n1 1\n", 7)] {
                let words = format!("{start}{CORNERS}{face}\n");
                for words in [words.replace('\n', "\r\n"), words.replace('\n', "\r"), words] {
                    let error = read_mesh("a.obj", words.as_bytes(), None).unwrap_err().to_string();
                    assert!(error.contains(problem) && error.contains(&format!("line {line}")), "{words:?}: {error}");
                }
            }
        }
        let long = format!("{CORNERS}f 1 2 {}", "é".repeat(999));
        assert!(read_mesh("a.obj", long.as_bytes(), None).unwrap_err().to_string().len() < 200);
    }
}
