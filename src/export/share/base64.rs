//! Base64 in the URL-safe alphabet without padding (RFC 4648, section 5).

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Four characters for every three bytes, fewer at the end.
pub fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity((bytes.len() * 4).div_ceil(3));
    for chunk in bytes.chunks(3) {
        let group = chunk.iter().fold(0u32, |group, &byte| group << 8 | u32::from(byte)) << (8 * (3 - chunk.len()));
        for k in 0..=chunk.len() {
            text.push(char::from(ALPHABET[(group >> (18 - 6 * k)) as usize & 63]));
        }
    }
    text
}

/// `None` for other characters, impossible lengths and left-over bits that are not zero.
pub fn decode(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() * 3 / 4);
    for chunk in text.as_bytes().chunks(4) {
        let mut group = 0u32;
        for &character in chunk {
            group = group << 6 | value(character)?;
        }
        let bits = 6 * chunk.len();
        let (whole, left_over) = (bits / 8, bits % 8);
        if whole == 0 || group & ((1 << left_over) - 1) != 0 {
            return None;
        }
        bytes.extend_from_slice(&(group >> left_over).to_be_bytes()[4 - whole..]);
    }
    Some(bytes)
}

fn value(character: u8) -> Option<u32> {
    let value = match character {
        b'A'..=b'Z' => character - b'A',
        b'a'..=b'z' => character - b'a' + 26,
        b'0'..=b'9' => character - b'0' + 52,
        b'-' => 62,
        b'_' => 63,
        _ => return None,
    };
    Some(u32::from(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn follows_the_standard() {
        for (bytes, text) in [("", ""), ("f", "Zg"), ("fo", "Zm8"), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            assert_eq!(encode(bytes.as_bytes()), text);
            assert_eq!(decode(text).as_deref(), Some(bytes.as_bytes()));
        }
        assert_eq!(encode(&[0xfb, 0xff]), "-_8");
        for bad in ["Z", "Zh", "Zg=", "Zg==", "Zm+v", "Zm9v Zg"] {
            assert_eq!(decode(bad), None, "{bad}");
        }
    }
}
