//! Files by their paths, on disk or in memory.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fmt;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::SystemTime;

use crate::Source;

/// Place of all files that a scene names: the disk, or memory.
///
/// Readers take a [`Source`] of these files. They find what a file refers to, such as the buffers of a glTF,
/// in the same place.
///
/// ```
/// use relief_io::{Files, MemoryFiles, HeightOptions, read_height};
///
/// let mut memory = MemoryFiles::new();
/// memory.insert("maps/wall.pgm", b"P5 2 2 255\n\x00\x10\x20\x30".as_slice())?;
/// let files = Files::Memory(memory);
/// let map = read_height(files.source("scenes/../maps/wall.pgm"), &HeightOptions::default())?;
/// assert_eq!(map.width(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub enum Files {
    /// The files of the disk.
    #[default]
    Disk,
    /// Files in memory.
    Memory(MemoryFiles),
}

impl Files {
    /// Returns the source of a file. It need not exist.
    pub fn source<'a>(&'a self, path: &'a (impl AsRef<Path> + ?Sized)) -> Source<'a> {
        match self {
            Self::Disk => Source::from(path),
            Self::Memory(files) => Source::in_memory(path.as_ref(), files),
        }
    }

    /// Returns the state of a file or folder, which differs once its content has changed. `None` if it does
    /// not exist. On disk it consists of length and time of change.
    pub fn stamp(&self, path: &Path) -> Option<FileStamp> {
        Some(FileStamp(match self {
            Self::Disk => {
                let about = std::fs::metadata(path).ok()?;
                Stamp::Disk(about.len(), about.modified().ok())
            }
            Self::Memory(files) => files.stamp(path)?,
        }))
    }
}

/// State of a file at some time, for [`Files::stamp`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileStamp(Stamp);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Stamp {
    Disk(u64, Option<SystemTime>),
    /// The latest version of the file, or of all files in the folder and below, and their number.
    Memory(u64, usize),
}

/// Files in memory, by relative paths.
///
/// A path may have `.` and `..`, which are resolved by its text: there are no links. It starts at the one
/// folder that holds all files, with or without a leading `/`, and a path that leaves this folder names no
/// file. Upper and lower case differ. A folder exists if a file lies in it.
///
/// Copies share the bytes.
#[derive(Clone, Default)]
pub struct MemoryFiles {
    files: BTreeMap<PathBuf, MemoryFile>,
}

#[derive(Clone)]
struct MemoryFile {
    bytes: Arc<[u8]>,
    /// Number that no other content has.
    version: u64,
}

/// Reason why a path cannot be the name of a file in memory.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("'{}' cannot name a file in memory: give a relative path without '..' at its start", .0.display())]
pub struct MemoryPathError(pub PathBuf);

impl MemoryFiles {
    /// Creates an empty set.
    pub const fn new() -> Self {
        Self { files: BTreeMap::new() }
    }

    /// Adds a file, in place of an earlier one of the same path.
    ///
    /// # Errors
    ///
    /// When the path is empty, leaves the folder of all files or has a drive.
    pub fn insert(
        &mut self,
        path: impl AsRef<Path>,
        bytes: impl Into<Arc<[u8]>>,
    ) -> Result<(), MemoryPathError> {
        let name = resolved(path.as_ref()).filter(|name| !name.as_os_str().is_empty());
        let name = name.ok_or_else(|| MemoryPathError(path.as_ref().to_owned()))?;
        self.files.insert(name, MemoryFile { bytes: bytes.into(), version: next_version() });
        Ok(())
    }

    /// Removes a file, and returns its bytes if it existed.
    pub fn remove(&mut self, path: impl AsRef<Path>) -> Option<Arc<[u8]>> {
        self.files.remove(&resolved(path.as_ref())?).map(|file| file.bytes)
    }

    /// Returns the bytes of a file, if it exists.
    pub fn get(&self, path: impl AsRef<Path>) -> Option<&Arc<[u8]>> {
        Some(&self.files.get(&resolved(path.as_ref())?)?.bytes)
    }

    /// Returns the paths of all files in the order of their names, without `.` and `..`.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.files.keys().map(PathBuf::as_path)
    }

    /// Returns the bytes of a file. Errors are of the kinds that a disk's have.
    pub(crate) fn read(&self, path: &Path) -> io::Result<&[u8]> {
        match self.get(path) {
            Some(bytes) => Ok(bytes),
            None if self.is_folder(path) => Err(io::ErrorKind::IsADirectory.into()),
            None => Err(io::Error::new(io::ErrorKind::NotFound, NotInMemory)),
        }
    }

    /// Returns the names of at most `most` entries of a folder.
    pub(crate) fn entries(&self, folder: &Path, most: usize) -> io::Result<Vec<OsString>> {
        if let Ok(_file) = self.read(folder) {
            return Err(io::ErrorKind::NotADirectory.into());
        }
        let mut names: Vec<OsString> = Vec::new();
        for (path, _) in self.inside(folder) {
            let name = path.components().next().map(|first| first.as_os_str().to_owned());
            names.extend(name.filter(|name| names.last() != Some(name)));
        }
        names.truncate(most);
        if names.is_empty() { Err(io::Error::new(io::ErrorKind::NotFound, NotInMemory)) } else { Ok(names) }
    }

    /// Returns whether a file lies in this folder or below.
    pub(crate) fn is_folder(&self, path: &Path) -> bool {
        self.inside(path).next().is_some()
    }

    /// Returns the files in a folder and below, by their paths from there.
    fn inside(&self, folder: &Path) -> impl Iterator<Item = (&Path, &MemoryFile)> {
        let inside = resolved(folder).into_iter().flat_map(|folder| {
            // Paths are sorted by their components, so these files follow each other.
            let from = self.files.range(folder.clone()..);
            from.map_while(move |(path, file)| Some((path.strip_prefix(&folder).ok()?, file)))
        });
        inside.filter(|(rest, _)| !rest.as_os_str().is_empty())
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        if let Some(file) = resolved(path).and_then(|name| self.files.get(&name)) {
            return Some(Stamp::Memory(file.version, 1));
        }
        let versions = || self.inside(path).map(|(_, file)| file.version);
        Some(Stamp::Memory(versions().max()?, versions().count()))
    }
}

impl fmt::Debug for MemoryFiles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.files.iter().map(|(path, file)| (path, file.bytes.len()))).finish()
    }
}

/// Text of the error that a file is not in memory.
#[derive(Debug, thiserror::Error)]
#[error("it is not among the files that were given: add it under this path")]
struct NotInMemory;

/// Returns a number that was not returned before.
fn next_version() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// Resolves `.` and `..` of a path from the folder of all files. `None` if it leaves this folder.
fn resolved(path: &Path) -> Option<PathBuf> {
    let mut name = PathBuf::new();
    for part in path.components() {
        match part {
            Component::Normal(part) => name.push(part),
            Component::CurDir | Component::RootDir => {}
            Component::ParentDir => name.pop().then_some(())?,
            Component::Prefix(_) => return None,
        }
    }
    Some(name)
}

#[cfg(test)]
mod tests;
