//! A set of files that is written whole or not at all.
//!
//! Files are prepared in a hidden staging folder beside their final paths. [`FileSet::commit`] then
//! writes a journal of the changes, renames all files to their final names, and removes the staging
//! folder. If a process is killed, the next one that opens a set in that folder finishes the
//! changes in the journal, and discards the rest. A change that fails is undone.
//!
//! Only one process at a time can hold the set of a given name in a folder. The system releases the
//! lock of a process that dies.
//!
//! If an output is a link, the link stays and the file that it leads to gets the content. An output
//! need not be in the folder of the set.
//!
//! While files are renamed, a reader may find old ones beside new ones. A [`Manifest`], written as
//! the last file of the set, settles this: it lists the files that belong together, with lengths
//! and hashes.
//!
//! # Examples
//!
//! ```
//! use relief_io::file_set::{FileSet, ManifestState, ListedFile, Manifest, Part};
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
//! let ManifestState::Valid(found) = Manifest::find(&place)? else { panic!("it was written") };
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
mod staging;
mod target;
#[cfg(test)]
mod tests;

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

pub use self::error::FileSetError;
pub use self::manifest::{ListedFile, Manifest, ManifestState, Part};
pub use self::target::is_same_file;

use self::disk::{Disk, is_there};
use self::journal::{Action, Step};
use self::staging::StagingFolder;
use self::target::Target;

/// Greatest number of attempts to create a folder that other processes remove.
const MOST_TRIES: usize = 100;

/// Files that are about to be written, all or none. If it is dropped without
/// [`commit`](FileSet::commit), nothing changes.
#[derive(Debug)]
pub struct FileSet {
    disk: Disk,
    staging: StagingFolder,
    /// Folder of the set, which holds the staging folder, without links.
    folder: PathBuf,
    /// Folders that were created, outermost first.
    created: Vec<PathBuf>,
    /// Folders with a remote staging folder.
    remote_folders: Vec<PathBuf>,
    steps: Vec<Step>,
}

