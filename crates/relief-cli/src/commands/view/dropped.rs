//! Files that come in from the page, in a folder of the session.

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

use relief_viewer::Given;
use tempfile::TempDir;

use crate::failure::Failure;

/// Most bytes of all files that come in at once.
const MAX_BYTES: u64 = 8 << 30;

/// The files of the session, and their folder.
pub struct Dropped {
    folder: TempDir,
    pub given: Given,
}

impl Dropped {
    pub fn new() -> Result<Self, Failure> {
        let folder = tempfile::Builder::new().prefix("relief-view-").tempdir();
        let folder = folder
            .map_err(|error| Failure::Work(format!("a folder for dropped files cannot be made: {error}")))?;
        Ok(Self { given: Given::new(folder.path(), MAX_BYTES), folder })
    }

    /// Removes all files. Threads that still wait for a request hold them, so nobody else would.
    pub fn remove(&self) -> Result<(), Failure> {
        let folder = self.folder.path();
        fs::remove_dir_all(folder).map_err(|error| {
            Failure::Work(format!("{}: the dropped files cannot be removed: {error}", folder.display()))
        })
    }

    /// Removes the files of a group, which were not taken.
    pub fn forget(&self, number: u64) {
        // What stays is removed at the end.
        let _ = fs::remove_dir_all(self.given.folder(number));
    }
}

/// Writes a file whose length was said before. Nothing is left of one that is cut.
pub fn write(place: &Path, length: u64, bytes: &mut dyn Read) -> Result<(), String> {
    let name = place.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut write = || -> io::Result<u64> {
        fs::create_dir_all(place.parent().unwrap_or(Path::new("")))?;
        let mut file = fs::File::create(place)?;
        let copied = io::copy(&mut bytes.take(length), &mut file)?;
        file.flush()?;
        Ok(copied)
    };
    let failed = match write() {
        Ok(copied) if copied == length => return Ok(()),
        Ok(copied) => format!("{name}: {copied} of {length} bytes came: drop it again"),
        Err(error) => format!("{name}: it cannot be kept: {error}"),
    };
    let _ = fs::remove_file(place);
    Err(failed)
}
