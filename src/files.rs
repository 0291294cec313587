//! Files are read up to a limit, and written whole or not at all.

use crate::{Error, Result};
use std::io::{self, Read, Write};
use std::{fs, path::Path};

/// All bytes of a file, or `None` if there are more than `most`: also for pipes and devices, whose size nobody knows.
///
/// # Errors
/// As the file system's.
pub fn read_at_most(path: &Path, most: usize) -> io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok((bytes.len() <= most).then_some(bytes))
}

/// Writes `bytes` to `path` through a file beside it that is renamed at the end: a reader sees the old file or the
/// whole new one, and a failure leaves nothing behind.
///
/// # Errors
/// [`Error::Input`] if the path names a folder, or one that is missing or closed to us; [`Error::Output`] if the disk is
/// full…
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let fail = |problem: String, remedy: &str| Error::input(path.display().to_string(), problem, remedy);
    let Some(name) = path.file_name() else {
        return Err(fail("is not a file name".into(), "give a file to write to"));
    };
    if path.is_dir() {
        return Err(fail("is a folder".into(), "give a file to write to"));
    }
    let beside = path.with_file_name(format!(".{}.{}.part", name.to_string_lossy(), std::process::id()));
    let write = || -> std::io::Result<()> {
        let mut file = fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        drop(file);
        fs::rename(&beside, path)
    };
    write().map_err(|problem| {
        // Nothing to clean up if it was never made, and nothing more to say if that fails too.
        let _ = fs::remove_file(&beside);
        let words = format!("cannot be written ({problem})");
        use io::ErrorKind::{NotADirectory, NotFound, PermissionDenied, ReadOnlyFilesystem};
        match problem.kind() {
            NotFound | PermissionDenied | NotADirectory | ReadOnlyFilesystem => {
                fail(words, "choose a folder that exists and can be written to")
            }
            _ => Error::output(path.display().to_string(), words, "make room or choose another folder"),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn replaces_whole_files_and_leaves_nothing_behind() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("out.bin");
        write_whole(&path, b"one").unwrap();
        write_whole(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        let missing = write_whole(&folder.path().join("no/such/folder.bin"), b"x").unwrap_err();
        assert!(missing.is_bad_input() && missing.to_string().contains("folder.bin"), "{missing}");
        assert!(write_whole(folder.path(), b"x").unwrap_err().to_string().contains("is a folder"));
        assert!(write_whole(Path::new("/"), b"x").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no parts are left");
        assert_eq!(read_at_most(&path, 3).unwrap().as_deref(), Some(&b"two"[..]));
        assert_eq!(read_at_most(&path, 2).unwrap(), None, "a byte too many");
    }
}
