//! Where a JPEG ends: phones put films and further pictures behind it, and some programs leave out its end marker.

/// How much of some bytes is a JPEG.
pub enum Extent {
    /// Its end marker is before this byte; what follows is something else.
    Whole(usize),
    /// It has a scan and no end marker: only the decoder can tell whether something is missing.
    Unended,
    /// It ends before its first scan.
    Nothing,
}

/// Walks the markers (ITU-T T.81, annex B): a segment tells its length, and within a scan 0xFF is followed by 0 or a restart
/// marker.
pub fn extent(bytes: &[u8]) -> Extent {
    let missing = |scanned: bool| if scanned { Extent::Unended } else { Extent::Nothing };
    let (mut at, mut scanned) = (2, false);
    loop {
        // What is not a marker is skipped, as decoders do.
        let Some(found) = bytes.get(at..).and_then(|rest| rest.windows(2).position(is_marker)) else {
            return missing(scanned);
        };
        at += found + 2;
        match bytes[at - 1] {
            0xd9 => return Extent::Whole(at),
            0x01 => continue,
            marker => scanned |= marker == 0xda,
        }
        let Some(length) = bytes.get(at..at + 2) else { return missing(scanned) };
        at += usize::from(u16::from_be_bytes([length[0], length[1]])).max(2);
    }
}

fn is_marker(pair: &[u8]) -> bool {
    pair[0] == 0xff && !matches!(pair[1], 0 | 0xff | 0xd0..=0xd8)
}

/// The bytes with some `filler` in place of what may be missing, and an end marker.
pub fn ended(bytes: &[u8], filler: u8) -> Vec<u8> {
    let mut ended = bytes.to_vec();
    // A lone half of a marker would swallow the filler.
    if ended.last() == Some(&0xff) {
        ended.pop();
    }
    ended.extend([filler; 256]);
    ended.extend([0xff, 0xd9]);
    ended
}
