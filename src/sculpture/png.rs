//! The chunks of a PNG file (ISO/IEC 15948), as far as they are read and written here.

/// How a PNG file begins.
pub(crate) const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
/// Where the first chunk ends, which is always the heading.
pub(crate) const AFTER_HEADING: usize = 33;

/// What a chunk is called and what it holds.
pub(crate) type Chunk<'a> = (&'a [u8], &'a [u8]);

/// The chunks, up to the end; `None` in place of one that is cut off or whose checksum is wrong, and nothing after it.
pub(crate) fn chunks(png: &[u8]) -> impl Iterator<Item = Option<Chunk<'_>>> {
    let mut rest = png.strip_prefix(SIGNATURE).unwrap_or_default();
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let chunk = first(rest);
        rest = match chunk {
            Some((kind, data)) if kind != b"IEND" => &rest[12 + data.len()..],
            _ => &[],
        };
        Some(chunk)
    })
}

fn first(rest: &[u8]) -> Option<Chunk<'_>> {
    let (length, rest) = rest.split_first_chunk::<4>()?;
    let length = u32::from_be_bytes(*length) as usize;
    let (body, rest) = rest.split_at_checked(length.checked_add(4)?)?;
    let checksum = rest.first_chunk::<4>()?;
    (crc32fast::hash(body) == u32::from_be_bytes(*checksum)).then(|| body.split_at(4))
}

/// A chunk as a file has it.
pub(crate) fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [kind, data].concat();
    [&(data.len() as u32).to_be_bytes()[..], &body, &crc32fast::hash(&body).to_be_bytes()].concat()
}
