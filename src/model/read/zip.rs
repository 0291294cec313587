//! Zip archives, as far as formats that are kept in them need: files are found by the directory at the end.

use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_with_limit};
use std::borrow::Cow;

/// Most bytes that are unpacked: half a million triangles in XML are less than half of it.
const MOST_BYTES: usize = 100_000_000;
/// Most bytes that one is unpacked to: no XML of a mesh is packed as well.
const MOST_TIMES: usize = 200;

/// An archive's directory.
pub(super) struct Archive<'a> {
    bytes: &'a [u8],
    files: Vec<File>,
    /// How many more bytes may be unpacked: what a small file says it holds may be endless.
    left: usize,
}

/// A file in it. Its size is not believed, so it is not kept.
struct File {
    path: String,
    flags: usize,
    method: usize,
    packed: usize,
    header: usize,
}

/// The number of so many bytes at a place, lowest first.
fn number<const BYTES: usize>(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes = bytes.get(at..at.checked_add(BYTES)?)?;
    usize::try_from(bytes.iter().rev().fold(0u64, |sum, &byte| sum << 8 | u64::from(byte))).ok()
}

/// What a field says that has its number elsewhere, as it may be too large for it.
const ELSEWHERE: usize = u32::MAX as usize;

impl<'a> Archive<'a> {
    /// None without a directory.
    pub(super) fn open(bytes: &'a [u8]) -> Option<Archive<'a>> {
        const END: &[u8] = b"PK\x05\x06";
        // A comment of up to 65,535 bytes follows the end.
        let first = bytes.len().saturating_sub(22 + 65_535);
        let end = first + bytes[first..].windows(END.len()).rposition(|window| window == END)?;
        let mut at = number::<4>(bytes, end + 16)?;
        // Zip64: a locator before the end, and a longer end where that says.
        if let Some(locator) = end.checked_sub(20).filter(|&at| bytes[at..].starts_with(b"PK\x06\x07")) {
            let end = number::<8>(bytes, locator + 8)?;
            if bytes.get(end..)?.starts_with(b"PK\x06\x06") {
                at = number::<8>(bytes, end.checked_add(48)?)?;
            }
        }
        let mut files = Vec::new();
        while let Some(entry) = bytes.get(at..).filter(|rest| rest.starts_with(b"PK\x01\x02")) {
            let [name, extra, comment] = [28, 30, 32].map(|at| number::<2>(entry, at).unwrap_or(0));
            let path = entry.get(46..46 + name)?;
            let mut packed = number::<4>(entry, 20)?;
            let mut header = number::<4>(entry, 42)?;
            let mut long = long_numbers(entry.get(46 + name..46 + name + extra)?);
            if number::<4>(entry, 24)? == ELSEWHERE {
                long.next();
            }
            for field in [&mut packed, &mut header] {
                if *field == ELSEWHERE {
                    *field = long.next()?;
                }
            }
            let path = String::from_utf8_lossy(path).replace('\\', "/");
            let [flags, method] = [8, 10].map(|at| number::<2>(entry, at).unwrap_or(0));
            files.push(File { path, flags, method, packed, header });
            at += 46 + name + extra + comment;
        }
        Some(Archive { bytes, files, left: MOST_BYTES })
    }

    /// The paths of its files.
    pub(super) fn paths(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| &file.path[..])
    }

    /// Unpacks the file at a path, from the archive's root and with letters of either case; none if there is no such file.
    ///
    /// # Errors
    /// Why it cannot be, to follow the archive's name.
    pub(super) fn read(&mut self, path: &str) -> Result<Option<Cow<'a, [u8]>>, String> {
        let path = path.trim_start_matches('/');
        let Some(file) = self.files.iter().find(|file| file.path.eq_ignore_ascii_case(path)) else { return Ok(None) };
        if file.flags & 1 != 0 {
            return Err("is encrypted".into());
        }
        let packed = || {
            let header = self.bytes.get(file.header..).filter(|rest| rest.starts_with(b"PK\x03\x04"))?;
            let start = 30 + number::<2>(header, 26)? + number::<2>(header, 28)?;
            header.get(start..start.checked_add(file.packed)?)
        };
        let cut = || format!("holds {path} only in part");
        let packed = packed().ok_or_else(cut)?;
        let most = self.left.min(1_000_000 + MOST_TIMES * packed.len());
        let unpacked = match file.method {
            0 => Cow::Borrowed(packed),
            8 => match decompress_to_vec_with_limit(packed, most) {
                Ok(bytes) => Cow::Owned(bytes),
                Err(error) if error.status == TINFLStatus::HasMoreOutput => {
                    return Err(format!("unpacks to more than {} MB", most / 1_000_000));
                }
                Err(_) => return Err(cut()),
            },
            method => return Err(format!("is packed in a way that is not read here (method {method})")),
        };
        self.left = self.left.saturating_sub(unpacked.len());
        Ok(Some(unpacked))
    }
}

/// The long numbers of an entry's extra fields, in order.
fn long_numbers(mut extra: &[u8]) -> impl Iterator<Item = usize> {
    let mut long: &[u8] = &[];
    while let (Some(kind), Some(length)) = (number::<2>(extra, 0), number::<2>(extra, 2)) {
        let Some(field) = extra.get(4..4 + length) else { break };
        if kind == 1 {
            long = field;
        }
        extra = &extra[4 + length..];
    }
    long.chunks_exact(8).map_while(|field| number::<8>(field, 0))
}