impl FileSet {
    /// Opens the set `name` in a folder, which is created if it is missing. Sets of the same name
    /// in one folder exclude each other. Changes that a killed process has left in the folder are
    /// finished or discarded.
    ///
    /// While another process holds the set, `wait` is called every few milliseconds with the time
    /// elapsed. It returns whether to go on waiting.
    ///
    /// # Errors
    ///
    /// When the folder cannot be written into, when `wait` returns false, or when the changes of a
    /// killed process cannot be finished.
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
        let mut created = Vec::new();
        let mut take = || -> io::Result<_> {
            make_folders(&disk, given, &mut created)?;
            let folder = given.canonicalize()?;
            Ok(StagingFolder::take(&disk, &folder, name, wait)?.map(|staging| (folder, staging)))
        };
        let mut taken = take();
        // The process that held the set may have created the folder, and removed it again.
        for _ in 0..MOST_TRIES {
            match &taken {
                Err(error) if error.kind() == io::ErrorKind::NotFound => taken = take(),
                _ => break,
            }
        }
        let (folder, staging) = match taken {
            Ok(Some(taken)) => taken,
            Ok(None) => {
                let name = name.to_string_lossy().into_owned();
                return Err(FileSetError::Busy { folder: given.to_owned(), name });
            }
            Err(error) => {
                remove_folders(&disk, &created);
                return Err(of_folder(error));
            }
        };
        let recovered = journal::recover(&disk, &staging).and_then(|()| staging.clean(&disk));
        if let Err(source) = recovered {
            return Err(FileSetError::Stuck { staging: staging.path, source });
        }
        for other in StagingFolder::abandoned(&disk, &folder) {
            // A later run tries again if this fails now. A run of that name reports it.
            if journal::recover(&disk, &other).is_ok() {
                other.leave(&disk);
            }
        }
        Ok(Self { disk, staging, folder, created, remote_folders: Vec::new(), steps: Vec::new() })
    }

    /// Returns the hidden staging folder, for temporary files of the work. It is removed at the
    /// end.
    pub fn staging_folder(&self) -> &Path {
        &self.staging.path
    }

    /// Checks in advance, as far as possible, whether a file can be put at a path.
    ///
    /// # Errors
    ///
    /// When the path has no file name, when a folder or anything else but a file is there, when
    /// links lead nowhere, or when the file's folder cannot be written into.
    pub fn check(&mut self, path: &Path) -> Result<(), FileSetError> {
        self.target(path).map(|_| ())
    }

    /// Resolves a path, and creates a staging folder in the target's folder.
    fn target(&mut self, path: &Path) -> Result<Target, FileSetError> {
        let target = Target::of(path)?;
        if target.folder != self.folder && !self.remote_folders.contains(&target.folder) {
            self.remote_folders.push(target.folder.clone());
            let created = self.staging.make_remote(&self.disk, &self.remote_folders);
            created.map_err(|source| FileSetError::Folder { folder: target.folder.clone(), source })?;
        }
        Ok(target)
    }

    /// Plans new content for a file, and returns the path to write it to. On commit, files are
    /// renamed in the order of these calls.
    ///
    /// # Errors
    ///
    /// See [`check`](Self::check). Also when the same file was planned before.
    pub fn put(&mut self, path: &Path) -> Result<PathBuf, FileSetError> {
        let target = self.target(path)?;
        let step = Step::new(Action::Put { replaces: false }, target, &self.folder);
        if self.steps.iter().any(|other| other.other_folder == step.other_folder && other.name == step.name) {
            return Err(FileSetError::Twice(path.to_owned()));
        }
        let staging = step.staging_path(&self.staging);
        let staging = staging.map_err(|source| FileSetError::Replace { path: path.to_owned(), source })?;
        let aside = staging.join(format!("new.{}", self.steps.len()));
        self.steps.push(step);
        Ok(aside)
    }

    /// Plans the removal of a file of the folder. A file that is already gone is no error.
    ///
    /// # Errors
    ///
    /// When the name is not a plain file name.
    pub fn remove(&mut self, name: &str) -> Result<(), FileSetError> {
        if Path::new(name).file_name() != Some(OsStr::new(name)) {
            return Err(FileSetError::NoName(name.into()));
        }
        self.steps.push(Step { action: Action::Remove, other_folder: None, name: name.into() });
        Ok(())
    }

    /// Changes the files as planned, all of them or none.
    ///
    /// # Errors
    ///
    /// When a planned file was not written, or when one cannot be replaced. Then no file has
    /// changed; if even that could not be restored, the error is [`FileSetError::Stuck`].
    pub fn commit(mut self) -> Result<(), FileSetError> {
        for (number, step) in self.steps.iter_mut().enumerate() {
            let target = step.target(&self.staging);
            let replace = |source| FileSetError::Replace { path: target.clone(), source };
            if let Action::Put { replaces } = &mut step.action {
                *replaces = is_there(&target).map_err(replace)?;
                let aside = step.staging_path(&self.staging).map_err(replace)?;
                if !is_there(&aside.join(format!("new.{number}"))).map_err(replace)? {
                    return Err(FileSetError::NotWritten(target));
                }
            }
        }
        journal::change(&self.disk, &self.staging, &self.steps).map_err(
            |((path, source), stuck)| match stuck {
                None => FileSetError::Replace { path, source },
                Some(_) => FileSetError::Stuck { staging: self.staging.path.clone(), source },
            },
        )?;
        self.created.clear();
        Ok(())
    }
}

impl Drop for FileSet {
    /// Removes the staging folder, unless it holds changes for the next run to finish.
    fn drop(&mut self) {
        if !journal::is_pending(&self.staging) {
            self.staging.leave(&self.disk);
            remove_folders(&self.disk, &self.created);
        }
    }
}

/// Creates a folder and its missing parents.
fn make_folders(disk: &Disk, folder: &Path, created: &mut Vec<PathBuf>) -> io::Result<()> {
    let missing: Vec<&Path> = folder
        .ancestors()
        .take_while(|folder| !folder.as_os_str().is_empty() && fs::symlink_metadata(folder).is_err())
        .collect();
    for folder in missing.into_iter().rev() {
        match disk.make_folder(folder) {
            Ok(()) => created.push(folder.to_owned()),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

/// Removes created folders that are empty.
fn remove_folders(disk: &Disk, created: &[PathBuf]) {
    for folder in created.iter().rev() {
        let _ = disk.remove_folder(folder);
    }
}
