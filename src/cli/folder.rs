//! An output folder that appears whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};
use wire4d::{Error, Result};

/// A folder being filled beside its final place. Dropped without [`Folder::finish`], it leaves nothing behind.
pub struct Folder {
    place: PathBuf,
    partial: PathBuf,
    /// Folders above it that had to be made, outermost first.
    made_above: Vec<PathBuf>,
    finished: bool,
}

impl Folder {
    /// Claims `place`: it must not exist, be empty, or hold an earlier run that `overwrite` allows to replace.
    ///
    /// # Errors
    /// [`Error::Input`] when something is in the way or it cannot be made.
    pub fn claim(place: &Path, overwrite: bool) -> Result<Folder> {
        let name = place.display().to_string();
        if place.is_file() {
            return Err(Error::input(name, "is a file, and a folder is needed", "give another --out"));
        }
        if let Ok(mut entries) = fs::read_dir(place) {
            let ours = ["report.json", "build.json"].iter().any(|report| place.join(report).is_file());
            if entries.next().is_some() && !(overwrite && ours) {
                let remedy = if ours {
                    "give another --out, or --overwrite to replace the earlier run"
                } else {
                    "give a new or empty folder"
                };
                return Err(Error::input(name, "the folder is not empty and nothing in it will be touched", remedy));
            }
        }
        let parent = match place.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let Some(last) = place.file_name() else {
            return Err(Error::input(name, "is no name for a folder", "give another --out"));
        };
        let mut made_above: Vec<PathBuf> =
            parent.ancestors().take_while(|above| !above.exists()).map(Path::to_owned).collect();
        made_above.reverse();
        let partial = parent.join(format!(".{}.partial-{}", last.to_string_lossy(), std::process::id()));
        let folder = Folder { place: place.to_owned(), partial, made_above, finished: false };
        fs::create_dir_all(&folder.partial).map_err(|error| {
            Error::input(&name, format!("cannot be made ({error})"), "give another --out that you may write to")
        })?;
        Ok(folder)
    }

    /// Where files wait until [`Folder::finish`].
    pub fn partial(&self) -> &Path {
        &self.partial
    }

    /// Adds a file.
    pub fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        fs::write(self.partial.join(name), bytes).map_err(|error| unwritable(&self.place.join(name), &error))
    }

    /// Moves everything to its final place. What an earlier run left there goes only once the new folder stands.
    pub fn finish(mut self) -> Result<()> {
        let aside = self.partial.with_extension("replaced");
        let replaces = self.place.is_dir();
        if replaces {
            fs::rename(&self.place, &aside).map_err(|error| unwritable(&self.place, &error))?;
        }
        if let Err(error) = fs::rename(&self.partial, &self.place) {
            if replaces {
                let _ = fs::rename(&aside, &self.place);
            }
            return Err(unwritable(&self.place, &error));
        }
        self.finished = true;
        if replaces {
            let _ = fs::remove_dir_all(&aside);
        }
        Ok(())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if !self.finished {
            let _ = fs::remove_dir_all(&self.partial);
            // Only empty folders go this way.
            for made in self.made_above.iter().rev() {
                let _ = fs::remove_dir(made);
            }
        }
    }
}

fn unwritable(place: &Path, error: &std::io::Error) -> Error {
    Error::output(place.display().to_string(), format!("cannot be written ({error})"), "check the path and its rights")
}
