//! A set of files that is written whole or not at all.
//!
//! Files are prepared in a hidden folder beside their places. [`FileSet::commit`] then writes down what is
//! going to change, gives all files their names, and removes the hidden folder. Whenever a process is killed,
//! the next one that opens a set in that folder finishes what was written down, and drops what was not. A
//! change that fails on the way is undone.
//!
//! One process at a time works on the set of a name in a folder. The system takes the lock back from a
//! process that dies.
//!
//! An output that is a link stays one: the file that it leads to gets the content. It need not be in the
//! folder of the set, and nor need any other output.
//!
//! While files get their names, a reader may find old ones beside new ones. A [`Manifest`], written as the
//! last file of the set, tells: it lists what belongs together, with lengths and hashes.
//!
//! # Examples
//!
//! ```
//! use relief_io::file_set::{FileSet, FoundManifest, ListedFile, Manifest, Part};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let folder = tempfile::tempdir()?;
//! # let folder = folder.path();
//! let mut set = FileSet::open(folder, "wall", &mut |_| true)?;
//! let mut part = Part { name: "cone".into(), made_from: "wall.png".into(), files: Vec::new() };
//! for name in ["wall.cone.0", "wall.cone.1"] {
//!     let aside = set.put(&folder.join(name))?;
//!     std::fs::write(&aside, name)?;
//!     part.files.push(ListedFile::of(&aside, name)?);
//! }
//! let mut manifest = Manifest::default();
//! manifest.set(part);
//! let place = folder.join("wall.manifest");
//! std::fs::write(set.put(&place)?, manifest.to_text())?;
//! set.commit()?;
//!
//! let FoundManifest::Whole(found) = Manifest::find(&place)? else { panic!("it was written") };
//! assert!(found.whole(folder, "cone", "wall.png").is_some());
//! std::fs::write(folder.join("wall.cone.1"), "cut")?;
//! assert!(found.whole(folder, "cone", "wall.png").is_none());
//! # Ok(())
//! # }
//! ```

mod disk;
mod error;
mod journal;
mod manifest;
mod place;
mod room;
#[cfg(test)]
mod tests;

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

pub use self::error::FileSetError;
pub use self::manifest::{FoundManifest, ListedFile, Manifest, Part};
pub use self::place::is_same_file;

use self::disk::{Disk, is_there};
use self::journal::{Action, Step};
use self::place::Place;
use self::room::Room;

/// How often a folder is made that others remove.
const MOST_TRIES: usize = 100;

/// Files that are about to be written, all of them or none. Dropped without [`commit`](FileSet::commit),
/// everything is as it was before.
#[derive(Debug)]
pub struct FileSet {
    disk: Disk,
    room: Room,
    /// The folder beside the room, without links.
    folder: PathBuf,
    /// Folders that were missing, from the outermost.
    made: Vec<PathBuf>,
    /// Folders with a room away.
    away: Vec<PathBuf>,
    steps: Vec<Step>,
}

impl FileSet {
    /// Begins a set of that name in a folder, which is made if it is missing. Sets of one name in one folder
    /// keep each other out. What a killed process has left in the folder is finished or removed.
    ///
    /// While another process holds the set, `wait` is asked every few milliseconds whether to go on waiting,
    /// with the time since the beginning.
    ///
    /// # Errors
    ///
    /// When the folder cannot be written into, when `wait` says no, or when what a killed process left cannot
    /// be finished.
    pub fn open(
        folder: &Path,
        name: impl AsRef<OsStr>,
        wait: &mut dyn FnMut(Duration) -> bool,
    ) -> Result<Self, FileSetError> {
        Self::open_on(Disk::default(), folder, name.as_ref(), wait)
    }

    fn open_on(
        disk: Disk,
        folder: &Path,
        name: &OsStr,
        wait: &mut dyn FnMut(Duration) -> bool,
    ) -> Result<Self, FileSetError> {
        let given = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let of_folder = |source| FileSetError::Folder { folder: given.to_owned(), source };
        let mut made = Vec::new();
        let mut take = || -> io::Result<_> {
            make_folders(&disk, given, &mut made)?;
            let folder = given.canonicalize()?;
            Ok(Room::take(&disk, &folder, name, wait)?.map(|room| (folder, room)))
        };
        let mut taken = take();
        // Who held the set may have made the folder, and removed it again.
        for _ in 0..MOST_TRIES {
            match &taken {
                Err(error) if error.kind() == io::ErrorKind::NotFound => taken = take(),
                _ => break,
            }
        }
        let (folder, room) = match taken {
            Ok(Some(taken)) => taken,
            Ok(None) => {
                let name = name.to_string_lossy().into_owned();
                return Err(FileSetError::Busy { folder: given.to_owned(), name });
            }
            Err(error) => {
                remove_folders(&disk, &made);
                return Err(of_folder(error));
            }
        };
        let recovered = journal::recover(&disk, &room).and_then(|()| room.clean(&disk));
        if let Err(source) = recovered {
            return Err(FileSetError::Stuck { room: room.path, source });
        }
        for other in Room::abandoned(&disk, &folder) {
            // What cannot be finished now is tried again by the next run, and said by one of that name.
            if journal::recover(&disk, &other).is_ok() {
                other.leave(&disk);
            }
        }
        Ok(Self { disk, room, folder, made, away: Vec::new(), steps: Vec::new() })
    }

