//! Disk operations of a file set, one at a time: tests can stop before any of them.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;

/// Disk operations. In a test they may stop for good, as when a process is killed, or a single one
/// may fail.
#[derive(Clone, Debug, Default)]
pub(super) struct Disk {
    #[cfg(test)]
    pub(super) hook: std::sync::Arc<super::tests::Hook>,
}

impl Disk {
    /// Called before each operation.
    #[cfg(test)]
    fn allow(&self) -> io::Result<()> {
        self.hook.allow()
    }

    #[cfg(not(test))]
    #[expect(clippy::unnecessary_wraps, clippy::unused_self, reason = "tests have another one")]
    const fn allow(&self) -> io::Result<()> {
        Ok(())
    }

    pub(super) fn make_folder(&self, path: &Path) -> io::Result<()> {
        self.allow()?;
        fs::create_dir(path)
    }

    /// Opens a file to lock it, and creates it if it is missing.
    pub(super) fn open_lock(&self, path: &Path) -> io::Result<File> {
        self.allow()?;
        File::options().create(true).truncate(false).write(true).open(path)
    }

    /// Writes a small file and syncs it to the disk. A process that is killed may leave a part of
    /// it.
    pub(super) fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        self.allow()?;
        let mut file = File::create(path)?;
        for part in bytes.chunks(bytes.len().div_ceil(2).max(1)) {
            self.allow()?;
            file.write_all(part)?;
        }
        file.sync_all()
    }

    pub(super) fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        self.allow()?;
        fs::rename(from, to)
    }

    /// Creates a hard link.
    pub(super) fn link(&self, from: &Path, to: &Path) -> io::Result<()> {
        self.allow()?;
        #[cfg(test)]
        if !self.hook.has_links() {
            return Err(io::ErrorKind::Unsupported.into());
        }
        fs::hard_link(from, to)
    }

    pub(super) fn remove_file(&self, path: &Path) -> io::Result<()> {
        self.allow()?;
        fs::remove_file(path)
    }

    /// Removes an empty folder.
    pub(super) fn remove_folder(&self, path: &Path) -> io::Result<()> {
        self.allow()?;
        fs::remove_dir(path)
    }
}

/// Whether anything exists at the path; links are not followed.
pub(super) fn is_there(path: &Path) -> io::Result<bool> {
    match fs::symlink_metadata(path) {
        Ok(_) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(error) => Err(error),
    }
}
