//! Files are written whole or not at all.

use crate::{Error, Result};
use std::{fs, io::Write, path::Path};

/// Writes `bytes` to `path` through a file beside it that is renamed at the end: a reader sees the old file or the
/// whole new one, and a failure leaves nothing behind.
///
/// # Errors
/// [`Error::Output`] if the folder is missing or cannot be written, the disk is full…
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let fail = |problem: String, remedy: &str| Error::output(path.display().to_string(), problem, remedy);
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
        fail(format!("cannot be written ({problem})"), "choose a folder that exists and can be written to")
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
        assert!(!missing.is_bad_input() && missing.to_string().contains("folder.bin"), "{missing}");
        assert!(write_whole(folder.path(), b"x").unwrap_err().to_string().contains("is a folder"));
        assert!(write_whole(Path::new("/"), b"x").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no parts are left");
    }
}