    /// The hidden folder beside the outputs, for files without a name that the work needs meanwhile. It is
    /// removed at the end.
    pub fn room(&self) -> &Path {
        &self.room.path
    }

    /// Finds out whether a file can be put in that place, as far as that can be known before.
    ///
    /// # Errors
    ///
    /// When the path ends in no name, when there is a folder or anything else but a file, when links lead
    /// nowhere, or when the file's folder cannot be written into.
    pub fn check(&mut self, path: &Path) -> Result<(), FileSetError> {
        self.place(path).map(|_| ())
    }

    /// The place of a file, in whose folder there is a room.
    fn place(&mut self, path: &Path) -> Result<Place, FileSetError> {
        let place = Place::of(path)?;
        if place.folder != self.folder && !self.away.contains(&place.folder) {
            self.away.push(place.folder.clone());
            let made = self.room.make_away(&self.disk, &self.away);
            made.map_err(|source| FileSetError::Folder { folder: place.folder.clone(), source })?;
        }
        Ok(place)
    }

    /// Plans new content for a file, and says where to write it. Files get their names in the order of these
    /// calls.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and when the same file has been planned before.
    pub fn put(&mut self, path: &Path) -> Result<PathBuf, FileSetError> {
        let place = self.place(path)?;
        let step = Step::new(Action::Put { replaces: false }, place, &self.folder);
        if self.steps.iter().any(|other| other.away == step.away && other.name == step.name) {
            return Err(FileSetError::Twice(path.to_owned()));
        }
        let room = step.room(&self.room);
        let room = room.map_err(|source| FileSetError::Replace { path: path.to_owned(), source })?;
        let aside = room.join(format!("new.{}", self.steps.len()));
        self.steps.push(step);
        Ok(aside)
    }

    /// Plans that a file of the folder goes. One that has gone already is no error.
    ///
    /// # Errors
    ///
    /// When the name is none of a file in the folder.
    pub fn remove(&mut self, name: &str) -> Result<(), FileSetError> {
        if Path::new(name).file_name() != Some(OsStr::new(name)) {
            return Err(FileSetError::NoName(name.into()));
        }
        self.steps.push(Step { action: Action::Remove, away: None, name: name.into() });
        Ok(())
    }

    /// Changes the files as planned, all of them or none.
    ///
    /// # Errors
    ///
    /// When a file was planned and not written, or when one cannot be replaced. Then no file has changed;
    /// where even that could not be reached the error is [`FileSetError::Stuck`].
    pub fn commit(mut self) -> Result<(), FileSetError> {
        for (number, step) in self.steps.iter_mut().enumerate() {
            let target = step.target(&self.room);
            let replace = |source| FileSetError::Replace { path: target.clone(), source };
            if let Action::Put { replaces } = &mut step.action {
                *replaces = is_there(&target).map_err(replace)?;
                let aside = step.room(&self.room).map_err(replace)?;
                if !is_there(&aside.join(format!("new.{number}"))).map_err(replace)? {
                    return Err(FileSetError::NotWritten(target));
                }
            }
        }
        journal::change(&self.disk, &self.room, &self.steps).map_err(
            |((path, source), stuck)| match stuck {
                None => FileSetError::Replace { path, source },
                Some(_) => FileSetError::Stuck { room: self.room.path.clone(), source },
            },
        )?;
        self.made.clear();
        Ok(())
    }
}

impl Drop for FileSet {
    /// Removes the room, unless there is work in it for the next run.
    fn drop(&mut self) {
        if !journal::is_pending(&self.room) {
            self.room.leave(&self.disk);
            remove_folders(&self.disk, &self.made);
        }
    }
}

/// Makes a folder and those that it is in, where they are missing.
fn make_folders(disk: &Disk, folder: &Path, made: &mut Vec<PathBuf>) -> io::Result<()> {
    let missing: Vec<&Path> = folder
        .ancestors()
        .take_while(|folder| !folder.as_os_str().is_empty() && fs::symlink_metadata(folder).is_err())
        .collect();
    for folder in missing.into_iter().rev() {
        match disk.make_folder(folder) {
            Ok(()) => made.push(folder.to_owned()),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// Removes folders that were made, where they are empty.
fn remove_folders(disk: &Disk, made: &[PathBuf]) {
    for folder in made.iter().rev() {
        let _ = disk.remove_folder(folder);
    }
}
