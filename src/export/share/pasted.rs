//! Codes in text as people paste it: a link with other parameters round its code, in brackets, quotes or a sentence, wrapped
//! or quoted by mail, as HTML, percent-encoded by a program that checks links.

use std::collections::HashSet;

/// Places at which a code may begin, and ends that are tried for each: texts made to have more are no links.
const MOST_STARTS: usize = 16;
const MOST_ENDS: usize = 256;
/// Shorter runs of letters are words.
const SHORTEST: usize = 7;
/// `w=` as quoted-printable mail writes it; no code begins with these characters.
const QUOTED_PRINTABLE: &str = "3D";

/// What may be a share code in `text`, likelier ones first; the checksum tells which one is. At `w=` where there is one,
/// else anything that looks like a code.
pub(super) fn codes_in(text: &str) -> Vec<String> {
    let mut text: String = text.chars().filter(|c| !is_invisible(*c)).collect();
    let mut starts = parameters(&text);
    // Twice, for links in links.
    for _ in 0..2 {
        if !starts.is_empty() {
            break;
        }
        text = percent_decoded(&text);
        starts = parameters(&text);
    }
    if starts.is_empty() {
        starts = words(&text);
    }
    let mut known = HashSet::new();
    let codes = starts.into_iter().take(MOST_STARTS).flat_map(|start| readings(&text[start..]));
    codes.filter(|code| known.insert(code.clone())).collect()
}

/// Zero-width spaces and joiners, marks of direction, soft hyphens, the byte order mark.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2064}' | '\u{feff}')
}

fn is_of_code(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '-' || c == '_'
}

/// Where values of a parameter `w` begin.
fn parameters(text: &str) -> Vec<usize> {
    let alone = |&at: &usize| !text[..at].ends_with(is_of_code);
    text.match_indices("w=").map(|(at, _)| at).filter(alone).map(|at| at + 2).collect()
}

/// Where what looks like a code begins, the longest first.
fn words(text: &str) -> Vec<usize> {
    let mut words: Vec<&str> = text.split(|c| !is_of_code(c)).filter(|word| word.len() >= SHORTEST).collect();
    words.sort_by_key(|word| std::cmp::Reverse(word.len()));
    words.into_iter().map(|word| word.as_ptr() as usize - text.as_ptr() as usize).collect()
}

/// The code at the start of `text`, read on over line breaks: up to the first one, up to the second one, …
fn readings(text: &str) -> Vec<String> {
    let text = text.strip_prefix(QUOTED_PRINTABLE).unwrap_or(text);
    let mut readings: Vec<String> = Vec::new();
    let mut code = String::new();
    let mut at_line_start = false;
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        let breaks = c == '=' && matches!(characters.peek(), Some('\r' | '\n'));
        if is_of_code(c) {
            if at_line_start {
                readings.push(code.clone());
                at_line_start = false;
            }
            code.push(c);
        } else if c.is_whitespace() || breaks || (at_line_start && matches!(c, '>' | '|')) {
            at_line_start = true;
        } else {
            break;
        }
        if readings.len() >= MOST_ENDS {
            break;
        }
    }
    readings.push(code);
    // A link in _italics_.
    let bare = |code: &String| code.trim_end_matches(['-', '_']).to_owned();
    let trimmed: Vec<String> = readings.iter().map(bare).collect();
    readings.into_iter().chain(trimmed).filter(|code| !code.is_empty()).collect()
}

/// With `%2D` and the like as the characters they stand for; what is no such thing stays.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, ..] = rest {
        let digit = |at: usize| rest.get(at).and_then(|&byte| char::from(byte).to_digit(16));
        match (first, digit(1).zip(digit(2))) {
            (b'%', Some((high, low))) => {
                bytes.push((16 * high + low) as u8);
                rest = &rest[3..];
            }
            _ => {
                bytes.push(*first);
                rest = &rest[1..];
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "AQab-cd_efGH0123456789";

    #[test]
    fn finds_the_code_in_whatever_a_link_went_through() {
        let link = format!("https://wire.example/app/#v=1&job=multiview&w={CODE}&preset=fast&seed=3");
        let [first, second] = [&CODE[..9], &CODE[9..]];
        let texts = [
            CODE.to_owned(),
            format!("  \"{CODE}\"\n"),
            link.clone(),
            format!("https://wire.example/app/#w={CODE}"),
            format!("<{link}>"),
            format!("Look: https://wire.example/#v=1&w={CODE}. I like it!"),
            format!("[my wire](https://wire.example/#v=1&w={CODE})"),
            format!("“https://wire.example/#v=1&w={CODE}”"),
            link.replace('&', "&amp;"),
            format!("https://wire.example/#v=1&w={first}\r\n{second}\r\n\r\nGreetings, Anna"),
            format!("> https://wire.example/#v=1&w={first}\n> {second}&seed=3\n> Greetings"),
            format!("https://wire.example/#v=3D1&w=3D{first}=\r\n{second}&seed=3D3"),
            format!("https://wire.example/#w={first}\u{200b}{second}\u{feff}"),
            format!("https://check.example/?url=https%3A%2F%2Fwire.example%2F%23v%3D1%26w%3D{CODE}%26seed%3D3&data=5"),
            format!("https://check.example/?url=https%253A%252F%252Fwire.example%252F%2523w%253D{CODE}"),
            format!("_https://wire.example/#w={CODE}_"),
            format!("https://wire.example/?view=front&w={CODE}"),
        ];
        for text in texts {
            assert!(codes_in(&text).iter().any(|code| code == CODE), "{text}: {:?}", codes_in(&text));
        }
    }

    #[test]
    fn finds_nothing_in_nothing_and_does_not_try_for_ever() {
        for text in ["", "  \n", "hi", "#w=", "w=\u{200b}", "%%%4", "=\n=\n"] {
            assert!(codes_in(text).is_empty(), "{text}: {:?}", codes_in(text));
        }
        assert!(codes_in(&"w=A ".repeat(9999)).len() < 4 * MOST_STARTS * MOST_ENDS);
        assert!(codes_in(&"A ".repeat(9999)).is_empty());
    }
}
